#!/usr/bin/env python3
"""Values that no machine has: a warning beside rare ones, the status of the point where they are impossible, in every analysis."""

import json
import os
import pathlib
import sys
import tempfile
import unittest

import program

WIND = """name: wind_stage
source: made up
model: planetary-drivetrain
input: {member: carrier, power: 2094.4 kW, speed: 20 rpm}
gearset:
  planets: 3
  teeth: {sun: 20, planet: 37, ring: 94}
  module: 13 mm
  profile_shift: {sun: 0, ring: 0}
  face_width: 280 mm
bearing:
  type: cylindrical-roller
  per_planet: 2
  rollers: 17
  roller_diameter: 42 mm
  roller_length: 72 mm
  pitch_diameter: 283 mm
  radial_clearance: 80 um
  bore: 200 mm
  outside_diameter: 360 mm
  width: 98 mm
  cage: {material: brass, inner_diameter: 268 mm, outer_diameter: 310 mm, width: 90 mm}
lubricant: {grade: ISO VG 320, temperature: 65 degC}
"""
STATIC = program.CASES / "harris_209" / "case.yaml"
BALLS = program.CASES / "ball_6305_iso16281" / "case.yaml"


class PlausibleValues(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        self.case = self.folder / "case.yaml"
        self.case.write_text(WIND, encoding="utf-8")

    def test_a_usual_stage_is_not_warned_of(self):
        found = program.answer("run", self.case)
        self.assertEqual(found["points"][0]["status"], "ok")
        for word in ("contact: ", "operation: ", "unit load", "tooth force"):
            self.assertFalse(program.warned(found, word), (word, found["warnings"]))

    def test_milliwatts_for_megawatts(self):
        point, warnings = self.point("input.power=2.0944 mW")
        self.assertRegex(point["status"], r"^implausible: life [0-9.e+]+ h \(at most 1e\+12 h: check power, speed")
        self.assertGreater(point["life_h"], 1e12)
        self.assertTrue(any(w.startswith("life: life above 1e+07 h") for w in warnings), warnings)
        self.assertTrue(any("tooth force over face width and module below 0.001 MPa" in w for w in warnings), warnings)

    def test_a_carrier_as_fast_as_a_turbine(self):
        point, warnings = self.point("input.speed=20000 rpm")
        self.assertTrue(point["status"].startswith("implausible: speed n d_m "), point["status"])
        self.assertGreater(point["contact_pressure_max_MPa"], 10000)
        for text in ("contact: pressure above 4000 MPa, where rollers yield", "operation: speed n d_m above 1.5e+06 mm rpm",
                     "operation: pitch line speed against the carrier above 200 m/s"):
            self.assertTrue(any(w.startswith(text) for w in warnings), (text, warnings))

    def test_values_stay_in_files_and_report(self):
        done = program.run("run", self.case, "-o", self.folder / "r", "--set", "input.power=2.0944 mW")
        self.assertEqual(done.returncode, 0, done.stderr)
        row = dict(zip(*(line.split(",") for line in (self.folder / "r" / "sweep.csv").read_text(encoding="utf-8").splitlines()[:2])))
        self.assertGreater(float(row["life_h"]), 1e12)

    def test_a_ring_that_tilts_freely(self):
        found = program.answer("run", BALLS, "load.radial=4 kN", "load.axial=1 kN")
        warned = program.warned(found, "load: tilt of the inner ring")
        self.assertEqual(bool(warned), abs(found["tilt_mrad"]) > 3.0)
        self.assertTrue(program.warned(program.answer("run", BALLS, "load.tilt=-3.5 mrad"), "load: tilt of the inner ring below -3 mrad"))
        self.assertFalse(program.warned(program.answer("run", BALLS, "load.tilt=0 mrad"), "load: tilt of the inner ring"))

    def test_single_bearings(self):
        found = program.answer("run", STATIC, "load.radial=4e7 N")
        self.assertRegex(found["status"], r"^implausible: C/P 0\.00121.* \(at least 0\.2: the load is several times the rating C\)$")
        self.assertTrue(program.warned(found, "contact: pressure above 4000 MPa"))
        usual = program.answer("run", STATIC)
        self.assertNotIn("status", usual)
        fast = program.answer("run", BALLS, "operation.shaft_speed=5e5 rpm", "operation.outer_speed=0 rpm")
        self.assertTrue(program.warned(fast, "operation: speed n d_m above 1.5e+06 mm rpm"), fast["warnings"])

    def test_meshes(self):
        gears = "\n".join(line for line in WIND.split("bearing:")[0].splitlines())
        self.case.write_text(gears, encoding="utf-8")
        self.assertTrue(program.warned(program.answer("mesh", self.case, "input.power=200 MW"), "tooth force over face width and module above 400 MPa"))
        self.assertFalse(program.warned(program.answer("mesh", self.case), "tooth force"))

    def point(self, *settings):
        found = program.answer("run", self.case, *settings)
        return found["points"][0], found["warnings"]


if __name__ == "__main__":
    if "ORBEARING" not in os.environ:
        print("skipped: ORBEARING does not name the program")
        sys.exit(77)
    unittest.main()
