#!/usr/bin/env python3
"""The figures of a dynamic result: there with its files, absent for a quasi-static one, in words where data are missing.

Exit code 77 (skipped) where matplotlib or netCDF4 is missing.
"""

import re
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

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

import program  # noqa: E402
import report_dynamic_fixture as dynamic  # noqa: E402
import report_fixture as fixture  # noqa: E402
from orbearing import report as command  # noqa: E402
from orbearing import effects_table, style  # noqa: E402
from orbearing.figures import DYNAMIC_BLOCKS, cage_orbit, dynamic_ablation, dynamic_polar, power_loss, slip_traces  # noqa: E402
from orbearing.page import page  # noqa: E402
from orbearing.point_file import PointFile, load_zone, one_roller, read_point  # noqa: E402
from orbearing.result_folder import read_report  # noqa: E402
from report_test import nulled, outline, poisoned, run_command  # noqa: E402

FROM_FILES = ("dynamic-polar", "roller-history", "roller-orbit", "slip-traces", "cage-orbit")
OF_ANIMATIONS = {"cage_angle"}  # variables that no figure asks for
FROM_ROWS = ("slip", "power-loss", "dynamic-ablation")
PICTURES = {"dynamic-polar": 3, "roller-history": 2, "roller-orbit": 1, "slip-traces": 1, "cage-orbit": 3, "slip": 1, "power-loss": 2,
            "dynamic-ablation": 1}
ROUND_OFF = 1e-9  # a few operations in double precision, relative


def section(text, slug):
    return re.search(rf'<section id="{slug}">.*?</section>', text, re.S).group(0)


def make_page(content=None, change=lambda name, values: values, damage=lambda folder: None):
    with tempfile.TemporaryDirectory() as folder:
        dynamic.write_results(folder, dynamic.make_report() if content is None else content, change)
        damage(Path(folder))
        return command.build(Path(folder))


def make_figures(content=None, change=lambda name, values: values, blocks=(*DYNAMIC_BLOCKS, dynamic_ablation.block),
                 damage=lambda folder: None):
    """The sections that only a dynamic result has, or some of them, without the time that the others take."""
    with tempfile.TemporaryDirectory() as folder:
        dynamic.write_results(folder, dynamic.make_report() if content is None else content, change)
        damage(Path(folder))
        report = read_report(Path(folder))
        with style.context():
            return page(report, [block(report) for block in blocks])


def peak_only():
    """One point in place of twelve, and so one picture in place of three."""
    content = dynamic.make_report()
    return {**content, "points": content["points"][5:6]}


def asked_of_files(content):
    """Block -> the names of all variables that it asks for: it cannot feel that another one is missing."""
    asked, get = {}, PointFile.get
    with tempfile.TemporaryDirectory() as folder, style.context():
        dynamic.write_results(folder, content)
        report = read_report(Path(folder))
        for block in DYNAMIC_BLOCKS[:len(FROM_FILES)]:
            names = asked[block] = set()
            with mock.patch.object(PointFile, "get", lambda point, *more: (names.update(more), get(point, *more))[1]):
                block(report)
    return asked


