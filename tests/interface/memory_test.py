#!/usr/bin/env python3
"""How much memory a dynamic sweep takes at most, and that more points do not take more."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from sweep_runs import sweep_call

MOST = 100.0  # [MB] promised for a sweep
# [MB] Each further thread adds a point in progress and an arena of the allocator; what a point leaves is its row.
GROWTH = 8.0
EVERY_THOUSAND = "sweep.input.speed={from: 1000 rpm, to: 12000 rpm, step: 1000 rpm}"
MANY = "sweep.input.speed={from: 6000 rpm, to: 12000 rpm, step: 200 rpm}"
# A point holds as much at its end, however short its run.
SHORT = ("--set", "simulation.observed_revolutions=1", "--set", "simulation.most_revolutions=2", "--set", "simulation.length_error=2e-6 mm")


def memory_of(call):
    """Largest resident size [MB] of a program of its own, and how it ended."""
    child = subprocess.Popen(call, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return usage.ru_maxrss / 1e3, child.returncode


class Memory(unittest.TestCase):
    def measure(self, grid, *options):
        with tempfile.TemporaryDirectory() as place:
            used, code = memory_of(sweep_call(Path(place, "out"), "--fidelity", "dynamic", "--jobs", "2", "--grid-only", *options, grid=grid))
        self.assertEqual(code, 0)
        return used

    def test_a_dynamic_sweep_stays_below_what_is_promised_and_more_points_take_no_more(self):
        twelve = self.measure(EVERY_THOUSAND, *SHORT)
        many = self.measure(MANY, *SHORT)
        print(f"twelve points: {twelve:.1f} MB; thirty-one: {many:.1f} MB")
        self.assertLess(twelve, MOST)
        self.assertLess(many, twelve + GROWTH)

    def test_the_measure_sees_memory(self):
        used, code = memory_of(["/usr/bin/env", "python3", "-c", "print(len(bytearray(150_000_000)))"])
        self.assertEqual(code, 0)
        self.assertGreater(used, 150.0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
