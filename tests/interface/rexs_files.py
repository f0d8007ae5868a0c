"""REXS files of our own making for the tests of `orbearing convert`: a planetary stage with its bearings and load cases, and a two-shaft gearbox."""

import base64
import json
import struct
import zipfile

PLANETS = 3
SUN, RING, PLANET, CARRIER, CASING, UNIT, STAGE = 11, 12, 21, 31, 2, 1, 9
BEARING = 501


class Rexs:
    """A model as lists; `degree` and `none` are the spellings of a version."""

    def __init__(self, version="1.4", degree="deg", none="none"):
        self.version, self.degree, self.none = version, degree, none
        self.components, self.relations, self.load_cases = [], [], []

    def add(self, number, kind, name="", **attributes):
        """A component; attributes are (value, unit) or a value without unit."""
        rows = [(key, *(value if isinstance(value, tuple) else (value, self.none))) for key, value in attributes.items()]
        self.components.append((number, kind, name, rows))
        return number

    def relate(self, kind, **roles):
        self.relations.append((kind, list(roles.items())))

    def load_case(self, number, parts):
        """Parts: (component, type, attributes)."""
        self.load_cases.append((number, parts))

    def degrees(self, value):
        return (value, self.degree)

    # Forms

    def xml(self, coded=None, mark=True):
        """The text; lists coded as float32 or float64 on request."""
        lines = ['<?xml version="1.0" encoding="UTF-8"?>', f'<model applicationId="Prüfstand" applicationVersion="1" date="2026-01-01T00:00:00+00:00" version="{self.version}">',
                 "  <relations>"]
        for i, (kind, roles) in enumerate(self.relations):
            refs = "".join(f'<ref id="{component}" role="{role}"/>' for role, component in roles)
            lines.append(f'    <relation id="{i + 1}" type="{kind}">{refs}</relation>')
        lines += ["  </relations>", "  <components>", "    <!-- a comment that stays -->"]
        lines += [self._xml_component(one, coded) for one in self.components]
        lines.append("  </components>")
        if self.load_cases:
            lines.append('  <load_spectrum id="1">')
            for number, parts in self.load_cases:
                inner = "".join(self._xml_component((component, kind, "", rows), None) for component, kind, rows in parts)
                lines.append(f'    <load_case id="{number}">{inner}</load_case>')
            lines.append("  </load_spectrum>")
        return ("\ufeff" if mark else "") + "\n".join([*lines, "</model>", ""])

    def _xml_component(self, component, coded):
        number, kind, name, rows = component
        inner = "".join(f'<attribute id="{key}" unit="{unit}">{_xml_value(value, coded)}</attribute>' for key, value, unit in rows)
        return f'    <component id="{number}" name="{name}" type="{kind}">{inner}</component>'

    def json(self, coded=None):
        model = {"version": self.version, "applicationId": "Prüfstand", "applicationVersion": "1", "date": "2026-01-01T00:00:00+00:00",
                 "relations": [{"id": i + 1, "type": kind, "refs": [{"id": component, "role": role} for role, component in roles]}
                               for i, (kind, roles) in enumerate(self.relations)],
                 "components": [{"id": number, "type": kind, "name": name, "attributes": [_json_attribute(row, coded) for row in rows]}
                                for number, kind, name, rows in self.components]}
        if self.load_cases:
            model["load_spectrum"] = {"id": 1, "load_cases": [
                {"id": number, "components": [{"id": component, "type": kind, "attributes": [_json_attribute(row, None) for row in rows]}
                                              for component, kind, rows in parts]} for number, parts in self.load_cases]}
        return json.dumps({"model": model}, ensure_ascii=False)

    def write(self, file, coded=None):
        """By the ending of the file's name."""
        if file.suffix == ".rexsj":
            file.write_text("\ufeff" + self.json(coded), encoding="utf-8")
        elif file.suffix == ".rexsz":
            with zipfile.ZipFile(file, "w") as archive:
                archive.writestr("Modell/größe.rexs", self.xml(coded))
                archive.writestr("notes.txt", "beside the model")
        else:
            file.write_text(self.xml(coded), encoding="utf-8")
        return file


