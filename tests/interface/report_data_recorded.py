#!/usr/bin/env python3
"""What the report computes besides the points of a sweep is as recorded: which effects are switched, fine curves, loads, gears, influences; files for ParaView,
typical conditions, units, words of commands. The program is one whose results are formulas.

`--record` writes records/report_data.json.xz anew. Exit code 77 (skipped) where matplotlib, netCDF4 or SciPy is missing.
"""

import base64
import contextlib
import io
import json
import pathlib
import re
import sys
import tempfile
import unittest.mock

try:
    import matplotlib  # noqa: F401
    import netCDF4
    import numpy as np
    import scipy  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import figures_fixture as made  # noqa: E402
import kept_records  # noqa: E402
import report_dynamic_fixture as dynamic  # noqa: E402
import report_fixture as fixture  # noqa: E402
from orbearing import conditions, effects, effects_table, gear_data, paraview, point_file, report_data, result_folder, terminal, units  # noqa: E402
from orbearing.errors import CaseError, ComputationError  # noqa: E402
from orbearing.point_file import PointFile  # noqa: E402
from orbearing.result_folder import Report  # noqa: E402

RECORDS = kept_records.Records("report_data")
VALUES = {"inertia.coriolis": True, "inertia.carrier_centrifugal": True, "inertia.own_orbit": False, "gearset.mesh_variation": True, "film.enabled": True, "traction.law": "limiting-shear", "traction.rolling_resistance": True,
          "traction.rolling_law": "reynolds", "drag.enabled": False, "contact.squeeze": True, "contact.lubrication": "full", "bearing.cage.pocket_film": "none", "bearing.complement": "cage", "bearing.cage.guide_land_diameter": 0.0406, "bearing.cage.inner_diameter": 0.0359,
          "bearing.cage.outer_diameter": 0.0402, "bearing.cage.guidance": "outer", "bearing.roller_diameter_deviation": [1e-6, -1e-6], "bearing.outer_race.waviness.order": [9], "bearing.outer_race.waviness.amplitude": [1e-6],
          "bearing.outer_race.waviness.phase": [0.0], "simulation.exchange.order": "jacobi", "simulation.exchange.extrapolation": 1.0, "simulation.exchange.window": 2e-6, "simulation.exchange.passes": 3.0, "life.reliability": 0.95,
          "bearing.radial_clearance": 1e-5, "text": "x"}


def inputs(prefix="", **changes):
    rows = {**VALUES, **{key.replace("__", "."): value for key, value in changes.items()}}
    return {(prefix + path if path.startswith(("gearset.", "bearing.")) else path): {"path": path, "value": value, "given": str(value)} for path, value in rows.items() if value != "gone"}


class Program:
    """In place of the program: loads and lives by the formulas of the fixture, each change with a factor of its own."""

    def __init__(self, failing=(), of_inputs=None):
        self.said, self.asked, self.failing, self.of_inputs = [], [], failing, of_inputs or inputs()

    def inputs(self):
        return self.of_inputs

    def points(self, settings, set, changes, speeds, fidelity, loads):  # noqa: A002
        self.asked.append([settings, set, len(changes), len(speeds), [round(float(speed), 6) for speed in speeds[:2]], fidelity, loads])
        found = []
        for number, change in enumerate(changes):
            rows = []
            for speed in speeds:
                rpm = float(speed) * 30.0 / np.pi
                row = {**fixture.point(rpm), "roller_slip": 0.01 + 1e-6 * rpm, "cage_slip": 0.02 - 1e-6 * rpm, "power_loss_W": 1e-3 * rpm, "steady": 1 if number % 2 else 0, "L10mh": 0.3 * float(fixture.life(rpm))}
                row["life_h"] *= 1.0 + 0.01 * number * (1 + len(change))
                if loads:
                    angle, inner, outer = fixture.distribution(rpm)
                    row |= {"angle_deg": angle * 2, "inner_load_N": inner * 2, "outer_load_N": outer * 2}
                if number == 2 and len(rows) == 1:
                    row = {"status": "failed"}
                rows.append(row)
            found.append(None if number in self.failing else rows)
        return found

    def point_of_case(self):
        return {"input_speed_rpm": 4321.0, "life_h": 1.0}

    def lundberg_palmgren_life_at(self, rpm, settings):
        return 3.0 * rpm + len(settings)

    def reliability(self):
        return 0.95

    def influences(self, assumed, result=""):
        if "broken" in assumed:
            raise CaseError("no result")
        return {"quantity": result or "L10mh", "unit": "x", "inputs": [{"path": path} for path in assumed]}

    def say(self, text):
        self.said.append(text)


