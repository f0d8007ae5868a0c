#!/usr/bin/env python3
"""Text and report begin with the table of lives and say which to design by.

Exit code 77 (skipped) where matplotlib is missing.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import matplotlib  # noqa: F401
except ImportError:
    print("skipped: matplotlib is missing")
    sys.exit(77)

from program import BRIEF_GEARS

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", "."))
REDUCER = SOURCE / "cases" / "reducer_150kW" / "case.yaml"
MOTOR = SOURCE / "cases" / "deep_groove_motor" / "case.yaml"
OIL = ("lubricant.grade=ISO VG 220", "lubricant.temperature=80 degC", "life.cleanliness=-/15/12")
LIVES = ("L10h", "L10rh", "L10mh", "L10mrh", "life_h")
SECONDS = 600


def call(*arguments, settings=()):
    options = [part for setting in settings for part in ("--set", setting)]
    done = subprocess.run([os.environ["ORBEARING"], *map(str, arguments), *options], capture_output=True, text=True, timeout=SECONDS, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def number(text):
    return float(text.replace(",", ""))


class Planets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.place.cleanup)
        cls.folder = pathlib.Path(cls.place.name) / "out"
        cls.text = call("sweep", REDUCER, "-o", cls.folder, "--grid-only",
                        settings=(*OIL, *BRIEF_GEARS, "sweep={input.speed: [3000 rpm, 6000 rpm, 9000 rpm]}"))
        call("report", cls.folder)
        cls.page = (cls.folder / "report.html").read_text(encoding="utf-8")
        lines = (cls.folder / "sweep.csv").read_text(encoding="utf-8").splitlines()
        rows = [dict(zip(lines[0].split(","), line.split(","))) for line in lines[1:]]
        cls.row = max(rows, key=lambda row: float(row["life_h"]))

    def test_text(self):
        lines = self.text.splitlines()
        self.assertIn(f"at {float(self.row['input_speed_rpm']):g} rpm", lines[0])
        self.assertEqual([line.split()[0] for line in lines[2:7]], list(LIVES))
        for line in lines[2:7]:
            self.assertAlmostEqual(float(line.split()[1]) / float(self.row[line.split()[0]]), 1.0, delta=1e-5, msg=line)
        for key, revolutions in (("L10h", "L10_Mrev"), ("L10rh", "L10r_Mrev"), ("L10mh", "L10m_Mrev"), ("L10mrh", "L10mr_Mrev"), ("life_h", "life_Mrev")):
            (line,) = [one for one in lines[2:7] if one.split()[0] == key]
            self.assertAlmostEqual(float(line.split()[2]) / float(self.row[revolutions]), 1.0, delta=1e-5, msg=line)
        self.assertIn("Governing life: life_h (life.method)", self.text)
        for symbol, column in (("C", "C_N"), ("P", "P_N"), ("C/P", "C_over_P"), ("S0", "S0"), ("contact pressure", "contact_pressure_max_MPa"),
                               ("kappa", "kappa"), ("e_C", "e_C"), ("a_ISO", "a_ISO"), ("a_ISO_r", "a_ISO_r")):
            found = re.search(rf"(?:^|, ){re.escape(symbol)} ([0-9.e+]+)", self.text, re.MULTILINE)
            self.assertAlmostEqual(float(found.group(1)) / float(self.row[column]), 1.0, delta=1e-4, msg=symbol)

    def test_page(self):
        start, end = self.page.index('<section id="lives">'), self.page.index("<th scope=\"col\">Result</th>")
        self.assertLess(start, end)
        section = self.page[start:end]
        for life in LIVES:
            cells = re.search(rf'<td class="short">{life}</td><td class="number">([^<]+)</td><td class="number">([^<]+)</td><td>([^<]+)</td>', section)
            self.assertIsNotNone(cells, life)
            self.assertAlmostEqual(number(cells.group(1)) / float(self.row[life]), 1.0, delta=1e-4, msg=life)
            self.assertIn("Lundberg-Palmgren" if life == "life_h" else "ISO", cells.group(3))
        self.assertIn("Governing life: life_h (life.method)", section)
        self.assertIn(f"At {float(self.row['input_speed_rpm']):,.0f} rpm", section)
        self.assertIn("a_ISO_r", section)

    def test_without_oil_the_advice_asks_for_it(self):
        text = call("run", REDUCER, "-o", pathlib.Path(self.place.name) / "dry", settings=("life.method=iso-16281",))
        self.assertTrue(text.startswith("life of one bearing"))
        self.assertIn("Governing life: L10rh (life.method)", text)
        self.assertIn("life.cleanliness", text)
        self.assertRegex(text, r"L10mh +- +-")

    def test_spectrum_by_each_life(self):
        # Miner's rule for each of the lives; the shares of the damage go by life.method.
        rows = "spectrum=[{power: 150 kW, speed: 6000 rpm, share: 0.3}, {power: 100 kW, speed: 2000 rpm, share: 0.7}]"
        found = json.loads(call("run", REDUCER, "--json", settings=(*OIL, rows, "life.method=iso-16281")))["spectrum"]
        self.assertEqual(found["life_key"], "L10mrh")
        for life in LIVES:
            for name in (life, f"system_{life}"):
                used = sum(one["share"] / one[name] for one in found["bins"])
                self.assertAlmostEqual(used * found[name], 1.0, delta=1e-9, msg=name)
        for one in found["bins"]:
            self.assertAlmostEqual(one["damage_share"], one["share"] / one["L10mrh"] * found["L10mrh"], delta=1e-9)
            self.assertAlmostEqual(one["damage_share_L10mh"], one["share"] / one["L10mh"] * found["L10mh"], delta=1e-9)


class BallsInMotion(unittest.TestCase):
    def test_lives_of_cube_means(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "out"
            settings = ("simulation.duration=0.05 s", "simulation.start=rolling", "lubricant.kinematic_viscosity=23 mm2/s", "life.cleanliness=high",
                        "drag.enabled=false")
            text = call("run", MOTOR, "-o", folder, settings=settings)
            found = json.loads(call("run", folder / "case.resolved.yaml", "--json"))
            call("report", folder)
            page = (folder / "report.html").read_text(encoding="utf-8")
        warnings, _, lives = text.partition("\n\n")
        self.assertRegex(warnings, r"^warning: drag\.mixture: at-rest has no effect: .*drag\.enabled")
        self.assertNotIn("\n", warnings)
        self.assertTrue(lives.startswith("life of one bearing"), text[:400])
        self.assertIn("exponent 3", text)
        self.assertAlmostEqual(found["life_h"] / found["L10rh"], 1.0, delta=1e-9)  # one law, by the same means
        self.assertAlmostEqual(found["L10_Mrev"] / (found["C_N"] / found["P_N"]) ** 3, 1.0, delta=1e-9)
        self.assertAlmostEqual(found["L10mh"] / (found["a_ISO"] * found["L10h"]), 1.0, delta=1e-9)
        self.assertAlmostEqual(found["L10mrh"] / (found["a_ISO_r"] * found["L10rh"]), 1.0, delta=1e-9)
        self.assertAlmostEqual(found["L10h"] * 60e-6 * 1730.0 / found["L10_Mrev"], 1.0, delta=1e-9)
        # A stationary load: the mean over time is near that of the balance, which the standard rates.
        self.assertEqual(found["P_N"], 938.0)
        self.assertGreater(found["contact_pressure_max_MPa"], 1000.0)
        self.assertLess(page.index('<section id="lives">'), page.index("<th scope=\"col\">Quantity</th>"))
        self.assertIn(f"Governing life: {found['life_table']['governing']} (life.method)", page)


if __name__ == "__main__":
    if "ORBEARING" not in os.environ:
        print("skipped: ORBEARING does not name the program")
        sys.exit(77)
    unittest.main()
