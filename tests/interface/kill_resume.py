#!/usr/bin/env python3
"""A sweep killed at random moments and resumed, run on one or two threads, or merged from shards gives the same table.

KILLS (default 3) sets how many times it is killed, SEED the moments.
"""

import os
import random
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from sweep_runs import FINE, PROGRAM, manifest_points, point_files, run, sweep, sweep_call, table

KILLS = int(os.environ.get("KILLS", "3"))
SEED = int(os.environ.get("SEED", str(time.time_ns() % 1_000_000)))


class FineSweep(unittest.TestCase):
    """Points enough that a kill falls among them."""

    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.place.cleanup)
        cls.undisturbed = Path(cls.place.name) / "undisturbed"
        start = time.monotonic()
        result = sweep(cls.undisturbed, grid=FINE)
        cls.seconds = time.monotonic() - start
        assert result.returncode == 0, result.stderr

    def folder(self, name):
        return Path(self.place.name) / name

    def kill_once(self, folder, seconds):
        """Goes on with the sweep for some seconds; True where the kill came before its end."""
        process = subprocess.Popen(sweep_call(folder, "--resume", grid=FINE), stdout=subprocess.DEVNULL)
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.kill()
        return process.wait() != 0

    def check_nothing_lost(self, folder, before):
        after = point_files(folder)
        self.assertEqual({point: after.get(point) for point in before}, before, "a finished point was lost or repeated")
        points = manifest_points(folder)
        self.assertEqual(len(points), len(set(points)), "a point stands in the manifest twice")

    def test_kills(self):
        moments = random.Random(SEED)
        kills = kept = rounds = 0
        folder = self.folder("killed")
        while kills < KILLS:
            before = point_files(folder)
            if self.kill_once(folder, moments.uniform(0.0, 2.0 * self.seconds / (KILLS + 1))):
                kills += 1
                kept += bool(before)
            else:
                self.assertEqual(table(folder), table(self.undisturbed), f"SEED={SEED}")
                rounds += 1
                folder = self.folder(f"killed{rounds}")
                continue
            self.check_nothing_lost(folder, before)
        before = point_files(folder)
        result = sweep(folder, "--resume", grid=FINE)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.check_nothing_lost(folder, before)
        self.assertEqual(table(folder), table(self.undisturbed), f"SEED={SEED}")
        self.assertTrue(kept or before, f"no kill came after a finished point, SEED={SEED}")
        print(f"{kills} kills, {len(before)} of {len(point_files(folder))} points kept by the last, SEED={SEED}")

    def test_threads(self):
        for jobs in ("1", "2"):
            result = sweep(self.folder(f"jobs{jobs}"), "--jobs", jobs, grid=FINE)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(table(self.folder(f"jobs{jobs}")), table(self.undisturbed), f"--jobs {jobs}")

    def test_shards(self):
        shards = [self.folder("shard1"), self.folder("shard2")]
        for index, shard in enumerate(shards, start=1):
            self.assertEqual(sweep(shard, "--shard", f"{index}/2", grid=FINE).returncode, 0)
        result = run([PROGRAM, "merge", *map(str, shards), "-o", str(self.folder("merged")), "--quiet"])
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(table(self.folder("merged")), table(self.undisturbed))


if __name__ == "__main__":
    unittest.main()