def coded_text(values, code):
    return base64.b64encode(struct.pack(f"<{len(values)}{'f' if code == 'float32' else 'd'}", *values)).decode()


def _xml_value(value, coded):
    if isinstance(value, bool):
        return "true" if value else "false"
    if not isinstance(value, list):
        return str(value)
    if coded and all(isinstance(one, float) for one in value):
        return f'<array code="{coded}">{coded_text(value, coded)}</array>'
    return "<array>" + "".join(f"<c>{_xml_value(one, None)}</c>" for one in value) + "</array>"


def _json_attribute(row, coded):
    key, value, unit = row
    if isinstance(value, list) and coded and all(isinstance(one, float) for one in value):
        return {"id": key, "unit": unit, "floating_point_array_coded": {"code": coded, "value": coded_text(value, coded)}}
    kind = "boolean" if isinstance(value, bool) else "integer" if isinstance(value, int) else "floating_point" if isinstance(value, float) else "string"
    if isinstance(value, list):
        kind = "boolean_array" if isinstance(value[0], bool) else "floating_point_array"
    return {"id": key, "unit": unit, kind: value}


def planetary(version="1.4", degree="deg", bearing="detailed", ring_shift=-0.9737, torque=(325541.0, "N m"), speed=(22.0, "1 / min"), helix=7.5,
              load_cases=False):
    """The stage of cases/wind_stage_750kW: 21/39/99, module 10, driven at the carrier; two cylindrical roller bearings in each planet."""
    model = Rexs(version, degree)
    new, deg = version != "1.0", model.degrees
    model.add(UNIT, "gear_unit", "Getriebe", u_axis_vector=([1.0, 0.0, 0.0], "mm"))
    model.add(CASING, "gear_casing", "Gehäuse", temperature_lubricant=(65.0, "C"))
    model.add(3, "lubricant", "ISO VG 320", viscosity_at_40_degree_celsius=(320.0, "mm^2 / s"), viscosity_at_100_degree_celsius=(24.0, "mm^2 / s"))
    model.add(4, "material", "Stahl", elastic_modulus=(206000.0, "N / mm^2"), poisson_ratio=0.3, density=(7.85, "kg / dm^3"))
    model.add(STAGE, "planetary_stage", "Planetenstufe [9]")
    model.add(CARRIER, "planet_carrier", "Planetenträger 1,5", mass_of_component=(4000.0, "kg"))
    shafts = {13: "Sonnenwelle", 14: "Hohlradwelle", 15: "Stegwelle"}
    for number, name in shafts.items():
        more = {} if number != 15 or load_cases else {"rotational_speed": speed}
        model.add(number, "shaft", name, support_vector=([0.0, 0.0, 0.0], "mm"), **more)
    model.add(5, "external_load", "Rotor", defines_torque=True, **({} if load_cases else {"torque_around_u_axis": torque}))
    model.add(6, "external_load", "Abtrieb", transmits_torque=True)
    model.add(7, "coupling", "Gehäusekopplung", radial_stiffness=(1.0e20, "N / m"), axial_stiffness=(9.999999999999999e22, "N / m"))
    model.relate("side", assembly=7, inner_part=14, outer_part=CASING)
    for whole, part in ((13, 6), (15, 5), (13, SUN), (14, RING), (STAGE, CARRIER), (CARRIER, 15)):
        model.relate("assembly", assembly=whole, part=part)
    model.relate("central_shaft", planetary_stage=STAGE, shaft=13)
    model.relate("central_shaft", planetary_stage=STAGE, shaft=14)
    model.relate("planet_carrier_shaft", planetary_stage=STAGE, shaft=15)
    model.relate("reference", origin=CASING, referenced=3)
    gear = {"normal_module": (10.0, "mm"), "support_vector": ([0.0, 0.0, 0.0], "mm")}
    model.add(SUN, "cylindrical_gear", "Sonne", number_of_teeth=21, face_width=(220.0, "mm"), helix_angle_reference_diameter=deg(helix), **gear)
    model.add(RING, "ring_gear", "Hohlrad", number_of_teeth=99, face_width=(230.0, "mm"), helix_angle_reference_diameter=deg(-helix), **gear)
    flank = "cylindrical_gear_flank" if version >= "1.3" else "flank_geometry"
    for gear_id, shift in ((SUN, 0.1763), (RING, ring_shift)):
        for side in (1, 2):
            model.add(gear_id * 10 + side, flank, "", normal_pressure_angle=deg(20.0), addendum_modification_coefficient=shift)
        model.relate("flank", gear=gear_id, left=gear_id * 10 + 1, right=gear_id * 10 + 2)
        model.relate("reference", origin=gear_id, referenced=4)
    for i in range(PLANETS):
        _planet(model, i, flank, new, deg, helix, bearing)
    if load_cases:
        for number, share, power, rpm in ((1, 25.0, 750.0, 22.0), (2, 60.0, 400.0, 18.0), (3, 15.0, 100.0, 10.0)):
            time = "operating_time_fraction" if version >= "1.3" else "load_duration_fraction"
            newton_metres = 1e3 * power / (rpm * 3.141592653589793 / 30.0)
            model.load_case(number, [(UNIT, "gear_unit", [(time, share, "%")]), (15, "shaft", [("rotational_speed", rpm, "1 / min")]),
                                     (5, "external_load", [("torque_around_u_axis", newton_metres, "N m")])])
    return model