def content(fidelity, **more):
    made.RANDOM = np.random.default_rng(3)
    validation = [{"reading": "", "quantity": "peak_speed_rpm", "published": 5000.0, "source": "[A]"}, {"reading": "", "quantity": "peak_life_h", "published": 4e4, "source": "[A]"},
                  {"reading": "x", "quantity": "peak_life_h", "published": 5e4, "source": "[B]"}, {"reading": "", "quantity": "peak_life_h", "published": 6e4, "source": "[C]"}, {"reading": "", "quantity": "peak_life_h", "published": None, "source": "[D]"}]
    return {"fidelity": fidelity, "points": [fixture.point(speed) for speed in (2000.0, 5000.0, 8000.0)], "peak": {"speed_rpm": 5000.0, "life_h": 1.0, "refined_speed_rpm": 5600.0, "refined_life_h": 2.0}, "validation": validation,
            "shown": {"speeds_rpm": [2000.0, 5000.0, 8000.0], "peak_speed_rpm": 5000.0, "set": "", "settings": ["a=1"]}, "drawing": {"rollers": 15, "bore_mm": 3.0}, "own_speed_rpm": 5000.0,
            "assumptions": [{"key": "bearing.radial_clearance"}, {"key": "text"}], "sensitivities": [{"assumption": "bearing.radial_clearance", "reading": "none", "life_change_h": None}, {"assumption": "bearing.radial_clearance", "reading": "37 um", "life_change_h": -5.0}],
            "verdicts": [{"requirement": "life", "key": "L10mh", "result": "shortest_L10mh"}], **more}


def refused(call):
    try:
        return call()
    except (CaseError, ComputationError, SystemExit, OSError) as error:
        return f"{type(error).__name__}: {error}"


