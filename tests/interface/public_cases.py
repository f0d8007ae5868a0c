#!/usr/bin/env python3
"""Cases that people tried elsewhere, with the right figure or the refusal.

Facts and figures of public sources are in the cases below and in public_cases_second.py. Each case of both collections, each case of an independent
examination, and the first tries of new users are held by these tests (paths from tests/; `::` names what is in the file):

| collection | case | tests |
|---|---|---|
| first | rexs_fva_planetary | interface/public_cases.py::test_planetary_stage_of_17_22_61_teeth interface/rexs_convert.py::test_the_planetary_stage_in_all_forms |
| first | rexs_traps | interface/rexs_convert.py::test_the_sign_of_degrees_and_its_word interface/rexs_convert.py::test_a_rexs_file_is_no_case |
| first | dtu10_stage1 | interface/public_cases.py::test_first_stage_of_10_MW |
| first | dtu10_whole | interface/public_cases.py::test_three_stages_of_10_MW |
| first | grc_profile_shifts | interface/public_cases.py::test_wind_stage_of_750_kW |
| first | grc_loads | interface/public_cases.py::test_wind_stage_of_750_kW |
| first | grc_chain | interface/public_cases.py::test_gearbox_of_750_kW |
| first | planet_bearing_catalogue_C | interface/public_cases.py::test_planet_bearing_by_the_makers_rating |
| first | nearly_equal_planets | interface/public_cases.py::test_four_planets_that_do_not_stand_at_right_angles |
| first | internal_pair_KHK | interface/public_cases.py::test_pair_with_an_internal_gear unit/mesh/internal_pair_test.cpp |
| first | iko_full_complement | interface/public_cases.py::test_as_many_rollers_as_touch |
| first | out_of_round_planet | interface/public_cases.py::test_an_out_of_round_race |
| first | skf_example5_spectrum | interface/public_cases.py::test_spectrum_of_a_catalogue interface/lives_by_hand.py::test_a_iso_of_a_catalogue_example |
| first | ntn_examples_3_4 | interface/public_cases.py::test_rating_for_a_required_life interface/multi_stage.py |
| first | nup204_other_maker | interface/catalogue_file.py::test_stated_ratings_replace_those_of_the_designation |
| first | ross3_table | interface/stiffness_command.py::test_files_hold_the_same interface/ross_table.py::test_release_3 |
| first | exudyn_6010 | interface/public_cases.py::test_balls_in_grooves_that_no_bearing_has |
| first | openfast_out | interface/public_cases.py::test_openfast_heads interface/record_files.py::test_files_of_others |
| first | german_excel_csv | interface/public_cases.py::test_tables_of_spreadsheets |
| first | powershell_utf16 | interface/public_cases.py::test_tables_of_spreadsheets |
| first | unicode_units | interface/public_cases.py::test_pasted_units_and_numbers |
| first | locale_comma | unit/app_case/units_test.cpp interface/python_package.py::test_numbers_are_those_of_a_point |
| first | fmu_glibc | interface/fmu_library.py::test_floor_of_the_c_library |
| second | zf_8hp_coupled_sets | interface/public_cases_second.py::CoupledSets interface/planet_bearing_inputs.py::Sets |
| second | pgs_stepped_and_wolfrom | interface/public_cases_second.py::test_two_gears_on_each_planet interface/gears_and_pins.py::test_what_cannot_be_stated_is_said_in_one_line |
| second | rblo_planet_speed | interface/public_cases_second.py::test_life_by_a_record_is_that_of_the_point |
| second | bearinx_two_stage_1_6 | interface/rexs_public_cases.py::test_two_stages_with_a_load_spectrum |
| second | rexs_external_database | interface/rexs_public_cases.py::Beside |
| second | rexs_planetary_power_1_4 | interface/rexs_public_cases.py::test_power_in_place_of_torque |
| second | rexs_wrong_contents | interface/rexs_public_cases.py::Refused |
| second | nke_fit_table | interface/public_cases_second.py::test_worked_rows_of_a_table_of_fits unit/bearing/seat_class_test.cpp::AgreesWithAPrintedTableOfFits |
| second | helical_shift_x_mn | interface/public_cases_second.py::test_a_helical_pair_with_a_normal_shift interface/gears_and_pins.py::test_a_wheel_has_a_bore_of_its_own |
| second | foreign_series_files | interface/record_files.py::test_files_of_other_programs_are_named interface/record_files.py::test_bladed_as_text_and_binary |
| second | eritenel_parker_3d | interface/gears_and_pins.py::test_what_cannot_be_stated_is_said_in_one_line interface/public_cases_second.py::test_helical_modes_in_the_plane |
| second | one_pin_off_pattern | interface/public_cases_second.py::test_one_pin_off |
| second | across_over_along | interface/public_cases_second.py::test_across_over_along identities/bearing_stiffness_test.cpp::AcrossOverAlongIsThatOfTheSum |
| second | nsk_tapered_pair_example5 | interface/public_cases_second.py::test_a_tapered_bearing_alone literature/tapered_ratings_test.cpp |
| second | ukf_k50_pair | interface/public_cases_second.py::test_factors_of_one_row |
| second | skf_example5_kappa | interface/public_cases_second.py::test_viscosity_ratio |
| second | fmu_late_start | unit/fmu/fmi2_test.cpp::ALateStartIsTheSameRun interface/fmu_fmpy.py::test_no_problem_is_found |
| examined | flexpin | interface/gears_and_pins.py::test_a_flexpin_carries_any_number_of_bearings |
| examined | carrier_own | interface/gears_and_pins.py::test_the_shaft_of_the_sun_loads_one_end_of_its_teeth interface/gears_and_pins.py::test_planets_and_sun_that_slide_have_no_axial_frequency |
| examined | rexs (6207, 6308) | interface/rexs_public_cases.py::test_gears_of_version_1_0_are_where_they_are_in_space interface/rexs_read_back.py::Places |
| examined | drag_slip | interface/light_loads.py::test_rolling_resistance_carries_rollers_along |
| examined | needle_slow | interface/light_loads.py::test_needles_of_a_slow_set |
| examined | ac_own | interface/static_bearing.py::test_formulas_of_the_page |
| examined | spherical_own, sph_pair | unit/life/rating_lives_test.cpp::LaminaOfTwoRowsStandsForTheLoadOfBoth interface/planet_bearing_types.py::test_standard_lives |
| examined | nu210 | interface/static_bearing.py::test_friction_does_not_depend_on_the_position |
| examined | pair_own | interface/gears_and_pins.py::test_teeth_of_paired_planets_warn_as_others |
| examined | stepped_own | interface/gears_and_pins.py::test_two_gears_on_each_planet_run |
| examined | tapered_own | interface/planet_bearing_types.py::test_standard_lives |
| examined | ball_own, ball6210 | interface/planet_bearing_types.py::test_balls interface/lives_by_hand.py::test_6208 |
| examined | cyl_own, unc_own | interface/governing_life.py::test_uncertainty |
| examined | internal | interface/public_cases.py::test_pair_with_an_internal_gear |
| examined | scratch_own | interface/planet_scratch.py::PlanetScratch |
| examined | two_sets | interface/multi_stage.py::test_power_flow_balances_in_every_set_and_shaft |
| new users | wind5_caged, wind5_full | interface/planet_bearing_inputs.py::test_a_full_complement_has_its_own_ratings |
| new users | mine, mineclr, eaxle, wind | interface/planet_bearing_inputs.py::test_a_thin_rim_is_a_result_a_warning_and_a_status interface/varied_without_effect.py |
| new users | eaxle_a | interface/true_output.py::test_a_band_that_is_open_is_told |
| new users | b6309 | interface/planet_bearing_inputs.py::PUMP |
| new users | hand16281 | interface/one_life.py::Standard |
"""

