#!/usr/bin/env python3
"""Conversions of REXS files are as recorded: cases, report, printed words, and files with results, of each model whole and with one value or relation changed at a time.

`--record` writes records/rexs.json.xz anew.
"""

import io
import contextlib
import json
import pathlib
import tempfile
import unittest.mock

import file_units
import kept_records
import program
import rexs_files

orbearing = program.package()

from orbearing.errors import CaseError, ComputationError  # noqa: E402
from orbearing.rexs import __main__ as command, convert, names, reading, results, sources  # noqa: E402

RECORDS = kept_records.Records("rexs")
SI = {"deg": 1.0, "°": 1.0}


def unshifted(make, first=0, **stated):
    """A model whose gears, from the `first` flank on, state no profile shift, and whose components state these values instead."""
    model = make()
    flanks = [rows for _, _, _, rows in model.components if any(key == "addendum_modification_coefficient" for key, _, _ in rows)]
    for rows in flanks[first:]:
        rows[:] = [row for row in rows if row[0] != "addendum_modification_coefficient"]
    for _, _, _, rows in model.components:
        rows[:] = [(key, stated.get(key, value), unit) for key, value, unit in rows]
    return model


def turned(model, name, stated=True):
    """With the axis of the shaft of that name the other way round, or not stated."""
    for _, kind, own, rows in model.components:
        if (kind, own) == ("shaft", name):
            rows[:] = [(key, [-one for one in value] if key == "u_axis_vector" else value, unit) for key, value, unit in rows if stated or key != "u_axis_vector"]
    return model


def saying(make, kind, each=None, **attributes):
    """A model whose components of a kind state these attributes as (value, unit); None: they state none. `each`: attributes of the first, the second and so on."""
    model = make()
    for place, (number, _, _, _) in enumerate([one for one in model.components if one[1] == kind]):
        own = attributes | (each[place] if each and place < len(each) else {})
        file_units.with_attributes(model, number, **{key: value for key, value in own.items() if value is not None})
        for _, _, _, rows in (one for one in model.components if one[0] == number):
            rows[:] = [row for row in rows if row[0] not in own or own[row[0]] is not None]
    return model


def cut_by(*tools):
    """A pair whose gears were cut by tools of these kinds and tip radii."""
    model = rexs_files.gearbox()
    for gear, (kind, radius) in zip((7, 8), tools):
        model.add(gear * 100, kind, "", tip_radius_factor=radius)
        model.relate("ordered_reference", origin=gear, referenced=gear * 100)
    return model


def at_distances(sun, ring):
    """A stage whose meshes state these centre distances [mm]: below 284 mm its teeth cannot mesh."""
    model = rexs_files.planetary()
    for number, kind, _, rows in model.components:
        if kind == "cylindrical_stage":
            rows[:] = [(key, (sun if number < 71 else ring) if key == "center_distance" else value, unit) for key, value, unit in rows]
    return model


def driven_by_word(second):
    """A pair without loads, whose data say whether the second gear drives."""
    model = rexs_files.gearbox()
    for _, kind, _, rows in model.components:
        if kind == "external_load":
            rows[:] = [row for row in rows if row[0] == "u_coordinate_on_shaft"]
    model.add(11, "stage_gear_data", "", is_driving_gear=second)
    model.relate("stage_gear_data", stage=10, gear=8, stage_gear_data=11)
    return model


