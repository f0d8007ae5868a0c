#!/usr/bin/env python3
"""Tapered, spherical and ball bearings in planets, at rest."""

import math
import tempfile
import unittest
from pathlib import Path

from program import CASES, answer, run, settings

TAPERED = CASES / "wind_stage_tapered" / "case.yaml"
SPUR = ("gearset.helix_angle=0 deg", "gearset.profile_shift.sun=0", "gearset.profile_shift.ring=0")
SPHERICAL = ("bearing.type=spherical-roller", "bearing.rows.contact_angle=10 deg", "bearing.width=110 mm", "bearing.roller_length=45 mm")
BALLS = """
bearing:
  type: deep-groove-ball
  per_planet: 2
  balls: 9
  ball_diameter: 44 mm
  pitch_diameter: 225 mm
  radial_clearance: 20 um
  bore: 160 mm
  outside_diameter: 290 mm
  width: 84 mm
"""


def point(*values, case=TAPERED):
    return answer("run", case, *values)["points"][0]


def f_c(gamma):
    return (0.377 * 551.13373 * 0.83 * gamma ** (2 / 9) * (1 - gamma) ** (29 / 27) / (1 + gamma) ** 0.25
            * (1 + (1.04 * ((1 - gamma) / (1 + gamma)) ** (143 / 108)) ** 4.5) ** (-2 / 9))


def capacity(b_m, rows, rollers, diameter, length, pitch, angle):
    cosine = math.cos(math.radians(angle))
    return b_m * f_c(diameter * cosine / pitch) * (rows * length * cosine) ** (7 / 9) * rollers ** 0.75 * diameter ** (29 / 27)