import json
import math
import unittest

from program import CASES, REDUCER, WIND, InFolder, answer, package, run, settings, warned

orbearing = package()

FVA = """name: fva_planetary
source: a planetary stage that gearbox programs exchange
model: planetary-drivetrain
input: {member: sun, power: 250 kW, speed: 1500 rpm}
gearset:
  planets: 3
  teeth: {sun: 17, planet: 22, ring: 61}
  module: 4 mm
  profile_shift: {sun: 0, ring: 0}
  face_width: 50 mm
"""
TWO_BEARINGS = """bearing:
  type: cylindrical-roller
  per_planet: 2
  complement: full
  rings: none
  roller_diameter: 8 mm
  roller_length: 14 mm
  pitch_diameter: 42 mm
  width: 20 mm
  radial_clearance: 30 um
"""
STAGES_10MW = """name: stages_10mw
source: public model of a 10 MW wind turbine gearbox
model: planetary-drivetrain
input: {power: 10 MW, speed: 9.6 rpm}
shafts:
  rotor: [motor, one.carrier]
  middle: [one.sun, two.carrier]
  out: [two.sun, load]
  housing: [ground, one.ring, two.ring]
sets:
  one:
    gearset: {planets: 5, teeth: {sun: 26, planet: 31, ring: 89}, module: 30 mm, helix_angle: 8 deg, profile_shift: {sun: 0.2702, ring: 0.1591}, face_width: 800 mm, addendum: ADDENDUM}
  two:
    gearset: {planets: 3, teeth: {sun: 26, planet: 41, ring: 109}, module: 20 mm, helix_angle: 8 deg, profile_shift: {sun: 0.2787, ring: 0.0024}, face_width: 520 mm}
parallel_stage: {behind: [61, 28]}
"""
STAGE_10MW = """name: stage_10mw
source: public model of a 10 MW wind turbine gearbox, first stage
model: planetary-drivetrain
input: {member: carrier, power: 10 MW, speed: 9.6 rpm}
gearset: {planets: 5, teeth: {sun: 26, planet: 31, ring: 89}, module: 30 mm, helix_angle: 8 deg, profile_shift: {sun: 0.2702, ring: 0.1591}, face_width: 800 mm}
bearing:
  type: cylindrical-roller
  per_planet: 2
  complement: full
  roller_diameter: 55 mm
  roller_length: 110 mm
  pitch_diameter: 500 mm
  radial_clearance: 150 um
  bore: 400 mm
  outside_diameter: 600 mm
  width: 272 mm
"""
THIRD_10MW = """name: third_10mw
source: public model of a 10 MW wind turbine gearbox, third stage
model: gear-pair
pair: {teeth: [61, 28], module: 18 mm, helix_angle: 12 deg, profile_shift: [0.1024, 0.2976], face_width: 500 mm, bore: 200 mm}
"""
FOUR_PLANETS = FVA.replace("planets: 3", "planets: 4").replace("250 kW", "50 kW")
PLANET_5MW = """name: planet_5mw
source: public model of a 5 MW gearbox, planet bearing of 5500 kN
model: roller-bearing
load: {radial: 762.07 kN}
bearing:
  type: cylindrical-roller
  rollers: 26
  roller_diameter: 55 mm
  roller_length: 110 mm
  pitch_diameter: 500 mm
  radial_clearance: 0 um
  laminae: 30
  profile: {kind: straight}
  dynamic_capacity: 5500 kN
operation: {turning_race: outer, outer_speed: 39.859 rpm}
"""
CATALOGUE_SPECTRUM = """name: catalogue_spectrum
source: "a maker's general catalogue, life under varying load"
model: roller-bearing
load: {radial: 200 kN}
bearing:
  type: cylindrical-roller
  rollers: 15
  roller_diameter: 34 mm
  roller_length: 34 mm
  pitch_diameter: 175 mm
  radial_clearance: 0 um
  laminae: 30
  profile: {kind: johns-gohar}
  dynamic_capacity: 540 kN
  fatigue_load_limit: 81.5 kN
life: {viscosity_ratio: 1, contamination_factor: 0.8}
"""
FULL = """name: full_complement
source: elementary geometry
model: roller-bearing
load: {radial: 1 kN}
bearing: {type: cylindrical-roller, complement: full, roller_diameter: 10 mm, roller_length: 10 mm, pitch_diameter: 30 mm, radial_clearance: 0 um}
"""
BALLS_6010 = """name: balls_6010
source: a ball bearing of a multibody program's tests
model: ball-bearing
load: {radial: 0 N, axial: 200 N}
bearing: {balls: 14, ball_diameter: 8.73 mm, pitch_diameter: 65 mm, inner_osculation: 0.625, outer_osculation: 0.625, radial_clearance: 0 um}
"""


