"""Motions that a case can state complete, soon: needles on a pin at any speed, designs drawn at random, and errors of
steps that follow the load. A motion that cannot be computed names the part and the input."""

import pathlib
import resource
import subprocess
import sys
import unittest

from program import CASES, LEFT_TO_FULL, REDUCER, WIND, answer, run, settings

SCAN = pathlib.Path(__file__).parents[1] / "scans" / "random_motion.py"
NEEDLES = CASES / "reducer_needles" / "case.yaml"
CAGE = ("bearing.complement=caged", "bearing.rollers=14", "bearing.cage.inner_diameter=33.6 mm", "bearing.cage.outer_diameter=38.8 mm",
        "bearing.cage.width=23 mm", "bearing.cage.material=steel", "bearing.cage.guide_land_diameter=39.2 mm")
SHORT = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2")
TORQUE = "238 N.m"  # of the published reducer at 6000 rpm


def moved(case, *values):
    """(The case's point in motion, processor time [s])."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    point = answer("run", case, *values, options=("--fidelity", "dynamic"))["points"][0]
    return point, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


class Needles(unittest.TestCase):
    """On the pin, in the planet's bore."""

    def completes(self, rpm, *values):
        duty = (f"input.speed={rpm} rpm", "input.torque=" + TORQUE)
        with self.subTest(values=values, rpm=rpm):
            still = answer("run", NEEDLES, *values, *duty)["points"][0]
            point, took = moved(NEEDLES, *values, *duty, *SHORT)
            print(f"{'caged' if values else 'full complement'}, {rpm} rpm: {took:.1f} s", file=sys.stderr)
            self.assertEqual(point["status"], "ok")
            self.assertAlmostEqual(point["outer_load_rms_N"] / still["outer_load_rms_N"], 1.0, delta=0.3)

    def test_a_full_complement_completes_at_any_speed(self):
        for rpm in (16000, 20000) if LEFT_TO_FULL else (100, 16000, 20000):  # 100 rpm takes 20 s
            self.completes(rpm)

    def test_caged_ones_complete_at_any_speed(self):
        for rpm in (100, 16000, 20000):
            self.completes(rpm, *CAGE)

    def test_on_a_stiff_pin_complete(self):
        for stiffness in ("5e8 N/m", "1e11 N/m"):
            self.completes(16000, *CAGE, "support.stiffness=" + stiffness)


@unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
class Reasons(unittest.TestCase):
    def test_a_motion_without_a_step_names_part_and_input(self):
        """A cage that weighs a millionth of a milligram."""
        result = run("run", REDUCER, "--fidelity", "dynamic", *settings((*SHORT, "bearing.cage.density=1e-6 kg/m3")))
        self.assertEqual(result.returncode, 1)
        for part in ("no step was small enough", "that of the cage", "on bearing.cage.pocket_stiffness", "bearing.cage.density"):
            self.assertIn(part, result.stderr)


class ErrorsOfSteps(unittest.TestCase):
    """Of the wind stage at twice its torque, whose contacts deflect by tens of micrometres."""

    HEAVY = (*SHORT, "input.power=1500 kW")

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_follow_the_load_and_leave_life_and_slip(self):
        points = {share: moved(WIND, *self.HEAVY, f"simulation.load_error_share={share}")[0] for share in ("2e-4", "2e-5", "2e-6")}
        exact, _ = moved(WIND, *self.HEAVY, "simulation.length_error=2e-8 mm")
        error = {share: abs(point["life_h"] / exact["life_h"] - 1.0) for share, point in points.items()}
        print("life over that of a tenth of the fixed error:", error, file=sys.stderr)
        self.assertLess(error["2e-5"], 1e-3)
        self.assertAlmostEqual(points["2e-5"]["cage_slip"], exact["cage_slip"], delta=2e-3)
        self.assertNotEqual(points["2e-4"]["life_h"], points["2e-5"]["life_h"])

    def test_leave_the_published_reducer_to_the_bit(self):
        self.assertEqual(moved(REDUCER, *SHORT)[0], moved(REDUCER, *SHORT, "simulation.load_error_share=0")[0])

    def test_a_stated_error_is_the_error(self):
        stated = (*self.HEAVY, "simulation.length_error=2e-7 mm")
        checked = run("check", WIND, *settings(stated))
        self.assertRegex(checked.stdout, r"load_error_share\s+0\b")
        self.assertEqual(moved(WIND, *stated)[0], moved(WIND, *self.HEAVY, "simulation.load_error_share=0")[0])


@unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
class Scan(unittest.TestCase):
    """tests/scans/random_motion.py, the same few designs each day."""

    def completes(self, *options):
        result = subprocess.run([sys.executable, SCAN, "--short", "--jobs", "1", *options], capture_output=True, text=True, check=False)
        print(result.stdout, file=sys.stderr)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_drivetrains(self):
        self.completes("--count", "5", "--seconds", "60")

    def test_ball_bearings(self):
        self.completes("--kind", "balls", "--count", "8", "--seconds", "60")

    def test_one_system(self):
        self.completes("--kind", "system", "--count", "2", "--seconds", "60")


if __name__ == "__main__":
    unittest.main()
