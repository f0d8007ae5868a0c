#!/usr/bin/env python3
"""Cases that people tried elsewhere, second collection: gearboxes of coupled sets, fits, factors and examples of makers, with the right figure or the refusal.

The table of all cases and their tests is in public_cases.py.
"""

import math
import unittest

from program import InFolder, answer, run, settings, warned

# Teeth of sun, planet and ring and the module [mm] of four sets of an automatic gearbox, and its gears: shafts, and the printed ratio.
SETS = {"p1": (48, 24, 96, 1.3), "p2": (48, 24, 96, 1.3), "p3": (69, 21, 111, 1.1), "p4": (23, 31, 85, 1.5)}
GEARS = {
    "1": (4.6957, "motor p4.sun", "load p4.carrier", "ground p1.sun p1.ring", "p4.ring p1.carrier"),
    "2": (3.1304, "motor p2.carrier", "load p4.carrier", "ground p1.sun p1.ring p2.sun", "p1.carrier p4.ring", "p4.sun p2.ring"),
    "3": (2.1039, "motor p4.sun p2.ring p2.carrier", "load p4.carrier", "ground p1.ring", "p1.sun p2.sun", "p1.carrier p4.ring"),
    "4": (1.6667, "motor p2.carrier", "load p3.carrier p4.carrier", "ground p1.ring", "p3.sun p3.ring p4.sun p2.ring", "p1.sun p2.sun", "p1.carrier p4.ring"),
    "5": (1.2845, "motor p3.ring p4.sun p2.carrier", "load p3.carrier p4.carrier", "ground p1.ring", "p3.sun p2.ring", "p1.sun p2.sun", "p1.carrier p4.ring"),
    "6": (1.0, "motor p3.sun p3.ring", "load p3.carrier"),
    "7": (0.8392, "motor p3.ring p2.carrier", "load p3.carrier", "ground p2.sun", "p3.sun p2.ring"),
    "8": (0.6667, "motor p2.carrier", "load p3.carrier", "ground p2.sun", "p3.sun p3.ring p2.ring"),
    "R": (-3.2968, "motor p2.carrier", "load p3.carrier p4.carrier", "ground p1.sun p1.ring p2.sun", "p3.sun p2.ring", "p3.ring p4.sun", "p1.carrier p4.ring"),
}
NEUTRAL = ("motor p2.carrier", "load p4.carrier p3.carrier", "p1.sun p2.sun", "p1.carrier p4.ring", "p2.ring p3.sun", "p3.ring p4.sun", "ground p1.ring")


def gearbox(name, shafts):
    """A case of the sets that these shafts join."""
    used = sorted({member.split(".")[0] for shaft in shafts for member in shaft.split() if "." in member})
    lines = [f"name: {name}", 'source: "teeth and ratios of a public table, connections by Willis"', "model: planetary-drivetrain", "input: {torque: 100 N.m, speed: 1000 rpm}", "shafts:"]
    lines += [f"  s{i}: [{', '.join(shaft.split())}]" for i, shaft in enumerate(shafts)]
    lines.append("sets:")
    for one in used:
        sun, planet, ring, module = SETS[one]
        lines.append(f"  {one}: {{gearset: {{planets: 4, teeth: {{sun: {sun}, planet: {planet}, ring: {ring}}}, profile_shift: {{sun: 0, ring: 0}}, module: {module} mm, "
                     f"face_width: 25 mm}}}}")
    return "\n".join(lines) + "\n"


