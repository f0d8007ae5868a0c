#!/usr/bin/env python3
"""docs/multibody: the example runs with the FMU and the loads that the program writes, and its advice holds.

Skipped where FMPy or, for the part in a multibody code, Exudyn is missing and cannot be had. Needs ORBEARING and
ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from virtual_environment import environment, interpreter_with, left_to_full

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
CASE = SOURCE / "cases" / "reducer_150kW" / "case.yaml"
FMPY = ("fmpy==0.3.32",)
EXUDYN = (*FMPY, "exudyn==1.13.6")
STEPS = (1e-6, 2e-6, 4e-6)  # [s]
RUNS = """
import json, sys
import numpy as np
from planet_bearing import EXCHANGES, INTEGRATORS, Bearing, duty_of, run_bearing
bearing, duty = Bearing(sys.argv[1]), duty_of(sys.argv[2])
rest = bearing.place_under(duty.static)
known = {"balance": (bearing.force_at(rest) + duty.static).tolist(), "mass": duty.mass, "static": duty.static.tolist()}
known["k"] = bearing.stiffness_at(rest).trace() / 2.0
bearing.begin(rest)
known["c"] = bearing.damping().trace() / 2.0
def way(exchange, size, end, integrator="force held over the step"):
    try:
        return run_bearing(bearing, duty, rest, round(end / size), size, exchange, integrator=integrator)[0]
    except (ArithmeticError, RuntimeError, OSError):
        return np.full((round(end / size) + 1, 2), np.inf)
fine = way("half a step ahead, slopes", 2.5e-7, 2e-4)
def error(exchange, size, integrator):
    return np.abs(way(exchange, size, 2e-4, integrator) - fine[::round(size / 2.5e-7)]).max()
known["errors"] = {i: {e: [error(e, s, i) for s in json.loads(sys.argv[3])] for e in EXCHANGES} for i in INTEGRATORS}
known["swing"] = {i: {e: [min(np.abs(way(e, s, 5e-3, i) - rest).max(), 1.0) for s in (2e-6, 1e-5, 2e-5)] for e in EXCHANGES}
                  for i in INTEGRATORS}
bearing.close()
print(json.dumps(known))
"""
IN_EXUDYN = """
import json, sys
import numpy as np
from exudyn_planet import errors, run_exudyn
from planet_bearing import Bearing, duty_of
bearing, duty = Bearing(sys.argv[1]), duty_of(sys.argv[2])
rest = bearing.place_under(duty.static)
def swing(share):
    places = run_exudyn(bearing, duty, rest, 500, 1e-5, share, True)
    return min(np.abs(places - rest).max(), 1.0) if len(places) == 500 else 1.0
known = {"errors": [[*key, row] for key, row in errors(bearing, duty, json.loads(sys.argv[3])).items()],
         "swing": {"half": swing(0.5), "whole": swing(1.0)}}
