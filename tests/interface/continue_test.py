#!/usr/bin/env python3
"""sweep --continue from outside: cut and resumed it equals the undisturbed run; what it refuses; both branches in one report."""

import json
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from program import BRIEF_GEARS
from sweep_runs import CASE, PROGRAM, manifest_points, run, snapshot, table

SPEEDS = "sweep.input.speed={from: 5000 rpm, to: 9000 rpm, step: 1000 rpm}"
# Short runs under steady meshes: what is tested is the order and the start of the points, not the steady state.
CHEAP = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2", "simulation.length_error=2e-6 mm",
         "gearset.mesh_variation=false", *BRIEF_GEARS)


def call(folder, *options, grid=SPEEDS):
    settings = [part for setting in (grid, *CHEAP) for part in ("--set", setting)]
    return [PROGRAM, "sweep", str(CASE), *settings, "--fidelity", "dynamic", "--quiet", "-o", str(folder), *options]


def sweep(folder, *options, grid=SPEEDS):
    return run(call(folder, *options, grid=grid))


def rows(folder):
    lines = (Path(folder) / "manifest.jsonl").read_text().splitlines()[1:]
    return {entry["point"]: entry["row"] for entry in map(json.loads, lines)}


class Continued(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.place = Path(place.name)
        for name, options in (("up", ("--continue", "up")), ("down", ("--continue", "down")), ("own", ("--grid-only",))):
            result = sweep(cls.place / name, *options)
            assert result.returncode == 0, result.stderr

    def cut(self, name, folder, kept):
        """The folder as a kill after `kept` points leaves it: lines and files of those points and a torn line."""
        shutil.copytree(self.place / name, folder)
        (folder / "sweep.csv").unlink()
        lines = (folder / "manifest.jsonl").read_bytes().splitlines(keepends=True)
        (folder / "manifest.jsonl").write_bytes(b"".join(lines[:1 + kept]) + lines[1 + kept][:20])
        for line in lines[1 + kept:]:
            (folder / json.loads(line)["file"]).unlink()

    def test_order_and_start_of_the_points(self):
        self.assertEqual(manifest_points(self.place / "up"), [0, 1, 2, 3, 4])
        self.assertEqual(manifest_points(self.place / "down"), [4, 3, 2, 1, 0])
        up, down, own = (rows(self.place / name) for name in ("up", "down", "own"))
        # The first of a path has no neighbour and starts as every point of a plain sweep does.
        self.assertEqual(up[0], own[0])
        self.assertEqual(down[4], own[4])
        for point in range(1, 5):
            self.assertNotEqual(up[point]["outer_load_rms_N"], own[point]["outer_load_rms_N"])
        for point in range(4):
            self.assertNotEqual(down[point]["outer_load_rms_N"], up[point]["outer_load_rms_N"])

    def test_cut_anywhere_and_resumed_it_is_the_undisturbed_run(self):
        for name, kept in (("up", 1), ("up", 3), ("down", 2)):
            with self.subTest(name=name, kept=kept), tempfile.TemporaryDirectory() as place:
                folder = Path(place) / "cut"
                self.cut(name, folder, kept)
                result = sweep(folder, "--continue", name, "--resume")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(table(folder), table(self.place / name))
                self.assertEqual((folder / "manifest.jsonl").read_bytes(), (self.place / name / "manifest.jsonl").read_bytes())

    def test_interrupted_and_resumed(self):
        with tempfile.TemporaryDirectory() as place:
            # On a busy machine the last point may be there before the signal of the first.
            for attempt in range(10):
                folder = Path(place) / f"interrupted {attempt}"
                process = subprocess.Popen(call(folder, "--continue", "up"), stderr=subprocess.PIPE, text=True)
                while process.poll() is None and not manifest_points(folder):
                    time.sleep(0.002)
                process.send_signal(signal.SIGINT)
                message = process.communicate()[1]
                if process.returncode != 0:
                    break
            self.assertEqual(process.returncode, 1)
            self.assertIn("--resume", message)
            self.assertLess(len(manifest_points(folder)), 5)
            self.assertEqual(sweep(folder, "--continue", "up", "--resume").returncode, 0)
            self.assertEqual(table(folder), table(self.place / "up"))

    def expect_refused(self, result, *parts):
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        for part in parts:
            self.assertIn(part, result.stderr)

    def test_another_direction_is_not_resumed(self):
        before = snapshot(self.place / "up")
        for options in (("--continue", "down"), ()):
            self.expect_refused(sweep(self.place / "up", "--resume", *options), "direction of --continue 'up' was found")
        self.expect_refused(sweep(self.place / "own", "--resume", "--continue", "up"), "'none' was found; 'up' is required")
        self.assertEqual(snapshot(self.place / "up"), before)

    def test_point_whose_file_is_another_is_computed_anew(self):
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place) / "cut"
            self.cut("up", folder, 2)
            still = Path(place) / "still"  # quasi-static points hold no state
            self.assertEqual(run([PROGRAM, "sweep", str(CASE), "--set", SPEEDS, "--quiet", "-o", str(still)]).returncode, 0)
            shutil.copy(still / "points" / "00001.nc", folder / "points" / "00001.nc")
            self.assertEqual(sweep(folder, "--continue", "up", "--resume").returncode, 0)
            self.assertEqual(table(folder), table(self.place / "up"))

    def test_usage(self):
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place) / "none"
            self.expect_refused(sweep(folder, "--continue", "up", "--shard", "1/2"), "--shard")
            self.expect_refused(sweep(folder, "--continue", "up", "--jobs", "2"), "--jobs 2")
            both = sweep(folder, "--continue", "up", "--jobs", "2", "--shard", "1/2")
            self.expect_refused(both, "--shard", "--jobs 2")
            self.expect_refused(sweep(folder, "--continue", "up", grid="sweep.input.speed=[6000 rpm]"), "input.speed", "two speeds")
            self.expect_refused(sweep(folder, "--continue", "up", "--fidelity", "quasi-static"))  # given twice
            plain = [PROGRAM, "sweep", str(CASE), "-o", str(folder), "--continue", "up"]
            self.expect_refused(run(plain), "--fidelity dynamic")
            sets = CASE.parents[1] / "three_sets_150kW" / "case.yaml"
            several = [PROGRAM, "sweep", str(sets), "-o", str(folder), "--fidelity", "dynamic", "--continue", "up"]
            self.expect_refused(run(several), "several sets", "one set")
            self.assertEqual(sweep(folder, "--continue", "sideways").returncode, 2)
            self.assertFalse(folder.exists())

    def test_one_thread_may_be_asked_for(self):
        with tempfile.TemporaryDirectory() as place:
            result = sweep(Path(place) / "one", "--continue", "up", "--jobs", "1", grid="sweep.input.speed=[5000 rpm, 6000 rpm]")
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_one_path_for_each_value_of_another_axis(self):
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place) / "grid"
            powers = ("--set", "sweep.input.power=[100 kW, 150 kW]")
            result = sweep(folder, "--continue", "up", *powers, grid="sweep.input.speed=[5000 rpm, 6000 rpm]")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(manifest_points(folder), [0, 2, 1, 3])
            up = rows(self.place / "up")
            alone = {row["input_speed_rpm"]: row for row in rows(folder).values() if row["input.power_kW"] == 150}
            for point, speed in ((0, 5000), (1, 6000)):
                self.assertEqual({key: alone[speed][key] for key in up[point]}, up[point])

    def report(self, folder, *options):
        return run([PROGRAM, "report", str(folder), "--quiet", *map(str, options)])

    def test_only_two_branches_of_one_sweep_go_together(self):
        up = self.place / "up"
        before = snapshot(self.place / "own")
        self.expect_refused(self.report(up, "--with", up), "--with", "'up' was found")
        self.expect_refused(self.report(up, "--with", self.place / "none"), "none")
        with tempfile.TemporaryDirectory() as place:
            other = Path(place) / "other"
            powers = ("--set", "input.power=100 kW")
            self.assertEqual(sweep(other, "--continue", "down", *powers, grid="sweep.input.speed=[5000 rpm, 6000 rpm]").returncode, 0)
            self.expect_refused(self.report(up, "--with", other), "hash", str(other))
        self.assertEqual(snapshot(self.place / "own"), before)

    def test_both_branches_stand_in_one_report(self):
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place) / "up"
            shutil.copytree(self.place / "up", folder)
            result = self.report(folder, "--with", self.place / "down")
            self.assertEqual(result.returncode, 0, result.stderr)
            data = json.loads((folder / "report.json").read_text(encoding="utf-8"))
            page = (folder / "report.html").read_text(encoding="utf-8")
            self.assertEqual([run_["name"] for run_ in data["branches"]["runs"]], ["up", "down"])
            self.assertEqual(data["branches"]["load_drift"], 0.002)
            self.assertEqual([len(run_["points"]) for run_ in data["branches"]["runs"]], [5, 5])
            self.assertIn('<section id="branches">', page)
            self.assertEqual(len(list((folder / "animations").glob("*.html"))), 5)


if __name__ == "__main__":
    unittest.main()
