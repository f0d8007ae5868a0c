"""Gear pairs outside planetary stages, and bearings of shafts, as cases of their own."""

from __future__ import annotations

import math
from typing import Optional

from orbearing.rexs.drive import Drive, gears_of
from orbearing.rexs.geometry import SAME_SHIFT, Teeth
from orbearing.rexs.ledger import Draft
from orbearing.rexs.model import Component
from orbearing.rexs.names import CATALOGUE, attribute_of, number_of, text_of
from orbearing.rexs.parts import BALLS, ROLLERS, Heights, Inside, Source, common, narrowest, put_fillet, put_heights, put_life, put_material, put_oil
from orbearing.rexs.stages import sections_of
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
        if module is None or any(value is None for value, _ in counted):
            return None
        numbers = [abs(int(value)) for value, _ in counted]
        draft.put("pair.teeth", numbers, *(origin for _, origin in counted))
        draft.put("pair.module", quantity(module, "mm"), *origins)
        teeth = Teeth(module, self._put_angle(), self._put_helix())
        shifts = self._put_shifts(teeth, numbers)
        heights = {str(i): Heights(source, gear, teeth, numbers[i], shifts[i]) for i, gear in enumerate(gears)}
        put_heights(source, draft, "pair", heights)
        put_fillet(source, draft, "pair", gears)
        return teeth, numbers, shifts

    def _put_angle(self) -> float:
        found = [self.source.of_flanks(gear, "pressure_angle") for gear in self.gears]
        value = next((value for value, _ in found if value is not None), None)
        if value is None:
            self.source.ledger.miss(self.draft.name, "pair.pressure_angle", "pressure_angle", None, "no flank states it", "20 deg")
            return 20.0
        self.draft.put("pair.pressure_angle", quantity(value, "deg"), *(origin for one, origins in found if one == value for origin in origins))
        return value

    def _put_helix(self) -> float:
        first, second = (self.source.number(gear, "helix") for gear in self.gears)
        value = first[0] if first[0] is not None else -(second[0] or 0.0) + 0.0
        fitting = second[1] if second[0] is not None and abs(abs(second[0]) - abs(value)) < 1e-6 else None
        self.draft.put("pair.helix_angle", quantity(value, "deg"), first[1], *([fitting] if fitting else []))
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
            self.notes.append(f"{self.draft.name}: the profile shifts add up to {stated:.6g}; the centre distance of {distance:.6g} mm requires "
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
            self.draft.assume("pair.bore", quantity(round(0.5 * root, 3), "mm"), "not stated in the file: half the root diameter of the smaller gear")
            return
        least = min(value for value, _ in found)
        self.draft.put("pair.bore", quantity(least, "mm"), *(origin for value, origin in found if value == least))
        for value, origin in found:
            if value > least:
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
            figures["centre_distance_mm"] = distance
        speed = self.speeds.get(self.drive.body_of(self.gears[0])) if self.gears else None
        if speed is not None:
            figures["driving_speed_rpm"] = speed
        if torque is not None and len(gears) == 2:
            scale = 1.0 if self.gears[0] is gears[0] else number_of(gears[1], "teeth").number / number_of(gears[0], "teeth").number
            figures["driving_torque_N_m"] = abs(torque * scale)
        return figures


class BearingCase:
    """The draft of the case of one bearing of a shaft, under the load that the file states for it."""

    def __init__(self, source: Source, drive: Drive, bearing: Component, shaft: Component, outer: Component, name: str,
                 forces: dict[int, tuple[float, float]], speeds: dict[object, float], load: str):
        self.source, self.drive, self.bearing, self.shaft, self.outer = source, drive, bearing, shaft, outer
        self.forces, self.load, self.speeds = forces.get(bearing.id), load, speeds
        self.kind = text_of(bearing, "bearing_type")
        self.balls = self.kind in BALLS
        self.draft = Draft(name, "ball-bearing" if self.balls else "roller-bearing", source.text)
        self.problem = ""
        self.notes: list[str] = []

    def build(self) -> Draft:
        """Inside, ratings, load, speeds, oil and life."""
        if self.bearing.type not in CATALOGUE:
            self.problem = "a concept bearing has no inside"
        elif self.kind not in (*BALLS, *ROLLERS):
            self.problem = f"'{self.kind}': cylindrical roller, needle roller, deep groove and angular contact ball bearings are known"
        if self.problem:
            return self.draft
        self.draft.origins["model"] = [(self.bearing, attribute) for attribute in [attribute_of(self.bearing, "bearing_type")] if attribute is not None]
        Inside(self.source, self.draft, self.bearing, self.balls).put()
        self._put_load()
        self._put_speeds()
        put_oil(self.source, self.draft, [self.bearing], [self.source.model.with_load_case(one) for one in self.source.model.load_cases])
        put_life(self.source, self.draft, self.bearing)
        return self.draft

    def _put_load(self) -> None:
        v, w, u = (self.source.number(self.bearing, name) for name in ("force_v", "force_w", "force_u"))
        if v[0] is None and w[0] is None:
            self._put_reaction()
            return
        self.draft.put("load.radial", quantity(math.hypot(v[0] or 0.0, w[0] or 0.0), "kN"), v[1], w[1])
        if u[0] and self.balls:
            self.draft.put("load.axial", quantity(abs(u[0]), "kN"), u[1])
        elif u[0]:
            self.source.ledger.leave(*u[1], "a roller-bearing carries no axial load")

    def _put_reaction(self) -> None:
        if self.forces is None:
            self.problem = "no load: the file states no force of this bearing, and statics of its shaft does not give it"
            self.source.ledger.miss(self.draft.name, "load.radial", "force_v", self.bearing, self.problem)
            return
        radial, axial = self.forces
        reason = f"statics of the shafts under {self.load}, without weights"
        for path, name, force in (("load.radial", "force_v", radial), ("load.axial", "force_u", axial if self.balls else 0.0)):
            if force > 0.0:
                self.source.ledger.miss(self.draft.name, path, name, self.bearing, reason, quantity(force, "kN"))
                self.draft.assume(path, quantity(force, "kN"), reason)

    def _put_speeds(self) -> None:
        speeds = {}
        for name, part, path in (("inner_speed", self.shaft, "operation.shaft_speed"), ("outer_speed", self.outer, "operation.outer_speed")):
            value, origin = self.source.number(self.bearing, name)
            if value is None:
                value = self.speeds.get(self.drive.bodies.of(part.id))
                origin = (self.bearing, None)
            if value:
                speeds[path] = (value, origin)
        turned = math.copysign(1.0, next(iter(speeds.values()))[0]) if speeds else 1.0  # a case counts the first as positive
        for path, (value, origin) in speeds.items():
            self.draft.put(path, quantity(turned * value, "rpm"), origin)

    def take(self) -> None:
        """All that the case holds."""
        self.source.ledger.take(self.draft)

    def figures(self) -> dict[str, float]:
        """Nothing beyond the case."""
        return {}

    def bearing_sets(self) -> list[list[Component]]:
        """The bearing itself."""
        return [[self.bearing]]