class PublicCases(InFolder):
    def near(self, value, right, tolerance):
        self.assertLessEqual(abs(value / right - 1.0), tolerance, (value, right))

    def rows(self, text, *values):
        """Inputs and derived values of `check` by their paths."""
        checked = answer("check", self.case(text), *values)
        return {row["path"]: row["value"] for row in checked["inputs"] + checked["derived"]}, checked

    def refusal(self, text, *values, command="check"):
        result = run(command, self.case(text), *settings(values))
        self.assertEqual(result.returncode, 2, result.stdout)
        return result.stderr


class Table(unittest.TestCase):
    def test_each_case_names_tests_that_exist(self):
        tests, rows = CASES.parent / "tests", [line.strip("| ").split(" | ") for line in __doc__.splitlines() if line.startswith("| ")][1:]
        self.assertEqual([sum(row[0] == one for row in rows) for one in ("first", "second")], [23, 17])
        for _, case, held in rows:
            for test in held.split():
                file, _, name = test.partition("::")
                self.assertIn(name, (tests / file).read_text(encoding="utf-8"), case)


class Gears(PublicCases):
    def test_planetary_stage_of_17_22_61_teeth(self):
        """rexs_fva_planetary: kinematics, torque, contact ratios, phases and the load of each of two bearings."""
        rows, checked = self.rows(FVA)
        self.near(rows["gearset.centre_distance"], 78.0, 1e-6)
        self.near(rows["operation.carrier_speed"], 326.923, 1e-5)
        self.near(-rows["operation.planet_speed"], 906.469, 1e-5)
        torques = {row["member"]: row["torque_N_m"] for row in checked["power_flow"]}
        self.near(torques["sun"], 1591.549, 1e-5)
        self.near(-torques["carrier"], 7302.4, 1e-5)
        self.near(17 * (1500.0 - rows["operation.carrier_speed"]) / 60.0, 332.372, 1e-5)
        meshes = answer("mesh", self.case(FVA), "gearset.root_fillet_radius=0")["meshes"]
        self.near(meshes[0]["contact_ratio"], 1.54775, 1e-4)
        self.near(meshes[3]["contact_ratio"], 1.95716, 1e-4)
        for planet in range(3):
            self.assertAlmostEqual(meshes[planet]["phase"], (0, 2 / 3, 1 / 3)[planet], 12)
        # The fillet of the default tool ends the ring's path of contact earlier, and a warning says so.
        hobbed = answer("mesh", self.case(FVA))
        self.near(hobbed["meshes"][3]["contact_ratio"], 1.78072, 1e-4)
        self.assertTrue(warned(hobbed, "root fillet"))
        load = answer("run", self.case(FVA + TWO_BEARINGS), options=("--fidelity", "quasi-static"))["points"][0]["tangential_load_N"]
        self.near(load, 15603.4, 1e-3)

    def test_first_stage_of_10_MW(self):
        """dtu10_stage1; the ring's shift of DIN's sign is refused or warned of in tests/unit/app_case/consistency_test.cpp."""
        rows, checked = self.rows(STAGE_10MW)
        self.assertAlmostEqual(rows["gearset.centre_distance"], 877.033, delta=0.005)
        self.near(rows["gearset.sun_mesh.contact_ratio"], 1.5266, 2e-4)
        self.near(rows["gearset.overlap_ratio"], 1.1813, 2e-4)
        self.near(-rows["operation.bore_load_y"], 1134.19e3, 1e-3)
        self.near(next(row["torque_N_m"] for row in checked["power_flow"] if row["member"] == "carrier"), 9.94718e6, 1e-3)
        meshes = answer("mesh", self.case(STAGE_10MW), "gearset.addendum=0.9748")["meshes"]
        self.near(meshes[0]["contact_ratio"], 1.4929, 2e-4)
        steps = [(meshes[i + 1]["phase"] - meshes[i]["phase"]) % 1.0 for i in range(4)]
        for step in steps:
            self.assertAlmostEqual(min(abs(step - 0.2), abs(step - 0.8)), 0.0, 9)
        self.assertTrue(warned(answer("check", self.case(STAGE_10MW), "gearset.profile_shift.ring=-0.1591"), "opposite sign"))

    def test_three_stages_of_10_MW(self):
        """dtu10_whole: ratios, and the geometry of sets that have no bearing."""
        rows, checked = self.rows(STAGES_10MW.replace("ADDENDUM", "0.9748"))
        speed = {row["shaft"]: abs(row["speed_rpm"]) for row in checked["power_flow"]}
        for shaft, before, ratio in (("middle", "rotor", 4.42308), ("out", "middle", 5.19231), ("behind", "out", 2.17857), ("behind", "rotor", 50.033)):
            self.near(speed[shaft] / speed[before], ratio, 1e-4)
        self.assertAlmostEqual(rows["sets.one.gearset.centre_distance"], 877.033, delta=0.005)
        self.near(rows["sets.one.gearset.sun_mesh.contact_ratio"], 1.4929, 2e-4)
        for name, right in (("centre_distance", 684.2731), ("sun_mesh.contact_ratio", 1.56381), ("overlap_ratio", 1.1518)):
            self.near(rows["sets.two.gearset." + name], right, 1e-4)
        carrier = next(row["torque_N_m"] for row in checked["power_flow"] if (row["set"], row["member"]) == ("two", "carrier"))
        self.near(carrier / (3 * 1e-3 * rows["sets.two.gearset.centre_distance"]), 1095.53e3, 1e-4)
        third, _ = self.rows(THIRD_10MW)
        self.near(third["pair.centre_distance"], 825.8853, 1e-4)

    def test_wind_stage_of_750_kW(self):
        """grc_profile_shifts and grc_loads; contact ratios are rows of cases/wind_stage_750kW/expected.yaml."""
        checked = answer("check", WIND)
        rows = {row["path"]: row["value"] for row in checked["inputs"] + checked["derived"]}
        self.near(rows["gearset.centre_distance"], 308.0, 1e-5)
        for gear, right in (("sun", 0.1763), ("planet", 0.3987), ("ring", 0.9737)):
            self.assertAlmostEqual(rows["gearset.profile_shift." + gear], right, delta=0.005)
        brief = ("bearing.tilt_state=stated", "bearing.laminae=1", "bearing.profile={kind: straight}", "input.speed=22.1 rpm")
        for torque, load in ((325, 175.87), (344.1, 186.20), (360, 194.81), (401, 216.99)):
            point = answer("run", WIND, f"input.torque={torque} kN.m", *brief)["points"][0]
            self.near(-point["tangential_load_N"], 1e3 * load, 0.003)
        flow = answer("check", WIND, "input.speed=22.1 rpm")
        self.near(next(row["speed_rpm"] for row in flow["power_flow"] if row["member"] == "sun"), 126.29, 1e-4)
        self.near(-next(row["value"] for row in flow["derived"] if row["path"] == "operation.planet_speed"), 56.1, 1e-4)

    def test_gearbox_of_750_kW(self):
        """grc_chain with grc_loads: 82/23 and 88/22 behind 21/39/99, from the rotor to the generator."""
        stages = "parallel_stage.behind=[[82, 23], [88, 22]]"
        checked = answer("check", WIND, stages, "input.speed=22.1 rpm")
        rows = {(row["set"], row["member"]): row for row in checked["power_flow"]}
        derived = {row["path"]: row["value"] for row in checked["derived"]}
        self.near(rows["behind_2", "second"]["speed_rpm"], 1800.9, 1e-4)
        self.near(derived["operation.load_speed"], 1800.9, 1e-4)
        self.near(derived["operation.overall_ratio"], 81.491, 1e-5)
        sun = 22.1 * 120 / 21
        for member, right in ((("gearset", "sun"), sun), (("behind_1", "first"), sun), (("behind_1", "second"), -sun * 82 / 23),
                              (("behind_2", "first"), -sun * 82 / 23), (("behind_2", "second"), sun * 82 * 4 / 23)):
            self.near(rows[member]["speed_rpm"], right, 1e-12)
        power = {name: sum(rows[name, member]["power_W"] for member in members)
                 for name, members in (("gearset", ("sun", "ring", "carrier")), ("behind_1", ("first", "second")), ("behind_2", ("first", "second")))}
        entering = rows["gearset", "carrier"]["power_W"]
        for name, sum_of_set in power.items():
            self.assertLess(abs(sum_of_set), 1e-9 * entering, name)
        self.near(-rows["behind_2", "second"]["power_W"], entering, 1e-12)
        self.near(-rows["behind_2", "second"]["torque_N_m"], rows["gearset", "carrier"]["torque_N_m"] / 81.4907, 1e-5)
        brief = ("bearing.tilt_state=stated", "bearing.laminae=1", "bearing.profile={kind: straight}", "input.speed=22.1 rpm")
        for torque, load in ((325, 175.87), (344.1, 186.20), (360, 194.81), (401, 216.99)):
            point = answer("run", WIND, f"input.torque={torque} kN.m", stages, *brief)["points"][0]
            self.near(-point["tangential_load_N"], 1e3 * load, 0.003)
        # The generator's speed in place of the rotor's.
        by_load = answer("check", WIND, stages, "input.speed_of=load", f"input.speed={22.1 * 120 / 21 * 82 / 23 * 4!r} rpm")
        self.near(next(row["value"] for row in by_load["derived"] if row["path"] == "operation.motor_speed"), 22.1, 1e-12)
        self.assertIn("'7216' is out of range", run("check", WIND, "--set", "parallel_stage.behind=[7216, 506]").stderr)

    def test_one_stage_in_a_list_is_that_stage(self):
        """To the byte, in what is resolved as well."""
        for side in ("front", "behind"):
            for command in (("check",), ("run", "--fidelity", "quasi-static")):
                one, listed = (run(*command, WIND, "--json", "--set", f"parallel_stage.{side}={value}") for value in ("[82, 23]", "[[82, 23]]"))
                self.assertEqual((one.returncode, one.stdout), (0, listed.stdout))

    def test_order_of_stages_changes_no_ratio(self):
        def ratio(*stages):
            return next(row["value"] for row in answer("check", WIND, *stages)["derived"] if row["path"] == "operation.overall_ratio")

        right = ratio("parallel_stage.behind=[[82, 23], [88, 22], [30, 31]]")
        for stages in (("parallel_stage.behind=[[30, 31], [88, 22], [82, 23]]",), ("parallel_stage.front=[[88, 22], [30, 31]]", "parallel_stage.behind=[82, 23]")):
            self.near(ratio(*stages), right, 1e-12)

    def test_four_planets_that_do_not_stand_at_right_angles(self):
        """nearly_equal_planets."""
        angles = "gearset.planet_angles=[0 deg, 92.3077 deg, 180 deg, 272.3077 deg]"
        rows, _ = self.rows(FOUR_PLANETS, angles)
        self.assertAlmostEqual(rows["gearset.planet_angle.least"], 87.6923, 4)
        self.assertAlmostEqual(rows["gearset.planet_angle.most"], 92.3077, 4)
        self.assertNotIn("gearset.planet_angle", rows)
        # 17 x 180/360 = 8.5 teeth: opposed planets are half a period apart.
        phases = [mesh["phase"] for mesh in answer("mesh", self.case(FOUR_PLANETS), angles)["meshes"]]
        for one, other in ((0, 2), (1, 3)):
            self.assertAlmostEqual(abs(phases[one] - phases[other]), 0.5, 9)
        self.assertIn("87.6923 deg or 92.3077 deg", self.refusal(FOUR_PLANETS, "gearset.planet_angles=[0 deg, 90 deg, 180 deg, 270 deg]"))
        self.assertIn("[0.0000 deg, 92.3077 deg, 180.0000 deg, 272.3077 deg] are nearest to equal steps", self.refusal(FOUR_PLANETS))

    def test_pair_with_an_internal_gear(self):
        """internal_pair_KHK; base circles in tests/unit/mesh/internal_pair_test.cpp."""
        pair = CASES / "mesh_62_62" / "case.yaml"
        self.assertIn("of a gear inside a ring, state pair.kind: internal", run("check", pair, "--set", "pair.teeth=[16, -24]").stderr)
        internal = ("pair.kind=internal", "pair.teeth=[16, 24]", "pair.module=3 mm", "pair.profile_shift=[0, 0.5]", "pair.bore=20 mm")
        rows = {row["path"]: row["value"] for row in answer("check", pair, *internal)["derived"]}
        self.near(rows["pair.working_pressure_angle"], 31.0938, 1e-4)
        self.near(rows["pair.centre_distance"], 13.1683, 1e-4)
        (mesh,) = answer("mesh", pair, *internal)["meshes"]
        self.near(mesh["contact_ratio"], rows["pair.contact_ratio"], 1e-12)
        self.assertGreater(mesh["min_N_per_m"], 0.0)


