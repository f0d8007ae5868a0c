"""What several kinds of cases take from a file alike: flanks, tools, materials, oil and the inside of bearings."""

from __future__ import annotations

import math
import re
from typing import Iterable, Optional

from orbearing.rexs.geometry import Teeth, crown_drop
from orbearing.rexs.ledger import Draft, Ledger
from orbearing.rexs.model import Attribute, Component, Model
from orbearing.rexs.names import BEARINGS, attribute_of, number_of, same_number, text_of
from orbearing.rexs.places import Places
from orbearing.rexs.writing import number_in, quantity

ISO_GRADES = (7, 10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460, 680, 1000, 1500, 2200, 3200)
GRADE_BAND = 0.1  # ISO 3448: the viscosity at 40 degC lies within a tenth of its grade
ROLLERS = ("radial_roller_bearing", "radial_needle_roller_bearing")
BALLS = ("radial_grooved_ball_bearing", "angular_contact_ball_bearing")
CLASSES = {"C0": "CN", "C2": "C2", "C3": "C3", "C4": "C4", "C5": "C5"}
FULL = 0.95  # from this share of the pitch circle on no cage fits between rollers
CROWN_LAMINAE = 40  # the relief of a profile is stated at the outermost of so many
# A usual cage guided at the outer ring, as the program has it for bearings of its catalogue.
CAGE_INWARD, CAGE_OUTWARD, CAGE_LAND, CAGE_WIDTH = 0.4, 0.5, 0.56, 0.76

Origin = tuple[Component, Optional[Attribute]]


class Source:
    """A model with the report of what is taken from it; `load_cases`: the model while each load acts."""

    def __init__(self, model: Model, ledger: Ledger, text: str):
        self.model, self.ledger, self.text = model, ledger, text
        self.places = Places(model)
        self.load_cases = [(one, model.with_load_case(one)) for one in model.load_cases]

    def number(self, component: Optional[Component], name: str) -> tuple[Optional[float], Origin]:
        """A number in SI and where it stands; what cannot be read is told."""
        if component is None:
            return None, (None, None)
        reading = number_of(component, name)
        if reading.problem:
            self.ledger.contradict(component, reading.attribute, reading.problem)
        return reading.number, (component, reading.attribute if reading.number is not None else None)

    def references(self, origin: Component, type_: str) -> list[Component]:
        """What a component refers to, of a type."""
        return [one for one in self.model.parts("reference", "origin", origin.id, "referenced") if one.type == type_]

    def flanks(self, gear: Component) -> list[Component]:
        """Left and right flank of a gear."""
        for relation in self.model.related("flank", gear=gear.id):
            found = [self.model.components.get(relation.part(role) or -1) for role in ("left", "right")]
            return [one for one in found if one is not None]
        return []

    def tool(self, gear: Component) -> Optional[Component]:
        """The tool that cut the gear first."""
        tools = [one for one in self.model.parts("ordered_reference", "origin", gear.id, "referenced") if one.type.endswith("_tool")]
        return next(iter([*tools, *self.model.parts("manufacturing_step", "workpiece", gear.id, "tool")]), None)

    def elements(self, row: Optional[Component]) -> list[Component]:
        """The rolling elements that the file describes of a row."""
        parts = self.model.parts("ordered_assembly", "assembly", row.id, "part") if row is not None else []
        return [one for one in parts if one.type == "rolling_element"]

    def of_flanks(self, gear: Component, name: str) -> tuple[Optional[float], list[Origin]]:
        """A value of both flanks, of the left one where they differ."""
        found = [(value, origin) for value, origin in (self.number(flank, name) for flank in self.flanks(gear)) if value is not None]
        if not found:
            return None, []
        value = found[0][0]
        for other, (component, attribute) in found[1:]:
            if not same_number(other, value):
                self.ledger.contradict(component, attribute, "differs from the other flank; a case has one value for both")
        return value, [origin for other, origin in found if same_number(other, value)]

    def shift(self, gear: Component, module: float) -> tuple[Optional[float], list[Origin]]:
        """The profile shift in modules, with the file's sign."""
        value, origins = self.of_flanks(gear, "shift")
        if value is None:
            length, origins = self.of_flanks(gear, "shift_length")
            value = None if length is None else length / module
        return value, origins


