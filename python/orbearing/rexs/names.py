"""Attributes of REXS that a case takes, by the name that this package gives them, and the units of both sides.

Every number of a file is read by number_of() or place_of(), which return SI; quantity() writes SI in the unit of a case.
No other function of this package converts a unit of a file. Angles are in rad, speeds in rad/s, temperatures in degC.

Names of attributes changed between versions: each row lists all of them, the newest first. A test compares the table
with the published schemas.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple, Optional

from orbearing.rexs.model import Attribute, Component

LARGEST = 1e100  # of any number in a file; beyond lies a slip
RIGID = 1e15  # [N/m] from here on a stiffness says "rigid"; programs write 1e20 to 1e23
WHOLE = 1e-6  # a number is whole within this; programs write 20.9999999999
SAME_NUMBER = 1e-9  # relative; conversion of units changes the last digits


class Unit(NamedTuple):
    """A quantity, the factor to its SI unit, and what is added then."""

    quantity: str
    factor: float
    offset: float = 0.0


_DEGREE, _RPM = math.pi / 180.0, math.pi / 30.0
# Spellings without spaces, of all versions and of programs that keep their own.
UNITS = {
    **dict.fromkeys(("none", "", "-", "1"), Unit("number", 1.0)),
    "%": Unit("number", 0.01),
    "mm": Unit("length", 1e-3), "cm": Unit("length", 1e-2), "m": Unit("length", 1.0),
    **dict.fromkeys(("mum", "um", "\u00b5m", "\u03bcm"), Unit("length", 1e-6)),
    **dict.fromkeys(("deg", "\u00b0", "degree"), Unit("angle", _DEGREE)), "rad": Unit("angle", 1.0),
    **dict.fromkeys(("1/min", "rpm", "min^-1"), Unit("rotation", _RPM)), "rad/s": Unit("rotation", 1.0),
    "1/s": Unit("rotation", 2.0 * math.pi),
    **dict.fromkeys(("Nm", "N*m", "N.m"), Unit("torque", 1.0)), **dict.fromkeys(("kNm", "kN*m"), Unit("torque", 1e3)),
    **dict.fromkeys(("Nmm", "N*mm"), Unit("torque", 1e-3)),
    "N": Unit("force", 1.0), "kN": Unit("force", 1e3), "MN": Unit("force", 1e6),
    "W": Unit("power", 1.0), "kW": Unit("power", 1e3), "MW": Unit("power", 1e6),
    **dict.fromkeys(("MPa", "N/mm^2"), Unit("stress", 1e6)), "Pa": Unit("stress", 1.0), "GPa": Unit("stress", 1e9),
    **dict.fromkeys(("C", "degC", "\u00b0C"), Unit("temperature", 1.0)), "K": Unit("temperature", 1.0, -273.15),
    "h": Unit("time", 3600.0), "min": Unit("time", 60.0), "s": Unit("time", 1.0),
    "kg": Unit("mass", 1.0), "g": Unit("mass", 1e-3), "t": Unit("mass", 1e3),
    **dict.fromkeys(("kg/dm^3", "g/cm^3"), Unit("density", 1e3)), "kg/m^3": Unit("density", 1.0),
    **dict.fromkeys(("mm^2/s", "cSt"), Unit("viscosity", 1e-6)), "m^2/s": Unit("viscosity", 1.0),
    "N/m": Unit("stiffness", 1.0), "N/mm": Unit("stiffness", 1e3), **dict.fromkeys(("N/mum", "N/um", "kN/mm"), Unit("stiffness", 1e6)),
}
# Units in which a case and the figures of the report state SI.
OURS = {"": 1.0, "mm": 1e-3, "um": 1e-6, "deg": _DEGREE, "rpm": _RPM, "kN": 1e3, "kW": 1e3, "GPa": 1e9, "degC": 1.0, "h": 3600.0, "kg": 1.0,
        "kg/m3": 1.0, "N/m": 1.0}


@dataclass(frozen=True)
class Known:
    """An attribute that is read: its names, newest first, the schema's unit, and the components that have it."""

    names: tuple[str, ...]
    unit: str
    components: tuple[str, ...]
    whole: bool = False  # a count


