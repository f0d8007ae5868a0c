#!/usr/bin/env python3
"""`orbearing study` and `orbearing.study` with a bearing: the numbers of sweeps, kills at any moment, what is refused.

KILLS (default 3) sets how many times it is killed, SEED the moments.
"""

import csv
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import program

orbearing = program.package()

import numpy as np  # noqa: E402
import xarray  # noqa: E402

from orbearing.studies.__main__ import main  # noqa: E402
from orbearing.studies.folder import DATASET, finished_counts  # noqa: E402

CASE, PROGRAM = str(program.REDUCER), os.environ["ORBEARING"]
KILLS = int(os.environ.get("KILLS", "3"))
# A parent that ignores SIGINT would pass that on to the program.
signal.signal(signal.SIGINT, signal.default_int_handler)
SEED = int(os.environ.get("SEED", str(time.time_ns() % 1_000_000)))
VARY = ("--vary", "bearing.radial_clearance=[0 um, 10 um, 0.02 mm]", "--vary", "film.enabled=[false, true]")
MANY = ("--vary", "bearing.radial_clearance={from: 0 um, to: 40 um}", "--sampler", "sobol", "--samples", "256")


def call(*options):
    return [PROGRAM, "study", CASE, *map(str, options)]


def run(*options):
    return program.within(main, CASE, *options)


