#!/usr/bin/env python3
"""Branches, slip map and animations of the report: from made-up results whose answer is known.

Exit code 77 (skipped) where matplotlib or netCDF4 is missing.
"""

import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import matplotlib  # noqa: F401
    import netCDF4  # noqa: F401
    import numpy as np
except ImportError:
    print("skipped: matplotlib, numpy or netCDF4 is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import report_dynamic_fixture as dynamic  # noqa: E402
import report_fixture as fixture  # noqa: E402
from orbearing import animation, style  # noqa: E402
from orbearing import report as command  # noqa: E402
from orbearing.figures import branches, slip_map  # noqa: E402
from orbearing.result_folder import Report, read_report  # noqa: E402
from report_test import outline, run_command  # noqa: E402

DRIFT = 0.002
POWERS = [50.0, 150.0, 300.0]  # [kW]
MOST_BYTES = 2_000_000
PRINTED = {"angle": 1e-4, "inner": 0.1, "outer": 0.1}  # the pages round to this


def rows(worth=1.0, apart=()):
    """Points of a branch; at the speeds `apart` its loads are larger by 1 %."""
    points = dynamic.make_report()["points"]
    for point in points:
        factor = 1.01 if point["input_speed_rpm"] in apart else worth
        point.update({name: factor * point[name] for name in branches.LOADS}, steady=1)
    return points


def branches_block(*runs, slice_=None):
    content = {"branches": {"load_drift": DRIFT, "runs": [{"name": name, "points": points} for name, points in runs]}, "slice": slice_}
    with style.context():
        return branches.block(Report(content))


class Branches(unittest.TestCase):
    def test_states_apart_are_named_with_their_speeds(self):
        block = branches_block(("up", rows()), ("down", rows(apart=(7000, 8000))))
        self.assertIn("coexisting states at 7,000, 8,000 rpm", block.caption)
        self.assertEqual([row[0] for row in block.summary.rows if row[-1] == "two states"], [7000, 8000])
        self.assertEqual(len(block.pictures), 1)

    def test_difference_below_the_drift_is_one_state(self):
        block = branches_block(("up", rows()), ("down", rows(worth=1 + 0.9 * DRIFT)))
        self.assertIn("no coexisting states", block.caption)
        self.assertIn("At none of the 12 speeds", block.caption)

    def test_single_branch_says_what_is_missing(self):
        block = branches_block(("up", rows()))
        self.assertIn("--with", block.caption)
        self.assertIsNone(block.summary)

    def test_unsteady_points_are_named(self):
        down = rows()
        down[3]["steady"] = 0
        self.assertIn("4,000 rpm (down)", branches_block(("up", rows()), ("down", down)).caption)

    def test_failed_points_are_left_out(self):
        down = rows(apart=(7000,))
        down[6] = {"input_speed_rpm": 7000, "status": "no", **dict.fromkeys(branches.LOADS)}
        block = branches_block(("up", rows()), ("down", down))
        self.assertIn("At none of the 11 speeds", block.caption)

    def test_only_the_shown_line_of_speeds_is_compared(self):
        up = [{**point, "input.power_kW": power} for power in POWERS for point in rows()]
        down = [{**point, "input.power_kW": power} for power in POWERS for point in rows(apart=(7000,) if power == 50.0 else ())]
        self.assertIn("At none of the 12 speeds", branches_block(("up", up), ("down", down), slice_={"input.power_kW": 150.0}).caption)
        self.assertIn("coexisting states at 7,000 rpm", branches_block(("up", up), ("down", down), slice_={"input.power_kW": 50.0}).caption)

    def test_nothing_usable_is_said(self):
        self.assertTrue(branches_block(("up", [{}]), ("down", None)).missing)


def map_report():
    """Roller slip grows with speed and falls with power; the cage runs ahead at the highest power."""
    content = dynamic.make_report()
    points = []
    for speed in fixture.GRID[::3]:
        for power in POWERS:
            points.append({**fixture.point(speed), "input.power_kW": power, "roller_slip": 1e-5 * speed / power,
                           "cage_slip": 1e-3 * (200.0 - power) / 100.0, "life_h": 1e6 / power})
    axes = [{"column": "input.power_kW", "units": "kW", "meaning": "power that enters"}]
    return {**content, "points": points, "axes": axes, "slice": {"input.power_kW": 150.0}}


class SlipMap(unittest.TestCase):
    def block(self, content):
        with style.context():
            return slip_map.block(Report(content))

    def test_maps_of_cage_and_rollers_with_limit_and_trend(self):
        block = self.block(map_report())
        self.assertEqual(len(block.pictures), 2)
        self.assertIn("input.power (kW)", block.caption)
        steps = {row[:2]: row[2] for row in block.summary.rows}
        self.assertEqual(steps["slip of the rollers", "input speed"], "9 of 9 steps")
        self.assertEqual(steps["slip of the rollers", "input.power (kW)"], "0 of 8 steps")
        # A cage that stands with the pin slips by all; one that turns with the bore runs ahead.
        ahead = 100 * (1 - dynamic.ROLLING["outer_race"] / dynamic.ROLLING["cage"])
        self.assertIn(f"{ahead:.1f} %".replace("-", "\u2212"), block.caption)
        self.assertIn("100 %", block.caption)

    def test_values_stand_at_their_place(self):
        content = map_report()
        grid = slip_map._grid(content["points"], "input.power_kW", np.array(fixture.GRID[::3]), np.array(POWERS), "roller_slip")
        np.testing.assert_allclose(grid, 1e-5 * np.array(fixture.GRID[::3])[None, :] / np.array(POWERS)[:, None])

    def test_one_axis_gives_words(self):
        content = map_report()
        content["points"] = [p for p in content["points"] if p["input.power_kW"] == 50.0]
        self.assertIn("no second axis", self.block(content).missing)

    def test_failed_points_leave_holes(self):
        content = map_report()
        content["points"][4].update(cage_slip=None, roller_slip=None, planet_load_N=None)
        self.assertEqual(len(self.block(content).pictures), 2)

    def test_plots_over_speed_show_one_line(self):
        line = Report(map_report()).along_speed()
        self.assertEqual([p["input.power_kW"] for p in line.records("points")], [150.0] * len(fixture.GRID[::3]))
        self.assertEqual(line.record("peak")["life_h"], 1e6 / 150.0)


class Animation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = Path(place.name)
        dynamic.write_results(cls.folder, dynamic.make_report())
        cls.report = read_report(cls.folder)
        cls.pages = dict(animation.pages(cls.report))
        cls.page = cls.pages["animations/6000rpm.html"]
        cls.data = json.loads(re.search(r'id="data">(.*?)</script>', cls.page, re.S).group(1))

    def test_a_page_for_each_point_below_two_megabytes(self):
        self.assertEqual(sorted(self.pages), sorted(f"animations/{speed}rpm.html" for speed in fixture.GRID))
        self.assertLess(max(len(text.encode()) for text in self.pages.values()), MOST_BYTES)

    def test_page_is_sound_and_needs_nothing_from_outside(self):
        found = outline(self.page)
        self.assertEqual((found.faults, found.open, found.references), ([], [], []))
        self.assertNotRegex(self.page, r"https?:|@import|@font-face")
        self.assertEqual(len(found.identifiers), len(set(found.identifiers)))
        used = set(re.findall(r'byId\("([^"]+)"\)', self.page))
        self.assertEqual(used - set(found.identifiers), set())

    def test_it_plays_what_the_file_holds(self):
        stored = dynamic.variables(6000)
        for name, digits in PRINTED.items():
            series = {"angle": "roller_angle", "inner": "roller_inner_load", "outer": "roller_outer_load"}[name]
            expected = np.unwrap(stored[series][2], axis=1) if name == "angle" else stored[series][2]
            np.testing.assert_allclose(np.array(self.data[name]), expected, rtol=0, atol=0.51 * digits)
        np.testing.assert_allclose(np.hypot(self.data["cageX"], self.data["cageY"]), 1e6 * dynamic.CLEARANCE / 2, atol=0.01)
        self.assertAlmostEqual(self.data["clearance"], 1e6 * dynamic.CLEARANCE)

    def test_sense_of_rotation_and_time(self):
        self.assertLess(self.data["outerSpeed"], 0.0)  # against the carrier
        self.assertLess(self.data["angle"][0][-1], self.data["angle"][0][0])
        turns = (self.data["turned"][0][-1] - self.data["turned"][0][0]) / (2 * np.pi)
        expected = (1 - dynamic.ROLLER_SLIP) * dynamic.ROLLING["roller_spin"] / 0.6  # spins in one turn of the cage
        self.assertAlmostEqual(turns, expected, delta=1e-3 * abs(expected))

    def test_exaggeration_is_stated_and_stays_small(self):
        shift = 1e6 * dynamic.CLEARANCE / 2
        factor = self.data["factor"]
        self.assertIn(f"drawn {factor} times", self.page)
        room = animation.SHOWN_SHIFT * 47.0 * 1e3
        self.assertLessEqual(factor * shift, room)
        self.assertGreater(2.5 * factor * shift, room)
        self.assertEqual(animation.exaggeration(1e9, 47.0), 1)

    def test_rotation_of_a_speed_that_rises_evenly(self):
        time = np.linspace(0.0, 2.0, 5)
        np.testing.assert_allclose(animation.rotation(time, 3.0 * time[None, :])[0], 1.5 * time**2, rtol=1e-12)

    def test_many_rollers_stay_below_the_limit(self):
        rollers, instants = 120, 4000
        full = np.random.default_rng(1).uniform(0.0, 1000.0, (rollers, instants))
        values = {"time": np.arange(instants) * 1e-5, "cage_position": full[:2] * 1e-6, "cage_angle": full[0], "cage_speed": full[0],
                  "roller_angle": full, "roller_inner_load": full, "roller_outer_load": full, "roller_spin": full}
        content = animation.content_of(self.report, animation.PointFile(values), 6000)
        self.assertLess(len(animation.page(self.report, 6000, content).encode()), MOST_BYTES)

    def test_missing_motion_gives_no_page(self):
        point = animation.read_point(self.report, 6000)
        for name in ("time", "cage_angle", "roller_spin", "roller_inner_load"):
            values = {key: value for key, value in point.values.items() if key != name}
            self.assertIsNone(animation.content_of(self.report, type(point)(values), 6000), name)

    def test_text_of_the_case_stays_text(self):
        content = {**self.report.content, "case": {"name": "</script><script>alert(1)</script>"}}
        self.assertNotIn("<script>alert", animation.page(Report(content), 6000, animation.content_of(
            self.report, animation.read_point(self.report, 6000), 6000)))

    def test_command_writes_them_and_the_report_names_them(self):
        result = run_command(self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        page = (self.folder / "report.html").read_text(encoding="utf-8")
        for name, text in self.pages.items():
            self.assertEqual((self.folder / name).read_text(encoding="utf-8"), text)
            self.assertIn(f'href="{name}"', page)


class WholePage(unittest.TestCase):
    def test_map_and_branches_stand_on_the_page_of_their_results(self):
        content = map_report()
        content["branches"] = {"load_drift": DRIFT, "runs": [{"name": "up", "points": content["points"]}]}
        with tempfile.TemporaryDirectory() as folder:
            fixture.write_report(folder, content)
            text = command.build(Path(folder))
        for slug in ("slip-map", "branches"):
            self.assertEqual(text.count(f'<section id="{slug}">'), 1)
        self.assertIn("with input.power_kW = 150", re.search("<h1>(.*?)</h1>", text).group(1))
        self.assertIn("-o again --fidelity dynamic --continue up", text)
        self.assertEqual(outline(text).faults, [])


if __name__ == "__main__":
    unittest.main()
