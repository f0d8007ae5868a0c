#!/usr/bin/env python3
"""The report's page: complete, self-contained, escaped, the same bytes twice, and robust to missing data.

Exit code 77 (skipped) where matplotlib is missing.
"""

import re
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path
from unittest import mock

try:
    import numpy as np
    from matplotlib.backends.backend_svg import FigureCanvasSVG
except ImportError:
    print("skipped: matplotlib or numpy is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import report_fixture as fixture  # noqa: E402
from orbearing import report as command  # noqa: E402
from orbearing.blocks import format_change, format_number  # noqa: E402
from orbearing.figures.ablation import change_percent, group_of  # noqa: E402
from orbearing.figures.polar_loads import load_direction  # noqa: E402

SLUGS = ("life", "planet-load", "polar", "drawing", "ablation-inertia", "ablation-clearance", "roller-loads")
VOID = {"meta", "br", "img", "link", "input", "hr"}
ROUND_OFF = 1e-9  # a few operations in double precision on numbers of order 1 to 100


class Outline(HTMLParser):
    """Collects identifiers, references and tags, and notes where tags do not close in order."""

    def __init__(self):
        super().__init__()
        self.open, self.faults, self.identifiers, self.references, self.tags = [], [], [], [], []

    def handle_starttag(self, tag, attributes):
        self.handle_startendtag(tag, attributes)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.tags.append(tag)
        for key, value in attributes:
            if key == "id":
                self.identifiers.append(value)
            elif key in ("href", "xlink:href", "src", "srcset", "action", "data", "poster"):
                self.references.append(value)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append((tag, self.getpos()))


def outline(page):
    parser = Outline()
    parser.feed(page)
    parser.close()
    return parser


def make_page(content):
    with tempfile.TemporaryDirectory() as folder:
        fixture.write_report(folder, content)
        return command.build(Path(folder))


def words_of(content):
    """The page with blank pictures: figures are made, which is quick, and not drawn, which takes most of the time."""
    with mock.patch.object(FigureCanvasSVG, "print_svg", lambda canvas, target, **_: target.write("<svg></svg>")):
        return make_page(content)


def best(content):
    return content["peak"]["refined_speed_rpm"]


def least_load(content):
    return content["fine"]["speed_rpm"][int(np.argmin(content["fine"]["planet_load_N"]))]


def run_command(*arguments):
    call = [sys.executable, "-B", "-m", "orbearing.report", *map(str, arguments)]
    return subprocess.run(call, capture_output=True, text=True, env={"PYTHONPATH": str(ROOT / "python"), "PATH": "/usr/bin:/bin"})


class CompletePage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = make_page(fixture.make_report())
        cls.outline = outline(cls.page)

    def section(self, slug):
        return re.search(rf'<section id="{slug}">.*?</section>', self.page, re.S).group(0)

    def test_every_figure_has_picture_caption_and_data(self):
        for slug in SLUGS:
            with self.subTest(figure=slug):
                text = self.section(slug)
                for part in ("<svg", "<figcaption>", "<details>"):
                    self.assertIn(part, text)
                self.assertNotIn('class="missing"', text)

    def test_every_number_says_by_which_rung_it_was_computed(self):
        heading = re.search(r"<h1>(.*?)</h1>", self.page).group(1)
        self.assertIn("quasi-static", heading)
        for slug in ("drawing", "ablation-inertia", "ablation-clearance", "polar"):
            self.assertIn("uasi-static", self.section(slug), slug)
        self.assertNotIn("with this run's values", self.page)

    def test_a_sweep_in_motion_is_not_mixed_with_quasi_static_numbers(self):
        content = fixture.make_report()
        content["fidelity"] = "monolithic"
        content["validation"][0]["of_sweep"] = 40123.0
        content["sensitivities"] = [{"assumption": "contact.law", "reading": "another", "peak_speed_rpm": 6000, "peak_life_h": 49356.0,
                             "worth_h": 2e-11}]
        page = words_of(content)
        self.assertIn("as one system", re.search(r"<h1>(.*?)</h1>", page).group(1))
        table = re.search(r"<h2>Published numbers beside ours</h2>.*?</section>", page, re.S).group(0)
        self.assertIn("<th scope=\"col\">quasi-static</th>", table)
        self.assertIn("<th scope=\"col\">monolithic</th>", table)
        self.assertIn("40,123", table)
        worths = re.search(r"<h2>Effect of each assumption</h2>.*?</section>", page, re.S).group(0)
        self.assertIn("0 h", worths)
        self.assertNotIn("e\u2212", worths)  # round-off is no worth

    def test_one_system_has_no_section_on_what_it_does_not_do(self):
        content = fixture.make_report()
        for fidelity, there in (("monolithic", False), ("co-simulated", True)):
            content["fidelity"] = fidelity
            content["points"] = [{**point, "interface_energy_residual": 1e-4} for point in content["points"]]
            found = set(outline(words_of(content)).identifiers)
            self.assertEqual("interface-energy" in found, there)
            self.assertNotIn("dynamic-ablation", found)

    def test_the_caption_of_the_planet_load_claims_only_what_is_so(self):
        content = fixture.make_report()
        claim = "Life peaks at a lower speed"
        self.assertEqual(claim in words_of(content), best(content) < least_load(content))
        content["peak"] |= {"refined_speed_rpm": 11000.0, "speed_rpm": 11000.0}
        self.assertNotIn(claim, words_of(content))

    def test_three_polar_pictures(self):
        self.assertEqual(self.section("polar").count("<svg"), 3)

    def test_nothing_comes_from_outside(self):
        self.assertNotRegex(self.page, r"https?:|//[a-z]+\.|@import|@font-face")
        self.assertFalse({"script", "link", "img", "iframe", "object"} & set(self.outline.tags))
        outside = [reference for reference in self.outline.references if not reference.startswith("#")]
        self.assertEqual(outside, [])

    def test_identifiers_are_unique_and_references_meet_them(self):
        identifiers = self.outline.identifiers
        self.assertEqual(len(identifiers), len(set(identifiers)))
        used = {r[1:] for r in self.outline.references} | set(re.findall(r"url\(#([^)]+)\)", self.page))
        self.assertEqual(used - set(identifiers), set())

    def test_tags_close_in_order(self):
        self.assertEqual((self.outline.faults, self.outline.open), ([], []))

    def test_headline_names_the_refined_peak(self):
        peak = fixture.make_report()["peak"]
        heading = re.search(r"<h1>(.*?)</h1>", self.page).group(1)
        self.assertIn(f"{peak['refined_speed_rpm']:,.0f} rpm", heading)
        self.assertIn(f"{peak['refined_life_h']:,.0f} hours", heading)

    def test_words_of_the_case_are_there(self):
        for text in ("undercut", "bearing.radial_clearance", "reproduced", "g++ 12.2.0", "orbearing sweep", "[Gai2025]"):
            self.assertIn(text, self.page)

    def test_same_results_give_the_same_bytes_in_another_process(self):
        with tempfile.TemporaryDirectory() as folder:
            fixture.write_report(folder, fixture.make_report())
            self.assertEqual(run_command(folder).returncode, 0)
            self.assertEqual(Path(folder, "report.html").read_bytes(), self.page.encode("utf-8"))
            self.assertEqual(sorted(p.name for p in Path(folder).iterdir()), ["report.html", "report.json"])


class MissingData(unittest.TestCase):
    def test_failed_point_is_named_with_its_reason(self):
        content = fixture.make_report()
        point = content["points"][3]
        content["points"][3] = {key: None for key in point} | {"input_speed_rpm": 4000, "status": "no equilibrium found"}
        page = words_of(content)
        self.assertIn("no equilibrium found", page)
        self.assertIn("12, of which 1 without a life", page)
        self.assertIn("<svg", page)

    def test_single_point_makes_no_claim_of_a_peak(self):
        content = fixture.make_report()
        content["points"] = content["points"][5:6]
        content["fine"] = {}
        page = words_of(content)
        self.assertIn("a single point", page)
        self.assertNotIn("Longest life_h", page)

    def test_best_point_at_the_edge_is_said(self):
        content = fixture.make_report()
        content["points"] = content["points"][:6]
        content["peak"] |= {"refined_speed_rpm": 6000, "refined_life_h": content["peak"]["life_h"]}
        self.assertIn("edge of the sweep", words_of(content))

    def test_any_part_may_be_missing_null_or_of_another_kind(self):
        whole = fixture.make_report()
        values = (None, [], {}, "text", 3, [None], [{}], {"speed_rpm": None})
        for value in values:
            with self.subTest(every_key=value):
                self.assertEqual(outline(make_page(dict.fromkeys(whole, value))).faults, [])
        for number, key in enumerate(("points", "peak", "fine", "polar", "drawing", "ablation")):
            with self.subTest(key=key):
                page = words_of({**whole, key: values[number]})
                self.assertEqual(outline(page).faults, [])
                self.assertIn("<svg", page)

    def test_nulls_inside_every_list_and_record(self):
        page = make_page(nulled(fixture.make_report()))
        self.assertNotIn(">nan<", page)
        for slug in SLUGS:
            self.assertIn(f'<section id="{slug}">', page)

    def test_empty_report_says_what_is_missing(self):
        page = make_page({})
        self.assertEqual(page.count('class="missing"'), len(SLUGS))
        self.assertNotIn("<svg", page)

    def test_not_a_number_counts_as_missing(self):
        content = fixture.make_report()
        content["points"][2]["life_h"] = float("nan")
        content["fine"]["life_h"][7] = float("inf")
        page = make_page(content)
        self.assertIn("1 without a life", page)
        self.assertNotRegex(page, r"(?i)>(nan|inf)<")


def nulled(value):
    """Every second number of a list, and every number of a record, becomes null."""
    if isinstance(value, dict):
        return {key: None if isinstance(item, (int, float)) else nulled(item) for key, item in value.items()}
    if isinstance(value, list):
        return [None if isinstance(v, float) and i % 2 else nulled(v) for i, v in enumerate(value)]
    return value


class Escaping(unittest.TestCase):
    BAD = '<script>alert("1")</script> & $\\frac{ \u8f74 -- ]]> --> _x'

    def test_text_from_the_case_stays_text(self):
        content = poisoned(fixture.make_report(), self.BAD)
        page = make_page(content)
        self.assertNotIn("<script", page)
        self.assertIn("&lt;script&gt;", page)
        self.assertEqual((outline(page).faults, outline(page).open), ([], []))


def poisoned(value, text):
    if isinstance(value, dict):
        return {key: poisoned(item, text) for key, item in value.items()}
    if isinstance(value, list):
        return [poisoned(item, text) for item in value]
    return text if isinstance(value, str) else value


class Command(unittest.TestCase):
    def check_bad_input(self, folder, *words):
        result = run_command(folder)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def test_bad_input_names_place_and_remedy(self):
        with tempfile.TemporaryDirectory() as folder:
            self.check_bad_input(Path(folder, "none"), "report.json", "orbearing report")
            self.check_bad_input(folder, "report.json", "orbearing report")
            for text in ("{", "[1]", "\udcff"):
                Path(folder, "report.json").write_bytes(text.encode("utf-8", "surrogateescape"))
                self.check_bad_input(folder, "report.json", "JSON")

    def test_bad_input_leaves_an_older_page_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "report.html").write_text("older")
            self.check_bad_input(folder, "report.json")
            self.assertEqual(Path(folder, "report.html").read_text(), "older")

    def test_target_that_cannot_be_replaced(self):
        with tempfile.TemporaryDirectory() as folder:
            fixture.write_report(folder, {})
            Path(folder, "report.html").mkdir()
            self.check_bad_input(folder, "report.html")
            self.assertEqual(sorted(p.name for p in Path(folder).iterdir()), ["report.html", "report.json"])

    def test_usage(self):
        for arguments in ((), ("a", "b"), ("--nonsense",)):
            self.assertEqual(run_command(*arguments).returncode, 2)
        self.assertEqual(run_command("--help").returncode, 0)