STEPPED = """name: stepped_and_wolfrom
source: default design of a calculator of planetary gears
model: planetary-drivetrain
input: {member: sun, torque: 1 N.m, speed: 1000 rpm}
gearset:
  planets: 3
  teeth: {sun: 12, planet: 39, ring: 54}
  profile_shift: {sun: 0, ring: 0}
  stepped_planet: {teeth: 20, module: 1.2 mm, face_width: 8 mm, offset: 12 mm}
  module: 0.8 mm
  face_width: 8 mm
"""
PLANET_5MW = """name: planet_5mw_17
source: public model of a 5 MW gearbox, first stage; rollers assumed
model: planetary-drivetrain
input: {member: carrier, power: 5000 kW, speed: 12.1 rpm}
gearset:
  planets: 3
  teeth: {sun: 19, planet: 17, ring: 56}
  module: 45 mm
  profile_shift: {sun: 0.617, ring: 0.5013}
  centre_distance: 863 mm
  face_width: 491 mm
  addendum: 0.75864
  clearance: 0.49136
  root_fillet_radius: 0.38
bearing: {type: cylindrical-roller, per_planet: 1, complement: full, roller_diameter: 70 mm, roller_length: 300 mm, pitch_diameter: 475 mm, bore: 350 mm,
          outside_diameter: 600 mm, width: 400 mm, radial_clearance: 100 um, dynamic_capacity: 4730 kN}
"""
SEATS = """name: seats
source: table of fits of a maker
model: planetary-drivetrain
input: {member: sun, power: 100 kW, speed: 100 rpm}
gearset: {planets: 3, teeth: {sun: 24, planet: 33, ring: 90}, module: 8 mm, profile_shift: {sun: 0.3, ring: 0.5}, face_width: 120 mm}
bearing: {type: cylindrical-roller, per_planet: 1, complement: full, roller_diameter: ROLLER mm, roller_length: ROLLER mm, pitch_diameter: PITCH mm, bore: BORE mm,
          outside_diameter: OUTSIDE mm, width: 40 mm, clearance_state: unmounted, radial_clearance: 80 um, fit: {pin_class: k5, planet_class: M6}}
"""
HELICAL = """name: helical_12_60
source: helical pair of a printed table
model: gear-pair
pair: {teeth: [12, 60], module: 3 mm, helix_angle: 30 deg, face_width: 30 mm, bore: 15 mm, driven_bore: 60 mm, profile_shift: [0.09809, 0]}
"""
THREE_DIMENSIONS = """name: helical_in_three_dimensions
source: parameters of a published helical set, in its plane
model: planetary-drivetrain
input: {member: sun, power: 10 kW, speed: 1000 rpm}
gearset:
  planets: 4
  teeth: {sun: 48, planet: 32, ring: 112}
  profile_shift: {sun: 0, ring: 0}
  module: 0.943 mm
  helix_angle: 28.5 deg
  face_width: 25 mm
  dynamics: {mesh_stiffness: {sun: 6.19e9 N/m, ring: 22.3e9 N/m}, planet: {mass: 0.2 kg, bearing_stiffness: 1e9 N/m}}
"""
ONE_PIN_OFF = """name: one_pin_off
source: load shares of planets about a floating sun, in closed form
model: planetary-drivetrain
input: {member: sun, power: 160 kW, speed: 3000 rpm}
gearset:
  planets: COUNT
  teeth: {sun: TEETH}
  module: 2.5 mm
  face_width: 32 mm
  dynamics:
    sun: {support_stiffness: 0 N/m}
    pin_error: {tangential: [ERRORS]}
bearing: {type: cylindrical-roller, complement: full, rings: none, per_planet: 2, roller_diameter: 4 mm, roller_length: 10 mm, pitch_diameter: 32 mm, width: 11 mm,
          radial_clearance: 0 um}
"""
ACROSS = """name: across_and_along
source: ratio of both stiffnesses of a rolling bearing by a sum over its elements
model: MODEL
load: {radial: 4 kN, tilt: 0 mrad}
bearing: {ELEMENTS, pitch_diameter: 65 mm, radial_clearance: 0 um}
"""
ELEMENTS = {"roller-bearing": "type: cylindrical-roller, rollers: 12, roller_diameter: 10 mm, roller_length: 10 mm", "ball-bearing": "balls: 12, ball_diameter: 10 mm"}
TAPERED = """name: tapered_in_a_pair
source: example 5 of a maker's catalogue, bearing of the larger load
model: roller-bearing
load: {radial: 3931 N}
bearing: {type: tapered-roller, rollers: 15, roller_diameter: 8.5 mm, roller_length: 11 mm, pitch_diameter: 44 mm, radial_clearance: 0 um, dynamic_capacity: 38.0 kN}
operation: {shaft_speed: 600 rpm}
"""
SPINDLE = """name: spindle_k50
source: calculation example of a maker of spindle bearings, of 15 degrees; balls assumed
model: ball-bearing
load: {radial: 2500 N, axial: 1000 N, tilt: 0 mrad}
bearing: {balls: 18, ball_diameter: 8.7 mm, pitch_diameter: 65 mm, contact_angle: 15 deg, radial_clearance: 0 um, dynamic_capacity: 34.6 kN, static_capacity: 32.4 kN}
operation: {shaft_speed: 1000 rpm}
"""
KAPPA = """name: viscosity_ratio
source: example of a maker's general catalogue; rollers assumed
model: roller-bearing
load: {radial: 200 kN}
bearing: {type: cylindrical-roller, rollers: 20, roller_diameter: 20 mm, roller_length: 40 mm, pitch_diameter: 165 mm, bore: 130 mm, outside_diameter: 200 mm, width: 69 mm,
          radial_clearance: 0 um, dynamic_capacity: 540 kN, static_capacity: 815 kN, fatigue_load_limit: 81.5 kN}
lubricant: {OIL}
life: {contamination_factor: 0.8}
operation: {shaft_speed: 50 rpm}
"""


