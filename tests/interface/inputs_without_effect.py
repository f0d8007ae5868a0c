#!/usr/bin/env python3
"""What the program says of the use of inputs and options is true: what changes nothing is
named, what is named without effect changes nothing, and an option that no analysis can follow is refused."""

import json
import pathlib
import tempfile
import unittest

from program import CASES, REDUCER, SETS, answer, run, settings, warned

MOTOR, HARRIS, JONES = (CASES / name / "case.yaml" for name in ("deep_groove_motor", "harris_209", "jones_218"))
DUPLEX, SCRATCH, PLANET_SCRATCH = (CASES / name / "case.yaml" for name in ("duplex_7020", "scratch_defect", "planet_scratch"))
# Beside what is computed they say what was read.
READ = ("assumptions", "warnings", "versions", "inputs")

NEEDLES, NU204 = (CASES / name / "case.yaml" for name in ("reducer_needles", "reducer_nu204"))
SHORT = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2", "simulation.length_error=2e-6 mm")
OWN_BEARING = """bearing: {type: deep-groove-ball, per_planet: 2, balls: 10, ball_diameter: 40 mm, pitch_diameter: 225 mm, radial_clearance: 60 um, bore: 160 mm, outside_diameter: 290 mm, width: 80 mm,
  cage: {inner_diameter: 212 mm, outer_diameter: 250 mm, width: 70 mm, density: 8500 kg/m3}}
"""


def balls_in_planets(folder):
    """The wind stage with spur gears on deep-groove ball bearings."""
    text = (CASES / "wind_stage_tapered" / "case.yaml").read_text(encoding="utf-8").split("\nassumed:")[0] + "\n"
    text = text[:text.index("bearing:")] + OWN_BEARING + text[text.index("lubricant:"):]
    file = pathlib.Path(folder) / "balls.yaml"
    file.write_text(text.replace("  helix_angle: 7.5 deg\n", ""), encoding="utf-8")
    return file


# Command, its options, case, settings, and the one that changes nothing beside them.
SILENT = [
    ("modes", ("--speed", "6000 rpm"), REDUCER, (), "input.speed=3000 rpm"),
    ("sweep", ("--grid-only",), REDUCER, ("sweep={input.speed: [6000 rpm]}",), "input.speed=3000 rpm"),
    ("modes", (), REDUCER, (), "bearing.bore=20 mm"),
    ("run", (), REDUCER, ("gearset.dynamics.pin_error.tangential=[4 um, 0 um, 0 um, 0 um]",), "bearing.bore=20 mm"),
    ("modes", (), REDUCER, (), "lubricant.viscosity=0.1 Pa.s"),
    ("stiffness", (), REDUCER, ("sweep={input.speed: [6000 rpm]}",), "lubricant.viscosity=0.1 Pa.s"),
    ("run", ("--gears",), REDUCER, (), "lubricant.viscosity=0.1 Pa.s"),
    ("run", (), REDUCER, (), "bearing.rings=outer"),
    ("run", ("--fidelity", "dynamic"), REDUCER, (), "inertia.euler=false"),
    ("mesh", (), REDUCER, (), "gearset.fixed=carrier"),
    ("run", (), MOTOR, ("simulation.duration=0.005 s",), "lubricant.flow=1 L/min"),
    ("run", (), JONES, ("equilibrium.ball_inertia=false", "operation.shaft_speed=8000 rpm"),
     "equilibrium.ball_attitude=minimum-friction"),
    ("run", (), JONES, ("equilibrium.ball_inertia=false", "operation.shaft_speed=8000 rpm"), "material.density=20000 kg/m3"),
    ("run", (), HARRIS, ("operation.shaft_speed=10000 rpm",), "material.density=20000 kg/m3"),
    ("modes", (), DUPLEX, ("operation.shaft_speed=8000 rpm",), "linear.mass=20 kg"),
    ("run", (), SETS, (), "sets.transmission.gearset.module=4.2 mm"),
    ("run", (), MOTOR, ("simulation.duration=0.005 s", "heat.enabled=true"), "heat.inlet=80 degC"),
]