MODELS = {
    "pair without shifts": lambda: unshifted(file_units.gearbox, center_distance=62.0), "pair with one shift": lambda: unshifted(file_units.gearbox, 2, center_distance=62.0),
    "stage without shifts": lambda: unshifted(file_units.stage), "stage with the ring's shift": lambda: unshifted(file_units.stage, 2),
    "stage": rexs_files.planetary, "stage, load cases": lambda: rexs_files.planetary(load_cases=True), "stage, concept": lambda: rexs_files.planetary(bearing="concept"),
    "stage, designation": lambda: rexs_files.planetary(bearing="designation"), "stage, 1.0": lambda: rexs_files.planetary("1.0", "°", torque=(-325541.0, "N m"), ring_shift=0.9737),
    "stage, 2.0": lambda: rexs_files.planetary("2.0", helix=0.0, load_cases=True, speed=(2.3, "rad / s")), "two stages": rexs_files.two_stages, "pair": rexs_files.gearbox,
    "coaxial, turned shaft": lambda: turned(rexs_files.coaxial_gearbox(), "Middle"),
    "coaxial, a shaft without axis": lambda: turned(rexs_files.coaxial_gearbox(), "Middle", stated=False),
    "coaxial": rexs_files.coaxial_gearbox, "coaxial, no places": lambda: rexs_files.coaxial_gearbox("2.0", False), "powered": rexs_files.powered_planets, "worm": rexs_files.worm_gearbox,
    "full stage": file_units.stage, "full pair": file_units.gearbox, "pair without places": file_units.without_places, "stated bearings": file_units.stated_bearings, "warm load cases": file_units.warm_load_cases,
    "hours": lambda: file_units.of_load_cases("h", operating_time=100.0), "percent": lambda: file_units.of_load_cases("%", operating_time_fraction=20.0), "shifts as lengths": file_units.of_shift_lengths,
    "lengths": lambda: file_units.of_lengths(significant_contact_length_inner_ring=(55.0, "mm"), significant_contact_length_outer_ring=(57.0, "mm")),
    **{f"clearance {i}": lambda one=one: file_units.of_clearance(**one) for i, one in enumerate((
        {"operating_radial_bearing_clearance": (-5.0, "mum")}, {"radial_clearance_class": ("C3", "none")}, {"radial_clearance_class": ("C9", "none")}, {"radial_backlash": (0.03, "mm")}, {"nominal_radial_bearing_clearance": (0.05, "mm")},
        {"mounted_radial_bearing_clearance": (0.04, "mm")}, {"minimum_radial_bearing_clearance": (0.02, "mm"), "maximum_radial_bearing_clearance": (0.05, "mm")},
        {"minimum_radial_bearing_clearance": (0.02, "mm")}, {"maximum_radial_bearing_clearance": (0.05, "mm")}))},
    "stage, no shifts, no distance": lambda: saying(lambda: unshifted(rexs_files.planetary), "cylindrical_stage", center_distance=None),
    "stage, no widths": lambda: saying(lambda: saying(rexs_files.planetary, "cylindrical_gear", face_width=None), "ring_gear", face_width=None),
    "stage, no module": lambda: saying(lambda: saying(rexs_files.planetary, "cylindrical_gear", normal_module=None), "ring_gear", normal_module=None),
    "stage, unlike modules": lambda: saying(rexs_files.planetary, "ring_gear", normal_module=(9.0, "mm")),
    "stage, other bearings": lambda: saying(rexs_files.planetary, "rolling_bearing_with_detailed_geometry", bearing_type=("radial_spherical_roller_bearing", "none")),
    "stage, unknown bearings": lambda: saying(lambda: rexs_files.planetary(bearing="designation"), "rolling_bearing_with_catalog_geometry", catalogue_designation=("QQ 77", "none")),
    "pair, no shifts, no distance": lambda: saying(lambda: unshifted(rexs_files.gearbox), "cylindrical_stage", center_distance=None),
    "pair, no widths": lambda: saying(rexs_files.gearbox, "cylindrical_gear", face_width=None), "pair, no module": lambda: saying(rexs_files.gearbox, "cylindrical_gear", normal_module=None),
    "pair, no angle": lambda: saying(rexs_files.gearbox, "cylindrical_gear_flank", normal_pressure_angle=None),
    "pair, two angles": lambda: saying(rexs_files.gearbox, "cylindrical_gear_flank", [{}, {}, {"normal_pressure_angle": (22.5, "deg")}]),
    "pair, unlike heights": lambda: saying(rexs_files.gearbox, "cylindrical_gear", [{}, {"tip_diameter": (84.6, "mm")}], tip_diameter=(44.0, "mm"), root_diameter=(35.0, "mm")),
    "pair, one rack": lambda: cut_by(("rack_shaped_tool", 0.3), ("rack_shaped_tool", 0.3)), "pair, two racks": lambda: cut_by(("rack_shaped_tool", 0.3), ("rack_shaped_tool", 0.25)),
    "pair, a cutter wheel": lambda: cut_by(("cutter_wheel_tool", 0.2), ("rack_shaped_tool", 0.25)), "pair, cutter wheels": lambda: cut_by(("cutter_wheel_tool", 0.2), ("cutter_wheel_tool", 0.3)),
    "stage, crowned along its contacts": lambda: saying(rexs_files.planetary, "rolling_bearing_row", significant_contact_length_inner_ring=(55.0, "mm"), significant_contact_length_outer_ring=(57.0, "mm")),
    "stage, planets with a bore": lambda: saying(lambda: rexs_files.planetary(bearing="concept"), "cylindrical_gear", inner_diameter=(40.0, "mm")),
    "pair, bearings at angles": lambda: saying(rexs_files.gearbox, "rolling_bearing_with_catalog_geometry", [{"catalogue_designation": (f"7205 {mark}", "none")} for mark in "ABC"],
                                               bearing_type=("angular_contact_ball_bearing", "none")),
    "stage, too near to the ring": lambda: at_distances(308.0, 270.0), "stage, too near to the sun": lambda: at_distances(270.0, 308.0),
    "stage, two distances": lambda: at_distances(308.0, 309.0),
    "pair, driven by the second gear": lambda: driven_by_word(True), "pair, not driven by the second gear": lambda: driven_by_word(False),
}
TEXTS = {"bearing_type": "radial_tapered_roller_bearing", "designation": "NU 210", "clearance_class": "C4", "axial_sense": "positive", "cleanliness": "-/17/14", "lubricant_name": "Oil X 46", "manufacturer": "SKF"}
SWITCHES = {"has_inner_ring": False, "has_outer_ring": False}
SIZES = {"number": 1.37, "length": 0.0371, "angle": 0.2113, "rotation": 41.3, "torque": 517.0, "force": 733.0, "power": 2.9e4, "stress": 1.87e11, "temperature": 61.0, "time": 7.2e6, "mass": 13.7, "density": 7600.0, "viscosity": 4.1e-5, "stiffness": 3.3e8}


