#!/usr/bin/env python3
"""Numbers of other programs' files come in as SI, whatever the unit that the file names: REXS, OpenFAST, records, tables and catalogues.

Each unit of each attribute or column is replaced by each other one of its quantity, with the number that says the same: the result is
the same. Another number in its place gives another result, so that none of them is passed over.
"""

import json
import math
import pathlib
import re
import tempfile
import unittest

import program
import rexs_files

orbearing = program.package()

from orbearing.rexs import convert, names, reading  # noqa: E402

NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w])")
SAME, ROUND_OFF = 1e-8, 1e-9  # relative; of numbers whose last digits are rounded
WITHOUT_EFFECT = {"viscosity_100", "oil_density", "common_width"}  # a case has them by the grade, and by the gears
PLACE = "support_vector"


def with_attributes(model, number, **attributes):
    """The model with attributes of a component replaced or added."""
    model.components = [(one, kind, name, [*(row for row in rows if row[0] not in attributes), *((key, *value) for key, value in attributes.items())]
                         if one == number else rows) for one, kind, name, rows in model.components]
    return model


def without(model, *attributes):
    model.components = [(one, kind, name, [row for row in rows if row[0] not in attributes]) for one, kind, name, rows in model.components]
    return model


def stage():
    """A planetary stage that states all that a stage can."""
    model = rexs_files.planetary()
    with_attributes(model, rexs_files.SUN, tip_diameter=(233.0, "mm"), root_diameter=(190.0, "mm"), inner_diameter=(90.0, "mm"), mass_of_component=(110.0, "kg"),
                    u_coordinate_on_shaft=(100.0, "mm"), support_vector=([100.0, 0.0, 0.0], "mm"))
    with_attributes(model, rexs_files.RING, mass_of_component=(700.0, "kg"), u_coordinate_on_shaft=(20.0, "mm"), support_vector=([20.0, 0.0, 0.0], "mm"))
    for place, outside in ((0.0, 1300.0), (120.0, 1250.0)):
        section = model.add(700 + int(place), "shaft_section", "", u_coordinate_on_shaft=(place, "mm"), length=(110.0, "mm"), outer_diameter_begin=(outside, "mm"))
        model.relate("assembly", assembly=14, part=section)
    model.add(704, "shaft_section", "", u_coordinate_on_shaft=(0.0, "mm"), length=(220.0, "mm"), inner_diameter_begin=(250.0, "mm"))
    model.relate("assembly", assembly=41, part=704)
    for i in range(3):
        with_attributes(model, 61 + i, minimum_normal_backlash=(0.2, "mm"), maximum_normal_backlash=(0.4, "mm"))
    for number in (91, 92):
        model.add(number, "concept_bearing", "Steglager", radial_stiffness=(2e8, "N / m"))
        model.relate("side", assembly=number, inner_part=15, outer_part=rexs_files.CASING)
    for number, *_ in list(model.components):
        if 500 < number < 600:
            with_attributes(model, number, fatigue_limit_load=(150.0, "kN"), survival_probability=(95.0, "%"))
    return model


def of_clearance(**clearances):
    """A stage whose bearings state their clearance in this way."""
    model = without(rexs_files.planetary(), "operating_radial_bearing_clearance")
    for number, *_ in list(model.components):
        if 500 < number < 600:
            with_attributes(model, number, **clearances)
    return model


def of_lengths(**lengths):
    """A stage whose rollers state the length of their contacts."""
    model = without(rexs_files.planetary(), "roller_crowning_radius")
    for number, *_ in list(model.components):
        if 1500 < number < 1600:
            with_attributes(model, number, **lengths)
    return model


def of_shift_lengths():
    model = without(rexs_files.planetary(), "addendum_modification_coefficient")
    for gear, shift in ((rexs_files.SUN, 1.763), (rexs_files.PLANET, 3.987), (rexs_files.RING, -9.737)):
        for side in (1, 2):
            with_attributes(model, 10 * gear + side, addendum_modification=(shift, "mm"))
    return model


