#!/usr/bin/env python3
"""Lives by ISO/TS 16281 do not depend on the number of laminae; `run` and `crown` give the same roller the same life; a program of the standard written here agrees."""

import json
import math
import pathlib
import tempfile
import unittest

import numpy

from program import CASES, answer, run, settings

INDUSTRIAL = CASES / "templates" / "industrial.yaml"
AGREE = 0.005  # of lives with 30 to 200 laminae
PRINTED = 1e-4  # relative, of six digits: another search of the same root
STANDARD = 0.01  # of lives by another program
NUMBERS = (30, 40, 60, 100, 200)
LIVES = ("L10rh", "L10mrh")


def bearing(name, rollers, diameter, length, pitch, clearance_um, radial, capacity, profile):
    """A case of one roller bearing [mm, N] with the standard's contact constant."""
    return f"""
name: {name}
model: roller-bearing
source: sizes of a catalogue bearing
load: {{radial: {radial} N}}
bearing:
  type: cylindrical-roller
  rollers: {rollers}
  roller_diameter: {diameter} mm
  roller_length: {length} mm
  pitch_diameter: {pitch} mm
  radial_clearance: {clearance_um} um
  dynamic_capacity: {capacity} N
  laminae: 30
  profile: {{kind: {profile}}}
contact: {{law: iso16281}}
"""


# Eqs. (12) to (20) of ISO/TS 16281:2008 as formulas of N and mm, inner ring rotating, a roller on the load line.
def reference_life(rollers, diameter, length, pitch, clearance_um, radial, capacity, profile, laminae=30):
    """[Mrev] L10r."""
    middle = (numpy.arange(laminae) + 0.5) / laminae * 2.0 - 1.0  # of half the length
    drop = numpy.zeros(laminae)
    if profile == "iso16281":
        if length <= 2.5 * diameter:
            drop = -0.00035 * diameter * numpy.log(1.0 - middle**2)
        else:
            beyond = (numpy.abs(middle) * length - (length - 2.5 * diameter)) / (2.5 * diameter)
            drop = numpy.where(beyond > 0.0, -0.0005 * diameter * numpy.log(1.0 - numpy.maximum(beyond, 0.0) ** 2), 0.0)
    angle = 2.0 * math.pi * numpy.arange(rollers) / rollers

    def loads(shift):
        approach = shift * numpy.cos(angle)[:, None] - 0.5e-3 * clearance_um - 2.0 * drop[None, :]
        return 35948.0 * length ** (8.0 / 9.0) / laminae * numpy.maximum(approach, 0.0) ** (10.0 / 9.0)

    low, high = 0.0, 1.0
    for _ in range(200):
        shift = 0.5 * (low + high)
        low, high = (shift, high) if (loads(shift) * numpy.cos(angle)[:, None]).sum() < radial else (low, shift)
    k = numpy.arange(1, laminae + 1)
    riser = 1.0 - 0.01 / numpy.log(1.985 * numpy.abs(2 * k - laminae - 1) / (2 * laminae - 2))
    stressed = riser * loads(shift)
    gamma = diameter / pitch
    ratio = 1.038 * ((1.0 - gamma) / (1.0 + gamma)) ** (143.0 / 108.0)
    inner = capacity / (0.83 * 0.378 * rollers) * (1.0 + ratio**4.5) ** (2.0 / 9.0)
    outer = capacity / (0.83 * 0.364 * rollers) * (1.0 + ratio**-4.5) ** (2.0 / 9.0)
    rotating = numpy.mean(stressed**4, axis=0) ** 0.25 / (inner * laminae ** (-7.0 / 9.0))
    stationary = numpy.mean(stressed**4.5, axis=0) ** (1.0 / 4.5) / (outer * laminae ** (-7.0 / 9.0))
    return (rotating**4.5 + stationary**4.5).sum() ** (-8.0 / 9.0)


BEARINGS = {
    "NU 2207": (14, 10.0, 13.0497, 54.0, 19.77, 6987.4, 61500.0),
    "NU 210": (16, 11.0, 11.0, 70.4, 40.0, 6000.0, 66000.0),
    "K 14x18x17": (14, 2.0, 13.8, 16.0, 15.0, 1500.0, 12000.0),
}


