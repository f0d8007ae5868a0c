#!/usr/bin/env python3
"""Every page of the report is as recorded, in words and numbers: of each kind of result, and of results that lack or change one value at a time.

The results are stored in records/results.json.xz, which `--results` makes anew by the program; `--record` writes records/pages.json.xz.
Exit code 77 (skipped) where matplotlib or netCDF4 is missing.
"""

import json
import lzma
import os
import re
import sys
import tempfile
import types
import unittest
import unittest.mock
from pathlib import Path

try:
    import matplotlib  # noqa: F401
    import numpy as np
except ImportError:
    print("skipped: matplotlib or numpy is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import figures_fixture as made  # noqa: E402
import kept_records  # noqa: E402
from orbearing import assessor, assessor_pdf, ball_page, blocks, crown_page, defect_page, lives, page, pair_page, static_page, style, summary, tables  # noqa: E402
from orbearing.blocks import FigureBlock, Table  # noqa: E402
from orbearing.errors import CaseError  # noqa: E402
from orbearing.point_file import PointFile  # noqa: E402
from orbearing.result_folder import Report  # noqa: E402

RECORDS = kept_records.Records("pages")
STORED = kept_records.FOLDER / "results.json.xz"
BLOCKS = [FigureBlock("life", "Life <over> speed", "a caption & more", ("<svg>1</svg>", '<svg href="#a">2</svg>'), Table(("a", "b (rpm)"), [(1.23456, "x"), (None, "")]),
                      Table(("speed",), [(1.0,), (2.0,)])),
          FigureBlock("load-spectrum", "Load spectrum", "bins", ("<svg>3</svg>",)), FigureBlock("polar", "Polar", "loads", ("<svg>4</svg>",)),
          FigureBlock("element-loads", "Elements", missing="no <loads>"), FigureBlock("slip", "Slip", "slips", ("<svg>5</svg>",))]
BEARINGS = {"bearing_load": [100.0, 120.0], "bearing_L10h": [5e4, 4e4], "bearing_L10rh": [4.5e4, 3.5e4], "bearing_L10mrh": [4.1e4, 3.1e4], "bearing_life": [6e4, 5e4],
            "planet_bearing_load": [90.0, 95.0, 130.0], "planet_planet_load_share": [0.9, 1.0, 1.1], "planet_load_share": [0.9, 1.0, 1.1], "planet_L10h": [7e4, 6e4, 5e4],
            "planet_L10mh": [6e4, 5e4, 4e4], "planet_life": [8e4, 7e4, 6e4]}


def lines_of(html):
    return re.sub(r"<style>.*?</style>", "<style>", html, flags=re.S).splitlines()


def paths_in(value, way=(), most=4):
    """Of each value of a result, however deep: of lists the first and the last entry."""
    if way:
        yield way
    if len(way) < most:
        entries = value.items() if isinstance(value, dict) else {i: value[i] for i in sorted({0, len(value) - 1})}.items() if isinstance(value, list) and value else ()
        for key, one in entries:
            yield from paths_in(one, (*way, key), most)


def other(value):
    """Another value of its kind: numbers a third larger, texts with more words, truth values turned, lists and dicts without their first entry."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)):
        return round(value * 1.3711, 6) + 1e-4
    if isinstance(value, str):
        return value + " <more>"
    if isinstance(value, list):
        return value[1:]
    return dict(list(value.items())[1:]) if isinstance(value, dict) else 7.5


def with_value(place, way, change):
    whole = dict(place) if isinstance(place, dict) else list(place)
    if len(way) > 1:
        whole[way[0]] = with_value(whole[way[0]], way[1:], change)
    elif change is None and isinstance(whole, dict):
        del whole[way[0]]
    else:
        whole[way[0]] = change(whole[way[0]]) if callable(change) else change
    return whole


class Pages(kept_records.Recorded):
    records = RECORDS

    @classmethod
    def setUpClass(cls):
        cls.results = json.loads(lzma.decompress(STORED.read_bytes()))
        for content in cls.results.values():
            part = next((content[kind] for kind in ("static", "pair") if kind in content), content)
            paths = [row["key"] for row in part["assumptions"]]
            part["influences"] = {"quantity": "shortest_L10mrh", "unit": "h", "shortest_L10mrh": 41234.5, "reliability": 0.95, "inputs": [
                {"path": path, "value": f"{1.2345678 * (i + 1)} mm", "step": f"{i + 1} %", "change": change}
                for i, (path, change) in enumerate(zip([*paths[:4], "life.reliability", *paths[4:6]], (-321.0, 654.3, 0.1, None, 999.0, 12.3, -2.0)))]}

    def whole_and_changes(self, name, draw, content, depth=3):
        """The page, and the lines that are new in it where a value is absent or another one."""
        begin = lines_of(draw(content))
        known, found, reasons = set(begin), {}, {}
        for way in paths_in(content, most=depth):
            for how, change in (("without", None), ("other", other)):
                try:
                    lines = lines_of(draw(with_value(content, way, change)))
                except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:  # no result has this form
                    lines = [type(error).__name__]
                fresh = [line for line in lines if line not in known]
                if fresh or len(lines) != len(begin):
                    text = json.dumps([len(lines) - len(begin), fresh])
                    found[f"{how} {'.'.join(map(str, way))}"] = reasons.setdefault(text, [len(lines) - len(begin), fresh])
        self.check(name, {"whole": begin, "changes": found})

    def test_the_report(self):
        def draw(content):
            with unittest.mock.patch("orbearing.assessor.read_point", lambda *_: PointFile({})):
                return page.page(Report(content, None), BLOCKS[:1], ("animations/1.html", "animations/<2>.html"))

        for name in ("spectrum", "sets"):
            content = self.results[name]
            shown = dict(content)
            shown |= {"validation": [{"source": "[A]", "quantity": "peak_life_h", "published": 3.0, "ours": 4.0, "deviation": 0.123, "tolerance": 0.15, "verdict": "reproduced", "of_sweep": 5.0},
                                     {"source": "[B]", "quantity": "other", "reading": "another", "published": 6.0}], "changed_inputs": [] if name == "sets" else ["input.power"],
                      "sensitivities": [{"assumption": "a", "reading": "r", "peak_speed_rpm": 1.0, "peak_life_h": 7.0, "worth_h": -2.0}, {"assumption": "b", "worth_h": 0.0004}],
                      "branches": {"runs": [{"name": "up"}]}, "missing": None, "fidelity": "dynamic" if name == "sets" else "quasi-static"}
            shown["fine"] = {"speed_rpm": [1.0, 2.0, 3.0, 4.0], "planet_load_N": [9.0, 7.0, 8.0, 11.0]}
            self.whole_and_changes(f"report: {name}", draw, shown, 3)

    def test_unlike_bearings(self):
        content = self.results["stage"]
        for name, values in {"both": BEARINGS, "bearings": {key: value for key, value in BEARINGS.items() if "planet" not in key}, "torn": {**BEARINGS, "bearing_life": [1.0]}}.items():
            point = PointFile({key: np.array(value) for key, value in values.items()})
            with unittest.mock.patch("orbearing.assessor.read_point", lambda *_, point=point: point):
                self.check(f"unlike bearings: {name}", lines_of(assessor._bearings(Report(content, None))))

    def test_the_assessors_page(self):
        def draw(most, figures):
            def html(content):
                with unittest.mock.patch("orbearing.assessor.read_point", lambda *_: PointFile({})):
                    return assessor_pdf.html(assessor_pdf.rated(Report(content, None)), BLOCKS, most, figures)
            return html

        for name in ("single", "pair", "stage", "spectrum", "sets"):
            self.check(f"assessor: {name}", {f"{most}, {figures}": lines_of(draw(most, figures)(self.results[name])) for most, figures in assessor_pdf.LEVELS[:1] + ((assessor.Most(1, 2), False),)})
        for name in ("spectrum", "stage"):
            content = {key: value for key, value in self.results[name].items() if key in ("points", "spectrum", "verdicts", "influences", "assumptions", "peak", "own_speed_rpm", "own_point", "warnings")}
            content |= {"points": content["points"][:2]}
            self.whole_and_changes(f"assessor, one value changed: {name}", draw(assessor.Most(2, 3), False), content, 4)

    def test_the_document(self):
        """Cut to eight pages: the first form of it that fits, or none."""
        asked = []

        def library(pages):
            class HTML:
                def __init__(self, string):
                    asked.append([len(re.findall("<tr>", string)), string.count('<section class="figure')])

                def render(self):
                    return types.SimpleNamespace(pages=[0] * pages[len(asked) - 1], write_pdf=lambda: b"%d" % len(asked))

            return {"weasyprint": types.SimpleNamespace(HTML=HTML)}

        found = []
        for pages in ([8], [9, 8], [20, 12, 9, 3], [20, 12, 9, 9]):
            asked.clear()
            with unittest.mock.patch.dict(sys.modules, library(pages)), unittest.mock.patch("orbearing.assessor.read_point", lambda *_: PointFile({})):
                try:
                    found.append(assessor_pdf.pdf(Report(self.results["spectrum"], None), BLOCKS).decode())
                except CaseError as error:
                    found.append(str(error))
            found.append(list(asked))
        with unittest.mock.patch.dict(sys.modules, library([1])), self.assertRaises(CaseError) as caught:
            assessor_pdf.pdf(Report({"points": []}, None), BLOCKS)
        with tempfile.TemporaryDirectory() as place:
            (Path(place) / "case.resolved.yaml").write_bytes(b"x: 1")
            os.utime(Path(place) / "case.resolved.yaml", (1e9, 1e9))
            issue = [assessor_pdf._issue(Report({}, folder)) for folder in (None, Path(place), Path(place) / "none")]
        reliable = [assessor._reliability(Report({"influences": {"reliability": value}}, None)) for value in (None, 0.9, 0.99)]
        self.check("document", [found, str(caught.exception), issue, reliable, assessor._signed(None), assessor._signed(-1.5, "h"), assessor._signed(2.0)])

    def test_runs_of_single_bearings(self):
        for name, draw in (("single", static_page.page), ("pair", pair_page.page)):
            self.whole_and_changes(f"run: {name}", lambda content, draw=draw: draw(Report(content, None), BLOCKS[3:]), self.results[name], 3)

    def test_studies_with_pages_of_their_own(self):
        made.RANDOM = np.random.default_rng(44)
        crowned, computed = made.crown(), made.computed_crown()
        for content in (crowned, computed):
            content["crown"] |= {"laminae": 41, "spectrum": [{"input_speed_rpm": 1000.0}, {"input_speed_rpm": 4000.0}], "options": {"tilt": "0.4 mrad", "all": True, "drop_tolerance": "1 um", "x": False},
                                 "optima": [{"profile": "logarithmic", "starts": {"ends": [{"start_um": 1.0, "drop_um": 2.0, "crowned_share": 0.3, "governing_life_h": 4e4, "evaluations": 55}]}}],
                                 "versions": {"b": "1", "a": None}, "warnings": ["beware"], "assumptions": [{"key": "k", "value": "v", "reason": "r", "worth_h": -3.0, "worth_text": "w"}]}
            content["crown"]["recommended"] |= {"half_space_life_h": 12345.0, "no_crown_needed": False, "rollers": "straight with relieved ends", "status": "is short", "points": [
                {"input_speed_rpm": 1000.0, "power_kW": 3.0, "share": 0.4, "tilt_mrad": 0.25, "load_share": 1.1, "half_space_life_h": 1.1e4, "governing_life_h": 1.2e4, "damage_share": 0.6,
                 "peak_pressure_MPa": 1717.0, "edge_ratio": 1.05}, {"input_speed_rpm": 4000.0, "tilt_mrad": 0.75}]}
        crowned["crown"]["recommended"]["within_tolerances"] = {"tilt_mrad": 0.1, "drop_um": 1.5, "distribution": "worst", "half_space_life_h": 9876.0}
        computed["crown"]["recommended"]["within_tolerances"] = {"pin_inclination_mrad": 0.2, "drop_um": 2.5, "distribution": "normal", "half_space_life_h": 8765.0}
        ended = with_value(crowned, ("crown", "recommended", "no_crown_needed"), True)
        stopped = with_value(ended, ("crown", "recommended", "rollers"), "straight")
        for name, content in (("stated", crowned), ("computed", computed), ("no crown", ended), ("no crown, straight", stopped)):
            draw = lambda content: crown_page.page(Report(content, None), BLOCKS[3:4])  # noqa: E731
            if name in ("stated", "computed"):
                self.whole_and_changes(f"crown: {name}", draw, {"crown": content["crown"]}, 3)
            else:
                self.check(f"crown: {name}", lines_of(draw(content))[:12])
        for name, (content, _) in (("scratch", made.scratch()), ("run-up", made.run_up())):
            self.whole_and_changes(f"defect: {name}", lambda content: defect_page.page(Report(content, None), BLOCKS[3:4]), content, 3)
        content, _ = made.balls()
        rated = with_value(content, ("balls",), lambda study: {**study, "life_table": {"governing": "L10mrh"}, "L10mrh": 4321.0, "L10mr_Mrev": 12.0, "L10rh": 5432.0, "L10r_Mrev": 15.0})
        for name, one in (("balls", content), ("rated balls", rated)):
            self.whole_and_changes(f"in time: {name}", lambda content: ball_page.page(Report(content, None), BLOCKS[3:4]), one, 3)

    def test_the_answer_in_a_sentence(self):
        point = {"input_speed_rpm": 1000.0, "L10mh": 5e4, "shortest_L10mh": 4e4, "status": "ok", "carrier_L10mh": 3e4, "limiting_set": "low"}
        report = {"points": [point, {**point, "input_speed_rpm": 2000.0, "refined": True}], "fidelity": "dynamic", "peak": {"life_key": "L10mh", "speed_rpm": 1000.0, "life_h": 5e4},
                  "missing": {"points": [3], "found": 2, "of": 5, "shard": "1/2", "text": "three points"}, "slice": {"kW": 5.0},
                  "spectrum": {"L10mh": 3.3e4, "life_key": "L10mh"}, "published": [{"source": "", "speed_rpm": 1.0, "life_h": 2.0, "ours_h": 3.0}, {"source": "b", "speed_rpm": 4.0, "life_h": 5.0}],
                  "changed_inputs": ["a", "b"], "carrier": {"bearings": [{"planet": 1, "position_mm": 2.0, "L10mh": 7.0}], "largest_load_share": 1.5}}
        for row in report["points"]:
            row["kW"] = 5.0
        found = {}
        for name, gone in {"all": (), "part": ("missing",), "no spectrum": ("missing", "spectrum"), "no line": ("missing", "spectrum", "slice"), "nothing": ("peak",)}.items():
            content = {key: value for key, value in report.items() if key not in gone}
            for more, edit in {"": {}, ", one point": {"points": report["points"][:1]}, ", not refined": {"missing": {"text": "not refined"}}, ", at rest": {"fidelity": "quasi-static"}, ", no bearing": {"carrier": {}}}.items():
                one = Report({**content, **edit}, None)
                found[name + more] = [summary.headline(one), [list(row) for row in summary.summary_table(one).rows]]
        self.check("sentences", found)


class Words(kept_records.Recorded):
    records = RECORDS

    def test_numbers(self):
        values = [None, True, 0, 1, -1.5, 0.000123456, 0.00001234, 99999.6, 123456.7, 1234567.8, 12345678.9, -3.14159e-7, 1e7, 9.9999e6, float("nan"), float("inf"), "x", 0.1 + 0.2]
        self.check("numbers", [[blocks.format_number(one), blocks.format_number(one, 3), blocks.format_quantity(one, "N", 4), tables.cell(one), page._hours(one) if isinstance(one, float) else ""]
                               for one in values])
        self.check("changes", [blocks.format_change(one, base) for one in (1.0, 2.0, 3.0, 3.3, None, -1.0) for base in (1.0, 0.0, 2.0, None)])
        self.check("columns", [list(blocks.columns_table(("a", "b"), [1, 2, 3], ["x"]).rows), list(blocks.columns_table(()).rows), BLOCKS[0]._repr_html_(), BLOCKS[3]._repr_html_()])
        names = ("life_h", "L10h", "L10rh", "L10mh", "L10mrh", "system_L10mrh", "system_life_h", "other")
        self.check("lives", [[lives.life_in_words(name), lives.revolutions_of(name), lives.name_of_worst({f"shortest_{name}": 1.0}, name), lives.name_of_worst({f"a.carrier_{name}": 1.0, f"a.shortest_{name}": 2.0}, name, "a."),
                              lives.name_of_worst({}, name)] for name in names])
        whole = {"life_table": {"governing": "L10mh"}, "L10mh": 1.0, "L10m_Mrev": 2.0, "L10rh": 3.0, "L10r_Mrev": 4.0, "life_h": 5.0, "life_Mrev": 6.0}
        found = []
        for governing in ("L10mh", "life_h", None):
            left = {**whole, "life_table": {"governing": governing}}
            while left:
                found.append(lives.governing_number(left))
                left = dict(list(left.items())[:-1]) if not found[-1] else {key: value for key, value in left.items() if key != {"h": found[-1][0]}.get(found[-1][2], lives.revolutions_of(found[-1][0]) if found[-1][0] != "L10r" else "L10r_Mrev")}
        self.check("governing lives", found)
        self.check("styles", sorted(path.name for path in (style.SHEET, page.STYLE_SHEET, assessor_pdf.STYLE_SHEET)))


if __name__ == "__main__":
    if "--results" in sys.argv:
        import pages_results
        pages_results.make(STORED)
    else:
        kept_records.main(RECORDS)