class Bearings(PublicCases):
    def test_planet_bearing_by_the_makers_rating(self):
        """planet_bearing_catalogue_C."""
        found = answer("run", self.case(PLANET_5MW))
        self.near(found["L10_Mrev"], 726.5, 0.002)
        self.near(found["L10h"], 303776, 0.002)

    def test_spectrum_of_a_catalogue(self):
        """skf_example5_spectrum: L10h of each load, and Miner's sum."""
        damage = 0.0
        for share, load, speed, right in ((0.05, 200, 50, 9136), (0.40, 125, 300, 7295), (0.45, 75, 400, 30030), (0.10, 50, 200, 232040)):
            life = answer("run", self.case(CATALOGUE_SPECTRUM), f"load.radial={load} kN", f"operation.shaft_speed={speed} rpm")["L10h"]
            self.near(life, right, 0.003)
            damage += share / life
        self.near(1.0 / damage, 13206, 0.002)

    def test_rating_for_a_required_life(self):
        """ntn_examples_3_4: 200 kN at 450 rpm for 20000 h."""
        needed = 200.0 * (20000 * 450 * 60 / 1e6) ** (3 / 10)
        self.near(needed, 1320.5, 0.003)
        found = answer("run", self.case(CATALOGUE_SPECTRUM), "load.radial=200 kN", "operation.shaft_speed=450 rpm", f"bearing.dynamic_capacity={needed!r} kN",
                       "requirements={life: 19999 h, life_key: L10h}")
        self.near(found["L10h"], 20000, 1e-9)
        self.assertEqual([row["passed"] for row in found["verdicts"]], [True])

    def test_as_many_rollers_as_touch(self):
        """iko_full_complement: pitch diameter over roller diameter is 1/sin(pi/Z)."""
        for rollers, ratio in ((6, 2.0), (7, 2.30476), (8, 2.61313), (9, 2.9238), (10, 3.23607), (12, 3.8637), (15, 4.80973), (18, 5.75877)):
            self.near(1.0 / math.sin(math.pi / rollers), ratio, 1e-5)
            touching = 10.0 / math.sin(math.pi / rollers)
            for pitch, good in ((touching, True), (touching * (1 + 1e-5), True), (touching - 1e-3, False)):
                result = run("check", self.case(FULL), "--json", *settings([f"bearing.pitch_diameter={pitch!r} mm", f"bearing.rollers={rollers}"]))
                self.assertEqual(result.returncode, 0 if good else 2, (rollers, pitch, result.stderr))
            self.assertRegex(result.stderr, r"a roller diameter \(10 mm\) of at most their centre distance, 9\.99\d+ mm")
            rows, _ = self.rows(FULL, f"bearing.pitch_diameter={touching!r} mm")
            self.assertLessEqual(rows["bearing.rollers"], rollers)

    def test_an_out_of_round_race(self):
        """out_of_round_planet: life has a maximum where the major axis lies along the load, and falls where it lies across."""
        still = {f"inertia.{name}": False for name in ("carrier_centrifugal", "own_orbit", "coriolis")}  # the load is tangential

        def life(amplitude, phase):
            form = {"order": [2], "amplitude": [f"{amplitude} um"], "phase": [f"{phase} deg"]}
            case = orbearing.load(REDUCER, {"bearing.laminae": 1, **still, "bearing.inner_race.out_of_roundness": form})
            return case.run()["points"][0]["life_h"]

        along, across = ([life(amplitude, phase) for amplitude in (0, 0.5, 1, 2, 4)] for phase in (0, 90))
        self.assertEqual(along[0], across[0])
        self.assertEqual(across, sorted(across, reverse=True))
        best = along.index(max(along))
        self.assertTrue(0 < best < 4)
        self.assertTrue(0.15 < along[best] / along[0] - 1.0 < 0.60, along)

    def test_balls_in_grooves_that_no_bearing_has(self):
        """exudyn_6010."""
        found = answer("run", self.case(BALLS_6010))
        loads = found["contact_loads_N"]
        angle = math.asin(200.0 / (14 * loads[0]))
        self.assertLess(max(loads) - min(loads), 1e-6 * loads[0])
        self.assertAlmostEqual(math.degrees(angle), 5.263, delta=1e-3)
        self.assertLess(abs(found["moment_N_m"]), 1e-6)
        self.assertGreater(found["displacement"]["axial_um"], 0.0)
        self.assertTrue(warned(found, "0.625 and 0.625; the factors X and Y of ISO 281 hold for at most 0.52 and 0.53"), found["warnings"])
        ours = answer("run", CASES / "ball_6305_iso16281")
        self.assertFalse(warned(ours, "osculation"))