class Numbers(unittest.TestCase):
    def test_formats(self):
        rows = [(43869.4, "43,869"), (0.0012345, "0.0012345"), (-12.5, "\u221212.5"), (0, "0"), (None, "–"),
                (float("nan"), "–"), (1.5e9, "1.5000e9"), (9255.8, "9,256"), (999999.6, "1,000,000"), (True, "–")]
        for value, text in rows:
            self.assertEqual(format_number(value).replace("e+0", "e"), text, value)

    def test_change(self):
        self.assertEqual(format_change(110.0, 100.0), "+10.0 %")
        self.assertEqual(format_change(50.0, 100.0), "\u221250.0 %")
        self.assertEqual(format_change(500.0, 100.0), "× 5")
        self.assertEqual(format_change(1.0, 0.0), "–")

    def test_load_direction_follows_from_the_outer_loads(self):
        for speed in (1000, 6000, 12000):
            entry = fixture.polar(speed)
            stored = load_direction(entry)
            derived = load_direction({**entry, "planet_load_x_N": None})
            # 15 rollers sample the load zone: the resultant may lean by a fraction of their spacing of 24 deg.
            self.assertAlmostEqual(np.degrees(derived - stored), 0.0, delta=24 / 4)

    def test_change_of_life_on_unlike_grids(self):
        """Where one of both was not computed there is no change."""
        reference = {"speed_rpm": [1000, 2000, 3000], "life_h": [10.0, 20.0, 40.0]}
        entry = {"speed_rpm": [4000, 2500, 2000], "life_h": [1.0, 2 * (20.0 * 40.0) ** 0.5, 10.0]}
        speed, change = change_percent(entry, reference)
        self.assertEqual(speed.tolist(), [2000])
        np.testing.assert_allclose(change, [-50.0], atol=ROUND_OFF)

    def test_group_of_ablation(self):
        rows = {"no Coriolis": "inertia", "no own orbit": "inertia", "clearance 10 µm": "clearance", "with film": "clearance"}
        for name, group in rows.items():
            self.assertEqual(group_of({"name": name}), group)
        self.assertEqual(group_of({"name": "with film", "group": "inertia"}), "inertia")


if __name__ == "__main__":
    unittest.main()
