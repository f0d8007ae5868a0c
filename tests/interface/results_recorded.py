#!/usr/bin/env python3
"""Results as objects are as recorded: arrays, datasets, plots, notebooks' tables, of results of each command that are made up.

`--record` writes records/results_objects.json.xz anew. Exit code 77 (skipped) where xarray, pandas or matplotlib is missing.
"""

import copy
import io
import pathlib
import pickle
import sys
import tempfile
import types
import unittest.mock

try:
    import matplotlib
    import netCDF4
    import numpy as np
    import pandas  # noqa: F401
    import xarray  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]
matplotlib.use("agg")

import kept_records  # noqa: E402
import whole_drawing  # noqa: E402

CORE = types.SimpleNamespace(version="0.0", asked=[])
CORE.compute = lambda core, command, options, *more: CORE.asked.append([command, {key: str(value) for key, value in options.items()}]) or ["{}", []]
sys.modules.setdefault("orbearing._core", CORE)

import orbearing.results as results  # noqa: E402

orbearing_package = sys.modules["orbearing"]
RECORDS = kept_records.Records("results_objects")


class FakeCase:
    name = "a <case>"
    core = types.SimpleNamespace(hash=lambda: "0123")

    def copy(self):
        return self


def point(speed, **more):
    return {"input_speed_rpm": speed, "planet_load_N": 1e3 + speed, "inner_load_max_N": 2.0 * speed, "outer_load_max_N": 3.0 * speed, "L10mh": 1e8 / speed, "system_L10mh": 1e7 / speed, "status": "ok", "refined": False, "odd": None, "word": "x", **more}


PEAK = {"life_key": "L10mh", "speed_rpm": 1000.0, "life_h": 1e5, "refined_speed_rpm": 1500.0, "refined_life_h": 2e5, "between_rpm": [1000.0, 2000.0]}
POINTS = [point(2000.0), point(1000.0, L10mh=None, planets=[1, 2]), point(1500.0, refined=True, L10mh=2e5), point(3000.0, status="failed", L10mh=-1.0)]
SWEEPS = {
    "plain": {"points": POINTS, "peak": PEAK, "warnings": ["a <warning>"], "units": {"planet_load_N": "kN"}},
    "no peak": {"points": POINTS[:2], "peak": {"life_key": "L10mh"}},
    "grid": {"points": [point(speed, **{"input.power_kW": power, "oil.temperature_K": 300.0, "sets.a.x_N": 1.0, "value": speed * power}) for speed in (1000.0, 2000.0) for power in (1.0, 2.0, 3.0)], "peak": PEAK},
    "no grid": {"points": [point(1000.0, **{"input.power_kW": 1.0}), point(2000.0, **{"input.power_kW": 2.0})], "peak": PEAK},
}
MODES = {"modes": [{"frequency_Hz": 100.0, "kind": "rotational", "multiplicity": 1}, {"frequency_Hz": 250.0, "kind": "translational", "multiplicity": 2}, {"frequency_Hz": None, "kind": "rotational", "multiplicity": 1}], "speed_rpm": 3.0}
MESH = {"meshes": [{"name": f"{kind} mesh", "mean_N_per_m": 2e8 + i, "text": "x", "curve": [[0.1 * j, 1e8 * (1 + i + 0.1 * j)] for j in range(4)], "case": f"c{i}"} for i, kind in enumerate(("sun", "ring"))], "contact_ratio": 1.5, "units": {"mean_N_per_m": "N/m"}}
CROWN = {"tilt": "stated", "life_key": "L10mrh", "points": [{"tilt_mrad": tilt, "drop_um": drop, "governing_life_h": 1e4 + drop - tilt} for tilt in (0.0, 0.4) for drop in (1.0, 2.0)], "optimum": {"drop_um": 2.0, "governing_life_h": 1.1e4}, "straight": {"x": 1}}
STIFFNESS = {"points": [{"speed_rpm": speed, "load": {"radial_N": 10.0 * n, "axial_N": 5.0}, "stiffness": None if n == 3 else [[1e6 * (1 + i + 5 * j + speed) if i != 4 else None for i in range(5)] for j in range(5)]} for n in (1, 2, 3) for speed in (300.0, 100.0)], "units": {"radial_N": "N"}}
SENSITIVITIES = {"quantity": "L10mh", "inputs": [{"path": f"a.b{i}", "value": 1.0 + i, "unit": "mm", "derivative": None if i == 2 else 3.0 - i, "error": 0.1, "elasticity": None if i == 2 else 0.5 - 0.1 * i, "meaning": "m"} for i in range(20)]}
PLAIN = {"life_h": 12.5, "flag": True, "name": "x<y", "none": None, "load_N": [1.0, None, 3.0], "texts": ["a", "b"], "empty": [], "rings": [{"force_N": 1.0, "name": "p"}, {"force_N": 2.0, "more": "q", "count": 3}], "envelope_peaks": [{"force_N": 5.0, "case": "z"}],
         "inputs": [{"path": 1}], "nested": {"a": 1}, "warnings": ["w"], "units": {"life_h": "s"}, "ratio": 0.25, "series": [[1, 2], [3, 4]]}


