#!/usr/bin/env python3
"""Ratings of another inside than the catalogue's, thin rims, sets that stand or idle, oils by two viscosities, assumptions with their effect, and inputs with defaults."""

import json
import unittest

from program import CASES, REDUCER, InFolder, answer, run, settings, warned

WIND = """name: wind_two_rows
source: own layout
model: planetary-drivetrain
input: {member: carrier, power: 3.4 MW, speed: 12 rpm}
gearset: {planets: 5, teeth: {sun: 39, planet: 36, ring: 111}, module: 14 mm, face_width: 400 mm}
bearing: {designation: NU 2340, per_planet: 2, clearance_class: C3, cage: {material: brass}}
lubricant: {grade: ISO VG 320, temperature: 65 degC}
life: {cleanliness: -/17/14}
"""
REDUCER_4 = """name: industrial
source: own layout
model: planetary-drivetrain
input: {member: sun, power: 160 kW, speed: 1500 rpm}
gearset: {planets: 3, teeth: {sun: 24, planet: 33, ring: 90}, module: 4 mm, profile_shift: {sun: 0.3, ring: 0.5}, face_width: 60 mm}
bearing: {designation: NU 2207, per_planet: 2, clearance_class: CN, cage: {material: brass}}
"""
# An automatic gearbox of four sets (8HP 70): teeth and printed ratios of a public table, connections by Willis. `NEEDLES` are the bearings of any planet.
NEEDLES = "{type: cylindrical-roller, complement: full, rings: none, per_planet: 1, roller_diameter: 1.5 mm, roller_length: 15 mm, pitch_diameter: 11 mm, radial_clearance: 0 um, width: 16 mm}"
TEETH = {"p1": (48, 24, 96, 1.3), "p2": (48, 24, 96, 1.3), "p3": (69, 21, 111, 1.1), "p4": (23, 31, 85, 1.5)}
GEARS = {  # shafts, ratio
    "1": ({"s0": "motor, p4.sun", "s1": "load, p4.carrier", "s2": "ground, p1.sun, p1.ring", "s3": "p1.carrier, p4.ring"}, 4.6957),
    "3": ({"s0": "motor, p4.sun, p2.ring, p2.carrier", "s1": "load, p4.carrier", "s2": "ground, p1.ring", "s3": "p4.ring, p1.carrier", "s4": "p2.sun, p1.sun"}, 2.1039),
    "R": ({"s0": "motor, p2.carrier", "s1": "load, p3.carrier, p4.carrier", "s2": "ground, p1.sun, p1.ring, p2.sun", "s3": "p3.sun, p2.ring", "s4": "p3.ring, p4.sun",
           "s5": "p1.carrier, p4.ring"}, -3.2968),
}
SPINDLE_ROLLERS = """name: two_viscosities
source: a maker's general catalogue, life under varying load
model: roller-bearing
load: {radial: 200 kN}
bearing: {type: cylindrical-roller, rollers: 20, roller_diameter: 20 mm, roller_length: 40 mm, pitch_diameter: 165 mm, radial_clearance: 0 um, laminae: 30, dynamic_capacity: 540 kN,
  static_capacity: 815 kN, fatigue_load_limit: 81.5 kN}
lubricant: {viscosity_40: 200 mm2/s, viscosity_100: 16 mm2/s, temperature: 65 degC}
life: {contamination_factor: 0.8}
operation: {shaft_speed: 300 rpm}
"""
PUMP = """name: pump_shaft
source: own layout
model: ball-bearing
load: {radial: 5 kN}
bearing: {designation: 6309, clearance_class: CN}
operation: {turning_race: inner, shaft_speed: 3000 rpm}
lubricant: {grade: ISO VG 68, temperature: 70 degC}
life: {cleanliness: -/17/14}
"""
HELICAL = """name: helical_12_60
source: a printed table of metric gears
model: gear-pair
pair: {teeth: [12, 60], module: 3 mm, helix_angle: 30 deg, face_width: 30 mm, bore: 15 mm, pressure_angle: 20 deg, profile_shift: [0.09809, 0]}
"""
GEARS_ALONE = """name: gears_alone
source: own layout
model: planetary-drivetrain
gearset: {planets: 4, teeth: {sun: 48, planet: 32, ring: 112}, module: 1 mm, face_width: 25 mm}
"""


