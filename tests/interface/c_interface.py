"""The C interface of the shared library, and the Python package over it: the same answers as by the compiled module, to the last bit.

Issue 51, Build 6: one wheel for every Python. Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import program
from virtual_environment import skip

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
BUILD = pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1]
LIBRARY = BUILD / "lib" / "liborbearing.so"
SECONDS = 600
# Among them all models, several sets, rows and texts.
CASES = ("reducer_150kW", "three_sets_150kW", "wind_stage_750kW", "duplex_7020", "scratch_defect", "harris_209", "planet_scratch",
         "reducer_needles", "spin_bearing_7210", "reducer_150kW_uncertain", "wind_stage_tapered")

# Run with each of the two: prints what it was answered.
QUESTIONS = """
import json, sys
import numpy as np
import orbearing
from orbearing import _core

def kind(call):
    try:
        return repr(call())
    except Exception as error:
        return [type(error).__name__, str(error)]

found = {"core": _core.__file__, "version": _core.version, "instruction_set": _core.instruction_set}
for name in sys.argv[1:]:
    if name not in orbearing.cases():
        continue
    core = orbearing.load(orbearing.cases()[name]).core
    paths = [row["path"] for row in core.inputs()]
    found[name] = {"case": [core.name(), core.model(), core.hash(), core.resolved(), core.axes(), core.inputs()],
                   "values": {path: [repr(core.value(path)), core.given(path)] for path in paths},
                   "units": {path: json.dumps(_core.si_units(path)) for path in paths},
                   "check": _core.compute(core, "check")}
core = orbearing.load(orbearing.cases()["reducer_150kW"]).core
found["si"] = [repr(core.si("input.speed", "6000 rpm")), repr(core.si("bearing.radial_clearance", ["1 um", "2 mil"]))]
found["changed"] = [core.with_settings([("bearing.radial_clearance", "10 um")]).hash(), core.with_numbers([("bearing.radial_clearance", 1e-5)]).hash(),
                    core.without_sweep().hash()]
values = np.array([[speed, clearance] for speed in (300.0, 600.0) for clearance in (0.0, 2e-5, -1.0)])
columns, table, status = _core.evaluate(core, ["input.speed", "bearing.radial_clearance"], values, jobs=2)
found["evaluate"] = [columns, [repr(one) for one in np.asarray(table).ravel().tolist()], status, list(np.shape(table))]
machine = _core.Machine(core)
machine.set_input("planet.displacement.x", 2e-5)
machine.set_input("planet.displacement.y", 1e-5, 1e-3)
machine.initialize(0.5)
machine.advance(1e-4)
saved = machine.save()
machine.advance(1e-4)
later = machine.outputs()
machine.restore(saved)
machine.advance(1e-4)
found["machine"] = [repr(machine.time), repr(machine.input("planet.displacement.y")), repr(later), machine.outputs() == later,
                    repr(machine.output("force.x")), repr(machine.slope("force.x", "planet.displacement.x")), len(saved),
                    [list(row) for row in machine.inputs], [list(row) for row in machine.output_list]]
found["refused"] = [
    kind(lambda: _core.load("nowhere.yaml")), kind(lambda: _core.parse("model: planetary-drivetrain\\nname: 3", "stated")),
    kind(lambda: core.value("bearing.radial_clearence")), kind(lambda: core.si("input.speed", "6000 mm")),
    kind(lambda: core.with_settings([("bearing.radial_clearance", "soon")])), kind(lambda: _core.compute(core, "run", {"fidelity": "exact"})),
    kind(lambda: _core.compute(None, "run")), kind(lambda: _core.evaluate(core, [], np.zeros((2, 0)))),
    kind(lambda: _core.evaluate(core, ["input.speed"], np.zeros((2, 2)))), kind(lambda: _core.evaluate(core, ["input.sped"], np.zeros((2, 1)))),
    kind(lambda: machine.set_input("nowhere", 1.0)), kind(lambda: machine.output("nowhere")), kind(lambda: machine.advance(-1.0)),
    kind(lambda: machine.restore([0.0])), kind(lambda: _core.Machine(orbearing.load(orbearing.cases()["duplex_7020"]).core))]
found["run"] = _core.compute(core, "sweep", {"grid_only": True})[0]
print(json.dumps(found))
"""

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


class Package:
    """The Python package without a compiled module: its files alone, over the library of the build."""

    def __init__(self):
        self._place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._place.name)
        (self.folder / "orbearing").mkdir()
        for entry in (SOURCE / "python" / "orbearing").iterdir():
            if entry.name != "__pycache__":
                (self.folder / "orbearing" / entry.name).symlink_to(entry)

    def end(self):
        self._place.cleanup()

    def run(self, *words, **more):
        environment = {**os.environ, "PYTHONPATH": str(self.folder), "ORBEARING_LIBRARY": str(LIBRARY), "ORBEARING_PACKAGE": str(self.folder)}
        return subprocess.run([sys.executable, *words], capture_output=True, text=True, timeout=SECONDS, check=False, env={**environment, **more})


class CInterface(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.package = Package()
        cls.addClassCleanup(cls.package.end)

    def test_answers_are_those_of_the_compiled_module(self):
        compiled = subprocess.run([sys.executable, "-c", QUESTIONS, *CASES], capture_output=True, text=True, timeout=SECONDS, check=False,
                                  env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
        self.assertEqual(compiled.returncode, 0, compiled.stderr)
        called = self.package.run("-c", QUESTIONS, *CASES)
        self.assertEqual(called.returncode, 0, called.stderr)
        ours, theirs = json.loads(called.stdout), json.loads(compiled.stdout)
        self.assertTrue(ours.pop("core").endswith("_core.py"))
        self.assertTrue(theirs.pop("core").endswith(".so"))
        self.assertGreaterEqual(len(set(ours) & set(CASES)), 5)
        self.maxDiff = 2000
        for part, answer in theirs.items():
            with self.subTest(part):
                self.assertEqual(ours[part], answer)
        self.assertEqual(set(ours), set(theirs))
        self.assertEqual(ours["evaluate"][2][0], "ok")
        self.assertTrue(all(isinstance(one, list) for one in ours["refused"]), ours["refused"])

    def test_a_progress_function_stops_a_computation_and_the_next_one_runs(self):
        done = self.package.run("-c", STOPPED)
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

    @unittest.skipIf(program.LEFT_TO_FULL, "all tests of the package again: tools/test --full, or by hand")
    def test_the_package_passes_its_tests(self):
        done = self.package.run(str(SOURCE / "tests" / "interface" / "python_package.py"))
        self.assertEqual(done.returncode, 0, done.stderr[-3000:])


if __name__ == "__main__":
    if not LIBRARY.exists():
        skip("the build has no shared library (target orbearing_library)")
    program.package()
    unittest.main()
