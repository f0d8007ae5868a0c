#!/usr/bin/env python3
"""Where a sweep and a merge may write: exit 2 with place and remedy, and nothing touched, where they may not."""

import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from sweep_runs import COARSE, FINE, PROGRAM, manifest_points, run, snapshot, sweep, sweep_call, table


class SweepFolder(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def expect_refused(self, result, *parts):
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)

    def finished(self, name="finished", *options):
        result = sweep(self.place / name, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return self.place / name

    def merge(self, *folders):
        return run([PROGRAM, "merge", *map(str, folders), "-o", str(self.place / "merged"), "--quiet"])

    def test_results_and_other_files_are_not_written_over(self):
        finished = self.finished()
        other = self.place / "other"
        other.mkdir()
        (other / "notes.txt").write_text("mine")
        before = snapshot(self.place)
        self.expect_refused(sweep(finished), str(finished), "--resume")
        self.expect_refused(sweep(other), str(other), "notes.txt")
        self.expect_refused(sweep(other, "--resume"), str(other), "notes.txt")
        self.assertEqual(snapshot(self.place), before)

    def test_another_case_is_not_resumed(self):
        finished = self.finished()
        before = snapshot(self.place)
        result = sweep(finished, "--resume", "--set", "input.power=75 kW")
        self.expect_refused(result, str(finished), "--resume", "required")
        self.assertEqual(snapshot(self.place), before)

    def test_resume_into_a_missing_or_empty_folder_starts_afresh(self):
        (self.place / "empty").mkdir()
        for folder in (self.place / "missing" / "below", self.place / "empty"):
            self.assertEqual(sweep(folder, "--resume").returncode, 0)
            self.assertTrue(table(folder))

    def test_folder_that_cannot_be_made(self):
        (self.place / "file").write_text("text")
        self.expect_refused(sweep(self.place / "file"), str(self.place / "file"))
        self.expect_refused(sweep(self.place / "file" / "below"), str(self.place / "file"))
        self.expect_refused(sweep("/proc/results"), "/proc/results")

    def test_damaged_manifest_is_named_by_line(self):
        finished = self.finished()
        lines = (finished / "manifest.jsonl").read_text().splitlines(keepends=True)
        (finished / "manifest.jsonl").write_text("".join([lines[0], "nonsense\n", *lines[2:]]))
        self.expect_refused(sweep(finished, "--resume"), "manifest.jsonl:2:1")

    def test_bad_shards(self):
        for shard in ("0/2", "3/2", "2", "a/b", "1/0"):
            self.expect_refused(sweep(self.place / "d", "--shard", shard), "--shard", "i/n")
        self.assertFalse((self.place / "d").exists())

    def test_merge_refuses(self):
        first, second = self.finished("s1", "--shard", "1/3"), self.finished("s2", "--shard", "2/3")
        third = self.finished("s3", "--shard", "3/3", "--set", "input.power=75 kW")
        self.expect_refused(self.merge(first, second), "shard 3/3 is missing")
        self.expect_refused(self.merge(first, second, second), "2/3", "once")
        self.expect_refused(self.merge(first, second, third), str(third), "hash")
        self.expect_refused(self.merge(self.place), "manifest.jsonl")
        self.assertFalse((self.place / "merged").exists())

    def test_interrupt_keeps_what_is_done(self):
        folder = self.place / "interrupted"
        process = subprocess.Popen(sweep_call(folder, grid=FINE), stderr=subprocess.PIPE, text=True)
        while process.poll() is None and not manifest_points(folder):
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        message = process.communicate()[1]
        self.assertEqual(process.returncode, 1)
        self.assertIn("--resume", message)
        self.assertTrue(manifest_points(folder))

    def test_grid_is_that_of_the_case(self):
        rows = table(self.finished()).decode().splitlines()
        self.assertEqual(len(rows), 24, COARSE)
        self.assertEqual([row.split(",")[0] for row in rows[1:4]], ["1000", "1500", "2000"])


if __name__ == "__main__":
    unittest.main()