def of_load_cases(unit, **attributes):
    """A stage with the load cases' times in this unit, and powers for torques."""
    model = rexs_files.planetary(load_cases=True)
    for number, parts in model.load_cases:
        for component, kind, rows in parts:
            if kind == "gear_unit":
                rows[:] = [(key, number * value, unit) for key, value in attributes.items()]
            elif kind == "external_load":
                rows[:] = [("power", 100.0 * number, "kW")]
    return model


def warm_load_cases():
    model = without(rexs_files.planetary(load_cases=True), "temperature_lubricant")
    for number, parts in model.load_cases:
        parts.append((rexs_files.CASING, "gear_casing", [("temperature_lubricant", 40.0 + 10.0 * (number % 3), "C")]))
    return model


def gearbox():
    """A pair with forces of a belt and a coupling on its shafts."""
    model = rexs_files.gearbox()
    with_attributes(model, 3, force_u_direction=(110.0, "N"), force_v_direction=(-230.0, "N"), force_w_direction=(370.0, "N"),
                    torque_around_v_axis=(5.0, "N m"), torque_around_w_axis=(-7.0, "N m"), u_coordinate_on_shaft=(-10.0, "mm"))
    with_attributes(model, 10, center_distance=(60.0 / math.cos(math.radians(12.0)), "mm"))
    for gear, helix in ((7, 12.0), (8, -12.0)):
        with_attributes(model, gear, helix_angle_reference_diameter=(helix, "deg"))
    return model


def without_places():
    """The same with coordinates on the shafts alone, as far as they can do."""
    return with_attributes(with_attributes(gearbox(), 5, support_vector=(None, "mm")), 6, support_vector=(None, "mm"))


def stated_bearings():
    """Ball bearings of which the file states the inside, forces and speeds."""
    model = rexs_files.gearbox()
    for number in (30, 31, 40, 41):
        with_attributes(model, number, radial_force_in_v=(3.0, "kN"), radial_force_in_w=(-4.0, "kN"), axial_force=(1.5, "kN"), speed_inner_ring=(900.0, "1 / min"),
                        speed_outer_ring=(-30.0, "1 / min"), operating_radial_bearing_clearance=(12.0, "mum"), inner_diameter=(25.0, "mm"), outer_diameter=(52.0, "mm"), width=(15.0, "mm"))
        model.add(number + 100, "rolling_bearing_row", "", number_of_rolling_elements=9, reference_diameter_rolling_bearing=(39.0, "mm"), pressure_angle=(15.0, "deg"),
                  raceway_radius_of_inner_ring=(4.09, "mm"), raceway_radius_of_outer_ring=(4.17, "mm"))
        model.add(number + 200, "rolling_element", "", diameter_of_rolling_element=(7.94, "mm"))
        model.relate("ordered_assembly", assembly=number, part=number + 100)
        model.relate("ordered_assembly", assembly=number + 100, part=number + 200)
    return model


def numbers_and_words(text):
    return [float(one) for one in NUMBER.findall(text)], NUMBER.sub("#", text)