def attributes_of(kind):
    """Of a kind of component: each attribute that is read of it, with a value of its own."""
    for place, (name, known) in enumerate(names.KNOWN.items()):
        if kind in known.components:
            unit = names.unit_of(known.unit)
            value = TEXTS.get(name, SWITCHES.get(name))
            if value is None:
                value = 5 if known.whole else round(SIZES[unit.quantity] * (1.0 + 0.01 * (place % 7)) / unit.factor - unit.offset, 9)
            for spelled in known.names:
                yield spelled, value, known.unit


def outcome(model):
    """Report and cases, without what names the file."""
    with tempfile.TemporaryDirectory() as folder:
        file = model.write(pathlib.Path(folder, "model.rexs"))
        try:
            read = sources.completed(reading.read(file), file)
            found = convert.convert(read, file.name, "xml")
        except (CaseError, ComputationError) as error:
            return {"error": str(error).replace(folder, "DIR")}
    report = json.loads(convert.json_of(found))
    return {"report": {key: value for key, value in report.items() if key != "versions"}, "cases": {name: text.splitlines() for name, text in sorted(found.cases.items())},
            "incomplete": {name: text.splitlines() for name, text in sorted(found.incomplete.items())}, "planets": {name: [[one.id for one in group] for group in groups] for name, groups in found.bearings.items()}}


