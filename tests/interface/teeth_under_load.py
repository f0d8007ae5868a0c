"""Teeth under load in `mesh`, `modes`, `run --gears` and `check`."""

import unittest

from program import REDUCER, WIND, answer, run

LOADED = "gearset.tooth_contact=loaded"
SLOW = "input.speed=1000 rpm"


def sun_mesh(*values, case=REDUCER):
    return answer("mesh", case, *values)["meshes"][0]


class TeethUnderLoad(unittest.TestCase):
    def test_stepped_error_is_force_over_stiffness(self):
        mesh = sun_mesh(SLOW)
        error = mesh["transmission_error"]
        least, most = mesh["min_N_per_m"], mesh["max_N_per_m"]
        swing = 1e6 * error["force_N"] * (1.0 / least - 1.0 / most)
        self.assertAlmostEqual(error["peak_to_peak_um"] / swing, 1.0, delta=1e-3)  # between samples

    def test_light_load_is_the_step_like_limit(self):
        stepped, light = sun_mesh(), sun_mesh(LOADED, "input.power=1e-5 kW")
        self.assertAlmostEqual(light["min_N_per_m"] / stepped["min_N_per_m"], 1.0, delta=0.02)
        # Bodies count once: two pairs are a few per cent softer.
        self.assertAlmostEqual(light["max_N_per_m"] / stepped["max_N_per_m"], 0.97, delta=0.02)
        relative = [mesh["transmission_error"]["peak_to_peak_um"] / mesh["transmission_error"]["mean_um"]
                    for mesh in (stepped, light)]
        self.assertAlmostEqual(relative[0], relative[1], delta=0.05)

    def test_heavy_load_is_smooth(self):
        def steepest(mesh):
            curve = [error for _, error in mesh["transmission_error"]["curve_um"]]
            return max(abs(b - a) for a, b in zip(curve, curve[1:])) / mesh["transmission_error"]["peak_to_peak_um"]

        self.assertGreater(steepest(sun_mesh(SLOW)), 0.5)
        self.assertLess(steepest(sun_mesh(SLOW, LOADED)), 0.25)  # within 1/180 of a period
        # Jumps of the slope of the force, not of the force.
        self.assertEqual(len(sun_mesh(SLOW, LOADED)["jumps"]), 2)

    def test_text_has_the_error(self):
        self.assertRegex(run("mesh", REDUCER, "--set", LOADED).stdout, r"transmission_error\.peak_to_peak_um +[0-9.]+")

    def test_helical_teeth_have_slices(self):
        error = sun_mesh(LOADED, case=WIND)["transmission_error"]
        plain = sun_mesh(LOADED, "gearset.helix_angle=0 deg", case=WIND)["transmission_error"]
        self.assertLess(error["peak_to_peak_um"], 0.5 * plain["peak_to_peak_um"])

    def test_planets_are_shaken_less_at_low_speed(self):
        def rms(*values):
            found = answer("run", REDUCER, SLOW, *values, options=("--gears",))["planet_acceleration_m_per_s2"]
            inner = (found["x"]["rms"] ** 2 + found["y"]["rms"] ** 2) / 2.0
            round_the_sun = (1000.0 * 37.0 / 116.0 * 3.141592653589793 / 30.0) ** 2 * 0.09  # [m/s2]  about
            self.assertAlmostEqual(found["housing_rms"] / (inner + round_the_sun**2 / 2.0) ** 0.5, 1.0, delta=0.05)
            return found["housing_rms"]

        self.assertLess(rms(LOADED), 0.3 * rms())

    def test_modes_feel_the_load(self):
        bearings = "gearset.dynamics.planet.bearing_stiffness=4e8 N/m"  # which else follow the load too

        def highest(*values):
            return max(mode["frequency_Hz"] for mode in answer("modes", REDUCER, bearings, *values)["modes"])

        self.assertNotEqual(highest(LOADED, SLOW), highest(LOADED, "input.speed=12000 rpm"))
        self.assertEqual(highest(SLOW), highest("input.speed=12000 rpm"))

    def test_what_has_no_effect_is_reported(self):
        warnings = answer("mesh", REDUCER, "gearset.tip_relief.sun=10 um")["warnings"]
        self.assertTrue(any("gearset.tip_relief.sun" in text and "gearset.tooth_contact" in text for text in warnings))
        warnings = answer("mesh", REDUCER, LOADED, "gearset.tip_relief.length=2")["warnings"]
        self.assertTrue(any("gearset.tip_relief.length" in text for text in warnings))

    def test_what_does_not_go_together_is_refused(self):
        for beside in ("gearset.dynamics.separation=false", "gearset.dynamics.mesh_stiffness.sun=4e8 N/m"):
            result = run("check", REDUCER, "--set", LOADED, "--set", beside)
            self.assertEqual(result.returncode, 2, beside)
            self.assertIn("gearset.tooth_contact", result.stderr)

    def test_stepped_teeth_shake_as_their_load(self):
        """Stiffness that depends on time alone is linear, however light the load."""
        shaken = [answer("run", REDUCER, f"input.power={power} W", options=("--gears",)) for power in (1, 150e3)]
        heavy, light = (1e3 * run["planet_acceleration_m_per_s2"]["x"]["rms"] / power for run, power in zip(shaken, (1, 150e3)))
        self.assertAlmostEqual(light / heavy, 1.0, delta=0.03)
        for result in shaken:
            self.assertEqual(result["separated_fraction"], result["share_of_time_with_parted_teeth"])  # the former key
            self.assertEqual(result["separated_fraction"], shaken[0]["separated_fraction"])


if __name__ == "__main__":
    unittest.main()
