#!/usr/bin/env python3
"""Planets in pairs, in mesh with each other, at rest."""

import math
import tempfile
import unittest
from pathlib import Path

from program import CASES, answer, run, settings

REDUCER = CASES / "reducer_150kW" / "case.yaml"
PAIRS = ("gearset.teeth.ring=121", "gearset.second_planet.teeth=24", "gearset.profile_shift.sun=0", "gearset.profile_shift.ring=0")


def point(*values):
    return answer("run", REDUCER, *PAIRS, *values)["points"][0]


class PlanetPairs(unittest.TestCase):
    def test_speeds_and_sizes(self):
        """Distances m (z_1 + z_2)/2 of 88.5 and 145.5 mm; the carrier turns by 1/(1 - 121/37) of the sun."""
        found = {row["path"]: row["value"] for row in answer("check", REDUCER, *PAIRS)["derived"]}
        self.assertAlmostEqual(found["sets.first_planet.gearset.centre_distance"], 88.5, delta=1e-9)
        self.assertAlmostEqual(found["sets.second_planet.gearset.centre_distance"], 145.5, delta=1e-9)
        self.assertAlmostEqual(found["sets.second_planet.gearset.planet_distance"], 69.0, delta=1e-9)
        cosine = (88.5 ** 2 + 145.5 ** 2 - 69.0 ** 2) / (2 * 88.5 * 145.5)
        self.assertAlmostEqual(found["sets.second_planet.gearset.pair_angle"], math.degrees(math.acos(cosine)), delta=1e-9)
        self.assertAlmostEqual(found["sets.first_planet.operation.carrier_speed"], 6000 / (121 / 37 - 1), delta=1e-6)

    def test_each_mesh_is_its_own(self):
        """Working angles by cos(a_w) = m (z_1 +- z_2)/2 cos(a) over the distance of its own axes, all three unlike by shifts."""
        shifts = ("gearset.profile_shift.sun=0.3", "gearset.second_planet.first_profile_shift=0.1", "gearset.second_planet.profile_shift=0.25", "gearset.profile_shift.ring=-0.2")
        found = {row["path"]: row["value"] for row in answer("check", REDUCER, *PAIRS, *shifts)["derived"]}
        first, second = "sets.first_planet.gearset.", "sets.second_planet.gearset."
        angles = []
        for mesh, distance, teeth in ((first + "sun_mesh", first + "centre_distance", 37 + 22), (second + "planet_mesh", second + "planet_distance", 22 + 24),
                                      (second + "ring_mesh", second + "centre_distance", 121 - 24)):
            angle = math.radians(found[mesh + ".pressure_angle"])
            self.assertAlmostEqual(math.cos(angle) * found[distance] / (3 * teeth / 2 * math.cos(math.radians(20))), 1, delta=1e-9, msg=mesh)
            angles.append(angle)
        self.assertGreater(min(abs(one - other) for one, other in ((angles[0], angles[1]), (angles[1], angles[2]), (angles[0], angles[2]))), 1e-3)
        ratios = [found[mesh + ".contact_ratio"] for mesh in (first + "sun_mesh", second + "planet_mesh", second + "ring_mesh")]
        self.assertEqual(len({round(ratio, 6) for ratio in ratios}), 3, ratios)

    def test_both_pins_carry_the_torque(self):
        """Without centrifugal loads: N (a_1 F_1t + a_2 F_2t) over both bearings of a planet is the torque of the carrier."""
        found = {row["path"]: row["value"] for row in answer("check", REDUCER, *PAIRS, "inertia.carrier_centrifugal=false")["derived"]}
        torque = 150e3 / (6000 * math.pi / 30) * (121 / 37 - 1)
        moment = 4 * 2 * sum(found[f"sets.{planet}_planet.operation.bore_load_y"] * arm for planet, arm in (("first", 0.0885), ("second", 0.1455)))
        self.assertAlmostEqual(abs(moment) / torque, 1, delta=1e-9)

    def test_loads_and_lives_of_both_planets(self):
        found = point()
        self.assertIn(found["limiting_set"], ("first_planet", "second_planet"))
        lives = {name: found[f"sets.{name}.life_h"] for name in ("first_planet", "second_planet")}
        self.assertEqual(min(lives, key=lives.get), found["limiting_set"])
        self.assertAlmostEqual(found["life_h"], min(lives.values()), delta=1e-9 * found["life_h"])
        self.assertLess(found["system_life_h"], found["life_h"])
        other = point("gearset.second_planet.side=behind")
        key = "sets.first_planet.planet_load_N"
        self.assertNotAlmostEqual(other[key] / found[key], 1, delta=1e-3)

    def test_a_sweep_has_columns_of_both(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("sweep", REDUCER, *settings((*PAIRS, "sweep.input.speed={from: 3000 rpm, to: 6000 rpm, step: 3000 rpm}")), "-o", Path(folder) / "out")
            self.assertEqual(result.returncode, 0, result.stderr)
            head = (Path(folder) / "out" / "sweep.csv").read_text(encoding="utf-8").splitlines()[0]
            self.assertIn("second_planet", head)

    def test_what_is_not_computed_is_refused(self):
        for command, *options in (("run", "--fidelity", "dynamic"), ("run", "--fidelity", "monolithic"), ("modes",), ("mesh",), ("fmu", "-o", "never.fmu"), ("crown", "--json")):
            result = run(command, REDUCER, *settings(PAIRS), *options)
            self.assertEqual(result.returncode, 2, (command, options, result.stderr[-300:]))
            self.assertIn("gearset.second_planet.teeth", result.stderr, command)
        for values, words in ((("gearset.planets=5",), "a divisor of ring - sun teeth = 84 is required"), (("gearset.helix_angle=5 deg",), "gearset.helix_angle"),
                              (("gearset.planet_rim=elastic",), "a rigid rim"), (("gearset.second_planet.teeth=45", "gearset.planets=1"), "second planets that reach the sun"),
                              (("gearset.profile_shift.planet=0.1",), "first_profile_shift instead of it"), (("gearset.teeth.ring=79",), "gearset")):
            result = run("check", REDUCER, *settings((*PAIRS, *values)))
            self.assertEqual(result.returncode, 2, values)
            self.assertIn(words, result.stderr, values)


if __name__ == "__main__":
    unittest.main()