def gearbox(gear, bearings, more_sets="", more_shafts=""):
    shafts = GEARS[gear][0]
    used = [name for name in TEETH if any(f"{name}." in members for members in shafts.values())]
    lines = ["name: gearbox", "source: a public table of teeth and ratios", "model: planetary-drivetrain", "input: {torque: 100 N.m, speed: 1000 rpm}",
             "lubricant: {grade: ISO VG 680, temperature: 60 degC}", "shafts:"]
    lines += [f"  {name}: [{members}]" for name, members in shafts.items()] + ([more_shafts] if more_shafts else []) + ["sets:"]
    for name in used:
        sun, planet, ring, module = TEETH[name]
        bearing = f", bearing: {NEEDLES}" if bearings else ""
        lines.append(f"  {name}: {{gearset: {{planets: 4, teeth: {{sun: {sun}, planet: {planet}, ring: {ring}}}, module: {module} mm, face_width: 25 mm}}{bearing}}}")
    return "\n".join(lines) + "\n" + more_sets


class Case(InFolder):
    def point(self, text, *values):
        return answer("run", self.case(text), *values)["points"][0]

    def row(self, file, path, *values):
        (row,) = [row for row in answer("check", file, *values)["derived"] if row["path"] == path]
        return row

    def refused(self, text, *values, command="check"):
        result = run(command, self.case(text), *settings(values))
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        return result.stderr


class Ratings(Case):
    def test_a_full_complement_has_its_own_ratings(self):
        """C of ISO 281 is proportional to Z^(3/4) and L10 to C^(10/3); C_0 of ISO 76 to Z. P differs by the mass of the cage alone."""
        caged, full = self.point(WIND), self.point(WIND, "bearing.complement=full")
        more = 16 / 13
        self.assertAlmostEqual(full["C_N"] / (1910e3 * more**0.75), 1, delta=1e-5)
        self.assertAlmostEqual(full["C0_N"] / caged["C0_N"], more, delta=1e-5)
        self.assertAlmostEqual(full["L10h"] / caged["L10h"], more**2.5, delta=0.005)
        self.assertAlmostEqual(full["L10h"] / 59600, 1, delta=0.005)  # by hand
        self.assertGreater(full["L10rh"] / caged["L10rh"], 1.3)


class Rims(Case):
    def test_a_thin_rim_is_a_result_a_warning_and_a_status(self):
        """Root circle of a standard rack: m (z + 2 x - 2.5)."""
        for text, bore, module, teeth, thin, none in ((REDUCER_4, 72, 4, 33, False, False), (REDUCER_4.replace("NU 2207", "NU 2213").replace("60 mm", "64 mm"), 120, 4, 33, True, True),
                                                      (WIND, 420, 14, 36, True, False)):
            with self.subTest(text.splitlines()[0], bore=bore):
                file = self.case(text)
                shift = self.row(file, "gearset.profile_shift.planet")["value"]
                right = (module * (teeth + 2 * shift - 2.5) - bore) / 2 / module
                self.assertAlmostEqual(self.row(file, "gearset.rim_over_module")["value"], right, delta=1e-6)
                found = answer("run", file)
                point = found["points"][0]
                self.assertAlmostEqual(point["rim_over_module"], right, delta=1e-6)
                self.assertEqual(warned(found, "gearset: rim of a planet between roots and bore, in modules, below 3"), thin)
                self.assertEqual(warned(answer("check", file), "gearset: rim of a planet"), thin)
                self.assertEqual(point["status"].startswith("implausible: rim of a planet"), none, point["status"])