def lines_of(value, place=""):
    """Every value with its place: what differs between two conversions is told by these lines. Entries of lists stand by what they say, not by their number."""
    if isinstance(value, dict):
        return [line for key, one in value.items() for line in lines_of(one, f"{place}/{key}")]
    if isinstance(value, list):
        return [line for one in value for line in (lines_of(one, place) if not isinstance(one, dict) else [f"{place}: {json.dumps(one, ensure_ascii=False)}"])]
    return [f"{place}: {value}"]


def other(value):
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return value + 3
    if isinstance(value, float):
        return round(1.0713 * value, 9) + 0.0071
    if isinstance(value, list):
        return [other(one) for one in value]
    return value + "x"


def copied(model):
    fresh = rexs_files.Rexs(model.version, model.degree, model.none)
    fresh.components = [(number, kind, name, list(rows)) for number, kind, name, rows in model.components]
    fresh.relations = [(kind, list(roles)) for kind, roles in model.relations]
    fresh.load_cases = [(number, [(component, kind, list(rows)) for component, kind, rows in parts]) for number, parts in model.load_cases]
    return fresh


def changes(model):
    """Name and model of each: an attribute of all components of its kind left out, of the first one alone, of the last one changed; one that none has; a relation, a part left out."""
    places = {}
    for i, (_, kind, _, rows) in enumerate(model.components):
        for j, (key, _, _) in enumerate(rows):
            places.setdefault((kind, key), []).append((i, j))
    for (kind, key), found in places.items():
        if len(found) > 1:
            fresh = copied(model)
            for i, j in found:
                fresh.components[i][3][j] = None
            for _, _, _, rows in fresh.components:
                rows[:] = [row for row in rows if row is not None]
            yield f"without any {kind}.{key}", fresh
        i, j = found[0]
        fresh = copied(model)
        del fresh.components[i][3][j]
        yield f"without the first {kind}.{key}", fresh
        i, j = found[-1]
        fresh = copied(model)
        name, value, unit = fresh.components[i][3][j]
        fresh.components[i][3][j] = (name, other(value), unit)
        yield f"other last {kind}.{key}", fresh
    for kind in dict.fromkeys(kind for _, kind, _, _ in model.components):
        for key, value, unit in attributes_of(kind):
            if (kind, key) not in places:
                fresh = copied(model)
                for _, one, _, rows in fresh.components:
                    if one == kind:
                        rows.append((key, value, unit))
                yield f"more {kind}.{key}", fresh
    seen = set()
    for i, (kind, roles) in enumerate(model.relations):
        types = {number: one for number, one, _, _ in model.components}
        what = (kind, *((role, types.get(component)) for role, component in roles))
        if what not in seen:
            seen.add(what)
            fresh = copied(model)
            del fresh.relations[i]
            yield f"without relation {i}", fresh
    seen = set()
    for i, (number, kind, name, _) in enumerate(model.components):
        if kind not in seen:
            seen.add(kind)
            fresh = copied(model)
            del fresh.components[i]
            fresh.relations = [one for one in fresh.relations if number not in [component for _, component in one[1]]]
            yield f"without {kind} {number}", fresh
    for i, (_, parts) in enumerate(model.load_cases[:2]):
        for j, (_, _, rows) in enumerate(parts):
            for k in range(len(rows)):
                fresh = copied(model)
                key, value, unit = rows[k]
                fresh.load_cases[i][1][j][2][k] = (key, other(value), unit)
                yield f"load case {i}, other {key} of part {j}", fresh
                fresh = copied(model)
                del fresh.load_cases[i][1][j][2][k]
                yield f"load case {i}, no {key} of part {j}", fresh


