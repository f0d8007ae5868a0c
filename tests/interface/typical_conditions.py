"""Typical conditions of an operating record: planted ones are found again."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

from orbearing.conditions import typical_conditions

PLANTED = [(1730, 938, 0.4), (3703, 903, 0.3), (1785, 266, 0.2), (3998, 206, 0.1)]  # rpm, N, share


def record(seed, seconds=4000, step=0.5):
    """Stretches of the conditions in turn, at uneven times, with scatter."""
    random = numpy.random.default_rng(seed)
    rows, time = [], 0.0
    for _ in range(10):
        for speed, load, share in PLANTED:
            end = time + share * seconds / 10
            while time < end - 1e-9:
                rows.append((time, random.normal(speed, 40), random.normal(load, 20)))
                time = min(time + step * random.uniform(0.2, 1.8), end)
    return numpy.array(rows).T


def call(text, *options):
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place) / "record.csv"
        file.write_text(text)
        command = [sys.executable, "-m", "orbearing.conditions", str(file), *options]
        return subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)


class Conditions(unittest.TestCase):
    def test_planted_ones_are_found(self):
        for seed in range(5):
            found = typical_conditions(*record(seed), 4)
            for (speed, load, share), one in zip(PLANTED, found, strict=True):
                self.assertAlmostEqual(one.speed_rpm, speed, delta=5, msg=f"seed {seed}")
                self.assertAlmostEqual(one.load_N, load, delta=3)
                self.assertAlmostEqual(one.share, share, delta=0.002)
            self.assertAlmostEqual(sum(one.share for one in found), 1.0, places=12)

    def test_the_equivalent_load_is_the_cubic_mean_over_turns(self):
        time = numpy.arange(4.0)
        found = typical_conditions(time, numpy.array([1000.0, 1000, 3000, 3000]), numpy.array([100.0, 100, 200, 200]), 1)
        self.assertEqual(len(found), 1)
        turns, cubes = numpy.array([1000, 1000, 3000]), numpy.array([100.0, 100, 200]) ** 3  # the last one has no duration
        self.assertAlmostEqual(found[0].equivalent_load_N, (turns @ cubes / turns.sum()) ** (1 / 3), places=9)

    def test_a_record_of_one_condition(self):
        found = typical_conditions(numpy.arange(10.0), numpy.full(10, 1500.0), numpy.full(10, 300.0), 4)
        self.assertEqual([(one.speed_rpm, one.load_N, one.share) for one in found], [(1500.0, 300.0, 1.0)])


class Command(unittest.TestCase):
    def test_json_and_units(self):
        rows = "".join(f"{hour},{speed},{load}\n" for hour, speed, load in ((0, 1000, 1), (1, 1000, 1), (2, 2000, 0.5), (3, 2000, 0.5)))
        result = call("time_h,speed_rpm,load_kN\n" + rows, "--conditions", "2", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads(result.stdout)["conditions"]
        self.assertEqual(json.loads(result.stdout)["units"], {"speed_rpm": "rpm", "load_N": "N", "equivalent_load_N": "N"})
        self.assertEqual([(one["speed_rpm"], one["load_N"]) for one in found], [(1000, 1000), (2000, 500)])
        self.assertAlmostEqual(found[0]["share"], 2 / 3)

    def test_bad_input(self):
        for text, words in (("time_s,speed_rpm\n0,1\n", "no column for the load"), ("time_s,speed_rpm,load_N\n0,1,2\n", "at least 2"),
                            ("time_s,speed_rpm,load_N\n0,1,2\n1,x,2\n", ":3:"), ("time_s,speed_rpm,load_N\n0,1,2\n1,1,nan\n", "not finite"),
                            ("time_s,speed_rpm,load_N\n0,1,2\n0,1,2\n", ":3: a time that is not later")):
            result = call(text)
            self.assertEqual(result.returncode, 2, text)
            self.assertIn(words, result.stderr)
            self.assertNotIn("Traceback", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