class Sets(Case):
    def test_planets_that_stand_make_no_revolutions(self):
        """Gear 1: all of p1 stands. Its bearings fail never, and all others together make the system."""
        found = self.point(gearbox("1", True))
        self.assertEqual(found["status"], "ok")
        for life in ("L10h", "L10rh", "L10mh", "L10mrh", "life_h"):
            self.assertIsNone(found[f"sets.p1.{life}"], life)
        self.assertIsNone(found["sets.p1.kappa"])
        self.assertGreater(found["sets.p1.S0"], 0)
        self.assertGreater(found["sets.p4.kappa"], 0)
        self.assertEqual(found["limiting_set"], "p4")
        alone = 4 ** (-8 / 9)  # four planets of p4, slope 9/8
        for life in ("L10h", "L10rh", "L10mh", "L10mrh"):
            self.assertAlmostEqual(found[f"system_{life}"] / (found[f"sets.p4.{life}"] * alone), 1, delta=1e-9, msg=life)

    def test_a_set_that_turns_as_a_block_stands_too(self):
        """Gear 3: ring and carrier of p2 are one shaft; its planets do not creep by round-off."""
        found = self.point(gearbox("3", True))
        self.assertIsNone(found["sets.p2.L10mh"])
        self.assertIsNone(found["sets.p2.kappa"])
        self.assertIsNotNone(found["system_L10mh"])

    def test_ratios_of_an_automatic_gearbox(self):
        for gear, (_, ratio) in GEARS.items():
            flow = answer("check", self.case(gearbox(gear, False)))["power_flow"]
            (output,) = {row["speed_rpm"] for row in flow if row["shaft"] == "s1"}
            self.assertAlmostEqual(1000 / output / ratio, 1, delta=1e-4, msg=gear)

    def test_planet_speeds_of_sets_without_a_bearing(self):
        """Reverse: speeds of the planets against their carriers over the input, by Willis."""
        found = {row["path"]: row["value"] for row in answer("check", self.case(gearbox("R", False)))["derived"]}
        for name, right in (("p1", 0.0), ("p2", 2.0), ("p3", 5.9252), ("p4", 0.8317)):
            self.assertAlmostEqual(abs(found[f"sets.{name}.operation.planet_speed"]) / 1000, right, delta=2e-4, msg=name)
        # The carrier of p2 takes 1 + 96/48 times the torque of the sun; four planets at the centre distance carry it.
        carrier = 100 * 0.3333 * 3
        self.assertAlmostEqual(abs(found["sets.p2.operation.pin_load_y"]) / (carrier / 4 / 46.8e-3), 1, delta=2e-3)

    def test_an_idle_set_is_named(self):
        """p3 with an open ring between motor and load: the gear goes on as without it."""
        text = gearbox("1", False, "  p3: {gearset: {planets: 4, teeth: {sun: 69, planet: 21, ring: 111}, module: 1.1 mm, face_width: 25 mm}}\n", "  open: [p3.ring]")
        text = text.replace("motor, p4.sun", "motor, p4.sun, p3.sun").replace("load, p4.carrier", "load, p4.carrier, p3.carrier")
        found = answer("check", self.case(text))
        self.assertEqual(found["idle_sets"], ["p3"])
        self.assertTrue(warned(found, "sets.p3: idle. It transmits no torque"))
        self.assertEqual({row["torque_N_m"] for row in found["power_flow"] if row["set"] == "p3"}, {0.0})

    def test_neutral_is_refused_with_all_open_members(self):
        text = gearbox("3", False).replace("ground, p1.ring", "ground").replace("  s4", "  s5: [p1.ring]\n  s4")
        said = self.refused(text)
        self.assertTrue("no member of a set" in said or "undetermined" in said or "floats" in said, said)


class Oils(Case):
    def test_two_viscosities(self):
        """ASTM D341 through 200 and 16 mm2/s at 40 and 100 degC; kappa by 45000 n^-0.83 d_m^-0.5 of ISO 281."""
        for temperature, speed, viscosity in ((50, 50, 112.9), (60, 200, 68.7), (65, 300, 54.9)):
            found = answer("run", self.case(SPINDLE_ROLLERS), f"lubricant.temperature={temperature} degC", f"operation.shaft_speed={speed} rpm")
            kappa = viscosity / (45000 * speed**-0.83 * 165**-0.5)
            self.assertAlmostEqual(found["kappa"] / kappa, 1, delta=1e-3, msg=temperature)
        resolved = self.folder / "results"
        self.assertEqual(run("run", self.case(SPINDLE_ROLLERS), "-o", resolved, "--quiet").returncode, 0)
        again, first = answer("run", resolved / "case.resolved.yaml"), answer("run", self.case(SPINDLE_ROLLERS))
        self.assertAlmostEqual(again["kappa"] / first["kappa"], 1, delta=1e-5)

    def test_refusals_say_what_to_state(self):
        graded = SPINDLE_ROLLERS.replace("viscosity_40: 200 mm2/s, viscosity_100: 16 mm2/s", "grade: ISO VG 200")
        self.assertIn("lubricant.viscosity_40 and lubricant.viscosity_100 instead of a grade", self.refused(graded))
        for key in ("kinematic_viscosity_40", "nu_40", "viscosity_40C"):
            self.assertIn("did you mean 'lubricant.viscosity_40'", self.refused(SPINDLE_ROLLERS.replace("viscosity_40", key, 1)))
        self.assertIn("lubricant.viscosity_40 is required with it", self.refused(SPINDLE_ROLLERS.replace("viscosity_40: 200 mm2/s, ", "")))
        self.assertIn("less at 100 degC than at 40 degC", self.refused(SPINDLE_ROLLERS.replace("16 mm2/s", "300 mm2/s")))
        self.assertIn("one of the two is required", self.refused(SPINDLE_ROLLERS.replace("{viscosity_40", "{grade: ISO VG 220, viscosity_40")))

    def test_the_index_stands_for_the_viscosity_at_100(self):
        graded = SPINDLE_ROLLERS.replace("viscosity_40: 200 mm2/s, viscosity_100: 16 mm2/s", "grade: ISO VG 220")
        alike = SPINDLE_ROLLERS.replace("viscosity_40: 200 mm2/s, viscosity_100: 16 mm2/s", "viscosity_40: 220 mm2/s")
        self.assertAlmostEqual(answer("run", self.case(alike))["kappa"] / answer("run", self.case(graded))["kappa"], 1, delta=1e-9)