def _planet(model, i, flank, new, deg, helix, bearing):
    import math

    angle = 2.0 * math.pi * i / PLANETS
    gear, shaft, pin = PLANET + i, 41 + i, 51 + i
    place = [0.0, 308.0 * math.cos(angle), 308.0 * math.sin(angle)]
    model.add(shaft, "shaft", f"Planetenwelle @ {120 * i},0°", support_vector=(place, "mm"))
    model.add(pin, "shaft", f"Bolzen @ {120 * i},0°", support_vector=(place, "mm"))
    model.relate("planet_shaft", planetary_stage=STAGE, shaft=shaft)
    model.relate("planet_pin", planetary_stage=STAGE, shaft=pin)
    model.add(gear, "cylindrical_gear", f"Planet @ {120 * i},0°", number_of_teeth=39, normal_module=(10.0, "mm"), face_width=(227.5, "mm"),
              helix_angle_reference_diameter=deg(-0.0 if helix == 0.0 else -helix), u_coordinate_on_shaft=(113.75, "mm"))
    model.relate("assembly", assembly=shaft, part=gear)
    model.relate("reference", origin=gear, referenced=4)
    for side in (1, 2):
        model.add(gear * 10 + side, flank, "", normal_pressure_angle=deg(20.0), addendum_modification_coefficient=0.3987)
    model.relate("flank", gear=gear, left=gear * 10 + 1, right=gear * 10 + 2)
    for offset, central in ((61, SUN), (71, RING)):
        model.add(offset + i, "cylindrical_stage", "", center_distance=(308.0, "mm"))
        model.relate("assembly", assembly=STAGE, part=offset + i)
        model.relate("stage", stage=offset + i, gear_1=central, gear_2=gear)
    for wall in range(2):
        model.add(81 + 2 * i + wall, "coupling", "", u_coordinate_on_shaft_inner_side=(10.0 + 280.0 * wall, "mm"), bending_stiffness=(1e20, "N mm / rad"))
        model.relate("side", assembly=81 + 2 * i + wall, inner_part=pin, outer_part=CARRIER)
    for j, along in enumerate((58.75, 168.75)):
        _bearing(model, BEARING + 10 * i + j, shaft, pin, along, new, bearing)


