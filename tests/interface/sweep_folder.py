#!/usr/bin/env python3
"""Where a sweep and a merge may write: exit 2 with place and remedy, and nothing touched, where they may not."""

import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from sweep_runs import CASE, COARSE, FINE, PROGRAM, WAIT, manifest_points, run, snapshot, sweep, sweep_call, table


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

    def test_damaged_manifest_is_named_by_line_and_computed_again(self):
        """A changed digit, or a line that is none of ours."""
        finished = self.finished()
        whole, file = table(finished), finished / "manifest.jsonl"
        lines = file.read_text().splitlines(keepends=True)
        changed = lines[5].replace('"life_h":', '"life_h":1', 1)
        file.write_text("".join([lines[0], "nonsense\n", *lines[2:5], changed, *lines[6:]]))
        result = run([part for part in sweep_call(finished, "--resume") if part != "--quiet"])
        self.assertEqual(result.returncode, 0, result.stderr)
        for line in (2, 6):
            self.assertIn(f"manifest.jsonl:{line}:1: differs from what its sweep wrote; its point is computed again", result.stderr)
        self.assertEqual(table(finished), whole)
        self.assertNotIn("differs", run([part for part in sweep_call(finished, "--resume") if part != "--quiet"]).stderr)

    def test_changed_digit_of_a_shard_is_not_merged(self):
        first, second = self.finished("s1", "--shard", "1/2"), self.finished("s2", "--shard", "2/2")
        file = first / "manifest.jsonl"
        file.write_text(file.read_text().replace('"life_h":', '"life_h":1', 1))
        self.expect_refused(self.merge(first, second), "manifest.jsonl:2:1", "--resume")
        self.assertFalse((self.place / "merged").exists())

    def test_links_are_not_written_through(self):
        finished = self.finished()
        (finished / "points" / "00000.nc").unlink()
        (finished / "points").rename(self.place / "elsewhere")
        (finished / "points").symlink_to(self.place / "elsewhere")
        before = snapshot(self.place)
        self.expect_refused(sweep(finished, "--resume"), "found a link to")
        self.assertEqual(snapshot(self.place), before)

    def test_shards_of_the_grid_alone_are_merged_without_more(self):
        shards = [self.finished(f"s{i}", "--shard", f"{i}/2", "--grid-only") for i in (1, 2)]
        self.assertEqual(self.merge(*shards).returncode, 0)
        self.assertEqual(table(self.place / "merged"), table(self.finished("grid", "--grid-only")))
        self.assertNotIn(b",true,", table(self.place / "merged"))

    def test_bad_shards(self):
        for shard in ("0/2", "3/2", "2", "a/b", "1/0", "1/99999999999"):
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

    def test_damaged_points_are_reported_and_computed_again(self):
        finished = self.finished()
        before = snapshot(finished)
        points = finished / "points"
        whole = (points / "00004.nc").read_bytes()
        flipped = bytearray(whole)
        flipped[len(whole) // 2] ^= 1
        damages = {"00000.nc": None, "00003.nc": b"", "00004.nc": whole[:-1], "00007.nc": whole, "00009.nc": bytes(flipped)}
        for name, content in damages.items():
            (points / name).unlink()
            if content is not None:
                (points / name).write_bytes(content)
        # --quiet stands in sweep_call(); what was wrong is reported without it.
        result = run([part for part in sweep_call(finished, "--resume") if part != "--quiet"])
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in damages:
            self.assertIn(f"points/{name}", result.stderr)
        self.assertEqual(result.stderr.count("computed again"), len(damages))
        after = snapshot(finished)
        for path in before:
            if not path.endswith("manifest.jsonl"):
                self.assertEqual(after[path], before[path], path)
        self.assertEqual(run(sweep_call(finished, "--resume")).stderr, "")

    def test_merge_names_what_resume_would_compute_again(self):
        first, second = self.finished("s1", "--shard", "1/2"), self.finished("s2", "--shard", "2/2")
        file = next((first / "points").iterdir())
        content = bytearray(file.read_bytes())
        content[len(content) // 2] ^= 1
        file.write_bytes(content)
        self.expect_refused(self.merge(first, second), str(file), "--resume")
        self.assertEqual(sweep(first, "--shard", "1/2", "--resume").returncode, 0)
        self.assertEqual(self.merge(first, second).returncode, 0)
        self.finished("whole")
        self.assertEqual(table(self.place / "merged"), table(self.place / "whole"))

    def test_json_alone_writes_nothing(self):
        finished = self.finished()
        with_folder = run([*sweep_call(finished, "--resume"), "--json"])
        alone = subprocess.run([PROGRAM, "sweep", str(CASE), "--set", COARSE, "--json"], cwd=self.place, capture_output=True,
                               text=True, timeout=WAIT, check=False)
        self.assertEqual((alone.returncode, alone.stderr), (0, ""))
        self.assertEqual(alone.stdout, with_folder.stdout)
        self.assertEqual([path.name for path in self.place.iterdir()], ["finished"])

    def test_threads_are_bounded_by_the_machine(self):
        """Threads beyond the processors cost memory and give nothing."""
        megabytes = 500 + 80 * len(os.sched_getaffinity(0))  # [MB]  a stack and a heap for each thread
        limit = f"ulimit -v {1024 * megabytes}; exec \"$@\""
        for name, call in (("sweep", sweep_call(self.place / "sweep", "--jobs", "4096")),
                           ("crown", [PROGRAM, "crown", str(CASE), "--json", "--jobs", "4096", "--starts", "1", "--drops",
                                      "0 um, 2 um", "--tilts", "0 mrad"])):
            with self.subTest(name):
                result = run(["bash", "-c", limit, name, *call])
                self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_file_size_limit_keeps_what_is_done(self):
        folder = self.place / "full"
        result = run(["bash", "-c", 'ulimit -f 1; exec "$@"', "sweep", *sweep_call(folder)])
        self.assertEqual(result.returncode, 1)
        self.assertIn("--resume", result.stderr)
        self.assertEqual([path for path in folder.rglob("*.tmp")], [])
        self.assertEqual(run(sweep_call(folder, "--resume")).returncode, 0)

    def test_grid_is_that_of_the_case(self):
        rows = table(self.finished("finished", "--grid-only")).decode().splitlines()
        self.assertEqual(len(rows), 24, COARSE)
        self.assertEqual([row.split(",")[0] for row in rows[1:4]], ["1000", "1500", "2000"])


if __name__ == "__main__":
    unittest.main()
