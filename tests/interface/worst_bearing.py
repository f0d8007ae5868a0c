#!/usr/bin/env python3
"""The bearing that requirements are judged by: of a set alone and of the same set as one of two it is the same one, to the digit."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import program

orbearing = program.package()

ROUND_OFF = 1e-12  # the ratio of a set alone and in an arrangement
OIL = {"lubricant": {"grade": "ISO VG 320", "temperature": "65 degC"}, "life": {"cleanliness": "-/17/14"}}
GEARS = {"planets": 4, "teeth": {"sun": 21, "planet": 37, "ring": 95}, "module": "10 mm", "helix_angle": "8 deg", "profile_shift": {"sun": 0, "ring": 0}, "face_width": "260 mm"}
ROLLERS = {"type": "cylindrical-roller", "complement": "full", "per_planet": 4, "rollers": 28, "roller_diameter": "24 mm", "roller_length": "36 mm", "pitch_diameter": "215 mm",
           "radial_clearance": "60 um", "bore": "170 mm", "outside_diameter": "260 mm", "width": "61 mm", "laminae": 11}
SPHERICAL = {"type": "spherical-roller", "per_planet": 2, "rollers": 19, "roller_diameter": "30 mm", "roller_length": "42 mm", "pitch_diameter": "215 mm", "radial_clearance": "90 um",
             "bore": "160 mm", "outside_diameter": "270 mm", "width": "109 mm", "rows": {"contact_angle": "11 deg"}, "dynamic_capacity": "1370 kN", "static_capacity": "1760 kN",
             "cage": {"material": "brass"}}
SECOND = {"gearset": {"planets": 3, "teeth": {"sun": 28, "planet": 47, "ring": 122}, "module": "7 mm", "helix_angle": "8 deg", "profile_shift": {"sun": 0, "ring": 0}, "face_width": "160 mm"},
          "bearing": {"designation": "NU 2320", "per_planet": 2, "cage": {"material": "brass"}}}
SHAFTS = {"rotor": ["motor", "first.carrier"], "middle": ["first.sun", "second.carrier"], "fast": ["second.sun", "load"], "housing": ["ground", "first.ring", "second.ring"]}
TILTED = {**ROLLERS, "tilt_state": "computed"}
OFF = {"gearset": {**GEARS, "dynamics": {"pin_error": {"tangential": ["40 um", "0 um", "0 um", "0 um"]}}}, "bearing": ROLLERS}
SPECTRUM = {"spectrum": [{"power": "1.2 MW", "speed": "18 rpm", "share": 0.3}, {"power": "0.7 MW", "speed": "15 rpm", "share": 0.7}]}
# name: the first set, what else the case states, the life that is judged.
KINDS = {
    "alike": ({"gearset": GEARS, "bearing": ROLLERS}, {}, "L10mrh"),
    "tilt computed": ({"gearset": GEARS, "bearing": TILTED}, {}, "shortest_L10mrh"),
    "errors of pins": (OFF, {}, "shortest_L10mrh"),
    "inclined rows": ({"gearset": GEARS, "bearing": SPHERICAL}, {}, "shortest_L10mrh"),
    "tilt computed, spectrum": ({"gearset": GEARS, "bearing": TILTED}, SPECTRUM, "shortest_L10mrh"),
}
NODE = shutil.which("node") or shutil.which("nodejs")
TILES = """
import fs from 'node:fs';
const {tilesOf} = await import(process.argv[1]);
const meanings = {of: () => ({}), label: (key) => key};
const chief = (run) => tilesOf({run: {...run, verdicts: []}, point: run.points[0], overSpeed: true, meanings, sweptSpeeds: () => [0]}).find((one) => one.chief);
process.stdout.write(JSON.stringify(JSON.parse(fs.readFileSync(0, 'utf8')).map((run) => [chief(run).name, chief(run).value])));
"""


def case_of(name, two):
    first, more, _ = KINDS[name]
    parts = {"sets": {"first": first, "second": SECOND}, "shafts": SHAFTS} if two else first
    given = {} if two else {"member": "carrier"}
    return {"name": "worst", "source": "made up", "model": "planetary-drivetrain", "input": {"power": "1.2 MW", "speed": "18 rpm", **given}, **OIL, **parts, **more,
            "requirements": {"life": "10000 h", "S0": 1, "contact_pressure_max": "4000 MPa", "load_share": 3}}


class WorstBearing(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.files, cls.runs = {}, {}
        for name in KINDS:
            for two in (False, True):
                file = cls.files[name, two] = pathlib.Path(place.name) / f"{len(cls.files)}.yaml"
                file.write_text(json.dumps(case_of(name, two)), encoding="utf-8")
                cls.runs[name, two] = program.answer("run", file)

    def each(self, test):
        for name, (_, _, key) in KINDS.items():
            with self.subTest(name):
                test(name, self.runs[name, False], self.runs[name, True], key)

    @staticmethod
    def verdict(run, requirement):
        return next(one for one in run["verdicts"] if one["requirement"] == requirement)

    def test_verdicts(self):
        def test(_, alone, both, key):
            for requirement in ("life", "S0", "contact_pressure_max", "load_share"):
                one, other = self.verdict(alone, requirement), self.verdict(both, requirement)
                self.assertEqual((one["of_set"], other["of_set"] if other["value"] is not None else "first"), ("", "first"))
                self.assertEqual((one["result"], one["passed"]), (other["result"], other["passed"]))
                if one["value"] is not None:
                    self.assertAlmostEqual(other["value"] / one["value"], 1.0, delta=ROUND_OFF)
            self.assertEqual(self.verdict(both, "life")["result"], key)
            self.assertEqual(both["points"][0]["limiting_set"], "first")

        self.each(test)

    def test_the_same_bearing_everywhere(self):
        """Rows, sensitivities and the page's tile."""
        found = self.tiles([run for (_, two), run in self.runs.items() if two]) if NODE else [None] * len(KINDS)
        tiles = dict(zip(KINDS, found, strict=True))

        def test(name, _, both, key):
            judged = self.verdict(both, "life")["value"]
            spectrum = both.get("spectrum") or {}
            self.assertEqual((spectrum or both["points"][0])[f"sets.first.{key}"], judged)
            if spectrum:
                self.assertEqual((spectrum["worst_bearing_key"], spectrum["worst_bearing_h"], spectrum["limiting_set"]), (key, judged, "first"))
                bins = [(one["share"] / one[f"sets.first.{key}"], one) for one in spectrum["bins"]]
                self.assertAlmostEqual(1.0 / sum(part for part, _ in bins) / judged, 1.0, delta=ROUND_OFF)
                for part, one in bins:
                    self.assertAlmostEqual(one["damage_share"], part * judged, delta=ROUND_OFF)
                    self.assertEqual(one["worst_bearing_h"], one[f"sets.first.{key}"])
            elif name == "tilt computed":
                by = program.answer("sensitivities", self.files[name, True], options=("--by", "input.power"))
                self.assertEqual((by["quantity"], by[key], by["of_set"]), (key, judged, "first"))
            if tiles[name]:
                self.assertEqual(tiles[name], [f"Governing life, L10mrh, {'load spectrum, ' if spectrum else ''}set first", judged])

        self.each(test)

    def tiles(self, runs):
        script = (program.CASES.parent / "page" / "web" / "tiles.js").resolve().as_uri()
        done = subprocess.run([NODE, "--input-type=module", "-e", TILES, script], input=json.dumps(runs), capture_output=True, text=True, check=False, timeout=program.SECONDS)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_text_says_which_bearing_of_which_set_and_shows_both(self):
        text = program.run("run", self.files["tilt computed", True]).stdout
        life = self.verdict(self.runs["tilt computed", True], "life")["value"]
        self.assertRegex(text, rf"life \(shortest L10mrh\) +{life:.6g} at least +10000 h +FAILED, set first, ")
        point = self.runs["tilt computed", True]["points"][0]
        for name in ("first", "second"):
            line = next(line for line in text.splitlines() if line.startswith(f"{name} "))
            self.assertIn(f" {point[f'sets.{name}.S0']:.4g} ", line)
            self.assertEqual("limiting set" in line, name == "first")
        self.assertNotIn("limiting set: status", text)
        self.assertIn("set first:\nlife of one bearing", text)

    def test_page_of_the_report(self):
        from orbearing import assessor
        from orbearing.result_folder import Report
        from orbearing.summary import headline

        for name in ("tilt computed", "tilt computed, spectrum"):
            run = self.runs[name, True]
            report, judged = Report({**run, "fidelity": "quasi-static", "own_speed_rpm": 18.0}), self.verdict(run, "life")["value"]
            self.assertIn("shortest L10mrh of the planet bearing of set first", headline(report))
            self.assertIn(orbearing_number(judged, 3), headline(report))
            columns = {one.head.split(",")[0]: one.number("L10mrh") for one in assessor._columns(report)}  # pylint: disable=protected-access
            self.assertEqual(list(columns), ["Mean of bearings of set first", "Worst bearing of set first", "One bearing of set second", "All bearings"])
            self.assertEqual(columns["Worst bearing of set first"], judged)
            self.assertIn(f"{'FAILED' if judged < 10000.0 else 'passed'}, set first<", "".join(assessor.sections(report)))

    def test_uncertainty_follows_the_limiting_set(self):
        """Point by point: a set with bearings that carry alike has no shortest life."""
        import numpy as np
        from orbearing.uncertainties.lives import lives_of_worst_bearing

        columns = {"L10mrh": np.array([3.0, 5.0, 7.0]), "shortest_L10mrh": np.array([2.0, np.nan, 6.0]), "carrier_L10mrh": np.array([np.nan, np.nan, 1.0])}
        self.assertEqual(lives_of_worst_bearing("L10mrh", columns).tolist(), [2.0, 5.0, 1.0])


def orbearing_number(value, digits):
    from orbearing.blocks import format_number

    return format_number(value, digits)


if __name__ == "__main__":
    unittest.main()
