"""Gear pairs outside planetary stages, and bearings of shafts, as cases of their own."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional

from orbearing.rexs.drive import FLOOR, Drive, gears_of
from orbearing.rexs.geometry import SAME_SHIFT, Teeth
from orbearing.rexs.ledger import Draft
from orbearing.rexs.model import Component, Model
from orbearing.rexs.names import CATALOGUE, KNOWN, attribute_of, in_unit, number_of, same_number, text_of
from orbearing.rexs.parts import (BALLS, ROLLERS, Heights, Inside, Source, common, narrowest, pressure_angle, put_fillet, put_heights, put_life, put_material,
                                  put_oil, rows_of, unlike_modules)
from orbearing.rexs.reactions import BearingForce
from orbearing.rexs.stages import SAME_HELIX, sections_of
from orbearing.rexs.writing import quantity


class PairCase:
    """The draft of the case of one gear pair."""

    def __init__(self, source: Source, drive: Drive, mesh: Component, name: str, speeds: dict[object, float]):
        self.source, self.drive, self.mesh, self.speeds = source, drive, mesh, speeds
        self.draft = Draft(name, "gear-pair", source.text)
        self.gears = gears_of(source.model, mesh)
        self.problem = ""
        self.notes: list[str] = []

    def build(self) -> Draft:
        """Teeth, sizes and material of both gears, the driving one first."""
        if len(self.gears) != 2:
            self.problem = f"found {len(self.gears)} gears (relation stage); two are required"
        elif any(gear.type == "ring_gear" for gear in self.gears):
            self.problem = "an internal pair, which is not converted: state it in a gear-pair case with pair.kind: internal"
        else:
            self.problem = unlike_modules(self.source, self.gears)
        if self.problem:
            return self.draft
        if self._second_drives():
            self.gears.reverse()
        numbers = self._put_teeth()
        put_material(self.source, self.draft, self.gears)
        if numbers:
            self._put_bore(*numbers)
        return self.draft

    def _second_drives(self) -> bool:
        """Whether power enters by the second gear; by the file's word where the loads do not say."""
        torque = self.drive.pair_torque(self.mesh)
        speed = self.speeds.get(self.drive.body_of(self.gears[0]))
        if torque and speed:
            return torque * speed < 0.0
        for relation in self.source.model.related("stage_gear_data", stage=self.mesh.id, gear=self.gears[1].id):
            data = self.source.model.components.get(relation.part("stage_gear_data") or -1)
            attribute = data.attributes.get("is_driving_gear") if data is not None else None
            return attribute is not None and attribute.value is True
        return False

    def _put_teeth(self) -> Optional[tuple[Teeth, list[int], list[float]]]:
        source, draft, gears = self.source, self.draft, self.gears
        counted = [source.number(gear, "teeth") for gear in gears]
        module, origins = common(source, gears, "module")
        width, wide = narrowest(source, gears)
        if width is not None:
            draft.put("pair.face_width", quantity(width, "mm"), *wide)
        if not module or not all(value for value, _ in counted):
            return None
        numbers = [abs(value) for value, _ in counted]
        draft.put("pair.teeth", numbers, *(origin for _, origin in counted))
        draft.put("pair.module", quantity(module, "mm"), *origins)
        teeth = Teeth(module, pressure_angle(source, draft, "pair", gears), self._put_helix())
        shifts = self._put_shifts(teeth, numbers)
        heights = {str(i): Heights(source, gear, teeth, numbers[i], shifts[i]) for i, gear in enumerate(gears)}
        put_heights(source, draft, "pair", heights)
        put_fillet(source, draft, "pair", gears)
        return teeth, numbers, shifts

    def _put_helix(self) -> float:
        first, second = (self.source.number(gear, "helix") for gear in self.gears)
        value = first[0] if first[0] is not None else -(second[0] or 0.0) + 0.0
        fits = second[0] is None or abs(second[0] + value) < SAME_HELIX
        if not fits:
            self.source.ledger.contradict(*second[1], "contradicts the mate's: gears that mesh outside have the same helix angle, of the opposite hand")
        self.draft.put("pair.helix_angle", quantity(value, "deg"), first[1], *([second[1]] if fits else []))
        return value

    def _put_shifts(self, teeth: Teeth, numbers: list[int]) -> list[float]:
        stated = [self.source.shift(gear, teeth.module) for gear in self.gears]
        distance, origin = self.source.number(self.mesh, "centre_distance")
        wanted = teeth.shift_sum(sum(numbers), distance) if distance else None
        shifts = [value for value, _ in stated]
        reason = ""
        if None in shifts and wanted is not None:
            reason = "the centre distance gives what the file does not state"
            known = sum(value for value in shifts if value is not None)
            missing = shifts.count(None)
            shifts = [(wanted - known) / missing if value is None else value for value in shifts]
            self.source.ledger.leave(*origin, "gives the profile shift that is not stated")
        elif None in shifts:
            reason = "neither shift nor centre distance is stated"
            shifts = [value or 0.0 for value in shifts]
        if reason:
            self.source.ledger.miss(self.draft.name, "pair.profile_shift", "shift", None, reason, shifts)
            self.draft.assume("pair.profile_shift", [round(value, 9) for value in shifts], reason)
        else:
            self.draft.put("pair.profile_shift", shifts, *(one for _, origins in stated for one in origins))
            self._compare(wanted, sum(shifts), distance, origin)
        return shifts

    def _compare(self, wanted: Optional[float], stated: float, distance: Optional[float], origin: tuple) -> None:
        if distance is None:
            return
        if wanted is not None and abs(wanted - stated) <= SAME_SHIFT:
            self.source.ledger.leave(*origin, "follows from teeth, module and profile shifts, and agrees")
        else:
            self.notes.append(f"{self.draft.name}: the profile shifts add up to {stated:.6g}; the centre distance of {in_unit(distance, 'mm'):.6g} mm requires "
                              f"{'another pair' if wanted is None else f'{wanted:.6g}'}")
            self.source.ledger.leave(*origin, "contradicts teeth, module and profile shifts, which the case takes")

    def _put_bore(self, teeth: Teeth, numbers: list[int], shifts: list[float]) -> None:
        """The bore of both gears: their own, else the shaft under them, the smaller of both."""
        found = []
        for gear, number, shift in zip(self.gears, numbers, shifts):
            own = self.source.number(gear, "gear_bore")
            stated = [own] if own[0] else sections_of(self.source, gear, "section_outside")
            root = teeth.reference_diameter(number) + 2.0 * teeth.module * (shift - 1.25)
            found += [(value, origin) for value, origin in stated if value and value < 0.98 * root]
        if not found:
            self.source.ledger.miss(self.draft.name, "pair.bore", "gear_bore", None, "neither gears nor shafts state a bore within the roots",
                                    "half the root diameter of the smaller gear")
            root = min(teeth.reference_diameter(number) + 2.0 * teeth.module * (shift - 1.25) for number, shift in zip(numbers, shifts))
            self.draft.assume("pair.bore", quantity(round(0.5 * root, 6), "mm"), "not stated in the file: half the root diameter of the smaller gear")
            return
        least = min(value for value, _ in found)
        self.draft.put("pair.bore", quantity(least, "mm"), *(origin for value, origin in found if same_number(value, least)))
        for value, origin in found:
            if not same_number(value, least):
                self.source.ledger.leave(*origin, "a gear-pair has one bore for both gears; the smaller is taken")

    def take(self) -> None:
        """All that the case holds."""
        self.source.ledger.take(self.draft)

    def figures(self) -> dict[str, float]:
        """Speed and torque of the driving gear, where the loads of the file give them; a gear-pair needs neither."""
        torque, gears = self.drive.pair_torque(self.mesh), gears_of(self.source.model, self.mesh)
        figures = {}
        distance = number_of(self.mesh, "centre_distance").number
        if distance is not None:
            figures["centre_distance_mm"] = in_unit(distance, "mm")
        speed = self.speeds.get(self.drive.body_of(self.gears[0])) if self.gears else None
        if speed is not None:
            figures["driving_speed_rpm"] = in_unit(speed, "rpm")
        if torque is not None and len(gears) == 2:
            scale = 1.0 if self.gears[0] is gears[0] else number_of(gears[1], "teeth").number / number_of(gears[0], "teeth").number
            figures["driving_torque_N_m"] = abs(torque * scale)
        return figures