def common(source: Source, gears: Iterable[Component], name: str) -> tuple[Optional[float], list[Origin]]:
    """A value that all gears must share; of the first where they differ."""
    found = [(value, origin) for value, origin in (source.number(gear, name) for gear in gears) if value is not None]
    if not found:
        return None, []
    first = found[0][0]
    for value, (component, attribute) in found:
        if not same_number(value, first):
            source.ledger.contradict(component, attribute, f"differs from component {found[0][1][0].id}; a case has one value for all gears")
    return first, [origin for value, origin in found if same_number(value, first)]


def unlike_modules(source: Source, gears: Iterable[Component]) -> str:
    """Why gears cannot mesh; empty where their modules are equal, or one alone is stated."""
    found = [(gear, value) for gear, (value, _) in ((gear, source.number(gear, "module")) for gear in gears) if value is not None]
    other = next(((gear, value) for gear, value in found if not same_number(value, found[0][1])), None)
    if other is None:
        return ""
    return (f"component {found[0][0].id} has a normal module of {quantity(found[0][1], 'mm')}, component {other[0].id} of {quantity(other[1], 'mm')}: "
            "gears that mesh have one module")


def pressure_angle(source: Source, draft: Draft, block: str, gears: Iterable[Component]) -> float:
    """The normal pressure angle [rad] of the gears, put into the case; 20 degrees where no flank states it."""
    found = [(value, origin) for value, origins in (source.of_flanks(gear, "pressure_angle") for gear in gears) if value is not None for origin in origins]
    if not found:
        source.ledger.miss(draft.name, f"{block}.pressure_angle", "pressure_angle", None, "no flank states it", "20 deg")
        return math.radians(20.0)
    value, (first, _) = found[0]
    for other, origin in found:
        if not same_number(other, value):
            source.ledger.contradict(*origin, f"differs from component {first.id}; gears that mesh have one pressure angle")
    draft.put(f"{block}.pressure_angle", quantity(value, "deg"), *(origin for other, origin in found if same_number(other, value)))
    return value


def narrowest(source: Source, gears: Iterable[Component]) -> tuple[Optional[float], list[Origin]]:
    """The least face width, which is the common one where gears stand beside each other."""
    found = [(value, origin) for value, origin in (source.number(gear, "face_width") for gear in gears) if value is not None]
    if not found:
        return None, []
    least = min(value for value, _ in found)
    for value, (component, attribute) in found:
        if not same_number(value, least):
            source.ledger.leave(component, attribute, "wider than its mate; a case has the common face width")
    return least, [origin for value, origin in found if same_number(value, least)]


class Heights:
    """Addendum and bottom clearance of a gear in modules, from its diameters, its flank or its tool."""

    def __init__(self, source: Source, gear: Component, teeth: Teeth, number: float, shift: float):
        self._source, self._gear = source, gear
        self._inward = -1.0 if gear.type == "ring_gear" else 1.0
        self._reference, self._module, self._shift = teeth.reference_diameter(number), teeth.module, shift
        self.addendum, self.addendum_origins = self._addendum()
        self.clearance, self.clearance_origins = self._clearance()

    def _height(self, name: str, inward: float) -> tuple[Optional[float], Origin]:
        """Height over the reference circle of the shifted profile, outward of the teeth positive."""
        diameter, origin = self._source.number(self._gear, name)
        if diameter is None:
            return None, origin
        return inward * (self._inward * (diameter - self._reference) / (2.0 * self._module) - self._inward * self._shift), origin

    def _addendum(self) -> tuple[Optional[float], list[Origin]]:
        value, origin = self._height("tip_diameter", 1.0)
        if value is not None:
            if 0.5 <= value <= 1.5:
                return round(value, 9), [origin]
            self._source.ledger.leave(*origin, f"gives an addendum of {value:.4g} modules; 0.5 to 1.5 are plausible")
        return self._source.of_flanks(self._gear, "profile_addendum")

    def _clearance(self) -> tuple[Optional[float], list[Origin]]:
        addendum = 1.0 if self.addendum is None else self.addendum
        depth, origin = self._height("root_diameter", -1.0)
        if depth is None:
            depth, origin = self._source.number(self._source.tool(self._gear), "tool_addendum")
        if depth is None:
            return None, []
        if 0.0 <= depth - addendum <= 0.6:
            return round(depth - addendum, 9), [origin]
        self._source.ledger.leave(*origin, f"gives a bottom clearance of {depth - addendum:.4g} modules; 0 to 0.6 are plausible")
        return None, []


