#!/usr/bin/env python3
"""What the page draws: its scripts run in node on a document without a browser (page_dom.mjs) and a server whose results are made up, of which no two
keys have the same number at any speed. Points are read from the drawn curves by the labels of their axes, as a reader does.

Skipped, with the reason, where node is missing or older than 20.
"""

import functools
import json
import math
import re
import subprocess
import sys
import unittest

from page_fixture import (CASE, CROWN, HIGH, KEYS, LOW, MESH, MODES, NODE, OTHER, POINT, ROLLER, ROLLERS, RPM, RUN, SCHEMA, SENSITIVITIES, SPEED, SPEEDS, SWEEP, VERDICTS,
                          WEB, check_of, click, cursor_put, dump, figure_of, label_of, name_of, page, put, readable, speeds_of, text_put, value_of)
from program import CASES

try:
    import yaml
except ImportError:
    print("skipped: yaml is missing (Debian: python3-yaml)")
    sys.exit(77)

BASE = getattr(yaml, "CBaseLoader", yaml.BaseLoader)  # each scalar as it stands
PIXEL = 0.006  # px, to which a path is written, with what is left of a half


class Read:
    """A chart as a reader sees it: values by the labels of the ticks."""

    def __init__(self, chart, log=False):
        self.chart, self.log = chart, log
        self.x, self.y = self.scale(chart["ticks"]["x"], False), self.scale(chart["ticks"]["y"], log)

    @staticmethod
    def scale(ticks, log):
        (a, first), (b, last) = ticks[0], ticks[-1]
        turn = math.log10 if log else float
        slope = (turn(last) - turn(first)) / (b - a)
        back = (lambda at: 10 ** at) if log else float
        return lambda pixel: (back(turn(first) + (pixel - a) * slope), abs(slope))

    def points(self, curve):
        return [(self.x(x), self.y(y)) for part in curve["paths"] for x, y in part]


class Drawn(unittest.TestCase):
    maxDiff = None

    def assert_chart(self, chart, expected, labels, log=False, **more):
        """`expected`: [(key, label, [(x, y)])] of all curves in their order, with what else is in `more` by key."""
        read = Read(chart, log)
        for ticks, scale in ((chart["ticks"]["x"], read.x), (chart["ticks"]["y"], read.y)):
            self.assertGreaterEqual(len(ticks), 2, chart["title"])
            for pixel, value in ticks:
                found, slope = scale(pixel)
                self.assertAlmostEqual(math.log10(found / value) if log and ticks is chart["ticks"]["y"] else found - value, 0, delta=PIXEL * slope)
        lines = {round(one[2], 6) for one in chart["lines"] if one[2] == one[3]} | {round(one[0], 6) for one in chart["lines"] if one[0] == one[1]}
        self.assertEqual(lines, {round(pixel, 6) for pixel, _ in chart["ticks"]["x"] + chart["ticks"]["y"]}, "lines stand at their labels")
        self.assertEqual(chart["labels"], labels)
        self.assertEqual([one["key"] for one in chart["curves"]], [key for key, _, _ in expected], chart["title"])
        for curve, (key, _, points) in zip(chart["curves"], expected):
            found = read.points(curve)
            self.assertEqual(len(found), len(points), key)
            for ((x, dx), (y, dy)), (a, b) in zip(found, points):
                self.assertAlmostEqual(x, a, delta=PIXEL * dx, msg=key)
                self.assertAlmostEqual(math.log10(y / b) if log else y - b, 0, delta=PIXEL * dy, msg=f"{key} at {a}: {y} for {b}")
            for name, value in more.get(key, {}).items():
                self.assertEqual(curve[name], value, (key, name))
        named = [(label, one["colour"]) for (_, label, _), one in zip(expected, chart["curves"]) if label]
        self.assertEqual([(one["text"], one["colour"]) for one in chart["legend"]], named)
        return read

    def assert_dots(self, curve, points, read):
        self.assertEqual([(a, b) for _, _, a, b in curve["dots"]], points)
        for x, y, a, b in curve["dots"]:
            self.assertAlmostEqual(read.x(x)[0], a, delta=PIXEL * read.x(x)[1])
            found, slope = read.y(y)
            self.assertAlmostEqual(math.log10(found / b) if read.log else found - b, 0, delta=PIXEL * slope)


def swept(key, which=0, speeds=None):
    return [(speed, value_of(key, speed, which)) for speed in speeds or speeds_of(LOW, HIGH)]


LIVES = ("life_h", "L10h", "L10rh", "L10mh", "L10mrh")
LOADS = ("planet_load_N", "tangential_load_N", "centrifugal_load_N", "radial_mesh_load_N")
OF_ROLLERS = ("inner_load_max_N", "inner_load_rms_N", "outer_load_max_N", "outer_load_rms_N")
OVER = "speed of the sun (rpm)"


def title_of(key):
    return f"{label_of(key)}: {POINT[key].get('description', '')}"


class Curves(Drawn):
    """Curves over speed: each key is its own curve, at its own values, and so is each of a pinned variant."""

    @classmethod
    def setUpClass(cls):
        cls.page = page([dump("first"), click("[data-pin=A]"), text_put(OTHER), {"what": "open", "selector": "#card-more"}, put("#card-more select", "film_inner_um"), dump("second"),
                         click("[data-pin=C]"), {"what": "check", "selector": "#card-life-log", "value": False}, cursor_put(8400), dump("third")], (CASE, OTHER))
        cls.first, cls.second, cls.third = (cls.page["dumps"][name]["cards"] for name in ("first", "second", "third"))

    def chart(self, name, cards=None):
        charts = (cards or self.first)[name]["charts"]
        self.assertEqual(len(charts), 1)
        return charts[0]

    def test_lives(self):
        chart = self.chart("life")
        read = self.assert_chart(chart, [(key, label_of(key), swept(key)) for key in LIVES], [OVER, "life (h)"], log=True,
                                 **{key: {"title": title_of(key), "dash": None, "equal": None, "dots": []} for key in LIVES})
        self.assertEqual([one["title"] for one in chart["legend"]], [title_of(key) for key in LIVES])
        self.assertEqual([one["colour"] for one in chart["curves"]], ["c1", "c2", "c3", "c4", "c5"])
        (at, y, top, label), = chart["marks"]
        self.assertAlmostEqual(read.x(at)[0], SWEEP["peak"]["speed_rpm"], places=6)
        self.assertEqual(label, "longest L10rh")
        self.assertLess(y, top)  # above the curves
        self.assertTrue(all(point[1] >= top for curve in chart["curves"] for part in curve["paths"] for point in part))
        (pixel, value), = chart["cursor"]
        self.assertAlmostEqual(read.x(pixel)[0], SPEED, places=6)
        self.assertEqual(value, SPEED)

    def ends(self, chart):
        """Pixels of the frame: left, right, top, bottom."""
        across, up = [one for one in chart["lines"] if one[2] == one[3]], [one for one in chart["lines"] if one[0] == one[1]]
        return (min(min(one[:2]) for one in across), max(max(one[:2]) for one in across),
                min(min(one[2:]) for one in up), max(max(one[2:]) for one in up))

    def test_curves_fill_the_width(self):
        for name in ("life", "loads", "roller-loads", "pressure"):
            chart = self.chart(name)
            at = [x for curve in chart["curves"] for part in curve["paths"] for x, _ in part]
            for found, wanted in zip((min(at), max(at)), self.ends(chart)):
                self.assertAlmostEqual(found, wanted, delta=PIXEL, msg=name)

    def test_an_axis_of_lives_has_room_about_them(self):
        """A tenth more at both ends; a fifth besides where the largest is not 1.2 times the least."""
        for keys, more in ((LIVES, 1.0), (("life_h",), 1.2)):
            speeds = (LOW, HIGH) if len(keys) > 1 else (8000.0, 8001.0)
            case = CASE if len(keys) > 1 else CASE.replace("[8000 rpm, 9000 rpm, 10000 rpm]", "[8000 rpm, 8001 rpm]")
            chart = self.chart("life") if len(keys) > 1 else page([dump()], (case,))["dumps"]["end"]["cards"]["life"]["charts"][0]
            values = [value_of(key, speed) for key in LIVES for speed in speeds]
            read, (_, _, top, bottom) = Read(chart, True), self.ends(chart)
            self.assertAlmostEqual(math.log10(read.y(bottom)[0] * 1.1 / min(values)), 0, delta=2 * PIXEL * read.y(bottom)[1])
            self.assertAlmostEqual(math.log10(read.y(top)[0] / 1.1 / max(values)), 0, delta=2 * PIXEL * read.y(top)[1])

    def test_the_cursor_is_drawn_whatever_the_values(self):
        """Values that are larger than any speed, and smaller ones."""
        for key in (next(one for one in reversed(KEYS) if "number" in POINT[one]["type"]), KEYS[0]):
            found = page([{"what": "open", "selector": "#card-more"}, put("#card-more select", key), cursor_put(8400), dump()])["dumps"]["end"]
            chart, = found["cards"]["more"]["charts"]
            (pixel, value), = chart["cursor"]
            self.assertEqual((value, [one["key"] for one in chart["curves"]]), (8400, [key]))
            self.assertAlmostEqual(Read(chart).x(pixel)[0], 8400, places=6)

    def test_loads_and_loads_of_rollers(self):
        for name, keys, label in (("loads", LOADS, "load of one bearing (N)"), ("roller-loads", OF_ROLLERS, "load of one roller (N)")):
            chart = self.chart(name)
            self.assert_chart(chart, [(key, label_of(key), swept(key)) for key in keys], [OVER, label], **{key: {"title": title_of(key), "dash": None} for key in keys})
            self.assertEqual(chart["marks"], [])

    def test_variants_are_dashed_curves_of_their_own_values(self):
        chart = self.chart("life", self.second)
        expected = [(key, label_of(key), swept(key, 1)) for key in LIVES] + [(f"{key} A", "variant A" if key == "life_h" else "", swept(key)) for key in LIVES]
        self.assert_chart(chart, expected, [OVER, "life (h)"], log=True, **{f"{key} A": {"dash": "7 4", "title": f"{key} of variant A", "colour": f"c{i + 1}"} for i, key in enumerate(LIVES)})
        self.assertEqual([one["dash"] for one in chart["legend"]], [None] * 5 + ["7 4"])

    def test_a_variant_like_the_case_is_said_to_be(self):
        chart = self.chart("life", self.third)
        expected = [(key, label_of(key), swept(key, 1)) for key in LIVES] + [(f"{key} A", "variant A" if key == "life_h" else "", swept(key)) for key in LIVES] \
            + [(f"{key} C", "variant Csame curves as the case" if key == "life_h" else "", swept(key, 1)) for key in LIVES]
        self.assert_chart(chart, expected, [OVER, "life (h)"], **{f"{key} C": {"equal": key, "dash": "9 3 2 3"} for key in LIVES})
        (pixel, value), = chart["cursor"]
        self.assertEqual(value, 8400)

    def test_any_result_over_speed(self):
        chart = self.chart("more", self.second)
        self.assert_chart(chart, [("film_inner_um", "film inner", swept("film_inner_um", 1)), ("film_inner_um A", "variant A", swept("film_inner_um"))], [OVER, "film inner (µm)"])
        self.assertIn("Any result over speed", self.second["more"]["text"])

    def test_equal_curves_are_dashed_and_named(self):
        rollers = [{**ROLLERS[0], "outer_pressure_MPa": ROLLERS[0]["inner_pressure_MPa"]}]
        found = page([dump()], results={"run": {**RUN, "roller_loads": rollers}})["dumps"]["end"]["cards"]["pressure"]
        points = list(zip(ROLLERS[0]["along_mm"], ROLLERS[0]["inner_pressure_MPa"]))
        self.assert_chart(found["charts"][0], [("inner", "inner race", points), ("outer", "outer racesame curve as inner race", points)],
                          ["position along the roller (mm)", "pressure (MPa)"], inner={"equal": None, "dash": None}, outer={"equal": "inner", "dash": "6 6"})

    def test_axes_begin_at_nought_where_it_is_near(self):
        """Values of one sign whose least is below 0.6 of the largest begin at 0, others have room about them; one value alone has 0 beside it."""
        for inner, outer, low, high in (([1011.0, 1022.0], [1001.0, 1044.0], 1001 - 2.15, 1044 + 2.15), ([100.0, 300.0], [900.0, 1000.0], 0.0, 1050.0), ([-1011.0, -1022.0], [-1001.0, -1044.0], -1044 - 2.15, -1001 + 2.15),
                                        ([-100.0, -300.0], [-900.0, -1000.0], -1050.0, 0.0), ([-7.0, -7.0], [-7.0, -7.0], -7.35, 0.0), ([7.0, 7.0], [7.0, 7.0], 0.0, 7.35), ([0.0, 0.0], [0.0, 0.0], 0.0, 1.05),
                                        ([-50.0, 10.0], [20.0, 30.0], -54.0, 34.0)):
            rollers = [{**ROLLERS[0], "along_mm": [-1.0, 1.0], "inner_pressure_MPa": inner, "outer_pressure_MPa": outer}]
            chart = page([dump(narrowly=["cards"])], results={"run": {**RUN, "roller_loads": rollers}})["dumps"]["end"]["cards"]["pressure"]["charts"][0]
            read = Read(chart)
            ends = next(one for one in chart["lines"] if one[0] == one[1])  # of a line over the whole height
            self.assertAlmostEqual(read.y(ends[3])[0], low, delta=1e-6 * (high - low), msg=str(inner))
            self.assertAlmostEqual(read.y(ends[2])[0], high, delta=1e-6 * (high - low), msg=str(inner))

    def test_pressure_along_the_roller(self):
        chart = self.chart("pressure")
        self.assert_chart(chart, [(race, f"{race} race", list(zip(ROLLERS[0]["along_mm"], ROLLERS[0][f"{race}_pressure_MPa"]))) for race in ("inner", "outer")],
                          ["position along the roller (mm)", "pressure (MPa)"])
        self.assertIn("Pressure along the most loaded roller", self.first["pressure"]["text"])
        empty = page([dump()], results={"run": {**RUN, "roller_loads": [{**ROLLERS[0], "along_mm": [], "inner_pressure_MPa": [], "outer_pressure_MPa": []}]}})["dumps"]["end"]["cards"]["pressure"]
        self.assertEqual((empty["text"], empty["charts"]), ("Pressure along the most loaded roller No slices of a roller: state bearing · laminae, such as 30", []))

    def test_requests_are_of_the_case_and_of_the_cursor(self):
        runs = [one for one in self.page["requests"] if one["command"] == "run"]
        self.assertEqual([(one["case_text"] == OTHER, one["settings"]) for one in runs], [(False, ["input.speed=9000 rpm"]), (True, ["input.speed=9000 rpm"]), (True, ["input.speed=8400 rpm"])])
        sweeps = [one for one in self.page["requests"] if one["command"] == "sweep"]
        self.assertEqual({len(one["settings"][0].split(",")) for one in sweeps}, {9, 60})
        for one in sweeps:
            count = len(one["settings"][0].split(","))
            self.assertEqual(one["settings"], ["sweep={input.speed: [%s]}" % ", ".join(f"{speed:g} rpm" for speed in speeds_of(LOW, HIGH, count))])
            self.assertEqual(one["options"], {"grid_only": True})


