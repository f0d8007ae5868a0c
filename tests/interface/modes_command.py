#!/usr/bin/env python3
"""`orbearing modes`, and `orbearing run` of gears alone, from outside."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

CASES = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases"
LUMPED = CASES / "lin_parker_1999" / "case.yaml"
REDUCER = CASES / "reducer_150kW" / "case.yaml"
SECONDS = 600
# Frequencies [Hz] of the planet modes do not depend on the number of planets, from four on.
PLANET_MODES = [1808.2, 5963.8, 6981.7]

GEARS = """name: gears
source: made up
model: planetary-drivetrain
input: {power: 10 kW, speed: 1500 rpm}
gearset:
  planets: 3
  teeth: {sun: 30, planet: 30, ring: 90}
  module: 2 mm
  profile_shift: {sun: 0, ring: 0}
  face_width: 20 mm
"""


def run(*arguments):
    command = [os.environ["ORBEARING"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


def result_of(*arguments):
    result = run(*arguments, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def modes(*arguments):
    return result_of("modes", *arguments)["modes"]


class Modes(unittest.TestCase):
    def test_kinds_and_multiplicities(self):
        for planets in (3, 4, 5, 6):
            with self.subTest(planets):
                found = modes(LUMPED, "--set", f"gearset.planets={planets}")
                of_kind = {kind: [m for m in found if m["kind"] == kind] for kind in
                           ("rotational", "translational", "planet")}
                self.assertEqual([m["multiplicity"] for m in of_kind["rotational"]], [1] * 6)
                self.assertEqual([m["multiplicity"] for m in of_kind["translational"]], [2] * 6)
                self.assertEqual(of_kind["rotational"][0]["frequency_Hz"], 0.0)
                expected = [] if planets == 3 else [planets - 3] * 3
                self.assertEqual([m["multiplicity"] for m in of_kind["planet"]], expected)
                for mode, frequency in zip(of_kind["planet"], PLANET_MODES):
                    self.assertAlmostEqual(mode["frequency_Hz"], frequency, delta=0.1)

    def test_speed_splits_pairs(self):
        at_rest, turning = modes(LUMPED), modes(LUMPED, "--speed", "1000 rpm")
        self.assertEqual(sum(m["multiplicity"] for m in at_rest), sum(m["multiplicity"] for m in turning))
        self.assertEqual({m["multiplicity"] for m in turning if m["kind"] == "translational"}, {1})
        self.assertTrue(all(m["growth_per_s"] == 0.0 for m in turning))

    def test_campbell(self):
        campbell = result_of("modes", REDUCER, "--speed", "6000 rpm")["campbell"]
        self.assertAlmostEqual(campbell["speed_rpm"][-1], 6000.0)
        self.assertAlmostEqual(campbell["mesh_harmonics_Hz"][-1][0], 37 * (6000 - 6000 * 37 / 116) / 60, delta=1e-6)
        self.assertEqual({len(row) for row in campbell["frequencies_Hz"]}, {20})  # 21 less the ring's rotation

    def test_bad_speed(self):
        for speed in ("6000", "100 Hz", "3 mm", "-5 rpm", "fast"):
            with self.subTest(speed):
                result = run("modes", LUMPED, f"--speed={speed}")
                self.assertEqual(result.returncode, 2)
                self.assertIn("--speed: ", result.stderr)

    def test_other_models(self):
        for case in ("mesh_62_62", "three_sets_150kW"):
            with self.subTest(case):
                result = run("modes", CASES / case / "case.yaml")
                self.assertEqual(result.returncode, 2)
                self.assertIn("required: ", result.stderr)

    def test_text_and_quiet(self):
        self.assertIn("1475.75  rotational", run("modes", LUMPED).stdout)
        self.assertEqual(run("modes", LUMPED, "--quiet").stdout, "")


class GearsAlone(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.case = pathlib.Path(self.folder.name) / "gears.yaml"
        self.case.write_text(GEARS, encoding="utf-8")
        self.out = pathlib.Path(self.folder.name) / "out"

    def test_run_without_bearing(self):
        found = result_of("run", self.case, "-o", self.out)
        self.assertTrue(found["steady"])
        # 63.66 N m on three planets at a base radius of 28.19 mm. Dampers take some tenths of a per cent, by which
        # the sun slows down at first, and its inertia pushes.
        for mesh in ("sun", "ring"):
            for planet in found["mesh_force_N"][mesh]:
                self.assertAlmostEqual(planet["mean"] / 752.7, 1.0, delta=1e-2)
        for share in found["load_sharing"]["mean"]:
            self.assertAlmostEqual(share, 1.0, delta=1e-3)
        self.assertGreater(found["planet_acceleration_m_per_s2"]["x"]["rms"], 0.0)
        names = sorted(path.name for path in self.out.rglob("*") if path.is_file())
        self.assertEqual(names, ["00000.nc", "case.resolved.yaml", "manifest.jsonl"])
        again = result_of("run", self.out / "case.resolved.yaml", "-o", self.out.with_name("again"))
        self.assertEqual(found["planet_acceleration_m_per_s2"], again["planet_acceleration_m_per_s2"])

    def test_folder_in_use(self):
        self.assertEqual(run("run", self.case, "-o", self.out, "--quiet").returncode, 0)
        self.assertEqual(run("run", self.case, "-o", self.out).returncode, 2)
        self.assertEqual(run("run", self.case, "-o", self.out, "--resume").returncode, 0)
        other = run("run", self.case, "-o", self.out, "--resume", "--set", "gearset.planets=4")
        self.assertEqual(other.returncode, 2)

    def test_gears_of_a_case_with_bearing(self):
        found = result_of("run", REDUCER, "--gears", "-o", self.out)
        self.assertAlmostEqual(found["mesh_frequency_Hz"], 2519.83, delta=0.01)
        self.assertEqual(len(found["load_sharing"]["mean"]), 4)

    def test_pin_error_is_one_a_planet(self):
        result = run("run", self.case, "-o", self.out, "--set", "gearset.dynamics.pin_error.radial=[1 um]")
        self.assertEqual(result.returncode, 2)
        self.assertIn("one value for each of the 3 planets", result.stderr)

    def test_no_life_without_bearing(self):
        result = run("sweep", self.case, "-o", self.out)
        self.assertEqual(result.returncode, 2)
        self.assertIn("bearing: missing", result.stderr)
        self.assertEqual(run("check", self.case, "--quiet").returncode, 0)

    def test_no_run_without_teeth(self):
        for command in ("run", "sweep"):
            result = run(command, LUMPED, "-o", self.out)
            self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(run("mesh", LUMPED).returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
