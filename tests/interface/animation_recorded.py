#!/usr/bin/env python3
"""Animations are as recorded: data and words of a page, all that its script draws at several instants and while it plays, and pictures of a ball bearing in motion.

The script runs in node; where there is none, what it draws is not compared. `--record` writes records/animation.json.xz anew, for which node is required.
Exit code 77 (skipped) where numpy, matplotlib or netCDF4 is missing.
"""

import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest.mock
from pathlib import Path

try:
    import matplotlib  # noqa: F401
    import netCDF4
    import numpy as np
except ImportError:
    print("skipped: numpy, matplotlib or netCDF4 is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import figures_fixture as made  # noqa: E402
import kept_records  # noqa: E402
import report_dynamic_fixture as dynamic  # noqa: E402
import whole_drawing  # noqa: E402
from orbearing import animate, animation  # noqa: E402
from orbearing.point_file import PointFile  # noqa: E402
from orbearing.result_folder import Report  # noqa: E402

RECORDS = kept_records.Records("animation")
SPEED = 6000
INSTANTS, ROLLERS = 9, 3  # that a page plays here

# A page without a browser: all that is done to canvases is kept, as are texts of elements; the clock is told by the test.
BROWSER = """
const kept = [], elements = {}, listeners = {};
let waiting = [];
const pen = (name) => new Proxy({}, {
  get: (own, what) => what in own ? own[what] : (...words) => kept.push([name, what, ...words]),
  set: (own, what, value) => { own[what] = value; kept.push([name, what, value]); return true; }});
const element = (name) => elements[name] ??= {textContent: "", value: 8, options: [4, 8, 16, 40].map((value) => ({value: String(value), textContent: ""})),
  addEventListener: (what, act) => { listeners[`${name} ${what}`] = act; },
  getBoundingClientRect: () => name === "trace" ? {width: 410, height: 310} : {width: 500, height: 500.4}, getContext: () => pen(name)};
globalThis.document = {getElementById: element};
globalThis.window = {devicePixelRatio: RATIO, addEventListener: (what, act) => { listeners[`window ${what}`] = act; }, location: {hash: "HASH"}, matchMedia: (query) => ({matches: query.includes("reduced") && STILL})};
globalThis.requestAnimationFrame = (act) => waiting.push(act);
const texts = () => Object.fromEntries(Object.entries(elements).filter(([name]) => name !== "data").map(([name, one]) => [name, [one.textContent, String(one.value), one.options.map((two) => two.textContent), one.width, one.height]]));
const states = [];
const state = (what) => { states.push([what, texts(), kept.length]); };
const tick = (now) => { const these = waiting; waiting = []; for (const act of these) act(now); };
element("data").textContent = DATA;
"""
AFTERWARDS = """
state("begin"); ACTS
process.stdout.write(JSON.stringify({kept, states, waiting: waiting.length}));
"""
PLAY = """
tick(1000); state("first"); tick(1050); state("second"); tick(9000); state("late");
listeners["play click"](); state("paused"); tick(9100); state("still paused"); listeners["play click"](); tick(9200); tick(9290); state("again");
element("instant").value = "0.625"; listeners["instant input"](); state("slid"); listeners["window resize"](); state("resized");
"""


def report():
    made.RANDOM = np.random.default_rng(44)
    content = dynamic.make_report()
    content["case"]["name"] = "a <case>"
    return Report(content)


def values(caged=True):
    found = {name: made.variable(SPEED, name) for name in ("time", "roller_angle", "roller_inner_load", "roller_outer_load", "roller_spin")}
    return found | ({name: made.variable(SPEED, name) for name in ("cage_position", "cage_angle", "cage_speed")} if caged else {"orbit_speed": made.variable(SPEED, "cage_speed")})


def short(data):
    """Fewer instants and rollers."""
    cut = lambda one: one[::len(one) // INSTANTS][:INSTANTS]  # noqa: E731
    return {key: [cut(one) for one in value[:ROLLERS]] if isinstance(value, list) and isinstance(value[0], list) else cut(value) if isinstance(value, list) else value for key, value in data.items()}


def drawn(data, address="", ratio=2, still=False, acts=""):
    begin = BROWSER.replace("RATIO", str(ratio)).replace("HASH", address).replace("STILL", json.dumps(still)).replace("DATA", json.dumps(json.dumps(data)))
    script = begin + (ROOT / "python" / "orbearing" / "animation.js").read_text(encoding="utf-8") + AFTERWARDS.replace("ACTS", acts)
    done = subprocess.run([shutil.which("node"), "-"], input=script, capture_output=True, text=True, check=False)
    if done.returncode:
        return {"error": done.stderr.strip().splitlines()[4:5]}
    found = json.loads(done.stdout)
    rows = {}
    for canvas, what, *words in found["kept"]:  # by canvas and act, each with its numbers in one list
        rows.setdefault(f"{canvas} {what}", []).append(words)
    order = [f"{canvas[0]}{what}" for canvas, what, *_ in found["kept"]]
    numbers = {key: ([*zip(*list_)] if all(isinstance(one, (int, float)) for words in list_ for one in words) and len({len(words) for words in list_}) == 1 else list_) for key, list_ in rows.items()}
    return {"acts": " ".join(order), "of each": {key: [list(one) for one in value] for key, value in numbers.items()}, "states": found["states"], "waiting": found["waiting"]}


class Animations(kept_records.Recorded):
    records = RECORDS

    def test_data_and_page(self):
        found = {}
        for name, caged in (("caged", True), ("uncaged", False)):
            data = animation.content_of(report(), PointFile(values(caged)), SPEED)
            page = animation.page(report(), SPEED, short(data))
            page = re.sub(r"<style>.*?</style>|<script>.*?</script>|(?<=id=\"data\">).*?(?=</script>)", "", page, flags=re.S)
            found[name] = {"data": data, "page": page.splitlines()}
        content = report().content
        found["lined"] = re.search("<title>.*", animation.page(Report({**content, "slice": {"kW": 3.0}, "kinematics": {**content["kinematics"], "carrier": None}, "case": {}}), SPEED, short(data)))[0]
        without = {}
        for key in values():
            without[key] = animation.content_of(report(), PointFile({name: value for name, value in values().items() if name != key}), SPEED) is None
            without[f"{key}, torn"] = animation.content_of(report(), PointFile({name: value[..., :-1] if name == key else value for name, value in values().items()}), SPEED) is None
            without[f"{key}, not finite"] = animation.content_of(report(), PointFile({name: np.where(np.arange(value.shape[-1]) == 3, np.nan, value) if name == key else value for name, value in values().items()}), SPEED) is None
        for key in (*animation.SIZES.values(), *animation.CAGE_SIZES.values()):
            for size in (None, 0.0):
                changed = Report({**content, "drawing": {**content["drawing"], key: size}})
                without[f"{key} {size}"] = [animation.content_of(changed, PointFile(values(caged)), SPEED) is None for caged in (True, False)]
        for key in ("outer_race", "cage"):
            changed = animation.content_of(Report({**content, "kinematics": {**content["kinematics"], key: None}}), PointFile(values()), SPEED)
            without[key] = changed and [changed["outerSpeed"], changed["orbitRolling"]]
        found["without"] = without
        found["enlarged"] = [animation.exaggeration(shift, size) for shift in (0.0, 0.01, 1.0, 3.3, 77.0, 5000.0) for size in (20.0, 47.0)]
        found["names"] = [animation.file_name(one) for one in (6000.0, 1234.5678, 1e6)]
        points = [{"input_speed_rpm": one, "life_h": life} for one, life in ((3.0, 1.0), (1.0, 2.0), (2.0, None), (3.0, 4.0), (None, 1.0))]
        found["speeds"] = [animation.speeds(Report({"points": points * 40, "fidelity": fidelity})) for fidelity in ("dynamic", "quasi-static")]
        found["most"] = len(animation.speeds(Report({"points": [{"input_speed_rpm": float(i), "life_h": 1.0} for i in range(100)], "fidelity": "dynamic"})))
        with unittest.mock.patch("orbearing.animation.MOST_VALUES", 1000):
            found["thinned"] = animation.content_of(report(), PointFile(values()), SPEED)
        with unittest.mock.patch("orbearing.animation.read_point", lambda report, speed: PointFile(values() if speed != 2000 else {})):
            found["pages"] = [name for name, _ in animation.pages(report())]
        self.check("page", found)

    def test_script(self):
        if not shutil.which("node"):
            self.assertFalse(kept_records.RECORDING, "node is required to record what the script draws")
            self.skipTest("no node")
        caged, uncaged = (short(animation.content_of(report(), PointFile(values(one)), SPEED)) for one in (True, False))
        for name, data, more in (("caged", caged, {"address": "#0.3"}), ("uncaged", uncaged, {"address": "#1", "ratio": 1}), ("playing", caged, {"acts": PLAY}), ("still", uncaged, {"still": True}),
                                 ("beyond", {**caged, "clearance": 0, "orbitRolling": None, "outerSpeed": -caged["outerSpeed"]}, {"address": "#1.5", "ratio": 0}),
                                 ("backwards", {**caged, "orbitSpeed": [-one for one in caged["orbitSpeed"]], "outer": [[0.0 for _ in one] for one in caged["outer"]]}, {"address": "#0"})):
            self.check(f"script, {name}", drawn(data, **more))

    def test_ball_bearing(self):
        rng = np.random.default_rng(7)
        count = 60
        time = 0.2 + np.linspace(0.0, 0.06, count)
        run = {"time": time, "first_ball_angle": 0.3 + 25.0 * (time - time[0]) * 9.0, "first_ball_inner_load": rng.uniform(10.0, 900.0, count), "inner_speed": rng.uniform(150.0, 160.0, count),
               **{name: 1e-5 * rng.uniform(-2.0, 9.0, count) for name in ("cage_x", "cage_y", "inner_x", "inner_y")}}
        case = """name: x  # of a test
bearing:
  balls: 8
  ball_diameter: 12.5 mm  # each
  pitch_diameter: 6 cm
  list:
    - skipped: 3
  cage:
    inner_diameter: 56000 um
    outer_diameter: 0.064
  bore: 40 mm
# a: comment
load:
  radial: 5 N
"""
        found = {}
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place)
            (folder / "case.resolved.yaml").write_text(case, encoding="utf-8")
            (folder / "points").mkdir()
            for name in ("none", "torn"):
                if name == "torn":
                    netCDF4.Dataset(folder / "points" / "00000.nc", "w").close()
                try:
                    animate.series(folder)
                except SystemExit as end:
                    found[name] = str(end).replace(place, "DIR")
            with netCDF4.Dataset(folder / "points" / "00000.nc", "w") as data:
                data.createDimension("time", count)
                data.createDimension("ball", 2)
                for name, one in run.items():
                    data.createVariable(name, "f8", ("time",))[...] = one
                data.createVariable("other", "f8", ("ball",))[...] = [1.0, 2.0]
            values_of = animate.resolved(folder / "case.resolved.yaml")
            found["case"] = values_of
            found["lengths"] = [animate.length(values_of, f"bearing.{key}") for key in ("ball_diameter", "pitch_diameter", "cage.inner_diameter", "cage.outer_diameter")]
            found["series"] = sorted(animate.series(folder))
            found["loads"] = animate.load_by_place(run)
            kept = []
            with unittest.mock.patch("matplotlib.figure.Figure.savefig", lambda figure, into, **more: kept.append([Path(into).name, more, whole_drawing.whole(figure)])):
                for begin, seconds, frames in ((-1.0, 0.05, 3), (0.21, 0.02, 8), (99.0, 0.05, 1), (-1.0, 0.5, 2)):
                    animate.animate(folder, folder / "x.png", begin, seconds, frames)
            found["strip"] = kept

            class Movie:
                """Draws the first and the last picture in place of a film."""

                def __init__(self, figure, draw, frames, blit):
                    self.kept = [list(frames), blit]
                    for time in (frames[0], frames[-1]):
                        draw(time)
                        self.kept.append(whole_drawing.whole(figure))

                def save(self, into, writer, dpi):
                    found["film"] = [Path(into).name, writer.fps, dpi, *self.kept]

            with unittest.mock.patch("matplotlib.animation.FuncAnimation", Movie):
                self.assertEqual(animate.main([place, "-o", f"{place}/x.gif", "--frames", "4"]), 0)
            with unittest.mock.patch("orbearing.animate.animate", lambda *words: found.setdefault("words", []).append([str(one).replace(place, "DIR") for one in words])):
                animate.main([place, "-o", "a.gif"])
                animate.main([place, "-o", "b.gif", "--begin", "0.25", "--seconds", "0.1", "--frames", "7"])
        self.check("ball bearing", found)


if __name__ == "__main__":
    kept_records.main(RECORDS)
