"""The C interface of the shared library, and Python's module over it: the answers of the command line, stops and refusals.

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