class Tiles(Drawn):
    """The verdict first; every failed requirement is a tile."""

    def tiles(self, **more):
        found = page([dump()], **more)["dumps"]["end"]
        return found["tiles"], found

    def test_the_governing_life_is_first_with_its_verdict(self):
        tiles, _ = self.tiles()
        chief = tiles[0]
        self.assertEqual((chief["key"], chief["classes"], chief["verdict"], chief["value"], chief["text"]),
                         ("L10mrh", "tile chief failed", "failed", "6.55", "Governing life, L10mrh6.55 hfailed: at least 100 h"))
        self.assertEqual([one["key"] for one in tiles[1:7]], ["L10h", "S0", "kappa", "contact_pressure_max_MPa", "rim_over_module", "largest_load_share"])
        texts = {one["key"]: (one["verdict"], one["text"]) for one in tiles}
        at = {key: value_of(key, SPEED) for key in KEYS}
        self.assertEqual(texts["S0"], ("failed", "S07.25passed here: at least 1.5failed at 17 of 60 speeds, worst 1.125"))
        self.assertEqual(next(one["classes"] for one in tiles if one["key"] == "S0"), "tile failed elsewhere")
        self.assertEqual(texts["largest_load_share"], ("not judged", f"load share{readable(at['largest_load_share'])}not judged: at most 1.3all planets carry the same load"))
        for key, name, unit in (("L10h", "L10h", "h"), ("kappa", "kappa", ""), ("contact_pressure_max_MPa", "pressure", "MPa"), ("rim_over_module", "rim / module", ""),
                                ("L10rh", "L10rh", "h"), ("life_h", "Lundberg-Palmgren", "h"), ("planet_load_N", "planet load", "N"), ("carrier_speed_rpm", "carrier", "rpm")):
            self.assertEqual(texts[key], (None, name + figure_of(at[key], unit)), key)
        self.assertIn("worst at input_speed_rpm = 9000", chief["title"])

    def test_a_passed_life_and_one_that_is_not_required(self):
        passed = [{**VERDICTS[0], "value": 200.5, "passed": True, "points_failed": 0}]
        tiles, _ = self.tiles(results={"run": {**RUN, "verdicts": passed}, "sweep": {**SWEEP, "verdicts": []}})
        self.assertEqual((tiles[0]["classes"], tiles[0]["text"]), ("tile chief passed", "Governing life, L10mrh200.5 hpassed: at least 100 h"))
        tiles, _ = self.tiles(results={"run": {**RUN, "verdicts": []}, "sweep": {**SWEEP, "verdicts": []}})
        value = readable(value_of("carrier_L10mrh", SPEED))
        self.assertEqual((tiles[0]["classes"], tiles[0]["text"]), ("tile chief", f"Governing life, L10mrh{value} hnot judged: the case requires no life"))
        self.assertIn(", of the bearing with the shortest", tiles[0]["title"])
        other = [{**VERDICTS[0], "key": "L10h"}]
        tiles, _ = self.tiles(results={"run": {**RUN, "verdicts": other}, "sweep": {**SWEEP, "verdicts": []}})
        self.assertIn("not limited: the case requires L10h", tiles[0]["text"])
        self.assertEqual((tiles[1]["key"], tiles[1]["verdict"], tiles[1]["text"]), ("L10h", "failed", "L10h6.55 hfailed: at least 100 h"))

    def test_the_key_is_that_of_the_result(self):
        for run_more, key in (({"life_key": "L10h"}, "L10h"), ({"peak": {**RUN["peak"], "life_key": "life_h"}}, "life_h"),
                              ({"spectrum": {"life_key": "L10rh", "L10rh": 4321.0, "bins": []}}, "L10rh")):
            tiles, _ = self.tiles(results={"run": {**RUN, "verdicts": [], **run_more}, "sweep": {**SWEEP, "verdicts": []}})
            self.assertEqual((tiles[0]["key"], "chief" in tiles[0]["classes"]), (key, True))
        self.assertIn("Governing life, L10rh, load spectrum4 321 h".replace(" 321", "\u202f321"), tiles[0]["text"])
        near = {"planet_load_N": 1e6, "tangential_load_N": 5e5, "centrifugal_load_N": 10.0, "radial_mesh_load_N": 5.0}
        at_end = {**SWEEP, "peak": {"life_key": "L10rh", "speed_rpm": HIGH, "life_h": 77.0}}
        tiles, found = self.tiles(results={"nulls": {"limiting_set": "second", **near}, "run": {**RUN, "roller_loads": []}, "sweep": at_end})
        self.assertIn("Governing life, L10mrh, set second", tiles[0]["text"])
        cards = found["cards"]
        self.assertIn("The results have no pressure along a roller of this bearing", cards["pressure"]["text"])
        self.assertIn("No bars: the results have no load of each roller.", cards["bearing"]["text"])
        self.assertEqual(cards["life"]["charts"][0]["marks"][0][-1], "longest L10rh of these speeds")
        self.assertIn("radial mesh loadat this scale the same curve as centrifugal load",
                      [one["text"] for one in cards["loads"]["charts"][0]["legend"]])

    def test_each_set_has_its_line_and_numbers_say_whose_they_are(self):
        sets = {"first": {"L10mrh": 15000.0, "shortest_L10mrh": 7448.0, "S0": 4.5, "kappa": 1.25}, "second": {"L10mrh": 90000.0, "S0": 3.5, "kappa": 2.25, "contact_pressure_max_MPa": 1234.0}}
        nulls = {"limiting_set": "first", "carrier_L10mrh": None, "shortest_L10mrh": 7448.0, **{f"sets.{name}.{key}": value for name, of in sets.items() for key, value in of.items()}}
        judged = [{**VERDICTS[0], "value": 7448.0, "result": "shortest_L10mrh", "of_set": "first"}, {**VERDICTS[1], "value": 3.5, "of_set": "second"}]
        tiles, _ = self.tiles(results={"nulls": nulls, "run": {**RUN, "verdicts": judged}, "sweep": {**SWEEP, "verdicts": []}})
        texts = {one["key"]: one["text"] for one in tiles}
        self.assertEqual(tiles[0]["text"], "Governing life, L10mrh, set first7\u202f448 hfailed: at least 100 h")
        self.assertEqual((texts["S0"], texts["kappa"].startswith("kappa, set first")), ("S0, set second3.5passed: at least 1.5", True))
        self.assertEqual({key: text for key, text in texts.items() if key.startswith("sets.")}, {
            "sets.first.shortest_L10mrh": "shortest L10mrh7\u202f448 h", "sets.first.S0": "S04.5", "sets.first.kappa": "kappa1.25", "sets.second.L10mrh": "L10mrh90\u202f000 h",
            "sets.second.S0": "S03.5", "sets.second.kappa": "kappa2.25", "sets.second.contact_pressure_max_MPa": "pressure1\u202f234 MPa"})

    def test_hours_are_whole_and_what_is_missing_says_why(self):
        nulls = {"L10h": 1234567.8, "kappa": None, "L10mh": None, "carrier_L10mrh": None, "shortest_L10mrh": None}
        tiles, _ = self.tiles(results={"nulls": nulls, "run": {**RUN, "verdicts": []}})
        texts = {one["key"]: one for one in tiles}
        self.assertEqual(texts["L10h"]["text"], "L10h1\u202f234\u202f568 h")
        self.assertEqual((texts["kappa"]["text"], texts["kappa"]["classes"]), ("kappa–an oil grade is required", "tile none"))
        self.assertTrue(texts["kappa"]["title"].endswith("not computed: an oil grade is required"))
        self.assertTrue(texts["L10mh"]["title"].endswith("not computed: oil grade and cleanliness are required"))
        self.assertEqual(texts["L10mrh"]["value"], repr(value_of("L10mrh", SPEED)).removesuffix(".0"))

    def test_the_tiles_come_before_the_inputs_on_a_narrow_page(self):
        _, found = self.tiles(narrow=True)
        order = found["tiles_before_inputs"]
        self.assertLess(order.index("tiles"), order.index("inputs"))
        self.assertFalse(any(group["open"] for group in found["groups"]))
        _, wide = self.tiles()
        self.assertNotIn("tiles", wide["tiles_before_inputs"])
        self.assertTrue(all(group["open"] for group in wide["groups"][:-1]))


