#!/usr/bin/env python3
"""An input that is stated, or varied, with the value that it has anyway changes no result, to the last digit, and no other input loses its effect.
Every number of each template, and of a bearing that a designation alone states: its class, state of clearance, sizes, ratings and cage are defaults."""

import pathlib
import random
import unittest

import numpy as np

import program
from program import CASES, LEFT_TO_FULL

orbearing = program.package()

DESIGNATED = """name: designated
source: made up
model: planetary-drivetrain
input: {member: sun, power: 55 kW, speed: 1480 rpm}
gearset: {planets: 3, teeth: {sun: 18, planet: 33, ring: 84}, module: 3 mm, profile_shift: {sun: 0, ring: 0}, face_width: 40 mm}
bearing:
  designation: NJ 2206
  per_planet: 2
  fit: {pin_class: k5, planet_class: N6}
  temperature: {pin: 75 degC, inner_ring: 75 degC, rollers: 75 degC, outer_ring: 72 degC, planet: 70 degC}
lubricant: {grade: ISO VG 220, temperature: 70 degC}
life: {cleanliness: -/17/14}
"""
CLEARANCE = "bearing.radial_clearance"
NUMBERS = ("quantity", "number", "integer")
DRAWN = 2  # numbers of each other model, whose run takes longer
SEED = random.SystemRandom().randrange(10**6)


def numbers_of(case):
    return [row["path"] for row in case.inputs if row["kind"] in NUMBERS and row["given"] is not None]


def stated_of(case):
    return [row["path"] for row in case.inputs if row["source"] == "given"]


class OwnValues(unittest.TestCase):
    def same(self, wanted, found, said):
        self.assertEqual(found[0], wanted[0], said)
        np.testing.assert_array_equal(found[1], wanted[1], said)
        self.assertEqual(found[2], wanted[2], said)

    def check_planets(self, case):
        speed = [["input.speed"], [[case["input.speed"]]]]
        wanted, stated = case.evaluate(*speed), stated_of(case)
        idle = case.core.without_effect(stated)
        for path in numbers_of(case):
            own = case[path]
            other = case.copy({path: own})
            self.same(wanted, other.evaluate(*speed), path)
            self.assertLessEqual(set(other.core.without_effect(stated)), {*idle, path}, path)
            if path not in case.core.without_effect([path]):
                self.same(wanted, case.evaluate([path], [[own]]), path)

    def test_of_a_designation(self):
        self.check_planets(orbearing.parse(DESIGNATED))

    def test_of_an_own_row_without_rings(self):
        """The needles of a user's own catalogue: their clearance is the running one."""
        row = ("designation, family, width_mm, inner_raceway_mm, outer_raceway_mm, dynamic_capacity [kN], static_capacity [kN]\n"
               "K 30x36x17, needle-roller-cage, 17, 30, 36, 20.1, 33.5\n")
        case = orbearing.parse(DESIGNATED, settings={"bearing": {"catalogue": row, "designation": "K 30x36x17", "per_planet": 2, "radial_clearance": "20 um", "cage": {"material": "steel"}}})
        self.assertEqual(case["bearing.clearance_state"], "operating")
        self.check_planets(case)
        said = [text for text in case.check().data["warnings"] if text.startswith("bearing.dynamic_capacity: not stated")]
        self.assertEqual(len(said), 1)
        self.assertIn("10 % more than 20100 N of K 30x36x17", said[0])

    def test_of_templates(self):
        draw = random.Random(SEED)
        files = sorted((CASES / "templates").glob("*.yaml"))
        for file in draw.sample(files, DRAWN) if LEFT_TO_FULL else files:
            case = orbearing.load(file, {"sweep": None})
            with self.subTest(case=file.stem, seed=SEED):
                if case.model == "planetary-drivetrain":
                    self.check_planets(case.copy({"spectrum": None}))
                    continue
                if LEFT_TO_FULL and case.model == "raceway-defect":
                    continue
                wanted, paths = case.run().data, numbers_of(case)
                for path in draw.sample(paths, DRAWN) if LEFT_TO_FULL else paths:
                    found = case.copy({path: case[path]}).run().data
                    self.assertEqual([key for key in wanted if key not in ("assumptions", "warnings") and found[key] != wanted[key]], [], path)


class Clearance(unittest.TestCase):
    """Before mounting, in each analysis that varies it: the fits and temperatures count."""

    def setUp(self):
        self.case = orbearing.parse(DESIGNATED)
        self.own = self.case[CLEARANCE]
        self.life = self.lives([self.own])[0]

    def lives(self, clearances):
        columns, numbers, _ = self.case.evaluate([CLEARANCE], [[one] for one in clearances])
        return list(numbers[:, columns.index("L10mrh")])

    def test_it_is_that_before_mounting(self):
        self.assertEqual(self.case["bearing.clearance_state"], "unmounted")
        stated = self.case.copy({"bearing.clearance_state": "unmounted", CLEARANCE: 1.1 * self.own})
        varied = self.case.copy({CLEARANCE: 1.1 * self.own})
        self.assertEqual(varied["bearing.clearance_state"], "unmounted")
        self.assertIsNone(varied["bearing.clearance_class"])
        np.testing.assert_array_equal(*(one.evaluate(["input.speed"], [[one["input.speed"]]])[1] for one in (stated, varied)))
        self.assertEqual(self.case.copy({"bearing.rings": "outer", CLEARANCE: "20 um"})["bearing.clearance_state"], "operating")
        running = self.case.copy({"bearing.clearance_state": "operating", CLEARANCE: self.own})
        self.assertNotEqual(running.run().data["points"][0]["L10mrh"], self.life)

    def test_study_sweep_and_slopes(self):
        studied = self.case.study({CLEARANCE: [f"{1e6 * self.own!r} um"], "input.speed": ["1480 rpm"]}, progress=False)
        self.assertEqual(studied.variants()[0]["peak_life_h"], self.life)
        swept = self.case.copy({"sweep": {CLEARANCE: [f"{1e6 * self.own!r} um"]}}).sweep().data["points"]
        self.assertEqual(swept[0]["L10mrh"], self.life)
        row, = self.case.sensitivities(by=[CLEARANCE]).data["inputs"]
        low, high = self.lives([0.999 * self.own, 1.001 * self.own])
        self.assertAlmostEqual(row["elasticity"], np.log(high / low) / 0.002, delta=5e-3)

    def test_uncertain_by_its_class(self):
        """The lives of samples lie between those of both ends of the class."""
        found = self.case.copy({"uncertain": {CLEARANCE: {"class": "CN"}}}).uncertainty(samples=8, curves=2, index_samples=2, speeds_rpm=[1000.0, 1480.0]).to_xarray()
        longest, shortest = self.lives([20e-6, 45e-6])
        lives = found["life"].values
        self.assertTrue(np.all((lives >= shortest) & (lives <= longest)), (lives, shortest, longest))


if __name__ == "__main__":
    unittest.main()