def put_heights(source: Source, draft: Draft, block: str, heights: dict[str, Heights]) -> None:
    """Addendum and clearance, once for all gears where they are equal."""
    for what in ("addendum", "clearance"):
        found = {name: getattr(one, what) for name, one in heights.items()}
        stated = {name: value for name, value in found.items() if value is not None}
        default = 1.0 if what == "addendum" else 0.25
        if not stated:
            source.ledger.miss(draft.name, f"{block}.{what}", "tip_diameter" if what == "addendum" else "root_diameter", None,
                               "neither diameters nor tool state it", default)
            continue
        origins = {name: getattr(heights[name], f"{what}_origins") for name in stated}
        first = next(iter(stated.values()))
        if all(abs(value - first) < 1e-6 for value in stated.values()):
            draft.put(f"{block}.{what}", first, *(origin for one in origins.values() for origin in one))
        elif block == "pair":
            for name, value in stated.items():
                if abs(value - first) >= 1e-6:
                    for origin in origins[name]:
                        source.ledger.leave(*origin, f"gives {value:.4g}; a pair has one {what} for both gears")
            draft.put(f"{block}.{what}", first, *next(iter(origins.values())))
        else:
            for name, value in stated.items():
                draft.put(f"{block}.{what}_of.{name}", value, *origins[name])


def put_fillet(source: Source, draft: Draft, block: str, gears: Iterable[Component]) -> None:
    """The tip radius of the racks, which is the root fillet of the gears."""
    found = []
    for gear in gears:
        tool = source.tool(gear)
        value, origin = source.number(tool, "tool_tip_radius")
        if value is None:
            continue
        if tool.type != "rack_shaped_tool":
            source.ledger.leave(*origin, "of a cutter wheel; a case has the tip radius of a rack")
        else:
            found.append((value, origin))
    if found:
        draft.put(f"{block}.root_fillet_radius", found[0][0], *(origin for value, origin in found if same_number(value, found[0][0])))
        for value, origin in found:
            if not same_number(value, found[0][0]):
                source.ledger.leave(*origin, "differs from the other gear's tool; a case has one rack")
    else:
        source.ledger.miss(draft.name, f"{block}.root_fillet_radius", "tool_tip_radius", None, "no rack-shaped tool states it", 0.38)


def put_material(source: Source, draft: Draft, gears: Iterable[Component]) -> None:
    """Young's modulus, Poisson's ratio and density of the gears' steel."""
    materials = [one for gear in gears for one in source.references(gear, "material")]
    for name, path, unit in (("elastic_modulus", "material.youngs_modulus", "GPa"), ("poisson_ratio", "material.poisson_ratio", ""),
                             ("density", "material.density", "kg/m3")):
        value, origins = common(source, dict.fromkeys(materials), name)
        if value is not None:
            draft.put(path, quantity(value, unit) if unit else value, *origins)


def lubricant_of(source: Source, users: Iterable[Component]) -> Optional[Component]:
    """The oil that the first of these components refers to."""
    for user in [*users, *source.model.of_type("gear_casing")]:
        for oil in source.references(user, "lubricant"):
            return oil
    return None


