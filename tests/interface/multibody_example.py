#!/usr/bin/env python3
"""docs/multibody: the example runs with the FMU that the program writes, and its advice holds.

Skipped where FMPy is missing and cannot be had. Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from virtual_environment import interpreter_with

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
FMPY = ("fmpy==0.3.32",)
RUNS = """
import json, sys
import numpy as np
from planet_bearing import EXCHANGES, MASS, STATIC, Bearing, run_bearing
bearing = Bearing(sys.argv[1])
rest = bearing.place_under(STATIC)
known = {"balance": (bearing.force_at(rest) + STATIC).tolist(), "inertia": MASS}
known["k"] = bearing.stiffness_at(rest).trace() / 2.0
bearing.begin(rest)
known["c"] = bearing.damping().trace() / 2.0
def way(exchange, size, end):
    try:
        return run_bearing(bearing, rest, round(end / size), size, exchange)[0]
    except ArithmeticError:
        return np.full((round(end / size) + 1, 2), np.inf)
fine = way("half a step ahead, slopes", 2.5e-7, 2e-4)
known["errors"] = {e: [np.abs(way(e, s, 2e-4) - fine[::round(s / 2.5e-7)]).max() for s in (1e-6, 2e-6, 4e-6)]
                   for e in EXCHANGES}
known["swing"] = {e: [min(np.abs(way(e, s, 5e-3) - rest).max(), 1.0) for s in (2e-6, 2e-5)] for e in EXCHANGES}
bearing.close()
print(json.dumps(known))
"""


def known():
    with tempfile.TemporaryDirectory() as folder:
        fmu = pathlib.Path(folder, "bearing.fmu")
        subprocess.run([os.environ["ORBEARING"], "fmu", SOURCE / "cases" / "reducer_150kW" / "case.yaml", "-o", fmu,
                        "--fmi", "2", "--quiet"], check=True, capture_output=True)
        done = subprocess.run([PYTHON, "-c", RUNS, fmu], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(SOURCE / "docs" / "multibody")})
    if done.returncode:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


class Example(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.known = known()

    def test_the_planet_rests_where_forces_balance(self):
        for rest in self.known["balance"]:
            self.assertLess(abs(rest), 1e-3)  # [N] of 600; what place_under() asks for

    def test_errors_fall_with_the_order_of_the_exchange(self):
        for exchange, order in (("in turn", 1), ("in turn, slopes", 2), ("half a step ahead", 1),
                                ("half a step ahead, slopes", 2)):
            coarse, fine = self.known["errors"][exchange][2], self.known["errors"][exchange][0]
            # Four times the step; contacts that open and close within a step cost up to half an order.
            self.assertGreater(coarse / fine, 4.0 ** (order - 0.5), exchange)

    def test_half_a_step_ahead_is_far_closer_than_in_turn_without_slopes(self):
        for ahead, in_turn in zip(self.known["errors"]["half a step ahead"], self.known["errors"]["in turn"]):
            self.assertLess(ahead, in_turn / 5.0)

    def test_steps_are_stable_where_the_page_says_so(self):
        quiet, limit = 3e-6, 2.0 * self.known["c"] / self.known["k"]  # [m], [s]
        self.assertGreater(limit, 2e-6)
        self.assertLess(limit, 2e-5)
        for exchange, (short, long) in self.known["swing"].items():
            self.assertLess(short, quiet, exchange)
            if exchange in ("parallel", "in turn"):
                self.assertGreater(long, 10.0 * quiet, exchange)
            if exchange.startswith("half a step ahead"):
                self.assertLess(long, quiet, exchange)


if __name__ == "__main__":
    PYTHON = interpreter_with(*FMPY)
    unittest.main()