class Units(PublicCases):
    def test_pasted_units_and_numbers(self):
        """unicode_units: the plain meaning, or a refusal that names what is wrong."""
        taken = {"gearset.module=4\u00a0mm": 4e-3, "gearset.module=4\u202fmm": 4e-3, "bearing.radial_clearance=60 \u00b5m": 6e-5,
                 "bearing.radial_clearance=60 \u03bcm": 6e-5, "bearing.radial_clearance=60 mum": 6e-5, "input.speed=1500 1/min": 50 * math.pi,
                 "input.speed=1500 min\u207b\u00b9": 50 * math.pi, "gearset.helix_angle=7.5\u00b0": math.radians(7.5), "gearset.helix_angle=-0.0 deg": 0.0,
                 "lubricant.temperature=80 C": 80.0}
        for text, value in taken.items():
            case = orbearing.load(WIND if "helix" in text or "lubricant" in text else REDUCER, dict([text.split("=")]))
            self.assertAlmostEqual(case[text.split("=")[0]], value, delta=1e-12 * max(1.0, abs(value)), msg=text)
        refused = {"gearset.helix_angle=\u22127.5 deg": "U+2212", "gearset.helix_angle=7\u00b030'": "its unit '\u00b030'' is not known",
                   "load.radial=1 kN-m": "its unit 'kN-m' does not measure the same as 'N'", "gearset.module=4,0 mm": "no commas",
                   "input.power=1.250,5 kW": "no commas"}
        for text, said in refused.items():
            with self.assertRaises(orbearing.CaseError) as raised:
                orbearing.load(CASES / "harris_209" if text.startswith("load") else WIND if "helix" in text else REDUCER, dict([text.split("=")]))
            self.assertIn(said, str(raised.exception))

    def test_openfast_heads(self):
        """openfast_out: kN-m is never read as N m; without columns the heads are listed."""
        file = self.folder / "like.csv"
        file.write_text("Time_[s],RotSpeed_[rpm],RotTorq_[kN-m],GenPwr_[kW]\n" + "".join(f"{0.05 * i},12.1,3946,4720\n" for i in range(4)), encoding="utf-8")
        said = run("spectrum", file, "--json")
        self.assertEqual(said.returncode, 2)
        self.assertIn("among the columns Time_[s], RotSpeed_[rpm], RotTorq_[kN-m], GenPwr_[kW]", said.stderr)
        found = run("spectrum", file, "--json", "--torque", "RotTorq", "--speed", "RotSpeed")
        (one,) = json.loads(found.stdout)["bins"]
        self.near(one["torque_N_m"], 3946e3, 1e-9)
        self.near(one["speed_rpm"], 12.1, 1e-9)

    def test_tables_of_spreadsheets(self):
        """german_excel_csv, powershell_utf16: 1500,5 never becomes 1500."""
        rows = [(f"{i}", "1500.5", f"{1591.25 + i}") for i in range(5)]

        def text(separator, comma, quote=""):
            lines = ["time_s,speed_rpm,torque_N_m".replace(",", separator)]
            lines += [separator.join(quote + (cell.replace(".", ",") if comma else cell) + quote for cell in row) for row in rows]
            return "\r\n".join(lines) + "\r\n"

        plain = text(",", False)
        written = {"semicolons": ("\ufeff" + text(";", True)).encode("utf-8"), "quotes": text(",", True, '"').encode("utf-8"), "utf16": plain.encode("utf-16"),
                   "latin1": plain.replace("N_m\r\n", "N_m,f\u00fcr\r\n", 1).replace("5\r\n", "5,x\r\n").encode("latin-1"), "split": text(",", True).encode("utf-8")}
        for name, content in written.items():
            file = self.folder / f"{name}.csv"
            file.write_bytes(content)
            result = run("spectrum", file, "--json")
            if name == "split":  # a decimal comma between commas: two readings
                self.assertEqual(result.returncode, 2)
                self.assertRegex(result.stderr, r"split\.csv:2:\d+: .*decimal comma")
                continue
            self.assertEqual(result.returncode, 0, result.stderr)
            for one in json.loads(result.stdout)["bins"]:
                self.near(one["speed_rpm"], 1500.5, 1e-12)
                self.assertTrue(1591.25 <= one["torque_N_m"] <= 1595.25, one)


if __name__ == "__main__":
    unittest.main()