GEARS = ("cylindrical_gear", "ring_gear")
FLANKS = ("cylindrical_gear_flank", "flank_geometry")
TOOLS = ("rack_shaped_tool", "cutter_wheel_tool")
CATALOGUE = ("rolling_bearing_with_catalog_geometry", "rolling_bearing_with_detailed_geometry")
BEARINGS = (*CATALOGUE, "concept_bearing")
ROW, ELEMENT = ("rolling_bearing_row",), ("rolling_element",)

KNOWN = {
    "teeth": Known(("number_of_teeth",), "none", GEARS, whole=True),
    "module": Known(("normal_module",), "mm", GEARS),
    "helix": Known(("helix_angle_reference_diameter",), "deg", GEARS),
    "face_width": Known(("face_width",), "mm", GEARS),
    "tip_diameter": Known(("tip_diameter",), "mm", GEARS),
    "root_diameter": Known(("root_diameter",), "mm", GEARS),
    "gear_bore": Known(("inner_diameter",), "mm", ("cylindrical_gear",)),
    "mass": Known(("mass_of_component",), "kg", (*GEARS, "planet_carrier")),
    "gear_place": Known(("u_coordinate_on_shaft",), "mm", GEARS),
    "pressure_angle": Known(("normal_pressure_angle",), "deg", FLANKS),
    "shift": Known(("addendum_modification_coefficient",), "none", FLANKS),
    "shift_length": Known(("addendum_modification",), "mm", FLANKS),
    "profile_addendum": Known(("addendum_coefficient_basic_profile",), "none", FLANKS),
    "centre_distance": Known(("center_distance",), "mm", ("cylindrical_stage",)),
    "common_width": Known(("common_face_width",), "mm", ("cylindrical_stage",)),
    "least_backlash": Known(("minimum_normal_backlash",), "mm", ("cylindrical_stage",)),
    "most_backlash": Known(("maximum_normal_backlash",), "mm", ("cylindrical_stage",)),
    "tool_addendum": Known(("addendum_coefficient_reference_profile",), "none", TOOLS),
    "tool_tip_radius": Known(("tip_corner_radius_factor_reference_profile", "tip_radius_factor"), "none", TOOLS),
    "speed": Known(("rotational_speed",), "1 / min", ("shaft",)),
    "defines_torque": Known(("defines_torque",), "none", ("external_load",)),
    "transmits_torque": Known(("transmits_torque",), "none", ("external_load",)),
    "torque": Known(("torque_around_u_axis",), "N m", ("external_load",)),
    "load_force_u": Known(("force_u_direction",), "N", ("external_load",)),
    "load_force_v": Known(("force_v_direction",), "N", ("external_load",)),
    "load_force_w": Known(("force_w_direction",), "N", ("external_load",)),
    "load_torque_v": Known(("torque_around_v_axis",), "N m", ("external_load",)),
    "load_torque_w": Known(("torque_around_w_axis",), "N m", ("external_load",)),
    "load_place": Known(("u_coordinate_on_shaft",), "mm", ("external_load",)),
    "load_power": Known(("power",), "kW", ("external_load",)),
    "gear_shift": Known(("gear_shift_index",), "none", ("gear_unit",), whole=True),
    "share": Known(("operating_time_fraction", "load_duration_fraction"), "%", ("gear_unit",)),
    "duration": Known(("operating_time", "load_duration"), "h", ("gear_unit",)),
    "oil_temperature": Known(("temperature_lubricant",), "C", ("gear_casing", "cylindrical_stage", *CATALOGUE)),
    "viscosity_40": Known(("viscosity_at_40_degree_celsius",), "mm^2 / s", ("lubricant",)),
    "viscosity_100": Known(("viscosity_at_100_degree_celsius",), "mm^2 / s", ("lubricant",)),
    "oil_density": Known(("density_at_15_degree_celsius",), "kg / dm^3", ("lubricant",)),
    "elastic_modulus": Known(("elastic_modulus",), "N / mm^2", ("material",)),
    "poisson_ratio": Known(("poisson_ratio",), "none", ("material",)),
    "density": Known(("density",), "kg / dm^3", ("material",)),
    "section_length": Known(("length",), "mm", ("shaft_section",)),
    "section_place": Known(("u_coordinate_on_shaft",), "mm", ("shaft_section",)),
    "section_outside": Known(("outer_diameter_begin",), "mm", ("shaft_section",)),
    "section_inside": Known(("inner_diameter_begin",), "mm", ("shaft_section",)),
    "designation": Known(("catalogue_designation", "name"), "none", CATALOGUE),
    "bearing_type": Known(("bearing_type",), "none", CATALOGUE),
    "manufacturer": Known(("manufacturer",), "none", CATALOGUE),
    "rows": Known(("number_of_bearing_rows",), "none", CATALOGUE, whole=True),
    "bore": Known(("inner_diameter",), "mm", BEARINGS),
    "outside": Known(("outer_diameter",), "mm", BEARINGS),
    "width": Known(("width",), "mm", BEARINGS),
    "has_inner_ring": Known(("has_inner_ring",), "none", CATALOGUE),
    "has_outer_ring": Known(("has_outer_ring",), "none", CATALOGUE),
    "inner_place": Known(("u_coordinate_on_shaft_inner_side",), "mm", (*BEARINGS, "coupling")),
    "outer_place": Known(("u_coordinate_on_shaft_outer_side",), "mm", BEARINGS),
    "radial_stiffness": Known(("radial_stiffness",), "N / m", BEARINGS),
    "dynamic_capacity": Known(("radial_dynamic_load_rating", "dynamic_capacity"), "kN", CATALOGUE),
    "static_capacity": Known(("radial_static_load_rating", "static_capacity"), "kN", CATALOGUE),
    "fatigue_limit": Known(("fatigue_limit_load",), "kN", CATALOGUE),
    "catalogue_e": Known(("catalogue_value_e",), "none", CATALOGUE),
    "catalogue_y1": Known(("axial_factor_y_1",), "none", CATALOGUE),
    "catalogue_y2": Known(("axial_factor_y_2",), "none", CATALOGUE),
    "operating_clearance": Known(("operating_radial_bearing_clearance", "radial_backlash"), "mum", CATALOGUE),
    "mounted_clearance": Known(("mounted_radial_bearing_clearance",), "mum", CATALOGUE),
    "shelf_clearance": Known(("radial_bearing_clearance",), "mum", CATALOGUE),
    "least_clearance": Known(("minimum_radial_bearing_clearance", "minimum_bearing_clearance"), "mum", CATALOGUE),
    "most_clearance": Known(("maximum_radial_bearing_clearance", "maximum_bearing_clearance"), "mum", CATALOGUE),
    "clearance_class": Known(("radial_clearance_class", "clearance_class"), "none", CATALOGUE),
    "contamination": Known(("contamination_factor_iso_281_2007", "contamination_factor_according_to_iso_281_2007",
                            "contamination_factor_according_to_din_26281"), "none", CATALOGUE),
    "survival": Known(("survival_probability", "survival_probablity"), "%", CATALOGUE),
    "force_v": Known(("radial_force_in_v",), "kN", BEARINGS),
    "force_w": Known(("radial_force_in_w",), "kN", BEARINGS),
    "force_u": Known(("axial_force",), "kN", BEARINGS),
    "axial_sense": Known(("axial_force_absorption",), "none", BEARINGS),
    "inner_speed": Known(("speed_inner_ring",), "1 / min", CATALOGUE),
    "outer_speed": Known(("speed_outer_ring",), "1 / min", CATALOGUE),
    "elements": Known(("number_of_rolling_elements",), "none", ROW, whole=True),
    "pitch_diameter": Known(("reference_diameter_rolling_bearing", "reference_diameter"), "mm", ROW),
    "contact_angle": Known(("pressure_angle",), "deg", ROW),
    "inner_groove": Known(("raceway_radius_of_inner_ring", "running_path_radius_of_inner_ring"), "mm", ROW),
    "outer_groove": Known(("raceway_radius_of_outer_ring", "running_path_radius_of_outer_ring"), "mm", ROW),
    "inner_contact_length": Known(("significant_contact_length_inner_ring", "significant_width_inner"), "mm", ROW),
    "outer_contact_length": Known(("significant_contact_length_outer_ring", "significant_width_outer"), "mm", ROW),
    "element_diameter": Known(("diameter_of_rolling_element",), "mm", ELEMENT),
    "element_length": Known(("length_of_rolling_element",), "mm", ELEMENT),
    "crown_radius": Known(("roller_crowning_radius", "roller_shell_radius"), "mm", ELEMENT),
}


