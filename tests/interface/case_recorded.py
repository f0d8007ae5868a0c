#!/usr/bin/env python3
"""What cases, machines, tables, packages of FMUs and components of OpenMDAO do is as recorded: what they ask the program, how values are written, what is refused.

`--record` writes records/case.json.xz anew.
"""

import contextlib
import io
import json
import os
import pathlib
import pickle
import re
import sys
import tempfile
import types
import unittest.mock
import warnings
import zipfile

import kept_records
import program

orbearing = program.package()

import numpy as np  # noqa: E402

from orbearing import case as cases, errors, machine, openmdao, ssp, table, whole_files  # noqa: E402
from orbearing.errors import CaseError, ComputationError  # noqa: E402

RECORDS = kept_records.Records("case")
TEXT = """name: small
source: a test
model: ball-bearing
load: {radial: 1000 N, axial: 0 N}
bearing: {balls: 7, ball_diameter: 11.5 mm, pitch_diameter: 43.5 mm, inner_osculation: 0.52, outer_osculation: 0.53, contact_angle: 0 deg, radial_clearance: 0 um, dynamic_capacity: 23400 N}
operation: {shaft_speed: 1500 rpm}
"""


def refused(call):
    try:
        return call()
    except (CaseError, ComputationError, KeyError, AttributeError, ValueError, TypeError, OSError, ImportError) as error:
        return f"{type(error).__name__}: {error}"


class Core(types.SimpleNamespace):
    """In place of the program's functions: what is asked is kept."""

    def __init__(self):
        super().__init__(asked=[], answer={"points": [], "warnings": []}, failures=[])

    def compute(self, core, command, options, report=None):
        self.asked.append([command, {key: str(value) for key, value in options.items()}, report is not None])
        if report is not None:
            for done in (1, 3):
                report(done, 3, "points: ")
        return json.dumps(self.answer), self.failures

    def evaluate(self, core, paths, values, fidelity, jobs, report):
        self.asked.append(["evaluate", paths, values.ravel(), str(values.dtype), fidelity, jobs])
        if report is not None:
            report(2)
        return ["a"], values, ["ok"]