def _bearing(model, number, shaft, pin, along, new, bearing):
    places = {"u_coordinate_on_shaft_outer_side": (along, "mm"), "u_coordinate_on_shaft_inner_side": (along + 40.0, "mm")}
    if bearing == "concept":
        model.add(number, "concept_bearing", "Planetenlager", radial_stiffness=(1e20, "N / m"), **places)
    else:
        rating, static = ("radial_dynamic_load_rating", "radial_static_load_rating") if new else ("dynamic_capacity", "static_capacity")
        clearance = "operating_radial_bearing_clearance" if new else "radial_backlash"
        size = {"inner_diameter": (160.0, "mm"), "outer_diameter": (290.0, "mm"), "width": (80.0, "mm"), rating: (930.0, "kN"), static: (1200.0, "kN"),
                clearance: (60.0, "mum"), "bearing_type": "radial_roller_bearing"}
        if bearing == "designation":
            size = {"catalogue_designation": "NU 2210-ECP", "bearing_type": "radial_roller_bearing", clearance: (60.0, "mum")}
        model.add(number, "rolling_bearing_with_catalog_geometry", "Planetenlager", **size, **places)
        if bearing == "detailed":
            pitch = "reference_diameter_rolling_bearing" if model.version >= "2" else "reference_diameter"
            model.add(number + 1000, "rolling_bearing_row", "", number_of_rolling_elements=16, **{pitch: (225.0, "mm")})
            model.add(number + 2000, "rolling_element", "", diameter_of_rolling_element=(38.0, "mm"), length_of_rolling_element=(58.0, "mm"),
                      roller_crowning_radius=(20000.0, "mm"))
            model.relate("ordered_assembly", assembly=number, part=number + 1000)
            model.relate("ordered_assembly", assembly=number + 1000, part=number + 2000)
    model.relate("side", assembly=number, inner_part=pin, outer_part=shaft)


def two_stages():
    """Two such stages in a row: the sun's shaft of the first drives the carrier of the second."""
    model, second = planetary(), planetary()
    shared, offset = (UNIT, CASING, 3, 4), 5000
    moved = {number: number if number in shared else number + offset for number, _, _, _ in second.components}
    dropped = {6, moved[5]}  # the load between the stages, and the second rotor
    model.components += [(moved[number], kind, name, [] if number == 15 else rows) for number, kind, name, rows in second.components if number not in shared]
    model.relations += [(kind, [(role, moved[component]) for role, component in roles]) for kind, roles in second.relations]
    model.components = [one for one in model.components if one[0] not in dropped]
    model.relations = [(kind, roles) for kind, roles in model.relations if not dropped & {component for _, component in roles}]
    model.add(9000, "coupling", "Kupplung")
    model.relate("side", assembly=9000, inner_part=13, outer_part=moved[15])
    return model


