#!/usr/bin/env python3
"""`orbearing convert`: REXS files as cases, and results back into them.

The files are made here (rexs_files.py); the published ones and the schemas are tried where ORBEARING_REFERENCE names their folder.
"""

import json
import math
import os
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import program
import rexs_files

orbearing = program.package()

from orbearing.rexs import names, reading, results  # noqa: E402
from orbearing.rexs.__main__ import main  # noqa: E402

REFERENCE = pathlib.Path(os.environ.get("ORBEARING_REFERENCE", os.devnull)) / "rexs"
NO_REFERENCE = "ORBEARING_REFERENCE names no folder with rexs/: the published files and schemas are not part of the project"
ROUND_OFF = 1e-9
FORMS = (".rexs", ".rexsj", ".rexsz")
STAGE = "planetenstufe_9"


class Converting(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)
        self.count = 0

    def convert(self, file, *options, code=0):
        """The report; the command ends with `code`."""
        self.count += 1
        self.out = self.place / f"out{self.count}"
        result = program.within(main, file, "-o", self.out, "--json", *options)
        self.assertEqual(result.returncode, code, result.stderr)
        self.said = result.stderr
        report = json.loads(result.stdout)
        self.assertEqual(report, json.loads((self.out / "conversion.json").read_text(encoding="utf-8")))
        return report

    def made(self, model, form=".rexs", **more):
        self.count += 1
        return model.write(self.place / f"model{self.count}{form}", **more)

    def case(self, name=STAGE):
        return orbearing.load(self.out / "cases" / name / "case.yaml")

    def refused(self, text, *arguments):
        result = program.within(main, *arguments)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertIn(text, result.stderr)

    def left(self, report, component, attribute):
        return next(entry["reason"] for entry in report["left_out"] if (entry["component"], entry["attribute"]) == (component, attribute))

    def key(self, report, component, attribute):
        return {entry["key"] for entry in report["taken"] if (entry["component"], entry["attribute"]) == (component, attribute)}

    def assert_close(self, value, wanted, tolerance=ROUND_OFF):
        self.assertLessEqual(abs(value - wanted), tolerance * abs(wanted), f"{value} is not {wanted}")


