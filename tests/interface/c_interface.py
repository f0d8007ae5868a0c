"""The C interface of the shared library, and Python's module over it: the answers of the command line, stops and refusals.

One wheel for every Python. Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import program

orbearing = program.package()
from orbearing import _core  # pylint: disable=wrong-import-position

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
BUILD = pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1]
LIBRARY = BUILD / "lib" / "liborbearing.so"
SECONDS = 600
# Among them all models, several sets, rows and texts.
CASES = ("reducer_150kW", "three_sets_150kW", "wind_stage_750kW", "duplex_7020", "scratch_defect", "harris_209", "planet_scratch",
         "reducer_needles", "spin_bearing_7210", "reducer_150kW_uncertain", "wind_stage_tapered")

STOPPED = """
import orbearing
from orbearing import _core
import numpy as np

core = orbearing.load(orbearing.cases()["reducer_150kW"]).core
calls = []

class Enough(Exception):
    pass

def enough(*state):
    calls.append(state)
    raise Enough(len(calls))

reports = []
report = _core._Watched._report
_core._Watched._report = lambda self, *state: reports.append(state) or report(self, *state)
for compute in (lambda: _core.compute(core, "sweep", {}, enough), lambda: _core.evaluate(core, ["input.speed"], np.full((8000, 1), 600.0), progress=enough)):
    calls.clear()
    reports.clear()
    try:
        compute()
        raise SystemExit("it did not stop")
    except Enough:
        assert calls and len(calls[0]) in (1, 3), calls
        assert len(reports) < 5, "it went on to the end"