@dataclass(frozen=True)
class LoadPoint:
    """The model at one of its loads: speeds of its bodies and forces of its bearings."""

    load_case: str  # empty: the loads of the file itself
    model: Model
    share: Optional[float]  # [-] of the time; None where the file does not state it
    speeds: dict[object, float]  # [rad/s]
    forces: dict[int, BearingForce]

    @property
    def text(self) -> str:
        return f"load case {self.load_case}" if self.load_case else "the loads of the file"


class BearingCase:
    """The draft of the case of one bearing of a shaft, under one of the loads that the file states."""

    def __init__(self, source: Source, drive: Drive, bearing: Component, shaft: Optional[Component], outer: Optional[Component], name: str, at: LoadPoint):
        self.source, self.drive, self.bearing, self.shaft, self.outer, self.at = source, drive, bearing, shaft, outer, at
        self.loaded = at.model.components.get(bearing.id, bearing)
        self.kind = text_of(bearing, "bearing_type")
        self.balls = self.kind in BALLS
        self.draft = Draft(name, "ball-bearing" if self.balls else "roller-bearing", source.text)
        self.problem = ""
        self.notes: list[str] = []

    def build(self) -> Draft:
        """Inside, ratings, load, speeds, oil and life."""
        if self.bearing.type not in CATALOGUE:
            self.problem = "a concept bearing has no inside"
        elif not self.kind:
            unread = self.source.model.unread.get(self.bearing.id)
            self.problem = unread or "the file states no bearing_type"
        elif self.kind not in (*BALLS, *ROLLERS):
            self.problem = f"'{self.kind}': cylindrical roller, needle roller, deep groove and angular contact ball bearings are known"
        if self.problem:
            return self.draft
        self.draft.origins["model"] = [(self.bearing, attribute) for attribute in [attribute_of(self.bearing, "bearing_type")] if attribute is not None]
        Inside(self.source, self.draft, self.bearing, self.balls).put()
        self._put_load()
        self._put_speeds()
        put_oil(self.source, self.draft, [self.bearing])
        put_life(self.source, self.draft, self.bearing)
        return self.draft

    def _put(self, path: str, value: float, unit: str, *origins: tuple) -> None:
        """A value of the load: what a load case states is reported as of that."""
        own = [(component, attribute) for component, attribute in origins if attribute is not None and self.bearing.attributes.get(attribute.id) is attribute]
        self.draft.put(path, quantity(value, unit), *own)
        for component, attribute in origins:
            if attribute is not None and (component, attribute) not in own:
                self.draft.put_of_load_case(path, self.at.load_case, component, attribute)

    def _stated_force(self) -> Optional[tuple[float, float, list, list]]:
        """Radial and axial force [N] that the file states as its own result, and where they stand."""
        v, w, u = (self.source.number(self.loaded, name) for name in ("force_v", "force_w", "force_u"))
        return None if v[0] is None and w[0] is None else (math.hypot(v[0] or 0.0, w[0] or 0.0), abs(u[0] or 0.0), [v[1], w[1]], [u[1]])

    def _put_load(self) -> None:
        stated = self._stated_force()
        if stated is None:
            self._put_reaction()
            return
        radial, axial, radial_origins, axial_origins = stated
        self._put("load.radial", radial, "kN", *radial_origins)
        if axial and self.balls:
            self._put("load.axial", axial, "kN", *axial_origins)
        elif axial:
            self.source.ledger.leave(*axial_origins[0], "a roller-bearing carries no axial load", self.at.load_case)

    def _put_reaction(self) -> None:
        force = self.at.forces.get(self.bearing.id)
        if force is None:
            self.problem = "no load: the file states no force of this bearing, and statics of its shaft does not give it"
            self.source.ledger.miss(self.draft.name, "load.radial", "force_v", self.bearing, self.problem)
            return
        reason = f"statics of the shafts under {self.at.text}, without weights"
        for path, name, value in (("load.radial", "force_v", force.radial), ("load.axial", "force_u", force.axial if self.balls else 0.0)):
            if value > 0.0:
                self.source.ledger.miss(self.draft.name, path, name, self.bearing, reason, quantity(value, "kN"))
                self.draft.assume(path, quantity(value, "kN"), reason)

    def _speeds(self) -> dict[str, tuple[float, tuple]]:
        """Speed [rad/s] of each ring that the file gives, by the path of a case, and where it stands."""
        speeds = {}
        for name, part, path in (("inner_speed", self.shaft, "operation.shaft_speed"), ("outer_speed", self.outer, "operation.outer_speed")):
            value, origin = self.source.number(self.loaded, name)
            if value is None and part is not None:
                value, origin = 0.0 if self.drive.bodies.of(part.id) == FLOOR else self.at.speeds.get(self.drive.bodies.of(part.id)), (self.bearing, None)
            if value is not None:
                speeds[path] = (value, origin)
        return speeds

    @property
    def stands(self) -> bool:
        """Whether both rings are known to stand at this load, which uses up no life."""
        speeds = self._speeds()
        return bool(speeds) and not any(value for value, _ in speeds.values())

    def _put_speeds(self) -> None:
        speeds = {path: found for path, found in self._speeds().items() if found[0]}
        turned = math.copysign(1.0, next(iter(speeds.values()))[0]) if speeds else 1.0  # a case counts the first as positive
        for path, (value, origin) in speeds.items():
            self._put(path, turned * value, "rpm", origin)

    def take(self) -> None:
        """All that the case holds."""
        self.source.ledger.take(self.draft)

    def figures(self) -> dict[str, float]:
        """Sizes and ratings that the file states, and force and speeds at this load; of bearings that are no case as well."""
        figures = {}
        for name, unit, key in STATED_FIGURES:
            value = number_of(self.bearing, name).number if self.bearing.type in KNOWN[name].components else None
            if value is not None:
                figures[f"{key}_{unit}" if unit else key] = _figure(value, unit)
        rows = rows_of(self.source, self.bearing)
        angles = [value for value in (number_of(row, "contact_angle").number for row in rows) if value is not None]
        if rows:
            figures["rows"] = len(rows)
        if angles:
            figures["contact_angle_deg"] = _figure(abs(angles[0]), "deg")
        return figures | self.load_figures()

    def load_figures(self) -> dict[str, float]:
        """Force and speeds at this load."""
        stated, force, figures = self._stated_force(), self.at.forces.get(self.bearing.id), {}
        if stated is not None or force is not None:
            radial, axial = stated[:2] if stated is not None else (force.radial, force.axial)
            figures |= {"radial_force_N": _figure(radial), "axial_force_N": _figure(axial)}
        for path, (value, _) in self._speeds().items():
            figures[path.removeprefix("operation.") + "_rpm"] = _figure(value, "rpm")
        return figures

    def bearing_sets(self) -> list[list[Component]]:
        """The bearing itself."""
        return [[self.bearing]]


# Attributes of a bearing in the report: name, unit, key.
STATED_FIGURES = (("bore", "mm", "bore"), ("outside", "mm", "outside_diameter"), ("width", "mm", "width"), ("rows", "", "rows"),
                  ("dynamic_capacity", "kN", "C"), ("static_capacity", "kN", "C0"), ("fatigue_limit", "kN", "C_u"), ("contamination", "", "e_C"),
                  ("catalogue_e", "", "e"), ("catalogue_y1", "", "Y1"), ("catalogue_y2", "", "Y2"))


def _figure(value: float, unit: str = "") -> float:
    """Without the last digits, in which one computer differs from another."""
    return float(f"{in_unit(value, unit):.10g}")