class Cases(InFolder):
    def near(self, value, right, tolerance, what=""):
        self.assertLessEqual(abs(value / right - 1.0), tolerance, (what, value, right))

    def rows(self, text, *values):
        """Inputs and derived values of `check` by their paths, and all of it."""
        checked = answer("check", self.case(text), *values)
        return {row["path"]: row["value"] for row in checked["inputs"] + checked["derived"]}, checked

    def refusal(self, text, *values, command="check"):
        """One message of one line."""
        result = run(command, self.case(text), *settings(values))
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), result.stderr)
        return result.stderr


class CoupledSets(Cases):
    """zf_8hp_coupled_sets."""

    def flow(self, gear):
        _, *shafts = GEARS[gear]
        rows, checked = self.rows(gearbox(f"gear_{gear}", shafts))
        return rows, {(row["set"], row["member"]): row for row in checked["power_flow"]}, checked

    def test_ratios_of_nine_gears(self):
        for gear, (ratio, *_) in GEARS.items():
            _, flow, checked = self.flow(gear)
            leaving = next(row["speed_rpm"] for row in flow.values() if row["shaft"] == "s1")
            self.near(1000.0 / leaving, ratio, 1e-4, gear)
            self.assertEqual(checked["power_circulation"]["present"], gear in "3R", gear)

    def test_speeds_and_torques_of_gear_5(self):
        rows, flow, _ = self.flow("5")
        for row, right in ((("p3", "carrier"), 778.5), (("p1", "sun"), 2155.7), (("p1", "carrier"), 718.6), (("p2", "ring"), 422.2)):
            self.near(flow[row]["speed_rpm"], right, 2e-4, row)
        for one, speed, torque in (("p1", 2874.2, 14.23), ("p2", 2311.4, 14.23), ("p3", 1170.8, 28.45), ("p4", 164.3, 11.55)):
            self.near(abs(rows[f"sets.{one}.operation.planet_speed"]), speed, 4e-4, one)
            self.near(abs(flow[one, "sun"]["torque_N_m"]), torque, 5e-4, one)

    def test_reverse_with_a_set_that_stands(self):
        rows, flow, _ = self.flow("R")
        for row, right in ((("p3", "carrier"), -303.3), (("p3", "ring"), -1424.3), (("p2", "ring"), 1500.0)):
            self.near(flow[row]["speed_rpm"], right, 2e-4, row)
        self.assertEqual((flow["p1", "carrier"]["speed_rpm"], rows["sets.p1.operation.planet_speed"]), (0.0, 0.0))
        for one, torque in (("p1", 132.12), ("p2", 33.33), ("p3", 66.67), ("p4", 107.25)):
            self.near(abs(flow[one, "sun"]["torque_N_m"]), torque, 5e-4, one)
        for one, speed in (("p2", 2000.0), ("p3", 5925.2), ("p4", 831.7)):
            self.near(abs(rows[f"sets.{one}.operation.planet_speed"]), speed, 1e-4, one)

    def test_a_clutch_too_few(self):
        said = self.refusal(gearbox("neutral", NEUTRAL))
        self.assertIn("speeds undetermined: of ", said)
        for member in ("p4.carrier", "p3.carrier", "p1.sun", "p2.ring", "p3.ring", "p4.sun"):
            self.assertIn(f"{member} (on ", said)


