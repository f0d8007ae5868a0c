#!/usr/bin/env python3
"""The peak that a sweep prints is a point that was run, and no neighbour lives much longer; a faster form of tools/peak_check.

Also: what --grid-only leaves out, what is said of peaks at the ends of the range, and what resonances stand in the rows.
"""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import program
from sweep_runs import CASE, PROGRAM, ROOT, run

SHORT = ("--set", "simulation.observed_revolutions=2")  # motion: what is tested is the search, not the means


def result_of(*options, command="sweep", case=CASE):
    with tempfile.TemporaryDirectory() as folder:
        done = run([PROGRAM, command, str(case), "--json", "-o", f"{folder}/d", *options])
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def warnings_of_ends(result):
    return [text for text in result["warnings"] if text.startswith("sweep.input.speed: ")]


class PeakFound(unittest.TestCase):
    def test_quasi_static_peaks_hold_what_the_check_requires(self):
        for case in ("reducer_150kW", "coupling_set_150kW", "three_sets_150kW"):
            check = [sys.executable, str(ROOT / "tools" / "peak_check"), "--fidelity", "quasi-static", str(ROOT / "cases" / case)]
            done = subprocess.run(check, capture_output=True, text=True, check=False, env={**os.environ, "ORBEARING": PROGRAM})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    @unittest.skipIf(program.LEFT_TO_FULL, "a search in motion: tools/test --full, or by hand")
    def test_in_motion_it_is_found_beside_the_dip(self):
        around = ("--set", "sweep.input.speed={from: 5000 rpm, to: 7000 rpm, step: 500 rpm}")
        sweep = result_of("--fidelity", "dynamic", *SHORT, *around)
        peak, points = sweep["peak"], sweep["points"]
        best = max(points, key=lambda p: p["life_h"])
        self.assertEqual((best["input_speed_rpm"], best["life_h"]), (peak["refined_speed_rpm"], peak["refined_life_h"]))
        self.assertGreater(peak["refined_life_h"], peak["life_h"])
        dip = [p["life_h"] for p in points if 5650 <= p["input_speed_rpm"] <= 5850]
        self.assertTrue(dip and min(dip) < 0.93 * peak["refined_life_h"], "the dip that the grid steps over is looked into")
        low, high = peak["between_rpm"]
        self.assertLessEqual(high - low, 2 * 11)
        alone = result_of("--fidelity", "dynamic", *SHORT, "--set", f"input.speed={best['input_speed_rpm']!r} rpm", command="run")
        self.assertEqual({**alone["points"][0], "refined": best["refined"]}, best, "life, loads and nearest resonance are those of the sweep")
        speeds = [p["input_speed_rpm"] for p in points]
        self.assertEqual(speeds, sorted(speeds))

    def test_rows_in_motion_name_a_resonance_and_others_do_not(self):
        grid = ("--grid-only", "--set", "sweep.input.speed=[4000 rpm, 6000 rpm]")
        near = result_of("--fidelity", "dynamic", *SHORT, *grid)["points"][1]
        # 6000 rpm: mesh frequency 2520 Hz, whose second harmonic excites planet modes (2 x 37 teeth modulo 4 planets is 2).
        self.assertEqual((near["resonance_kind"], near["resonance_mode"], near["resonance_harmonic"]), ("planet", "P1", 2))
        mesh_frequency = near["resonance_frequency_Hz"] / 2 / near["resonance_speed_rpm"] * 6000
        self.assertAlmostEqual(mesh_frequency, 79 * 6000 / 60 * 37 / 116, delta=1e-3 * mesh_frequency)  # lines between speeds a fifth apart
        still = result_of("--fidelity", "dynamic", *SHORT, *grid, "--set", "gearset.mesh_variation=false")["points"][1]
        self.assertNotIn("resonance_mode", still)
        self.assertNotIn("resonance_mode", result_of(*grid)["points"][1])

    def test_grid_only_leaves_the_added_points_out(self):
        grid, all_points = result_of("--grid-only"), result_of()
        self.assertEqual([p["refined"] for p in grid["points"]], [False] * 12)
        self.assertIsNone(grid["peak"]["refined_life_h"])
        self.assertEqual([p for p in all_points["points"] if not p["refined"]], grid["points"])
        self.assertTrue(any(p["refined"] for p in all_points["points"]))

    def test_one_speed_is_not_refined(self):
        result = result_of("--set", "sweep.input.speed=[6000 rpm]")
        self.assertEqual(len(result["points"]), 1)
        self.assertIsNone(result["peak"]["refined_speed_rpm"])

    def test_warnings_tell_the_ends_apart(self):
        falling = result_of("--set", "bearing.radial_clearance=-60 um")
        self.assertEqual(falling["peak"]["refined_speed_rpm"], 1000)
        self.assertEqual([("decreases" in text, "1000 rpm" in text, "increases" in text) for text in warnings_of_ends(falling)],
                         [(True, True, False)])
        rising = result_of("--set", "sweep.input.speed={from: 1000 rpm, to: 5000 rpm, step: 1000 rpm}")
        self.assertEqual(rising["peak"]["refined_speed_rpm"], 5000)
        self.assertEqual([("decreases" in text, "5000 rpm" in text, "increases" in text) for text in warnings_of_ends(rising)],
                         [(False, True, True)])
        self.assertEqual(warnings_of_ends(result_of()), [])

    def test_second_axis_is_refined_on_the_best_line_and_says_so(self):
        result = result_of("--set", "sweep.bearing.radial_clearance=[0 um, 37 um]")
        added = {p["bearing.radial_clearance_um"] for p in result["points"] if p["refined"]}
        self.assertEqual(added, {0})
        self.assertTrue(any("bearing.radial_clearance_um = 0" in text for text in result["warnings"]))

    def test_table_and_merged_shards(self):
        with tempfile.TemporaryDirectory() as place:
            place = Path(place)
            for name, options in (("whole", ()), ("s1", ("--shard", "1/2")), ("s2", ("--shard", "2/2"))):
                self.assertEqual(run([PROGRAM, "sweep", str(CASE), "--quiet", "-o", str(place / name), *options]).returncode, 0)
            merge = [PROGRAM, "merge", str(place / "s1"), str(place / "s2"), "--quiet"]
            self.assertEqual(run([*merge, "-o", str(place / "both"), "--jobs", "1"]).returncode, 0)
            self.assertEqual(run([*merge, "-o", str(place / "grid"), "--grid-only"]).returncode, 0)
            tables = {name: (place / name / "sweep.csv").read_bytes() for name in ("whole", "both")}
            self.assertEqual(tables["whole"], tables["both"])
            with open(place / "grid" / "sweep.csv", encoding="utf-8", newline="") as file:
                self.assertEqual([row["refined"] for row in csv.DictReader(file)], ["false"] * 12)


if __name__ == "__main__":
    unittest.main()