def sweep(folder, *options):
    """Rows of the table of a sweep."""
    subprocess.run([PROGRAM, "sweep", CASE, "-o", str(folder), "--quiet", "--grid-only", *options], check=True)
    with open(folder / "sweep.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class Study(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.place = pathlib.Path(place.name)
        cls.result = program.run("study", CASE, "-o", cls.place / "grid", *VARY, "--points", "peak", "--json")
        assert cls.result.returncode == 0, cls.result.stderr
        with xarray.open_dataset(cls.place / "grid" / DATASET) as stored:
            cls.stored = stored.load()

    def test_the_numbers_of_a_sweep_to_the_last_bit(self):
        rows = sweep(self.place / "sweep", "--set", "bearing.radial_clearance=0.02 mm", "--set", "film.enabled=true")
        variant = self.stored.sel({"bearing.radial_clearance": 20.0, "film.enabled": "true"})
        compared = 0
        for name in rows[0]:
            if name in variant and name != "status":
                np.testing.assert_array_equal(variant[name].values, [float(row[name] or "nan") for row in rows], name)
                compared += 1
        self.assertGreater(compared, 15)
        missing = [name for name in rows[0] if name not in variant and any(row[name] for row in rows)]
        self.assertEqual(missing, ["refined"], "every column of the table is there")
        best = max(rows, key=lambda row: float(row["life_h"]))
        self.assertEqual((float(variant.peak_speed_rpm), float(variant.peak_life_h)), (float(best["input_speed_rpm"]), float(best["life_h"])))

    def test_one_json_object(self):
        found = json.loads(self.result.stdout)
        self.assertEqual((found["points"], found["failed_points"], len(found["variants"])), (72, 0, 6))
        self.assertEqual(found["dimensions"][-1], {"name": "input.speed", "length": 12})
        self.assertEqual(found["variants"][0]["peak_life_h"], float(self.stored.peak_life_h[0, 0]))
        self.assertEqual([p["unit"] for p in found["parameters"]], ["um", None, "rpm"])
        self.assertEqual([found["units"][key] for key in ("input.speed", "peak_speed_rpm", "peak_life_h")], ["rpm", "rpm", "h"])
        alone = run(*VARY, "--json")
        self.assertEqual(json.loads(alone.stdout), found, "without a folder the same")

    def test_files_of_the_peaks_are_those_of_a_run(self):
        numbers = sorted(int(number) for number in self.stored.peak_point.values.ravel())
        files = sorted((self.place / "grid" / "points").iterdir())
        self.assertEqual([int(file.stem) for file in files], numbers)
        last = self.stored.sel({"bearing.radial_clearance": 20.0, "film.enabled": "true"})
        folder = self.place / "run"
        subprocess.run([PROGRAM, "run", CASE, "-o", str(folder), "--quiet", "--set", "bearing.radial_clearance=0.02 mm", "--set", "film.enabled=true",
                        "--set", f"input.speed={float(last.peak_speed_rpm):g} rpm"], check=True)
        with xarray.open_dataset(files[-1]) as ours, xarray.open_dataset(folder / "points" / "00000.nc") as theirs:
            self.assertTrue(ours.equals(theirs))
        kept = {file: file.stat().st_mtime_ns for file in files}
        self.assertEqual(run("-o", self.place / "grid", *VARY, "--points", "peak", "--resume", "--quiet").returncode, 0)
        self.assertEqual({file: file.stat().st_mtime_ns for file in files}, kept)

    def test_from_python_the_same_store(self):
        vary = {"bearing.radial_clearance": ["0 um", "10 um", "0.02 mm"], "film.enabled": [False, True]}
        for name, options in {"core": {}, "threads": {"executor": "threads", "jobs": 3}}.items():
            result = orbearing.study(CASE, vary, output=self.place / name, progress=False, **options)
            self.assertEqual((self.place / name / DATASET).read_bytes(), (self.place / "grid" / DATASET).read_bytes(), name)
        self.assertTrue(result.to_xarray().identical(self.stored))
        from orbearing import _core
        self.assertTrue(orbearing.study(_core.load(CASE), vary, progress=False).to_xarray().identical(self.stored))
        with self.assertRaises(ValueError):
            orbearing.study(CASE, vary, executor="processes")

    def test_rows_of_a_table(self):
        (self.place / "rows.csv").write_text("bearing.rollers, bearing.roller_diameter (mm)\n15, 5.24\n14, 5.5\n")
        result = run("--table", self.place / "rows.csv", "--vary", "bearing.radial_clearance=[0 um]", "--json")
        found = json.loads(result.stdout)
        self.assertEqual([(v["bearing.rollers"], v["bearing.roller_diameter"]) for v in found["variants"]], [(15.0, 5.24), (14.0, 5.5)])
        self.assertEqual(found["variants"][0]["peak_life_h"], float(self.stored.peak_life_h[0, 0]))

    def test_tables_that_are_none_are_refused_with_their_place(self):
        head = "bearing.radial_clearance (um),input.speed (rpm)\n"
        for content, pattern in ((head + "10,5,6000\n", r"rows\.csv:2:6: found 3 values \(a decimal comma"),
                                 (head + "10.5,6000,7.5\n", r"rows\.csv:2:11: found 3 values; required: 2"),
                                 (head + "10\n", r"rows\.csv:2:1: found 1 values; required: 2"),
                                 ("token=hunter2\n1\n", r"rows\.csv:1:1: found a first line that names no paths"),
                                 ("bearing.rollers;input.speed\n1;2\n", r"semicolons")):
            (self.place / "rows.csv").write_text(content, encoding="utf-8")
            result = run("--table", self.place / "rows.csv", "--json")
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertRegex(result.stderr, pattern)
            self.assertNotIn("hunter2", result.stderr)
        (self.place / "rows.csv").write_bytes("bearing.rollers,input.speed (rpm)\n".encode("utf-16"))
        self.assertRegex(run("--table", self.place / "rows.csv", "--json").stderr, r"rows\.csv:1:1: found a file in UTF-16")
        (self.place / "rows.csv").write_bytes(b"bearing.rollers,input.speed (rpm)\n15,6000\xff\n")
        self.assertRegex(run("--table", self.place / "rows.csv", "--json").stderr, r"rows\.csv:2:8: found a byte that is not UTF-8")

    def test_what_has_no_effect_on_any_point_is_refused(self):
        result = run("--vary", "input.acceleration=[0 rpm/s, 10 rpm/s]", "--json")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("input.acceleration: found a varied input that has no effect on --fidelity quasi-static; used by --fidelity dynamic; required: an input "
                      "that has an effect", result.stderr)

    def test_points_that_fail(self):
        # More and larger rollers fit each alone, not both.
        result = run("--vary", "bearing.rollers=[14, 16]", "--vary", "bearing.roller_diameter=[5.24 mm, 7.4 mm]", "--json")
        self.assertEqual(result.returncode, 1, result.stderr)
        found = json.loads(result.stdout)
        self.assertEqual([variant["failed_points"] for variant in found["variants"]], [0, 0, 0, 12])
        self.assertIsNone(found["variants"][3]["peak_life_h"])
        self.assertRegex(result.stderr, "^12 points: .*do not fit around the pitch circle")

    def test_bad_input(self):
        place = ("-o", self.place / "bad")
        for options, part in (((*place, "--vary", "bearing.radial_clearance=0 um"), "path=[value, value]"), (("--vary", "film.enabled=[true]"), "--output: missing"),
                              ((*place, "--vary", "bearing.radial_clearanc=[0 um]"), "did you mean 'bearing.radial_clearance'"),
                              ((*place, "--vary", "bearing.rollers=[15, 90]"), "90 rollers do not fit"), ((*place, "--samples", "4"), "--sampler sobol or lhs"),
                              ((*place, "--scheduler", "tcp://127.0.0.1:9", "--jobs", "2"), "--jobs: found with --scheduler"),
                              ((*place, "--set", "input.power=banana", *VARY), "input.power: 'banana'"), ((*place, "--points", "some"), "--points"),
                              (("--json", "--resume"), "--resume: found without --output")):
            with self.subTest(options):
                result = run(*options)
                self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
                self.assertIn(part, result.stderr)
        self.assertFalse((self.place / "bad").exists())

    def test_resume_of_another_study_is_refused(self):
        before = {file: file.read_bytes() for file in (self.place / "grid").rglob("*") if file.is_file()}
        for options, part in (((*VARY, "--set", "input.power=75 kW"), "resolved case"), ((*VARY[:2],), "number of points"), ((*VARY, "--fidelity", "dynamic"), "fidelity")):
            result = run("-o", self.place / "grid", *options, "--resume")
            self.assertEqual(result.returncode, 2)
            self.assertIn(part, result.stderr)
        self.assertEqual(run("-o", self.place / "grid", *VARY).returncode, 2)
        self.assertEqual(subprocess.run([PROGRAM, "sweep", CASE, "-o", str(self.place / "grid"), "--resume"], capture_output=True, check=False).returncode, 2)
        self.assertEqual({file: file.read_bytes() for file in (self.place / "grid").rglob("*") if file.is_file()}, before)


class Killed(unittest.TestCase):
    def test_killed_and_gone_on_with(self):
        moments = random.Random(SEED)
        with tempfile.TemporaryDirectory() as name:
            place = pathlib.Path(name)
            begin = time.monotonic()
            self.assertEqual(program.run("study", CASE, "-o", place / "whole", *MANY, "--quiet").returncode, 0)
            seconds = time.monotonic() - begin
            whole = (place / "whole" / DATASET).read_bytes()
            kills = kept = rounds = 0
            folder = place / "killed"
            while kills < KILLS:
                process = subprocess.Popen(call("-o", folder, *MANY, "--quiet", "--resume"), start_new_session=True)
                try:
                    process.wait(moments.uniform(0.2, 1.5) * seconds)
                    self.assertEqual((folder / DATASET).read_bytes(), whole, f"SEED={SEED}")
                    rounds += 1
                    folder = place / f"killed{rounds}"
                except subprocess.TimeoutExpired:
                    os.killpg(process.pid, 9)
                    process.wait()
                    kills += 1
                    kept += self.finished(folder) > 0
            self.assertEqual(run("-o", folder, *MANY, "--quiet", "--resume").returncode, 0)
            self.assertEqual(finished_counts(folder).tolist(), [1] * 3072)
            self.assertEqual((folder / DATASET).read_bytes(), whole, f"SEED={SEED}")
            print(f"{kills} kills, {kept} of them among finished points, SEED={SEED}", file=sys.stderr)

    def test_interrupted(self):
        for wish in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(wish), tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name) / "stopped"
                process = subprocess.Popen(call("-o", folder, *MANY[:-1], "1024"), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True)
                while process.poll() is None and not self.finished(folder):
                    time.sleep(0.05)
                process.send_signal(wish)
                self.assertIn("study: interrupted; what is done stays", process.communicate(timeout=300)[1])
                self.assertEqual(process.returncode, 1)
                part = orbearing.open_study(folder)
                self.assertTrue(0 < part.missing < part.points)

    @staticmethod
    def finished(folder):
        """Points that stand in the folder; a kill may come before its first record is whole."""
        try:
            counts = finished_counts(folder)
        except (ValueError, IndexError):
            return 0
        assert counts.max() <= 1, "a point stands in the journal twice"
        return counts.sum()


if __name__ == "__main__":
    unittest.main(verbosity=2)