class Rexs(unittest.TestCase):
    MODELS = {"stage": stage, "clearance mounted": lambda: of_clearance(mounted_radial_bearing_clearance=(70.0, "mum")),
              "clearance before mounting": lambda: of_clearance(radial_bearing_clearance=(80.0, "mum")),
              "clearance between": lambda: of_clearance(minimum_radial_bearing_clearance=(50.0, "mum"), maximum_radial_bearing_clearance=(75.0, "mum")),
              "length inner": lambda: of_lengths(significant_contact_length_inner_ring=(55.0, "mm"), significant_contact_length_outer_ring=(56.0, "mm")),
              "length outer": lambda: of_lengths(significant_contact_length_inner_ring=(55.0, "mm"), significant_contact_length_outer_ring=(54.0, "mm")),
              "shifts": of_shift_lengths, "shares": lambda: of_load_cases("%", operating_time_fraction=100.0 / 6.0),
              "hours": lambda: of_load_cases("h", operating_time=1000.0), "oil": warm_load_cases, "gearbox": gearbox, "gearbox by coordinates": without_places,
              "bearings": stated_bearings}

    def converted(self, model):
        """Texts of all cases and figures of the report, and the numbers in them."""
        with tempfile.TemporaryDirectory() as folder:
            file = model.write(pathlib.Path(folder) / "model.rexsj")
            found = convert.convert(reading.read(file), "model.rexsj", "json")
        report = {kind: [{key: one.get(key) for key in ("case", "problems", "figures", "load_cases")} for one in found.report[kind]]
                  for kind in ("stages", "pairs", "bearings", "shafts")}
        return json.dumps([found.cases, found.incomplete, report], sort_keys=True)

    def same(self, one, other):
        (first, words), (second, other_words) = numbers_and_words(one), numbers_and_words(other)
        return words == other_words and all(math.isclose(a, b, rel_tol=SAME, abs_tol=ROUND_OFF) for a, b in zip(first, second))

    def changed(self, make, attribute, change):
        """The model with this attribute of all its components changed: value and unit as change() gives them."""
        model = make()
        model.components = [(number, kind, name, [(key, *change(value, unit)) if key == attribute and value is not None else (key, value, unit)
                                                  for key, value, unit in rows]) for number, kind, name, rows in model.components]
        model.load_cases = [(number, [(component, kind, [(key, *change(value, unit)) if key == attribute else (key, value, unit) for key, value, unit in rows])
                                      for component, kind, rows in parts]) for number, parts in model.load_cases]
        return model

    def dimensional(self, make):
        """Attributes of a model that have a unit, with the unit in the file."""
        model = make()
        parts = [(number, kind, rows) for number, kind, _, rows in model.components] + [one for _, several in model.load_cases for one in several]
        known = {(spelled, kind) for one in names.KNOWN.values() for spelled in one.names for kind in one.components} | \
                {(PLACE, kind) for _, kind, _ in parts}
        found = {}
        for _, kind, rows in parts:
            for key, value, unit in rows:
                if (key, kind) in known and value is not None and names.unit_of(unit) and unit not in ("none", ""):
                    found[key] = unit
        return found

    def test_each_unit_of_each_attribute_gives_the_same_cases(self):
        tried, effective = set(), set()
        for name, make in self.MODELS.items():
            right = self.converted(make())
            self.assertNotIn('incomplete', right, name)
            of_gearbox = name.startswith(("gearbox", "bearings"))
            for attribute, stated in self.dimensional(make).items():
                if (of_gearbox and name, attribute) in tried:
                    continue
                tried.add((of_gearbox and name, attribute))
                own = names.unit_of(stated)
                for unit, meaning in names.UNITS.items():
                    if meaning.quantity != own.quantity or unit in ("", "-", "1") or meaning == own:
                        continue

                    def in_unit(value, _):
                        return ([(one * own.factor + own.offset - meaning.offset) / meaning.factor for one in value] if isinstance(value, list) else
                                (value * own.factor + own.offset - meaning.offset) / meaning.factor), unit

                    found = self.converted(self.changed(make, attribute, in_unit))
                    self.assertTrue(self.same(found, right), f"{name}: {attribute} in {unit}\n{found}\n{right}")
                for factor in (1.01, 1.5, 0.1):  # an oil of 1 % more is of the same grade, a longer section of a shaft still under its gear
                    if attribute not in effective and not self.same(self.converted(self.changed(make, attribute, lambda value, unit: (
                            [factor * one for one in value] if isinstance(value, list) else factor * value, unit))), right):
                        effective.add(attribute)
        for name, known in names.KNOWN.items():
            if names.unit_of(known.unit).quantity != "number" and name not in WITHOUT_EFFECT:
                self.assertTrue(set(known.names) & {attribute for _, attribute in tried}, f"no model states {name}")
                self.assertTrue(set(known.names) & effective, f"{name} changes nothing")
        self.assertIn(PLACE, effective)

    def test_a_force_of_the_file_is_in_newtons(self):
        """By hand: 1 kN across and its moments on a shaft of two bearings at 20 and 80 mm, 50 mm outside the first."""
        for attribute, value, unit, first, second in (("force_v_direction", 1000.0, "N", 1000.0 * 110.0 / 60.0, 1000.0 * 50.0 / 60.0),
                                                      ("force_w_direction", 1.0, "kN", 1000.0 * 110.0 / 60.0, 1000.0 * 50.0 / 60.0),
                                                      ("torque_around_v_axis", 60.0, "N m", 1000.0, 1000.0), ("torque_around_w_axis", 0.06, "kN m", 1000.0, 1000.0)):
            model = rexs_files.gearbox()
            with_attributes(model, 3, torque_around_u_axis=(1e-9, "N m"), u_coordinate_on_shaft=(-30.0, "mm"), **{attribute: (value, unit)})
            with tempfile.TemporaryDirectory() as folder:
                found = convert.convert(reading.read(model.write(pathlib.Path(folder) / "model.rexs")), "model.rexs", "xml")
            forces = [one["figures"]["radial_force_N"] for one in found.report["bearings"][:2]]
            for force, wanted in zip(forces, (first, second)):
                self.assertAlmostEqual(force / wanted, 1.0, 6, (attribute, forces))
        model = with_attributes(rexs_files.gearbox(), 3, force_u_direction=(0.5, "kN"))
        with tempfile.TemporaryDirectory() as folder:
            found = convert.convert(reading.read(model.write(pathlib.Path(folder) / "model.rexs")), "model.rexs", "xml")
        self.assertAlmostEqual(found.report["bearings"][0]["figures"]["axial_force_N"], 500.0, 9)