def put_oil(source: Source, draft: Draft, users: Iterable[Component]) -> None:
    """Grade and temperature of the oil."""
    users = list(users)
    oil = lubricant_of(source, users)
    if oil is None:
        source.ledger.miss(draft.name, "lubricant.grade", "viscosity_40", None, "no component refers to a lubricant", "the default oil")
        return
    viscosity, origin = source.number(oil, "viscosity_40")
    grade = next((one for one in ISO_GRADES if viscosity is not None and abs(viscosity / (1e-6 * one) - 1.0) <= GRADE_BAND), None)
    if grade is None:
        source.ledger.miss(draft.name, "lubricant.grade", "viscosity_40", oil, "the viscosity at 40 degC is that of no grade of ISO 3448", "the default oil")
        return
    draft.put("lubricant.grade", f"ISO VG {grade}", origin)
    for name in ("viscosity_100", "oil_density"):
        attribute = attribute_of(oil, name)
        source.ledger.leave(oil, attribute, "follows from the grade in a case (mineral oil, viscosity index 95)")
    holders = [*source.model.of_type("gear_casing"), *users]
    stated = [(value, origin) for value, origin in (source.number(one, "oil_temperature") for one in holders) if value is not None]
    if not stated:
        stated = _thinnest_oil(source, draft, holders)
    if stated:
        draft.put("lubricant.temperature", quantity(stated[0][0], "degC"), *(one for value, one in stated if same_number(value, stated[0][0])))
        for value, one in stated:
            if not same_number(value, stated[0][0]):
                source.ledger.leave(*one, "differs from the casing's; a case has one temperature of the oil")
    else:
        source.ledger.miss(draft.name, "lubricant.temperature", "oil_temperature", None, "no component states it", "70 degC")


def _thinnest_oil(source: Source, draft: Draft, holders: list[Component]) -> list[tuple]:
    """The highest temperature of all load cases."""
    found = [(number_of(model.components[one.id], "oil_temperature"), load_case.id, one) for load_case, model in source.load_cases for one in holders]
    found = [(reading, *more) for reading, *more in found if reading.number is not None]
    if not found:
        return []
    hottest = max(reading.number for reading, *_ in found)
    for reading, load_case, component in found:
        if same_number(reading.number, hottest):
            draft.put_of_load_case("lubricant.temperature", load_case, component, reading.attribute)
        else:
            source.ledger.leave(component, reading.attribute, "cooler than in another load case; a case has one temperature of the oil", load_case)
    return [(hottest, (None, None))]


def put_life(source: Source, draft: Draft, bearing: Component) -> None:
    """Cleanliness and reliability."""
    value, origin = source.number(bearing, "contamination")
    if value is not None:
        draft.put("life.contamination_factor", value, origin)
    value, origin = source.number(bearing, "survival")
    if value is not None and 0.0 < value < 1.0:
        draft.put("life.reliability", value, origin)


def rows_of(source: Source, bearing: Component) -> list[Component]:
    """The rows of a bearing that the file describes."""
    return [one for one in source.model.parts("ordered_assembly", "assembly", bearing.id, "part") if one.type == "rolling_bearing_row"]


def row_count(source: Source, bearing: Component) -> int:
    """How many rows a bearing has."""
    value, _ = source.number(bearing, "rows")
    return max(value or 0, len(rows_of(source, bearing)), 1)


def designation_of(bearing: Component) -> tuple[str, str]:
    """The catalogue's spelling of a designation, and the suffixes that are left out; reinforced series keep their E."""
    match = re.match(r"(NUP|NU|NJ)?\s*(\d{3,5})\s*[- ]?(.*)", text_of(bearing, "designation").upper())
    if not match:
        return "", text_of(bearing, "designation")
    prefix, digits, suffix = match.groups()
    marks = [mark for mark in re.split(r"[-. ]", suffix) if mark]
    angle = next((mark for mark in marks if mark in ("A", "B", "C") and digits.startswith("7")), "")
    strong = "E" if prefix and any(re.fullmatch(r"E(C|CP|CJ|CM|W|T|G)?", mark) for mark in marks) else ""
    kept = [mark for mark in marks if mark not in (angle, strong)]
    return " ".join(part for part in (prefix, digits, angle, strong) if part), "-".join(kept)