whole = []
_core.compute(core, "sweep", {"grid_only": True}, lambda *state: whole.append(state))
assert whole and all(done <= total and isinstance(doing, str) for done, total, doing in whole), whole
print("stopped")
"""


# Features that a driven bearing, driven gears, or bearings in motion do not include.
LAMINAE = {"bearing.laminae": "20", "bearing.tilt_state": "computed"}
FEATURES = {
    "tapered pair": ("wind_stage_tapered", {}),
    "spherical rollers": ("wind_stage_tapered", {"bearing.type": "spherical-roller", "bearing.rows.contact_angle": "10 deg"}),
    "elastic rim": ("reducer_150kW", {"gearset.planet_rim": "elastic"}),
    "tilt": ("wind_stage_750kW", {}),
    "unequal clearances": ("reducer_150kW", {**LAMINAE, "bearing.clearance_differences": "[0 um, 100 um]"}),
    "stepped planet": ("reducer_150kW", {**LAMINAE, "gearset.stepped_planet.offset": "28 mm", "gearset.stepped_planet.profile_shift": "-0.46",
                                         "gearset.stepped_planet.teeth": "22"}),
    "planets in pairs": ("reducer_150kW", {"gearset.teeth.ring": "121", "gearset.second_planet.teeth": "24", "gearset.profile_shift.sun": "0",
                                           "gearset.profile_shift.ring": "0"}),
    "several sets": ("three_sets_150kW", {}),
    "a single bearing": ("harris_209", {}),
    "a roller of its own": ("reducer_150kW", {"bearing.roller_diameter_deviation": "[1 um]"}),
}
# Features that each analysis refuses.
REFUSED = {
    ("fmu", "bearing"): set(FEATURES) - {"a roller of its own"},
    ("fmu", "gearset"): {"tapered pair", "spherical rollers", "elastic rim", "stepped planet", "planets in pairs", "several sets", "a single bearing"},
    ("run", "dynamic"): {"tapered pair", "spherical rollers", "stepped planet", "planets in pairs"},
    ("run", "monolithic"): {"tapered pair", "spherical rollers", "tilt", "unequal clearances", "stepped planet", "planets in pairs", "several sets"},
    ("run", "quasi-static"): {"a roller of its own"},
}


class Doors(unittest.TestCase):
    """Whether an analysis can take a case is asked in the library: command line, Python and C refuse the same with the same words."""

    def test_each_feature_at_each_door(self):
        for (command, of), features in REFUSED.items():
            for feature in sorted(features):
                with self.subTest(command=command, of=of, feature=feature):
                    name, settings = FEATURES[feature]
                    file = program.CASES / name / "case.yaml"
                    words = ["fmu", file, "--model", of, "-o", "never.fmu"] if command == "fmu" else ["run", file, "--fidelity", of, "--json"]
                    said = program.run(*words, *program.settings([f"{path}={value}" for path, value in settings.items()]))
                    self.assertEqual((said.returncode, said.stdout), (2, ""), said.stderr)
                    messages = [line.removeprefix("--set: ") for line in said.stderr.splitlines()]
                    self.assertTrue(all("required" in line for line in messages), messages)
                    case = orbearing.load(file, settings)
                    self.refuses(messages, (lambda: self.machine(case, of)) if command == "fmu" else (lambda: self.points(case, of)))
                    self.refuses(messages, (case.bearing if of == "bearing" else case.gears) if command == "fmu" else (lambda: case.run(fidelity=of)))
                    if command == "run":
                        self.refuses(messages, lambda: case.sensitivities(fidelity=of, by=["input.power"]))

    @staticmethod
    def machine(case, model):
        """By the C function."""
        _core.Machine(case.core, model)

    @staticmethod
    def points(case, fidelity):
        orbearing.evaluate(case, ["input.power"], [[150e3]], fidelity)

    def refuses(self, messages, call):
        with self.assertRaises(orbearing.CaseError) as raised:
            call()
        self.assertEqual([text.removeprefix("--set: ") for text in raised.exception.messages], messages)

    def test_what_they_take_is_made(self):
        """What the FMU of a bearing takes: unlike rollers."""
        name, settings = FEATURES["a roller of its own"]
        for model in ("bearing", "gearset"):
            _core.Machine(orbearing.load(program.CASES / name / "case.yaml", settings if model == "bearing" else {}).core, model)

    def test_a_machine_has_a_model_and_finite_numbers(self):
        case = orbearing.load(program.CASES / "reducer_150kW" / "case.yaml")
        with self.assertRaises(orbearing.CaseError) as raised:
            _core.Machine(case.core, "zz")
        self.assertEqual(raised.exception.messages, ["model: found 'zz'; required: bearing or gearset"])
        bearing = case.bearing()
        for call, text in ((lambda: bearing.initialize(float("nan")), "initialize: time [s]: found nan; required: a finite number"),
                           (lambda: bearing.initialize(float("inf")), "initialize: time [s]: found inf; required: a finite number"),
                           (lambda: bearing.set_input("planet.velocity.x", float("nan")), "planet.velocity.x: found nan; required: a finite number"),
                           (lambda: bearing.set_input("planet.velocity.x", 0.0, float("inf")), "planet.velocity.x, slope: found inf; required: a finite number"),
                           (lambda: bearing.advance(float("nan")), "advance: found nan s; required: above 0"),
                           (lambda: bearing.advance(float("inf")), "advance: step [s]: found inf; required: a finite number")):
            with self.assertRaises(orbearing.CaseError) as raised:
                call()
            self.assertEqual(raised.exception.messages, [text])
        bearing.initialize(0.0)
        self.assertTrue(np.isfinite(bearing.force).all())


class CInterface(unittest.TestCase):
    def test_answers_are_those_of_the_command_line(self):
        for name in CASES:
            with self.subTest(name):
                file = orbearing.cases()[name]
                self.assertEqual(json.loads(_core.compute(_core.load(str(file)), "check")[0]), program.answer("check", file))

    def test_what_cannot_be_asked_is_a_mistake_of_the_input(self):
        core = _core.load(str(program.REDUCER))
        machine = _core.Machine(core)
        for call in (lambda: _core.load("nowhere.yaml"), lambda: _core.parse("model: planetary-drivetrain\nname: 3", "stated"),
                     lambda: core.value("bearing.radial_clearence"), lambda: core.si("input.speed", "6000 mm"),
                     lambda: core.with_settings([("bearing.radial_clearance", "soon")]), lambda: _core.compute(core, "run", {"fidelity": "exact"}),
                     lambda: _core.compute(None, "run"), lambda: _core.evaluate(core, [], np.zeros((2, 0))),
                     lambda: _core.evaluate(core, ["input.speed"], np.zeros((2, 2))), lambda: _core.evaluate(core, ["input.sped"], np.zeros((2, 1))),
                     lambda: machine.set_input("nowhere", 1.0), lambda: machine.output("nowhere"), lambda: machine.restore([0.0]),
                     lambda: _core.Machine(_core.load(str(program.CASES / "duplex_7020" / "case.yaml"))), lambda: _core.CoreTable("nowhere.json")):
            self.assertRaises(orbearing.CaseError, call)

    def test_a_progress_function_stops_a_computation_and_the_next_one_runs(self):
        done = subprocess.run([sys.executable, "-c", STOPPED], capture_output=True, text=True, timeout=SECONDS, check=False,
                              env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
        self.assertEqual((done.returncode, done.stdout), (0, "stopped\n"), done.stderr)

    def test_the_library_has_the_functions_of_the_header_and_no_others(self):
        header = (SOURCE / "include" / "orbearing" / "c_interface.h").read_text(encoding="utf-8")
        declared = set(re.findall(r"\b(orbearing_\w+)\(", header))
        package = (SOURCE / "python" / "orbearing" / "_core.py").read_text(encoding="utf-8")
        tables = package[package.index("_FUNCTIONS = {"):package.index("_library = ")]
        self.assertEqual({f"orbearing_{name}" for name in re.findall(r'^    "(\w+)":', tables, re.M)}, declared)
        symbols = subprocess.run(["nm", "-D", "--defined-only", str(LIBRARY)], capture_output=True, text=True, check=True).stdout
        self.assertEqual(set(re.findall(r" T (orbearing_\w+)$", symbols, re.M)), declared)

    def test_the_header_is_c(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "caller.c"
            file.write_text('#include "orbearing/c_interface.h"\nint main(void) { return orbearing_version() == NULL; }\n')
            built = subprocess.run(["cc", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", f"-I{SOURCE / 'include'}", str(file), str(LIBRARY),
                                    "-o", f"{folder}/caller"], capture_output=True, text=True, check=False)
            self.assertEqual(built.returncode, 0, built.stderr)
            ran = subprocess.run([f"{folder}/caller"], env={**os.environ, "LD_LIBRARY_PATH": str(LIBRARY.parent)}, check=False)
            self.assertEqual(ran.returncode, 0)


if __name__ == "__main__":
    unittest.main()
