#!/usr/bin/env python3
"""What the benchmarks in Python and tools/bench promise, without timing anything that matters.

Needs the program's path in ORBEARING and the source folder in ORBEARING_SOURCE_DIR. Where the benchmarks are built beside the
program (ORBEARING_BUILD_BENCHMARKS), their orbearing_pace is asked, too.
"""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2])).resolve()
PROGRAM = pathlib.Path(os.environ["ORBEARING"]).resolve()
SECONDS = 600

sys.path.insert(0, str(SOURCE / "benchmarks"))
import command  # noqa: E402
import exudyn_ball  # noqa: E402
import over_base  # noqa: E402


class Spread(unittest.TestCase):
    def test_median_and_quartiles_of_five(self):
        self.assertEqual(command.middle([50.0, 10.0, 40.0, 20.0, 30.0]), (30.0, 20.0, 40.0))

    def test_the_extremes_of_two(self):
        self.assertEqual(command.middle([3.0, 1.0]), (2.0, 1.0, 3.0))


class Pairs(unittest.TestCase):
    def test_a_ratio_is_how_many_times_faster_than_the_base(self):
        seconds = {"ours": 2.0, "base": 6.0}
        self.assertEqual(over_base.ratios("ours", "base", 4, seconds.get), [3.0] * 4)

    def test_versions_run_in_turn_each_first_every_other_time(self):
        asked = []

        def time_of(version):
            asked.append(version)
            return 1.0

        over_base.ratios("ours", "base", 3, time_of)
        self.assertEqual(asked, ["ours", "base", "base", "ours", "ours", "base"])


class Runs(unittest.TestCase):
    def test_a_run_tells_its_result_time_and_memory(self):
        run = command.Run(str(PROGRAM), ["run", str(SOURCE / "cases/reducer_150kW/case.yaml")])
        self.assertEqual(len(run.result["points"]), 1)
        self.assertGreater(run.cpu, 0.0)
        self.assertGreater(run.wall, 0.0)
        self.assertGreater(run.peak_MB, 1.0)
        self.assertLess(run.peak_MB, 1000.0)

    def test_a_run_that_fails_is_no_figure(self):
        with self.assertRaisesRegex(RuntimeError, "nowhere.yaml"):
            command.Run(str(PROGRAM), ["run", "nowhere.yaml"])

    def test_one_system_runs_as_many_revolutions_as_are_asked_for(self):
        # Two before, none of them steady at that drift, then those observed: what is subtracted is their cost alone.
        case = str(SOURCE / "cases/reducer_150kW/case.yaml")
        few = command.settings(["gearset.planets=2", "bearing.per_planet=1", "simulation.length_error=1e-5 mm"])
        run = command.Run(str(PROGRAM), ["run", case, "--fidelity", "monolithic", *few,
                                         *command.settings(command.one_system(1))])
        self.assertEqual(run.result["points"][0]["steady"], 0.0)


# The program adds the centrifugal force of the balls, a newton beside the 40 that the loaded one carries, on one of both races.
FORMULA = 3e-3


class Hertz(unittest.TestCase):
    """The contact of Exudyn's balls is ours only with the same stiffness."""

    def test_complete_elliptic_integrals(self):
        # Parameter 1/2: Gauss' lemniscate, K = Gamma(1/4)^2 / (4 sqrt(pi)), and Legendre's relation 2 E K - K^2 = pi/2.
        first, second = exudyn_ball.elliptic(0.5)
        self.assertAlmostEqual(first, math.gamma(0.25) ** 2 / (4.0 * math.sqrt(math.pi)), delta=1e-14)
        self.assertAlmostEqual(2.0 * second * first - first**2, 0.5 * math.pi, delta=1e-13)

    def test_approach_of_a_ball_is_that_of_the_program(self):
        # One ball on the line of the load carries all of it, and rings approach by both contacts and half the clearance.
        load, balls = 100.0, exudyn_ball.BALLS
        case = str(SOURCE / "cases/deep_groove_motor/case.yaml")
        fields = ["simulation.duration=0.01 s", "simulation.start=rolling", f"load.radial={load} N"]
        stiffness = command.Run(str(PROGRAM), ["run", case, *command.settings(fields)]).result["stiffness"]
        inner, outer = (exudyn_ball.hertz_stiffness(race) for race in ("inner", "outer"))
        both = (inner ** (-2.0 / 3.0) + outer ** (-2.0 / 3.0)) ** -1.5
        angles = [2.0 * math.pi * ball / balls for ball in range(balls)]

        def carried(displacement):
            approaches = [max(0.0, displacement * math.cos(angle) - 0.5 * exudyn_ball.CLEARANCE) for angle in angles]
            force = sum(both * a**1.5 * math.cos(angle) for a, angle in zip(approaches, angles))
            slope = sum(1.5 * both * math.sqrt(a) * math.cos(angle) ** 2 for a, angle in zip(approaches, angles))
            return force, slope

        low, high = 0.0, 1e-3
        for _ in range(100):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if carried(middle)[0] < load else (low, middle)
        self.assertAlmostEqual(stiffness[0][0] / carried(high)[1], 1.0, delta=FORMULA)


class Pace(unittest.TestCase):
    def setUp(self):
        if not (PROGRAM.parent / "orbearing_pace").exists():
            self.skipTest("orbearing_pace is not built (ORBEARING_BUILD_BENCHMARKS)")

    def test_equal_versions_are_equally_fast(self):
        ours, base = over_base.Pace(str(PROGRAM.parent)), over_base.Pace(str(PROGRAM.parent))
        try:
            for version in (ours, base):
                self.assertEqual(version.ask("bearing 6000 0 constant"), ["ready"])
            answers = [version.ask("run") for version in (ours, base)]
            self.assertEqual(answers[0][1:], answers[1][1:])  # simulated time and steps
            found = over_base.ratios(ours, base, 9, lambda version: version.number("run"))
            # CPU times in turn: a factor of two would be another program.
            self.assertLess(abs(math.log(command.middle(found)[0])), math.log(1.5))
        finally:
            ours.close()
            base.close()

    def test_a_request_that_it_does_not_know_ends_it(self):
        done = subprocess.run([PROGRAM.parent / "orbearing_pace"], input="gallop\n", capture_output=True, text=True,
                              timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("gallop", done.stderr)


class Tool(unittest.TestCase):
    def bench(self, *arguments):
        return subprocess.run([SOURCE / "tools/bench", *arguments], capture_output=True, text=True, timeout=SECONDS,
                              check=False)

    def test_what_is_no_base_is_refused_before_anything_is_built(self):
        with tempfile.TemporaryDirectory() as folder:
            done = self.bench("--json", "--base", folder)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stdout, "")
        self.assertIn("--base: " + folder, done.stderr)

    def test_unknown_arguments_are_refused(self):
        done = self.bench("--jsno")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--jsno", done.stderr)


if __name__ == "__main__":
    unittest.main()