class WholeResult(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = make_page()
        cls.outline = outline(cls.page)

    def test_every_figure_has_pictures_caption_and_numbers(self):
        for slug, count in PICTURES.items():
            with self.subTest(figure=slug):
                text = section(self.page, slug)
                self.assertEqual(text.count("<svg"), count)
                for part in ("<figcaption>", "<td"):
                    self.assertIn(part, text)
                self.assertNotIn('class="missing"', text)

    def test_page_is_one_sound_file(self):
        self.assertEqual((self.outline.faults, self.outline.open), ([], []))
        self.assertEqual(len(self.outline.identifiers), len(set(self.outline.identifiers)))
        self.assertNotRegex(self.page, r"https?:|@import|@font-face|(?i:>nan<)")
        inside = {reference for reference in self.outline.references if not reference.startswith("animations/")}
        used = {r[1:] for r in inside} | set(re.findall(r"url\(#([^)]+)\)", self.page))
        self.assertEqual(used - set(self.outline.identifiers), set())

    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_same_results_give_the_same_bytes_in_another_process(self):
        with tempfile.TemporaryDirectory() as folder:
            dynamic.write_results(folder, dynamic.make_report())
            result = run_command(folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertEqual(Path(folder, "report.html").read_bytes(), self.page.encode("utf-8"))

    def test_quasi_static_result_has_none_of_them(self):
        text = make_page({**dynamic.make_report(), "fidelity": "quasi-static"})
        for slug in PICTURES:
            self.assertNotIn(f'<section id="{slug}">', text)

    def test_what_is_too_thin_to_draw_is_named(self):
        self.assertIn("not drawn: pin support.", section(self.page, "power-loss"))


class MissingData(unittest.TestCase):
    def check_words(self, text, *words):
        """The figures from files say why they are empty, the others are drawn."""
        for slug in FROM_FILES:
            part = section(text, slug)
            self.assertNotIn("<svg", part, slug)
            for word in words:
                self.assertIn(word, part, slug)
        for slug in FROM_ROWS:
            self.assertEqual(section(text, slug).count("<svg"), PICTURES[slug], slug)

    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_files_that_are_gone_or_damaged(self):
        def remove(folder):
            for path in folder.glob("points/*"):
                path.unlink()

        def damage(folder):
            for path in folder.glob("points/*"):
                path.write_bytes(path.read_bytes()[:900])

        self.check_words(make_page(damage=remove), "cannot be read", ".nc")
        self.check_words(make_figures(damage=damage), "cannot be read", ".nc")
        self.check_words(make_figures(damage=lambda folder: (folder / "manifest.jsonl").unlink()), "manifest.jsonl")

    def test_missing_module_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            dynamic.write_results(folder, dynamic.make_report())
            with mock.patch.dict(sys.modules, {"netCDF4": None}), style.context():
                report = read_report(Path(folder))
                blocks = (*DYNAMIC_BLOCKS, dynamic_ablation.block)
                self.check_words(page(report, [block(report) for block in blocks]), "netCDF4", "python3-netcdf4")

    def test_one_file_less_costs_one_picture(self):
        text = make_figures(damage=lambda folder: (folder / "points" / "00000.nc").unlink())
        self.assertEqual(section(text, "dynamic-polar").count("<svg"), 2)
        self.assertEqual(section(text, "roller-history").count("<svg"), PICTURES["roller-history"])

    @unittest.skipIf(program.LEFT_TO_FULL, "each variable twice: tools/test --full, or by hand")
    def test_any_variable_may_be_absent_or_unfilled(self):
        asked = asked_of_files(peak_only())
        self.assertTrue(all(asked.values()))
        for name in dynamic.variables(6000):
            blocks = [block for block, names in asked.items() if name in names]
            self.assertTrue(blocks or name in OF_ANIMATIONS, f"nothing asks for {name}")
            for empty in (None, np.nan) if blocks else ():
                with self.subTest(variable=name, value=empty):
                    text = make_figures(peak_only(), lambda n, values: values if n != name else empty, blocks)
                    self.assertEqual(outline(text).faults, [])
                    self.assertNotRegex(text, r"(?i)>nan<")

    def test_holes_in_the_series_are_survived(self):
        def with_holes(name, values):
            values = np.array(values)
            values.flat[::3] = np.nan
            return values

        text = make_figures(change=with_holes)
        for slug, count in PICTURES.items():
            self.assertEqual(section(text, slug).count("<svg"), count)
        self.assertNotRegex(text, r"(?i)>nan<")

    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_nulls_and_other_kinds_in_the_report(self):
        whole = peak_only()
        self.assertNotRegex(make_figures({**nulled(whole), "fidelity": "dynamic"}), r"(?i)>nan<")
        for value in (None, [], {}, "text", [None], {"ablation": [{"points": 3}], "quasi_static": []},
                      {"ablation": [{"name": None, "points": [None, {}]}], "quasi_static": {"polar": [{}]}}):
            with self.subTest(dynamic=value):
                text = make_figures({**whole, "dynamic": value}, blocks=(dynamic_polar.block, dynamic_ablation.block))
                self.assertEqual(outline(text).faults, [])
        for key in ("points", "peak", "drawing", "polar"):
            with self.subTest(key=key):
                self.assertEqual(outline(make_figures({**whole, key: None})).faults, [])

    def test_single_point_and_only_reference(self):
        whole = peak_only()
        whole["dynamic"]["ablation"] = whole["dynamic"]["ablation"][:1]
        text = make_figures(whole)
        self.assertEqual(section(text, "power-loss").count("<svg"), 2)
        self.assertEqual(section(text, "cage-orbit").count("<svg"), 1)
        self.assertIn('class="missing"', section(text, "dynamic-ablation"))

    def test_text_from_the_results_stays_text(self):
        bad = "<script>1</script> & $\\frac{ _x"
        content = poisoned(dynamic.make_report(), bad)
        self.assertNotIn("<script", make_figures({**content, "fidelity": "dynamic"}))


class Numbers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        dynamic.write_results(cls.folder.name, dynamic.make_report())
        cls.report = read_report(Path(cls.folder.name))

    def block(self, figure):
        with style.context():
            return figure.block(self.report)

    def test_shown_speeds_are_lowest_best_and_highest(self):
        self.assertEqual(self.report.shown_speeds, [1000, 6000, 12000])

    def test_speed_without_a_file_is_said_past_a_torn_line(self):
        point = read_point(self.report, 777)
        self.assertEqual(point.values, {})
        self.assertIn("777 rpm is not named in manifest.jsonl", point.problem)

    def test_rollers_that_carry_as_quasi_static_ones_leave_no_difference(self):
        rows = np.array(self.block(dynamic_polar).data.rows, dtype=float)
        self.assertEqual(len(rows), 3 * dynamic.PLACES)
        np.testing.assert_allclose(rows[:, 4:], rows[:, 2:4], rtol=ROUND_OFF, atol=ROUND_OFF)

    def test_cage_on_half_its_clearance(self):
        row = self.block(cage_orbit).summary.rows[0]
        clearance_um = 1e6 * dynamic.CLEARANCE
        self.assertAlmostEqual(row[4], clearance_um / 2, delta=0.05)  # the table shows tenths
        self.assertAlmostEqual(row[5], 50.0, delta=0.05)

    def test_slip_over_time_is_that_of_the_rows(self):
        rows = np.array(self.block(slip_traces).data.rows, dtype=float)
        shares = 100 * np.array([dynamic.ROLLER_SLIP, dynamic.ROLLER_SLIP, dynamic.CAGE_SLIP])
        np.testing.assert_allclose(rows[:, 1:], np.tile(shares, (len(rows), 1)), rtol=1e3 * ROUND_OFF)

    def test_clearance_of_either_guidance(self):
        rows = [((38.88, 33.44, 38.54), 170.0), ((33.0, 33.44, 38.54), 220.0), ((36.0, 33.44, 38.54), None), ((None, 33.44, 38.54), None)]
        for (land, inner, outer), radius in rows:
            found = cage_orbit.clearance({"guide_land_mm": land, "cage_inner_mm": inner, "cage_outer_mm": outer})
            self.assertEqual(found if found is None else round(found, 6), radius)

    def test_losses_add_up(self):
        for row, speed in zip(self.block(power_loss).data.rows, fixture.GRID):
            self.assertAlmostEqual(row[-1] / sum(dynamic.losses(speed).values()), 1.0, delta=ROUND_OFF)

    def test_change_of_life_against_all_effects(self):
        runs = {entry["name"]: {1000.0: entry["points"][0]} for entry in dynamic.make_report()["dynamic"]["ablation"]}
        reference = runs["all effects"]
        for name, worth in dynamic.EFFECTS.items():
            change = dynamic_ablation.change_of_life(runs[name], reference, 1000.0, "life_h")
            self.assertAlmostEqual(change, 100 * (worth - 1), delta=100 * worth * ROUND_OFF)
        self.assertTrue(np.isnan(dynamic_ablation.change_of_life({}, reference, 1000.0, "life_h")))

    def test_effects_as_a_table(self):
        lines = effects_table.rows(self.report.record("dynamic")["ablation"])
        self.assertEqual(len(lines), 3 * len(dynamic.EFFECTS))
        self.assertEqual([line[:2] for line in lines[:2]], [("1000", "all effects"), ("1000", "no Coriolis")])
        self.assertEqual([line[3] for line in lines[:4]], ["", "-0.4 %", "+3900.0 %", "+10.0 %"])
        self.assertEqual(effects_table.rows([{"name": "one", "points": [{"speed_rpm": 1, "status": "no balance"}]}])[0][2], "no balance")

    def test_load_zone_is_where_the_inner_race_carries(self):
        point = read_point(self.report, 6000)
        time, angle, inner = one_roller(point, "roller_inner_load")
        zone = load_zone(point, angle)
        self.assertEqual(time[0], 0.0)
        self.assertTrue(zone.any() and not zone.all())
        self.assertGreater(inner[zone].min(), 0.04 * inner.max())  # near 5 %: the places are 5 deg wide
        self.assertLess(inner[~zone].max(), 0.15 * inner.max())

    def test_one_roller_is_cut_to_one_revolution(self):
        whole = read_point(self.report, 6000)
        twice = {name: np.concatenate([values, values], axis=-1) for name, values in whole.values.items()}
        twice["time"] = np.arange(2.0 * dynamic.INSTANTS)
        time, *_ = one_roller(type(whole)(twice), "roller_inner_load")
        self.assertLess(abs(len(time) - dynamic.INSTANTS), 3)  # the joint repeats one instant


if __name__ == "__main__":
    unittest.main()
