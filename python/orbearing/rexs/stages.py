"""Planetary stages of a file as cases."""

from __future__ import annotations

import math
from typing import Any, Optional

from orbearing.rexs.drive import FLOOR, Drive, Member, Planetary, shaft_of
from orbearing.rexs.geometry import SAME_SHIFT, Teeth
from orbearing.rexs.ledger import Draft
from orbearing.rexs.model import Component, Model
from orbearing.rexs.names import CATALOGUE, RIGID, attribute_of, in_unit, is_rigid, is_true, number_of, place_of, same_number, text_of
from orbearing.rexs.parts import (ROLLERS, Heights, Inside, Source, common, is_bearing, narrowest, pressure_angle, put_fillet, put_heights, put_life,
                                  put_material, put_oil, row_count, rows_of, unlike_modules)
from orbearing.rexs.writing import number_text, quantity

SAME_ANGLE = 0.01  # [deg]
SAME_HELIX = 1e-8  # [rad]
SAME_SHARE = 1e-6
STANDSTILL = 1e-10  # [rad/s]
NOTHING = 1e-9  # [unit of a figure] round-off of zero


class StageCase:
    """The draft of the case of one planetary stage."""

    def __init__(self, source: Source, drive: Drive, stage: Planetary, name: str):
        self.source, self.drive, self.stage, self.model = source, drive, stage, source.model
        self.draft = Draft(name, "planetary-drivetrain", source.text)
        self.members: dict[str, Member] = {}
        self.spectrum_origins: list[tuple] = []
        self.bearings: list[Component] = []
        self.sides: list[list[tuple[Component, Component]]] = []
        self.bearing_places: list[float] = []  # [m]
        self.centre_distance: Optional[float] = None  # [m]
        self.notes: list[str] = []
        self.problem = ""
        self.contact_ratios: dict[str, float] = {}

    def build(self) -> Draft:
        """All that the file states for this stage."""
        self._put_input()
        self._put_gears()
        self._put_planets()
        self._put_bodies()
        put_material(self.source, self.draft, [self.stage.sun, self.stage.planets[0], self.stage.ring])
        self._put_bearings()
        users = [*self.bearings, *self.stage.sun_meshes, *self.stage.ring_meshes]
        put_oil(self.source, self.draft, users)
        return self.draft

    # Drive of the stage

    def _put_input(self) -> None:
        for names, parts in ((("torque", "load_power"), self._loads()), (("speed",), self.model.of_type("shaft"))):
            for part in parts:
                for name in names:
                    self.source.number(part, name)  # tells what cannot be read
        self._put_fixed()
        base = self._at(self.model)
        rows = [(one, self._at(model)) for one, model in self.source.load_cases]
        rows = [(one, members) for one, members in rows if members]
        if not base and rows:
            operating, base = max(rows, key=lambda row: self._share(row[0])[1] or 0.0)
            if len(rows) > 1:
                self.source.ledger.miss(self.draft.name, "input.power", "torque", None, "the file states loads by load case alone",
                                        f"load case {operating.id}, the longest")
        if not base:
            self.source.ledger.miss(self.draft.name, "input.power", "torque", None, "speed and torque of the stage do not follow from the file")
            return
        self.members = base
        driving = max(base, key=lambda name: base[name].power)
        self.draft.put("input.member", driving)
        self.draft.put("input.power", quantity(base[driving].power, "kW"), *self._load_origins())
        self.draft.put("input.speed", quantity(abs(base[driving].speed), "rpm"), *self._speed_origins())
        if len(rows) > 1:
            self._put_spectrum(driving, rows)
        elif rows:
            self.spectrum_origins += self._case_origins(rows[0][0])

    def _put_fixed(self) -> None:
        bodies = self.stage.bodies
        held = [name for name, body in bodies.items() if body == FLOOR]
        if not held:
            _, speeds, _ = self.drive.members(self.model)
            held = [name for name, body in bodies.items() if abs(speeds.get(body, 1.0)) < STANDSTILL]
        if not held:
            held = [name for name in ("ring", "sun") if self.drive.is_open(bodies[name])][:1]
            if held:
                self.source.ledger.miss(self.draft.name, "gearset.fixed", "", getattr(self.stage, held[0]),
                                        "no member is joined to a casing; the one without a shaft is taken", held[0])
                self.drive.hold(bodies[held[0]])
        if len(held) == 1:
            self.draft.put("gearset.fixed", held[0])
        else:
            self.problem = f"found {len(held)} members held by a casing; one is required"

    def _at(self, model: Model) -> dict[str, Member]:
        members, _, notes = self.drive.members(model)
        self.notes += [note for note in notes if note not in self.notes]
        return members.get(self.stage.stage.id, {})

    def _loads(self) -> list[Component]:
        return self.model.of_type("external_load")

    def _load_origins(self) -> list[tuple]:
        names = ("torque", "load_power", "defines_torque", "transmits_torque")
        return [(load, attribute_of(load, name)) for load in self._loads() for name in names if attribute_of(load, name)]

    def _speed_origins(self) -> list[tuple]:
        return [(shaft, attribute_of(shaft, "speed")) for shaft in self.model.of_type("shaft") if attribute_of(shaft, "speed")]

    def _case_origins(self, load_case: Any) -> list[tuple]:
        names = ("torque", "load_power", "speed", "share", "duration")
        found = []
        for component in load_case.components:
            for name in names:
                attribute = attribute_of(component, name) if component.type else None
                if attribute is not None and (component.type, attribute.id) != ("shaft_section", "length"):
                    found.append((load_case.id, component, attribute))
        return found

    def _share(self, load_case: Any) -> tuple[str, Optional[float]]:
        """How long a load acts: share [-] or hours [s], and the number; None where it is not stated."""
        for component in load_case.components:
            if component.id in self.model.components and self.model.components[component.id].type == "gear_unit":
                share = number_of(component, "share").number
                if share is not None:
                    return "share", share
                duration = number_of(component, "duration").number
                if duration is not None:
                    return "hours", duration
        return "share", None

    def _put_spectrum(self, driving: str, rows: list[tuple]) -> None:
        times = [self._share(one) for one, _ in rows]
        rows = [row for row, (_, time) in zip(rows, times) if time != 0.0]  # one that never acts does no damage
        times = [one for one in times if one[1] != 0.0]
        if len({kind for kind, _ in times}) > 1 or any(time is None or time < 0.0 for _, time in times):
            self.source.ledger.miss(self.draft.name, "spectrum", "share", None, "some load cases state no duration")
            return
        if not rows:
            return
        total = sum(time for _, time in times)
        shares = [time / total if kind == "share" else in_unit(time, "h") for kind, time in times]
        if times[0][0] == "share" and abs(total - 1.0) > SAME_SHARE:
            self.notes.append(f"{self.draft.name}: the shares of the load cases add up to {total:.6g}; scaled to 1")
        spectrum = []
        for (one, members), (kind, _), time in zip(rows, times, shares):
            if members[driving].power < 0.0:
                self.notes.append(f"{self.draft.name}: load case {one.id} drives the stage backwards; its power is taken without its sign")
            spectrum.append({"power": quantity(abs(members[driving].power), "kW"), "speed": quantity(abs(members[driving].speed), "rpm"),
                             kind: time})
            self.spectrum_origins += self._case_origins(one)
        self.draft.put("spectrum", spectrum)

    # Teeth

    def _put_gears(self) -> None:
        stage, draft, source = self.stage, self.draft, self.source
        gears = {"sun": stage.sun, "planet": stage.planets[0], "ring": stage.ring}
        draft.put("gearset.planets", len(stage.planet_shafts))
        numbers = {}
        for name, gear in gears.items():
            value, origin = source.number(gear, "teeth")
            if value is not None:
                numbers[name] = abs(value)
                draft.put(f"gearset.teeth.{name}", numbers[name], origin)
        module, origins = common(source, gears.values(), "module")
        unlike = unlike_modules(source, [stage.sun, *stage.planets, stage.ring])
        if unlike:
            self.problem = unlike
            return
        if module is not None:
            draft.put("gearset.module", quantity(module, "mm"), *origins)
        angle = pressure_angle(source, draft, "gearset", gears.values())
        helix = self._put_helix(gears)
        width, origins = narrowest(source, [stage.sun, *stage.planets, stage.ring])
        if width is not None:
            draft.put("gearset.face_width", quantity(width, "mm"), *origins)
        if not module or len(numbers) < 3 or not all(numbers.values()) or abs(helix) >= 0.5 * math.pi:
            return
        teeth = Teeth(module, angle, helix)
        shifts = self._put_shifts(gears, numbers, teeth)
        heights = {name: Heights(source, gear, teeth, numbers[name], shifts[name]) for name, gear in gears.items()}
        put_heights(source, draft, "gearset", heights)
        put_fillet(source, draft, "gearset", [stage.planets[0], stage.sun, stage.ring])
        self._put_ratios(teeth, numbers, shifts, heights)
        self._find_contact_ratios(teeth, numbers, shifts, heights)
        self._put_backlash()

    def _put_helix(self, gears: dict[str, Component]) -> float:
        value, origin = self.source.number(gears["sun"], "helix")
        others = [self.source.number(gear, "helix") for name, gear in gears.items() if name != "sun"]
        if value is None:
            return 0.0
        # A planet is of the sun's opposite hand, and so is the ring, which is of the planet's.
        fitting = [one for found, one in others if found is not None and abs(found + value) < SAME_HELIX]
        for found, one in others:
            if found is not None and abs(found + value) >= SAME_HELIX:
                self.source.ledger.contradict(*one, "contradicts the sun's: planet and ring have the same helix angle, of the opposite hand")
        self.draft.put("gearset.helix_angle", quantity(value, "deg"), origin, *fitting)
        return value

    def _centre_distance(self, meshes: list[Component]) -> tuple[Optional[float], list]:
        value, origins = common(self.source, meshes, "centre_distance")
        return (abs(value) if value else None), origins

    def _put_shifts(self, gears: dict[str, Component], numbers: dict[str, int], teeth: Teeth) -> dict[str, float]:
        stated = {name: self.source.shift(gear, teeth.module) for name, gear in gears.items()}
        distance, origins = self._centre_distance(self.stage.sun_meshes)
        ring_distance, ring_origins = self._centre_distance(self.stage.ring_meshes)
        distance, ring_distance = distance or ring_distance, ring_distance or distance
        if distance is not None:
            alike = ring_distance is not None and same_number(distance, ring_distance)
            self.draft.put("gearset.centre_distance", quantity(distance, "mm"), *origins, *(ring_origins if alike else []))
        self.centre_distance = distance
        outer = teeth.shift_sum(numbers["sun"] + numbers["planet"], distance) if distance else None
        inner = teeth.shift_sum(numbers["ring"] - numbers["planet"], ring_distance) if ring_distance else None
        sun, planet = stated["sun"][0], stated["planet"][0]
        if planet is None and sun is not None and outer is not None:
            planet = outer - sun
        if sun is None and outer is not None:
            share = "the file states no shift of the sun; the centre distance gives it"
            if planet is None:
                planet, share = 0.5 * outer, "the file states no shift; half of the sum that the centre distance gives"
            sun = outer - planet
            self._assume_shift("sun", sun, share)
        elif planet is not None and distance and (outer is None or abs(sun + planet - outer) > SAME_SHIFT):
            self._contradict_distance(origins, f"the profile shifts of sun and planet add up to {sun + planet:.6g}", outer)
        ring = self._ring_shift(stated["ring"], planet, inner)
        if stated["ring"][0] is not None and planet is not None and ring_distance and (inner is None or abs(ring - planet - inner) > SAME_SHIFT):
            self._contradict_distance(ring_origins or origins, f"the profile shift of the ring is {ring - planet:.6g} more than the planet's", inner)
        if sun is not None and stated["sun"][0] is not None:
            self.draft.put("gearset.profile_shift.sun", sun, *stated["sun"][1])
        if stated["planet"][0] is not None:
            self.draft.put("gearset.profile_shift.planet", stated["planet"][0], *stated["planet"][1])
        if ring is None:
            self._assume_missing("ring")
        if sun is None:
            self._assume_missing("sun")
        return {"sun": sun or 0.0, "planet": planet or 0.0, "ring": ring or 0.0}

    def _contradict_distance(self, origins: list, stated: str, wanted: Optional[float]) -> None:
        for origin in origins:
            self.source.ledger.contradict(*origin, f"contradicts the teeth: {stated}; this centre distance requires "
                                                   f"{'another number of teeth' if wanted is None else f'{wanted:.6g}'}")

    def _assume_missing(self, name: str) -> None:
        self.source.ledger.miss(self.draft.name, f"gearset.profile_shift.{name}", "shift", getattr(self.stage, name),
                                "neither shift nor centre distance is stated", 0.0)
        self.draft.assume(f"gearset.profile_shift.{name}", 0, "not stated in the file")

    def _assume_shift(self, name: str, value: float, reason: str) -> None:
        value = round(value, 9) + 0.0
        self.source.ledger.miss(self.draft.name, f"gearset.profile_shift.{name}", "shift", getattr(self.stage, name), reason, value)
        self.draft.assume(f"gearset.profile_shift.{name}", value, reason)

    def _ring_shift(self, stated: tuple, planet: Optional[float], inner: Optional[float]) -> Optional[float]:
        """The ring's shift, positive outward: in files it is negative outward, as in DIN 3960; the centre distance shows where it is not."""
        value, origins = stated
        wanted = None if inner is None or planet is None else inner + planet
        if value is None:
            if wanted is not None:
                self._assume_shift("ring", wanted, "the file states no shift of the ring; the centre distance gives it")
            return wanted
        outward = 0.0 - value
        if wanted is not None and abs(outward - wanted) > SAME_SHIFT and abs(value - wanted) <= SAME_SHIFT:
            outward = value
            self.notes.append(f"{self.draft.name}: the ring's shift of {value:.6g} is positive outward in this file, by its centre distance")
        self.draft.put("gearset.profile_shift.ring", outward + 0.0, *origins)
        return outward

    def _put_ratios(self, teeth: Teeth, numbers: dict[str, int], shifts: dict[str, float], heights: dict[str, Heights]) -> None:
        """Bore of the sun, outside of the ring and bore of a planet, from the shafts that carry them."""
        def root(name: str, inward: float) -> float:
            height = heights[name]
            depth = (1.0 if height.addendum is None else height.addendum) + (0.25 if height.clearance is None else height.clearance)
            return teeth.reference_diameter(numbers[name]) + 2.0 * teeth.module * (shifts[name] - inward * depth)

        sun_root, ring_root = root("sun", 1.0), root("ring", -1.0)
        for value, origin in self._bores(self.stage.sun):
            if 0.02 <= value / sun_root <= 0.98:
                self.draft.put("gearset.sun_bore_ratio", round(value / sun_root, 9), origin)
                break
        for value, origin in self._sections(self.stage.ring, "section_outside"):
            if value and 1.005 <= value / ring_root <= 20.0:
                self.draft.put("gearset.ring_outside_ratio", round(value / ring_root, 9), origin)
                break
        size = teeth.module * (numbers["planet"] - 2.5)
        for value, origin in self._bores(self.stage.planets[0]):
            if 0.02 <= value / size <= 0.98:
                self.draft.put("gearset.planet_bore_ratio", round(value / size, 9), origin)
                break

    def _find_contact_ratios(self, teeth: Teeth, numbers: dict[str, int], shifts: dict[str, float], heights: dict[str, Heights]) -> None:
        """Transverse contact ratios between the tip circles alone, as most programs state them."""
        distance = self.centre_distance
        if distance is None:
            return
        tips = {name: teeth.reference_diameter(numbers[name]) + 2.0 * teeth.module
                * (shifts[name] + (-1.0 if name == "ring" else 1.0) * (1.0 if heights[name].addendum is None else heights[name].addendum)) for name in numbers}
        for name in ("sun", "ring"):
            ratio = teeth.contact_ratio((numbers["planet"], tips["planet"]), (numbers[name], tips[name]), distance, internal=name == "ring")
            if ratio is not None:
                self.contact_ratios[f"{name}_contact_ratio"] = ratio

    def _bores(self, gear: Component) -> list[tuple]:
        value, origin = self.source.number(gear, "gear_bore")
        return [(value, origin)] if value else [(inside, one) for inside, one in self._sections(gear, "section_inside") if inside]

    def _sections(self, gear: Component, name: str) -> list[tuple]:
        return sections_of(self.source, gear, name)

    def _put_backlash(self) -> None:
        for mesh in self.stage.sun_meshes[:1]:
            least, most = (self.source.number(mesh, name) for name in ("least_backlash", "most_backlash"))
            stated = [one for one in (least, most) if one[0] is not None]
            if stated:
                self.draft.put("gearset.dynamics.backlash", quantity(sum(value for value, _ in stated) / len(stated), "mm"), *(one for _, one in stated))

    # Planets, bodies and bearings

    def _put_planets(self) -> None:
        axis = place_of(self.stage.sun) or place_of(self.stage.ring)
        places = [place_of(one) for one in self.stage.planet_shafts]
        if axis is None or not all(places) or len(places) < 2:
            return
        angles = sorted(math.degrees(math.atan2(place[2] - axis[2], place[1] - axis[1])) % 360.0 for place in places)
        steps = [(angle - angles[0]) % 360.0 for angle in angles]
        if any(abs(step - 360.0 * i / len(steps)) > SAME_ANGLE for i, step in enumerate(steps)):
            self.draft.put("gearset.planet_angles", [f"{number_text(round(step, 6))} deg" for step in steps],
                           *((shaft, shaft.attributes.get("support_vector")) for shaft in self.stage.planet_shafts))

    def _put_bodies(self) -> None:
        for name, part in (("sun", self.stage.sun), ("ring", self.stage.ring), ("planet", self.stage.planets[0])):
            mass, origin = self.source.number(part, "mass")
            if mass:
                self.draft.put(f"gearset.dynamics.{name}.mass", quantity(mass, "kg"), origin)
        self._put_supports()
        for carrier in self.model.parts("assembly", "assembly", self.stage.stage.id, "part"):
            mass, origin = self.source.number(carrier, "mass") if carrier.type == "planet_carrier" else (None, None)
            if mass:
                self.draft.put("gearset.dynamics.carrier.mass", quantity(mass, "kg"), origin)

    def _put_supports(self) -> None:
        """Radial stiffness of the bearings that hold sun, ring and carrier in the casing; rigid ones say nothing."""
        for name, body in self.stage.bodies.items():
            held = [self.model.components.get(relation.part("assembly") or -1) for relation in self.model.related("side")
                    if body != FLOOR and relation.part("inner_part") is not None and self.drive.bodies.of(relation.part("inner_part")) == body
                    and self.drive.bodies.of(relation.part("outer_part")) == FLOOR]
            stated = [self.source.number(bearing, "radial_stiffness") for bearing in held if is_bearing(bearing)]
            if stated and all(value is not None and 0.0 < value < RIGID for value, _ in stated):
                self.draft.put(f"gearset.dynamics.{name}.support_stiffness", quantity(sum(value for value, _ in stated), "N/m"), *(one for _, one in stated))

    def _sides_of(self, body: object) -> list[tuple[Component, Component]]:
        """Bearings whose outer ring sits in a body, with the part in their bore."""
        found = []
        for relation in self.model.related("side"):
            bearing = self.model.components.get(relation.part("assembly") or -1)
            inner, outer = relation.part("inner_part"), relation.part("outer_part")
            if is_bearing(bearing) and outer is not None and self.drive.bodies.of(outer) == body and inner in self.model.components:
                found.append((bearing, self.model.components[inner]))
        return found

    def _put_bearings(self) -> None:
        bodies = [self.drive.bodies.of(shaft.id) for shaft in self.stage.planet_shafts]
        sides = [sorted(self._sides_of(body), key=lambda side, shaft=shaft: self._place_of(side[0], shaft) or 0.0)
                 for body, shaft in zip(bodies, self.stage.planet_shafts)]
        self.sides = sides
        self._note_copies()
        if not sides or not sides[0]:
            self.source.ledger.miss(self.draft.name, "bearing.per_planet", "", self.stage.planet_shafts[0], "no bearing carries a planet on its pin")
            return
        self.bearings = [bearing for bearing, _ in sides[0]]
        first, pin = sides[0][0]
        self.bearing_places = self._places()
        if first.type not in CATALOGUE:
            self.source.ledger.miss(self.draft.name, "bearing.rollers", "elements", first, "a concept bearing has no rolling elements")
            for bearing in self.bearings:
                self._leave(bearing, "a concept bearing has no inside: the case is written without a bearing")
            return
        if text_of(first, "bearing_type") not in (*ROLLERS, ""):
            self.source.ledger.miss(self.draft.name, "bearing.type", "bearing_type", first,
                                    f"'{text_of(first, 'bearing_type')}': a planet bearing of a case has cylindrical rollers")
            return
        self._put_roller_bearing(first, pin)

    def _leave(self, component: Component, reason: str) -> None:
        for attribute in component.attributes.values():
            if not is_rigid(attribute) and "vector" not in attribute.id:
                self.source.ledger.leave(component, attribute, reason)

    def _places(self) -> list[float]:
        """Places of the bearings along the planet, from the middle of its face [m]."""
        shaft = shaft_of(self.model, self.stage.planets[0])
        middle = self.source.places.along(self.stage.planets[0], shaft, "gear_place")
        places = [self._place_of(bearing, shaft) for bearing in self.bearings]
        return [place - middle for place in places] if middle is not None and None not in places else []

    def _place_of(self, bearing: Component, shaft: Optional[Component]) -> Optional[float]:
        return self.source.places.along(bearing, shaft, "outer_place")

    def _put_roller_bearing(self, first: Component, pin: Component) -> None:
        draft, rows = self.draft, row_count(self.source, first)
        draft.put("bearing.per_planet", len(self.bearings) * rows, (first, attribute_of(first, "rows")))
        draft.origins["bearing.per_planet"].extend([(first, attribute_of(first, "bearing_type"))] if attribute_of(first, "bearing_type") else [])
        Inside(self.source, draft, first, balls=False).put()
        if rows > 1:
            for name in ("dynamic_capacity", "static_capacity", "fatigue_limit"):
                self.source.ledger.leave(first, attribute_of(first, name), f"rates {rows} rows together; a case rates each row")
        inner, outer = is_true(first, "has_inner_ring"), is_true(first, "has_outer_ring")
        if inner is False:
            draft.put("bearing.rings", "none" if outer is False else "outer", *((first, attribute_of(first, f"has_{side}_ring")) for side in ("inner", "outer")))
        if self.bearing_places and rows == 1:
            draft.put("bearing.axial_places", [quantity(round(place, 12), "mm") for place in self.bearing_places],
                      *((bearing, attribute_of(bearing, "outer_place")) for bearing in self.bearings),
                      (self.stage.planets[0], attribute_of(self.stage.planets[0], "gear_place")))
        put_life(self.source, draft, first)
        self._put_pin(pin)

    def _walls(self, pin: Component) -> list[Component]:
        """The joints that hold a pin."""
        found = [self.model.components.get(relation.part("assembly") or -1) for relation in self.model.related("side", inner_part=pin.id)]
        return [one for one in found if one is not None and one.type in ("coupling", "cylindrical_interference_fit")]

    def _put_pin(self, pin: Component) -> None:
        """Span of the pin between the walls that hold it."""
        places = [self.source.number(one, "inner_place") for one in self._walls(pin)]
        places = [one for one in places if one[0] is not None]
        if len(places) == 2 and places[0][0] != places[1][0]:
            self.draft.put("support.pin_span", quantity(abs(places[0][0] - places[1][0]), "mm"), *(origin for _, origin in places))
            if "bearing.axial_places" in self.draft.values:
                self.draft.assume("bearing.tilt_state", "computed", "the file states where bearings and walls stand along the pin")

    # The report

    def take(self) -> None:
        """All that the case holds, with the parts of the other planets."""
        self.source.ledger.take(self.draft)
        self.source.ledger.take_spectrum(self.draft, self.spectrum_origins)

    def _note_copies(self) -> None:
        """Tells the report which parts are the same in all planets."""
        source, ledger, stage = self.source, self.source.ledger, self.stage
        ledger.alike(stage.planets[0], stage.planets[1:])
        ledger.alike(stage.planet_shafts[0], stage.planet_shafts[1:])
        for meshes in (stage.sun_meshes, stage.ring_meshes):
            ledger.alike(meshes[0], meshes[1:])
        if stage.pins:
            ledger.alike(stage.pins[0], stage.pins[1:])
        self._alike_lists([source.flanks(planet) for planet in stage.planets])
        self._alike_lists([self._walls(pin) for pin in stage.pins])
        self._alike_lists(self.bearing_sets())
        bearings = [bearing for side in self.bearing_sets() for bearing in side]
        for bearing in bearings[:1]:
            ledger.alike(bearing, bearings[1:])
        rows = [row for bearing in bearings for row in rows_of(source, bearing)]
        elements = [element for row in rows for element in source.elements(row)]
        for parts in (rows, elements):
            if parts:
                ledger.alike(parts[0], parts[1:])

    def _alike_lists(self, lists: list[list[Component]]) -> None:
        """The same place in the lists of all planets."""
        for i, original in enumerate(lists[0] if lists else []):
            self.source.ledger.alike(original, [others[i] for others in lists[1:] if i < len(others)])

    def bearing_sets(self) -> list[list[Component]]:
        """The bearings of each planet, along its axis."""
        return [[bearing for bearing, _ in side] for side in self.sides]

    def figures(self) -> dict[str, float]:
        """What follows by elementary geometry, statics and kinematics, as a check against the program that wrote the file."""
        values = self.draft.values
        distance = self.centre_distance if "gearset.centre_distance" in values else None
        figures = {"centre_distance_mm": in_unit(distance, "mm")} if distance is not None else {}
        figures |= self.contact_ratios
        for name, member in self.members.items():
            figures[f"{name}_speed_rpm"], figures[f"{name}_torque_N_m"] = in_unit(member.speed, "rpm"), member.torque
        if self.members:
            figures |= self._motion(distance)
        for place, value in enumerate(self.bearing_places):
            figures[f"bearing_{place + 1}_place_mm"] = in_unit(value, "mm")
        return {name: rounded(value) for name, value in figures.items()}

    def _motion(self, distance: Optional[float]) -> dict[str, float]:
        values, carrier = self.draft.values, self.members["carrier"]
        relative = self.members["sun"].speed - carrier.speed
        figures = {}
        if "gearset.teeth.planet" in values and "gearset.teeth.sun" in values:
            figures = {"planet_relative_speed_rpm": in_unit(relative, "rpm") * values["gearset.teeth.sun"] / values["gearset.teeth.planet"],
                       "mesh_frequency_Hz": abs(relative) * values["gearset.teeth.sun"] / (2.0 * math.pi)}
        if distance is not None:
            figures["pin_force_N"] = abs(carrier.torque) / (distance * values["gearset.planets"])
            if self.bearings:
                figures["bearings_per_planet"] = len(self.bearings)
                figures["force_per_bearing_N"] = figures["pin_force_N"] / len(self.bearings)
        return figures


def rounded(value: float) -> float:
    """Without the last digits, in which one computer differs from another."""
    return 0.0 if abs(value) < NOTHING else float(f"{value:.10g}")


def sections_of(source: Source, gear: Component, name: str) -> list[tuple]:
    """A diameter of the sections of the shaft where the gear sits."""
    shaft = shaft_of(source.model, gear)
    if shaft is None:
        return []
    sections = [one for one in source.model.parts("assembly", "assembly", shaft.id, "part") if one.type == "shaft_section"]
    place = source.places.along(gear, shaft, "gear_place")
    return [source.number(one, name) for one in sections if place is None or _covers(one, place, sections)]


def _covers(section: Component, place: float, sections: list[Component]) -> bool:
    """Whether a section of a shaft lies at a place along it; sections without a place follow one another."""
    length = number_of(section, "section_length").number
    begin = number_of(section, "section_place").number
    if begin is None:
        before = sections[:sections.index(section)]
        begin = sum(number_of(one, "section_length").number or 0.0 for one in before)
    return length is None or begin <= place <= begin + length
