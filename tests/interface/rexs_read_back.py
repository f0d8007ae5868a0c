#!/usr/bin/env python3
"""`orbearing convert`: each branch of the reader of REXS with a file of its own, in which no two values are equal, and each value read back.

The values of the cases are written here by hand, from the format's definitions and elementary geometry; the models are those of file_units.py.
"""

import math
import pathlib
import tempfile
import unittest

import program
import rexs_files
from file_units import gearbox, of_clearance, of_load_cases, stage, stated_bearings, warm_load_cases, with_attributes, without

orbearing = program.package()

from orbearing.errors import CaseError  # noqa: E402
from orbearing.rexs import convert, names, reading, results  # noqa: E402
from orbearing.rexs.model import Attribute, Component  # noqa: E402

STAGE, BEARING = "planetenstufe_9", rexs_files.BEARING
RPM, DEGREE = math.pi / 30.0, math.pi / 180.0


# Components of the format that have attributes which are read.
COMPONENTS = {"concept_bearing", "coupling", "cutter_wheel_tool", "cylindrical_gear", "cylindrical_gear_flank", "cylindrical_stage", "external_load",
              "flank_geometry", "gear_casing", "gear_unit", "lubricant", "material", "planet_carrier", "rack_shaped_tool", "ring_gear",
              "rolling_bearing_row", "rolling_bearing_with_catalog_geometry", "rolling_bearing_with_detailed_geometry", "rolling_element", "shaft",
              "shaft_section"}


class Names(unittest.TestCase):
    def test_each_attribute_has_a_unit_and_components_of_the_format(self):
        for name, known in names.KNOWN.items():
            self.assertIsNotNone(names.unit_of(known.unit), name)
            self.assertEqual((set(known.components) - COMPONENTS, len(set(known.names))), (set(), len(known.names)), name)
        self.assertEqual({one for known in names.KNOWN.values() for one in known.components}, COMPONENTS)

    def test_numbers_and_counts_come_in_every_unit_of_their_quantity(self):
        count = next(name for name, known in names.KNOWN.items() if known.whole)
        for name, unit, stated, wanted in (("duration", "h", 2.0, 7200.0), ("duration", "s", 90.0, 90.0), ("load_force_u", "kN", 1.5, 1500.0),
                                           ("load_place", "mm", 40.0, 0.04), ("share", "%", 25.0, 0.25), ("oil_temperature", "C", 60.0, 60.0),
                                           ("oil_temperature", "K", 333.15, 60.0), (count, "none", 3.0, 3), (count, "%", 300.0, 3)):
            known = names.KNOWN[name]

            def read(unit, known=known, name=name, stated=stated):
                return names.number_of(Component(1, known.components[0], "", {known.names[0]: Attribute(known.names[0], unit, stated)}), name).number
            self.assertAlmostEqual(read(unit), wanted, delta=1e-9 * wanted, msg=f"{name} [{unit}]")
            self.assertIsNone(read("rad"), name)


class ReadBack(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)

    def converted(self, model, form=".rexs"):
        file = model.write(self.place / f"model{form}")
        return convert.convert(reading.read(file), file.name, reading.form_of(file.read_bytes()))

    def case(self, model, name=STAGE):
        found = self.converted(model)
        self.assertIn(name, found.cases, found.report)
        return orbearing.parse(found.cases[name], name)

    def reads(self, case, **expected):
        """Values [SI] of a case by their paths, with __ for the points."""
        for key, wanted in expected.items():
            path = key.replace("__", ".")
            found = case[path]
            if isinstance(wanted, float):
                self.assertAlmostEqual(found, wanted, delta=1e-6 * abs(wanted), msg=path)
            else:
                self.assertEqual(found, wanted, path)


def of_bearings(model, low=500, high=600):
    return [number for number, *_ in model.components if low < number < high]