class AtTheCursor(Drawn):
    """Numbers, drawings and what is computed on a button are those of the cursor's speed."""

    @classmethod
    def setUpClass(cls):
        nulls = {"friction_moment_N_m": 3.21e-5, "power_loss_W": None, "sun_thrust_N": -1.25e9, "orbit_slip": -0.0, "cage_slip": 0.125}
        steps = [cursor_put(8400), {"what": "open", "selector": "#card-point"}, {"what": "open", "selector": "#card-crown"}, click("#card-crown button"),
                 {"what": "open", "selector": "#card-assumptions"}, click("#card-assumptions button"), {"what": "open", "selector": "#card-mesh"}, {"what": "open", "selector": "#card-modes"},
                 dump("cursor"), put("#mode-choice", "translational 1"), put("#card-bearing input", "250", "input"), dump("turned"),
                 cursor_put(8600), dump("further"), cursor_put(8400), dump("back"), text_put(OTHER), dump("other")]
        rest = {"rest_a": 12345.678, "rest_b": {"inner": 0.00012346}, "rest_list": [1.5, None, 2.5], "rest_rows": [{"name": "one", "force_N": 3.25}, {"name": "two", "force_N": 4.75}],
                "rest_lists": [{"set": "", "loads_N": [1.5, 2.5]}], "rest_words": ["x", "y"], "rest_matrix": [[1.25, 2.25], [3.25, None]], "rest_text": "words"}
        cls.page = page(steps, (CASE, OTHER), results={"nulls": nulls, "run": {**RUN, **rest}})
        cls.dumps = cls.page["dumps"]
        cls.nulls = nulls
        cls.check = check_of(CASE)["check"]
        cls.derived = {one["path"]: one["value"] for one in cls.check["derived"]}

    def test_variants_come_before_the_last_card(self):
        shown = [name for name, _ in sorted(self.dumps["cursor"]["wide"], key=lambda one: one[1])]
        self.assertEqual(shown.index("variants"), len(shown) - 2, shown)

    def test_all_results_are_listed_with_units_and_meanings(self):
        rows = self.dumps["cursor"]["cards"]["point"]["tables"][0]
        point = {"input_speed_rpm": 8400.0, **{key: value_of(key, 8400.0) for key in KEYS}, **self.nulls, "status": "ok"}
        expected = {key: value for key, value in point.items() if value is not None and key != "refined"}
        self.assertEqual(len(rows), len(expected))
        order = [*KEYS, "input_speed_rpm", "status"]
        for (label, value, meaning), key in zip(rows, [key for key in order if key in expected]):
            unit = POINT.get(key, {}).get("unit", "")
            shown = expected[key] if key == "status" else figure_of(expected[key] + 0.0, unit)
            self.assertEqual((label, value, meaning), (label_of(key) if key != "status" else "status", shown, POINT.get(key, {}).get("description", "")), key)
        self.assertEqual([title for _, title in self.dumps["cursor"]["cards"]["point"]["titles"][:len(rows)]], [key for key in order if key in expected])
        texts = [row[1] for row in rows]
        self.assertIn("3.21·10⁻⁵ N m".replace("3.21", "3.210"), texts)  # the sign of an exponent
        self.assertIn("−1.250·10⁹ N", texts)
        numbers = [key for key in order if isinstance(expected.get(key), float)]
        for key, (text, value, title) in zip(numbers, self.dumps["cursor"]["cards"]["point"]["figures"]):
            unit = POINT.get(key, {}).get("unit", "")
            self.assertEqual(float(value), expected[key], key)
            self.assertEqual(title, f"{value} {'' if unit == '1' else unit}".strip(), key)  # all digits, and the unit as the program has it
        figures = {title: (text, value) for text, value, title in self.dumps["cursor"]["cards"]["point"]["figures"]}
        self.assertEqual(figures["0.0000321 N.m"], ("3.210·10⁻⁵ N m", "0.0000321"))
        self.assertEqual(self.dumps["cursor"]["cursor"], "8\u202f400 rpm")

    def test_the_rest_of_the_result(self):
        tables = self.dumps["cursor"]["cards"]["point"]["tables"]
        text = self.dumps["cursor"]["cards"]["point"]["text"]
        self.assertIn([["rest a", "12\u202f346 N", ""], ["rest text", "words", ""]], tables)
        self.assertIn([["inner", "1.235·10⁻⁴ mm", ""]], tables)
        self.assertIn([["name", "force"], ["one", "3.25"], ["two", "4.75"]], tables)
        self.assertIn([["1.25", "2.25"], ["3.25", "–"]], tables)
        self.assertIn("rest list: 3 values", text)
        self.assertIn("rest words: 2 rows", text)
        self.assertIn("rest lists: 1 row loads: 2 values", text)
        self.assertNotIn([["set"], [""]], tables)

    def test_crown_and_effects_are_of_the_cursor(self):
        asked = {one["command"]: one for one in self.page["requests"] if one["command"] in ("crown", "sensitivities")}
        for command in ("crown", "sensitivities"):
            self.assertEqual((asked[command]["settings"], asked[command]["case_text"]), (["input.speed=8400 rpm"], CASE), command)

    def test_the_crown(self):
        card = self.dumps["cursor"]["cards"]["crown"]
        self.assertEqual(card["tables"][0], [
            ["Recommended drop", "6.5 µm"], ["Range with 95 % of the life", "3.25 µm to 9.75 µm"], ["Life there, by half-space pressures", "41\u202f234 h"], ["of straight rollers", "31\u202f234 h"],
            ["Rollers", "crowned"], ["L10mrh there, by laminae", "40\u202f123 h"], ["of straight rollers", "30\u202f123 h"], ["Peak pressure there", "1\u202f717 MPa"],
            ["Peak pressure of straight rollers", "1\u202f919 MPa"]])
        self.assertIn("Design by the tile: L10mrh is 21,234 h now and 22,345 h with this drop.", card["text"].replace("\u202f", ","))
        self.assertNotIn("shortens this life", card["text"])
        known = sorted((one["drop_um"], one["governing_life_h"], one["peak_pressure_MPa"]) for one in CROWN["points"] if one["governing_life_h"])
        half, lives, pressures = card["charts"]
        drop = "drop at the end of a roller (µm)"
        self.assert_chart(half, [("life_share", "life by half-space pressures, which the recommendation goes by", [(0.0, 70.0), (6.5, 100.0), (12.0, 80.0)])], [drop, "share of the longest life (%)"])
        for chart, key, label, i, unit in ((lives, "governing_life_h", "L10mrh by laminae", 1, "L10mrh (h)"), (pressures, "peak_pressure_MPa", "peak pressure", 2, "pressure (MPa)")):
            points = [(one[0], one[i]) for one in known]
            read = self.assert_chart(chart, [(key, label, points)], [drop, unit])
            self.assert_dots(chart["curves"][0], points, read)
        for chart in card["charts"]:
            (at, y, top, label), = chart["marks"]
            self.assertEqual(label, "recommended")
            self.assertAlmostEqual(Read(chart).x(at)[0], 6.5, places=6)
            self.assertLess(y, top)

    def test_effects_on_life(self):
        card = self.dumps["cursor"]["cards"]["assumptions"]
        rows = next(table for table in card["tables"] if table[0][0] == "Input")
        self.assertEqual(rows[0], ["Input", "Value", "Life changes by, for 1 %", "Reason"])
        assumed = [one for one in self.check["inputs"] if one["standing"] != "given"]
        effects = {one["path"]: one["elasticity"] for one in SENSITIVITIES["inputs"]}
        self.assertEqual([row[0] for row in rows[1:3]], ["material.density", "life.reduction_factor"])
        self.assertEqual([rows[1][2], rows[2][2]], ["−8.5 %", "4.3 %"])
        self.assertEqual(len(rows) - 1, len(assumed))
        self.assertIn(f"{len(assumed)} assumed inputs", card["text"])
        by_path = {one["path"]: one for one in assumed}
        for path, value, effect, reason in rows[1:]:
            self.assertEqual(reason, re.sub(r"[ \n]+", " ", by_path[path]["reason"]).strip(), path)
            self.assertEqual(effect, f"{readable(effects[path], 2)} %" if effects.get(path) is not None else "", path)
            self.assertFalse(re.search(r"\d\.\d{7}", value), value)
        for warning in {*self.check["warnings"], "a warning of the run"}:
            self.assertIn(re.sub(r"[ \n]+", " ", warning), card["text"])

    def test_the_meshes(self):
        card = self.dumps["cursor"]["cards"]["mesh"]
        curves = [(f"{kind}", kind, [tuple(one) for one in mesh["curve"]]) for kind, mesh in zip(("sun-planet", "ring-planet"), MESH["meshes"][1::2])]
        self.assert_chart(card["charts"][0], curves, ["share of the mesh period", "stiffness (N/m)"])
        rows = [[kind, *(readable(mesh[key]) for key in ("contact_ratio", "mean_N_per_m", "min_N_per_m", "max_N_per_m"))] for kind, mesh in zip(("sun-planet", "ring-planet"), MESH["meshes"][1::2])]
        self.assertEqual(card["tables"][0], [["mesh", "contact ratio", "mean (N/m)", "min (N/m)", "max (N/m)"], *rows])

    def frequency(self, i, speed):
        return MODES[i]["frequency_Hz"] * (1 + speed / (9e4 + 1e4 * i))

    def test_the_campbell_diagram(self):
        chart = self.dumps["cursor"]["cards"]["modes"]["charts"][0]
        speeds = speeds_of(LOW, HIGH, 9)
        mesh = self.derived["gearset.dynamics.mesh_frequency"]
        own = [("rotational 1", "rotational mode", 0, "c1", "1. rotational mode"), ("translational 1", "translational mode", 1, "c2", "1. translational mode"),
               ("translational 2", "", 1, "c2", "2. translational mode"), ("planet 1", "planet mode", 3, "c3", "1. planet mode")]
        top = max(self.frequency(3, speed) for speed in speeds)
        curves = []
        for name, label, i, _, _ in own:
            same = "same curve as translational mode" if name == "translational 2" else ""
            curves.append((name, label and label + same, [(speed, self.frequency(i, speed)) for speed in speeds]))
        for order in (1, 2, 3):
            ends = [min(speed, 1.05 * top * SPEED / (order * mesh)) for speed in (LOW, HIGH)]
            curves.append((f"mesh {order}", "mesh frequency" if order == 1 else f"{order} × mesh frequency", [(speed, order * mesh * speed / SPEED) for speed in ends]))
        read = self.assert_chart(chart, curves, [OVER, "frequency (Hz)"], **{name: {"colour": colour, "title": title} for name, _, _, colour, title in own},
                                 **{"mesh 1": {"colour": "c8", "dash": None}, "mesh 2": {"dash": "6 3"}, "mesh 3": {"dash": "2 3"}})
        for curve, (name, _, points) in zip(chart["curves"][:4], curves):
            self.assert_dots(curve, points, read)
        self.assertEqual(self.dumps["cursor"]["options"]["mode-choice"], ["rotational 1", "translational 1", "translational 2", "planet 1"])

    def test_the_shape_of_a_mode(self):
        text = self.dumps["turned"]["cards"]["modes"]["text"]
        self.assertIn(f"Translational mode at {figure_of(self.frequency(1, 8400.0), 'Hz')}, one of 2 of this frequency.", text)
        self.assertIn(f"Translational mode at {figure_of(self.frequency(1, 8600.0), 'Hz')}, one of 2", self.dumps["further"]["cards"]["modes"]["text"])  # the same one at another speed
        self.assertIn(f"Rotational mode at {figure_of(self.frequency(0, 8400.0), 'Hz')}. Largest", self.dumps["cursor"]["cards"]["modes"]["text"])
        distance = self.derived["gearset.centre_distance"]
        drawing = next(one for one in self.dumps["turned"]["drawings"] if "shape" in one["class"])
        size = 0.22 * distance
        self.assertIn(f"Largest displacement drawn as {readable(size, 2)} mm", text)
        pressure, module = math.radians(20), 3.0
        shape = MODES[1]["shape"]
        for name, row, teeth in (("sun", 0, 37), ("ring", 1, 79)):
            x, y, u = (size * value for value in shape[row])
            turn = math.degrees(u / (module * teeth / 2 * math.cos(pressure)))
            self.assert_placed(drawing, f"moved {name}-moved", [(-y, -x, -turn)])
        planets = []
        for i in range(4):
            place, (out, along, u) = math.pi / 2 * i, (size * value for value in shape[3])
            x = (distance + out) * math.cos(place) - along * math.sin(place)
            y = (distance + out) * math.sin(place) + along * math.cos(place)
            planets.append((-y, -x, -math.degrees(place + u / (module * 22 / 2 * math.cos(pressure)))))
        self.assert_placed(drawing, "moved planet-moved", planets)
        still = [[float(part[key]) for key in ("r", "cx", "cy")] for part in drawing["parts"] if part.get("class") == "still"]
        expected = [[118.5, 0, 0], [55.5, 0, 0], *([33.0, -distance * math.sin(math.pi / 2 * i), -distance * math.cos(math.pi / 2 * i)] for i in range(4))]
        for one, other in zip(still, expected, strict=True):
            self.assert_numbers(one, other)
        self.assert_numbers([float(one) for one in drawing["viewBox"].split()], [-1.3 * 118.5, -1.3 * 118.5, 2.6 * 118.5, 2.6 * 118.5])
        bodies = [(float(part["r"]), part["path"]) for part in drawing["parts"] if part["name"] == "circle" and part["path"].startswith("moved")]
        self.assertEqual(bodies, [(118.5, "moved ring-moved")] + [(33.0, "moved planet-moved")] * 4 + [(55.5, "moved sun-moved")])
        (cx, cy, u), arm = (size * value for value in shape[2]), next(one for one in drawing["parts"] if one.get("class") == "carrier")["d"]
        numbers = [float(one) for one in re.findall(r"-?[\d.]+", arm)]
        for i in range(4):
            angle = math.pi / 2 * i + u / distance
            for found, value in zip(numbers[4 * i:4 * i + 4], (-cy, -cx, -distance * math.sin(angle), -distance * math.cos(angle))):
                self.assertAlmostEqual(found, value, delta=1e-3)

    def assert_placed(self, drawing, name, expected):
        found = [[float(one) for one in re.findall(r"-?[\d.]+", part["transform"])] for part in drawing["parts"] if part.get("class") == name]
        self.assertEqual(len(found), len(expected), name)
        for one, other in zip(found, expected):
            for a, b in zip(one, other):
                self.assertAlmostEqual(a, b, delta=1e-3, msg=name)

    def rolling(self, speed):
        """Cage, outer ring and spin in the carrier, with the slip of the point."""
        outer, ratio = self.derived["operation.planet_speed"] * speed / SPEED, 5.24 / 35.64
        cage = outer * (1 + ratio) / 2 * (1 - 0.125)
        return cage, outer, cage + outer * (1 - ratio**2) / (2 * ratio)

    def test_the_bearing_is_to_scale_at_the_speed_of_the_cursor(self):
        cage, outer, spin = self.rolling(8400.0)
        for name in ("cursor", "turned"):
            text = self.dumps[name]["cards"]["bearing"]["text"]
            self.assertIn(f"Cage {figure_of(cage, 'rpm')} in the carrier, outer ring {figure_of(outer, 'rpm')}, rollers about their axes {figure_of(spin, 'rpm')}. "
                          f"Slowed {readable(abs(cage) / 60 * 4, 3)} times. Bars: load of each roller, outward on the outer race, inward on the inner race.", text)
        turn, sense = 0.25, math.copysign(1, cage)
        drawing = next(one for one in self.dumps["turned"]["drawings"] if one["aria-label"] == "Bearing to scale with the load of each roller")
        half = (1.2 + 0.34) * 47 / 2
        self.assertEqual([float(one) for one in drawing["viewBox"].split()], [-half, -half, 2 * half, 2 * half])
        largest = max(ROLLERS[0]["inner_load_N"])
        elements = [part for part in drawing["parts"] if part.get("class", "").startswith("element")]
        self.assertEqual([part["class"] for part in elements], ["element first"] + ["element"] * 14)
        step, loads = 360 / ROLLER, ROLLERS[0]

        def load_at(race, degrees):
            place = degrees % 360 / step
            i, rest = int(place) % ROLLER, place - int(place)
            return loads[f"{race}_load_N"][i] * (1 - rest) + loads[f"{race}_load_N"][(i + 1) % ROLLER] * rest

        bars = {race: [part for part in drawing["parts"] if part.get("class") == f"bar {race}"] for race in ("inner", "outer")}
        for j, part in enumerate(elements):
            degrees = 360 * turn * sense + step * j
            x, y, rotation = (float(one) for one in re.findall(r"-?[\d.]+", part["transform"]))
            self.assertAlmostEqual(x, -35.64 / 2 * math.sin(math.radians(degrees)), delta=1e-4)
            self.assertAlmostEqual(y, -35.64 / 2 * math.cos(math.radians(degrees)), delta=1e-4)
            self.assertAlmostEqual(math.cos(math.radians(rotation + 360 * turn * sense * spin / cage)), 1, delta=1e-8, msg="rotation of a roller")
            both = {race: load_at(race, degrees) for race in ("inner", "outer")}
            self.assertAlmostEqual(float(part["share"]), max(both.values()) / largest, places=9)
            for race, foot, sign in (("outer", 1.03 * 47 / 2, 1), ("inner", 0.97 * (35.64 - 5.24) / 2, -1)):
                bar = bars[race][j]
                self.assertAlmostEqual(float(bar["data-load"]), both[race], places=9)
                end = foot + sign * both[race] * 0.34 * 47 / 2 / largest
                inner_foot = math.hypot(float(bar["x1"]), float(bar["y1"]))
                if race == "outer":
                    self.assertAlmostEqual(inner_foot, foot, delta=1e-3)
                self.assertAlmostEqual(math.hypot(float(bar["x2"]), float(bar["y2"])) - inner_foot, end - foot, delta=1e-3)
                self.assertAlmostEqual(float(bar["x1"]) / inner_foot, -math.sin(math.radians(degrees)), delta=1e-4)
        text = next(part for part in drawing["parts"] if part["name"] == "text" and part["text"].endswith(" N"))
        self.assertEqual(text["text"], f"{readable(largest)} N")
        self.assertEqual({part["text"] for part in drawing["parts"] if part["name"] == "text"}, {text["text"], "outward", "to the sun"})
        circles = {part["r"] for part in drawing["parts"] if part["name"] == "circle"}
        self.assertEqual(circles, {"2.62"})
        lines = {name: [[float(part[key]) for key in ("x1", "y1", "x2", "y2")] for part in drawing["parts"] if part["name"] == "line" and part["path"].split()[0] == name]
                 for name in ("marks", "cage", "scale", "element")}
        self.assertEqual(lines["element"], [[0.0, 0.0, 0.0, -0.85 * 5.24 / 2]] * ROLLER)
        marks = []
        for small, large in ((float(self.derived["bearing.outer_raceway_diameter"]), 47.0), (25.0, float(self.derived["bearing.inner_raceway_diameter"]))):
            for i in range(12):
                depth, angle = (0.6 if i == 0 else 0.25) * (large - small) / 2, math.pi / 6 * i
                high = (large + small) / 4 + depth / 2
                marks.append([-high * math.sin(angle), -high * math.cos(angle), -(high - depth) * math.sin(angle), -(high - depth) * math.cos(angle)])
        self.assertEqual(len(lines["marks"]), len(marks))
        for one, other in zip(lines["marks"], marks):
            self.assert_numbers(one, other)
        for j, one in enumerate(lines["cage"]):
            angle = 2 * math.pi * (j + 0.5) / ROLLER
            self.assert_numbers(one, [-33.44 / 2 * math.sin(angle), -33.44 / 2 * math.cos(angle), -38.54 / 2 * math.sin(angle), -38.54 / 2 * math.cos(angle)])
        self.assertEqual(len(lines["cage"]), ROLLER)
        right, long = 1.44 * 47 / 2, 0.34 * 47 / 2
        self.assert_numbers(lines["scale"][0], [right - long, right, right, right])
        rings = [part["d"] for part in drawing["parts"] if part.get("class") == "ring"]
        self.assertEqual([[float(one) for one in re.findall(r"M(-?[\d.]+)", d)] for d in rings], [[-23.5, -float(self.derived["bearing.outer_raceway_diameter"]) / 2],
                                                                                              [-float(self.derived["bearing.inner_raceway_diameter"]) / 2, -12.5]])
        cages = [[float(one) for one in re.findall(r"M(-?[\d.]+)", part["d"])] for part in drawing["parts"] if part.get("class") == "cage-ring"]
        self.assertEqual(cages, [[-38.54 / 2, -33.44 / 2]])
        for name, speed in (("outer-ring", outer), ("inner-ring", 0.0), ("cage", cage)):
            part = next(one for one in drawing["parts"] if one.get("class") == name)
            rotation = float(re.search(r"rotate\((-?[\d.]+)\)", part["transform"])[1])
            self.assertAlmostEqual(math.cos(math.radians(rotation + 360 * turn * sense * speed / cage)), 1, delta=1e-8, msg=name)

    def test_the_gears_are_to_scale_at_the_speed_of_the_cursor(self):
        flow = {one["member"]: one["speed_rpm"] * 8400.0 / SPEED for one in self.check["power_flow"]}
        distance = self.derived["gearset.centre_distance"]
        text = self.dumps["cursor"]["cards"]["gears"]["text"]
        planet = self.derived["operation.planet_speed"] * 8400.0 / SPEED
        self.assertIn(f"Sun {figure_of(flow['sun'], 'rpm')}, ring {figure_of(flow['ring'], 'rpm')}, carrier {figure_of(flow['carrier'], 'rpm')}, "
                      f"planet in the carrier {figure_of(planet, 'rpm')}. Centre distance {readable(distance, 5)} mm.", text)
        drawing = next(one for one in self.dumps["cursor"]["drawings"] if "gears" in one["class"])
        shift = {"sun": 0.2618, "ring": 0.4146, "planet": self.derived["gearset.profile_shift.planet"]}
        for name, teeth, sign in (("sun", 37, 1), ("planet", 22, 1), ("ring", 79, -1)):
            outline = next(one for one in drawing["parts"] if one.get("class") == f"gear {name}-gear")["d"]
            outline = outline[outline.rindex("M"):]
            points = [tuple(map(float, pair.split(","))) for pair in outline.strip("MZ").split("L")]
            self.assertEqual(len(points), 12 * teeth)
            radii = [math.hypot(*one) for one in points]
            reference = 3.0 * teeth / 2
            tip, root = reference + 3 * (shift[name] + sign), reference + 3 * (shift[name] - 1.25 * sign)
            self.assertAlmostEqual(max(radii), max(tip, root), delta=2e-3)
            self.assertAlmostEqual(min(radii), min(tip, root), delta=2e-3)
            flank = [(math.hypot(*one), math.atan2(-one[0], -one[1])) for one in points[:12]]
            middle = 0.0 if sign > 0 else math.pi / teeth
            for radius, angle in flank:
                base = reference * math.cos(math.radians(20))
                at = math.acos(min(1, base / max(radius, base)))
                half = max(0.0, (math.pi / 2 + 2 * shift[name] * math.tan(math.radians(20))) / teeth + self.involute(math.radians(20)) - self.involute(at))
                self.assertAlmostEqual(abs(angle - middle), half, delta=2e-3 / radius + 1e-4)
        planets = [one for one in drawing["parts"] if one.get("transform", "").startswith("translate") and one["path"] == "machine gears"]
        places = [[float(value) for value in re.findall(r"-?[\d.]+", one["transform"])] for one in planets]
        sun, around = places[1], places[2:6]
        self.assertEqual(sun, [0.0, 0.0, sun[2]])
        self.assertAlmostEqual(sun[2], 0.0)
        for i, (x, y, rotation) in enumerate(around):
            place = math.pi / 2 * i
            self.assertAlmostEqual(x, -distance * math.sin(place), delta=2e-3)
            self.assertAlmostEqual(y, -distance * math.cos(place), delta=2e-3)
            # A gap of the planet faces a tooth of the sun: the tooth nearest to the sun's middle stands half a pitch beside.
            own = place + math.pi + place * 37 / 22 - math.pi / 22
            self.assertAlmostEqual(math.sin(math.radians(-rotation) - own), 0, delta=1e-4)
        circles = {part["class"]: float(part["r"]) for part in drawing["parts"] if part["name"] == "circle" and part["class"] in ("bore", "pin")}
        self.assertEqual(circles, {"bore": 23.5, "pin": 12.5})
        root = {name: 3.0 * teeth / 2 + 3 * (shift[name] - 1.25) for name, teeth in (("sun", 37), ("planet", 22))}
        dots = [(float(part["r"]), float(part["cx"]), round(float(part["cy"]), 9)) for part in drawing["parts"] if part.get("class") == "dot"]
        self.assertEqual(dots, [(1.5, 0.0, round(-0.7 * root["sun"], 9))] + [(1.5, 0.0, round(-(root["planet"] + 23.5) / 2, 9))] * 4)
        outside = 3.0 * 79 / 2 + 3 * (shift["ring"] + 1.25) + 2.5 * 3
        self.assert_numbers([float(one) for one in drawing["viewBox"].split()], [-1.03 * outside, -1.03 * outside, 2.06 * outside, 2.06 * outside])
        ring = next(one for one in drawing["parts"] if one.get("class") == "gear ring-gear")["d"]
        self.assertAlmostEqual(float(re.match(r"M(-?[\d.]+),0a", ring)[1]), -outside, places=6)
        arms = [float(one) for one in re.findall(r"-?[\d.]+", next(part for part in drawing["parts"] if part.get("class") == "carrier")["d"])]
        self.assert_numbers(arms, sum(([0, 0, -distance * math.sin(math.pi / 2 * i), -distance * math.cos(math.pi / 2 * i)] for i in range(4)), []), 1e-3)

    def assert_numbers(self, found, expected, delta=1e-6):
        self.assertEqual(len(found), len(expected))
        for one, other in zip(found, expected):
            self.assertAlmostEqual(one, other, delta=delta)

    @staticmethod
    def involute(angle):
        return math.tan(angle) - angle

    def test_results_are_marked_beside_another_case_and_shown_again(self):
        for card in ("crown", ):
            self.assertNotIn("Of another case", self.dumps["cursor"]["cards"][card]["text"])
            self.assertIn("Of another case: input.speed 8400 rpm there, 8600 rpm here.", self.dumps["further"]["cards"][card]["text"])
            self.assertNotIn("Of another case", self.dumps["back"]["cards"][card]["text"])
            self.assertIn("Of another case: input.power 150 kW there, 0.123457 MW here.", self.dumps["other"]["cards"][card]["text"])
        rows = {name: next(table for table in self.dumps[name]["cards"]["assumptions"]["tables"] if table[0][0] == "Input")[0] for name in ("cursor", "further", "back", "other")}
        self.assertEqual([len(rows[name]) for name in ("cursor", "further", "back", "other")], [4, 3, 4, 3])
        self.assertEqual(sum(one["command"] == "crown" for one in self.page["requests"]), 1)
        self.assertEqual([one["case_text"] for one in self.page["requests"] if one["command"] == "mesh"], [CASE, OTHER])