def gearbox():
    """One helical pair on two shafts, each on two deep groove ball bearings: 20/40, module 2, width 20; 100 N m at 1000 rpm on the pinion's shaft."""
    model = Rexs("1.7")
    model.add(UNIT, "gear_unit", "Gearbox", u_axis_vector=([1.0, 0.0, 0.0], "mm"))
    model.add(CASING, "gear_casing", "Casing")
    model.add(3, "external_load", "Motor", torque_around_u_axis=(50.0, "N m"), u_coordinate_on_shaft=(0.0, "mm"), defines_torque=True)
    model.add(4, "external_load", "Load", u_coordinate_on_shaft=(100.0, "mm"))
    model.add(10, "cylindrical_stage", "Stage", center_distance=(60.0, "mm"))
    for i, (teeth, place) in enumerate(((20, 0.0), (40, 60.0))):
        shaft, gear = 5 + i, 7 + i
        model.add(shaft, "shaft", f"Shaft {i + 1}", support_vector=([0.0, place, 0.0], "mm"), **({"rotational_speed": (1000.0, "1 / min")} if i == 0 else {}))
        model.add(20 + i, "shaft_section", "", u_coordinate_on_shaft=(0.0, "mm"), length=(100.0, "mm"), outer_diameter_begin=(25.0, "mm"))
        model.add(gear, "cylindrical_gear", f"Gear {i + 1}", number_of_teeth=teeth, normal_module=(2.0, "mm"), face_width=(20.0 + i, "mm"),
                  helix_angle_reference_diameter=(0.0, "deg"), u_coordinate_on_shaft=(50.0, "mm"), support_vector=([50.0, place, 0.0], "mm"))
        for side in (1, 2):
            model.add(gear * 10 + side, "cylindrical_gear_flank", "", normal_pressure_angle=(20.0, "deg"), addendum_modification_coefficient=0.0)
        model.relate("flank", gear=gear, left=gear * 10 + 1, right=gear * 10 + 2)
        for part in (20 + i, gear, 3 + i):
            model.relate("assembly", assembly=shaft, part=part)
        for j, along in enumerate((20.0, 80.0)):
            number = 30 + 10 * i + j
            model.add(number, "rolling_bearing_with_catalog_geometry", f"6205 Lager {number}", catalogue_designation="6205",
                      bearing_type="radial_grooved_ball_bearing", axial_force_absorption="both_directions" if j == 0 else "no_direction",
                      radial_clearance_class="C3", u_coordinate_on_shaft_inner_side=(along, "mm"))
            model.relate("side", assembly=number, inner_part=shaft, outer_part=CASING)
    model.relate("stage", stage=10, gear_1=7, gear_2=8)
    return model


def _gear(model, number, shaft, teeth, module, width, helix, shift, along, **more):
    """A cylindrical gear with its middle at `along` of its shaft, both flanks with the same shift."""
    model.add(number, "cylindrical_gear", f"Gear {number}", number_of_teeth=teeth, normal_module=(module, "mm"), face_width=(width, "mm"),
              helix_angle_reference_diameter=model.degrees(helix), u_coordinate_on_shaft=(along, "mm"), **more)
    for side in (1, 2):
        model.add(10 * number + side, "cylindrical_gear_flank", "", normal_pressure_angle=model.degrees(20.0), addendum_modification_coefficient=shift)
    model.relate("flank", gear=number, left=10 * number + 1, right=10 * number + 2)
    model.relate("assembly", assembly=shaft, part=number)


def _sections(model, shaft, number, *pieces):
    """Length and outside diameter [mm] of each piece of a shaft, one after the other."""
    along = 0.0
    for i, (length, diameter) in enumerate(pieces):
        model.add(number + i, "shaft_section", "", u_coordinate_on_shaft=(along, "mm"), length=(length, "mm"), outer_diameter_begin=(diameter, "mm"),
                  outer_diameter_end=(diameter, "mm"))
        model.relate("assembly", assembly=shaft, part=number + i)
        along += length


# share [%], input speed [rpm] and torque [N m], forces on the input shaft (v) and on the output shaft (u, v) [N]
COAXIAL_LOADS = ((20.0, 543.0, 567.0, 456.0, 0.0, 123.0), (30.0, 3456.0, 345.0, 678.0, 123.0, 0.0), (35.0, 1234.0, 456.0, 876.0, 0.0, 345.0),
                 (15.0, 789.0, 789.0, 1233.0, 567.0, 0.0))