class Planets(Cases):
    def test_two_gears_on_each_planet(self):
        """pgs_stepped_and_wolfrom; a second ring is refused in gears_and_pins.py."""
        rows, checked = self.rows(STEPPED)
        flow = {row["member"]: row for row in checked["power_flow"]}
        self.near(1000.0 / flow["carrier"]["speed_rpm"], 9.775, 1e-5)
        self.near(-flow["carrier"]["torque_N_m"], 9.775, 1e-5)
        for path, right in (("gearset.centre_distance", 20.4), ("operation.carrier_speed", 102.302), ("operation.planet_speed", -276.215)):
            self.near(rows[path], right, 1e-5, path)
        along = math.cos(math.radians(20.0))
        for path, right in (("operation.mesh_normal_force", 69.444), ("operation.ring_mesh_normal_force", 90.278)):
            self.near(rows[path] * along, right, 1e-4, path)
        self.near(rows["operation.pin_load_y"], 159.72, 1e-4)
        held, checked = self.rows(STEPPED, "gearset.fixed=carrier")
        self.near(next(row["speed_rpm"] for row in checked["power_flow"] if row["member"] == "ring"), -113.960, 1e-5)
        self.near(held["operation.planet_speed"], -307.692, 1e-5)
        shifted, _ = self.rows(STEPPED.replace("ring: 54", "ring: 90").replace("  stepped_planet: {teeth: 20, module: 1.2 mm, face_width: 8 mm, offset: 12 mm}\n", ""),
                               "gearset.profile_shift={sun: 0.4, ring: 1.2}")
        self.assertAlmostEqual(shifted["gearset.profile_shift.planet"], 0.4, 9)
        self.near(shifted["gearset.centre_distance"], 20.9826, 1e-5)  # 21.04 by adding up the shifts

    def test_two_rings_as_two_sets(self):
        """Speeds of a Wolfrom set come out of two sets with suns in common, loads do not: the circulating power is named."""
        shafts = ("motor a.sun b.sun", "a.carrier b.carrier", "load b.ring", "ground a.ring")
        gears = "planets: 3, profile_shift: {sun: 0, ring: 0}, module: 0.8 mm, face_width: 8 mm"
        text = STEPPED.split("gearset:")[0].replace("member: sun, ", "") + "shafts:\n" + "".join(f"  s{i}: [{', '.join(one.split())}]\n" for i, one in enumerate(shafts))
        text += (f"sets:\n  a: {{gearset: {{teeth: {{sun: 12, planet: 39, ring: 90}}, {gears}}}}}\n  b: {{gearset: {{teeth: {{sun: 12, planet: 39, ring: 54}}, "
                 f"stepped_planet: {{teeth: 20, module: 1.2 mm, face_width: 8 mm, offset: 12 mm}}, {gears}}}}}\n")
        _, checked = self.rows(text)
        flow = {(row["set"], row["member"]): row for row in checked["power_flow"]}
        self.near(flow["b", "ring"]["speed_rpm"], 17.094, 1e-4)
        self.near(flow["a", "carrier"]["speed_rpm"], 117.647, 1e-5)
        self.assertEqual(set(checked["power_circulation"]["members"]), {"a.sun", "a.carrier", "b.sun", "b.carrier"})
        self.near(checked["power_circulation"]["largest_share"], 23 / 3, 1e-9)

    def test_life_by_a_record_is_that_of_the_point(self):
        """rblo_planet_speed: the speed of the planet against its pin counts, not that against the housing."""
        rows, _ = self.rows(PLANET_5MW)
        self.near(-rows["operation.planet_speed"], 39.8588, 1e-5)
        point = answer("run", self.case(PLANET_5MW))["points"][0]
        self.near(-point["tangential_load_N"], 1524.14e3, 1e-5)
        self.near(point["P_N"], 1531.290e3, 1e-5)  # with the radial parts of unequal working angles, and 1.66 kN centrifugal
        self.near(point["L10_Mrev"], (4730e3 / point["P_N"]) ** (10 / 3), 1e-9)
        self.near(point["L10h"], point["L10_Mrev"] * 1e6 / 60.0 / 39.8588, 1e-5)
        record = self.folder / "record.csv"
        record.write_text("Time_[s],RotSpeed_[rpm],RotTorq_[kN-m]\n" + "".join(f"{i},12.1,{5e6 / (12.1 * math.pi / 30.0) / 1e3!r}\n" for i in range(10)), encoding="utf-8")
        series = answer("spectrum", record, options=("--torque", "RotTorq", "--speed", "RotSpeed", "--case", self.case(PLANET_5MW)))
        self.near(series["points"][0]["L10h"], point["L10h"], 1e-9)

    def test_one_pin_off(self):
        """one_pin_off_pattern: k e (delta_i1 - 1/N - (2/N) cos(2 pi (i - 1)/N)) while all planets carry."""
        for count, teeth, excess in ((3, "31, planet: 29, ring: 89", None), (4, "31, planet: 29, ring: 89", 1.0), (5, "31, planet: 29, ring: 89", 1.2361),
                                     (6, "54, planet: 24, ring: 102", None)):
            shares = {}
            for error in (2, -2):
                errors = ", ".join([f"{error} um"] + ["0 um"] * (count - 1))
                point = answer("run", self.case(ONE_PIN_OFF.replace("COUNT", str(count)).replace("TEETH", teeth).replace("ERRORS", errors)))["points"][0]
                shares[error] = [one["load_share"] - 1.0 for one in point["planets"]]
                self.near(point["largest_load_share"], 1.0 + max(shares[error]), 1e-9)
            if count == 3:
                self.assertLess(max(map(abs, shares[2] + shares[-2])), 1e-4)
                continue
            right = [(i == 0) - 1 / count - 2 / count * math.cos(2 * math.pi * i / count) for i in range(count)]
            for found in shares.values():
                for i in range(count):
                    self.assertAlmostEqual(found[i] / found[0] * right[0], right[i], delta=0.02 * right[0], msg=(count, i))
            if excess:
                high, low = sorted((max(shares[2]), max(shares[-2])))[::-1]
                self.near(high / low, excess, 0.02)


    def test_helical_modes_in_the_plane(self):
        """eritenel_parker_3d: without tilting inertias and stiffnesses the modes are those of the plane, and a warning says so."""
        found = answer("modes", self.case(THREE_DIMENSIONS))
        self.assertTrue(warned(found, "Axial and tilting vibration is left out"), found["warnings"])
        self.assertNotIn("in_three_dimensions", found)
        self.assertEqual({one["kind"] for one in found["modes"]}, {"rotational", "translational", "planet"})


