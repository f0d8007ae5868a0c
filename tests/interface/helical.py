"""Helical teeth in every command; parallel stages."""

import json
import math
import pathlib
import tempfile
import unittest

from program import CASES, REDUCER, SETS, WIND, answer, run, settings, warned

PAIR = CASES / "mesh_62_62" / "case.yaml"
HELIX = "gearset.helix_angle=15 deg"
SHORT = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2", "gearset.dynamics.observed_periods=8",
         "gearset.dynamics.settling_periods=100", "simulation.length_error=2e-6 mm")


class Helical(unittest.TestCase):
    def test_check_says_what_follows(self):
        text = json.dumps(answer("check", WIND))
        for path in ("gearset.overlap_ratio", "gearset.base_helix_angle", "operation.mesh_axial_force",
                     "operation.overturning_moment", "operation.thrust.sun"):
            self.assertIn(path, text)

    def test_mesh_has_axial_forces_in_closed_form(self):
        for place in ("housing", "carrier"):
            axial = answer("mesh", WIND, f"gearset.sun_thrust={place}")["axial"]
            carrier_torque = 750e3 / (22.0 * math.pi / 30.0)
            sun_torque = carrier_torque * 21.0 / 120.0
            helix, alpha = math.radians(7.5), math.atan(math.tan(math.radians(20.0)) / math.cos(math.radians(7.5)))
            radius = 21.0 * 5e-3 / math.cos(helix)
            self.assertAlmostEqual(abs(axial["thrust_on_sun_N"]) / (sun_torque / radius * math.tan(helix)), 1.0, delta=1e-9)
            self.assertAlmostEqual(3.0 * axial["ring_on_planet_N"] / axial["thrust_on_sun_N"], 1.0, delta=1e-12)
            working = 39.0 / 60.0 * 0.308  # [m]  pitch radii of the planet in both meshes, which are alike here
            self.assertAlmostEqual(axial["planet_overturning_moment_N_m"] / (2.0 * working * axial["sun_on_planet_N"]),
                                   1.0, delta=1e-5)
            base = math.asin(math.sin(helix) * math.cos(math.radians(20.0)))
            normal = sun_torque / 3.0 / (radius * math.cos(alpha)) / math.cos(base)
            self.assertAlmostEqual(axial["tooth_normal_force_N"] / normal, 1.0, delta=1e-9)
            held = axial["held_by_housing"]
            self.assertEqual(held["sun_N" if place == "carrier" else "carrier_N"], 0.0)
            self.assertAlmostEqual(sum(held.values()), 0.0)
        self.assertNotIn("axial", answer("mesh", REDUCER))

    def test_pair(self):
        (mesh,) = answer("mesh", PAIR, "pair.helix_angle=15 deg")["meshes"]
        self.assertAlmostEqual(mesh["overlap_ratio"], 20.0 * math.sin(math.radians(15.0)) / (2.0 * math.pi), delta=1e-9)
        self.assertAlmostEqual(mesh["total_contact_ratio"], mesh["contact_ratio"] + mesh["overlap_ratio"], delta=1e-12)
        (spur,) = answer("mesh", PAIR)["meshes"]
        self.assertLess(mesh["max_N_per_m"] - mesh["min_N_per_m"], 0.3 * (spur["max_N_per_m"] - spur["min_N_per_m"]))

    def test_slight_helix_is_a_spur_set(self):
        slight = "gearset.helix_angle=1e-5 deg"
        modes, spur = answer("modes", REDUCER, slight)["modes"], answer("modes", REDUCER)["modes"]
        self.assertEqual(len(modes), len(spur))
        for one, other in zip(modes, spur):
            self.assertEqual(one["kind"], other["kind"])
            self.assertAlmostEqual(one["frequency_Hz"], other["frequency_Hz"], delta=1e-9 * 12e3)
        point, straight = answer("run", REDUCER, slight)["points"][0], answer("run", REDUCER)["points"][0]
        for name in ("planet_load_N", "life_h", "inner_load_max_N"):
            self.assertAlmostEqual(point[name] / straight[name], 1.0, delta=1e-9)

    def test_bearings_feel_it(self):
        tilting = ("bearing.tilt_state=computed", "bearing.laminae=20", HELIX)
        found = answer("run", REDUCER, *tilting)
        row = found["points"][0]
        spur = answer("run", REDUCER, *tilting[:2])["points"][0]
        self.assertGreater(row["largest_bearing_tilt_mrad"], 2.0 * spur["largest_bearing_tilt_mrad"])
        self.assertLess(row["shortest_life_h"], spur["shortest_life_h"])
        self.assertFalse(warned(found, "tilt a planet"))
        level = answer("run", REDUCER, HELIX)
        self.assertTrue(warned(level, f"tilt a planet by a moment of {abs(row['overturning_moment_N_m']):.4g} N m"))
        self.assertNotEqual(row["axial_mesh_force_N"], 0.0)

    def test_sweeps_of_all_rungs(self):
        for fidelity in ("quasi-static", "dynamic", "co-simulated", "monolithic"):
            with self.subTest(fidelity):
                found = answer("sweep", REDUCER, HELIX, "sweep.input.speed=[6000 rpm]", *SHORT,
                               options=("--fidelity", fidelity))
                self.assertEqual(found["points"][0]["status"], "ok")
                self.assertEqual(warned(found, "motion is that in the plane"), fidelity != "quasi-static")

    def test_gears_in_motion(self):
        spur = answer("run", REDUCER, *SHORT, options=("--gears",))
        found = answer("run", REDUCER, HELIX, *SHORT, options=("--gears",))
        self.assertTrue(warned(found, "motion is that in the plane"))
        self.assertNotEqual(spur, found)
        self.assertTrue(warned(answer("modes", REDUCER, HELIX, options=("--speed", "6000 rpm")), "in the plane"))

    def test_other_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            work = pathlib.Path(folder)
            self.assertEqual(run("crown", REDUCER, "-o", work / "crown", *settings((HELIX, "bearing.laminae=20")), "--drops", "4 um",
                                 "--starts", "1", "--quiet").returncode, 0)
            self.assertEqual(run("stiffness", REDUCER, "-o", work / "k", *settings((HELIX, "sweep.input.speed=[6000 rpm]")), "--quiet").returncode, 0)
            self.assertEqual(run("sweep", REDUCER, "-o", work / "s", *settings((HELIX, "sweep.input.speed=[6000 rpm]")), "--quiet").returncode, 0)
            self.assertEqual(run("report", work / "s", "--quiet").returncode, 0)
            for model in ("bearing", "gearset"):
                made = run("fmu", REDUCER, "-o", work / f"{model}.fmu", "--model", model, "--set", HELIX, "--json")
                self.assertEqual(made.returncode, 0, made.stderr)
                said = "in the plane" if model == "gearset" else "tilt a planet"
                self.assertTrue(warned(json.loads(made.stdout), said))

    def test_multi_stage(self):
        found = answer("sweep", SETS, "sets.reduction." + HELIX, "sweep.input.speed=[6000 rpm]")
        self.assertTrue(warned(found, "sets.reduction.gearset.helix_angle: the axial forces tilt"))
        self.assertEqual(found["points"][0]["status"], "ok")

    def test_parallel_stage(self):
        alone = answer("run", REDUCER, "inertia.carrier_centrifugal=false", "inertia.own_orbit=false")["points"][0]
        behind = "parallel_stage.behind=[50, 17]"
        found = answer("run", REDUCER, "parallel_stage.front=[63, 20]", behind, "input.speed=1904.7619047619047 rpm",
                       "inertia.carrier_centrifugal=false", "inertia.own_orbit=false")["points"][0]
        for name in ("carrier_speed_rpm", "tangential_load_N", "life_h"):
            self.assertAlmostEqual(found[name] / alone[name], 1.0, delta=1e-9, msg=name)
        self.assertAlmostEqual(found["input_speed_rpm"], 6000.0 * 20.0 / 63.0, delta=1e-9)
        flow = answer("check", REDUCER, "parallel_stage.front=[20, 63]", behind)["power_flow"]
        rows = {(row["set"], row["member"]): row for row in flow}
        self.assertAlmostEqual(rows["front", "second"]["speed_rpm"], -6000.0 * 20.0 / 63.0, delta=1e-6)
        self.assertAlmostEqual(rows["gearset", "sun"]["torque_N_m"] / rows["front", "first"]["torque_N_m"], -63.0 / 20.0,
                               delta=1e-9)
        carrier, load = rows["gearset", "carrier"], rows["behind", "second"]
        self.assertAlmostEqual(load["speed_rpm"] / carrier["speed_rpm"], -50.0 / 17.0, delta=1e-9)
        self.assertAlmostEqual(load["power_W"], -150e3, delta=1e-6)
        sets = answer("check", SETS, "parallel_stage.front=[20, 63]")["power_flow"]
        self.assertEqual(sets[-3]["set"], "front")
        fewer = answer("sweep", SETS, "parallel_stage.front=[63, 20]", "sweep.input.speed=[1904.7619047619047 rpm]")
        as_before = answer("sweep", SETS, "sweep.input.speed=[6000 rpm]")
        self.assertAlmostEqual(fewer["points"][0]["life_h"] / as_before["points"][0]["life_h"], 1.0, delta=1e-8)
        for wrong in ("[20]", "[0, 5]", "[2.5, 5]"):
            self.assertEqual(run("check", REDUCER, *settings((f"parallel_stage.front={wrong}",))).returncode, 2, wrong)

    def test_tips_in_the_roots_of_the_ring_are_warned_of(self):
        heights = ["gearset.addendum_of.planet=1.4", "gearset.root_fillet_radius=0.1", "gearset.clearance_of.sun=0.6"]
        self.assertTrue(warned(answer("run", WIND, *heights), "tips of the planet interfere with the roots of the ring by 1.1"))
        self.assertFalse(warned(answer("run", WIND), "interfere with"))

    def test_no_stiffness_where_planets_find_their_tilt(self):
        self.assertIsNone(answer("run", WIND)["stiffness"])
        self.assertIsNotNone(answer("run", WIND, "bearing.tilt_state=stated")["stiffness"])

    def test_few_laminae_are_warned_of(self):
        self.assertTrue(warned(answer("run", WIND, "bearing.laminae=1"), "bearing.laminae: 1 resolve"))
        self.assertFalse(warned(answer("run", WIND), "bearing.laminae"))

    def test_thrust_of_spur_gears_is_warned_of(self):
        found = answer("mesh", REDUCER, "gearset.sun_thrust=carrier")
        self.assertTrue(warned(found, "gearset.sun_thrust"))

    def test_wind_turbine(self):
        found = answer("sweep", WIND, options=("--grid-only",))
        self.assertEqual([row["status"] for row in found["points"]], ["ok"] * 5)
        for row in found["points"]:
            self.assertAlmostEqual(row["planet_load_N"] * row["input_speed_rpm"] / (176.16e3 * 22.0), 1.0, delta=1e-3)
        ratios = [mesh["overlap_ratio"] for mesh in answer("mesh", WIND)["meshes"]]
        self.assertAlmostEqual(ratios[0], 220.0 * math.sin(math.radians(7.5)) / (10.0 * math.pi), delta=1e-9)
        self.assertEqual(answer("modes", WIND)["modes"][0]["kind"], "rotational")
        self.assertEqual(run("validate", WIND, "--quiet").returncode, 0)


if __name__ == "__main__":
    unittest.main()