class Reading(NamedTuple):
    """A number in SI and the attribute that states it; without a number, why there is none."""

    number: Optional[float]
    attribute: Optional[Attribute]
    problem: str = ""


def unit_of(text: str) -> Optional[Unit]:
    """The unit of a spelling, or None where it is not known."""
    return UNITS.get("".join(text.split()).replace("\u00b7", "*"))


def attribute_of(component: Component, name: str) -> Optional[Attribute]:
    """The attribute under any of its names, if it has a value."""
    for spelled in KNOWN[name].names:
        attribute = component.attributes.get(spelled)
        if attribute is not None and attribute.value is not None:
            return attribute
    return None


def in_unit(value: float, unit: str) -> float:
    """A number in SI in a unit of a case or of the report."""
    return value / OURS[unit]


def same_number(one: float, other: float) -> bool:
    """Whether two numbers are equal but for the round-off of their units."""
    return math.isclose(one, other, rel_tol=SAME_NUMBER, abs_tol=0.0)


def is_number(value: object) -> bool:
    """Whether a value of a file is a number that can be used."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= LARGEST


def is_rigid(attribute: Attribute) -> bool:
    """Whether a stiffness says "rigid" instead of a number."""
    unit = unit_of(attribute.unit)
    return "stiffness" in attribute.id and is_number(attribute.value) and attribute.value * (unit.factor if unit else 1.0) >= RIGID


def number_of(component: Component, name: str) -> Reading:
    """A number in SI; a count as a whole number."""
    known, attribute = KNOWN[name], attribute_of(component, name)
    if attribute is None:
        return Reading(None, None)
    if not is_number(attribute.value):
        return Reading(None, attribute, f"found {str(attribute.value)[:40]!r}; a number with a decimal point is required")
    wanted, found = unit_of(known.unit), unit_of(attribute.unit)
    if found is None or found.quantity != wanted.quantity:
        return Reading(None, attribute, f"its unit '{attribute.unit}' is none of this quantity; '{known.unit}' is required")
    if known.whole:
        return _count(attribute, attribute.value * found.factor)
    number = attribute.value * found.factor if found.factor != 1.0 else attribute.value
    return Reading(float(number) + found.offset + 0.0, attribute)  # -0.0 + 0.0 is 0.0


def _count(attribute: Attribute, value: float) -> Reading:
    nearest = round(value)
    if abs(value - nearest) > WHOLE:
        return Reading(None, attribute, f"found {value:.10g}; a whole number is required")
    return Reading(nearest, attribute)


def text_of(component: Component, name: str) -> str:
    """A text, empty where there is none."""
    attribute = attribute_of(component, name)
    return str(attribute.value).strip() if attribute is not None and not isinstance(attribute.value, (list, bool)) else ""


def is_true(component: Component, name: str) -> Optional[bool]:
    """A truth value, or None where there is none."""
    attribute = attribute_of(component, name)
    if attribute is None:
        return None
    return attribute.value if isinstance(attribute.value, bool) else {"true": True, "false": False}.get(str(attribute.value).strip().lower())


def _vector(attribute: Optional[Attribute]) -> Optional[list[float]]:
    value = attribute.value if attribute is not None else None
    return [float(one) for one in value] if isinstance(value, list) and len(value) == 3 and all(map(is_number, value)) else None


def direction_of(component: Component, name: str) -> Optional[list[float]]:
    """A direction in space, which has no unit; None where it has no length."""
    vector = _vector(component.attributes.get(name))
    return vector if vector and any(vector) else None


def place_of(component: Component) -> Optional[list[float]]:
    """Where a component is in space [m], or None."""
    attribute = component.attributes.get("support_vector")
    vector, unit = _vector(attribute), unit_of(attribute.unit) if attribute is not None else None
    return [one * unit.factor for one in vector] if vector and unit and unit.quantity == "length" else None