class PlanetBearingTypes(unittest.TestCase):
    def test_capacities_are_those_of_iso_281(self):
        self.assertAlmostEqual(point()["C_N"] / capacity(1.1, 1, 19, 34, 58, 225, 16), 1, delta=1e-9)
        self.assertAlmostEqual(point(*SPUR, *SPHERICAL)["C_N"] / capacity(1.15, 2, 19, 34, 45, 225, 10), 1, delta=1e-9)

    def test_a_pair_without_preload_shares_as_the_published_factors(self):
        """4.08 F / (Z cos(alpha)) of line contacts without clearance, few rollers within 3 %; no centrifugal load."""
        found = point(*SPUR, "bearing.rows.preload=0 N", "inertia.carrier_centrifugal=false")
        expected = 4.08 * found["planet_load_N"] / (19 * math.cos(math.radians(16)))
        self.assertAlmostEqual(found["outer_load_max_N"] / expected, 1, delta=0.03)
        self.assertAlmostEqual(found["P_N"] / found["planet_load_N"], 1, delta=1e-6)  # F_a = 1.26 F_r tan(alpha) < e F_r
        self.assertAlmostEqual(found["largest_bearing_share"], 1, delta=1e-6)

    def test_the_moment_of_helical_teeth_loads_both_rows_unlike(self):
        found = point()
        self.assertGreater(found["largest_bearing_share"], 1.0001)  # the couple is radial, the load tangential: it loads both nearly alike
        self.assertGreater(found["P_N"] / found["planet_load_N"], 1.02)
        self.assertGreater(found["largest_bearing_tilt_mrad"], 0.01)
        other = point("bearing.rows.arrangement=face-to-face")
        self.assertGreater(other["largest_bearing_tilt_mrad"], 1.2 * found["largest_bearing_tilt_mrad"])
        wide = point("bearing.rows.distance=136 mm")
        self.assertLess(wide["largest_bearing_share"], found["largest_bearing_share"])

    def test_a_high_preload_costs_life(self):
        """A light one loads more rollers and costs none."""
        light, high = (point(*SPUR, f"bearing.rows.preload={preload} kN") for preload in (20, 800))
        self.assertLess(high["life_h"], 0.5 * light["life_h"])
        self.assertGreater(high["P_N"], high["planet_load_N"])

    def test_standard_lives(self):
        for values in ((), (*SPUR, *SPHERICAL)):
            found = point(*values)
            self.assertAlmostEqual(found["L10_Mrev"] / found["C_over_P"] ** (10 / 3), 1, delta=1e-9)
            self.assertAlmostEqual(found["C_over_P"] / (found["C_N"] / found["P_N"]), 1, delta=1e-9)

    def test_barrels_without_angle_are_two_cylindrical_bearings(self):
        still = ("inertia.carrier_centrifugal=false", "inertia.coriolis=false", "inertia.own_orbit=false", "bearing.width=84 mm")
        both = point(*SPUR, *still, "bearing.type=spherical-roller", "bearing.rows.contact_angle=1e-6 deg", "bearing.per_planet=1")
        cylinders = point(*SPUR, *still, "bearing.type=cylindrical-roller", "bearing.per_planet=2")
        for key in ("outer_load_max_N", "inner_load_max_N", "outer_load_rms_N", "system_life_h"):
            self.assertAlmostEqual(both[key] / cylinders[key], 1, delta=1e-8, msg=key)

    def test_balls(self):
        text = TAPERED.read_text(encoding="utf-8")
        head, tail = text.split("bearing:\n", 1)
        tail = tail[tail.index("lubricant:\n"):]
        cage = "  cage: {inner_diameter: 212 mm, outer_diameter: 250 mm, width: 74 mm, density: 8500 kg/m3}\n"
        kept, rest = [], tail.split("assumed:\n", 1)
        kept = [line for line in rest[1].splitlines() if not line.strip().startswith("bearing.")]
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "balls.yaml"
            case.write_text(head + BALLS.lstrip() + cage + rest[0] + "assumed:\n" + "\n".join(kept) + "\n", encoding="utf-8")
            found = point("input.power=30 kW", case=case)
            self.assertAlmostEqual(found["L10_Mrev"] / found["C_over_P"] ** 3, 1, delta=1e-9)
            self.assertAlmostEqual(found["life_h"] / found["L10rh"], 1, delta=1e-9)
            refused = run("run", case, *settings(("bearing.per_planet=1",)))
            self.assertEqual(refused.returncode, 2)
            self.assertIn("hold the moment of helical teeth", refused.stderr)

    def test_laminae_carry_the_tilt_along_the_rollers(self):
        straight = ("bearing.profile.kind=straight",)
        whole, even, crowned = point(*straight), point("bearing.laminae=30", *straight), point("bearing.laminae=30", "bearing.profile.kind=johns-gohar")
        for found in (even, crowned):
            self.assertAlmostEqual(found["outer_load_max_N"] / whole["outer_load_max_N"], 1, delta=0.05)
            self.assertNotEqual(found["L10rh"], whole["L10rh"])
        self.assertEqual(even["C_N"], whole["C_N"])
        self.assertGreater(even["contact_pressure_max_MPa"], whole["contact_pressure_max_MPa"])  # where the tilt presses most
        finer = point("bearing.laminae=60")
        self.assertAlmostEqual(finer["largest_bearing_tilt_mrad"] / point("bearing.laminae=30")["largest_bearing_tilt_mrad"], 1, delta=1e-3)

    def test_a_profile_without_laminae_acts_on_the_lives_of_iso_16281_alone(self):
        """They have 30 laminae of their own; loads are those of whole rollers, which have no profile."""
        straight, crowned, laminae = (point(f"bearing.profile.kind={kind}", *more)
                                      for kind, more in (("straight", ()), ("johns-gohar", ()), ("johns-gohar", ("bearing.laminae=30",))))
        for key in ("life_h", "outer_load_max_N", "largest_bearing_tilt_mrad"):
            self.assertEqual(crowned[key], straight[key], key)
        for key in ("L10rh", "L10mrh"):
            self.assertEqual(crowned[key], laminae[key], key)
            self.assertGreater(crowned[key], straight[key], key)  # no stress at the ends

    def test_a_sweep_has_its_files(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("sweep", TAPERED, "-o", Path(folder) / "out")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertTrue((Path(folder) / "out" / "points" / "00000.nc").exists())

    def test_what_is_not_computed_is_refused(self):
        for words in (("run", "--fidelity", "dynamic"), ("run", "--fidelity", "monolithic"), ("run", "--fidelity", "co-simulated"), ("modes",), ("run", "--gears"),
                      ("crown", "--json"), ("fmu", "-o", "never.fmu"), ("stiffness", "--json"),
                      ("carrier", *settings(("gearset.carrier.bearing_positions=[-250 mm, 250 mm]", "gearset.carrier.bearing_stiffness=[3e9 N/m, 3e9 N/m]")))):
            command, *options = words
            result = run(command, TAPERED, *options)
            self.assertEqual(result.returncode, 2, (words, result.stdout[-300:], result.stderr[-300:]))
            self.assertIn("bearing.type", result.stderr, words)
        for values in ((*SPUR, *SPHERICAL, "bearing.laminae=30"), ("bearing.tilt_state=computed",), ("gearset.planet_rim=elastic",), ("film.enabled=true",), ("bearing.per_planet=1",),
                       ("gearset.dynamics.pin_error.tangential=[5 um, 0 um, 0 um]",), ("bearing.rows.approach=5 um",), ("bearing.rows.distance=30 mm",),
                       ("bearing.type=spherical-roller", "bearing.per_planet=1")):
            result = run("run", TAPERED, *settings(values))
            self.assertEqual(result.returncode, 2, values)

    def test_meshes_know_no_bearings(self):
        answer("mesh", TAPERED)


if __name__ == "__main__":
    unittest.main()
