"""Planets at unequal angles in every command. A computed tilt in motion. Seats by class, full complements."""

import json
import math
import pathlib
import tempfile
import unittest

from program import REDUCER, SETS, answer, run, settings

STEP = 360.0 / 116.0  # [deg]  37 + 79 teeth
THREE = (0, 30, 75)
SHORT = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2", "gearset.dynamics.observed_periods=8",
         "gearset.dynamics.settling_periods=100", "simulation.length_error=2e-6 mm")
FLOATING = "gearset.dynamics.sun.support_stiffness=0 N/m"


def placed(steps):
    angles = ", ".join(f"{round(STEP * k, 4)} deg" for k in steps)
    return f"gearset.planets={len(steps)}", f"gearset.planet_angles=[{angles}]"


def sines(steps):
    """Shares of three planets about a sun that floats: each as the sine of the angle between the other two."""
    a, b, c = (math.radians(STEP * k) for k in steps)
    forces = (math.sin(c - b), math.sin(a - c), math.sin(b - a))
    return [3.0 * force / sum(forces) for force in forces]


class UnequalPlanets(unittest.TestCase):
    def test_who_carries_how_much(self):
        point = answer("run", REDUCER, *placed(THREE), FLOATING)["points"][0]
        most = max(sines(THREE))
        # The sun shifts until its forces balance; its own centrifugal force there is what is left.
        self.assertAlmostEqual(point["largest_load_share"], most, delta=2e-3)
        self.assertEqual(point["shortest_life_planet"], 1 + sines(THREE).index(most))
        self.assertLess(point["shortest_life_h"], point["life_h"])
        held = answer("run", REDUCER, *placed(THREE))["points"][0]
        self.assertLess(held["largest_load_share"], most)  # a sun in bearings passes on what does not balance

    def test_equal_steps_are_the_default(self):
        plain = answer("run", REDUCER)["points"]
        stated = answer("run", REDUCER, *placed((0, 29, 58, 87)))["points"]
        self.assertEqual(plain, stated)

    def test_modes_and_meshes(self):
        pairs = placed((0, 22, 58, 80))
        even, found = (answer("modes", REDUCER, *values) for values in ((), pairs))
        kinds = [{mode["kind"] for mode in result["modes"]} for result in (even, found)]
        self.assertEqual(*kinds)
        rotational = [[mode["frequency_Hz"] for mode in result["modes"] if mode["kind"] == "rotational"] for result in (even, found)]
        for a, b in zip(*rotational):
            self.assertAlmostEqual(a, b, delta=1e-3 * max(a, 1.0))
        phases = [mesh["phase"] for mesh in answer("mesh", REDUCER, *pairs)["meshes"]]
        for n, k in enumerate((0, 22, 58, 80)):
            self.assertAlmostEqual(phases[n], (37 * k / 116.0) % 1.0, delta=1e-6)

    def test_every_command_takes_them_or_says_why_not(self):
        places = placed((0, 22, 58, 80))
        for fidelity in ("dynamic", "co-simulated", "monolithic"):
            point = answer("run", REDUCER, *places, *SHORT, options=("--fidelity", fidelity))["points"][0]
            self.assertEqual(point["status"], "ok", fidelity)
        gears = answer("run", REDUCER, *places, *SHORT, options=("--gears",))
        self.assertIn("load_sharing", json.dumps(gears))
        crown = run("crown", REDUCER, "--json", *settings(places), "--set", "bearing.laminae=12", "--drops", "0 um,1 um", "--tilts", "0 mrad")
        self.assertEqual(crown.returncode, 0, crown.stderr)
        self.assertIn("gearset.planet_angles", " ".join(json.loads(crown.stdout)["warnings"]))
        # With what else they are computed: docs/combinations.md.
        for values in (("bearing.laminae=12", "bearing.tilt_state=computed"), ("gearset.planet_rim=elastic",)):
            self.assertEqual(run("check", REDUCER, *settings([*places, *values])).returncode, 0)
        for value in ("gearset.planet_angles=[0 deg, 68.2759 deg, 180 deg, 248.2759 deg]", "bearing.tilt_state=computed"):
            several = run("check", SETS, "--set", f"sets.reduction.{value}", "--set", "sets.reduction.bearing.laminae=12")
            self.assertEqual(several.returncode, 0, several.stderr)
        self.assertEqual(run("mesh", SETS).returncode, 2)
        turned = run("check", REDUCER, "--set", "gearset.planet_angles=[0 deg, 270 deg, 180 deg, 90 deg]")
        self.assertNotIn("must not touch", turned.stderr)
        wrong = run("check", REDUCER, *settings(["gearset.planets=3", "gearset.planet_angles=[0 deg, 95 deg, 233 deg]"]))
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("where teeth do not fit", wrong.stderr)

    def test_fmu_of_the_gears_has_them(self):
        with tempfile.TemporaryDirectory() as folder:
            made = run("fmu", REDUCER, "--model", "gearset", "-o", pathlib.Path(folder) / "gears.fmu", *settings(placed((0, 22, 58, 80))))
            self.assertEqual(made.returncode, 0, made.stderr)