class Assumptions(Case):
    def test_kind_of_lubrication_stands_with_its_effect(self):
        file = self.case(PUMP)
        found = answer("run", file)
        effects = {one["key"]: one.get("effect", "") for one in found["assumptions"]}
        there = answer("run", file, "life.lubrication=oil-bath")
        percent = 100 * (there["L10mh"] / found["L10mh"] - 1)
        self.assertLess(percent, -50)
        self.assertIn(f"oil-bath: L10mh {percent:+.0f} %", effects["life.lubrication"])
        self.assertIn("life.lubrication circulating-oil; oil-bath: L10mh", run("run", file).stdout)
        self.assertNotIn("effect", next(one for one in answer("run", file, "life.lubrication=oil-bath")["assumptions"] if one["key"] == "life.reliability"))

    def test_all_that_check_lists_and_moves_a_life_stands_in_a_run(self):
        file = self.case(REDUCER_4 + "lubricant: {grade: ISO VG 220}\nlife: {cleanliness: -/17/14}\n")
        effects = {one["key"] for one in answer("run", file)["assumptions"] if "effect" in one}
        base = self.point(file.read_text(encoding="utf-8"))
        lives = ("L10h", "L10rh", "L10mh", "L10mrh", "life_h")
        for row in answer("check", file)["inputs"]:
            if row["standing"] != "assumed" or row["origin"] != "default" or not isinstance(row["value"], float) or row["value"] == 0 or row["unit"] in ("", "K"):
                continue
            if row["path"] in ("life.reliability",) or row["path"].startswith("input.") or row["reason"].startswith("default: NSK"):  # no estimates
                continue
            number, _, unit = row["given"].partition(" ")
            changed = run("run", file, "--json", "--set", f"{row['path']}={1.1 * float(number)!r} {unit}".rstrip())
            if changed.returncode != 0:
                continue
            there = json.loads(changed.stdout)["points"][0]
            if max(abs(there[life] / base[life] - 1) for life in lives) > 0.02:
                self.assertIn(row["path"], effects)


