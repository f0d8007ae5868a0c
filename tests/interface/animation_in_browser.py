#!/usr/bin/env python3
"""The page that plays a bearing's motion: the data it holds, and what its script draws of them at one instant.

The script runs in a JavaScript engine (node) on a canvas that records each stroke; where there is none this part is skipped and says so.
Exit code 77 (skipped) where numpy or matplotlib is missing.
"""

import json
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

try:
    import matplotlib  # noqa: F401
    import numpy as np
except ImportError:
    print("skipped: numpy or matplotlib is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import figures_fixture as made  # noqa: E402
import report_dynamic_fixture as dynamic  # noqa: E402
from figures_test import number  # noqa: E402
from orbearing import animation  # noqa: E402
from orbearing.point_file import PointFile  # noqa: E402
from orbearing.result_folder import Report  # noqa: E402

SPEED, WIDTH, HEIGHT = 6000, 400.0, 300.0
SHARE = 0.3  # of the orbit, at which the page stands
BAR, REACH = 0.26, 1.3 + 0.26  # longest bar and half the picture over the outside radius

# A page without a browser: a canvas whose strokes, fills and texts are kept, texts of elements, and the address.
BROWSER = """
const kept = {}, elements = {};
const pen = (name) => {
  const ops = kept[name] = [];
  let path = [];
  const own = {setTransform() {}, clearRect() {}, setLineDash(dash) { this.dash = dash; }, beginPath() { path = []; },
    moveTo(x, y) { path.push(["move", x, y]); }, lineTo(x, y) { path.push(["line", x, y]); }, arc(x, y, r) { path.push(["arc", x, y, r]); },
    stroke() { ops.push({what: "stroke", colour: this.strokeStyle, width: this.lineWidth, path: path.slice()}); },
    fill() { ops.push({what: "fill", colour: this.fillStyle, path: path.slice()}); },
    fillText(text, x, y) { ops.push({what: "text", text, x, y}); }};
  return own;
};
const element = (name) => elements[name] ??= {textContent: "", value: 0, options: [4, 8, 16, 40].map((value) => ({value: String(value), textContent: ""})),
  addEventListener() {}, getBoundingClientRect: () => ({width: WIDTH, height: HEIGHT}), getContext() { return pen(name); }};
globalThis.document = {getElementById: element};
globalThis.window = {devicePixelRatio: 1, addEventListener() {}, location: {hash: "#SHARE"}, matchMedia: () => ({matches: true})};
globalThis.requestAnimationFrame = () => {};
element("data").textContent = DATA;
"""
AFTERWARDS = """
const texts = {};
for (const [name, one] of Object.entries(elements)) texts[name] = name === "data" ? "" : one.textContent;
process.stdout.write(JSON.stringify({kept, texts, paces: elements.pace.options.map((one) => one.textContent), slider: elements.instant.value}));
"""


def content(caged=True):
    """What a page plays, and the values it comes from."""
    values = {name: made.variable(SPEED, name) for name in ("time", "roller_angle", "roller_inner_load", "roller_outer_load", "roller_spin")}
    values |= {name: made.variable(SPEED, name) for name in ("cage_position", "cage_angle", "cage_speed")} if caged else {
        "orbit_speed": made.variable(SPEED, "cage_speed")}
    report = Report(dynamic.make_report())
    return report, values, animation.content_of(report, PointFile(values), SPEED)


class Data(unittest.TestCase):
    def test_sizes_speeds_and_series(self):
        report, values, data = content()
        drawing = report.content["drawing"]
        keys = {"bore": "bore_mm", "innerRaceway": "inner_raceway_diameter_mm", "outerRaceway": "outer_raceway_diameter_mm", "pitch": "pitch_diameter_mm",
                "roller": "roller_diameter_mm", "outside": "outside_mm", "cageInner": "cage_inner_mm", "cageOuter": "cage_outer_mm"}
        self.assertEqual(data["size"], {name: drawing[key] for name, key in keys.items()})
        rad_s = SPEED * 2 * np.pi / 60
        self.assertAlmostEqual(data["outerSpeed"], dynamic.ROLLING["outer_race"] * rad_s)
        self.assertAlmostEqual(data["orbitRolling"], dynamic.ROLLING["cage"] * rad_s)
        self.assertAlmostEqual(data["clearance"], 1e6 * dynamic.CLEARANCE)
        self.assertAlmostEqual(data["largest"], max(values["roller_inner_load"].max(), values["roller_outer_load"].max()))
        spin, time = values["roller_spin"], values["time"]
        turned = np.array([[np.trapz(row[:i + 1], time[:i + 1]) for i in range(len(time))] for row in spin[:2]])
        for name, expected, digits in (("time", time, 8), ("inner", values["roller_inner_load"], 1), ("outer", values["roller_outer_load"], 1),
                                       ("cageX", 1e6 * values["cage_position"][0], 2), ("cageY", 1e6 * values["cage_position"][1], 2),
                                       ("orbitSpeed", values["cage_speed"], 3), ("angle", np.unwrap(values["roller_angle"], axis=1), 4)):
            np.testing.assert_allclose(data[name], expected, rtol=0, atol=0.51 * 10.0**-digits, err_msg=name)
        np.testing.assert_allclose(data["turned"][:2], turned, atol=1e-3)
        np.testing.assert_allclose(np.diff(data["cageAngle"]), np.diff(values["cage_angle"]), atol=2e-4)
        self.assertTrue(0 <= data["cageAngle"][0] < 2 * np.pi)

    def test_speeds_beside_the_picture(self):
        report, _, data = content()
        text = animation.page(report, SPEED, data)
        rpm = SPEED * dynamic.ROLLING["outer_race"]
        self.assertIn(f'speed of the planet in the carrier frame</th><td>{number(rpm).replace("-", "−")} rpm</td>', text)
        self.assertIn(f'speed of the carrier</th><td>{number(SPEED * dynamic.ROLLING["carrier"])} rpm</td>', text)
        self.assertIn(f"drawn {data['factor']} times as large", text)
        rows = dict((key, label) for label, key in re.findall(r'<th scope="row">([^<]*)</th><td id="([^"]*)"', text))
        self.assertEqual(rows, {"now-time": "time", "now-orbit": "speed of the cage in the carrier frame", "now-slip": "slip of the cage",
                                "now-load": "largest load of a roller", "now-carrying": "rollers that carry", "now-shift": "shift of the cage"})

    def test_a_bearing_without_a_cage(self):
        report, values, data = content(caged=False)
        self.assertFalse({"factor", "cageX", "cageAngle"} & set(data))
        np.testing.assert_allclose(data["orbitSpeed"], values["orbit_speed"], atol=6e-4)
        self.assertIn("speed of the rollers in the carrier frame, mean", animation.page(report, SPEED, data))


@unittest.skipUnless(shutil.which("node"), "no JavaScript engine (node) is at hand: what the script draws is not asked")
class Drawn(unittest.TestCase):
    """The picture at one instant, in the canvas' own lengths: x up, y to the left, the middle of the canvas in the middle."""

    @classmethod
    def setUpClass(cls):
        report, _, cls.data = content()
        text = animation.page(report, SPEED, cls.data)
        held, script = re.search(r'id="data">(.*?)</script>\n<script>\n(.*)</script>', text, re.S).groups()
        prelude = BROWSER.replace("WIDTH", str(WIDTH)).replace("HEIGHT", str(HEIGHT)).replace("SHARE", str(SHARE)).replace("DATA", json.dumps(held))
        done = subprocess.run(["node", "-e", f"{prelude}\n{script}\n{AFTERWARDS}"], capture_output=True, text=True, timeout=120, check=False)
        assert done.returncode == 0, done.stderr
        found = json.loads(done.stdout)
        cls.ops, cls.trace, cls.texts, cls.paces = found["kept"]["bearing"], found["kept"]["trace"], found["texts"], found["paces"]
        place = SHARE * (len(cls.data["time"]) - 1)
        cls.now = lambda self, series: float(np.interp(place, np.arange(len(series)), series))
        cls.rollers, cls.scale = len(cls.data["angle"]), WIDTH / 2 / (cls.data["size"]["outside"] / 2 * REACH)

    def at(self, x, y):
        return [WIDTH / 2 - y * self.scale, WIDTH / 2 - x * self.scale]

    def polar(self, radius, angle):
        return self.at(radius * np.cos(angle), radius * np.sin(angle))

    def lines(self, colour=None, width=None):
        return [np.array([step[1:] for step in op["path"]]) for op in self.ops if op["what"] == "stroke" and len(op["path"]) == 2 and op["path"][1][0] == "line"
                and (colour is None or op["colour"] == colour) and (width is None or abs(op["width"] - width) < 1e-9)]

    def assert_drawn(self, lines, *ends, what=""):
        wanted = np.array(ends)
        self.assertTrue(any(np.allclose(line, wanted, atol=0.02) for line in lines), f"{what}: no line from {wanted[0]} to {wanted[1]}")

    def circles(self, what):
        """Centres and radii of what was filled or stroked as circles."""
        return [[step[1:] for step in op["path"] if step[0] == "arc"] for op in self.ops if op["what"] == what and any(step[0] == "arc" for step in op["path"])]

    def test_rings_and_cage(self):
        size, data = self.data["size"], self.data
        shift = [data["factor"] * 1e-3 * self.now(data[key]) for key in ("cageX", "cageY")]
        wanted = [((0, 0), size["outside"], size["outerRaceway"]), ((0, 0), size["innerRaceway"], size["bore"]), (shift, size["cageOuter"], size["cageInner"])]
        for found, (centre, outer, inner) in zip(self.circles("fill")[:3], wanted):
            np.testing.assert_allclose(found, [[*self.at(*centre), outer / 2 * self.scale], [*self.at(*centre), inner / 2 * self.scale]], atol=1e-6)
        turned = data["outerSpeed"] * (self.now(data["time"]) - data["time"][0])
        for i in range(12):
            angle, depth = turned + i * np.pi / 6, (0.55 if i == 0 else 0.25) * (size["outside"] - size["outerRaceway"]) / 2
            self.assert_drawn(self.lines(width=3 if i == 0 else 1), self.polar(size["outside"] / 2, angle), self.polar(size["outside"] / 2 - depth, angle), what="mark of the ring")
        for j in range(self.rollers):
            bar = self.now(data["cageAngle"]) + 2 * np.pi * (j + 0.5) / self.rollers
            ends = [self.at(shift[0] + size[key] / 2 * np.cos(bar), shift[1] + size[key] / 2 * np.sin(bar)) for key in ("cageInner", "cageOuter")]
            self.assert_drawn(self.lines(width=3 if j == 0 else 1), *ends, what="bar of the cage")

    def test_rollers_are_where_they_are_and_as_dark_as_they_carry(self):
        data, size = self.data, self.data["size"]
        fills = [op for op in self.ops if op["what"] == "fill" and str(op["colour"]).startswith("rgb(")]
        self.assertEqual(len(fills), self.rollers)
        for j, op in enumerate(fills):
            angle = self.now(data["angle"][j])
            np.testing.assert_allclose(op["path"][-1][1:], [*self.polar(size["pitch"] / 2, angle), size["roller"] / 2 * self.scale], atol=1e-6)
            share = max(self.now(data["inner"][j]), self.now(data["outer"][j])) / data["largest"]
            shade = [int(part) for part in re.findall(r"\d+", op["colour"])]
            np.testing.assert_allclose(shade, [255 - 205 * share, 255 - 140 * share, 255 - 70 * share], atol=0.51)
            mark, centre = self.now(data["turned"][j]), size["pitch"] / 2 * np.array([np.cos(angle), np.sin(angle)])
            tip = centre + 0.85 * size["roller"] / 2 * np.array([np.cos(mark), np.sin(mark)])
            self.assert_drawn(self.lines(width=1.2), self.at(*centre), self.at(*tip), what="mark of a roller")

    def test_bars_are_as_long_as_loads(self):
        data, outside = self.data, self.data["size"]["outside"] / 2
        for key, foot, sign, colour in (("outer", 1.03 * outside, 1, "#D55E00"), ("inner", 0.97 * data["size"]["innerRaceway"] / 2, -1, "#0072B2")):
            drawn = self.lines(colour=colour)
            for j in range(self.rollers):
                load, angle = self.now(data[key][j]), self.now(data["angle"][j])
                if load > 0:
                    self.assert_drawn(drawn, self.polar(foot, angle), self.polar(foot + sign * BAR * outside * load / data["largest"], angle), what=f"bar of the {key} race")
        texts = [op["text"] for op in self.ops if op["what"] == "text"]
        self.assertIn(f"{data['largest']:,.0f} N", texts)
        right, low = self.at(-(1.24 + BAR) * outside, -(1.2 + BAR) * outside)
        self.assert_drawn(self.lines(colour="#767676", width=5), (right, low), (right - BAR * outside * self.scale, low), what="the bars' scale")

    def test_path_of_the_cage_in_its_clearance(self):
        data = self.data
        x, y = np.array(data["cageX"]), np.array(data["cageY"])
        room, reach = 0.42 * data["size"]["bore"] / 2, max(data["clearance"], np.hypot(x, y).max())
        path = next(op["path"] for op in self.ops if op["what"] == "stroke" and len(op["path"]) == len(x))
        np.testing.assert_allclose([step[1:] for step in path], [self.at(a / reach * room, b / reach * room) for a, b in zip(x, y)], atol=1e-6)
        dot = self.circles("fill")[-1][0]
        np.testing.assert_allclose(dot[:2], self.at(self.now(x) / reach * room, self.now(y) / reach * room), atol=1e-6)
        circle = next(one[0] for one in self.circles("stroke") if len(one) == 1 and abs(one[0][2] - room * data["clearance"] / reach * self.scale) < 1e-6)
        np.testing.assert_allclose(circle[:2], self.at(0, 0), atol=1e-6)
        self.assertIn(f"circle: {data['clearance']:.0f} µm", [op["text"] for op in self.ops if op["what"] == "text"])

    def test_senses_and_the_frame(self):
        """x up, y to the left; arrows lead where members turn, the cage here against the carrier as the planet does."""
        edge = (1.1 + BAR) * self.data["size"]["outside"] / 2
        texts = {op["text"]: (op["x"], op["y"]) for op in self.ops if op["what"] == "text"}
        foot, reach = np.array([0.85, 0.86]) * edge, 0.16 * edge
        for name, way in (("x", (1, 0)), ("y", (0, 1))):
            np.testing.assert_allclose(texts[name], self.at(*(foot + 1.35 * reach * np.array(way))), atol=1e-6)
            self.assert_drawn(self.lines(width=1.5), self.at(*foot), self.at(*(foot + reach * np.array(way))), what=f"axis {name}")
            for side in (-0.03, 0.03):
                barb = foot + reach * np.array(way) - 0.05 * edge * np.array(way) + side * edge * np.array(way)[::-1]
                self.assert_drawn(self.lines(width=1.5), self.at(*barb), self.at(*(foot + reach * np.array(way))), what=f"tip of axis {name}")
        np.testing.assert_allclose(texts["carrier turns"], self.at(1.07 * edge, 0), atol=1e-6)
        np.testing.assert_allclose(texts["sun"], self.at(-1.12 * edge, 0), atol=1e-6)
        half = self.data["size"]["pitch"] / 2
        middles = ((edge, 0.0, 1), (0.93 * self.data["size"]["outside"] / 2, np.pi / 4, -1), (half, np.pi / 4 + np.pi / self.rollers, -1))
        for radius, middle, sense in middles:
            ends = np.linspace(middle - 0.16 * sense, middle + 0.16 * sense, 17)
            for a, b in zip(ends, ends[1:]):
                self.assert_drawn(self.lines(width=2), self.polar(radius, a), self.polar(radius, b), what="arc of a sense")
            for side in (0.975, 1.025):
                self.assert_drawn(self.lines(width=2), self.polar(radius, ends[-1]), self.polar(radius * side, ends[-1] - 0.035 * sense), what="tip of a sense")

    def test_loads_over_time(self):
        data, left, bottom, top = self.data, 46, HEIGHT - 30, 18
        count = len(data["time"])
        for key, colour in (("outer", "#D55E00"), ("inner", "#0072B2")):
            path = next(op["path"] for op in self.trace if op["what"] == "stroke" and op["colour"] == colour)
            wanted = [[left + (WIDTH - left - 8) * i / (count - 1), bottom - (bottom - top) * load / data["largest"]] for i, load in enumerate(data[key][0])]
            np.testing.assert_allclose([step[1:] for step in path], wanted, atol=1e-6)
        now = next(op["path"] for op in self.trace if op["what"] == "stroke" and op["colour"] == "#1a1a1a")
        across = left + (WIDTH - left - 8) * SHARE
        np.testing.assert_allclose([step[1:] for step in now], [[across, top], [across, bottom]], atol=1e-6)
        texts = [(op["text"], op["x"], op["y"]) for op in self.trace if op["what"] == "text"]
        for share in (0, 0.5, 1):
            self.assertIn((f"{share * data['largest']:,.0f}", left - 5, bottom - (bottom - top) * share + 4), texts)
            time = 1e3 * (np.interp(share * (count - 1), np.arange(count), data["time"]) - data["time"][0])
            self.assertIn((f"{time:.2f}", left + (WIDTH - left - 8) * share, HEIGHT - 17), texts)
        self.assertEqual([text for text, *_ in texts if "(" in text], ["load of the marked roller (N): outer race, inner race dashed", "time (ms)"])

    def test_numbers_beside_it(self):
        data, now = self.data, self.now
        speed, loads = now(data["orbitSpeed"]), [max(now(a), now(b)) for a, b in zip(data["inner"], data["outer"])]
        minus = lambda text: text.replace("-", "−")  # noqa: E731
        self.assertEqual({name: self.texts[name] for name in self.texts if name.startswith("now-")}, {
            "now-time": f"{1e3 * (now(data['time']) - data['time'][0]):.3f} ms", "now-orbit": minus(f"{speed * 60 / (2 * np.pi):,.0f} rpm"),
            "now-slip": minus(f"{100 * (1 - speed / data['orbitRolling']):.2f} %"), "now-load": f"{max(loads):,.0f} N",
            "now-carrying": f"{sum(load > 0.05 * data['largest'] for load in loads)} of {self.rollers}",
            "now-shift": f"{np.hypot(now(data['cageX']), now(data['cageY'])):.1f} µm"})
        orbit = data["time"][-1] - data["time"][0]
        self.assertEqual(self.paces, [f"{pace} s for {1e3 * orbit:.2f} ms: slowed {pace / orbit:,.0f} times" for pace in (4, 8, 16, 40)])


if __name__ == "__main__":
    unittest.main()