class Pairs(Cases):
    def test_a_helical_pair_with_a_normal_shift(self):
        """helical_shift_x_mn."""
        rows, _ = self.rows(HELICAL)
        for path, right in (("centre_distance", 125.0), ("first_gear.reference_diameter", 41.569), ("second_gear.reference_diameter", 207.846), ("first_gear.base_diameter", 38.322),
                            ("second_gear.base_diameter", 191.611), ("first_gear.pitch_diameter", 41.667), ("second_gear.pitch_diameter", 208.333),
                            ("working_pressure_angle", 23.1126)):
            self.near(rows[f"pair.{path}"], right, 1.2e-5, path)  # digits as printed
        self.near(rows["pair.contact_ratio"], 1.29466, 2e-4)
        self.near(answer("mesh", self.case(HELICAL))["meshes"][0]["contact_ratio"], 1.29466, 2e-4)


class Seats(Cases):
    def test_worked_rows_of_a_table_of_fits(self):
        """nke_fit_table; all of its classes in tests/unit/bearing/seat_class_test.cpp."""
        for path, name, diameter, most, least in (("pin", "j5", 75, 21, -7), ("pin", "k5", 75, 30, 2), ("pin", "m5", 100, 48, 13), ("pin", "k5", 25, 21, 2),
                                                  ("planet", "H6", 120, 0, -37), ("planet", "M6", 160, 33, -17), ("planet", "N7", 90, 45, -5)):
            pin = path == "pin"
            bore, outside = (diameter, 2.0 * diameter) if pin else (0.55 * diameter, diameter)
            text = SEATS.replace("BORE", f"{bore:g}").replace("OUTSIDE", f"{outside:g}").replace("PITCH", f"{0.5 * (bore + outside):g}").replace("ROLLER", f"{0.2 * (outside - bore):g}")
            rows, _ = self.rows(text, f"bearing.fit.{path}_class={name}")
            found = f"bearing.fit.{'inner' if pin else 'outer'}_interference."
            self.assertAlmostEqual(rows[found + "most"], most, delta=1.0, msg=(name, diameter))
            self.assertAlmostEqual(rows[found + "least"], least, delta=1.0, msg=(name, diameter))