class Stage(Converting):
    """A planetary stage with its bearings."""

    def test_all_forms_give_one_case(self):
        texts = set()
        for form in FORMS:
            report = self.convert(self.made(rexs_files.planetary(), form))
            self.assertEqual(report["stages"][0]["case"], f"cases/{STAGE}/case.yaml")
            text = (self.out / report["stages"][0]["case"]).read_text(encoding="utf-8")
            texts.add("\n".join(line for line in text.splitlines() if not line.startswith("source:")))
        self.assertEqual(len(texts), 1)

    def test_the_case_is_that_of_the_stage_it_describes(self):
        """cases/wind_stage_750kW states the same stage."""
        self.convert(self.made(rexs_files.planetary()))
        case, ours = self.case(), orbearing.load(program.WIND)
        for path in ("gearset.planets", "gearset.teeth.sun", "gearset.teeth.planet", "gearset.teeth.ring", "gearset.module", "gearset.helix_angle",
                     "gearset.profile_shift.sun", "gearset.profile_shift.ring", "gearset.face_width", "gearset.fixed", "input.member", "input.speed",
                     "bearing.per_planet", "bearing.rollers", "bearing.roller_diameter", "bearing.roller_length", "bearing.pitch_diameter",
                     "bearing.radial_clearance", "bearing.bore", "bearing.outside_diameter", "bearing.width", "lubricant.grade", "lubricant.temperature"):
            found, wanted = case[path], ours[path]
            self.assert_close(found, wanted) if isinstance(wanted, float) else self.assertEqual(found, wanted, path)
        self.assertEqual(case.given("bearing.dynamic_capacity"), "930 kN")
        self.assertEqual(case.given("bearing.static_capacity"), "1200 kN")
        self.assertEqual(case["bearing.axial_places"], [-0.055, 0.055])
        self.assert_close(case["support.pin_span"], 0.28)
        # Drop of a circle of 20 m through the middle of the outermost of 40 laminae of 58 mm.
        self.assert_close(case["bearing.profile.drop"], 20.0 - math.sqrt(400.0 - (0.5 * 0.058 * 39 / 40) ** 2), 1e-6)

    def test_check_and_run_take_it(self):
        self.convert(self.made(rexs_files.planetary()))
        file = self.out / "cases" / STAGE / "case.yaml"
        self.assertEqual(program.run("check", file).returncode, 0)
        point = program.answer("run", file)["points"][0]
        self.assert_close(point["L10_Mrev"], (930.0 / (point["P_N"] / 1e3)) ** (10 / 3), 1e-6)

    def test_figures_are_those_of_statics(self):
        report = self.convert(self.made(rexs_files.planetary()))
        figures = report["stages"][0]["figures"]
        self.assert_close(figures["pin_force_N"], 325541.0 / (3 * 0.308))
        self.assert_close(figures["force_per_bearing_N"], 325541.0 / (6 * 0.308))
        self.assert_close(figures["sun_speed_rpm"], 22.0 * (1 + 99 / 21))
        self.assert_close(figures["sun_torque_N_m"], -325541.0 / (1 + 99 / 21))
        self.assertEqual(figures["ring_speed_rpm"], 0.0)
        self.assert_close(figures["mesh_frequency_Hz"], 22.0 / 60 * 99)
        self.assert_close(figures["sun_contact_ratio"], 1.52363, 1e-5)  # as `orbearing mesh` has it
        self.assertEqual(report["units"]["pin_force_N"], "N")

    def test_nothing_is_lost_without_being_named(self):
        for model in (rexs_files.planetary(), rexs_files.planetary(bearing="concept"), rexs_files.planetary(load_cases=True)):
            report = self.convert(self.made(model))
            named = {(entry.get("load_case", ""), entry["component"], entry["attribute"]) for entry in report["taken"] + report["left_out"]}
            stated = {("", number, key) for number, _, _, rows in model.components for key, _, _ in rows}
            stated |= {(str(number), component, key) for number, parts in model.load_cases for component, _, rows in parts for key, _, _ in rows}
            self.assertEqual(named, stated)
            both = {(entry.get("load_case", ""), entry["component"], entry["attribute"]) for entry in report["taken"]} \
                & {(entry.get("load_case", ""), entry["component"], entry["attribute"]) for entry in report["left_out"]}
            self.assertEqual(both, set())
            self.assertTrue(all(entry["reason"] for entry in report["left_out"] + report["missing"]))

    def test_an_entry_names_component_attribute_value_unit_and_key(self):
        report = self.convert(self.made(rexs_files.planetary()))
        self.assertIn({"component": rexs_files.SUN, "type": "cylindrical_gear", "attribute": "number_of_teeth", "value": 21, "unit": "none",
                       "case": STAGE, "key": "gearset.teeth.sun"}, report["taken"])
        copy = next(entry for entry in report["taken"] if entry["component"] == rexs_files.PLANET + 2 and entry["attribute"] == "number_of_teeth")
        self.assertEqual(copy["copy_of"], rexs_files.PLANET)

    def test_versions(self):
        """Attributes by the names of 1.0, 1.4 and 2.0."""
        cases = []
        for version, degree in (("1.0", "\u00b0"), ("1.4", "deg"), ("2.0.0", "deg")):
            self.convert(self.made(rexs_files.planetary(version=version, degree=degree)))
            case = self.case()
            cases.append([case[path] for path in ("bearing.dynamic_capacity", "bearing.pitch_diameter", "bearing.radial_clearance", "gearset.helix_angle")])
        self.assertEqual(cases[0], cases[1])
        self.assertEqual(cases[1], cases[2])

    def test_load_cases_are_the_spectrum(self):
        for version in ("1.2", "2.0"):
            report = self.convert(self.made(rexs_files.planetary(version=version, load_cases=True)))
            rows = self.case()["spectrum"]
            self.assertEqual([round(row["power"]) for row in rows], [750000, 400000, 100000])
            self.assertEqual([row["share"] for row in rows], [0.25, 0.6, 0.15])
            self.assertEqual(self.case().given("input.speed"), "18 rpm")
            self.assertIn("load case 2, the longest", next(entry["instead"] for entry in report["missing"] if entry["key"] == "input.power"))

    def test_shares_that_do_not_add_up_are_scaled_and_told(self):
        model = rexs_files.planetary(load_cases=True)
        model.load_cases = model.load_cases[:2]
        report = self.convert(self.made(model))
        self.assertEqual([round(row["share"], 6) for row in self.case()["spectrum"]], [0.294118, 0.705882])
        self.assertTrue(any("add up to 0.85; scaled to 1" in note for note in report["notes"]), report["notes"])

    def test_the_sign_of_the_rings_shift(self):
        """Negative outward as in DIN 3960; the centre distance shows a file that has it positive outward."""
        for shift, told in ((-0.9737, False), (0.9737, True)):
            report = self.convert(self.made(rexs_files.planetary(ring_shift=shift)))
            self.assertEqual(self.case()["gearset.profile_shift.ring"], 0.9737)
            self.assertEqual(any("positive outward in this file" in note for note in report["notes"]), told)

    def test_a_shift_that_is_not_stated_follows_from_the_centre_distance(self):
        model = rexs_files.planetary()
        model.components = [(number, kind, name, [row for row in rows if number // 10 != rexs_files.SUN or row[0] != "addendum_modification_coefficient"])
                            for number, kind, name, rows in model.components]
        report = self.convert(self.made(model))
        self.assert_close(self.case()["gearset.profile_shift.sun"], 0.1763, 1e-3)
        self.assertIn("centre distance gives it", next(entry["reason"] for entry in report["missing"] if entry["key"] == "gearset.profile_shift.sun"))

    def test_the_sun_drives_where_power_enters_there(self):
        model = rexs_files.planetary(torque=(-325541.0, "N m"))
        self.convert(self.made(model))
        self.assertEqual(self.case()["input.member"], "sun")
        self.assert_close(self.case()["input.speed"], math.radians(6 * 22.0) * (1 + 99 / 21), 1e-6)

    def test_a_concept_bearing_has_no_inside(self):
        report = self.convert(self.made(rexs_files.planetary(bearing="concept")))
        self.assertIsNone(self.case().given("bearing.rollers") if "bearing.rollers" in (self.out / "cases" / STAGE / "case.yaml").read_text() else None)
        self.assertIn("bearing.rollers", {entry["key"] for entry in report["missing"]})
        self.assert_close(report["stages"][0]["figures"]["force_per_bearing_N"], 325541.0 / (6 * 0.308))
        self.assertEqual(report["stages"][0]["figures"]["bearing_1_place_mm"], -55.0)

    def test_a_stronger_series_is_not_taken_for_the_plain_one(self):
        report = self.convert(self.made(rexs_files.planetary(bearing="designation")))
        self.assertNotIn((rexs_files.BEARING, "catalogue_designation"), [(entry["component"], entry["attribute"]) for entry in report["left_out"]])
        self.assertEqual(self.case()["bearing.designation"], "NU 2210 E")

    def test_a_member_must_be_held(self):
        model = rexs_files.planetary()
        model.relations = [one for one in model.relations if not (one[0] == "side" and ("assembly", 7) in one[1])]
        self.convert(self.made(model), code=2)
        self.assertIn("found 0 members held by a casing; one is required", self.said)

    def test_cleanliness_and_reliability(self):
        for version, contamination, survival in (("1.0", "contamination_factor_according_to_din_26281", "survival_probablity"),
                                                 ("2.0", "contamination_factor_iso_281_2007", "survival_probability")):
            model = rexs_files.planetary(version=version)
            model.components = [(number, kind, name, [*rows, (contamination, 0.6, "none"), (survival, 95.0, "%")] if number == rexs_files.BEARING else rows)
                                for number, kind, name, rows in model.components]
            self.convert(self.made(model))
            self.assertEqual(self.case()["life.contamination_factor"], 0.6)
            self.assertEqual(self.case()["life.reliability"], 0.95)

    def test_stages_in_a_row(self):
        """Each stage is a case, with the speed and torque that the other leaves to it."""
        report = self.convert(self.made(rexs_files.two_stages()))
        first, second = (entry["figures"] for entry in report["stages"])
        ratio = 1 + 99 / 21
        self.assert_close(second["carrier_speed_rpm"], 22.0 * ratio)
        self.assert_close(second["sun_speed_rpm"], 22.0 * ratio ** 2)
        self.assert_close(second["carrier_torque_N_m"], 325541.0 / ratio)
        self.assert_close(first["sun_torque_N_m"], -second["carrier_torque_N_m"])
        self.assertEqual([entry["case"] for entry in report["stages"]], [f"cases/{STAGE}/case.yaml", f"cases/{STAGE}_5009/case.yaml"])

    def test_a_shaft_that_points_the_other_way(self):
        model = rexs_files.planetary()
        model.components = [(number, kind, name, [*rows, ("u_axis_vector", [-1.0, 0.0, 0.0], "mm")] if number == 13 else rows)
                            for number, kind, name, rows in model.components]
        figures = self.convert(self.made(model))["stages"][0]["figures"]
        self.assert_close(figures["sun_speed_rpm"], 22.0 * (1 + 99 / 21))
        self.assert_close(figures["sun_torque_N_m"], -325541.0 / (1 + 99 / 21))

    def test_supports_are_taken_where_they_are_not_rigid(self):
        for stiffness, taken in ((2e8, True), (1e20, False)):
            model = rexs_files.planetary()
            for number in (91, 92):
                model.add(number, "concept_bearing", "Steglager", radial_stiffness=(stiffness, "N / m"))
                model.relate("side", assembly=number, inner_part=15, outer_part=rexs_files.CASING)
            report = self.convert(self.made(model))
            if taken:
                self.assertEqual(self.case().given("gearset.dynamics.carrier.support_stiffness"), "400000000 N/m")
            else:
                self.assertIn("rigid", self.left(report, 91, "radial_stiffness"))

    def test_rollers_that_fill_their_circle_have_no_cage(self):
        text = rexs_files.planetary().xml().replace('"number_of_rolling_elements" unit="none">16', '"number_of_rolling_elements" unit="none">18')
        file = self.place / "full.rexs"
        file.write_text(text, encoding="utf-8")
        self.convert(file)
        self.assertEqual(self.case()["bearing.complement"], "full")

    def test_an_open_clutch_holds_nothing(self):
        for engaged, code in ((True, 0), (False, 2)):
            model = rexs_files.planetary()
            model.components = [(number, "switchable_coupling" if number == 7 else kind, name,
                                 [*rows, ("is_engaged", [engaged], "none")] if number == 7 else rows) for number, kind, name, rows in model.components]
            self.convert(self.made(model), code=code)


class Traps(Converting):
    """Spellings on which readers of the format broke."""

    def test_the_sign_of_degrees_and_its_word(self):
        for degree in ("\u00b0", "deg"):
            self.convert(self.made(rexs_files.planetary(degree=degree)))
            self.assert_close(self.case()["gearset.helix_angle"], math.radians(7.5))

    def test_a_helix_of_minus_zero_is_zero(self):
        for form in FORMS:
            report = self.convert(self.made(rexs_files.planetary(helix=0.0), form))
            self.assertEqual(self.case().given("gearset.helix_angle"), "0 deg")
            self.assertEqual(math.copysign(1.0, self.case()["gearset.helix_angle"]), 1.0)
            self.assertEqual(self.key(report, rexs_files.PLANET, "helix_angle_reference_diameter"), {"gearset.helix_angle"})

    def test_rigid_is_no_number(self):
        report = self.convert(self.made(rexs_files.planetary()))
        self.assertIn("rigid", self.left(report, 7, "radial_stiffness"))
        self.assertIn("rigid", self.left(report, 7, "axial_stiffness"))
        self.assertNotIn("e+20", (self.out / "cases" / STAGE / "case.yaml").read_text(encoding="utf-8"))

    def test_coded_lists(self):
        """Planets at unequal angles follow from lists in base64, of both widths, in XML and JSON."""
        steps = [0, 39, 81]  # of 360/120 degrees
        for form in (".rexs", ".rexsj"):
            for code in ("float32", "float64"):
                model = rexs_files.planetary()
                for i, step in enumerate(steps):
                    angle = math.radians(3.0 * step)
                    place = [0.0, 308.0 * math.cos(angle), 308.0 * math.sin(angle)]
                    model.components = [(number, kind, name, [(key, place if number == 41 + i and key == "support_vector" else value, unit)
                                                              for key, value, unit in rows]) for number, kind, name, rows in model.components]
                self.convert(self.made(model, form, coded=code))
                found = [math.degrees(angle) for angle in self.case()["gearset.planet_angles"]]
                for angle, step in zip(found, steps):
                    self.assertLess(abs(angle - 3.0 * step), 5e-3)

    def test_a_coded_matrix_is_stored_by_columns(self):
        self.assertEqual(reading._matrix([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 2, 3), [[1.0, 3.0, 5.0], [2.0, 4.0, 6.0]])

    def test_a_broken_code_is_told(self):
        text = rexs_files.planetary().xml(coded="float64").replace('code="float64">', 'code="float64">A', 1)
        file = self.place / "broken.rexs"
        file.write_text(text, encoding="utf-8")
        report = self.convert(file)
        self.assertTrue(any("not read" in note for note in report["notes"]), report["notes"])

    def test_units_of_other_programs(self):
        for torque, speed in (((325.541, "kN m"), (22.0, "1/min")), ((325541.0, "Nm"), (22.0 * math.pi / 30.0, "rad / s")),
                              ((325541.0, "N m"), (22.0 / 60.0, "1 / s"))):
            self.convert(self.made(rexs_files.planetary(torque=torque, speed=speed)))
            self.assert_close(self.case()["input.power"], 325541.0 * 22.0 * math.pi / 30.0)

    def test_a_unit_of_another_quantity_is_told(self):
        report = self.convert(self.made(rexs_files.planetary(torque=(325541.0, "N / m"))), code=2)
        self.assertEqual(self.left(report, 5, "torque_around_u_axis"), "its unit 'N / m' is none of this quantity; 'N m' is required")
        self.assertIn("input.power", {entry["key"] for entry in report["missing"]})
        self.assertIn("input.power: missing", report["stages"][0]["problems"][0])
        self.assertTrue((self.out / report["stages"][0]["incomplete"]).is_file())

    def test_a_decimal_comma_is_no_number(self):
        text = rexs_files.planetary().xml().replace('<attribute id="width" unit="mm">80.0', '<attribute id="width" unit="mm">80,5')
        file = self.place / "comma.rexs"
        file.write_text(text, encoding="utf-8")
        report = self.convert(file)
        self.assertIn("a number with a decimal point is required", self.left(report, rexs_files.BEARING, "width"))

    def test_numbers_beyond_all_bounds_are_told(self):
        for value in ("1e999", "9" * 400, "-1e300"):
            text = rexs_files.planetary().xml().replace('<attribute id="width" unit="mm">80.0', f'<attribute id="width" unit="mm">{value}')
            text = text.replace('<attribute id="radial_stiffness" unit="N / m">1e+20', f'<attribute id="radial_stiffness" unit="N / m">{value}')
            file = self.place / "large.rexs"
            file.write_text(text, encoding="utf-8")
            self.assertIn("a number with a decimal point is required", self.left(self.convert(file), rexs_files.BEARING, "width"))

    def test_umlauts_and_commas_in_names(self):
        model = rexs_files.planetary()
        model.components = [(number, kind, "Größte Stufe 1,5 @ 0,0\u00b0" if number == rexs_files.STAGE else name, rows)
                            for number, kind, name, rows in model.components]
        for form in FORMS:
            report = self.convert(self.made(model, form))
            self.assertEqual(report["stages"][0]["case"], "cases/groesste_stufe_1_5/case.yaml")
            self.assertEqual(report["stages"][0]["name"], "Größte Stufe 1,5 @ 0,0\u00b0")


class WithoutStage(Converting):
    """A file without a planetary stage ends with 2; its pairs and bearings become cases."""

    def test_pair_and_bearings(self):
        report = self.convert(self.made(rexs_files.gearbox()), code=2)
        self.assertIn("no planetary stage found", self.said)
        pair = self.case("stage")
        self.assertEqual(pair["pair.teeth"], [20, 40])
        self.assertEqual(pair.given("pair.module"), "2 mm")
        self.assertEqual(pair.given("pair.face_width"), "20 mm")
        self.assertEqual(pair.given("pair.bore"), "25 mm")
        self.assertEqual(program.run("check", self.out / "cases" / "stage" / "case.yaml").returncode, 0)
        self.assert_close(report["pairs"][0]["figures"]["driving_torque_N_m"], 50.0)
        # 50 N m on a radius of 20 mm, at 20 degrees, halves on the bearings at both sides.
        force = 50.0 / 0.02 / math.cos(math.radians(20.0)) / 2
        for number, speed in ((30, 1000.0), (31, 1000.0), (40, 500.0), (41, 500.0)):
            bearing = self.case(f"6205_lager_{number}")
            self.assert_close(bearing["load.radial"], force)
            self.assert_close(bearing["operation.shaft_speed"], speed * math.pi / 30.0)
            self.assertEqual(bearing["bearing.clearance_class"], "C3")

    def test_helical_teeth_push_along_the_axis(self):
        """Moments of the axial force, and the one bearing that takes it."""
        model = rexs_files.gearbox()
        helix = {7: 15.0, 8: -15.0}
        model.components = [(number, kind, name, [(key, helix[number] if key == "helix_angle_reference_diameter" else value, unit) for key, value, unit in rows]
                             if number in helix else rows) for number, kind, name, rows in model.components]
        self.convert(self.made(model), code=2)
        radius, angle = 20.0 / math.cos(math.radians(15.0)), math.radians(15.0)
        thrust = 50.0e3 / radius * math.tan(angle)
        self.assert_close(self.case("6205_lager_30")["load.axial"], thrust)
        self.assertEqual(self.case("6205_lager_31")["load.axial"], 0.0)
        # Shaft 1: tangential 50e3/20 across, radial and the couple of the thrust in the plane of the axes.
        transverse = math.atan(math.tan(math.radians(20.0)) / math.cos(angle))
        radial = 2500.0 * math.tan(math.acos(radius * math.cos(transverse) / 20.0))
        first, second = (math.hypot(1250.0, 0.5 * radial + sign * thrust * 20.0 / 60.0) for sign in (1.0, -1.0))
        self.assert_close(self.case("6205_lager_30")["load.radial"], first if self.case("6205_lager_30")["load.radial"] > 1.4e3 else second)
        self.assert_close(sum(self.case(f"6205_lager_{number}")["load.radial"] for number in (30, 31)), first + second)

    def test_three_bearings_on_a_shaft_are_told(self):
        model = rexs_files.gearbox()
        model.add(32, "rolling_bearing_with_catalog_geometry", "third", catalogue_designation="6205", bearing_type="radial_grooved_ball_bearing",
                  u_coordinate_on_shaft_inner_side=(95.0, "mm"))
        model.relate("side", assembly=32, inner_part=5, outer_part=rexs_files.CASING)
        report = self.convert(self.made(model), code=2)
        problems = {entry["component"]: entry.get("problems") for entry in report["bearings"]}
        self.assertIn("statics of its shaft does not give it", problems[30][0])
        self.assertIsNone(problems[40])

    def test_what_no_case_describes_is_told(self):
        model = rexs_files.gearbox()
        model.components = [(number, kind, name, [(key, "radial_tapered_roller_bearing" if key == "bearing_type" and number == 30 else value, unit)
                                                  for key, value, unit in rows]) for number, kind, name, rows in model.components]
        model.components = [(number, "ring_gear" if number == 8 else kind, name, rows) for number, kind, name, rows in model.components]
        report = self.convert(self.made(model), code=2)
        self.assertIn("internal pair", report["pairs"][0]["problems"][0])
        self.assertIn("radial_tapered_roller_bearing", report["bearings"][0]["problems"][0])


class Results(Converting):
    """Lives, loads and lamina loads written back as REXS results."""

    def run_case(self, name=STAGE):
        folder = self.place / f"run{self.count}"
        result = program.run("run", self.out / "cases" / name / "case.yaml", "-o", folder, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        return folder, program.answer("run", self.out / "cases" / name / "case.yaml").get("points", [None])[0]

    def test_the_file_comes_back_with_lives_and_nothing_else_changes(self):
        for version, form in (("1.4", ".rexs"), ("2.0", ".rexsj"), ("1.0", ".rexsz")):
            file = self.made(rexs_files.planetary(version=version, degree="deg" if version != "1.0" else "\u00b0"), form)
            self.convert(file)
            before = (self.out / "cases" / STAGE / "case.yaml").read_text(encoding="utf-8")
            folder, point = self.run_case()
            report = self.convert(file, "--results", folder)
            again = reading.read(self.out / file.name)
            first = reading.read(file)
            added = {(entry["component"], entry["attribute"]) for entry in report["results"][0]["written"]}
            for number, component in first.components.items():
                for attribute in component.attributes.values():
                    self.assertEqual(again.components[number].attributes[attribute.id], attribute)
                extra = set(again.components[number].attributes) - set(component.attributes) - {"angular_position_around_u"}
                self.assertEqual(extra, {attribute for one, attribute in added if one == number})
            self.assertEqual(again.relations[:len(first.relations)], first.relations)
            life = {"1.4": "nominal_reference_rating_life_time_din_26281", "1.0": "nominal_reference_rating_life_time_din_26281",
                    "2.0": "nominal_reference_rating_life_time_iso_16281_2008"}[version]
            load = next(one for name, one in again.components[rexs_files.BEARING].attributes.items() if name.startswith("equivalent_dynamic"))
            self.assertEqual(load.unit, "kN")
            self.assert_close(load.value, point["P_N"] / 1e3)
            lives = [again.components[rexs_files.BEARING + i].attributes[life].value for i in (0, 1, 20, 21)]
            self.assertEqual(lives[:2], lives[2:])
            self.assert_close(min(lives), point["L10rh"], 0.2)
            self.assertNotEqual(lives[0], lives[1])  # helical teeth load one bearing more
            self.convert(self.out / file.name)
            self.assertEqual((self.out / "cases" / STAGE / "case.yaml").read_text(encoding="utf-8"), before)

    def test_lamina_loads(self):
        """Each roller with its contacts on both races; the loads on the inner race carry the load of the bearing."""
        file = self.made(rexs_files.planetary(version="2.0"))
        self.convert(file)
        folder, point = self.run_case()
        report = self.convert(file, "--results", folder)
        self.assertEqual(report["results"][0]["contacts"], 3 * 16 * 2)  # one bearing of each planet carries most
        self.assertIn("carries most", report["results"][0]["not_written"][0]["reason"])
        model = reading.read(self.out / file.name)
        row = next(iter(model.parts("ordered_assembly", "assembly", rexs_files.BEARING, "part")))
        rollers = model.parts("ordered_assembly", "assembly", row.id, "part")
        self.assertEqual(len(rollers), 16)
        along = across = 0.0
        for roller in rollers:
            contacts = model.parts("assembly", "assembly", roller.id, "part")
            inner = next(one for one in contacts if one.attributes["rolling_element_contact_type"].value == "inner_raceway_contact")
            laminae, force = inner.attributes["rolling_element_lamina_load"].value, inner.attributes["rolling_element_force"].value
            self.assert_close(1e3 * force, sum(laminae), 1e-9) if force else None
            self.assertEqual(len(laminae), len(inner.attributes["rolling_element_coordinate"].value))
            angle = math.radians(roller.attributes["angular_position_around_u"].value)
            along, across = along + 1e3 * force * math.cos(angle), across + 1e3 * force * math.sin(angle)
        self.assert_close(math.hypot(along, across), point["planet_load_N"] * 1.0544, 1e-3)  # 5.4 % more than the mean of both bearings

    def test_a_version_without_an_attribute_is_told(self):
        file = self.made(rexs_files.planetary(version="1.0"))
        self.convert(file)
        folder, _ = self.run_case()
        report = self.convert(file, "--results", folder)
        self.assertEqual({entry["column"] for entry in report["results"][0]["not_written"]}, {"L10mh", "L10m_Mrev", "contact_pressure_max_MPa", "lamina loads"})

    def test_single_bearings(self):
        file = self.made(rexs_files.gearbox())
        self.convert(file, code=2)
        folder, _ = self.run_case("6205_lager_40")
        report = self.convert(file, "--results", folder, code=2)
        self.assertEqual({entry["component"] for entry in report["results"][0]["written"]}, {40})
        self.assertIn(("equivalent_dynamic_bearing_load_iso_281_2007", "kN"), {(entry["attribute"], entry["unit"]) for entry in report["results"][0]["written"]})

    def test_a_run_of_another_case_is_refused(self):
        file = self.made(rexs_files.planetary())
        folder = self.place / "other"
        self.assertEqual(program.run("run", program.REDUCER, "-o", folder, "--quiet").returncode, 0)
        self.refused("is no case of this file with a bearing", file, "-o", self.place / "x", "--results", folder)
        self.refused("no results of a run", file, "-o", self.place / "y", "--results", self.place)


class Refusals(Converting):
    """What is no REXS file, and a REXS file given to other commands."""

    def write(self, name, content):
        file = self.place / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    def test_what_is_no_rexs_file(self):
        out = ("-o", self.place / "out")
        self.refused(":1:1: cannot be opened", self.place / "none.rexs", *out)
        self.refused("x.rexs:2:6: found what is no XML", self.write("x.rexs", '<model version="1.4">\n<a></b></model>'), *out)
        self.refused("root is 'html'", self.write("h.rexs", "<html/>"), *out)
        self.refused("j.rexsj:1:11: found what is no JSON", self.write("j.rexsj", '{"model": }'), *out)
        self.refused("a JSON file without 'model'", self.write("k.rexsj", '{"name": 1}'), *out)
        self.refused("a document type declaration", self.write("d.rexs", '<!DOCTYPE m [<!ENTITY a "b">]><model version="1.4"/>'), *out)
        self.refused("a ZIP file that cannot be read", self.write("z.rexsz", b"PK\x03\x04 broken"), *out)
        self.refused("found REXS 3.1", self.write("v.rexs", '<model version="3.1"/>'), *out)
        self.refused("a model without a version", self.write("w.rexs", "<model/>"), *out)
        self.refused("two components with the id 1", self.write("t.rexs", '<model version="1.4"><components><component id="1" type="shaft"/>'
                                                                 '<component id="1" type="shaft"/></components></model>'), *out)

    def test_zip_without_one_model(self):
        import zipfile

        file = self.place / "n.rexsz"
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("readme.txt", "no model")
        self.refused("a ZIP file with 0 REXS models (readme.txt)", file, "-o", self.place / "out")

    def test_options(self):
        file = self.made(rexs_files.planetary())
        self.refused("--output: missing", file)
        self.refused("--results: found without --output", file, "--json", "--results", self.place)
        (self.place / "full").mkdir()
        (self.place / "full" / "a").write_text("")
        self.refused("holds files", file, "-o", self.place / "full")
        self.refused("is a file; a folder is required", file, "-o", file)

    def test_the_program_hands_over(self):
        file = self.made(rexs_files.planetary())
        result = program.run("convert", file, "-o", self.place / "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(f"{self.place}/out/cases/{STAGE}/case.yaml", result.stdout)
        self.assertIn("usage: orbearing convert", program.run("convert", "--help").stdout)
        self.assertEqual([program.run("convert", word).returncode for word in ("--help", "--nonsense")], [0, 2])
        self.assertIn("convert", program.run("--help").stdout)

    def test_a_rexs_file_is_no_case(self):
        """Other commands name it and the command that reads it."""
        for form, kind in ((".rexs", "a REXS file"), (".rexsj", "a REXS file"), (".rexsz", "a ZIP file")):
            file = self.made(rexs_files.planetary(), form)
            for command in ("check", "run", "mesh"):
                result = program.run(command, file, *(("--json",) if command == "run" else ()))
                self.assertEqual(result.returncode, 2)
                self.assertEqual(result.stderr, f"{file}:1:1: (file): {kind}; a case in YAML is required; of a REXS file (.rexs, .rexsj, .rexsz) "
                                                f"'orbearing convert {file} -o DIR' makes cases\n")
        self.assertIn("an XML file", program.run("check", self.write("a.xml", "<html/>")).stderr)


@unittest.skipUnless(REFERENCE.is_dir(), NO_REFERENCE)
class Published(Converting):
    """The published files, and the schemas that the format publishes."""

    def test_the_planetary_stage_in_all_forms(self):
        for form in FORMS:
            report = self.convert(REFERENCE / f"FVA_Planetary_stage_-_Minus_gearing_1.1{form}")
            figures, case = report["stages"][0]["figures"], self.case()
            for name, wanted in {"centre_distance_mm": 78.0, "carrier_speed_rpm": 326.923, "planet_relative_speed_rpm": 906.469, "mesh_frequency_Hz": 332.372,
                                 "sun_torque_N_m": 1591.549, "pin_force_N": 31206.9, "force_per_bearing_N": 15603.4, "sun_contact_ratio": 1.54775,
                                 "ring_contact_ratio": 1.95716}.items():
                self.assert_close(figures[name], wanted, 1e-5)
            self.assert_close(-figures["carrier_torque_N_m"], 7302.4, 1e-5)
            self.assertEqual([case[f"gearset.teeth.{name}"] for name in ("sun", "planet", "ring")], [17, 22, 61])
            self.assertEqual(case.given("input.power"), "250 kW")
            self.assertEqual([figures["bearing_1_place_mm"], figures["bearing_2_place_mm"]], [-12.5, 12.5])

    def test_the_small_sample(self):
        for form in (".rexs", ".rexsz"):
            report = self.convert(REFERENCE.parent / "public_cases" / f"planetary_sample{form}")
            self.assert_close(report["stages"][0]["figures"]["pin_force_N"], 31206.9, 1e-5)
            self.assertEqual(self.case("planetenstufe").given("gearset.helix_angle"), "0 deg")

    def test_the_gearboxes_without_a_planetary_stage(self):
        report = self.convert(REFERENCE / "SEW_3-stage_cylindrical_gearbox_1.0.rexs", code=2)
        self.assertEqual([self.case(name)["pair.teeth"] for name in ("stirnradstufe", "stirnradstufe_37", "stirnradstufe_55")], [[23, 67], [13, 76], [14, 87]])
        self.assertEqual(len(report["bearings"]), 9)
        self.assertTrue(all(entry["case"] or entry["problems"] for entry in report["bearings"]))
        for form in (".rexs", ".rexsj"):
            report = self.convert(REFERENCE / f"FVA-Industriegetriebe_2stufig_1-4{form}", code=2)
            self.assertEqual([self.case(name)["pair.teeth"] for name in ("cylindrical_stage_24", "cylindrical_stage_41")], [[27, 51], [23, 34]])
            self.assertIn("plausible", self.left(report, 16, "tip_diameter"))

    def test_attributes_and_units_are_those_of_the_schemas(self):
        """Each name of the table is in a schema for one of its components, with a unit of that quantity; results with the very unit of the version."""
        schemas = [ElementTree.parse(file).getroot() for file in sorted((REFERENCE / "schema").glob("*.xml"))]
        self.assertEqual([one.get("version") for one in schemas], ["1.4", "1.7", "2.0.0"])
        units_of, has = {}, {}
        for schema in schemas:
            units = {one.get("id"): one.get("name") for one in schema.find("units")}
            for one in schema.find("attributes"):
                units_of.setdefault(one.get("attributeId"), {})[schema.get("version")] = units[one.get("unit")]
            for one in schema.find("componentAttributeMappings"):
                has.setdefault(one.get("attributeId"), set()).add(one.get("componentId"))
        for name, known in names.KNOWN.items():
            self.assertIn(known.names[0], units_of, name)
            self.assertTrue(has[known.names[0]] & set(known.components), name)
            for unit in units_of[known.names[0]].values():
                self.assertEqual(names.unit_of(unit).quantity, names.unit_of(known.unit).quantity, name)
        for version in ((1, 4), (1, 7), (2, 0)):
            text = "2.0.0" if version == (2, 0) else f"{version[0]}.{version[1]}"
            for result in results.RESULTS:
                spelling = result.of(version)
                if spelling is not None:
                    self.assertEqual(units_of[spelling.attribute].get(text), spelling.unit, (text, spelling.attribute))
                    self.assertIn("rolling_bearing_with_catalog_geometry", has[spelling.attribute])


if __name__ == "__main__":
    unittest.main()
