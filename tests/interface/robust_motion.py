"""Issue 50, Build 1 and 3: motions that a case can state complete, soon: needles on a pin from 100 to 20,000 rpm, designs drawn at random,
slow planets, and errors of steps that follow the load."""

import json
import os
import pathlib
import resource
import subprocess
import sys
import unittest

from program import CASES, REDUCER, WIND, answer, run, settings

SCAN = pathlib.Path(__file__).parents[1] / "scans" / "random_motion.py"
NEEDLES = CASES / "reducer_needles" / "case.yaml"
CAGE = ("bearing.complement=caged", "bearing.rollers=14", "bearing.cage.inner_diameter=33.6 mm", "bearing.cage.outer_diameter=38.8 mm",
        "bearing.cage.width=23 mm", "bearing.cage.material=steel", "bearing.cage.guide_land_diameter=39.2 mm")
SHORT = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2")
POWER = 150.0  # [kW]  at 6000 rpm and above; below, the torque of 6000 rpm


def duty(rpm):
    return f"input.speed={rpm} rpm", f"input.power={POWER * min(1.0, rpm / 6000.0):.6g} kW"


def seconds():
    """Processor time of all programs run so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def moved(case, *values, fidelity="dynamic"):
    """(The case's point in motion, processor time [s])."""
    before = seconds()
    point = answer("run", case, *values, options=("--fidelity", fidelity))["points"][0]
    return point, seconds() - before


class Needles(unittest.TestCase):
    """On the pin, in the planet's bore."""

    def test_complete_at_every_speed(self):
        for name, cage in (("full complement", ()), ("caged", CAGE)):
            for rpm in (100, 16000, 20000):
                with self.subTest(name, rpm=rpm):
                    still = answer("run", NEEDLES, *cage, *duty(rpm))["points"][0]
                    point, took = moved(NEEDLES, *cage, *duty(rpm), *SHORT)
                    print(f"{name}, {rpm} rpm: {took:.1f} s", file=sys.stderr)
                    self.assertEqual(point["status"], "ok")
                    self.assertAlmostEqual(point["outer_load_rms_N"] / still["outer_load_rms_N"], 1.0, delta=0.5)


if __name__ == "__main__":
    unittest.main()