class Stage(ReadBack):
    def test_everything_that_a_stage_states(self):
        case = self.case(stage())
        module, reference = 10e-3, 21 * 10e-3 / math.cos(7.5 * DEGREE)
        addendum = (0.233 - reference) / (2 * module) - 0.1763
        depth = (reference - 0.190) / (2 * module) + 0.1763
        ring_root = 99 * 10e-3 / math.cos(7.5 * DEGREE) + 2 * module * (0.9737 + 1.25)
        self.reads(case, gearset__planets=3, gearset__teeth__sun=21, gearset__teeth__planet=39, gearset__teeth__ring=99, gearset__module=module,
                   gearset__pressure_angle=20 * DEGREE, gearset__helix_angle=7.5 * DEGREE, gearset__face_width=0.220, gearset__fixed="ring",
                   gearset__centre_distance=0.308, gearset__profile_shift__sun=0.1763, gearset__profile_shift__ring=0.9737,
                   gearset__addendum=addendum, gearset__clearance=depth - addendum, gearset__sun_bore_ratio=0.090 / 0.190,
                   gearset__ring_outside_ratio=1.300 / ring_root, gearset__planet_bore_ratio=0.250 / (module * 36.5),
                   gearset__dynamics__backlash=0.3e-3, gearset__dynamics__sun__mass=110.0, gearset__dynamics__ring__mass=700.0,
                   gearset__dynamics__carrier__mass=4000.0, gearset__dynamics__carrier__support_stiffness=4e8,
                   material__youngs_modulus=206e9, material__poisson_ratio=0.3, material__density=7850.0,
                   input__member="carrier", input__power=325541.0 * 22.0 * RPM, input__speed=22.0 * RPM,
                   bearing__per_planet=2, bearing__rollers=16, bearing__roller_diameter=38e-3, bearing__roller_length=58e-3, bearing__pitch_diameter=225e-3,
                   bearing__bore=160e-3, bearing__outside_diameter=290e-3, bearing__width=80e-3, bearing__radial_clearance=60e-6,
                   bearing__dynamic_capacity=930e3, bearing__static_capacity=1200e3, bearing__fatigue_load_limit=150e3, support__pin_span=0.280,
                   life__reliability=0.95, lubricant__grade="ISO VG 320", lubricant__temperature=65.0)
        self.assertEqual(case["bearing.axial_places"], [-0.055, 0.055])

    def test_each_statement_of_the_clearance(self):
        for clearances, wanted in (({"mounted_radial_bearing_clearance": (70.0, "mum")}, 70e-6), ({"radial_bearing_clearance": (81.0, "mum")}, 81e-6),
                                   ({"minimum_radial_bearing_clearance": (50.0, "mum"), "maximum_radial_bearing_clearance": (76.0, "mum")}, 63e-6),
                                   ({"operating_radial_bearing_clearance": (42.0, "mum"), "mounted_radial_bearing_clearance": (70.0, "mum"),
                                     "radial_bearing_clearance": (81.0, "mum")}, 42e-6)):
            self.reads(self.case(of_clearance(**clearances)), bearing__radial_clearance=wanted)
        self.assertEqual(self.case(of_clearance(radial_clearance_class=("C4", "none")))["bearing.clearance_class"], "C4")
        self.assertEqual(self.case(of_clearance())["bearing.clearance_class"], "CN")

    def test_the_hottest_oil_of_the_load_cases(self):
        """50, 60 and 40 degC; the casing's own temperature counts where it is stated."""
        found = self.converted(warm_load_cases())
        self.reads(orbearing.parse(found.cases[STAGE], STAGE), lubricant__temperature=60.0)
        self.assertEqual([(entry["load_case"], entry["value"]) for entry in found.report["taken"] if entry["attribute"] == "temperature_lubricant"], [("2", 60.0)])
        self.reads(self.case(rexs_files.planetary(load_cases=True)), lubricant__temperature=65.0)

    def test_rows_of_double_row_bearings_are_counted(self):
        """By the number that the bearing states, and by the rows that the file describes; a case rates each row."""
        def narrow():
            model = rexs_files.planetary()
            for number in of_bearings(model, 2500, 2600):
                with_attributes(model, number, length_of_rolling_element=(40.0, "mm"))
            for number in of_bearings(model):
                with_attributes(model, number, width=(108.0, "mm"))
            return model

        stated, described = narrow(), narrow()
        for number in of_bearings(stated):
            with_attributes(stated, number, number_of_bearing_rows=(2, "none"))
        for number in of_bearings(described):
            row = described.add(number + 3000, "rolling_bearing_row", "", number_of_rolling_elements=16, reference_diameter=(225.0, "mm"))
            described.relate("ordered_assembly", assembly=number, part=row)
        for model in (stated, described):
            found = self.converted(model)
            case = orbearing.parse(found.cases[STAGE], STAGE)
            self.reads(case, bearing__per_planet=4, bearing__rollers=16, bearing__width=54e-3)
            self.assertNotIn("bearing.dynamic_capacity", found.cases[STAGE])
            self.assertIn("rates 2 rows together", {entry["attribute"]: entry["reason"] for entry in found.report["left_out"]
                                                    if entry["component"] == BEARING}["radial_dynamic_load_rating"])

    def test_torques_and_powers_and_their_signs(self):
        """Two loads of a shaft add up; power at a speed is a torque; what leaves by the carrier enters by the sun."""
        ratio = 1 + 99 / 21
        both = with_attributes(rexs_files.planetary(), 5, torque_around_u_axis=(200541.0, "N m"))
        both.add(8, "external_load", "Bremse", defines_torque=True, torque_around_u_axis=(125000.0, "N m"))
        both.relate("assembly", assembly=15, part=8)
        self.reads(self.case(both), input__power=325541.0 * 22.0 * RPM, input__member="carrier")
        for power, member, speed in ((600.0, "carrier", 22.0), (-600.0, "sun", 22.0 * ratio)):
            model = with_attributes(without(rexs_files.planetary(), "torque_around_u_axis"), 5, power=(power, "kW"))
            found = self.converted(model)
            self.reads(orbearing.parse(found.cases[STAGE], STAGE), input__member=member, input__power=600e3, input__speed=speed * RPM)
            figures = found.report["stages"][0]["figures"]
            torque = 1e3 * power / (22.0 * RPM)
            self.assertAlmostEqual(figures["carrier_torque_N_m"] / torque, 1.0, 9)
            self.assertAlmostEqual(figures["sun_torque_N_m"] / (-torque / ratio), 1.0, 9)
        idle = with_attributes(rexs_files.planetary(), 6, torque_around_u_axis=(999.0, "N m"), transmits_torque=(False, "none"))
        self.reads(self.case(idle), input__power=325541.0 * 22.0 * RPM)

    def test_shares_and_hours_of_load_cases(self):
        rows = self.case(of_load_cases("%", operating_time_fraction=100.0 / 6.0))["spectrum"]
        for row, power, speed, share in zip(rows, (100e3, 200e3, 300e3), (22.0, 18.0, 10.0), (1 / 6, 2 / 6, 3 / 6), strict=True):
            for key, wanted in (("power", power), ("speed", speed * RPM), ("share", share)):
                self.assertAlmostEqual(row[key] / wanted, 1.0, 9, key)
        rows = self.case(of_load_cases("h", operating_time=1000.0))["spectrum"]
        self.assertEqual([round(row["hours"] / 3600.0, 6) for row in rows], [1000.0, 2000.0, 3000.0])

    def test_the_gear_that_is_shifted(self):
        """The second of three gears holds the ring; a number that a program writes as 2.0 is 2."""
        for index, held in ((2, True), (2.0, True), (1, False), (3, False), (2.5, False)):
            model = with_attributes(with_attributes(rexs_files.planetary(), 1, gear_shift_index=(index, "none")), 7, is_engaged=([False, True, False], "none"))
            model.components = [(number, "switchable_coupling" if number == 7 else kind, name, rows) for number, kind, name, rows in model.components]
            self.assertEqual(STAGE in self.converted(model).cases, held, index)

    def test_rings_that_a_bearing_has(self):
        for inner, outer, rings in ((False, True, "outer"), (False, False, "none"), (True, True, "both")):
            model = rexs_files.planetary()
            for number in of_bearings(model):
                with_attributes(model, number, has_inner_ring=(inner, "none"), has_outer_ring=(outer, "none"))
            text = self.converted(model).cases[STAGE]
            self.assertIn(f"rings: {rings}" if rings != "both" else "rollers: 16", text)
            self.assertEqual("rings:" in text, rings != "both")

    def test_incomplete_rows_leave_the_designation(self):
        """Without number, size or pitch circle of the rolling elements there is no inside; nothing breaks."""
        for low, gone in ((1500, "number_of_rolling_elements"), (1500, "reference_diameter"), (2500, "diameter_of_rolling_element")):
            model = rexs_files.planetary()
            for number in of_bearings(model, low, low + 100):
                model.components = [(one, kind, name, [row for row in rows if one != number or row[0] != gone]) for one, kind, name, rows in model.components]
            for number in of_bearings(model):
                with_attributes(model, number, catalogue_designation=("NU 2210", "none"))
            case = self.case(without(model, "inner_diameter", "outer_diameter", "width"))
            self.reads(case, bearing__designation="NU 2210", bearing__radial_clearance=60e-6, bearing__dynamic_capacity=930e3)

    def test_what_is_said_to_be_missing(self):
        """Of a bearing without an inside what it lacks, once; not what stands for it alone. The other stage keeps its own."""
        model = rexs_files.two_stages()
        for number in of_bearings(model):
            model.relations = [one for one in model.relations if one[0] != "ordered_assembly" or ("assembly", number) not in one[1]]
        found = self.converted(model)
        missing = {}
        for entry in found.report["missing"]:
            missing.setdefault(entry["case"], []).append(entry["key"])
        first, second = STAGE, f"{STAGE}_5009"
        self.assertIn("bearing.roller_diameter", missing[first])
        self.assertEqual([key for key in missing[first] if key.startswith(("bearing.clearance_class", "lubricant", "life"))], [])
        self.assertIn("gearset.addendum", missing[first])
        self.assertIn("bearing.cage.material", missing[second])  # its dimensions follow from the rollers
        self.assertNotIn("bearing:", found.cases[first].replace("bearings", ""))
        self.assertIn("rollers: 16", found.cases[second])

    def test_ratings_of_nothing_are_none(self):
        model = rexs_files.planetary()
        for number in of_bearings(model):
            with_attributes(model, number, radial_dynamic_load_rating=(0.0, "kN"), radial_static_load_rating=(0.0, "kN"), fatigue_limit_load=(0.0, "kN"))
        found = self.converted(model)
        self.assertNotIn("dynamic_capacity", found.cases[STAGE])
        self.assertEqual(found.report["notes"], [])

    def test_why_an_attribute_is_left_out(self):
        model = with_attributes(rexs_files.planetary(), BEARING, nominal_rating_life_time_iso_281_2007=(1000.0, "h"), custom_colour=(3, "none"),
                                display_color=("red", "none"), bearing_tolerance_class=("P6", "none"), maximum_radial_bearing_clearance=(None, "mum"))
        reasons = {entry["attribute"]: entry["reason"] for entry in self.converted(model, ".rexsj").report["left_out"] if entry["component"] == BEARING}
        for attribute, reason in (("nominal_rating_life_time_iso_281_2007", "a result of another program"), ("custom_colour", "an extension of one program"),
                                  ("display_color", "describes the part, does not size it"), ("maximum_radial_bearing_clearance", "has no value"),
                                  ("bearing_tolerance_class", "no key of a case takes this attribute of this type of component"),
                                  ("u_coordinate_on_shaft_inner_side", "place along a shaft that no key of a case needs")):
            self.assertEqual(reasons[attribute], reason)

    def test_whole_numbers_are_whole(self):
        """Rounded within a millionth, left out with the reason beyond."""
        def changed(value, number_of):
            model = rexs_files.planetary()
            model.components = [(number, kind, name, [(key, value if key == number_of and (number_of != "number_of_teeth" or 20 < number < 30) else old, unit)
                                                      for key, old, unit in rows]) for number, kind, name, rows in model.components]
            return self.converted(model, ".rexsj")

        found = changed(15.9999999999, "number_of_rolling_elements")
        self.reads(orbearing.parse(found.cases[STAGE], STAGE), bearing__rollers=16)
        self.reads(orbearing.parse(changed(38.9999999999, "number_of_teeth").cases[STAGE], STAGE), gearset__teeth__planet=39)
        for value, attribute, component in ((16.7, "number_of_rolling_elements", BEARING + 1000), (39.6, "number_of_teeth", rexs_files.PLANET)):
            found = changed(value, attribute)
            self.assertNotIn(str(int(value)) + "\n", found.cases.get(STAGE, ""), attribute)
            self.assertIn(f"found {value}; a whole number is required", {(entry["component"], entry["attribute"]): entry["reason"]
                                                                          for entry in found.report["left_out"]}[component, attribute])
            self.assertTrue(any(f"{attribute} {value}: found {value}; a whole number is required" in note for note in found.report["notes"]), found.report["notes"])