# Units of records and tables by quantity, and the size of each in the SI unit.
RPM = math.pi / 30.0
SPEEDS = {"rpm": RPM, "1/min": RPM, "U/min": RPM, "rad/s": 1.0, "deg/s": math.pi / 180.0}
TORQUES = {"N.m": 1.0, "Nm": 1.0, "N-m": 1.0, "kN.m": 1e3, "kN-m": 1e3, "MN.m": 1e6, "N.mm": 1e-3}
POWERS = {"W": 1.0, "kW": 1e3, "MW": 1e6}
TIMES = {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0}
LENGTHS = {"mm": 1e-3, "m": 1.0, "cm": 1e-2, "um": 1e-6}
FORCES = {"kN": 1e3, "N": 1.0, "MN": 1e6}


class Records(unittest.TestCase):
    """Channels of a made-up simulation, in SI."""

    ROWS = [(60.0 * i, (8.0, 12.0)[i // 3 % 2], (4.1e6, 1.0e6, 2.2e6, 3.1e6)[i % 4] + 2e4 * (i % 5)) for i in range(60)]

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def bins(self, name, text, *options):
        file = self.folder / name
        file.write_text(text, encoding="utf-8")
        result = program.run("spectrum", file, "--json", "--time", "Time", "--speed", "Speed", "--bins", "4x2", *options)
        self.assertEqual(result.returncode, 0, text[:300] + result.stderr)
        return [(one["share"], one["torque_N_m"], one["speed_rpm"]) for one in json.loads(result.stdout)["bins"]]

    def text(self, form, time, speed, load, by_power):
        """A table or a file of OpenFAST with these units."""
        rows = [(t / TIMES[time], n / SPEEDS[speed], (m * n / POWERS[load]) if by_power else m / TORQUES[load]) for t, n, m in self.ROWS]
        third = "Power" if by_power else "Torque"
        if form == "out":
            lines = ["", "Predictions were generated by a program", "", "", "", "", f"Time\tSpeed\t{third}", f"({time})\t({speed})\t({load})"]
            return "\n".join(lines + ["\t".join(f"{one:.15e}" for one in row) for row in rows]) + "\n"
        head = f"Time [{time}],Speed [{speed}],{third} [{load}]" if form == "brackets" else f"Time,Speed,{third}\n{time},{speed},{load}"
        return "\n".join([head, *(",".join(repr(one) for one in row) for row in rows)]) + "\n"

    def test_each_unit_of_each_channel_gives_the_same_bins(self):
        for form in ("out", "brackets", "line of units"):
            for by_power, loads in ((False, TORQUES), (True, POWERS)):
                options = ("--power", "Power") if by_power else ("--torque", "Torque")
                name = "series.out" if form == "out" else "series.csv"
                right = self.bins(name, self.text(form, "s", "rad/s", "W" if by_power else "N.m", by_power), *options)
                self.assertEqual(max(one[1] for one in right) // 1e5, 41, right)  # N m
                for time, speed, load in [("s", "rad/s", unit) for unit in loads] + [("s", unit, next(iter(loads))) for unit in SPEEDS] + \
                        [(unit, "rad/s", next(iter(loads))) for unit in TIMES]:
                    found = self.bins(name, self.text(form, time, speed, load, by_power), *options)
                    self.assertEqual(len(found), len(right))
                    for one, other in zip(found, right):
                        for a, b in zip(one, other):
                            self.assertAlmostEqual(a / b, 1.0, delta=1e-9, msg=f"{form}: {time}, {speed}, {load}")

    def test_each_unit_of_rows_of_a_spectrum(self):
        rows = [(150e3, 600.0, 0.7), (90e3, 200.0, 0.3)]  # W, rad/s, share

        def spectrum(unit_of_load, unit_of_speed, by_torque):
            lines = [f"{'torque' if by_torque else 'power'} [{unit_of_load}],speed [{unit_of_speed}],share"]
            lines += [f"{(power / speed / TORQUES[unit_of_load]) if by_torque else power / POWERS[unit_of_load]!r},{speed / SPEEDS[unit_of_speed]!r},{share}"
                      for power, speed, share in rows]
            (self.folder / "loads.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
            case = orbearing.load(program.REDUCER, {"spectrum": f"{{file: {self.folder / 'loads.csv'}}}"})
            return [(row.get("power") or row["torque"] * row["speed"], row["speed"], row["share"]) for row in case["spectrum"]]

        for by_torque, loads in ((False, POWERS), (True, TORQUES)):
            for load, speed in [(unit, "rpm") for unit in loads] + [(next(iter(loads)), unit) for unit in SPEEDS]:
                for found, wanted in zip(spectrum(load, speed, by_torque), rows):
                    for a, b in zip(found, wanted):
                        self.assertAlmostEqual(a / b, 1.0, 9, (load, speed))

    def test_each_unit_of_a_catalogue(self):
        sizes = {"bore": 20e-3, "outside_diameter": 47e-3, "width": 14e-3, "inner_raceway": 26.5e-3}
        ratings = {"dynamic_capacity": 32.5e3, "static_capacity": 24.7e3, "fatigue_load_limit": 3.9e3}

        def bearing(units):
            columns = {key: value / {**LENGTHS, **FORCES}[units[key]] for key, value in {**sizes, **ratings}.items()}
            head = "designation,family," + ",".join(f"{key} [{units[key]}]" for key in columns)
            text = head + "\nTRY 204,cylindrical-roller," + ",".join(repr(value) for value in columns.values()) + "\n"
            (self.folder / "ours.csv").write_text(text, encoding="utf-8")
            case = orbearing.parse("name: ours\nsource: made up\nmodel: roller-bearing\nload: {radial: 3 kN}\nbearing: {catalogue: "
                                   f"{self.folder / 'ours.csv'}, designation: TRY 204, clearance_class: CN}}\n")
            return {key: case["bearing." + key] for key in (*(one for one in sizes if one != "inner_raceway"), *ratings, "pitch_diameter")}

        usual = {**dict.fromkeys(sizes, "mm"), **dict.fromkeys(ratings, "kN")}
        right = bearing(usual)
        self.assertAlmostEqual(right["bore"], 20e-3, 12)
        self.assertAlmostEqual(right["dynamic_capacity"], 32.5e3, 6)
        for column in usual:
            for unit in LENGTHS if column in sizes else FORCES:
                for key, value in bearing({**usual, column: unit}).items():
                    self.assertAlmostEqual(value / right[key], 1.0, 9, (column, unit, key))


if __name__ == "__main__":
    unittest.main()