class ReportData(kept_records.Recorded):
    records = RECORDS

    def test_effects(self):
        def told(changes):
            return [[one.name, one.group, one.settings] for one in changes]

        found = {}
        for name, given, of_set in (("stated", inputs(), ""), ("of a set", inputs("sets.low."), "low"), ("full", inputs(bearing__complement="full"), ""), ("inner guidance", inputs(bearing__cage__guidance="inner"), ""),
                                    ("none", {}, ""), ("turned", inputs(inertia__coriolis=False, inertia__own_orbit=True, traction__law="regularised-coulomb", film__enabled=False, traction__rolling_resistance=False, drag__enabled=True, contact__lubrication="mixed", bearing__cage__pocket_film="hydrodynamic", bearing__roller_diameter_deviation=None), ""),
                                    ("no land", inputs(bearing__cage__guide_land_diameter="gone", bearing__outer_race__waviness__phase="gone"), "")):
            found[name] = {"at rest": told(effects.at_rest(given, of_set)), "chief": told(effects.in_motion(given, False, of_set)), "every": told(effects.in_motion(given, True, of_set))}
        self.check("effects", found)

    def test_completed(self):
        found = {}
        gears = {"speeds": [], "tooth_pairs": [], "meshes": [], "swept_rpm": []}
        for name, fidelity, more, program in (("at rest", "quasi-static", {"gears": gears}, Program((4, 6))), ("in motion", "dynamic", {}, Program()), ("every effect", "dynamic", {}, Program((3,))), ("coupled", "co-simulated", {}, Program()),
                                              ("monolithic", "monolithic", {"points": [fixture.point(3000.0)]}, Program()), ("L10mh", "quasi-static", {"peak": {"speed_rpm": 5000.0, "life_key": "L10mh"}, "own_speed_rpm": 4321.0}, Program()),
                                              ("broken", "quasi-static", {"assumptions": [{"key": "broken"}], "validation": [], "verdicts": []}, Program()), ("no axis", "quasi-static", {"slice": {"kW": 1.0}, "own_speed_rpm": 1.0}, Program())):
            whole = report_data.complete(content(fidelity, **more), program, name == "every effect")
            found[name] = {"content": {key: value for key, value in whole.items() if key not in ("points", "validation")}, "asked": program.asked, "said": program.said}
        found["not shown"] = report_data.complete({"x": 1, "shown": 3}, Program())
        found["influences"] = [report_data.influences({**content("quasi-static"), "peak": {"life_key": key}}, Program(), life) for key, life in (("L10mh", ""), ("life_h", ""), ("life_h", "system_L10r_Mrev"))]
        found["how"] = [report_data.how(inputs(simulation__exchange__passes=passes), fidelity) for passes, fidelity in ((1.0, "co-simulated"), (3.0, "co-simulated"), (3.0, "monolithic"))]
        found["published"] = [report_data.published(content(fidelity, **more), lambda rpm: 7.0) for fidelity, more in (("quasi-static", {}), ("dynamic", {"points": []}), ("quasi-static", {"points": []}), ("quasi-static", {"slice": {"kW": 2.0}}), ("quasi-static", {"validation": []}))]
        self.check("completed", found)

    def test_what_the_program_is_asked(self):
        """By its library where there is one: command, folder and options."""
        asked = []

        def compute(core, command, options, show):
            asked.append([command, {key: str(value).replace("\\", "/") for key, value in options.items()}])
            if command == "check":
                return [json.dumps({"inputs": [{"path": "a", "value": 1.5}, {"path": "b", "value": "x"}, {"path": "life.reliability", "value": 0.9}]})]
            answers = {"report": [[{"life_h": 1.0}]], "run": {"points": [{"input_speed_rpm": 7.0}]}, "sweep": {"points": [{"life_h": 8.0}]}, "sensitivities": {"quantity": "q", "inputs": [{"path": "a"}, {"path": "b"}, {"path": "c"}]}}
            return [json.dumps(answers[command])]

        import types
        module = types.SimpleNamespace(compute=compute)
        with unittest.mock.patch.dict(sys.modules, {"orbearing._core": module}), unittest.mock.patch("orbearing._core", module, create=True):
            program = report_data.Program(pathlib.Path("DIR"))
            found = [program.inputs(), program.points(speeds=[1.0], loads=False), program.point_of_case(), program.lundberg_palmgren_life_at(1234.5, ["x=1"]), program.reliability(), program.influences(["a", "b"]), program.influences(["a"], "L10h"), program.influences(["b", "z"])]
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            report_data.Program(pathlib.Path("DIR"), quiet=False).say("words")
            report_data.Program(pathlib.Path("DIR")).say("nothing")
        self.check("asked", {"found": found, "asked": asked, "said": said.getvalue()})

    def test_gears(self):
        made.RANDOM = np.random.default_rng(8)
        pair = {"mesh": "sun", "working_pressure_angle_deg": 22.5, "contact_from_pitch_point_mm": 1.25, "gears": [{"name": "a", "base_radius_mm": 37.0, "base_half_angle_deg": 3.1}, {"name": "b", "base_radius_mm": 46.0, "base_half_angle_deg": 2.7}]}
        run = lambda n: {"steady": n > 1, "planet_acceleration_m_per_s2": {axis: {"rms": 1.0 * n, "max": 2.0 * n} for axis in "xyz"}, "load_sharing": {"mean": [0.9, 1.1]}, "separated_fraction": 0.1 * n}  # noqa: E731
        speeds = [{"speed_rpm": 1000.0 * n, "mesh_frequency_Hz": 310.0 * n, "status": "ok", "modes": [{"kind": kind, "rank": rank, "name": f"{kind}{rank}", "frequency_Hz": 100.0 * n + rank} for kind in "PR" for rank in range(n)], **({"run": run(n)} if n != 2 else {})} for n in (1, 2, 3)]
        time = np.linspace(0.0, 0.01, 41)[:-1]
        series = {"load_N": (100.0 + 5.0 * np.sin(2 * np.pi * 400.0 * time) + 2.0 * np.cos(2 * np.pi * 300.0 * time)).tolist(), "time_s": (0.3 + time).tolist(), "periods": 2, "mesh_frequency_Hz": 200.0, "speed_rpm": 900.0, "status": "ok"}
        gears = {"speeds": speeds, "tooth_pairs": [pair, {**pair, "mesh": "ring", "contact_from_pitch_point_mm": -0.75}], "meshes": [{"name": f"{kind} mesh {n}", "mean": n} for kind in ("sun", "ring") for n in (1, 2)], "mode_shapes": {"x": 1}, "meetings": [1], "swept_rpm": [1000.0, 3000.0],
                 "load_series": series}
        self.check("gears", [gear_data.arranged(gears), gear_data.arranged({**gears, "load_series": {"status": "none"}, "speeds": [], "tooth_pairs": None})])

    def test_table_of_effects(self):
        entries = [dynamic.ablation(name, worth) for name, worth in dynamic.EFFECTS.items()]
        for number, entry in enumerate(entries):
            for place, point in enumerate(entry["points"]):
                point |= {"inner_load_rms_N": 100.0 + number + place, "cage_slip": 0.01 * number + 0.001 * place, "steady": place != 1}
        entries[2]["points"][1] = {"speed_rpm": 6000.0, "status": "failed"}
        uncaged = [{**entry, "life_key": "L10mh", "points": [{**point, "orbit_slip": 0.5, "L10mh": 7.0 + number} for point in entry["points"]]} for number, entry in enumerate(entries)]
        found = []
        with tempfile.TemporaryDirectory() as place:
            for ablation in (entries, uncaged, entries[1:], []):
                pathlib.Path(place, "report.json").write_text(json.dumps({"dynamic": {"ablation": ablation}}), encoding="utf-8")
                printed = io.StringIO()
                with contextlib.redirect_stdout(printed):
                    found.append([effects_table.main(place)])
                found[-1].append(printed.getvalue().splitlines())
            said = io.StringIO()
            with contextlib.redirect_stderr(said):
                found.append([effects_table.main(place + "/none"), said.getvalue().replace(place, "DIR")])
        self.check("table of effects", found)

    def test_result_folders(self):
        found = {}
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            for name, text in (("none", None), ("torn", b"{"), ("a list", b"[1]"), ("bytes", b"\xff\xfe")):
                if text is not None:
                    (folder / "report.json").write_bytes(text)
                found[name] = refused(lambda: result_folder.read_report(folder)).replace(place, "DIR")
            (folder / "manifest.jsonl").write_text('{"head": 1}\n{"file": "points/0.nc", "row": {"input_speed_rpm": 1000.0, "kW": 5.0}}\n{"file": "points/1.nc", "row": {"input_speed_rpm": 1000.0, "kW": 6.0}}\n{"row": {"input_speed_rpm": 2000.0}}\n{"file": "p', encoding="utf-8")
            (folder / "points").mkdir()
            (folder / "points" / "1.nc").write_bytes(b"damaged")
            with netCDF4.Dataset(folder / "points" / "0.nc", "w") as data:
                data.createDimension("n", 3)
                data.createVariable("a", "f8", ("n",))[...] = np.ma.masked_invalid([1.0, np.nan, 3.0])
                data.createVariable("b", "i4", ("n",))[...] = [1, 2, 3]
                data.createVariable("c", str, ("n",))[...] = np.array(["x", "y", "z"], object)
            for speed, line in ((1000.0, {"kW": 5.0}), (1000.0 * (1 + 5e-7), {"kW": 5.0}), (1000.0, {"kW": 6.0}), (1000.0, {"kW": 7.0}), (1010.0, {}), (2000.0, {}), (None, {})):
                got = point_file.read_point(Report({"slice": line}, folder), speed)
                found[f"point {speed} {line}"] = [{key: value for key, value in got.values.items()}, got.problem]
            found["no folder"] = [point_file.read_only_point(None).problem, point_file.read_point(Report({}), 5.0).problem, point_file.read_only_point(folder).problem]
        points = [{"input_speed_rpm": 1.0, "life_h": 2.0, "kW": 5.0, "refined": True, "status": "ok"}, {"input_speed_rpm": 2.0, "life_h": 3.0, "kW": 5.0, "status": "ok, more"}, {"input_speed_rpm": 3.0, "life_h": 9.0, "kW": 6.0, "status": "implausible: x"},
                  {"input_speed_rpm": 4.0, "life_h": None, "kW": 5.0, "status": "ok"}, {"input_speed_rpm": 5.0, "life_h": 1.0, "status": "failed", "kW": 5.0 * (1 + 1e-10)}]
        for name, more in (("all", {}), ("line", {"slice": {"kW": 5.0}}), ("L10h", {"peak": {"life_key": "L10h"}}), ("peak", {"peak": {"speed_rpm": 2.4, "refined_speed_rpm": None}}), ("in motion", {"fidelity": "dynamic"}), ("coupled", {"fidelity": "monolithic"}), ("nothing", {"points": []})):
            one = Report({"points": points, **more})
            along = one.along_speed()
            found[name] = [one.life_key, one.line, one.fidelity, one.is_dynamic, one.is_coupled, one.peak_speed, one.shown_speeds, [p["status"] for p in one.failed_points], along.record("peak"), len(along.records("points")), along.shown_speeds]
        found["peaks"] = [result_folder.peak_of(some) for some in (points, points[1:], points[:1], [])]
        found["columns"] = [result_folder.curve({"a": [1, 2, 3], "b": [1.0, "x"], "c": None}, "a", "b", "c"), result_folder.curve({}, "a"), result_folder.numbers([True, 1, None, float("nan")]), result_folder.records([1, {"a": 1}]), result_folder.record([1])]
        found["same"] = [result_folder.same(one, other) for one, other in ((1.0, 1.0 + 1e-10), (1.0, 1.0 + 1e-8), (1.0, None), (-1.0, 1.0), (0, 0))]
        found["slips"] = [result_folder.slip_of_set([]), result_folder.slip_of_set([{"orbit_slip": 0.1}, {}])]
        time = np.linspace(0.0, 3.0, 31)
        angle = np.mod(np.outer([1.0, -1.0], 3.0 * time) + 0.5, 2 * np.pi)
        file = PointFile({"time": time, "roller_angle": angle, "x": np.array([time, 2 * time]), "angle": np.linspace(0, 6.0, 13), "inner_load": np.maximum(0.0, np.cos(np.linspace(0, 6.0, 13)))})
        found["roller"] = [point_file.one_roller(file, "x"), point_file.one_roller(file, "x", roller=1), point_file.one_roller(file, "angle"), point_file.one_roller(file, "none")]
        found["zone"] = [point_file.load_zone(file, angle[0]), point_file.load_zone(PointFile({}), angle[0][:3])]
        self.check("result folders", found)

    def test_conditions(self):
        rng = np.random.default_rng(2)
        levels = np.repeat([[1000.0, 5000.0], [1500.0, 9000.0], [400.0, 2000.0]], 40, axis=0)
        speed, load = (levels * (1.0 + 0.01 * rng.standard_normal(levels.shape))).T
        time = np.cumsum(rng.uniform(0.5, 1.5, 120))
        found = {"three": [vars(one) for one in conditions.typical_conditions(time, speed, load, 3)], "one": [vars(one) for one in conditions.typical_conditions(time, speed, load, 1, 5)],
                 "still": [vars(one) for one in conditions.typical_conditions(time[:4], np.zeros(4), load[:4], 2)], "alike": [vars(one) for one in conditions.typical_conditions(time[:4], np.full(4, -3.0), np.full(4, 7.0), 4)]}
        with tempfile.TemporaryDirectory() as place:
            file = pathlib.Path(place, "record.csv")
            rows = "\n".join(f"{t:.4f},{s:.4f},{f / 1e3:.5f}" for t, s, f in zip(time / 3600.0, speed, load))
            texts = {"good": f"time_h,speed_rpm,load_kN\n{rows}\n", "few": "time_s,speed_rpm,load_N\n1,2,3\n", "no column": "time_s,speed,load_N\n1,2,3\n", "falling": "time_s,speed_rpm,load_N\n1,2,3\n2,3,4\n2,3,4\n", "no number": "time_s,speed_rpm,load_N\n1,x,3\n2,3,4\n",
                     "short": "time_s,speed_rpm,load_N\n1,2\n2,3,4\n", "infinite": "time_s,speed_rpm,load_N\n1,2,inf\n2,3,4\n"}
            for name, text in texts.items():
                file.write_text(text, encoding="utf-8")
                got = refused(lambda: conditions.read_record(file))
                found[name] = got.replace(place, "DIR") if isinstance(got, str) else [list(one[:5]) for one in got]
            file.write_text(texts["good"], encoding="utf-8")
            for words in ([], ["--json", "--conditions", "2"]):
                printed = io.StringIO()
                with contextlib.redirect_stdout(printed):
                    code = conditions.main([str(file), *words])
                found[f"command {len(words)}"] = [code, printed.getvalue().splitlines()]
            said = io.StringIO()
            with contextlib.redirect_stderr(said):
                found["no file"] = [conditions.main([place + "/none.csv"]), said.getvalue().replace(place, "DIR")]
        self.check("conditions", found)

    def test_paraview(self):
        found = {}

        def shown(text):
            """Numbers in place of their base64."""
            def numbers(hit):
                content = base64.b64decode(hit[3])
                kind = "<f8" if hit[1] == "Float64" else "<i4"
                return f"{hit[0][:hit[0].index('>') + 1]}{np.frombuffer(content[:4], '<u4')[0]}: " + " ".join(f"{one:.6g}" for one in np.frombuffer(content[4:], kind)[::7]) + "<"
            return re.sub(r'type="(\w+)" Name="(\w+)"[^>]*>([A-Za-z0-9+/=]+)<', numbers, text).splitlines()

        case = "bearing:\n  roller_diameter: 10 mm\n  roller_length: 12 mm\n  pitch_diameter: 60 mm\n"
        for name, variables in {"loads": {"lamina_load": np.arange(6.0).reshape(2, 3) + 1.0, "steps_element_angles": np.array([0.2, 2.0])},
                                "motion": {"time": np.linspace(0.0, 0.3, 4), "roller_angle": np.array([[0.1, 0.2, 0.3, 0.4], [1.0, 1.1, 1.2, 1.3]]), "roller_spin": np.arange(8.0).reshape(2, 4), "roller_other": np.arange(2.0), "cage_x": np.arange(4.0)}, "neither": {"x": np.arange(2.0)}}.items():
            with tempfile.TemporaryDirectory() as place:
                folder = pathlib.Path(place)
                (folder / "case.resolved.yaml").write_text(case, encoding="utf-8")
                (folder / "points").mkdir()
                for number in range(2):
                    with netCDF4.Dataset(folder / "points" / f"{number}.nc", "w") as data:
                        for size in {size for values in variables.values() for size in values.shape}:
                            data.createDimension(f"n{size}", size)
                        for key, values in variables.items():
                            data.createVariable(key, "f8", tuple(f"n{size}" for size in values.shape))[...] = values * (1.0 + number)
                for words in (["--frames", "3"], ["--point", "1", "--frames", "1"], ["--point", "2"]):
                    printed = io.StringIO()
                    with contextlib.redirect_stdout(printed):
                        code = refused(lambda: paraview.main([place, "-o", f"{place}/out", *words]))
                    found[f"{name} {words}"] = [str(code).replace(place, "DIR"), printed.getvalue().replace(place, "DIR"), {path.name: shown(path.read_text(encoding="utf-8")) for path in sorted((folder / "out").glob("*"))}]
                (folder / "case.resolved.yaml").write_text("bearing:\n  roller_length: 12 mm\n", encoding="utf-8")
                found[f"{name}, no sizes"] = str(refused(lambda: paraview.Folder(folder, 0))).replace(place, "DIR")
        self.check("paraview", found)

    def test_words(self):
        names = ["x_N", "x_N_m", "x_N_per_m", "x_N_per_mm_um", "x_kN", "x_h", "L10h", "system_L10mrh", "a.L10rh", "xL10h", "elliptic_K", "a.elliptic_E", "speed_rpm", "x_m_s2", "x_m_s", "x_rad_s", "x_K", "share", "x_percent", "x_Mrev", "inner_L10mh", "x_per_s"]
        stated = ["N.m/rad", "m", "kg.m2", "N/(mm.um)", "1/s2", "Mrev", "deg", "m^0.5", "N.s/m"]
        found = {"units": {name: units.units_of(name) for name in names}, "udunits": {one: units.as_udunits(one) for one in stated}, "in": units.units_in({"a_N": 1, "b": [{"c_h": 2, "d": {"e_m": 3}}], "f": "x_N"}),
                 "stated": [units.unit_in({"a": "N.m"}, "a"), units.unit_in({"a": 3}, "a_N"), units.unit_in({}, "b_h")], "printable": [terminal.printable(text) for text in ("a\nb\tc\rd", "\x1b[2J", "\u202eabc", "\x7f\x80", "\ud800", "plain ä")]}
        found["settings"] = [str(refused(lambda options=options: terminal.settings_of(options))) for options in (["a=1", " b = 2 = 3 "], ["a", "=1", "b=2", " =3"])]
        readers = (terminal.stated, terminal.whole_number(0), terminal.whole_number(-3, 5), terminal.finite)
        for number, read in enumerate(readers):
            cells = []
            for text in ("", " ", "3", "-3", "+4", "5", "6", "1.5", ".5", "1e3", "1e999", "x", "٣", "12345678901234567890", "-4"):
                try:
                    cells.append(str(read(text)))
                except Exception as error:  # noqa: BLE001
                    cells.append(f"{type(error).__name__}: {error}")
            found[f"reader {number}"] = cells

        def fails(error):
            def call():
                raise error
            return call

        for number, error in enumerate((CaseError(["a\x1bb", "c"]), ImportError("no x"), KeyboardInterrupt(), ComputationError("bad"), OSError(2, "gone", "file.txt"), OSError(28, "full"))):
            said = io.StringIO()
            with contextlib.redirect_stderr(said):
                found[f"exit {number}"] = [terminal.exit_code("name", fails(error), "packages", "; stays"), said.getvalue()]
        found["exit"] = terminal.exit_code("name", lambda: 7, "p")
        for number, end in enumerate((SystemExit(3), SystemExit("words"), SystemExit(None), OSError(2, "gone", "f.txt"), OSError(28, "full"))):
            said, printed = io.StringIO(), io.StringIO()
            with contextlib.redirect_stderr(said), contextlib.redirect_stdout(printed), unittest.mock.patch("os.dup2"), unittest.mock.patch.object(printed, "fileno", lambda: 1, create=True):
                found[f"finished {number}"] = [terminal.finished(fails(end)), said.getvalue()]

        class Terminal(io.StringIO):
            def isatty(self):
                return True

        for shown in (False, True):
            said = Terminal()
            with contextlib.redirect_stderr(said), unittest.mock.patch("time.monotonic", side_effect=[5.0, 5.05, 5.2, 9.0, 9.1, 9.15, 9.3]):
                line = terminal.StatusLine(shown)
                due = [line.is_due]
                line.show("a")
                due += [line.is_due, line.is_due]
                line.end()
            found[f"line {shown}"] = [due, said.getvalue()]
        self.check("words", found)


if __name__ == "__main__":
    kept_records.main(RECORDS)