class Inside:
    """What a file says of the inside of a bearing, put into a case."""

    def __init__(self, source: Source, draft: Draft, bearing: Component, balls: bool):
        self.source, self.draft, self.bearing, self.balls = source, draft, bearing, balls
        self.row = next(iter(rows_of(source, bearing)), None)
        self.element = next(iter(source.elements(self.row)), None)

    def put(self) -> None:
        """Sizes where all are stated, else the designation; ratings in both cases."""
        if not self._put_sizes():
            self._put_designation()
        self._put_rings()
        if row_count(self.source, self.bearing) == 1:
            self._put_ratings()
        self._put_clearance()

    def _put_rings(self) -> None:
        """Bore, outside diameter and the width of one row, where neither a designation nor the balls stand for them."""
        rows = row_count(self.source, self.bearing)
        for name, path in (("bore", "bearing.bore"), ("outside", "bearing.outside_diameter"), ("width", "bearing.width")):
            value, origin = self.source.number(self.bearing, name)
            if value is None or value <= 0.0 or "bearing.designation" in self.draft.values:
                continue
            if "bearing.balls" in self.draft.values:
                self.source.ledger.leave(*origin, "a ball-bearing with the sizes of its balls takes none of its rings")
            else:
                self.draft.put(path, quantity(value / rows if name == "width" else value, "mm"), origin)

    def _put_ratings(self) -> None:
        for name, path in (("dynamic_capacity", "bearing.dynamic_capacity"), ("static_capacity", "bearing.static_capacity"),
                           ("fatigue_limit", "bearing.fatigue_load_limit")):
            value, origin = self.source.number(self.bearing, name)
            if value is not None and value > 0.0:
                self.draft.put(path, quantity(value, "kN"), origin)

    def _put_sizes(self) -> bool:
        number, counted = self.source.number(self.row, "elements")
        diameter, sized = self.source.number(self.element, "element_diameter")
        pitch, placed = self.source.number(self.row, "pitch_diameter")
        if min(number or 0, diameter or 0.0, pitch or 0.0) <= 0:
            return False
        self.draft.put("bearing.balls" if self.balls else "bearing.rollers", number, counted)
        self.draft.put("bearing.ball_diameter" if self.balls else "bearing.roller_diameter", quantity(diameter, "mm"), sized)
        self.draft.put("bearing.pitch_diameter", quantity(pitch, "mm"), placed)
        if self.balls:
            self._put_grooves(diameter)
        else:
            self.draft.put("bearing.type", "cylindrical-roller")
            if number * diameter > FULL * math.pi * pitch:
                self.draft.assume("bearing.complement", "full", "the rollers of the file fill their circle")
            self._put_length()
        return True

    def _put_grooves(self, diameter: float) -> None:
        angle, origin = self.source.number(self.row, "contact_angle")
        if angle is not None:
            self.draft.put("bearing.contact_angle", quantity(abs(angle), "deg"), origin)
        for side in ("inner", "outer"):
            radius, origin = self.source.number(self.row, f"{side}_groove")
            if radius:
                self.draft.put(f"bearing.{side}_osculation", round(radius / diameter, 9), origin)

    def _put_length(self) -> None:
        stated = [self.source.number(self.row, f"{side}_contact_length") for side in ("inner", "outer")]
        stated = [one for one in stated if one[0]]
        length, whole = self.source.number(self.element, "element_length")
        if stated:
            shortest = min(value for value, _ in stated)
            self.draft.put("bearing.roller_length", quantity(shortest, "mm"), *(origin for value, origin in stated if same_number(value, shortest)))
            self.source.ledger.leave(*whole, "the length of contact is stated, and a case takes that")
        elif length:
            self.draft.put("bearing.roller_length", quantity(length, "mm"), whole)
        self._put_crown(min([value for value, _ in stated] or [length or 0.0]))

    def _put_crown(self, length: float) -> None:
        radius, origin = self.source.number(self.element, "crown_radius")
        drop = crown_drop(radius, length, CROWN_LAMINAE) if radius and length else 0.0
        if drop > 0.0:
            self.draft.put("bearing.profile.kind", "circular", origin)
            self.draft.put("bearing.profile.drop", quantity(round(drop, 15), "um"), origin)
            self.draft.put("bearing.laminae", CROWN_LAMINAE)

    def _put_designation(self) -> None:
        name, suffixes = designation_of(self.bearing)
        attribute = attribute_of(self.bearing, "designation")
        if name:
            self.draft.put("bearing.designation", name, (self.bearing, attribute))
        elif attribute is not None:
            self.source.ledger.leave(self.bearing, attribute, "not a designation of the catalogue")
        if suffixes:
            self.source.ledger.miss(self.draft.name, "bearing.designation", "designation", self.bearing,
                                    f"the suffixes '{suffixes}' of the designation have no counterpart in a case", name or None)

    def _put_clearance(self) -> None:
        for name in ("operating_clearance", "mounted_clearance", "shelf_clearance"):
            value, origin = self.source.number(self.bearing, name)
            if value is not None:
                self.draft.put("bearing.radial_clearance", quantity(value, "um"), origin)
                if "bearing.designation" in self.draft.values and not self.balls and name != "shelf_clearance":
                    self.draft.put("bearing.clearance_state", "operating", origin)
                if name == "shelf_clearance":
                    self.source.ledger.miss(self.draft.name, "bearing.radial_clearance", "operating_clearance", self.bearing,
                                            "the file states the clearance before mounting alone", quantity(value, "um"))
                return
        least, most = (self.source.number(self.bearing, name) for name in ("least_clearance", "most_clearance"))
        if least[0] is not None and most[0] is not None:
            self.draft.put("bearing.radial_clearance", quantity(0.5 * (least[0] + most[0]), "um"), least[1], most[1])
            return
        attribute = attribute_of(self.bearing, "clearance_class")
        if attribute is not None and "bearing.balls" in self.draft.values:
            self.source.ledger.leave(self.bearing, attribute, "a class of clearance requires a designation; a ball-bearing with the sizes of its balls takes "
                                                              "a clearance in micrometres")
        elif attribute is not None and str(attribute.value) in CLASSES:
            self.draft.put("bearing.clearance_class", CLASSES[str(attribute.value)], (self.bearing, attribute))