class Bearings(ReadBack):
    def test_a_ball_bearing_that_states_its_inside_its_forces_and_its_speeds(self):
        case = self.case(stated_bearings(), "6205_lager_30")
        self.reads(case, load__radial=5e3, load__axial=1.5e3, operation__shaft_speed=900.0 * RPM, operation__outer_speed=-30.0 * RPM, bearing__balls=9,
                   bearing__ball_diameter=7.94e-3, bearing__pitch_diameter=39e-3, bearing__contact_angle=15 * DEGREE, bearing__inner_osculation=4.09 / 7.94,
                   bearing__outer_osculation=4.17 / 7.94, bearing__radial_clearance=12e-6)
        outer_alone = without(stated_bearings(), "speed_inner_ring", "rotational_speed")
        self.reads(self.case(outer_alone, "6205_lager_30"), operation__outer_speed=30.0 * RPM)  # a case counts the first as positive
        still = with_attributes(stated_bearings(), 30, speed_inner_ring=(0.0, "1 / min"))
        self.reads(self.case(still, "6205_lager_30"), operation__outer_speed=30.0 * RPM)  # of those that rotate

    def test_a_bearing_between_two_shafts_loads_each_at_its_own_place(self):
        """The first shaft ends in the bore of another that begins at 60 mm of it; bearings in the casing hold that one at 40 and 140 mm of its own."""
        model = rexs_files.gearbox()
        model.add(50, "shaft", "Outer", support_vector=([60.0, 0.0, 0.0], "mm"))
        with_attributes(model, 31, u_coordinate_on_shaft_outer_side=(20.0, "mm"))
        model.relations = [(kind, [(role, 50 if role == "outer_part" and ("assembly", 31) in roles else part) for role, part in roles])
                           for kind, roles in model.relations]
        for number, place in ((60, 40.0), (61, 140.0)):
            model.add(number, "rolling_bearing_with_catalog_geometry", f"{number}", catalogue_designation="6205",
                      bearing_type="radial_grooved_ball_bearing", u_coordinate_on_shaft_inner_side=(place, "mm"))
            model.relate("side", assembly=number, inner_part=50, outer_part=rexs_files.CASING)
        found = {entry["component"]: entry["figures"].get("radial_force_N") for entry in self.converted(model).report["bearings"]}
        force = 50.0 / 0.02 / math.cos(math.radians(20.0))  # of the teeth, in the middle of both bearings of the first shaft
        for number, share in ((30, 0.5), (31, 0.5), (60, 0.5 * 120.0 / 100.0), (61, 0.5 * 20.0 / 100.0)):
            self.assertAlmostEqual(found[number] / (share * force), 1.0, 9, number)

    def test_rollers_that_were_not_cut_into_laminae_have_no_loads_of_them(self):
        class Resolved:
            def value(self, path):
                return {"bearing.rollers": 16.0}[path]

            def model(self):
                return "planetary-drivetrain"

        arrays = {"angle": [0.0], "lamina_place": [0.0], "inner_lamina_load": [[1.0]]}
        self.assertIsNone(results._lamina_loads(results.Run(pathlib.Path("run"), STAGE, {}, arrays, Resolved())))

    def test_a_clearance_of_balls_is_a_number(self):
        """A class of clearance is that of a designation: without one the case is incomplete, and says what is missing."""
        found = self.converted(without(stated_bearings(), "operating_radial_bearing_clearance"))
        entry = found.report["bearings"][0]
        self.assertEqual((entry["case"], entry["incomplete"]), (None, "incomplete/6205_lager_30.yaml"))
        self.assertIn("bearing.radial_clearance: missing", entry["problems"][0])

    def test_a_gear_pair(self):
        case = self.case(gearbox(), "stage")
        self.assertEqual((case["pair.teeth"], case["pair.profile_shift"]), ([20, 40], [0.0, 0.0]))
        self.reads(case, pair__module=2e-3, pair__helix_angle=12 * DEGREE, pair__pressure_angle=20 * DEGREE, pair__face_width=20e-3, pair__bore=25e-3)

    def test_helix_and_pressure_angle_of_one_gear_or_of_none(self):
        """The mate is of the opposite hand; the force of a pair of 25 degrees; straight teeth where no helix angle is stated."""
        for attribute, helix in ((-12.0, 12.0), (None, 0.0)):
            model = without(rexs_files.gearbox(), "helix_angle_reference_diameter", "center_distance")
            if attribute is not None:
                with_attributes(model, 8, helix_angle_reference_diameter=(attribute, "deg"))
            self.reads(self.case(model, "stage"), pair__helix_angle=helix * DEGREE)
        steep = rexs_files.gearbox()
        for side in (71, 72, 81, 82):
            with_attributes(steep, side, normal_pressure_angle=(25.0, "deg"))
        self.reads(self.case(steep, "6205_lager_31"), load__radial=50.0 / 0.02 / math.cos(25.0 * DEGREE) / 2)

    def test_the_bore_of_a_pair_that_states_none(self):
        """Half the root diameter of the smaller gear."""
        model = without(rexs_files.gearbox(), "outer_diameter_begin", "center_distance")
        for side in (71, 72):
            with_attributes(model, side, addendum_modification_coefficient=(0.2, "none"))
        self.reads(self.case(model, "stage"), pair__bore=0.5 * (40e-3 + 2 * 2e-3 * (0.2 - 1.25)))

    def test_forces_and_lives_under_several_load_cases(self):
        """A case for each; together by the rule of Palmgren and Miner, with forces of each by statics."""
        model = without(rexs_files.gearbox(), "torque_around_u_axis", "rotational_speed")
        loads = ((1, 20.0, 50.0, 1000.0), (2, 70.0, 30.0, 1500.0), (3, 10.0, 80.0, 400.0))  # share [%], N m, rpm
        for number, share, torque, speed in loads:
            model.load_case(number, [(rexs_files.UNIT, "gear_unit", [("operating_time_fraction", share, "%")]),
                                     (5, "shaft", [("rotational_speed", speed, "1 / min")]), (3, "external_load", [("torque_around_u_axis", torque, "N m")])])
        found = self.converted(model)
        entry = next(one for one in found.report["bearings"] if one["component"] == 41)
        self.assertEqual([one["load_case"] for one in entry["load_cases"]], ["1", "2", "3"])
        damage = 0.0
        for one, (number, share, torque, speed) in zip(entry["load_cases"], loads):
            case = orbearing.parse(found.cases[f"6205_lager_41_load_case_{number}"], "c")
            force = torque / 0.02 / math.cos(20.0 * DEGREE) / 2
            self.reads(case, load__radial=force, operation__shaft_speed=0.5 * speed * RPM)
            self.assertAlmostEqual(one["figures"]["radial_force_N"] / force, 1.0, 8)
            self.assertAlmostEqual(one["share"], share / 100.0, 12)
            (life,) = (one["figures"]["L10h"],)
            capacity = case["bearing.dynamic_capacity"]
            self.assertAlmostEqual(life / (1e6 / (30.0 * speed) * (capacity / force) ** 3), 1.0, 6)  # no axial load: P = F
            damage += share / 100.0 / life
        self.assertAlmostEqual(entry["lives"]["L10h"] * damage, 1.0, 8)
        self.assertEqual(entry["case"], "cases/6205_lager_41_load_case_2/case.yaml")  # which does most damage


    def test_of_many_load_cases_the_worst_is_written(self):
        model = without(rexs_files.gearbox(), "torque_around_u_axis", "rotational_speed")
        for number in range(1, 26):
            model.load_case(number, [(rexs_files.UNIT, "gear_unit", [("operating_time_fraction", 4.0, "%")]),
                                     (5, "shaft", [("rotational_speed", 1000.0, "1 / min")]), (3, "external_load", [("torque_around_u_axis", 10.0 + number % 13, "N m")])])
        found = self.converted(model)
        self.assertEqual(sorted(name for name in found.cases if name != "stage"), [f"6205_lager_{number}_load_case_12" for number in (30, 31, 40, 41)])
        entry = found.report["bearings"][0]
        self.assertEqual([one["load_case"] for one in entry["load_cases"] if one["case"]], ["12"])
        lives = [one["figures"]["L10h"] for one in entry["load_cases"]]
        self.assertAlmostEqual(entry["lives"]["L10h"] * sum(0.04 / life for life in lives), 1.0, 8)

    def test_results_of_a_load_case_are_written_into_it(self):
        """Each life stands where its load does, in both forms."""
        for form in (".rexs", ".rexsj"):
            model = without(rexs_files.gearbox(), "torque_around_u_axis", "rotational_speed")
            for number, torque in ((1, 50.0), (2, 30.0)):
                model.load_case(number, [(rexs_files.UNIT, "gear_unit", [("operating_time_fraction", 50.0, "%")]),
                                         (5, "shaft", [("rotational_speed", 1000.0, "1 / min")]), (3, "external_load", [("torque_around_u_axis", torque, "N m")])])
            file = model.write(self.place / f"loads{form}")
            read = reading.read(file)
            found = convert.convert(read, file.name, reading.form_of(file.read_bytes()))
            document = (results._Json if form == ".rexsj" else results._Xml)(file.read_bytes())
            for number, life in ((1, 1000.0), (2, 7000.0)):
                results._write_run(read, document, found, results.Run(pathlib.Path("run"), f"6205_lager_40_load_case_{number}", {"L10h": life}, {}, None))
            file.write_bytes(document.bytes())
            again = reading.read(file)
            for load_case, life in zip(again.load_cases, (1000.0, 7000.0), strict=True):
                (bearing,) = (one for one in load_case.components if one.id == 40)
                self.assertEqual((bearing.type, bearing.attributes["nominal_rating_life_time_iso_281_2007"].value), ("rolling_bearing_with_catalog_geometry", life))
            self.assertNotIn("nominal_rating_life_time_iso_281_2007", again.components[40].attributes)
            self.assertEqual(again.notes, [])