# Said to have no effect before, though the results change.
FELT = [
    ("run", (), REDUCER, ("film.enabled=true", "life.viscosity_ratio_by=film", "life.contamination_factor=0.5"),
     "contact.roughness=0.4 um"),
    ("run", (), REDUCER, ("bearing.laminae=20", "bearing.profile.kind=fujiwara-kawase", "bearing.profile.end_drop=5 um"),
     "bearing.profile.k1=1.3"),
    ("run", ("--fidelity", "dynamic"), REDUCER, ("traction.law=limiting-shear",), "traction.sliding_scale=0.3 m/s"),
    ("run", (), CASES / "nasa_35mm" / "case.yaml", ("simulation.duration=0.005 s",), "traction.limiting_friction=0.03"),
    ("mesh", (), REDUCER, ("gearset.planet_rim=elastic",), "bearing.width=13 mm"),
    ("run", (), HARRIS, ("operation.shaft_speed=10000 rpm", "lubricant.grade=ISO VG 68"), "material.density=20000 kg/m3"),
    # Without a cage the motion is that of one system; with one the columns of resonances change.
    ("run", ("--fidelity", "dynamic"), NEEDLES, SHORT, "gearset.dynamics.planet.bearing_stiffness=1e8 N/m"),
    ("run", ("--fidelity", "dynamic"), NEEDLES, SHORT, "bearing.fit.pin_bore=16 mm"),
    ("run", ("--fidelity", "dynamic"), REDUCER, SHORT, "gearset.dynamics.planet.bearing_stiffness=1e8 N/m"),
    ("run", (), MOTOR, ("simulation.duration=0.005 s", "heat.enabled=true", "lubricant.flow=1 L/min"), "heat.inlet=80 degC"),
]


def computed(result):
    return {name: value for name, value in result.items() if name not in READ}


def of_path(result, setting):
    path = setting.split("=")[0]
    return [warning for warning in result["warnings"] if warning.startswith(path + ":")]


class InputsWithoutEffect(unittest.TestCase):
    def test_what_changes_nothing_is_named(self):
        for command, options, case, beside, setting in SILENT:
            with self.subTest(command=command, setting=setting, case=case.parent.name):
                plain = answer(command, case, *beside, options=options)
                changed = answer(command, case, *beside, setting, options=options)
                self.assertEqual(computed(plain), computed(changed))
                found = of_path(changed, setting)
                self.assertEqual(len(found), 1, changed["warnings"])
                self.assertIn("has no effect", found[0])

    def test_no_case_of_the_project_states_what_changes_nothing(self):
        cases = sorted(CASES.glob("**/case.yaml"))
        self.assertGreater(len(cases), 60)
        for case in cases:
            with self.subTest(case=case.parent.name):
                done = run("check", case)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn("has no effect", done.stdout + done.stderr)

    def test_what_changes_results_is_not(self):
        for command, options, case, beside, setting in FELT:
            with self.subTest(command=command, setting=setting, case=case.parent.name):
                plain = answer(command, case, *beside, options=options)
                changed = answer(command, case, *beside, setting, options=options)
                self.assertNotEqual(computed(plain), computed(changed))
                self.assertEqual(of_path(changed, setting), [])

    def test_what_rollers_alone_have_is_named_beside_balls_in_planets(self):
        with tempfile.TemporaryDirectory() as folder:
            case = balls_in_planets(folder)
            plain = computed(answer("run", case))
            for setting in ("life.reduction_factor=0.5", "contact.law=iso16281", "lubricant.density=1000 kg/m3", "film.inlet_heating=gupta"):
                changed = answer("run", case, setting)
                self.assertEqual(plain, computed(changed), setting)
                path, _, value = setting.partition("=")
                found = of_path(changed, setting)
                self.assertEqual(len(found), 1, changed["warnings"])
                self.assertRegex(found[0], rf"^{path}: {value} has no effect.* it counts only where the planet bearings have rollers$")

    def test_a_table_without_the_designation_is_named(self):
        """'NU 204-E' is another bearing than NU 204, whose line is the project's own."""
        head = "designation, family, bore_mm, outside_diameter_mm, width_mm, inner_raceway_mm, dynamic_capacity_kN, static_capacity_kN\n"
        with tempfile.TemporaryDirectory() as folder:
            own, case = pathlib.Path(folder) / "own.csv", pathlib.Path(folder) / "case.yaml"
            case.write_text(NU204.read_text(encoding="utf-8"), encoding="utf-8")
            plain = answer("run", case)
            for name, counts in (("NU 204-E", False), ("NU 204", True)):
                own.write_text(f"{head}{name}, cylindrical-roller, 20, 47, 14, 26.5, 32.5, 24.7\n", encoding="utf-8")
                changed = answer("run", case, "bearing.catalogue=own.csv")
                self.assertEqual(changed["points"][0]["C_N"], 32500 if counts else plain["points"][0]["C_N"])
                found = of_path(changed, "bearing.catalogue=own.csv")
                self.assertEqual(len(found), 0 if counts else 1, changed["warnings"])
                if not counts:
                    self.assertIn("it counts only where a line has the designation 'NU 204'. Lines of it: NU 204-E. The line of the project's own catalogue is used", found[0])

    def test_what_decides_a_life_is_swept(self):
        _, _, case, beside, _ = FELT[0]
        axis = "sweep={contact.roughness: [0.2 um, 0.4 um]}"
        lives = [point["L10mh"] for point in answer("sweep", case, *beside, axis)["points"]]
        self.assertGreater(lives[0], 1.5 * lives[1])

    def test_a_spectrum_that_is_left_out_is_named(self):
        spectrum = "spectrum=[{power: 150 kW, speed: 6000 rpm, share: 0.1}, {power: 300 kW, speed: 1500 rpm, share: 0.9}]"
        found = answer("sensitivities", REDUCER, spectrum)
        self.assertTrue(warned(found, "spectrum: has no effect on sensitivities"), found["warnings"])
        self.assertFalse(warned(answer("sensitivities", REDUCER), "spectrum"))

    def test_all_ways_to_an_effect_are_named(self):
        found = of_path(answer("check", REDUCER, "contact.roughness=0.4 um"), "contact.roughness")
        self.assertEqual(len(found), 1)
        for choice in ("contact.lubrication", "contact.squeeze", "life.viscosity_ratio_by is film"):
            self.assertIn(choice, found[0])

    def test_slopes_push_no_planet_over(self):
        beside = ("bearing.laminae=20", "bearing.profile.kind=iso16281", "bearing.tilt_state=computed", "gearset.tooth_contact=loaded")
        found = answer("run", REDUCER, *beside, "gearset.lead_slope.sun=30 um")
        self.assertTrue(warned(found, "gearset.lead_slope.sun: 30 um moves the force of the teeth along the face"), found["warnings"])
        self.assertFalse(warned(answer("run", REDUCER, *beside), "gearset.lead_slope"))

    def test_a_tilt_on_one_lamina_is_refused(self):
        refused = run("run", HARRIS, "--json", *settings(("bearing.laminae=1", "load.tilt=10 mrad")))
        self.assertEqual(refused.returncode, 2)
        self.assertIn("bearing.laminae: a single lamina, which is not affected by a tilt; at least 2 laminae are required with load.tilt",
                      refused.stderr)
        self.assertEqual(run("run", HARRIS, "--json", *settings(("bearing.laminae=2", "load.tilt=10 mrad", "life.method=lundberg-palmgren"))).returncode, 0)


