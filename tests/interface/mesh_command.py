"""`orbearing mesh` from outside: its JSON, its text, and cases that have no mesh."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

CASES = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases"
PAIR = CASES / "mesh_62_62" / "case.yaml"
SET = CASES / "reducer_150kW" / "case.yaml"
SECONDS = 600


def run(*arguments):
    command = [os.environ["ORBEARING"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


def meshes(*arguments):
    result = run("mesh", *arguments, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)["meshes"]


class Mesh(unittest.TestCase):
    def test_pair(self):
        (mesh,) = meshes(PAIR)
        self.assertAlmostEqual(mesh["contact_ratio"], 1.7897798668, delta=1e-6)
        self.assertAlmostEqual(mesh["mean_N_per_m"] / 3.903e8, 1.0, delta=0.03)
        fractions = [fraction for fraction, _ in mesh["curve"]]
        self.assertEqual(fractions, sorted(fractions))
        self.assertGreaterEqual(len(fractions), 100)

    def test_options_after_and_before(self):
        (wide,) = meshes("--set", "pair.face_width=40 mm", PAIR)
        (plain,) = meshes(PAIR)
        self.assertAlmostEqual(wide["mean_N_per_m"] / plain["mean_N_per_m"], 2.0, delta=1e-9)

    def test_other_pairs(self):
        for teeth in ("[30, 20]", "[25, 70]", "[20, 20]", "[2000, 2000]"):
            with self.subTest(teeth):
                (mesh,) = meshes(PAIR, "--set", f"pair.teeth={teeth}")
                self.assertGreater(mesh["min_N_per_m"], 0.0)
                self.assertLess(mesh["contact_ratio"], 2.0)

    def test_set(self):
        found = meshes(SET)
        self.assertEqual([mesh["name"] for mesh in found[:2]], ["sun-planet 1", "sun-planet 2"])
        self.assertEqual(len(found), 8)

    def test_text(self):
        result = run("mesh", PAIR)
        self.assertEqual(result.returncode, 0)
        self.assertIn("1.78978", result.stdout)
        self.assertEqual(run("mesh", PAIR, "--quiet").stdout, "")

    def test_pair_is_not_run(self):
        with tempfile.TemporaryDirectory() as folder:
            for command in ("run", "sweep"):
                output = pathlib.Path(folder) / command
                result = run(command, PAIR, "-o", output)
                self.assertEqual(result.returncode, 2)
                self.assertIn("orbearing mesh", result.stderr)
                self.assertFalse(output.exists())

    def test_bad_pairs(self):
        for setting, part in (
            ("pair.teeth=[20]", "pair.teeth: a list of 1"),
            ("pair.teeth=[20, many]", "not a whole number"),
            ("pair.bore=0 mm", "pair.bore"),
            ("pair.bore=1 m", "root diameter"),
            ("pair.profile_shift=[-2, -2]", "larger sum"),
            ("pair.profile_shift=[.nan, 0]", "finite"),
        ):
            with self.subTest(setting):
                result = run("mesh", PAIR, "--set", setting)
                self.assertEqual(result.returncode, 2)
                self.assertEqual(result.stdout, "")
                self.assertRegex(result.stderr, r"^(--set|.*:\d+:\d+): pair\.")
                self.assertIn(part, result.stderr)


if __name__ == "__main__":
    if "ORBEARING" not in os.environ:
        print("skipped: ORBEARING does not name the program")
        sys.exit(77)
    unittest.main()