class Planets(ReadBack):
    """Results of unlike planets go to their own bearings."""

    class Document:
        def __init__(self):
            self.values = {}

        def put(self, component, attribute, unit, value, _):
            self.values[component, attribute] = value

    def test_of_a_sweep_the_point_at_the_speed_of_the_case(self):
        class Resolved:
            def value(self, path):
                return {"input.speed": 100.0}[path]  # [rad/s]

        points = [{"row": {"input_speed_rpm": speed}} for speed in (900.0, 100.0 * 30.0 / math.pi, 1000.0)]
        self.assertIs(results._operating_point(pathlib.Path("run"), points, Resolved()), points[1])
        self.assertIs(results._operating_point(pathlib.Path("run"), points[2:], Resolved()), points[2])
        with self.assertRaisesRegex(CaseError, "found 2 points, none at the case's input.speed"):
            results._operating_point(pathlib.Path("run"), points[::2], Resolved())

    def test_each_bearing_has_its_own_life(self):
        found = self.converted(rexs_files.planetary())
        lives = [1000.0 + 100.0 * i for i in range(6)]
        run = results.Run(pathlib.Path("run"), STAGE, {"L10h": 1000.0, "L10_Mrev": 50.0, "kappa": 1.5}, {"bearing_L10h": lives}, None)
        document = self.Document()
        model = reading.read(rexs_files.planetary().write(self.place / "m.rexs"))
        model.version = "1.2"  # no contacts of rolling elements
        results._write_run(model, document, found, run)
        for planet in range(3):
            for index in range(2):
                bearing, life = BEARING + 10 * planet + index, lives[2 * planet + index]
                self.assertEqual(document.values[bearing, "nominal_rating_life_time_iso_281_2007"], life)
                self.assertAlmostEqual(document.values[bearing, "nominal_rating_life_rotations_iso_281_2007"], 50e6 * life / 1000.0, 3)
                self.assertEqual(document.values[bearing, "viscosity_ratio_according_to_iso_281_2007"], 1.5)