class OptionsWithoutEffect(unittest.TestCase):
    def refused(self, *arguments):
        found = run(*arguments)
        self.assertEqual((found.returncode, found.stdout), (2, ""), found.stderr)
        return found.stderr

    def test_a_fidelity_that_cannot_be_chosen_is_refused(self):
        motor = settings(("simulation.duration=0.005 s",))
        for fidelity in ("quasi-static", "dynamic", "monolithic"):
            said = self.refused("run", REDUCER, "--json", "--gears", "--fidelity", fidelity)
            self.assertIn(f"--fidelity: found {fidelity}; required: none together with --gears", said)
        said = self.refused("run", MOTOR, "--json", *motor, "--fidelity", "quasi-static")
        self.assertIn("--fidelity: found quasi-static; required: dynamic for a ball bearing in time", said)
        said = self.refused("run", PLANET_SCRATCH, "--json", "--fidelity", "quasi-static")
        self.assertIn("--fidelity: found quasi-static; required: none, or monolithic", said)
        self.assertEqual(run("run", MOTOR, "--json", *motor, "--fidelity", "dynamic").returncode, 0)

    def test_noise_is_a_number(self):
        short = settings(("signal.revolutions=3",))
        for noise in ("nan", "inf", "-1", "1e300"):
            self.assertIn("--noise", self.refused("signals", SCRATCH, "--json", *short, "--noise", noise))
        for seed in ("1", "2"):
            self.assertIn("--noise", self.refused("signals", SCRATCH, "--json", *short, "--seed", seed))

    def test_an_axis_without_effect_is_refused(self):
        said = self.refused("signals", SCRATCH, "--json", "--vary", "lubricant.viscosity=[0.01 Pa.s, 0.02 Pa.s]")
        self.assertIn("lubricant.viscosity: found a varied input that has no effect on run of a bearing with scratches", said)

    def test_a_path_varies_once(self):
        said = self.refused("signals", SCRATCH, "--json", "--vary", "defect.race=[outer]", "--vary", "defect.race=[inner]")
        self.assertIn("--vary: found defect.race twice; required: all values of a path in one list", said)

    def test_equal_signals_under_unlike_labels_are_named(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "signals"
            # Laws of damping whose share of critical damping is zero.
            found = run("signals", SCRATCH, "--json", "-o", str(folder), *settings(("signal.revolutions=3", "contact.damping_ratio=0")),
                        "--vary", "defect.race=[outer]", "--vary", "contact.damping_model=[viscous, hunt-crossley]",
                        "--vary", "load.radial=[400 N, 500 N]")
            self.assertEqual(found.returncode, 0, found.stderr)
            warnings = json.loads(found.stdout)["warnings"]
            signals = sorted((folder / "signals").glob("*.csv"))
            self.assertEqual(len(signals), 4)
            self.assertEqual(signals[0].read_bytes(), signals[2].read_bytes())
        self.assertEqual([text for text in warnings if text.startswith("--vary")],
                         ["--vary: contact.damping_model: no signal differs by it, only their labels"])


if __name__ == "__main__":
    unittest.main()
