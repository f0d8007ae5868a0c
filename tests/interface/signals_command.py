#!/usr/bin/env python3
"""`orbearing signals` from outside: labelled signals of a grid of scratches, the same whatever the order."""

import csv
import json
import pathlib
import struct
import subprocess
import tempfile
import unittest

from sweep_runs import PROGRAM, ROOT, run

CASE = str(ROOT / "cases" / "scratch_defect" / "case.yaml")
SHORT = ("--set", "signal.revolutions=3", "--set", "signal.sampling_rate=12.8 kHz")
GRID = ("--vary", "defect.race=[none, outer, inner, ball]", "--vary", "defect.width=[0.4 mm, 0.8 mm]")
NOISY = ("--noise", "0.25", "--seed", "7")


def signals(*options):
    return run([PROGRAM, "signals", CASE, *SHORT, *options])


def rows_of(folder):
    with open(folder / "labels.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def files_of(folder):
    return {path.name: path.read_bytes() for path in sorted((folder / "signals").iterdir())}


class Signals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.place = pathlib.Path(place.name)
        cls.result = signals(*GRID, *NOISY, "--quiet", "-o", str(cls.place / "whole"))
        assert cls.result.returncode == 0, cls.result.stderr

    def test_labels(self):
        rows = rows_of(self.place / "whole")
        self.assertEqual([row["defect"] for row in rows], ["none"] + [race for race in ("outer", "inner", "ball") for _ in range(2)],
                         "a sound bearing has no width and stands there once")
        self.assertEqual([row["width_mm"] for row in rows], ["", "0.4", "0.8", "0.4", "0.8", "0.4", "0.8"])
        for row in rows:
            self.assertAlmostEqual(float(row["shaft_Hz"]), 25.0)
            expected = {"none": None, "outer": 76.27, "inner": 123.73, "ball": 99.42}[row["defect"]]
            self.assertTrue(row["defect_Hz"] == "" if expected is None else abs(float(row["defect_Hz"]) - expected) < 0.01)
        self.assertLess(float(rows[0]["rms_m_s2"]), 0.3)
        self.assertGreater(float(rows[0]["rms_m_s2"]), 0.2, "noise of 0.25 m/s2 is in a signal of 0.01")

    def test_files_hold_the_signal(self):
        row = rows_of(self.place / "whole")[2]
        with open(self.place / "whole" / row["file"], encoding="utf-8", newline="") as file:
            signal = [float(line["acceleration_m_s2"]) for line in csv.DictReader(file)]
        self.assertEqual(len(signal), int(row["samples"]))
        self.assertAlmostEqual(max(map(abs, signal)), float(row["max_m_s2"]), delta=1e-6 * float(row["max_m_s2"]))
        sound = (self.place / "whole" / row["file"].replace(".csv", ".wav")).read_bytes()
        self.assertEqual(sound[:4] + sound[8:12], b"RIFFWAVE")
        self.assertEqual(struct.unpack("<I", sound[24:28])[0], 12800)
        self.assertEqual((len(sound) - 44) // 4, len(signal))

    def test_same_signals_with_one_thread_and_after_a_resume(self):
        again = self.place / "again"
        self.assertEqual(signals(*GRID, *NOISY, "--quiet", "--jobs", "1", "-o", str(again)).returncode, 0)
        self.assertEqual(files_of(again), files_of(self.place / "whole"))
        lines = (again / "manifest.jsonl").read_bytes().splitlines(keepends=True)
        (again / "manifest.jsonl").write_bytes(b"".join(lines[:4]))
        self.assertEqual(signals(*GRID, *NOISY, "--quiet", "--resume", "-o", str(again)).returncode, 0)
        self.assertEqual(files_of(again), files_of(self.place / "whole"))
        self.assertEqual(rows_of(again), rows_of(self.place / "whole"))
        other = signals(*GRID, "--noise", "0.25", "--seed", "8", "--quiet", "--resume", "-o", str(again))
        self.assertEqual(other.returncode, 2)

    def test_all_that_can_be_scratched_unless_said(self):
        result = signals("--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([one["defect"] for one in json.loads(result.stdout)["signals"]], ["none", "outer", "inner", "ball"])

    def test_run_ups_are_labelled_by_orders(self):
        folder = self.place / "run_up"
        grid = ("--vary", "defect.race=[outer, inner]", "--vary", "signal.run_up_from=[0.5, 1]")
        result = signals(*grid, "--quiet", "-o", str(folder))
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = rows_of(folder)
        for row, (race, start) in zip(rows, (("outer", 0.5), ("outer", 1.0), ("inner", 0.5), ("inner", 1.0)), strict=True):
            self.assertEqual((row["defect"], float(row["run_up_from"])), (race, start))
            self.assertAlmostEqual(float(row["defect_order"]), {"outer": 76.27, "inner": 123.73}[race] / 25, delta=1e-3)
            self.assertAlmostEqual(float(row["defect_Hz"]) / float(row["shaft_Hz"]), float(row["defect_order"]), delta=1e-9)
            with open(folder / row["file"], encoding="utf-8", newline="") as file:
                lines = list(csv.DictReader(file))
            self.assertEqual("shaft_angle_rad" in lines[0], start < 1.0)
            if start < 1.0:
                angle = [float(line["shaft_angle_rad"]) for line in lines]
                # Cut to a length that transforms fast.
                self.assertTrue(0.97 < (angle[-1] - angle[0]) / (3 * 2 * 3.14159265) <= 1.0, angle[-1] - angle[0])
                self.assertGreater(angle[-1] - angle[-2], 1.3 * (angle[1] - angle[0]))

    def test_a_set_has_no_page(self):
        report = run([PROGRAM, "report", str(self.place / "whole")])
        self.assertEqual(report.returncode, 2)
        self.assertIn("found a set of signals", report.stderr)

    def test_bad_input(self):
        for options, part in ((("--vary", "defect.race=none"), "path=[value, value]"), (("--vary", "defect.width=[0.4 mm,]"), "between commas"),
                              (("--vary", "defect.rac=[none]"), "defect.rac"), (("--vary", "defect.width=[-1 mm]"), "defect.width")):
            with self.subTest(options):
                result = signals("--json", *options)
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertIn(part, result.stderr)
        other = run([PROGRAM, "signals", str(ROOT / "cases" / "jones_218" / "case.yaml"), "--json"])
        self.assertEqual(other.returncode, 2)
        self.assertIn("raceway-defect", other.stderr)
        self.assertEqual(subprocess.run([PROGRAM, "signals", CASE], capture_output=True, check=False).returncode, 2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