def coaxial_gearbox(version="1.6", places=True):
    """Two stages, 27/51 and 23/34, whose input and output shafts are in line, a needle cage between both; four load cases. `places`: of gears in space."""
    model = Rexs(version)
    model.add(UNIT, "gear_unit", "Unit", u_axis_vector=([1.0, 0.0, 0.0], "mm"))
    model.add(CASING, "gear_casing", "Casing", temperature_lubricant=(70.0, "C"))
    model.add(3, "lubricant", "Oil", viscosity_at_40_degree_celsius=(100.0, "mm^2 / s"), viscosity_at_100_degree_celsius=(11.0, "mm^2 / s"))
    model.relate("reference", origin=CASING, referenced=3)
    entry, middle, leaving = 5, 6, 7
    for shaft, name, place in ((entry, "Input", [-70.0, 0.0, 0.0]), (middle, "Middle", [-25.0, 0.0, -190.0]), (leaving, "Output", [90.0, 0.0, 0.0])):
        model.add(shaft, "shaft", name, support_vector=(place, "mm"), u_axis_vector=([1.0, 0.0, 0.0], "mm"), w_axis_vector=([0.0, 0.0, 1.0], "mm"),
                  defines_speed=shaft == entry)
    _sections(model, entry, 20, (80.0, 50.0), (80.0, 60.0), (30.0, 50.0))
    _sections(model, middle, 25, (45.0, 80.0), (60.0, 90.0), (165.0, 80.0))
    _sections(model, leaving, 30, (113.0, 70.0), (10.0, 80.0), (100.0, 60.0))
    def at(*place):
        return {"support_vector": (list(place), "mm")} if places else {}

    _gear(model, 11, entry, 27, 4.5, 50.0, 21.0, 0.231415, 117.0, **at(47.0, 0.0, 0.0))
    _gear(model, 12, middle, 51, 4.5, 50.0, -21.0, 0.231415, 72.0, **at(47.0, 0.0, -190.0))
    _gear(model, 13, middle, 23, 6.5, 74.0, -10.0, 0.15074, 180.0, tip_diameter=(1.0, "mm"), **at(155.0, 0.0, -190.0))
    _gear(model, 14, leaving, 34, 6.5, 74.0, 10.0, 0.15074, 65.0, **at(155.0, 0.0, 0.0))
    for number, first, second in ((8, 11, 12), (9, 13, 14)):
        model.add(number, "cylindrical_stage", f"Stage {number}", center_distance=(190.0, "mm"))
        model.relate("stage", stage=number, gear_1=first, gear_2=second)
    size = {"radial_force_absorption": True}
    model.add(40, "rolling_bearing_with_catalog_geometry", "6210-2Z front", catalogue_designation="6210-2Z", bearing_type="radial_grooved_ball_bearing", manufacturer="FAG",
              contamination_factor_according_to_iso_281_2007=0.5, axial_force_absorption="both_directions", u_coordinate_on_shaft_inner_side=(65.0, "mm"),
              u_coordinate_on_shaft_outer_side=(65.0, "mm"), **size)
    for number, kind, along, way in ((41, "33014", 15.2204, "negative"), (42, "33012", 137.958, "positive")):
        model.add(number, "rolling_bearing_with_catalog_geometry", f"{kind} tapered", catalogue_designation=kind, bearing_type="radial_tapered_roller_bearing",
                  axial_force_absorption=way, u_coordinate_on_shaft_inner_side=(along, "mm"), u_coordinate_on_shaft_outer_side=(along + 160.0, "mm"), **size)
    model.add(43, "concept_bearing", "K 50x58x25 cage", axial_force_absorption="no_direction", u_coordinate_on_shaft_inner_side=(175.0, "mm"),
              u_coordinate_on_shaft_outer_side=(15.0, "mm"), **size)
    for number, along, way in ((44, 20.0, "negative"), (45, 250.0, "positive")):
        model.add(number, "concept_bearing", f"33016 at {along:g}", axial_force_absorption=way, u_coordinate_on_shaft_inner_side=(along, "mm"),
                  u_coordinate_on_shaft_outer_side=(along, "mm"), **size)
    for number, inner, outer in ((40, entry, CASING), (41, leaving, CASING), (42, leaving, CASING), (43, entry, leaving), (44, middle, CASING), (45, middle, CASING)):
        model.relate("side", assembly=number, inner_part=inner, outer_part=outer)
    for number, shaft, along, torque in ((50, entry, 0.0, True), (51, leaving, 170.0, True), (52, entry, 0.0, False), (53, leaving, 170.0, False)):
        model.add(number, "external_load", f"Load {number}", u_coordinate_on_shaft=(along, "mm"), transmits_torque=torque, defines_torque=number == 50)
        model.relate("assembly", assembly=shaft, part=number)
    for i, (share, speed, torque, front, along, across) in enumerate(COAXIAL_LOADS):
        model.load_case(i + 1, [(UNIT, "gear_unit", [("operating_time_fraction", share, "%")]), (entry, "shaft", [("rotational_speed", speed, "1 / min")]),
                                (50, "external_load", [("torque_around_u_axis", torque, "N m")]),
                                (52, "external_load", [("force_u_direction", 0.0, "N"), ("force_v_direction", front, "N"), ("force_w_direction", 0.0, "N")]),
                                (53, "external_load", [("force_u_direction", along, "N"), ("force_v_direction", across, "N"), ("force_w_direction", 0.0, "N")])])
    return model