class Moved(Drawn):
    """What is played and dragged."""

    def test_bearing_and_gears_are_played(self):
        found = page([click("#card-bearing .play"), {"what": "frames", "times": [500, 1500, 2500]}, dump("playing"), click("#card-bearing .play"), {"what": "frames", "times": [9000, 9900]}, dump("paused"),
                      put("#card-bearing .player select", "16"), dump("slower")])["dumps"]
        self.assertEqual([re.search(r"(Play|Pause) one revolution of the cage in", found[name]["cards"]["bearing"]["text"])[1] for name in ("playing", "paused")], ["Pause", "Play"])
        flow = {one["member"]: one["speed_rpm"] for one in check_of(CASE)["check"]["power_flow"]}
        planet = next(one["value"] for one in check_of(CASE)["check"]["derived"] if one["path"] == "operation.planet_speed")
        turn, sense = 2.0 / 4, math.copysign(1, planet * (1 - value_of("cage_slip", SPEED)))
        self.assertEqual(found["playing"]["players"]["bearing"], str(round(1000 * turn)))
        for name in ("playing", "paused"):
            drawings = found[name]["drawings"]
            bearing = next(one for one in drawings if one["aria-label"].startswith("Bearing to scale"))
            first = next(part for part in bearing["parts"] if part.get("class") == "element first")
            x, y, _ = (float(one) for one in re.findall(r"-?[\d.]+", first["transform"]))
            self.assertAlmostEqual(x, -35.64 / 2 * math.sin(2 * math.pi * turn * sense), delta=1e-3)
            self.assertAlmostEqual(y, -35.64 / 2 * math.cos(2 * math.pi * turn * sense), delta=1e-3)
            if name == "playing":
                continue  # the gears follow by a frame
            gears = next(one for one in drawings if "gears" in one["class"])
            places = [[float(value) for value in re.findall(r"-?[\d.]+", part["transform"])] for part in gears["parts"] if part.get("transform", "").startswith("translate")]
            slowed = turn / 4 * 2 * math.pi / max(map(abs, flow.values()))
            self.assertAlmostEqual(math.cos(math.radians(places[1][2]) + slowed * flow["sun"]), 1, delta=1e-9)
            distance = next(one["value"] for one in check_of(CASE)["check"]["derived"] if one["path"] == "gearset.centre_distance")
            for i, (x, y, rotation) in enumerate(places[2:6]):
                place = math.pi / 2 * i + slowed * flow["carrier"]
                self.assertAlmostEqual(x, -distance * math.sin(place), delta=2e-3)
                self.assertAlmostEqual(y, -distance * math.cos(place), delta=2e-3)
                # Teeth roll on the sun: the planet turns back by the ratio of the teeth.
                own = place + math.pi - (slowed * flow["sun"] - place) * 37 / 22 - math.pi / 22
                self.assertAlmostEqual(math.sin(math.radians(-rotation) - own), 0, delta=1e-4)
            self.assertAlmostEqual(math.cos(79 * (math.radians(places[0][2]) + self.ring_of(slowed, flow))), 1, delta=1e-5)
            self.assertAlmostEqual(math.cos(79 * math.radians(places[0][2])), 1, delta=1e-5)  # a ring at rest stands still, up to a tooth
            arms = [float(one) for one in re.findall(r"-?[\d.]+", next(part for part in gears["parts"] if part.get("class") == "carrier")["d"])]
            self.assertAlmostEqual(arms[2], -distance * math.sin(slowed * flow["carrier"]), delta=2e-3)
        speed = abs(planet * (1 + 5.24 / 35.64) / 2 * (1 - value_of("cage_slip", SPEED)))
        self.assertIn(f"Slowed {readable(speed / 60 * 16, 3)} times.", found["slower"]["cards"]["bearing"]["text"])

    @staticmethod
    def ring_of(slowed, flow):
        """A gap of the ring faces the tooth of the first planet."""
        place = slowed * flow["carrier"]
        planet = place + math.pi - (slowed * flow["sun"] - place) * 37 / 22 - math.pi / 22
        return place + (planet - place) * 22 / 79 + math.pi / 79

    def test_the_shape_of_a_mode_swings(self):
        found = page([{"what": "open", "selector": "#card-modes"}, put("#mode-choice", "translational 1"), click("#card-modes .play"), {"what": "frames", "times": [100, 600]}, dump("swung"),
                      put("#card-modes .player input", "50", "input"), dump("half")])["dumps"]
        distance = next(one["value"] for one in check_of(CASE)["check"]["derived"] if one["path"] == "gearset.centre_distance")
        for name, factor in (("swung", 1.0), ("half", 0.5)):
            drawing = next(one for one in found[name]["drawings"] if "shape" in one["class"])
            x, y, _ = (float(one) for one in re.findall(r"-?[\d.]+", next(part for part in drawing["parts"] if part.get("class") == "moved sun-moved")["transform"]))
            angle = 2 * math.pi * 0.5 / 2  # half a second of two a period
            values = [0.22 * distance * factor * (a * math.cos(angle) + b * math.sin(angle)) for a, b in zip(MODES[1]["shape"][0], MODES[1]["shape_quarter"][0])]
            self.assertAlmostEqual(-y, values[0], delta=1e-3)
            self.assertAlmostEqual(-x, values[1], delta=1e-3)
            self.assertIn(f"Largest displacement drawn as {readable(0.22 * distance * factor, 2)} mm", found[name]["cards"]["modes"]["text"])

    def test_the_cursor_is_dragged_in_a_chart(self):
        left, right = 76, 640 - 22
        at = {rpm: left + (right - left) * (rpm - LOW) / (HIGH - LOW) for rpm in (8500, 9250)}
        found = page([{"what": "event", "selector": "#card-loads .chart", "event": "pointerdown", "data": {"buttons": 1, "clientX": at[8500], "clientY": 50, "pointerId": 1}}, dump("pressed"),
                      {"what": "event", "selector": "#card-loads .chart", "event": "pointermove", "data": {"buttons": 1, "clientX": at[9250], "clientY": 50}}, dump("dragged"),
                      {"what": "event", "selector": "#card-loads .chart", "event": "pointermove", "data": {"buttons": 0, "clientX": 300, "clientY": 50}}, dump("left"),
                      {"what": "event", "selector": "#card-loads .chart", "event": "pointermove", "data": {"buttons": 1, "clientX": 5000, "clientY": 50}}, dump("beyond")])
        dumps = found["dumps"]
        self.assertEqual([dumps[name]["cursor"] for name in ("pressed", "dragged", "left", "beyond")], ["8\u202f500 rpm", "9\u202f250 rpm", "9\u202f250 rpm", "10\u202f000 rpm"])
        for name, rpm in (("pressed", 8500), ("dragged", 9250), ("beyond", 10000)):
            for card in ("life", "loads", "roller-loads"):
                chart = dumps[name]["cards"][card]["charts"][0]
                (pixel, value), = chart["cursor"]
                self.assertEqual(value, rpm)
                self.assertAlmostEqual(Read(chart).x(pixel)[0], rpm, delta=1e-6)
        self.assertEqual([one["settings"] for one in found["requests"] if one["command"] == "run"][1:], [["input.speed=8500 rpm"], ["input.speed=9250 rpm"], ["input.speed=10000 rpm"]])

    def test_a_curve_of_the_campbell_diagram_is_pressed(self):
        first = page([{"what": "open", "selector": "#card-modes"}, dump()])["dumps"]["end"]["cards"]["modes"]["charts"][0]
        curve = next(one for one in first["curves"] if one["key"] == "planet 1")
        x, y = curve["paths"][0][4]
        found = page([{"what": "open", "selector": "#card-modes"}, {"what": "event", "selector": "#card-modes .chart", "event": "pointerdown", "data": {"buttons": 1, "clientX": x, "clientY": y, "pointerId": 1}}, dump()])
        self.assertIn("Planet mode at ", found["dumps"]["end"]["cards"]["modes"]["text"])


