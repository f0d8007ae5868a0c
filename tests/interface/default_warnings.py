#!/usr/bin/env python3
"""`check` warns where a life hangs on a default, and of what load sharing costs."""

import re
import unittest

from program import CASES, REDUCER, WIND, answer

HANGS = re.compile(r"(\S+): not stated; with 10 % more than the default, (.+), (\S+) changes by ([+-]\d+) %")
SHARING = re.compile(r"gearset.dynamics.pin_error: .* K_gamma (\S+) and a shortest life_h of (\S+) h, ([+-]\d+) % against (\S+) h")


def effects(case, *values):
    found = {}
    for warning in answer("check", case, *values)["warnings"]:
        if match := HANGS.fullmatch(warning):
            found[match[1]] = (match[2], match[3], int(match[4]))
    return found


def sharing(case, *values):
    return [match.groups() for warning in answer("check", case, *values)["warnings"] if (match := SHARING.fullmatch(warning))]


class Defaults(unittest.TestCase):
    def test_effect_is_that_of_a_run_with_the_value(self):
        found = effects(WIND, "bearing.tilt_state=stated")
        self.assertIn("life.reduction_factor", found)
        self.assertLessEqual(len(found), 3)
        for path, (given, key, percent) in found.items():
            number, _, unit = given.partition(" ")
            here, there = (answer("run", WIND, "bearing.tilt_state=stated", *values)["points"][0][key]
                           for values in ((), (f"{path}={1.1 * float(number)!r} {unit}",)))
            self.assertAlmostEqual(100 * (there / here - 1), percent, delta=0.5)
            self.assertGreaterEqual(abs(there / here - 1), 0.1)

    def test_what_is_stated_is_no_default(self):
        self.assertNotIn("life.reduction_factor", effects(WIND, "life.reduction_factor=0.83"))
        self.assertNotIn("life.reduction_factor", effects(REDUCER))
        self.assertNotIn("input.application_factor", effects(REDUCER))

    def test_elastic_rims_and_single_bearings_too(self):
        self.assertIn("material.density", effects(REDUCER, "gearset.planet_rim=elastic", "material.density=7850 kg/m3") | effects(CASES / "reducer_nu204"))
        self.assertEqual(effects(CASES / "mesh_62_62"), {})
        answer("check", CASES / "harris_209")

    def test_one_pin_off(self):
        (share, shortest, percent, even), = sharing(REDUCER)
        rows = {row["path"]: row["value"] for row in answer("check", REDUCER)["derived"]}
        self.assertAlmostEqual(float(share), rows["one_pin_off.load_share"], 2)
        self.assertAlmostEqual(float(shortest), rows["one_pin_off.shortest_life"], delta=1)
        self.assertAlmostEqual(float(even), answer("run", REDUCER)["points"][0]["life_h"], delta=1)
        self.assertAlmostEqual(100 * (float(shortest) / float(even) - 1), int(percent), delta=0.6)
        self.assertEqual(sharing(REDUCER, "gearset.dynamics.pin_error.tangential=[5 um, 0 um, 0 um, 0 um]"), [])
        self.assertEqual(sharing(REDUCER, "gearset.planets=1"), [])


if __name__ == "__main__":
    unittest.main()