def powered_planets():
    """A stage of 17/22/61 teeth whose sun states power and speed and no torque; the ring is held by switchable couplings."""
    model = Rexs("1.4")
    model.add(UNIT, "gear_unit", "Unit", u_axis_vector=([1.0, 0.0, 0.0], "mm"))
    model.add(CASING, "gear_casing", "Casing", temperature_lubricant=(80.0, "C"))
    model.add(3, "lubricant", "ISO-VG-100", viscosity_at_40_degree_celsius=(100.0, "mm^2 / s"), viscosity_at_100_degree_celsius=(11.0, "mm^2 / s"))
    model.relate("reference", origin=CASING, referenced=3)
    model.add(STAGE, "planetary_stage", "Planetary stage [9]")
    model.add(CARRIER, "planet_carrier", "Carrier")
    for number, name, more in ((13, "Sun shaft", {"rotational_speed": (1500.0, "1 / min"), "defines_speed": True}), (14, "Ring shaft", {}), (15, "Carrier shaft", {})):
        model.add(number, "shaft", name, support_vector=([0.0, 0.0, 0.0], "mm"), **more)
    model.add(5, "external_load", "Motor", power=(100.0, "kW"), transmits_torque=True, defines_torque=True)
    model.add(6, "external_load", "Machine", transmits_torque=True)
    for number in (16, 17):
        model.add(number, "switchable_coupling", "Coupling", is_engaged=[True], rotational_stiffness=(1e20, "N mm / rad"))
        model.relate("side", assembly=number, inner_part=14, outer_part=CASING)
    for whole, part in ((13, 5), (15, 6), (STAGE, CARRIER), (CARRIER, 15)):
        model.relate("assembly", assembly=whole, part=part)
    for shaft in (13, 14):
        model.relate("central_shaft", planetary_stage=STAGE, shaft=shaft)
    model.relate("planet_carrier_shaft", planetary_stage=STAGE, shaft=15)
    _gear(model, 18, 13, 17, 4.0, 50.0, 0.0, 0.0, 25.0)
    model.add(19, "ring_gear", "Ring", number_of_teeth=61, normal_module=(4.0, "mm"), face_width=(50.0, "mm"), helix_angle_reference_diameter=(0.0, "deg"))
    for side in (1, 2):
        model.add(190 + side, "cylindrical_gear_flank", "", normal_pressure_angle=(20.0, "deg"))
    model.relate("flank", gear=19, left=191, right=192)
    model.relate("assembly", assembly=14, part=19)
    for i in range(PLANETS):
        model.add(41 + i, "shaft", f"Planet shaft {i + 1}", support_vector=([0.0, 0.0, 78.0], "mm"))
        model.relate("planet_shaft", planetary_stage=STAGE, shaft=41 + i)
        _gear(model, 21 + i, 41 + i, 22, 4.0, 50.0, -0.0, 0.0, 25.0)
        for offset, central in ((61, 18), (71, 19)):
            model.add(offset + i, "cylindrical_stage", "", center_distance=(78.0, "mm"))
            model.relate("assembly", assembly=STAGE, part=offset + i)
            model.relate("stage", stage=offset + i, gear_1=central, gear_2=21 + i)
    return model


