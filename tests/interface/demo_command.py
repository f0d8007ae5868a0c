#!/usr/bin/env python3
"""`orbearing demo`: a first result with its report in a new folder; what it prints is true of its files.

Exit code 77 (skipped) where matplotlib is missing.
"""

import csv
import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from program import CASES, run


def demo(folder, *options):
    return subprocess.run([os.environ["ORBEARING"], "demo", *map(str, options)], cwd=folder, capture_output=True, text=True, check=False)


def lives(folder):
    with open(folder / "sweep.csv", newline="", encoding="utf-8") as file:
        return [(float(row["input_speed_rpm"]), float(row["life_h"])) for row in csv.DictReader(file)]


class Demo(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def test_it_takes_a_new_folder_and_prints_what_is_there(self):
        (self.folder / "orbearing-demo").write_text("mine\n", encoding="utf-8")
        done = demo(self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual((self.folder / "orbearing-demo").read_text(encoding="utf-8"), "mine\n")
        results = self.folder / "orbearing-demo-2"
        self.assertEqual({one.name for one in self.folder.iterdir()}, {"orbearing-demo", "orbearing-demo-2"})
        self.assertIn("<svg", (results / "report.html").read_text(encoding="utf-8"))
        self.assertIn("orbearing-demo-2/report.html", done.stdout)
        points = lives(results)
        self.assertIn(f": {len(points)} speeds in sweep.csv", done.stdout)
        longest = max(points, key=lambda point: point[1])
        self.assertIn(f"{longest[1]:.0f} h at {longest[0]:.0f} rpm of the sun", done.stdout)
        for end in (points[0], points[-1]):
            self.assertRegex(done.stdout, rf"At {end[0]:.0f} rpm the \w+ (\w+ )?limits it to {end[1]:.0f} h")
        # The command that it proposes next works.
        new, = re.findall(r"^  orbearing (new .*)$", done.stdout, re.M)
        written = subprocess.run([os.environ["ORBEARING"], *new.split()], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(written.returncode, 0, written.stderr)
        self.assertEqual(run("check", self.folder / "mine.yaml", "--quiet").returncode, 0)

    def test_json_names_report_and_peak(self):
        done = demo(self.folder, "--json", "-o", "mine")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        result = json.loads(done.stdout)
        self.assertEqual((result["folder"], result["report"]), ("mine", "mine/report.html"))
        self.assertTrue(pathlib.Path(result["case"]).samefile(CASES / "reducer_150kW" / "case.yaml"))
        points = lives(self.folder / "mine")
        self.assertEqual(result["points"], len(points))
        peak = result["peak"]
        longest = max(points, key=lambda point: point[1])
        self.assertAlmostEqual(peak["refined_speed_rpm"], longest[0], places=6)
        self.assertAlmostEqual(peak["refined_life_h"] / longest[1], 1.0, places=9)
        for key, value in peak.items():
            if isinstance(value, float):
                self.assertIn(key, result["units"])

    def test_a_folder_that_holds_something_is_refused(self):
        (self.folder / "kept").write_text("", encoding="utf-8")
        done = demo(self.folder, "-o", ".", "--quiet")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(done.stderr, ".: is not empty; a new or empty folder is required\n")
        self.assertEqual([one.name for one in self.folder.iterdir()], ["kept"])


if __name__ == "__main__":
    if importlib.util.find_spec("matplotlib") is None or importlib.util.find_spec("netCDF4") is None:
        print("skipped: matplotlib or netCDF4 is missing")
        sys.exit(77)
    unittest.main()