def dataset(found):
    return {"sizes": {str(key): size for key, size in found.sizes.items()}, "attributes": {key: value for key, value in found.attrs.items()},
            "variables": {str(key): [list(one.dims), one.values.ravel().tolist(), {word: str(value) for word, value in one.attrs.items()}] for key, one in found.variables.items()}, "coordinates": [str(key) for key in found.coords]}


def refused(call):
    try:
        return call()
    except Exception as error:  # noqa: BLE001
        return f"{type(error).__name__}: {error}"


@unittest.mock.patch.dict(sys.modules, {"orbearing._core": CORE})
@unittest.mock.patch("orbearing._core", CORE, create=True)
class Results(kept_records.Recorded):
    records = RECORDS

    def made(self, kind, data, command="run", **more):
        return kind(data, command=command, case=FakeCase(), **more)

    def drawn(self, result, **options):
        from matplotlib import pyplot
        axes = result.plot(**options)
        found = whole_drawing.whole(axes.figure)
        pyplot.close(axes.figure)
        results._undrawn.clear()
        return found

    def test_sweeps(self):
        for name, data in SWEEPS.items():
            one = self.made(results.SweepResult, data, "sweep", options={"fidelity": "dynamic"} if name == "grid" else None)
            self.check(f"sweep: {name}", {
                "dataset": refused(lambda one=one: dataset(one.to_xarray())), "points": dataset(one.to_xarray(points=True)), "plot": self.drawn(one), "html": one._repr_html_(), "repr": repr(one), "columns": list(one.columns), "life": one.life_key, "peak": dict(one.peak),
                "refined": list(one.refined), "column": [one.column("L10mh"), list(one.column("word")), list(one.input_speed_rpm)], "wrong": [refused(lambda one=one: one.nothing), refused(lambda one=one: one._hidden), refused(one.series), refused(lambda one=one: one.column("x"))]})

    def test_other_commands(self):
        modes = self.made(results.ModesResult, MODES, "modes")
        mesh, sensitivities = self.made(results.MeshResult, MESH, "mesh"), self.made(results.SensitivityResult, SENSITIVITIES, "sensitivities")
        check = self.made(results.CheckResult, {"inputs": [{"path": "a.b", "given": "1 <mm>", "standing": "given", "reason": "r&d"}], "warnings": ["w"]}, "check")
        self.check("modes", [modes.frequency_Hz, list(modes.kind), modes.multiplicity, self.drawn(modes), dataset(modes.to_xarray())])
        self.check("mesh", [dataset(mesh.to_xarray()), self.drawn(mesh)])
        for name, data in {"stated": CROWN, "computed": {**CROWN, "tilt": "computed"}, "profiles": {**CROWN, "points": [{**one, "profile": "arc" if i % 2 else "straight"} for i, one in enumerate(CROWN["points"])]}}.items():
            crown = self.made(results.CrownResult, data, "crown")
            self.check(f"crown: {name}", [crown.life_key, dict(crown.optimum), dict(crown.straight), self.drawn(crown), dataset(crown.to_xarray())])
        stiffness = self.made(results.StiffnessResult, STIFFNESS, "stiffness")

        class Element:
            def __init__(self, n, cxx, frequency=None, **terms):
                self.kept = [n, cxx, frequency, terms]

        class NewElement:
            def __init__(self, n, cxx, speed=None, **terms):
                self.kept = ["new", n, cxx, speed, terms]

        elements = []
        for kind in (Element, NewElement):
            with unittest.mock.patch.dict(sys.modules, {"ross": types.SimpleNamespace(BearingElement=kind)}):
                elements += [stiffness.ross_element(3).kept, stiffness.ross_element(1, load=1).kept, self.made(results.StiffnessResult, {"points": STIFFNESS["points"][1:2]}, "stiffness").ross_element(2).kept]
        self.check("stiffness", [dataset(stiffness.to_xarray()), self.drawn(stiffness), elements])
        self.check("sensitivities", [dataset(sensitivities.to_xarray()), self.drawn(sensitivities), self.drawn(sensitivities, most=3), sensitivities._repr_html_()])
        self.check("check", check._repr_html_())

    def test_any_result(self):
        one = self.made(results.Result, PLAIN, options={"fidelity": "dynamic"}, folder="some/folder")
        found = {"dataset": dataset(one.to_xarray()), "data": one.data, "keys": list(one), "length": len(one), "warnings": list(one.warnings), "html": one._repr_html_(), "repr": repr(one), "folder": str(one.folder), "no plot": refused(one.plot),
                 "fixed": [refused(lambda: setattr(one, "x", 1)), refused(lambda: one["rings"][0].__setitem__("a", 1)), refused(lambda: results.number_array([1.0, None]).__setitem__(0, 2.0))], "none": [str(self.made(results.Result, {}).folder), list(self.made(results.Result, {}).warnings)]}
        again = pickle.loads(pickle.dumps(self.made(results.Result, PLAIN, folder="f")))
        found["pickled"] = [again.data == one.data, str(again.folder)]
        with tempfile.TemporaryDirectory() as place:
            kept = pathlib.Path(place, "kept")
            kept.mkdir()
            owner = self.made(results.Result, PLAIN, folder=str(kept / "results"), kept=str(kept))
            other, twin = pickle.loads(pickle.dumps(owner)), copy.deepcopy(owner)
            found["of another process"] = [str(other.folder), twin.folder == owner.folder, kept.exists()]
            del owner
            found["kept by its copy"] = kept.exists()
            del twin
            found["gone"] = not kept.exists()
            folder = pathlib.Path(place, "out")
            (folder / "animations").mkdir(parents=True)
            (folder / "animations" / "1.html").write_text("a", encoding="utf-8")
            (folder / "report.html").write_text("page", encoding="utf-8")
            (folder / "points").mkdir()
            for number in range(2):
                with netCDF4.Dataset(folder / "points" / f"{number}.nc", "w") as data:
                    data.createDimension("n", 2)
                    data.createVariable("x", "f8", ("n",))[...] = [1.0 + number, 2.0]
            CORE.asked.clear()
            written = self.made(results.Result, PLAIN, folder=str(folder))
            target = written.report(pathlib.Path(place, "new", "page.html"))
            found["report"] = [sorted(str(path.relative_to(place)) for path in target.parent.rglob("*")), [[command, {key: value.replace(place, "DIR") for key, value in options.items()}] for command, options in CORE.asked]]
            CORE.asked.clear()
            refused(lambda: self.made(results.Result, PLAIN, "mesh", options={"speed": "3"}).report(pathlib.Path(place, "x.html")))
            found["computed again"] = [[command, sorted(options)] for command, options in CORE.asked]
            sweep = self.made(results.SweepResult, SWEEPS["plain"], "sweep", folder=str(folder))
            found["series"] = [sweep.series().x.values, sweep.series(1).x.values]
        said = io.StringIO()
        with unittest.mock.patch("sys.stderr", said):
            axes = results._new_axes(1.5)
            results._say_how_to_show()
            results._say_how_to_show()
        found["undrawn"] = [said.getvalue(), list(axes.figure.get_size_inches())]
        axes = results._new_axes()
        axes.figure.canvas.draw()
        found["drawn"] = len(results._undrawn)
        self.check("any result", found)


if __name__ == "__main__":
    kept_records.main(RECORDS)