class Compared(Drawn):
    """Pinned variants beside the case: inputs, results and percentages."""

    @classmethod
    def setUpClass(cls):
        third = CASE.replace("radial_clearance: 10 um", "radial_clearance: 30 um")
        cls.page = page([click("[data-pin=A]"), text_put(OTHER), click("[data-pin=B]"), text_put(third), cursor_put(8400), dump(), click("[data-take=A]"), dump("taken"), click("[data-drop=A]"),
                         dump("dropped")], (CASE, OTHER, third))
        cls.dumps = cls.page["dumps"]

    def test_inputs_and_results(self):
        card = self.dumps["end"]["cards"]["variants"]
        rows = card["tables"][0]
        self.assertEqual(rows[0], ["", "now", "A", "B"])
        self.assertEqual(rows[1:3], [["input.power", "150 kW", "150 kW", "0.123457 MW"], ["bearing.radial_clearance", "30 um", "10 um", "10 um"]])
        results = {row[0]: row[1:] for row in rows[3:]}
        keys = [key for key in KEYS if re.match(r"(life_h|L10|system_life_h|planet_load_N|inner_load_max_N|contact_pressure_max_MPa|C_over_P|S0|kappa|a_ISO|operating_clearance_um|film_inner_um|cage_slip|power_loss_W)", key)]
        self.assertEqual([row[0] for row in rows[3:]], [label_of(key) for key in keys])
        for key in keys:
            unit = POINT[key].get("unit", "")
            now, first, second = value_of(key, 8400.0, 2), value_of(key, SPEED, 0), value_of(key, SPEED, 1)

            def told(value, now=now, unit=unit):
                percent = 100 * (value / now - 1)
                change = "" if abs(percent) < 0.005 else f" ({'+' if percent > 0 else '−'}{readable(abs(percent), 2)} %)"
                return figure_of(value, unit) + change
            self.assertEqual(results[label_of(key)], [figure_of(now, unit), told(first), told(second)], key)
        self.assertIn("Results of A are those at its own cursor, 9000 rpm.", card["text"])
        self.assertNotRegex(" ".join(sum(rows, [])), r"\d{7}\.|\.\d{7}")

    def test_they_are_taken_and_removed(self):
        self.assertEqual(self.dumps["taken"]["text"], CASE)
        self.assertEqual([row[0] for row in self.dumps["dropped"]["cards"]["variants"]["tables"][0][1:2]], ["input.power"])
        self.assertEqual(self.dumps["dropped"]["cards"]["variants"]["tables"][0][0], ["", "now", "B"])
        self.assertTrue(self.dumps["dropped"]["buttons"]["A"]["shown"])


class Motion(Drawn):
    """A dynamic run belongs to the case that it was computed for."""

    KEYS = ("cage_slip", "roller_slip", "orbit_slip", "drag_slip")

    @classmethod
    def setUpClass(cls):
        now = {"angle_deg": [360 * j / ROLLER for j in range(ROLLER)], "spin_rpm": [1200.0 + j for j in range(ROLLER)], "inner_load_N": [10.0 + j for j in range(ROLLER)],
               "outer_load_N": [20.0 + j for j in range(ROLLER)], "cage_um": [3.0, 4.0], "cage_turned_deg": 30.0, "cage_rpm": 950.0, "rolling_cage_rpm": 1000.0, "time_s": 0.1, "expected_s": 0.4,
               "most_s": 0.8, "run": 2, "most_runs": 5}
        steps = [put("#fidelity", "dynamic"), click("#card-motion .chief"), {"what": "tell", "event": "progress", "data": {"done": 1, "all": 16, "seconds_left": 12.34, "doing": ""}}, dump("running"),
                 {"what": "points", "speeds": [9000.0, 8000.0], "which": 0}, {"what": "tell", "event": "motion", "data": now},
                 {"what": "tell", "event": "motion", "data": {**now, "time_s": 0.2, "cage_turned_deg": 600.0, "cage_um": [5.0, 6.0]}}, dump("moving"),
                 {"what": "click", "selector": "#card-motion .stop"}, dump("stopped"), text_put(OTHER), dump("other"), text_put(CASE + "# the same again\n"), dump("again"),
                 {"what": "click", "selector": "#card-motion .proceed"}, {"what": "points", "speeds": [10000.0], "which": 0}, text_put(OTHER), dump("while"),
                 {"what": "tell", "event": "result", "data": {"points": []}}, dump("done elsewhere"), click("#card-motion .back"), dump("done")]
        cls.page = page(steps, (CASE, OTHER, CASE + "# the same again\n"))
        cls.dumps = cls.page["dumps"]

    def state(self, name):
        buttons = self.dumps[name]["buttons"]
        return [not buttons[one]["disabled"] for one in ("Start", "Stop", "Continue")], buttons["Back to the case of these points"]["shown"]

    def text(self, name):
        return self.dumps[name]["cards"]["motion"]["text"]

    def test_buttons_and_words(self):
        self.assertEqual(self.state("running"), ([False, True, False], False))
        self.assertIn("1 of 16 points done, 12 s to go", self.text("running"))
        self.assertEqual(self.state("stopped"), ([True, False, True], False))
        self.assertIn("Stopped: 2 of 16 points kept.", self.text("stopped"))
        self.assertEqual(self.state("other"), ([True, False, False], True))
        self.assertIn("Stopped: 2 of 16 points kept. Of another case: input.power 150 kW there, 0.123457 MW here.", self.text("other"))
        self.assertEqual(self.state("again"), ([True, False, True], False))
        self.assertIn("Stopped: 2 of 16 points kept.", self.text("again"))
        self.assertNotIn("Of another case", self.text("again"))
        self.assertEqual(self.state("while"), ([False, True, False], True))
        self.assertIn("Of another case: input.power 150 kW there", self.text("while"))
        self.assertEqual(self.state("done elsewhere"), ([True, False, False], True))
        self.assertEqual(self.dumps["done"]["text"], CASE)
        self.assertIn("Done: 3 points.", self.text("done"))

    def test_curves_are_those_of_the_case(self):
        for name, speeds in (("moving", [8000.0, 9000.0]), ("stopped", [8000.0, 9000.0]), ("again", [8000.0, 9000.0]), ("done", [8000.0, 9000.0, 10000.0])):
            slips, losses = self.dumps[name]["cards"]["motion"]["charts"][-2:]
            expected = [(key, label_of(key), swept(key, speeds=speeds)) for key in self.KEYS]
            read = self.assert_chart(slips, expected, [OVER, "slip"])
            for curve, (_, _, points) in zip(slips["curves"], expected):
                self.assert_dots(curve, points, read)
            keys = [key for key in KEYS if key.startswith("power_loss")]
            self.assert_chart(losses, [(key, label_of(key).replace("power loss ", ""), swept(key, speeds=speeds)) for key in keys], [OVER, "loss (W)"])
            life = self.dumps[name]["cards"]["life"]["charts"][0]
            moving = next(one for one in life["curves"] if one["key"] == "L10mrh dynamic")
            self.assertEqual([(a, b) for _, _, a, b in moving["dots"]], swept("L10mrh", speeds=speeds))
            self.assertIn(("L10mrh, dynamic", "c5", 1), [(one["text"], one["colour"], one["dot"]) for one in life["legend"]])
        for name in ("other", "while"):
            self.assertEqual(self.dumps[name]["cards"]["motion"]["charts"], [])
            self.assertFalse([one for one in self.dumps[name]["cards"]["life"]["charts"][0]["curves"] if "dynamic" in one["key"]])

    def test_a_case_of_one_speed_runs_at_the_cursor(self):
        plain = CASE.replace("sweep:\n  input.speed: [8000 rpm, 9000 rpm, 10000 rpm]\n", "")
        found = page([put("#cursor", "500", "input"), click("#card-motion .chief"), cursor_put(8100), dump("at")], (plain,))
        low, high = SPEED / 5, SPEED * 2
        self.assertEqual(found["jobs"][0]["settings"], [f"sweep={{input.speed: [{low + (high - low) / 2:g} rpm]}}"])
        self.assertIn(", at the speed of the cursor. ", found["dumps"]["at"]["cards"]["motion"]["text"])
        self.assertIn(", at the speeds of the case's own sweep. ", self.text("stopped"))

    def test_what_is_asked_for(self):
        first, stopped, second = self.page["jobs"][:3]
        self.assertEqual((first["command"], first["settings"], first["options"], first["case_text"]), ("sweep", [], {"fidelity": "dynamic", "grid_only": True}, CASE))
        self.assertEqual(stopped, {"stopped": "jobs/1"})
        self.assertEqual({**second, "continue": None}, {**first, "continue": None})
        self.assertEqual(second["continue"], "1")

    def test_the_bearing_in_motion(self):
        text = self.text("moving")
        self.assertIn("0.2 s of motion, 3.17 revolutions of the cage, slip 5 %.", text)
        self.assertIn("50 % of run 2 of at most 5 done.", text)
        # The state of the computation is pure rolling of the cage at 1000 rpm in the carrier.
        derived = {one["path"]: one["value"] for one in check_of(CASE)["check"]["derived"]}
        planet, half = derived["operation.planet_speed"] / SPEED, (1 + 5.24 / 35.64) / 2
        self.assertIn(f"At {readable(1000.0 / abs(planet * half))} rpm: 0.2 s of motion,", text)
        drawing = next(one for one in self.dumps["moving"]["drawings"] if one["aria-label"] == "Bearing in motion, as computed now")
        elements = [part for part in drawing["parts"] if part.get("class", "").startswith("element")]
        for j, part in enumerate(elements):
            x, y, spun = (float(one) for one in re.findall(r"-?[\d.]+", part["transform"]))
            angle = 2 * math.pi * j / ROLLER
            self.assertAlmostEqual(x, -35.64 / 2 * math.sin(angle), delta=1e-3)
            self.assertAlmostEqual(y, -35.64 / 2 * math.cos(angle), delta=1e-3)
            self.assertAlmostEqual(math.cos(math.radians(spun + 6 * (1200.0 + j) * 0.1)), 1, delta=1e-6)
            self.assertAlmostEqual(float(part["share"]), (20.0 + j) / 34.0, places=9)
        cage = next(part for part in drawing["parts"] if part.get("class") == "cage")["transform"]
        self.assertEqual([float(one) for one in re.findall(r"-?[\d.]+", cage)], [-0.006, -0.005, -240.0])
        ring = re.search(r"rotate\((-?[\d.]+)\)", next(part for part in drawing["parts"] if part.get("class") == "outer-ring")["transform"])[1]
        self.assertAlmostEqual(math.cos(math.radians(float(ring) + 6 * 1000.0 / half * 0.2)), 1, delta=1e-6)


class Session(Drawn):
    """Speeds that a case sweeps in any unit; power, torque and torque over speed, one from another."""

    def test_units_of_the_swept_speeds(self):
        for text, low, high in (("[800 rad/s, 1000 rad/s]", 800 * RPM, 1000 * RPM), ("[48000 deg/s, 60000 deg/s]", 8000.0, 10000.0), ("{from: 8 krpm, to: 10 krpm, step: 1 krpm}", 8000.0, 10000.0)):
            case = CASE.replace("[8000 rpm, 9000 rpm, 10000 rpm]", text)
            found = page([dump(narrowly=["cursor"])], (case,))
            speeds = re.findall(r"([\d.]+) rpm", [one for one in found["requests"] if one["command"] == "sweep"][-1]["settings"][0])
            self.assertEqual((float(speeds[0]), float(speeds[-1])), (float(f"{low:.5g}"), float(f"{high:.5g}")), text)
        own = page([dump(narrowly=["cursor"])], (CASE.replace("sweep:\n  input.speed: [8000 rpm, 9000 rpm, 10000 rpm]\n", ""),))
        speeds = re.findall(r"([\d.]+) rpm", [one for one in own["requests"] if one["command"] == "sweep"][-1]["settings"][0])
        self.assertEqual((float(speeds[0]), float(speeds[-1])), (SPEED / 5, SPEED * 2))

    def test_power_and_torque_say_the_same(self):
        torque = 150e3 / (SPEED / RPM)
        found = page([click("[data-instead='input.torque']"), dump("torque"), text_put(CASE), click("[data-instead='input.torque_curve']"), dump("curve")], (CASE,))
        stated = re.search(r"torque: ([\d.]+) N\.m", found["dumps"]["torque"]["text"])
        self.assertAlmostEqual(float(stated[1]) / torque, 1, delta=1e-11)
        rows = re.findall(r"\[([\d.]+) rpm, ([\d.]+) N\.m\]", found["dumps"]["curve"]["text"])
        self.assertEqual([float(one) for one, _ in rows], [8000.0, 9000.0, 10000.0])
        for rpm, one in rows:
            self.assertAlmostEqual(float(one) * float(rpm) / RPM / 150e3, 1, delta=1e-11)

    def test_a_new_speed_moves_cursor_and_curve(self):
        plain = CASE.replace("sweep:\n  input.speed: [8000 rpm, 9000 rpm, 10000 rpm]\n", "")
        faster = plain.replace("speed: 9000 rpm", "speed: 12000 rpm")
        found = page([text_put(faster), dump()], (plain, faster))
        chart = found["dumps"]["end"]["cards"]["loads"]["charts"][0]
        self.assert_chart(chart, [(key, label_of(key), swept(key, 1, speeds_of(2400.0, 24000.0))) for key in LOADS], [OVER, "load of one bearing (N)"])
        self.assertEqual(found["dumps"]["end"]["cursor"], "12\u202f000 rpm")