class TiltInMotion(unittest.TestCase):
    def test_every_bearing_of_a_planet_runs(self):
        tilting = ("bearing.laminae=12", "bearing.tilt_state=computed", "bearing.clearance_differences=[0 um, 10 um]")
        rest = answer("run", REDUCER, *tilting)["points"][0]
        motion = answer("run", REDUCER, *tilting, *SHORT, options=("--fidelity", "dynamic"))["points"][0]
        for key in ("largest_bearing_tilt_mrad", "largest_bearing_share", "shortest_life_h", "life_h"):
            self.assertAlmostEqual(motion[key] / rest[key], 1.0, delta=0.15, msg=key)
        refused = run("run", REDUCER, "--json", "--fidelity", "monolithic", *settings(tilting))
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("bearing.tilt_state", refused.stderr)

    def test_the_carrier_twists(self):
        tilting = ("bearing.laminae=12", "bearing.tilt_state=computed")
        rigid, soft = (answer("run", REDUCER, *tilting, *more)["points"][0]
                       for more in ((), ("support.carrier_twist_stiffness=2e5 N.m/rad",)))
        self.assertGreater(soft["largest_bearing_tilt_mrad"], 1.5 * rigid["largest_bearing_tilt_mrad"])
        self.assertLess(soft["shortest_life_h"], rigid["shortest_life_h"])
        one = run("check", REDUCER, *settings([*tilting, "support.carrier_twist_stiffness=2e5 N.m/rad", "support.pin_ends=one"]))
        self.assertEqual(one.returncode, 2)


class Seats(unittest.TestCase):
    def test_a_class_stands_for_its_middle(self):
        shelf = ("bearing.clearance_state=unmounted", "bearing.radial_clearance=40 um")
        by_class = answer("check", REDUCER, *shelf, "bearing.fit.pin_class=k5", "bearing.fit.planet_class=N6")
        by_value = answer("check", REDUCER, *shelf, "bearing.fit.inner_interference=11.5 um", "bearing.fit.outer_interference=14.5 um")
        chain = [[row["value"] for row in result["derived"] if row["path"] == "bearing.clearance.operating"] for result in (by_class, by_value)]
        self.assertEqual(*chain)
        self.assertTrue(chain[0])
        ends = {row["path"]: row["value"] for row in by_class["derived"]}
        self.assertAlmostEqual(ends["bearing.fit.inner_interference.most"], 21.0, delta=1e-9)
        self.assertAlmostEqual(ends["bearing.fit.outer_interference.least"], 1.0, delta=1e-9)
        both = answer("check", REDUCER, *shelf, "bearing.fit.pin_class=k5", "bearing.fit.inner_interference=3 um")
        self.assertIn("bearing.fit.inner_interference", " ".join(both["warnings"]))


class FullComplement(unittest.TestCase):
    def test_of_a_caged_case_needs_no_room_for_bars(self):
        point = answer("run", REDUCER, "bearing.complement=full", "bearing.rollers=21")["points"][0]
        self.assertEqual(point["status"], "ok")
        self.assertGreater(point["life_h"], answer("run", REDUCER)["points"][0]["life_h"])
        caged = run("check", REDUCER, *settings(["bearing.rollers=21"]))
        self.assertEqual(caged.returncode, 2)
        self.assertIn("room for bars", caged.stderr)


if __name__ == "__main__":
    unittest.main()