class NumberOfLaminae(unittest.TestCase):
    def lives(self, profile, *values):
        point = answer("run", INDUSTRIAL, f"bearing.profile.kind={profile}", *values)["points"][0]
        return {key: point[key] for key in (*LIVES, "life_h")}

    def test_lives_agree_from_thirty_laminae_on(self):
        for profile in ("straight", "iso16281", "circular"):
            base = self.lives(profile, "bearing.laminae=30")
            for laminae in NUMBERS[1:]:
                found = self.lives(profile, f"bearing.laminae={laminae}")
                for key in LIVES:
                    self.assertLess(abs(found[key] / base[key] - 1.0), AGREE, f"{profile}, {laminae} laminae: {key} {found[key]} for {base[key]}")

    def test_whole_rollers_have_the_lives_of_thirty_laminae(self):
        for profile in ("straight", "iso16281"):
            whole, cut = self.lives(profile), self.lives(profile, "bearing.laminae=30")
            for key in LIVES:
                self.assertLess(abs(whole[key] / cut[key] - 1.0), PRINTED, f"{profile}: {key}")
        self.assertEqual(self.lives("straight")["life_h"], self.lives("iso16281")["life_h"])

    def test_the_formula_of_the_standard_depends_on_the_number(self):
        def life(laminae):
            return answer("run", INDUSTRIAL, "bearing.profile.kind=straight", f"bearing.laminae={laminae}",
                          "life.stress_riser=standard")["points"][0]["L10rh"]
        self.assertGreater(life(100), 1.3 * life(40))

    def test_rollers_without_a_stated_profile_have_that_of_the_standard(self):
        point = answer("run", INDUSTRIAL)["points"][0]
        self.assertEqual({key: point[key] for key in LIVES}, {key: self.lives("iso16281")[key] for key in LIVES})
        rows = {row["path"]: row for row in answer("check", INDUSTRIAL)["inputs"]}
        self.assertEqual(rows["bearing.profile.kind"]["standing"], "assumed")

    def test_fewer_than_thirty_straight_laminae(self):
        refused = run("run", INDUSTRIAL, *settings(["bearing.laminae=20", "bearing.profile.kind=straight"]))
        self.assertEqual(refused.returncode, 2)
        self.assertIn("bearing.laminae: 20 laminae of straight rollers with life.method: iso-16281; at least 30 are required", refused.stderr)
        found = answer("run", INDUSTRIAL, "bearing.laminae=20", "bearing.profile.kind=straight", "life.method=lundberg-palmgren")
        self.assertIsNone(found["points"][0]["L10rh"])
        self.assertTrue(any("L10rh and L10mrh are left out" in text for text in found["warnings"]))

    def test_in_motion_the_profile_lies_under_the_load_of_each_passage(self):
        short = ("simulation.most_revolutions=4", "simulation.observed_revolutions=2")
        moving = {profile: answer("run", INDUSTRIAL, f"bearing.profile.kind={profile}", *short, options=["--fidelity", "dynamic"])["points"][0]
                  for profile in ("straight", "iso16281")}
        self.assertEqual(moving["straight"]["life_h"], moving["iso16281"]["life_h"])
        at_rest = {profile: self.lives(profile)["L10rh"] for profile in moving}
        gain, gain_at_rest = (lives["iso16281"] / lives["straight"] for lives in
                              ({profile: point["L10rh"] for profile, point in moving.items()}, at_rest))
        self.assertLess(abs(gain / gain_at_rest - 1.0), 0.1)  # loads of whole rollers are shared otherwise among the rollers


class Standard(unittest.TestCase):
    def test_another_program(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, sizes in BEARINGS.items():
                for profile in ("straight", "iso16281"):
                    file = pathlib.Path(folder) / "case.yaml"
                    file.write_text(bearing(name, *sizes, profile))
                    ours, theirs = answer("run", file)["L10r_Mrev"], reference_life(*sizes, profile)
                    self.assertLess(abs(ours / theirs - 1.0), STANDARD, f"{name}, {profile}: {ours} for {theirs}")


class Crown(unittest.TestCase):
    def test_the_same_roller_has_the_same_life_as_in_run(self):
        tilted = ("bearing.tilt_state=computed", "bearing.laminae=30")
        crown = answer("crown", INDUSTRIAL, *tilted)
        self.assertEqual(crown["life_key"], "L10mrh")
        for design, profile in (("straight", "straight"), ("reference", "iso16281")):
            point = answer("run", INDUSTRIAL, *tilted, f"bearing.profile.kind={profile}")["points"][0]
            self.assertLess(abs(crown[design]["L10rh"] / min(point["L10rh"], point.get("shortest_L10rh") or math.inf) - 1.0), 0.02, design)
            self.assertEqual(crown[design]["governing_life_h"], crown[design]["L10mrh"])


if __name__ == "__main__":
    unittest.main()