class Form(Drawn):
    """One row for each input; mistakes at the field that was changed; a unit that is wrong does not stay."""

    def row(self, found, key):
        return next(row for row in found["rows"] if row["key"] == key)

    def test_a_wrong_unit_does_not_stay(self):
        wrong, right, odd = CASE.replace("power: 150 kW", "power: 160 Nm"), CASE.replace("power: 150 kW", "power: 160 kW"), CASE.replace("power: 150 kW", "power: 150000 J/s")
        found = page([put("[id='in-input.power']", "160 Nm"), dump("wrong"), put("[id='in-input.power']", "160"), dump("right"), put("[id='in-input.power']", "150000 J/s"), dump("odd"),
                      put("[id='in-input.power']", "151000"), dump("kept")], (CASE, wrong, right, odd, odd.replace("150000", "151000")))["dumps"]
        self.assertEqual(found["wrong"]["text"], wrong)
        row = self.row(found["wrong"], "input.power")
        self.assertEqual((row["value"], row["unit"], "bad" in row["state"]), ("160 Nm", "kW", True))
        self.assertEqual(found["right"]["text"], right)
        row = self.row(found["right"], "input.power")
        self.assertEqual((row["value"], row["unit"], "bad" in row["state"]), ("160", "kW", False))
        self.assertEqual((self.row(found["odd"], "input.power")["value"], self.row(found["odd"], "input.power")["unit"]), ("150000", "J/s"))
        self.assertIn("power: 151000 J/s", found["kept"]["text"])

    def test_a_text_that_names_a_file_is_taken_out_where_it_is_emptied(self):
        named = CASE.replace("bearing:\n", "bearing:\n  catalogue: own.csv\n", 1)
        self.assertNotEqual(named, CASE)
        found = page([put("[id='in-bearing.catalogue']", ""), dump("emptied")], (named, CASE))["dumps"]
        self.assertEqual(found["emptied"]["text"], CASE)

    def test_a_mistake_is_shown_at_the_field_that_was_changed(self):
        named = CASE[:CASE.index("  rollers: 15\n")] + "  designation: NU 204\n  clearance_class: CN\n  cage: {material: polyamide}\n" + CASE[CASE.index("lubricant:"):]
        wrong = named.replace("NU 204", "NU 2307")
        refused = {"text": wrong, "errors": ["case.yaml:15:15: bearing.per_planet: found 2 bearings of 31 mm; required: less"]}
        third = {"text": wrong.replace("module: 3 mm", "module: -3 mm"), "errors": [*refused["errors"], "case.yaml:12:11: gearset.module: found -3 mm; required: more"]}
        found = page([put("[id='in-bearing.designation']", "NU 2307"), dump("wrong"), put("[id='in-gearset.module']", "-3"), dump("two"), click("#mend button"), dump("first"),
                      text_put(named), dump("mended"), text_put(wrong), dump("by text")], (named, refused, third))["dumps"]
        row = self.row(found["wrong"], "bearing.designation")
        self.assertEqual((row["note"], "bad" in row["state"]), ("bearing.per_planet: found 2 bearings of 31 mm; required: less", True))
        self.assertFalse("bad" in self.row(found["wrong"], "bearing.per_planet")["state"])
        self.assertEqual(found["wrong"]["mend"], "1 error: the results are those of the last valid case")
        self.assertEqual([group["mark"] for group in found["wrong"]["groups"]], ["", "1 error", "", "", "", ""])
        self.assertIn("bad", self.row(found["two"], "bearing.designation")["state"])  # as long as it is there
        self.assertEqual(self.row(found["two"], "gearset.module")["note"], "found -3 mm; required: more")
        self.assertEqual(found["two"]["mend"], "2 errors: the results are those of the last valid case")
        self.assertEqual(found["first"]["focused"], "in-bearing.designation")
        self.assertFalse([row["key"] for row in found["mended"]["rows"] if "bad" in row["state"]])
        self.assertEqual([row["key"] for row in found["by text"]["rows"] if "bad" in row["state"]], ["bearing.per_planet"])

    def test_a_faulty_file_has_no_results_and_no_fidelity(self):
        wrong = CASE.replace("module: 3 mm", "module: 3,5 mm")
        opened = {"kind": "case", "name": "x", "file": "x.yaml", "text": wrong, "checksum": "1", "writable": False, "folder": ""}
        found = page([dump()], ({"text": wrong, "errors": ["case.yaml:10:11: gearset.module: found 3,5 mm; required: more"]},), opened=opened)["dumps"]["end"]
        self.assertEqual(found["mend"], "1 error: there are no results yet")
        self.assertTrue(found["fidelity_hidden"])

    def test_several_sets_have_no_fields_of_a_single_one(self):
        text = (CASES / "three_sets_150kW" / "case.yaml").read_text(encoding="utf-8")
        keys = {row["key"] for row in page([dump()], (text,))["dumps"]["end"]["rows"]}
        self.assertFalse([key for key in keys if key.startswith(("gearset.", "bearing."))])
        self.assertIn("sets.reduction.gearset.planets", keys)

    def test_values_units_and_defaults(self):
        found = page([dump(), click("[data-group=Oil] [data-state=default]"), dump("defaults")])["dumps"]
        rows = {row["key"]: row for row in found["end"]["rows"]}
        check = {one["path"]: one for one in check_of(CASE)["check"]["inputs"]}
        for key, value, unit in (("input.power", "150", "kW"), ("gearset.module", "3", "mm"), ("bearing.radial_clearance", "10", "um"), ("lubricant.viscosity", "0.01", "Pa.s"),
                                 ("gearset.teeth.sun", "37", None), ("life.method", "lundberg-palmgren", None)):
            self.assertEqual((rows[key]["value"], rows[key]["unit"], rows[key]["state"].split()[1], rows[key]["shown"]), (value, unit, "stated", True), key)
        for key, row in rows.items():
            if key in check and check[key]["standing"] != "given" and row["unit"]:
                number, _, unit = check[key]["given"].partition(" ")
                self.assertAlmostEqual(float(row["value"]), float(number), delta=1e-5 * abs(float(number)), msg=key)
                self.assertEqual((row["unit"], row["state"].split()[1]), (unit, "default"), key)
                self.assertIn(re.sub(r"[ \n]+", " ", check[key]["reason"]), row["note"], key)
        shown = {row["key"] for row in found["defaults"]["rows"] if row["shown"]} - {row["key"] for row in found["end"]["rows"] if row["shown"]}
        self.assertTrue(shown and all(key.split(".")[0] in ("lubricant", "film", "traction", "drag", "heat") for key in shown))

    def test_unused_inputs_are_marked(self):
        found = page([dump(), put("#fidelity", "dynamic"), dump("dynamic")])["dumps"]
        for name, fidelity in (("end", "quasi-static"), ("dynamic", "dynamic")):
            rows = {row["key"]: row for row in found[name]["rows"]}
            for one in check_of(CASE)["check"]["inputs"]:
                if one["path"] in rows:
                    self.assertEqual(f"Not used by {fidelity}" in rows[one["path"]]["note"], f"--fidelity {fidelity}" in one["not_modelled_by"], one["path"])

    def test_a_unit_is_converted(self):
        found = page([put("[data-key='gearset.module'] .unit", "um"), dump(), put("[data-key='gearset.face_width'] .unit", "inch"), dump("refused")],
                     (CASE, CASE.replace("module: 3 mm", "module: 3000 um")), units={"3 mm > um": {"body": {"number": 3000, "text": "3000 um"}}})["dumps"]
        self.assertEqual(found["end"]["text"], CASE.replace("module: 3 mm", "module: 3000 um"))
        self.assertIn("no unit inch", self.row(found["refused"], "gearset.face_width")["note"])

    def test_a_value_is_taken_out_and_put_in_place(self):
        found = page([click("[data-key='gearset.face_width'] .reset"), dump(), put("[id='in-bearing.laminae']", "30"), dump("put")], (CASE,))["dumps"]
        self.assertEqual(found["end"]["text"], CASE.replace("  face_width: 28 mm\n", ""))
        self.assertEqual(self.row(found["end"], "gearset.face_width")["value"], "")  # no default
        self.assertEqual([line for line in found["put"]["text"].splitlines() if "laminae" in line], ["  laminae: 30"])

    def test_what_can_be_chosen_is_found_and_what_cannot_is_said(self):
        found = {word: page([put("#search", word, "input"), dump(narrowly=["rows"])])["dumps"]["end"]["rows"] for word in ("grease", "pairing", "tapered", "spherical")}
        shown = {word: {row["key"]: row for row in rows if row["shown"]} for word, rows in found.items()}
        self.assertIn("life.lubrication", shown["grease"])
        self.assertIn("bearing.rows.arrangement", shown["pairing"])
        for word in ("tapered", "spherical"):
            self.assertIn("bearing.type", shown[word])
            self.assertIn("Designations of tapered roller bearings and spherical roller bearings cannot be chosen", shown[word]["bearing.designation"]["meaning"])