class Places(ReadBack):
    """Where gears are along their shafts: in space, as all versions have it; the coordinate is that of the face's beginning in version 1.0."""

    def forces(self, model):
        found = self.converted(model)
        return [entry["figures"]["radial_force_N"] for entry in found.report["bearings"][:2]], found.report["notes"]

    def test_the_place_in_space_is_taken(self):
        force = 50.0 / 0.02 / math.cos(math.radians(20.0))
        for coordinate, told in ((50.0, None), (40.0, "half a face width before"), (47.0, "component 7 ('Gear 1'): u_coordinate_on_shaft is 47 mm; its support_vector gives 50 mm")):
            model = with_attributes(rexs_files.gearbox(), 7, u_coordinate_on_shaft=(coordinate, "mm"))
            forces, notes = self.forces(model)
            for found in forces:
                self.assertAlmostEqual(found / (0.5 * force), 1.0, 9)
            self.assertEqual([told] if told else [], [told for note in notes if told and told in note], notes)
            self.assertEqual(len(notes), 1 if told else 0, notes)

    def test_shafts_that_begin_elsewhere_and_coordinates_alone(self):
        force = 50.0 / 0.02 / math.cos(math.radians(20.0))
        moved = with_attributes(with_attributes(rexs_files.gearbox(), 5, support_vector=([-15.0, 0.0, 0.0], "mm")), 7, u_coordinate_on_shaft=(65.0, "mm"))
        forces, notes = self.forces(moved)  # the gear is at 65 mm between bearings at 20 and 80 mm
        self.assertEqual(notes, [])
        for found, share in zip(forces, (0.25, 0.75)):
            self.assertAlmostEqual(found / (share * force), 1.0, 9)
        alone = with_attributes(with_attributes(rexs_files.gearbox(), 5, support_vector=(None, "mm")), 7, u_coordinate_on_shaft=(35.0, "mm"))
        forces, _ = self.forces(alone)
        for found, share in zip(forces, (0.75, 0.25)):
            self.assertAlmostEqual(found / (share * force), 1.0, 9)