class Stiffness(Cases):
    def ratio(self, model, count, turn, *more):
        element = ELEMENTS[model].split(":")[0] if model == "ball-bearing" else "rollers"
        text = ACROSS.replace("MODEL", model).replace("ELEMENTS", ELEMENTS[model])
        found = answer("stiffness", self.case(text), f"bearing.{element}={count}", f"bearing.first_element_angle={turn * 360 / count!r} deg", *more)
        k = found["points"][0]["stiffness"]
        return k[1][1] / k[0][0], found["warnings"]

    def test_across_over_along(self):
        """across_over_along: also by tests/identities/bearing_stiffness_test.cpp. Straight rollers, as the sum has them."""
        straight = ("bearing.profile={kind: straight}",)
        for model, more, rows in (("roller-bearing", straight, ((8, 0.4904, 0.9331), (12, 0.6399, 0.9200), (16, 0.7114, 0.9143))),
                                  ("ball-bearing", (), ((8, 0.4568, 0.7341), (12, 0.5550, 0.7007), (16, 0.5947, 0.6882)))):
            for count, on_line, between in rows:
                self.near(self.ratio(model, count, 0, *more)[0], on_line, 2e-4, (model, count))
                self.near(self.ratio(model, count, 0.5, *more)[0], between, 2e-4, (model, count))

    def test_a_profile_that_is_not_stated_is_named_with_its_effect(self):
        stated, _ = self.ratio("roller-bearing", 12, 0, "bearing.profile={kind: straight}")
        assumed, warnings = self.ratio("roller-bearing", 12, 0)
        self.assertLess(assumed, stated)
        self.assertTrue(any("bearing.profile.kind: not given; iso16281 is used. Straight rollers change the stiffness along the load by +" in text for text in warnings), warnings)


class Ratings(Cases):
    def test_a_tapered_bearing_alone(self):
        """nsk_tapered_pair_example5: no life without the axial load that its mate causes."""
        said = self.refusal(TAPERED)
        self.assertIn("bearing.type: 'tapered-roller' in a case of one bearing; cylindrical-roller is required; other types are those of planets", said)
        both = run("run", self.case(TAPERED.replace("3931 N", "3931 N, axial: 3474 N")))
        self.assertEqual(both.returncode, 2)
        self.assertIn("load.axial: a field that roller-bearing does not use", both.stderr)

    def test_factors_of_one_row(self):
        """ukf_k50_pair: a maker rates the pair with X 1 and Y 1.46, 3960 N and 11 000 h."""
        found = answer("run", self.case(SPINDLE))
        self.near(found["equivalent_load_N"], 2500.0, 1e-9)
        self.near(found["L10h"], 1e6 / 60e3 * (34.6 / 2.5) ** 3, 1e-9)
        self.near(found["L10h"], 44183.0, 1e-5)
        self.assertIn("P of ISO 281, by X and Y of one row; a pair that its maker rates has others", run("run", self.case(SPINDLE), "-o", self.folder / "out").stdout)
        self.near(1e6 / 60e3 * (34.6 / (2.5 + 1.46)) ** 3, 11117.0, 1e-4)  # of the pair, by hand
        rows = run("run", self.case(SPINDLE), "--set", "bearing.rows.arrangement=back-to-back")
        self.assertIn("bearing.rows.arrangement: a field that ball-bearing does not use", rows.stderr)

    def test_viscosity_ratio(self):
        """skf_example5_kappa: 45000 n^-0.83 d_m^-0.5 below 1000 rpm; viscosities by ASTM D341."""
        for viscosity, speed, right in ((120, 50, 0.881), (60, 300, 1.948), (60, 400, 2.474), (75, 200, 1.740)):
            text = KAPPA.replace("OIL", f"kinematic_viscosity: {viscosity} mm2/s")
            self.near(answer("run", self.case(text), f"operation.shaft_speed={speed} rpm")["kappa"], right, 1e-3)
        for temperature, right in ((50, 112.9), (60, 68.7), (65, 54.9)):
            rows, _ = self.rows(KAPPA.replace("OIL", f"viscosity_40: 200 mm2/s, viscosity_100: 16 mm2/s, temperature: {temperature} degC"))
            self.near(rows["lubricant.kinematic_viscosity"], right * 1e-6, 1e-3)
        said = run("check", self.case(KAPPA.replace("OIL", "grade: ISO VG 200, temperature: 60 degC"))).stderr
        self.assertIn("an oil of another viscosity is stated by lubricant.viscosity_40 and lubricant.viscosity_100", said)


if __name__ == "__main__":
    unittest.main()