class Edited(Drawn):
    """Values by slider, by a unit that is typed, from a file; requests that fail."""

    def test_a_slider_spans_about_the_value(self):
        texts = [CASE.replace("module: 3 mm", f"module: {value} mm") for value in ("4.5", "1.5")]
        rollers = CASE.replace("rollers: 15", "rollers: 22")  # of 3, the least, to 30
        found = page([put("[data-key='gearset.module'] .slider", "150", "input"), dump("dragging"), put("[data-key='gearset.module'] .slider", "50"), dump("released"),
                      text_put(CASE), put("[data-key='bearing.rollers'] .slider", "140"), dump("whole")], (CASE, *texts, rollers))["dumps"]
        self.assertEqual([found[name]["text"] for name in ("dragging", "released", "whole")], [*texts, rollers])

    def test_a_slider_of_a_negative_value_spans_to_nought(self):
        """-20 degC: from -40 to 0 degC in steps of a tenth."""
        cold = CASE.replace("viscosity: 0.01 Pa.s,", "viscosity: 0.01 Pa.s, temperature: -20 degC,")
        checks = [{"text": text, **check_of(text)} for text in (cold, cold.replace("-20 degC", "-29.8 degC"))]
        found = page([put("[data-key='lubricant.temperature'] .slider", "51"), dump()], checks)["dumps"]["end"]
        self.assertEqual(found["text"], checks[1]["text"])

    def test_a_typed_unit(self):
        inch = CASE.replace("module: 3 mm", "module: 0.125 inch")
        found = page([put("[data-key='gearset.module'] .unit", "other"), put("[data-key='gearset.module'] input.unit", "inch", "input"), {"what": "event", "selector": "[data-key='gearset.module'] input.unit", "event": "blur"}, dump(),
                      put("[data-key='gearset.face_width'] .unit", "other"), {"what": "event", "selector": "[data-key='gearset.face_width'] input.unit", "event": "blur"}, dump("none")],
                     (CASE, inch), units={"3 mm > inch": {"body": {"number": 0.125, "text": "0.125 inch"}}})["dumps"]
        self.assertEqual(found["end"]["text"], inch)
        row = next(row for row in found["end"]["rows"] if row["key"] == "gearset.module")
        self.assertEqual((row["value"], row["unit"]), ("0.125", "inch"))
        self.assertEqual(found["none"]["text"], inch)

    def test_text_that_the_form_cannot_show(self):
        anchored = CASE.replace("module: 3 mm", "module: &m 3 mm")
        broken = {"text": anchored, "errors": ["case.yaml:10:11: gearset.module: found an anchor", "case.yaml:4:3: nowhere.key: found a key", "not about a line"]}
        found = page([text_put(anchored), dump(), click("#errors button"), dump("line")], (CASE, broken))["dumps"]
        self.assertIn("The form cannot show this text (line 10: anchors, aliases and tags are not read here). Edit it as YAML.", found["end"]["errors"])
        self.assertIn("Line 4, column 3: nowhere.key: found a key Show the linenot about a line", found["end"]["errors"])
        self.assertEqual((found["line"]["focused"], "with-text" in found["line"]["body"]), ("yaml", True))
        self.assertEqual(next(row for row in found["end"]["rows"] if row["key"] == "gearset.module")["note"], "found an anchor")
        self.assertEqual(found["end"]["mend"], "3 errors: the results are those of the last valid case")
        self.assertIn("stale", found["end"]["body"])

    def test_requests_that_fail(self):
        failed = {"status": 500, "body": {"code": 1, "errors": ["no static equilibrium", "second line"]}}
        found = page([cursor_put(8400), dump("failed"), cursor_put(8600), dump("again")], refusals=[None] * 4 + [failed])["dumps"]
        self.assertIn("no static equilibriumsecond line", found["failed"]["errors"])
        self.assertTrue(found["failed"]["header"].endswith("failed New case YAML Take away") and "stale" in found["failed"]["body"])
        self.assertEqual(found["again"]["errors"], "")
        self.assertNotIn("stale", found["again"]["body"])
        gone = page([cursor_put(8400), dump()], refusals=[None] * 4 + ["gone"])["dumps"]["end"]
        self.assertIn("The program does not answer. Start `orbearing open` again, then load its new address.", gone["errors"])
        busy = page([cursor_put(8400), dump()], refusals=[None] * 4 + [{"status": 429, "body": {"error": "more than 8"}}] * 2)
        self.assertEqual(busy["dumps"]["end"]["errors"], "")
        self.assertEqual(busy["requests"][-1]["settings"], ["input.speed=8400 rpm"])

    def test_long_results(self):
        rest = {"many": [{"name": f"row {i}", "force_N": 1.5 + i} for i in range(70)], "wide": [[float(i) for i in range(14)]], "none": [], "long": [float(i) + 0.5 for i in range(30)],
                "power_flow": [{"member": "sun", "speed_rpm": 1.5, "torque_N_m": 2.5}, {"member": "ring", "speed_rpm": 3.5, "torque_N_m": -4.5}]}
        card = page([{"what": "open", "selector": "#card-point"}, {"what": "open", "selector": "#card-point details"}, dump()], results={"run": {**RUN, **rest}})["dumps"]["end"]["cards"]["point"]
        many = next(table for table in card["tables"] if ["name", "force"] in table)
        self.assertEqual((len(many), many[60]), (61, ["row 59", "60.5"]))
        self.assertIn(["0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "…"], sum(card["tables"], []))
        self.assertIn("long: 30 values", card["text"])
        self.assertIn([["member", "speed (rpm)", "torque (N m)"], ["sun", "1.5", "2.5"], ["ring", "3.5", "−4.5"]], card["tables"])

    def test_a_curve_that_takes_long_has_few_speeds(self):
        """Speeds of the curve: nine at first, sixty where they take no long time."""
        found = page([dump(narrowly=["cursor"]), text_put(OTHER)], (CASE, OTHER), recorded=True, takes={"sweep": 30})
        self.assertEqual([len(one["settings"][0].split(",")) for one in found["requests"] if one["command"] == "sweep"], [9, 60, 60])


class TakenAway(Drawn):
    def test_commands(self):
        found = page([click("#to-take"), dump("still"), click("#take .close"), put("#fidelity", "dynamic"), cursor_put(8400), click("#to-take"), dump("moving")],
                     opened={"kind": "case", "name": "x", "file": "my case.yaml", "text": CASE, "checksum": "as opened", "writable": True, "folder": "/x"})["dumps"]
        still, moving = (found[name]["take"]["areas"] for name in ("still", "moving"))
        self.assertEqual(still["take-command"], "orbearing sweep 'my case.yaml' -o results")
        self.assertEqual(moving["take-command"], "orbearing sweep 'my case.yaml' --fidelity dynamic -o results")
        self.assertEqual(still["take-point"], "orbearing run 'my case.yaml' --json --set 'input.speed=9000 rpm'")
        self.assertEqual(moving["take-point"], "orbearing run 'my case.yaml' --json --set 'input.speed=8400 rpm'")
        self.assertEqual(moving["take-python"], 'import orbearing\n\ncase = orbearing.load("my case.yaml")\nsweep = case.sweep(fidelity="dynamic")\ntable = sweep.to_xarray()\nsweep.plot()')

    def test_files(self):
        found = page([click("#to-take"), click("#take-case"), click("#take-csv"), click("#take-json"), dump(narrowly=["take"])], results={"nulls": {"film_inner_um": None}})
        case, table, result = found["downloads"]
        self.assertEqual(case, CASE)
        rows = [line.split(",") for line in table.splitlines()]
        self.assertEqual(rows[0], [*KEYS, "input_speed_rpm", "status"])
        self.assertEqual(len(rows), 1 + SPEEDS)
        for row, speed in zip(rows[1:], speeds_of(LOW, HIGH)):
            for key, cell in zip(rows[0], row):
                if key == "film_inner_um":
                    self.assertEqual(cell, "")
                elif key == "status":
                    self.assertEqual(cell, "ok")
                else:
                    self.assertEqual(float(cell), speed if key == "input_speed_rpm" else value_of(key, speed), key)
        point = json.loads(result)["points"][0]
        self.assertEqual({key: point[key] for key in KEYS if key != "film_inner_um"}, {key: value_of(key, SPEED) for key in KEYS if key != "film_inner_um"})
        self.assertEqual(point["input_speed_rpm"], SPEED)

    def test_reports(self):
        found = page([cursor_put(8400), click("#to-take"), click("#take-report"), put("#take-scope", "speeds"), click("#take-pdf"), dump()])
        asked = [one for one in found["requests"] if "path" in one]
        self.assertEqual([(one["path"], one["settings"], one["case_text"]) for one in asked], [("report?of=point", ["input.speed=8400 rpm"], CASE), ("report?of=speeds&form=pdf", [], CASE)])
        self.assertEqual(found["downloads"], ["<p>report</p>"] * 2)
        self.assertIn("The PDF is among the downloads.", found["dumps"]["end"]["take"]["text"])
        self.assertIn("Report at 8\u202f400 rpm", found["dumps"]["end"]["choices"]["take-scope"])

    def test_saving_states_the_version_it_began_with(self):
        conflict = {"status": 409, "body": {"errors": ["case.yaml: found another content"], "checksum": "by a colleague"}}
        found = page([click("#to-take"), click("#save"), click("#save"), dump("conflict"), click("#replace"), dump("replaced"), put("#save-name", "other.yaml"), click("#save"), dump()],
                     saves=[{"body": {"file": "case.yaml", "checksum": "second"}}, conflict])
        asked = [(one["file"], one["checksum"], one["text"]) for one in found["requests"] if one.get("path") == "save"]
        self.assertEqual(asked, [("case.yaml", "as opened", CASE), ("case.yaml", "second", CASE), ("case.yaml", "by a colleague", CASE), ("other.yaml", "", CASE)])
        self.assertIn("case.yaml: found another content", found["dumps"]["conflict"]["take"]["text"])
        self.assertEqual([found["dumps"][name]["buttons"]["replace"]["shown"] for name in ("conflict", "replaced")], [True, False])
        self.assertIn("Saved: case.yaml", found["dumps"]["replaced"]["take"]["text"])

    def test_the_token_of_the_address_is_not_kept(self):
        found = page([dump(narrowly=["cursor"])])
        self.assertTrue(found["address"].endswith("/page/"), found["address"])
        self.assertNotIn("secret", json.dumps(found))


ROLLER_CASE = (CASES / "templates" / "roller-bearing.yaml").read_text(encoding="utf-8")
DEFECT_CASE = (CASES / "templates" / "defect.yaml").read_text(encoding="utf-8")
STATIC = SCHEMA["$defs"]["run static"]["properties"]


class Single(Drawn):
    """Cases without a curve over speed: one result as tables, drawn and judged; in time after a button."""

    @classmethod
    def setUpClass(cls):
        cls.check = check_of(ROLLER_CASE)["check"]
        cls.inputs = {one["path"]: one["value"] for one in cls.check["inputs"]}
        cls.derived = {one["path"]: one["value"] for one in cls.check["derived"]}
        cls.count = int(cls.inputs["bearing.rollers"])
        cls.lives = {key: 1000.0 + 137 * i for i, key in enumerate(("L10h", "L10rh", "L10mh", "L10mrh", "life_h"))}
        cls.loads = {"contact_loads_N": [500.0 + 7 * j for j in range(cls.count)], "lamina_loads_N": [[10.0 * j + i for i in range(4)] for j in range(cls.count)],
                     "steps": {"gamma": 0.125, "lamina_places_mm": [-3.0, -1.0, 1.0, 3.0]}}
        cls.key = cls.check["governing_life"]["key"]
        cls.found = {**cls.lives, "S0": 2.5, "kappa": 3.5, "contact_pressure_max_MPa": 1234.0, **cls.loads, "displacement": {"radial_um": 4.25, "axial_um": 0.5},
                   "verdicts": [{**VERDICTS[0], "key": cls.key, "value": 1274.0, "limit": 1274.5}, {**VERDICTS[1], "value": 2.5, "limit": 2.0}], "units": {"steps/gamma": "1"}, "warnings": ["of the run"]}
        cls.page = page([dump()], ({"text": ROLLER_CASE, **check_of(ROLLER_CASE), "results": {"run": cls.found}},), results={"run": {}},
                        opened={"kind": "case", "name": "x", "file": "x.yaml", "text": ROLLER_CASE, "checksum": "1", "writable": False, "folder": ""})
        cls.end = cls.page["dumps"]["end"]

    def test_tiles(self):
        tiles = self.end["tiles"]
        self.assertEqual([(one["key"], one["verdict"], one["text"]) for one in tiles[:4]], [
            (self.key, "failed", f"Governing life, {self.key}1\u202f274 hfailed: at least 1\u202f275 h"), ("L10h", None, "L10h1\u202f000 h"),
            ("S0", "passed", "S02.5passed: at least 2"), ("kappa", None, "kappa3.5")])
        self.assertEqual({one["key"]: one["text"] for one in tiles[4:]}, {
            "contact_pressure_max_MPa": "pressure1\u202f234 MPa", **{key: f"{'Lundberg-Palmgren' if key == 'life_h' else key}{figure_of(self.lives[key], 'h')}"
                                                                  for key in ("L10rh", "L10mh", "L10mrh", "life_h") if key != self.key}})

    def test_the_result_as_tables(self):
        card = self.end["cards"]["result"]
        rows = {row[0]: row[1:] for row in card["tables"][0]}
        for key in (*self.lives, "S0", "kappa", "contact_pressure_max_MPa"):
            part = STATIC[key]
            label = part.get("symbol") or name_of(key, part.get("unit", ""))
            self.assertEqual(rows[label], [figure_of(self.found[key], part.get("unit", "")), part["description"]], key)
        self.assertIn(["radial", "4.25 µm", STATIC["displacement"]["properties"]["radial_um"]["description"]], sum(card["tables"], []))
        self.assertIn(["gamma", "0.125", STATIC["steps"]["properties"]["gamma"]["description"]], sum(card["tables"], []))
        self.assertIn(f"contact loads: {self.count} values – {STATIC['contact_loads_N']['description']}", card["text"])
        self.assertIn("verdicts: 2 rows", card["text"])
        verdicts = next(table for table in card["tables"] if table[0][0] == "requirement")
        self.assertEqual([row[:4] for row in verdicts[1:]], [["life", "1\u202f274", "1\u202f275", "false"], ["S0", "2.5", "2", "true"]])
        self.assertNotIn("of the run", card["text"])
        titles = dict(card["titles"])
        self.assertEqual(titles["bound"], STATIC["verdicts"]["items"]["properties"]["bound"]["description"])
        self.assertEqual(titles[STATIC["L10mh"].get("symbol", "L10mh")], "L10mh")

    def test_laminae_of_the_most_loaded_roller(self):
        card = self.end["cards"]["pressure"]
        self.assertIn("Load along the most loaded roller", card["text"])
        self.assert_chart(card["charts"][0], [("lamina", f"roller {self.count}", list(zip(self.loads["steps"]["lamina_places_mm"], self.loads["lamina_loads_N"][-1])))],
                          ["position along the roller (mm)", "load of a lamina (N)"])

    def test_the_bearing(self):
        pitch, roller = self.inputs["bearing.pitch_diameter"] * 1e3, self.inputs["bearing.roller_diameter"] * 1e3
        inner, ratio = self.inputs["operation.shaft_speed"] * RPM, roller / pitch
        cage = inner * (1 - ratio) / 2
        spin = cage - inner * (1 - ratio**2) / (2 * ratio)
        self.assertIn(f"Cage {figure_of(cage, 'rpm')}, inner ring {figure_of(inner, 'rpm')}, rollers about their axes {figure_of(spin, 'rpm')}. Slowed {readable(cage / 60 * 4, 3)} times.", self.end["cards"]["bearing"]["text"])
        drawing = next(one for one in self.end["drawings"] if one["aria-label"].startswith("Bearing to scale"))
        bars = [float(part["data-load"]) for part in drawing["parts"] if part.get("class") == "bar outer"]
        for found, expected in zip(bars, self.loads["contact_loads_N"]):
            self.assertAlmostEqual(found, expected, places=9)
        self.assertEqual({part["text"] for part in drawing["parts"] if part["name"] == "text"}, {"radial load", f"{readable(max(bars))} N"})
        first = next(part for part in drawing["parts"] if part.get("class") == "element first")
        x, y, _ = (float(one) for one in re.findall(r"-?[\d.]+", first["transform"]))
        self.assertAlmostEqual(math.hypot(x, y), pitch / 2, delta=1e-3)

    def test_commands(self):
        found = page([click("#to-take"), dump()], ({"text": ROLLER_CASE, **check_of(ROLLER_CASE), "results": {"run": self.found}},), results={"run": {}})["dumps"]["end"]["take"]
        self.assertEqual(found["areas"], {"take-command": "orbearing run case.yaml", "take-python": 'import orbearing\n\ncase = orbearing.load("case.yaml")\nresult = case.run()'})

    def test_cards_are_those_of_the_model(self):
        pair = (CASES / "mesh_62_62" / "case.yaml").read_text(encoding="utf-8")
        duplex = (CASES / "templates" / "duplex.yaml").read_text(encoding="utf-8")
        shown = {name: set(page([dump()], ({"text": text, **check_of(text), "results": {command: result}},), results={"run": {}})["dumps"]["end"]["cards"])
                 for name, text, command, result in (("gears", pair, "mesh", MESH), ("duplex", duplex, "run", {"L10h": 1.5}), ("defect", DEFECT_CASE, "run", {}))}
        shown |= {"planets": set(page([dump()])["dumps"]["end"]["cards"]), "roller": set(self.end["cards"])}
        always = {"variants", "assumptions"}
        self.assertEqual(shown, {"planets": always | {"life", "loads", "roller-loads", "motion", "more", "mesh", "bearing", "gears", "pressure", "crown", "modes", "point"},
                                 "roller": always | {"result", "bearing", "pressure"}, "gears": always | {"result", "mesh"}, "duplex": always | {"result", "bearing"}, "defect": always | {"result", "bearing"}})

    def test_a_run_in_time_belongs_to_its_case(self):
        other = DEFECT_CASE.replace("radial: 1 kN", "radial: 2 kN")
        found = page([dump("asked"), click("#card-result .chief"), {"what": "tell", "event": "progress", "data": {"done": 3, "all": 8, "doing": "Motion", "seconds_left": 4.56}}, dump("running"),
                      text_put(other), {"what": "tell", "event": "progress", "data": {"done": 4, "all": 8, "doing": "Motion", "seconds_left": None}}, dump("other"),
                      {"what": "tell", "event": "result", "data": {"shaft_Hz": 25.25, "defect_Hz": 89.5, "units": {}}}, dump("ended"), text_put(DEFECT_CASE), dump("again")],
                     ({"text": DEFECT_CASE, **check_of(DEFECT_CASE)}, {"text": other, **check_of(other)}), results={"run": {}})
        texts = {name: one["cards"]["result"]["text"] for name, one in found["dumps"].items()}
        self.assertIn("The run follows the motion in time: press Compute.", texts["asked"])
        self.assertIn("Motion: 38 %, 4.6 s to go.", texts["running"])
        self.assertIn("Motion: 50 %. Of another case: load.radial 1 kN there, 2 kN here.", texts["other"])
        self.assertIn("Done. Of another case: load.radial 1 kN there, 2 kN here.", texts["ended"])
        self.assertNotIn("25.25", texts["ended"])
        self.assertIn("shaft25.25 Hz".replace("shaft", ""), texts["again"])
        self.assertNotIn("Of another case", texts["again"])
        self.assertEqual([one["command"] for one in found["jobs"]], ["run"])


class Opened(Drawn):
    """The first page, folders of results, load spectra."""

    def test_templates_and_folders(self):
        start = {"kind": "start", "name": "", "file": "", "text": "", "writable": False, "folder": ""}
        more = {"templates": [{"name": "one", "title": "One title", "purpose": "its purpose", "text": CASE}], "folders": [{"name": "half", "case": "reducer", "fidelity": "dynamic", "points": 5, "of": 16}]}
        found = page([dump("start"), click("[data-folder=half]"), dump("refused"), click("[data-template=one]"), dump("open")], opened=start, **more)["dumps"]
        self.assertIn("One titleits purpose", found["start"]["start"])
        self.assertIn("halfreducer, dynamic, 5 of 16 points", found["start"]["start"])
        self.assertIn("a folder that differs", found["refused"]["start"])
        self.assertEqual((found["open"]["text"], found["open"]["title"]), (CASE, "reducer of the page – Orbearing"))

    def test_a_folder_that_is_not_finished_goes_on(self):
        points = [{**{key: value_of(key, speed) for key in KEYS}, "input_speed_rpm": speed, "status": "ok"} for speed in (8000.0, 9000.0)]
        opened = {"kind": "results", "name": "half", "file": "case.resolved.yaml", "text": CASE, "checksum": "1", "writable": True, "folder": "/x/half", "fidelity": "dynamic", "finished": False,
                  "points": points, "missing": {"found": 2, "of": 3}, "options": {"fidelity": "dynamic", "grid_only": True, "continue": "speed"}}
        found = page([dump("opened"), click("#card-motion .proceed"), {"what": "points", "speeds": [10000.0], "which": 0}, {"what": "tell", "event": "stopped", "data": {"points": []}}, dump("stopped"),
                      click("#card-motion .proceed"), {"what": "tell", "event": "result", "data": {"points": []}}, dump("done")], opened=opened)
        texts = {name: one["cards"]["motion"]["text"] for name, one in found["dumps"].items()}
        self.assertIn("Folder half: 2 of 3 points. Continue computes the others in this folder.", texts["opened"])
        self.assertIn("Stopped: 3 points kept.", texts["stopped"])
        self.assertIn("Done: 3 points.", texts["done"])
        asked = {"command": "sweep", "case_text": CASE, "settings": [], "options": opened["options"], "results": ""}
        self.assertEqual(found["jobs"], [asked, asked])
        self.assertEqual(found["dumps"]["opened"]["cards"]["motion"]["charts"][0]["curves"][0]["dots"][0][2], 8000.0)

    def test_an_error_of_the_folder_stays(self):
        opened = {"kind": "results", "name": "half", "file": "case.resolved.yaml", "text": CASE, "checksum": "1", "writable": True, "folder": "/x", "error": "case.resolved.yaml: differs from what its run wrote"}
        found = page([dump(), cursor_put(8400), put("#fidelity", "dynamic"), dump("later")], opened=opened)["dumps"]
        for one in found.values():
            self.assertIn("case.resolved.yaml: differs from what its run wrote", one["errors"])

    def test_the_bins_of_a_spectrum(self):
        bins = [{"bin": i + 1, "power_kW": 150.5 - i, "torque_N_m": 160.25 - 3 * i, "speed_rpm": 9000.0 - 7 * i, "share": 0.25 + 0.5 * i, "damage_share": 0.875 - 0.75 * i, "life_h": 1.0, "L10mrh": 2.0,
                 "worst_bearing_h": 4321.0 + 11 * i} for i in range(2)]
        whole = {"bins": bins, "life_h": 1.0, "life_key": "L10mrh", "L10mrh": 2.0, "shortest_L10mrh": 5432.0, "worst_bearing_key": "shortest_L10mrh", "worst_bearing_h": 5432.0, "limiting_set": "second"}
        for spectrum in (whole, [whole, {**whole, "bins": bins[:1], "worst_bearing_h": 1.0}]):
            found = page([dump()], results={"sweep": {**SWEEP, "spectrum": spectrum}, "run": {**RUN, "spectrum": spectrum, "verdicts": []}})["dumps"]["end"]
            card = found["cards"]["spectrum"]
            self.assertEqual((found["tiles"][0]["value"], found["tiles"][0]["text"].startswith("Governing life, L10mrh, load spectrum, set second5")), ("5432", True))
            self.assertEqual(card["tables"][0], [
                ["bin", "power (kW)", "torque (N m)", "speed (rpm)", "share of time", "share of damage", "shortest L10mrh (h)"],
                ["1", "150.5", "160.3", "9\u202f000", "25 %", "87.5 %", "4\u202f321"], ["2", "149.5", "157.3", "8\u202f993", "75 %", "12.5 %", "4\u202f332"]])
            self.assertIn("shortest L10mrh under the spectrum, set second: 5\u202f432 h.", card["text"])

    def test_a_planet_without_a_known_speed(self):
        """The bearing is drawn, and nothing is said of speeds."""
        check = check_of(CASE)["check"]
        unknown = {**check, "derived": [one for one in check["derived"] if one["path"] != "operation.planet_speed"]}
        found = page([dump()], ({"text": CASE, "check": unknown},))["dumps"]["end"]
        drawing = next(one for one in found["drawings"] if one["aria-label"].startswith("Bearing to scale"))
        self.assertEqual(sum(part.get("class", "").startswith("element") for part in drawing["parts"]), ROLLER)
        self.assertNotIn("NaN", json.dumps(found))
        self.assertNotRegex(found["cards"]["bearing"]["text"], "Slowed|rpm")

    def test_few_large_rollers_on_a_solid_ring(self):
        """Three rollers of 11 mm about 20 mm leave 9 mm: no bore is stated and none is drawn, and the marks end at the raceway."""
        check = check_of(CASE)["check"]
        sizes = {"bearing.pitch_diameter": 0.02, "bearing.roller_diameter": 0.011, "bearing.rollers": 3, "bearing.bore": None}
        few = {**check, "inputs": [{**one, "value": sizes.get(one["path"], one["value"])} for one in check["inputs"]],
               "derived": [one for one in check["derived"] if "raceway" not in one["path"]]}
        found = page([dump()], ({"text": CASE, "check": few},))["dumps"]["end"]
        drawing = next(one for one in found["drawings"] if one["aria-label"].startswith("Bearing to scale"))
        marks = [part for part in drawing["parts"] if part["name"] == "line" and part["path"].split()[0] == "marks"]
        heights = [[math.hypot(float(part[f"x{i}"]), float(part[f"y{i}"])) for i in (1, 2)] for part in marks]
        for outer, inner in heights[12:]:
            self.assertTrue(0.4 * 9.0 - 1e-9 <= inner < outer <= 9.0 / 2, (inner, outer))

    def test_rings(self):
        for rings, parts in (("none", {"raceway": 1, "pin": 1, "ring": 0}), ("outer", {"raceway": 0, "pin": 1, "ring": 1}), ("both", {"raceway": 0, "pin": 0, "ring": 2})):
            text = CASE.replace("  type: cylindrical-roller\n", f"  type: cylindrical-roller\n  rings: {rings}\n")
            if rings != "both":
                text = text.replace("  bore: 25 mm\n", "")
            check = check_of(CASE)["check"]
            inputs = [one if one["path"] != "bearing.rings" else {**one, "value": rings, "given": rings} for one in check["inputs"]]
            found = page([dump()], ({"text": text, "check": {**check, "inputs": inputs}},))["dumps"]["end"]
            drawing = next(one for one in found["drawings"] if one["aria-label"].startswith("Bearing to scale"))
            self.assertEqual({name: sum(part.get("class") == name for part in drawing["parts"]) for name in parts}, parts, rings)
            sizes = {part["class"]: float(part["r"]) for part in drawing["parts"] if part.get("class") in ("raceway", "pin")}
            derived = {one["path"]: one["value"] for one in check["derived"]}
            for name, path in (("raceway", "outer"), ("pin", "inner")):
                if name in sizes:
                    self.assertAlmostEqual(sizes[name], derived[f"bearing.{path}_raceway_diameter"] / 2, places=9)
            gears = next(one for one in found["drawings"] if "gears" in one["class"])
            seats = {part["class"]: float(part["r"]) for part in gears["parts"] if part["name"] == "circle" and part["class"] in ("bore", "pin")}
            self.assertAlmostEqual(seats["bore"], derived["bearing.outer_raceway_diameter"] / 2 if rings == "none" else 23.5, places=9)
            self.assertAlmostEqual(seats["pin"], 12.5 if rings == "both" else derived["bearing.inner_raceway_diameter"] / 2, places=9)
            self.assertEqual({"none": "No rings: rollers run on the pin and in the bore of the planet. ", "outer": "Rollers run on the pin. ", "both": ""}[rings] in found["cards"]["bearing"]["text"], True)


READER = """
import * as yaml from %s;
import fs from 'node:fs';
const plain = (node) => node.kind === 'map' ? Object.fromEntries(node.entries.map((one) => [one.key, plain(one.node)])) : node.kind === 'list' ? node.items.map(plain) : node.empty ? '' : node.value;
const tried = (act) => { try { return act(); } catch (error) { if (!(error instanceof yaml.NotReadable)) throw error; return {refused: error.message}; } };
process.stdout.write(JSON.stringify(JSON.parse(fs.readFileSync(0)).map(({text, sets, removes, words}) => ({
  tree: tried(() => plain(yaml.parse(text))),
  sets: (sets ?? []).map(([path, source, order]) => yaml.withValue(text, path, source, order && (() => order))),
  removes: (removes ?? []).map((path) => yaml.withoutValue(text, path)),
  texts: (sets ?? []).map(([path]) => yaml.textAt(text, yaml.nodeAt(yaml.parse(text), path))),
  words: (words ?? []).map(([value, options]) => yaml.scalarText(value, options))
}))));
"""
ODD = """# a comment
---
name: "quoted: \\"text\\" \\u00e9 \\x41 #"   # behind it
source: 'it''s quoted # no comment'
plain: a value # a comment
folded: first line
  second line
  third
block: |
  one
    two

  three
empty:
"quoted: key" : 5
'other key': 6
flow: {a: 1, "b c": [x, 'y, z', {d: e}], f:   # a comment
  last, g: }
list:
  - one
  - two: 2
    three: {}
  -
    four: [4]
  - - nested
    - list
after: last
nested:
  deeper:
    deepest: 1
"""


def paths_in(tree, before=()):
    for key, value in tree.items():
        yield (*before, key)
        if isinstance(value, dict):
            yield from paths_in(value, (*before, key))


def with_value(tree, path, value):
    return {**tree, path[0]: value if len(path) == 1 else with_value(tree.get(path[0]) or {}, path[1:], value)}


def without(tree, path):
    """A mapping that held nothing else goes too."""
    if len(path) == 1:
        return {key: value for key, value in tree.items() if key != path[0]}
    inner = without(tree[path[0]], path[1:])
    return {**tree, path[0]: inner} if inner else {key: value for key, value in tree.items() if key != path[0]}


class CaseText(unittest.TestCase):
    """Case files as a tree, and edits that leave all else as it was: compared with PyYAML."""

    maxDiff = None

    @staticmethod
    def read(requests):
        program = READER % json.dumps((WEB / "yaml_text.js").as_uri())
        done = subprocess.run([NODE, "--input-type=module", "-e", program], input=json.dumps(requests), capture_output=True, text=True, timeout=300, check=False)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    @staticmethod
    def loaded(text):
        tree = yaml.load(text, BASE)
        if tree and "block" in tree:
            tree["block"] = tree["block"].rstrip()
        return tree

    @staticmethod
    def comments(text):
        return re.findall(r"(?:^|\s)(#.*)$", text, re.M)

    def test_trees_and_edits_of_all_cases(self):
        texts = [ODD, *(file.read_text(encoding="utf-8") for file in sorted(CASES.glob("*/case.yaml")) + sorted((CASES / "templates").glob("*.yaml")))]
        texts = [text for text in texts if not re.search(r": [&*]", text)]
        trees = [yaml.load(text, BASE) for text in texts]
        trees[0]["block"] = trees[0]["block"].rstrip()  # the form shows it without its last line break
        requests = []
        for text, tree in zip(texts, trees):
            paths = [list(path) for path in paths_in(tree)]
            requests.append({"text": text, "sets": [[path, "12 mm"] for path in paths] + [[[*path[:-1], "added"], "7"] for path in paths] + [[["new", "deep", "key"], "8"]], "removes": paths})
        for request, tree, found in zip(requests, trees, self.read(requests)):
            self.assertEqual(found["tree"], tree)
            for (path, source), edited, own in zip(request["sets"], found["sets"], found["texts"]):
                self.assertEqual(self.loaded(edited), with_value(tree, path, source), (path, edited))
                value = functools.reduce(lambda one, key: one.get(key) if isinstance(one, dict) else None, path, tree)
                if isinstance(value, str):
                    self.assertEqual(own, value, path)
                elif value:
                    self.assertEqual(yaml.load(own, BASE), value, path)
                if isinstance(value, str) and request["text"] is not ODD or value is None:
                    self.assertEqual(self.comments(edited), self.comments(request["text"]), path)
            for path, edited in zip(request["removes"], found["removes"]):
                self.assertEqual(self.loaded(edited) or {}, without(tree, path), (path, edited))

    def test_keys_are_added_in_the_order_of_the_schema(self):
        text = "a: 1\nc: 3  # of c\ne:\n  f: 1\n"
        found, = self.read([{"text": text, "sets": [[["b"], "2", ["a", "b", "c", "k", "e"]], [["k"], "4", ["a", "b", "c", "k", "e"]], [["z"], "9", ["z", "a", "b"]]]}])
        self.assertEqual(found["sets"], ["a: 1\nb: 2\nc: 3  # of c\ne:\n  f: 1\n", "a: 1\nc: 3  # of c\nk: 4\ne:\n  f: 1\n", "z: 9\na: 1\nc: 3  # of c\ne:\n  f: 1\n"])

    def test_what_cannot_be_read_is_refused_with_its_line(self):
        refused = {"a: &x 1\n": "line 1: anchors", "a: 1\nb: *x\n": "line 2: anchors", "a: !!binary x\n": "line 1: anchors", "a: 'x\n": "line 1: a quotation mark", "a: [1, 2\n": "line 1: '[' is not closed",
                   "a: {b: 1} c\n": "line 1: nothing but a comment", "a: 1\n   b: 2\n": "line 2: its indentation", "a: 1\nwords\n": "line 2: a key and a colon", "a: b: c\n": "line 1: a colon within",
                   "a: [1 2: 3]\n": "line 1: a comma", "\ta: 1\n": "line 1: a tabulator", "a:\n  b: 1\n c: 2\n": "line 3: its indentation"}
        for (text, said), found in zip(refused.items(), self.read([{"text": text} for text in refused])):
            self.assertTrue(found["tree"].get("refused", "").startswith(said), (text, found["tree"]))

    def test_words_stay_words(self):
        values = ["a", "", " a", "a: b", "a #b", "- a", "-5 mm", ".5 mm", "[a", "{", "yes", "null", "~", "a\nb\tc\x01", 'a "b" \\c', "#", "'x", "1", "1.5e3", "true", "0x1F", ".nan", "a, b", "NU 204", "%x", "@x", "5 % of it"]
        found, = self.read([{"text": "", "words": [[value, {"words": words, "flow": flow}] for value in values for words in (False, True) for flow in (False, True)]}])
        for i, value in enumerate(values):
            for j, (words, flow) in enumerate(((False, False), (False, True), (True, False), (True, True))):
                text = found["words"][4 * i + j]
                document = f"{{k: {text}, l: 1}}" if flow else f"k: {text}\nl: 1\n"
                self.assertEqual(yaml.load(document, BASE)["k"], value, (value, text))
                if words:
                    self.assertIsInstance(yaml.safe_load(document)["k"], str, (value, text))


if __name__ == "__main__":
    unittest.main()