class Rexs(kept_records.Recorded):
    records = RECORDS

    def test_all_models(self):
        for name, make in MODELS.items():
            self.check(name, outcome(make()))

    @unittest.mock.patch.object(convert, "warnings_of", lambda core: [])  # those of whole models are recorded; they take half of the time
    def test_changed_models(self):
        done = set()
        for name in ("full stage", "full pair", "powered"):
            model = MODELS[name]()
            whole = lines_of(outcome(model))
            known, found, told = set(whole), {}, {}
            for what, changed in changes(model):
                if what in done:  # of another model
                    continue
                done.add(what)
                lines = lines_of(outcome(changed))
                left = set(lines)
                text = [[line for line in lines if line not in known], sum(line not in left for line in whole)]
                found[what] = told.setdefault(json.dumps(text), text)
            self.check(f"{name}, changed", found)

    def test_load_cases(self):
        model = MODELS["stage, load cases"]()
        whole = lines_of(outcome(model))
        known, found = set(whole), {}
        for what, changed in changes(model):
            if what.startswith(("load case", "more gear_unit")):
                found[what] = [line for line in lines_of(outcome(changed)) if line not in known]
        self.check("load cases, changed", found)

    def test_as_printed(self):
        """What the command prints of each."""
        said = {}
        for name in ("stage", "pair", "coaxial", "worm", "powered"):
            with tempfile.TemporaryDirectory() as folder:
                file = MODELS[name]().write(pathlib.Path(folder, "model.rexs"))
                answer = program.within(command.main, file, "-o", f"{folder}/out")
                said[name] = [answer.returncode, answer.stdout.replace(folder, "DIR").splitlines(), answer.stderr.replace(folder, "DIR").splitlines()]
        with tempfile.TemporaryDirectory() as folder:
            rexs_files.shelf_bearing().write(pathlib.Path(folder, "bearings.rexs"))
            rexs_files.shelf_shaft().write(pathlib.Path(folder, "shafts.rexs"))
            for name, model in (("shelf", rexs_files.on_the_shelf()), ("empty shelf", rexs_files.on_the_shelf("./none.rexs", 61, "./shafts.rexs", 31))):
                file = model.write(pathlib.Path(folder, f"{name}.rexs"))
                answer = program.within(command.main, file, "--json")
                said[name] = [answer.returncode, json.loads(answer.stdout.replace(folder, "DIR")) if answer.stdout else "", answer.stderr.replace(folder, "DIR").splitlines()]
        self.check("words", said)
        printed = io.StringIO()
        report = {"source": "s", "version": "1.5", "application": "", "stages": [], "pairs": [], "taken": [1], "missing": [{"case": "c", "key": "k", "reason": "r", "instead": 3}, {"case": "c", "key": "l", "reason": "q", "instead": None}],
                  "left_out": [1, 2], "notes": ["n"], "shafts": [{"type": "shaft", "component": 3, "name": "S", "figures": {}}, {"type": "shaft", "component": 4, "name": "T", "figures": {"speed_rpm": 12.5, "outside_diameters_mm": [3.0, 4.5]}}],
                  "bearings": [{"type": "b", "component": 5, "name": "B", "case": None, "problems": ["p", "q"], "figures": {"bore_mm": 3.0, "C_kN": 4.0, "C0_kN": 5.5, "e": 0.3, "Y1": 2.0, "rows": 2, "contact_angle_deg": 14.5, "e_C": 0.5, "C_u_kN": 0.7, "Y2": 3.0}},
                               {"type": "b", "component": 6, "name": "C", "case": "c", "problems": [], "lives": {"L10h": 3.3, "L10mh": 4.4},
                                "load_cases": [{"load_case": "7", "share": 0.25, "figures": {"radial_force_N": 1.5, "axial_force_N": 2.5}}, {"load_case": "", "share": None, "figures": {"radial_force_N": 3.5, "axial_force_N": 4.5}}]}]}
        with contextlib.redirect_stdout(printed):
            command.print_summary(report, pathlib.Path("DIR"))
        self.check("summary", printed.getvalue().splitlines())

    def test_results(self):
        """Files of each version and form with the results of runs that are made up: each column a number of its own."""
        columns = sorted({one.column for one in results.RESULTS})
        row = {column: 100.0 + 7.77 * i for i, column in enumerate(columns)} | {"status": "ok", "input_speed_rpm": 22.0}
        arrays = {"bearing_load": [900.0, 1100.0], "bearing_L10h": [90.0, 110.0], "bearing_L10rh": [80.0, 120.0], "bearing_L10mh": [70.0, 130.0], "bearing_L10mrh": [60.0, 140.0],
                  "angle": [0.1 * i for i in range(4)], "lamina_place": [-0.01, 0.0, 0.01], "inner_lamina_load": [[1.0 + i + 10 * j for j in range(3)] for i in range(4)],
                  "outer_lamina_load": [[2.0 + i + 20 * j for j in range(3)] for i in range(4)]}

        class Resolved:
            values = {"input.speed": 2.3, "bearing.per_planet": 2, "bearing.rollers": 4, "bearing.laminae": 3, "gearset.planets": 3, "bearing.roller_length": 0.05, "bearing.roller_diameter": 0.038}

            def value(self, path):
                return self.values[path]

            def model(self):
                return "planetary-drivetrain"

        found = {}
        for name, version, form, case in (("stage", "1.0", ".rexs", "planetenstufe_9"), ("stage", "1.4", ".rexsj", "planetenstufe_9"), ("stage", "1.6", ".rexs", "planetenstufe_9"),
                                          ("stage", "2.0", ".rexs", "planetenstufe_9"), ("coaxial", "1.6", ".rexs", "6210_2z_front_load_case_2"), ("coaxial", "1.7", ".rexsj", "6210_2z_front_load_case_3")):
            model = rexs_files.planetary(version, "°" if version == "1.0" else "deg") if name == "stage" else rexs_files.coaxial_gearbox(version)
            with tempfile.TemporaryDirectory() as folder:
                file = model.write(pathlib.Path(folder, f"model{form}"))
                content = file.read_bytes()
                read = reading.read(file)
                conversion = convert.convert(read, file.name, reading.form_of(content))
                for more, without in (("", ()), (", mean", ("bearing_L10h", "bearing_L10mh")), (", no laminae", results.LAMINAE)):
                    document = (results._Json if form == ".rexsj" else results._Xml)(content)
                    run = results.Run(pathlib.Path("run"), case, row, {key: value for key, value in arrays.items() if key not in without}, Resolved())
                    try:
                        said = results._write_run(read, document, conversion, run)
                    except (CaseError, KeyError, TypeError, AttributeError, ValueError) as error:
                        found[f"{name} {version} {form}{more}"] = f"{type(error).__name__}: {error}".replace(folder, "DIR")
                        continue
                    lines = document.bytes().decode("utf-8-sig").replace("><", ">\n<").replace("}, {", "},\n{").replace('{"id"', '\n{"id"').splitlines()
                    before = set(content.decode("utf-8-sig").replace("><", ">\n<").replace("}, {", "},\n{").replace('{"id"', '\n{"id"').splitlines())
                    found[f"{name} {version} {form}{more}"] = [said if isinstance(said, (dict, list, str, int, float, type(None))) else str(said), [line for line in lines if line not in before]]
        self.check("results", found)

    @unittest.skipIf(kept_records.LEFT_TO_FULL, "left to tools/test --full")
    def test_attributes(self):
        """Units of each attribute, and what numbers of other units are."""
        found = {}
        for name, known in sorted(vars(names).items()):
            if isinstance(known, (dict, tuple, frozenset, set)) and name.isupper():
                found[name] = str(sorted(map(str, known)) if isinstance(known, (set, frozenset)) else known)
        self.check("names", found)


if __name__ == "__main__":
    kept_records.main(RECORDS)