def filler(source: Source, bearing: Optional[Component]):
    """A function that assumes what REXS has no attribute for, or what the file left out, so that a case is whole."""

    def fill(draft: Draft, missing: list[str], refused: set[str]) -> bool:
        filled = False
        for key in missing:
            path, text, reason = _assumption(draft, key)
            if text and path not in draft.values and path not in refused:
                draft.assume(path, text, reason)
                source.ledger.miss(draft.name, path, "shelf_clearance" if "clearance" in path else "", bearing, reason, text)
                filled = True
        return filled

    return fill


def _assumption(draft: Draft, path: str) -> tuple[str, str, str]:
    """What to put for a missing path: path, text and reason; an empty text where nothing can be assumed."""
    def length(key: str) -> Optional[float]:
        return number_in(draft.values[key]) if key in draft.values else None

    if path == "bearing.radial_clearance" and "bearing.balls" not in draft.values:
        return "bearing.clearance_class", "CN", "the file states no clearance: the normal class"
    if path == "bearing.cage.density":
        return "bearing.cage.material", "polyamide", "REXS describes no cage: the usual material"
    diameter, pitch = length("bearing.roller_diameter"), length("bearing.pitch_diameter")
    reason = "REXS describes no cage: a usual one of this section, guided at the outer ring"
    if diameter is None or pitch is None:
        return path, "", ""
    width, roller = length("bearing.width"), length("bearing.roller_length")
    axial = CAGE_WIDTH * width if width else (roller or 0.0) + CAGE_INWARD * diameter
    sizes = {"inner_diameter": pitch - CAGE_INWARD * diameter, "outer_diameter": pitch + CAGE_OUTWARD * diameter,
             "guide_land_diameter": pitch + CAGE_LAND * diameter, "width": axial}
    size = sizes.get(path.removeprefix("bearing.cage."))
    return path, quantity(size, "mm") if size else "", reason


def is_bearing(component: Optional[Component]) -> bool:
    return component is not None and component.type in BEARINGS