class Defaults(Case):
    def test_first_drafts_of_gear_sets(self):
        """No profile shift, no cage sizes: both are assumed and listed."""
        text = REDUCER_4.replace("profile_shift: {sun: 0.3, ring: 0.5}, ", "").replace(
            "designation: NU 2207, per_planet: 2, clearance_class: CN, cage: {material: brass}",
            "type: cylindrical-roller, per_planet: 2, rollers: 14, roller_diameter: 11 mm, roller_length: 15 mm, pitch_diameter: 53.5 mm, radial_clearance: 40 um, bore: 35 mm, "
            "outside_diameter: 72 mm, width: 23 mm, cage: {material: brass}")
        assumed = {row["path"] for row in answer("check", self.case(text))["inputs"] if row["standing"] == "assumed"}
        self.assertLessEqual({"gearset.profile_shift.sun", "gearset.profile_shift.ring", "bearing.cage.inner_diameter", "bearing.cage.outer_diameter", "bearing.cage.width"}, assumed)
        self.assertEqual(self.point(text)["status"], "ok")

    def test_modes_take_neither_power_nor_speed(self):
        alone, driven = answer("modes", self.case(GEARS_ALONE)), answer("modes", self.case(GEARS_ALONE + "input: {member: sun, power: 10 kW, speed: 1000 rpm}\n"))
        self.assertEqual([mode["frequency_Hz"] for mode in alone["modes"]], [mode["frequency_Hz"] for mode in driven["modes"]])
        self.assertFalse(any("shape_quarter" in mode for mode in alone["modes"]))
        self.assertIn("input.power: missing", self.refused(GEARS_ALONE, command="mesh"))

    def test_diameters_of_gears(self):
        """The printed pair 12/60, 30 degrees: reference, base and pitch diameters of the handbook."""
        file = self.case(HELICAL)
        first, second = answer("mesh", file)["gears"]
        for gear, reference, base, pitch in ((first, 41.569, 38.322, 41.667), (second, 207.846, 191.611, 208.333)):
            for key, right in (("reference_mm", reference), ("base_mm", base), ("pitch_mm", pitch)):
                self.assertAlmostEqual(gear[key], right, delta=6e-4, msg=key)
        self.assertAlmostEqual(self.row(file, "pair.first_gear.pitch_diameter")["value"], 41.667, delta=6e-4)
        rows = {row["path"]: row["value"] for row in answer("check", REDUCER)["derived"]}
        centre = rows["gearset.centre_distance"]
        self.assertAlmostEqual(rows["gearset.sun.pitch_diameter"] + rows["gearset.planet.pitch_diameter"], 2 * centre, delta=1e-9)
        self.assertAlmostEqual(rows["gearset.ring.pitch_diameter"] - rows["gearset.planet.ring_pitch_diameter"], 2 * centre, delta=1e-9)

    def test_single_planets_are_in_json(self):
        """Equal springs: a pin off changes the loads of five planets by cos(2 pi (i - 1)/5), sun and ring taking out the first harmonic."""
        errors = "gearset.dynamics.pin_error.tangential=[10 um, 0 um, 0 um]"
        planets = self.point(REDUCER_4, errors)["planets"]
        self.assertEqual(len(planets), 3)
        self.assertAlmostEqual(sum(planet["load_share"] for planet in planets), 3, delta=1e-9)
        for planet in planets:
            self.assertGreater(planet["bearing_load_N"], 0)
            self.assertGreater(planet["L10rh"], 0)
        self.assertNotIn("planets", self.point(REDUCER_4))

    def test_the_word_for_other_bearings(self):
        for name, word in (("30305", "a tapered roller bearing"), ("33014", "a tapered roller bearing"), ("22310", "a spherical roller bearing")):
            said = self.refused(REDUCER_4.replace("NU 2207", f"'{name}'"))
            self.assertIn(word, said)
            self.assertNotIn("NU", said)

    def test_a_key_of_another_model_is_proposed_as_such(self):
        said = self.refused(PUMP.replace("clearance_class: CN", "clearance_class: CN, arrangement: O"))
        self.assertIn("is one, in cases of another model", said)

    def test_seats_by_the_commonest_classes(self):
        """Interference of normal bearings on j5 and in J6, J7 as catalogues print it; M6 above 250 to 315 mm has ES -9."""
        for pin, planet, inner, outer in (("j5", "J7", (-5, 18), (-31, 12)), ("j6", "J6", (-5, 23), (-26, 6))):
            rows = {row["path"]: row["value"] for row in answer("check", self.case(REDUCER_4), f"bearing.fit.pin_class={pin}", f"bearing.fit.planet_class={planet}")["derived"]}
            for seat, right in (("inner", inner), ("outer", outer)):
                for end, value in zip(("least", "most"), right, strict=True):
                    self.assertAlmostEqual(rows[f"bearing.fit.{seat}_interference.{end}"], value, delta=1e-6, msg=(pin, planet, seat, end))


class DerivedValues(Case):
    def test_what_fails_says_so_in_its_line(self):
        """`check` shows its table where a derived value has none, as `run` in motion goes on."""
        light = CASES / "templates" / "wind-stage.yaml"
        for case, values in ((light, ("input.power=4 kW",)), (REDUCER, ("bearing.roller_diameter_deviation=[1 um, 2 um]",)),
                             (REDUCER, ("bearing.outer_race.waviness={order: [3], amplitude: [1 um], phase: [0 deg]}",)), (CASES / "reducer_needles", ("gearset.dynamics.backlash=0 mm",))):
            with self.subTest(case, values=values):
                found = answer("check", case, *values)
                rows = {row["path"]: row for row in found["derived"]}
                self.assertIn("gearset.centre_distance", rows)
                for row in rows.values():
                    self.assertEqual(row["value"] is None, row["meaning"].startswith("not computed: "), row)
                text = run("check", case, *settings(values)).stdout
                self.assertEqual("not computed: " in text, any(row["value"] is None for row in rows.values()))


if __name__ == "__main__":
    unittest.main()