bearing.close()
print(json.dumps(known))
"""


def program(*arguments):
    return subprocess.run([os.environ["ORBEARING"], *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def known(python, script, sizes=STEPS):
    with tempfile.TemporaryDirectory() as folder:
        fmu, check = pathlib.Path(folder, "bearing.fmu"), pathlib.Path(folder, "check.json")
        program("fmu", CASE, "-o", fmu, "--fmi", "2", "--quiet")
        check.write_text(program("check", CASE, "--json"), encoding="utf-8")
        done = subprocess.run([python, "-c", script, fmu, check, json.dumps(sizes)], capture_output=True, text=True, cwd=folder,
                              env={**os.environ, "PYTHONPATH": str(SOURCE / "docs" / "multibody")})
    if done.returncode:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout.splitlines()[-1])


HELD, ALPHA = "force held over the step", "generalised alpha"
QUIET = 3e-6  # [m]  the planet sways by 0.8 um; one that has come loose by far more


class Example(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.known = known(PYTHON, RUNS)

    def test_the_load_is_that_which_check_prints_for_one_bearing(self):
        text = program("check", CASE)
        for axis, force in zip("xy", self.known["static"]):
            printed = re.search(rf"operation\.bore_load_{axis} +(\S+) +N", text).group(1)
            self.assertAlmostEqual(force, float(printed), delta=5e-6 * abs(force))  # six digits are printed

    def test_the_planet_rests_where_forces_balance(self):
        for rest in self.known["balance"]:
            self.assertLess(abs(rest), 1e-6 * max(map(abs, self.known["static"])))  # what place_under() asks for

    def test_errors_fall_with_the_order_of_the_exchange(self):
        for integrator, exchange, order in (
                (HELD, "in turn", 1), (HELD, "in turn, slopes", 2), (HELD, "half a step ahead", 1),
                (HELD, "half a step ahead, slopes", 2), (HELD, "a step ahead", 1), (ALPHA, "half a step ahead", 1),
                (ALPHA, "a step ahead", 1), (ALPHA, "a step ahead, slopes", 2)):
            coarse, fine = self.known["errors"][integrator][exchange][2], self.known["errors"][integrator][exchange][0]
            # Four times the step; contacts that open and close within a step cost up to half an order.
            self.assertGreater(coarse / fine, 4.0 ** (order - 0.5), f"{exchange}, {integrator}")

    def test_the_hold_that_suits_the_integrator_is_far_closer_than_the_other(self):
        """Twice at least: a force half a step off is an error of the first order, the right one's is a small part of it."""
        for integrator, right, wrong in ((HELD, "half a step ahead", "a step ahead"), (ALPHA, "a step ahead", "half a step ahead")):
            for slopes in ("", ", slopes"):
                for one, other in zip(self.known["errors"][integrator][right + slopes],
                                      self.known["errors"][integrator][wrong + slopes]):
                    self.assertLess(one, other / 2.0, integrator + slopes)

    def test_steps_are_stable_where_the_page_says_so(self):
        limit = 2.0 * self.known["c"] / self.known["k"]  # [s]
        self.assertGreater(limit, 2e-6)
        self.assertLess(limit, 1e-5)
        late = {HELD: ("parallel", "in turn"), ALPHA: ("parallel", "in turn", "half a step ahead", "half a step ahead, slopes")}
        steady = {HELD: ("half a step ahead", "half a step ahead, slopes", "a step ahead, slopes"), ALPHA: ("a step ahead, slopes",)}
        for integrator, swings in self.known["swing"].items():
            for exchange, (short, middle, long) in swings.items():
                if exchange in late[integrator]:
                    self.assertGreater(long, 10.0 * QUIET, f"{exchange}, {integrator}")
                if exchange in steady[integrator]:
                    self.assertLess(max(short, middle, long), QUIET, f"{exchange}, {integrator}")
        self.assertLess(self.known["swing"][ALPHA]["a step ahead"][1], QUIET)


class InExudyn(unittest.TestCase):
    """The same in an implicit multibody code of others, compared with a fine run that knows nothing of it."""

    @classmethod
    def setUpClass(cls):
        python, reason = environment(*EXUDYN)
        if reason:
            raise unittest.SkipTest(reason)
        cls.known = known(python, IN_EXUDYN)

    def test_an_implicit_integrator_wants_a_step_ahead_an_explicit_one_half(self):
        row = {(solver, share, slopes): errors for solver, share, slopes, errors in self.known["errors"]}
        for slopes in (False, True):
            for index in range(len(STEPS)):
                half, whole = row[ALPHA, 0.5, slopes][index], row[ALPHA, 1.0, slopes][index]
                self.assertLess(whole, half / 2.0)
                half, whole = row["Runge-Kutta", 0.5, slopes][index], row["Runge-Kutta", 1.0, slopes][index]
                self.assertLess(half, whole / 2.0)

    def test_steps_of_10_us_hold_only_with_the_right_one(self):
        self.assertLess(self.known["swing"]["whole"], QUIET)
        self.assertGreater(self.known["swing"]["half"], 10.0 * QUIET)


if __name__ == "__main__":
    left_to_full("installs Exudyn, and the advice of a page is about steps of many sizes")
    PYTHON = interpreter_with(*FMPY)
    unittest.main()