def shelf_bearing():
    """A spherical roller bearing of a library, with sizes and ratings: 22206 E, component 60."""
    library = Rexs("1.5")
    library.add(60, "rolling_bearing_with_catalog_geometry", "of the shelf", catalogue_designation="22206 E", bearing_type="radial_self_aligning_roller_bearing",
                inner_diameter=(30.0, "mm"), outer_diameter=(62.0, "mm"), width=(20.0, "mm"), number_of_bearing_rows=2, radial_dynamic_load_rating=(66.1, "kN"),
                radial_static_load_rating=(60.0, "kN"), fatigue_limit_load=(6.4, "kN"), contamination_factor_according_to_iso_281_2007=0.5, catalogue_value_e=0.31,
                axial_factor_y_1=2.2, axial_factor_y_2=3.3)
    for number in (80, 90):
        library.add(number, "rolling_bearing_row", "", pressure_angle=(11.68, "deg"))
        library.relate("ordered_assembly", assembly=60, part=number)
    return library


def shelf_shaft():
    """A shaft of two sections of a library: component 30, of the material 50."""
    library = Rexs("1.5")
    library.add(30, "shaft", "of the shelf")
    library.add(50, "material", "Steel", elastic_modulus=(210000.0, "N / mm^2"))
    library.relate("reference", origin=30, referenced=50)
    _sections(library, 30, 100, (50.0, 30.0), (50.0, 50.0))
    return library


def on_the_shelf(bearing="./bearings.rexs", bearing_id=60, shaft="./shafts.rexs", shaft_id=30):
    """A shaft and its bearing that are in other files."""
    model = Rexs("1.5")
    model.add(UNIT, "gear_unit", "Unit")
    model.add(CASING, "gear_casing", "Casing")
    model.add(3, "shaft", "Shaft [3]", data_source=shaft, referenced_component_id=shaft_id, support_vector=([0.0, 0.0, 0.0], "mm"))
    model.add(6, "rolling_bearing_with_catalog_geometry", "Rolling bearing [6]", data_source=bearing, referenced_component_id=bearing_id,
              axial_force_absorption="negative", u_coordinate_on_shaft_inner_side=(40.0, "mm"))
    model.relate("side", assembly=6, inner_part=3, outer_part=CASING)
    return model


def worm_gearbox():
    """A worm and its wheel on two shafts, each in two bearings without an inside."""
    model = Rexs("1.4")
    model.add(UNIT, "gear_unit", "Getriebe größer")
    model.add(CASING, "gear_casing", "Gehäuse")
    model.add(3, "worm_stage", "Schneckenstufe [3]")
    for i, kind in enumerate(("worm_gear", "worm_wheel")):
        model.add(4 + i, "shaft", f"Welle [{4 + i}]")
        model.add(8 + i, kind, f"Rad [{8 + i}]", number_of_teeth=(2, 40)[i])
        model.relate("assembly", assembly=4 + i, part=8 + i)
        for j in range(2):
            model.add(14 + 2 * i + j, "concept_bearing", f"Wälzlager [{14 + 2 * i + j}]")
            model.relate("side", assembly=14 + 2 * i + j, inner_part=4 + i, outer_part=CASING)
    model.relate("stage", stage=3, gear_1=8, gear_2=9)
    model.load_case(1, [(UNIT, "gear_unit", [("load_duration_fraction", "30.0", "none")])])
    return model