class Cases(kept_records.Recorded):
    records = RECORDS

    def test_values_as_text(self):
        values = ["5 um", 3, 2.5, True, [1e-6, 2e-6], (1.0, 2.0), np.float64(3.5), np.int64(4), np.bool_(True), np.array([1.0, 2.0]), {"from": 1.0, "to": 2.0, "step": 0.5}, {"radial": 5.0, "axial": 1}, None, object, {"a": np.array([1])}, [[1, 2.0, 3]], [{"power": 1.0, "share": 0.5}]]
        paths = ("bearing.radial_clearance", "bearing.balls", "load", "sweep", "sweep.input.speed", "spectrum", "bearing", "name", "none.such", "uncertain", "sweep.input.power")
        found = {path: [str(refused(lambda path=path, value=value: cases._as_text(path, value))) for value in values] for path in paths}
        found["sweep of speeds"] = [cases._as_text("sweep", {"input.speed": {"from": 1.0, "to": 2.0, "step": 1.0}, "bearing.rollers": [1, 2]}), cases._as_text("", {"bearing": {"radial_clearance": 1e-6, "balls": 7}})]
        found["spectrum"] = cases._as_text("spectrum", [{"power": 1.0, "speed": 2.0, "share": 0.5, "other": 3}, [1.0, 2.0, 0.25, 9]])
        found["paths"] = [str(refused(lambda one=one: cases._path(one))) for one in ("a.b", 3, None)]
        found["implausible"] = [cases._implausible(one) for one in (None, {}, {"points": 3}, {"points": [{"status": "ok"}, {"status": "implausible: x"}, {"status": "implausible: y"}, 3]})]
        self.check("values", found)

    def test_a_case(self):
        case = orbearing.parse(TEXT, "small.yaml")
        found = {"names": [case.name, case.model, case.life_key, repr(case)], "values": [case[path] for path in ("bearing.balls", "load.radial", "bearing.contact_angle", "name", "lubricant.grade")], "given": [case.given(path) for path in ("load.radial", "lubricant.grade")],
                 "html": [case._repr_html_().count("<tr>"), case._repr_html_()[:200]]}
        before = case.copy()
        case["load.radial"] = 2000
        case["bearing.radial_clearance"] = "10 um"
        case["load.radial"] = 2500.0
        found["changed"] = [case["load.radial"], before["load.radial"], repr(case), case._settings]
        found["wrong"] = [str(refused(lambda path=path, value=value: case.__setitem__(path, value))) for path, value in (("load.radial", -1), ("load.radiall", 1), (3, 1), ("bearing.balls", object))] + [repr(case)]
        found["deleted"] = [str(refused(lambda path=path: case.__delitem__(path))) for path in ("bearing.dynamic_capacity", "bearing.dynamic_capacity", "lubricant.grade", "sweep", "sweep.input.speed")] + [repr(case)]
        found["block"] = [refused(lambda: (case.__setitem__("load", {"radial": 3000.0, "axial": 100.0}), case._settings)[1])]
        again = pickle.loads(pickle.dumps(case))
        found["pickled"] = [again._settings, again["load.radial"]]
        found["with settings"] = [repr(orbearing.parse(TEXT, "x", {"load.radial": "7 N"})), str(refused(lambda: orbearing.parse(TEXT, "x", [1]))), repr(case.copy({"bearing.balls": 8})), str(refused(lambda: orbearing.load("")))]
        with tempfile.TemporaryDirectory() as place:
            pathlib.Path(place, "case.yaml").write_text(TEXT, encoding="utf-8")
            found["of a folder"] = repr(orbearing.load(place))
            found["not there"] = str(refused(lambda: orbearing.load(place + "/none.yaml"))).replace(place, "DIR")
        found["stated"] = [case._states(path) for path in ("load", "load.radial", "lubricant", "sweep", "sweep.x", "assumed", "load.rad")]
        self.check("a case", found)

    def test_what_the_program_is_asked(self):
        case, core = orbearing.parse(TEXT, "small.yaml"), Core()
        core.si_units, core.load, core.parse = cases._core.si_units, cases._core.load, cases._core.parse
        model = unittest.mock.patch.object(cases.Case, "model", "planetary-drivetrain")
        told, found = [], {}
        calls = {"check": lambda: case.check(), "run": lambda: case.run(), "run in motion": lambda: case.run("dynamic", "out", True), "sweep": lambda: case.sweep(), "sweep in motion": lambda: case.sweep("dynamic", 3, True, "up", None, True), "crown": lambda: case.crown(tilts="0 mrad", jobs=2),
                 "modes": lambda: [case.modes(), case.modes("3 rpm")], "mesh": lambda: case.mesh(), "stiffness": lambda: case.stiffness("out"), "sensitivities": lambda: [case.sensitivities(), case.sensitivities("out", "dynamic", "L10h", ["a"], 2)], "signals": lambda: [case.signals(), case.signals(["a=[1]"], "out", "dynamic", 0.5, 3)],
                 "fmu": lambda: [case.fmu("x.fmu"), case.fmu("x.fmu", 3, "gearset", True)], "evaluate": lambda: [case.evaluate(["a"], [[1], [2]]), cases.evaluate(case, ["a", "b"], np.array([[1, 2]]), "dynamic", 3, lambda *words: told.append(list(words)))],
                 "progress": lambda: [case.run(progress=lambda *words: told.append(list(words))), case.run(progress=False)]}
        for kind in ("one bearing", "drivetrain"):
            with unittest.mock.patch.object(cases, "_core", core), (model if kind == "drivetrain" else contextlib.nullcontext()):
                for name, call in calls.items():
                    core.asked.clear()
                    got = call()
                    shown = [type(one).__name__ if not isinstance(one, tuple) else str(one[0]) for one in (got if isinstance(got, list) else [got])]
                    asked = [[command, {key: ("TEMPORARY" if "orbearing-" in value else value) for key, value in options.items()}, *more] if isinstance(options, dict) else [command, options, *more] for command, options, *more in core.asked]
                    found[f"{kind}: {name}"] = [shown, asked, [bool(getattr(one, "_kept", None)) for one in (got if isinstance(got, list) else [got])]]
        found["told"] = told
        core.failures, core.answer = ["a point failed"], {"points": [{"status": "implausible: heavy"}]}
        with unittest.mock.patch.object(cases, "_core", core), warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always")
            case.run()
        found["warned"] = [[str(one.message), one.category.__name__, os.path.basename(one.filename)] for one in heard]
        made = []
        core.failures, core.answer = [], {"points": []}
        with unittest.mock.patch.object(cases, "_core", core), unittest.mock.patch("orbearing.table.Table", lambda file: made.append(str(file))):
            core.asked.clear()
            case.table("out", {"load.radial": (1.0, "2 kN")}, ["L10h"], bound=0.1, points=5, jobs=2, resume=True)
            case.table("out")
        found["table"] = [list(core.asked), list(made)]

        class Bar:
            def __init__(self, total, file, leave):
                self.n, self.total, self.desc, self.kept = 0, total, "", [["made", total, leave]]
                made.append(self)

            def reset(self, total):
                self.total, self.n = total, 0
                self.kept.append(["reset", total])

            def set_description_str(self, text):
                self.desc = text
                self.kept.append(["said", text])

            def update(self, more):
                self.n += more
                self.kept.append(["update", more])

            def close(self):
                self.kept.append(["closed"])

        made.clear()
        with unittest.mock.patch.dict(sys.modules, {"tqdm": types.SimpleNamespace(), "tqdm.auto": types.SimpleNamespace(tqdm=Bar)}), unittest.mock.patch.object(cases, "_core", core), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            case.run(progress=True)
            case.evaluate(["a"], [[1.0]], progress=True)
        found["bars"] = [bar.kept for bar in made]
        said = io.StringIO()
        with unittest.mock.patch.dict(sys.modules, {"tqdm": None, "tqdm.auto": None}), unittest.mock.patch.object(cases, "_core", core), warnings.catch_warnings(), contextlib.redirect_stderr(said):
            warnings.simplefilter("ignore")
            case.run(progress=True)
            case.evaluate(["a"], [[1.0]], progress=True)
        found["plain"] = said.getvalue()
        self.check("asked", found)

    def test_machines(self):
        class Machine:
            inputs = [("planet.displacement.x", "m", "x"), ("planet.velocity.y", "m/s", "y")]
            output_list = [("force.x", "N", "f"), ("force.y", "N", "g"), ("moment", "N m", "m")]
            time = 0.25

            def __init__(self, core, model):
                self.asked = [model]

            def __getattr__(self, name):
                def call(*words):
                    self.asked.append([name, *(list(one) if isinstance(one, (list, tuple)) else one for one in words)])
                    return {"output": len(str(words)) * 1.5, "outputs": [1.0, 2.0, 3.0], "slope": 10.0 * len(words[0]) + sum(map(ord, words[-1])) if name == "slope" else 0, "save": [1.0, 2.5]}.get(name)
                return call

        with unittest.mock.patch.object(machine._core, "Machine", Machine):
            bearing, gears = machine.Bearing(types.SimpleNamespace(core=1)), machine.Gears(types.SimpleNamespace(core=1))
            bearing.set_input("planet.displacement.x", 1e-6, 2.0)
            bearing.set_input(planet_displacement_x=3e-6, other=4.0)
            bearing.initialize(0.5)
            bearing.advance(1e-3)
            bearing.restore(np.array([1, 2]))
            found = [bearing.inputs, bearing.outputs, bearing.time, bearing.all_outputs(), bearing.directional_derivative(["force.x"], ["planet.displacement.x", "planet.velocity.y"], [2.0, 3.0]), bearing.save(), bearing.force, bearing.moment, bearing.stiffness, bearing.damping,
                     bearing._machine.asked, gears._machine.asked]
        self.check("machines", json.loads(json.dumps(found, default=lambda one: one.tolist())))

    def test_tables(self):
        class CoreTable:
            def __init__(self, file):
                self.asked = []

            def inputs(self):
                return [("input.speed", 1.0, 2.0), ("bearing.radial_clearance", 3.0, 4.0), ("oil.speed", 5.0, 6.0)]

            def results(self):
                return ["life_h", "x"]

            def bound(self):
                return 0.125

            def case(self):
                return types.SimpleNamespace(value=lambda path: float(len(path)), si=lambda path, text: [float(len(one)) for one in text] if isinstance(text, list) else float(len(text)) * 2, name=lambda: "c")

            def answers(self, result, rows, bound, compute, jobs):
                self.asked.append([result, rows.tolist(), bound, compute, jobs])
                return rows.sum(axis=1), 0.1 * rows[:, 0], np.arange(len(rows)) % 2, {1: "bad"}

        with unittest.mock.patch.object(table._core, "CoreTable", CoreTable):
            one = table.Table("some/folder")
            answers = [one.life_h(), one.life_h(radial_clearance=[1.0, 2.0], input_speed="6000 rpm"), one.answer("x", bound=0.5, compute=False, jobs=3, oil_speed=np.array([["a", "bb"], ["ccc", "d"]]))]
            found = [repr(one), one.inputs, list(one.results), one.bound, [[answer.value, answer.error, answer.computed, list(answer.value.shape), {str(key): text for key, text in answer.failures.items()}] for answer in answers], one._core.asked,
                     str(refused(lambda: one.nothing)), str(refused(lambda: one.life_h(speed=1.0))), one.__reduce__()[1][0] == os.path.abspath("some/folder"), sorted(one._paths)]
        self.check("tables", json.loads(json.dumps(found, default=lambda one: one.tolist())))

    def test_packages_of_fmus(self):
        def description(names, stop):
            rows = "".join(f'<ScalarVariable name="{name}" causality="{kind}"><{typed} {f"unit={chr(34)}{unit}{chr(34)}" if unit else ""} {f"start={chr(34)}{start}{chr(34)}" if start else ""}/></ScalarVariable>' for name, kind, typed, unit, start in names)
            return (f'<fmiModelDescription><UnitDefinitions><Unit name="N"><BaseUnit kg="1" m="1" s="-2"/></Unit><Unit name="m"><BaseUnit m="1"/></Unit></UnitDefinitions><DefaultExperiment stopTime="{stop}"/>'
                    f"<ModelVariables>{rows}</ModelVariables></fmiModelDescription>")

        gears = [(f"planet[{i}].{name}", "output", "Real", "m", None) for i in (1, 2) for name in ("displacement.x", "speed")] + [(f"planet[{i}].force.x", "input", "Real", "N", "0") for i in (1, 2)] + [("carrier.speed", "output", "Real", None, None), ("teeth", "parameter", "Integer", None, "21"), ("free", "parameter", "Real", None, None)]
        bearing = [("planet.displacement.x", "input", "Real", "m", None), ("force.x", "output", "Real", "N", None), ("clearance", "parameter", "Real", "m", "1e-5"), ("flag", "parameter", "Boolean", None, "true"), ("local", "local", "Real", None, None)]
        found = {}
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)

            class FakeCase:
                name = "x"

                def __getitem__(self, path):
                    return 2

                def fmu(self, file, fmi, model, windows, progress):
                    with zipfile.ZipFile(file, "w") as archive:
                        archive.writestr(zipfile.ZipInfo("modelDescription.xml"), description(gears if model == "gearset" else bearing, "0.5" if model == "gearset" else "0.7"))
                    found.setdefault("asked", []).append([fmi, model, windows, progress])
                    return {"warnings": ["both", model], "versions": {"orbearing": "1.2"}}

            for name, per_planet in (("two", 2), ("one", 1)):
                with unittest.mock.patch.object(FakeCase, "__getitem__", lambda self, path, per_planet=per_planet: per_planet):
                    package = ssp.write(FakeCase(), folder / "new" / f"{name}.ssp", windows=name == "one")
                found[name] = {key: value for key, value in vars(package).items() if key != "file"}
                with zipfile.ZipFile(folder / "new" / f"{name}.ssp") as archive:
                    found[f"{name}, content"] = [[one.filename, list(one.date_time)] for one in archive.infolist()] + [archive.read(file).decode().splitlines() for file in archive.namelist() if not file.endswith(".fmu")]
            found["refused"] = [str(refused(lambda one=one: ssp.write(FakeCase(), one))).replace(place, "DIR") for one in (folder / "x.zip", folder, folder / "x")]
            (folder / "file").write_text("x")
            found["not written"] = re.sub(r"\.ssp-\w+", "", str(refused(lambda: ssp.write(FakeCase(), folder / "file" / "x.ssp"))).replace(place, "DIR"))
            for words in ([], ["--json", "--windows"], ["--quiet"]):
                printed = io.StringIO()
                with unittest.mock.patch.object(ssp, "_core", types.SimpleNamespace(load=lambda case, settings: None)), unittest.mock.patch.object(ssp, "load", lambda case, settings: FakeCase()), contextlib.redirect_stdout(printed):
                    code = ssp.main(["case.yaml", "-o", f"{place}/z.ssp", "--set", "a=1", *words])
                found[f"command {words}"] = [code, printed.getvalue().replace(place, "DIR").splitlines()]
        found["connections"] = [list(one) for one in ssp.connections(2)]
        self.check("packages", found)

    def test_components(self):
        class FakeCase:
            def __init__(self, at=None):
                self.at = {"bearing.clearance": 2e-5, "input.power": 150e3, "count": 7.0, **(at or {})}
                self.asked = []
                self.core = types.SimpleNamespace(without_effect=lambda paths, fidelity: {path: f"{path}: no effect" for path in paths if path == "idle"}, si=lambda path, text: 0.001)
                self.inputs = [{"path": "bearing.clearance", "kind": "quantity", "si_unit": "m", "given": "20 um"}, {"path": "input.power", "kind": "quantity", "si_unit": "W", "given": "150 kW"}, {"path": "count", "kind": "number", "si_unit": "", "given": "7"},
                               {"path": "kind", "kind": "choice", "si_unit": "", "given": "x"}, {"path": "empty", "kind": "number", "si_unit": "", "given": None}, {"path": "idle", "kind": "number", "si_unit": "", "given": "1"}]

            def copy(self, at=None):
                return FakeCase({**self.at, **(at or {})})

            def __getitem__(self, path):
                return self.at[path]

            def run(self, fidelity=None):
                c, p = self.at["bearing.clearance"], self.at["input.power"]
                status = "failed" if p > 1e6 else "ok"
                return {"points": [{"life_h": 1e9 / p + 1e8 * c, "flag": True, "inner": {"load_N": 3.0 * p}, "status": status, "text": "x"}], "units": {"life_h": "h", "load_N": "kN"}} if fidelity != "single" else {"life_h": 2.0 * p, "units": {}}

            def sensitivities(self, fidelity, result, by):
                return {"inputs": [{"path": "bearing.clearance", "derivative": 4.0, "value": 20.0 if self.at["bearing.clearance"] else 0.0, "unit": "um"}, {"path": "count", "derivative": None if result == "inner/load_N" else 5.0, "value": 7.0, "unit": ""}]}

        found = {"wrong": [str(refused(lambda words=words: openmdao.Responses(FakeCase(), *words))) for words in (
            (["bearing.clearanc"], ["life_h"]), (["kind"], ["life_h"]), (["empty"], ["life_h"]), (["idle"], ["life_h"]), ([], ["life_h"]), (["count", "count"], ["life_h"]), (["count"], []), (["count"], ["lief_h"]), (["count"], ["flag"]), (["count"], ["inner/loadd_N", "zzz"]),
            (["count"], ["life_h"], None, {"count": 0.0}), (["count"], ["life_h"], None, {}), (["count"], ["life_h"], None, {"count": 1.0, "x": 2.0}))]}
        one = openmdao.Responses(FakeCase(), ["bearing.clearance", "input.power", "count"], ["life_h", "inner/load_N"], None, {"bearing.clearance": 1e-6, "input.power": 10.0, "count": 1.0})
        told = lambda slopes: [[key, path, value] for (key, path), value in slopes.items()]  # noqa: E731
        found["steps"] = [one.input_units, one.output_units, one.start, one.values({}), one.values({"input.power": 2e5}), told(one.slopes({"input.power": 1e5})), str(refused(lambda: one.values({"x": 1.0}))), str(refused(lambda: one.values({"input.power": 2e6})))]
        by = openmdao.Responses(FakeCase(), ["bearing.clearance", "count"], ["life_h"])
        found["sensitivities"] = [told(by.slopes({})), told(by.slopes({"bearing.clearance": 0.0})), str(refused(lambda: openmdao.Responses(FakeCase(), ["count"], ["inner/load_N"]).slopes({})))]
        found["single"] = openmdao.Responses(FakeCase(), ["input.power"], ["life_h"], "single").values({"input.power": 3.0})
        found["names"] = [openmdao.variable_name("a.b/c[0]"), *[openmdao.openmdao_unit(unit) for unit in ("kg/m3", "N.m", "1", "", "m s-2", "megarevolution", "N mm-1 um-1")]]

        class Component:
            def __init__(self):
                self.kept = []
                self.setup()
                self.setup_partials()

            def add_input(self, name, **more):
                self.kept.append(["input", name, more])

            def add_output(self, name, **more):
                self.kept.append(["output", name, more])

            def declare_partials(self, *words):
                self.kept.append(["partials", *words])

        api = types.SimpleNamespace(ExplicitComponent=Component)
        with unittest.mock.patch.dict(sys.modules, {"openmdao": types.ModuleType("openmdao"), "openmdao.api": api, "openmdao.utils": types.ModuleType("openmdao.utils"), "openmdao.utils.units": types.SimpleNamespace(valid_units=lambda unit: unit != "h")}):
            sys.modules["openmdao"].api = api
            made = openmdao.component(one)
            outputs, partials = {}, {}
            inputs = {openmdao.variable_name(path): np.array([value]) for path, value in one.start.items()}
            made.compute(inputs, outputs)
            made.compute_partials(inputs, partials)
            found["component"] = [made.kept, outputs, [[*key, value] for key, value in partials.items()], len(openmdao.component(FakeCase(), ["count"], ["life_h"]).kept)]
        with unittest.mock.patch.dict(sys.modules, {"openmdao": None, "openmdao.api": None}):
            found["without"] = str(refused(lambda: openmdao.component(one)))
        self.check("components", found)

    def test_mistakes(self):
        found = {"errors": []}
        for words in (["a.yaml:3:4: x.y: missing; required: z", "no place"], ["--set: b: found 'c'"], []):
            one = refused(lambda words=words: CaseError(words))
            found["errors"].append([str(one), list(one.messages), [vars(mistake) if hasattr(mistake, "__dict__") else str(mistake) for mistake in one.mistakes], str(one.without_option())])
        found["text"] = [list(CaseError("one").messages), str(ComputationError("x"))]
        found["whole numbers"] = [str(refused(lambda value=value: errors.require_whole("n", value, 2, 9))) for value in (1, 2, 9, 10, 2.5, True, "3", None, np.int64(4))]
        with tempfile.TemporaryDirectory() as place:
            target = pathlib.Path(place, "x.txt")
            whole_files.write_whole(target, "text ä")
            whole_files.write_whole(target, b"bytes")
            found["files"] = [sorted(path.name for path in pathlib.Path(place).iterdir()), target.read_text(encoding="utf-8"), str(refused(lambda: whole_files.write_whole(pathlib.Path(place, "none", "y"), "z"))).replace(place, "DIR")[:30]]
        self.check("mistakes", found)


if __name__ == "__main__":
    kept_records.main(RECORDS)