class Contradictions(ReadBack):
    """What a file states twice and differently is a note."""

    def noted(self, model, *texts):
        found = self.converted(model)
        for text in texts:
            self.assertTrue(any(text in note for note in found.report["notes"]), (text, found.report["notes"]))
        return found

    def test_nothing_is_noted_where_nothing_contradicts(self):
        for model in (rexs_files.planetary(), rexs_files.planetary(load_cases=True), rexs_files.gearbox(), rexs_files.two_stages(), gearbox()):
            self.assertEqual(self.converted(model).report["notes"], [])

    def test_digits_of_a_speed_that_is_rounded_contradict_nothing(self):
        """22 rpm of the carrier are 125.714 rpm of the sun; the file states four digits."""
        self.assertEqual(self.converted(with_attributes(rexs_files.planetary(), 13, rotational_speed=(125.7, "1 / min"))).report["notes"], [])

    def test_a_coupling_is_no_bearing(self):
        """One that joins a shaft and its gear carries no load of the shaft and is in no list."""
        joined = gearbox()
        joined.add(900, "coupling", "Nabe", u_coordinate_on_shaft_inner_side=(50.0, "mm"))
        joined.relate("side", assembly=900, inner_part=5, outer_part=7)
        found, plain = self.converted(joined), self.converted(gearbox())
        self.assertEqual([entry["component"] for entry in plain.report["bearings"]], [30, 31, 40, 41])
        self.assertEqual(found.report["bearings"], plain.report["bearings"])
        self.assertEqual(found.cases, plain.cases)

    def test_modules_that_do_not_mesh_are_no_case(self):
        for number in (rexs_files.SUN, rexs_files.PLANET + 1, rexs_files.RING):
            found = self.converted(with_attributes(rexs_files.planetary(), number, normal_module=(8.0, "mm")))
            self.assertEqual(found.cases, {})
            self.assertIn("gears that mesh have one module", found.report["stages"][0]["problems"][0])
        found = self.converted(with_attributes(rexs_files.gearbox(), 8, normal_module=(2.5, "mm")))
        self.assertNotIn("stage", found.cases)
        self.assertIn("component 7 has a normal module of 2 mm, component 8 of 2.5 mm", found.report["pairs"][0]["problems"][0])

    def test_stages(self):
        distance = rexs_files.planetary()
        for number in (61, 62, 63):
            with_attributes(distance, number, center_distance=(310.0, "mm"))
        self.noted(distance, "component 61, 62, 63: center_distance 310.0 mm: contradicts the teeth: the profile shifts of sun and planet add up to 0.575")
        ring = rexs_files.planetary()
        for number in (71, 72, 73):
            with_attributes(ring, number, center_distance=(309.0, "mm"))
        self.noted(ring, "component 71, 72, 73: center_distance 309.0 mm: contradicts the teeth: the profile shift of the ring is 0.575 more than the planet's")
        self.noted(with_attributes(rexs_files.planetary(), rexs_files.RING, helix_angle_reference_diameter=(7.5, "deg")),
                   "component 12: helix_angle_reference_diameter 7.5 deg: contradicts the sun's")
        self.noted(with_attributes(rexs_files.planetary(), BEARING + 1, operating_radial_bearing_clearance=(20.0, "mum")),
                   "component 502: operating_radial_bearing_clearance 20.0 mum: differs from component 501")
        self.noted(with_attributes(rexs_files.planetary(), rexs_files.PLANET + 2, face_width=(200.0, "mm"), mass_of_component=(80.0, "kg")))
        self.noted(with_attributes(rexs_files.planetary(), 10 * rexs_files.SUN + 2, normal_pressure_angle=(22.5, "deg")), "differs from the other flank")
        self.noted(with_attributes(rexs_files.planetary(), 13, rotational_speed=(100.0, "1 / min")), "contradict the numbers of teeth")
        rounded = 1.003 * 22.0 * (1.0 + 99.0 / 21.0)  # what is left is below a thousandth of it, but not of 22 rpm
        self.noted(with_attributes(rexs_files.planetary(), 13, rotational_speed=(rounded, "1 / min")))
        self.noted(with_attributes(rexs_files.planetary(), 6, torque_around_u_axis=(9000.0, "N m"), defines_torque=(True, "none")),
                   "the torques that the file states contradict each other")
        self.noted(with_attributes(rexs_files.planetary(), 5, power=(700.0, "kW")), "its power at 22 rpm gives 303841 N m; the torque is taken")

    def test_pairs(self):
        self.noted(with_attributes(gearbox(), 8, helix_angle_reference_diameter=(12.0, "deg")), "component 8: helix_angle_reference_diameter 12.0 deg: contradicts the mate's")
        self.noted(with_attributes(rexs_files.gearbox(), 10, center_distance=(61.0, "mm")), "the centre distance of 61 mm requires")

    def test_the_same_in_another_unit_is_no_contradiction(self):
        model = with_attributes(rexs_files.planetary(), BEARING + 1, operating_radial_bearing_clearance=(0.06, "mm"))
        with_attributes(model, rexs_files.SUN, normal_module=(0.01, "m"), helix_angle_reference_diameter=(7.5 * DEGREE, "rad"))
        self.assertEqual(self.converted(model).report["notes"], [])


if __name__ == "__main__":
    unittest.main()
