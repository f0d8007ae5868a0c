"""Forces of the bearings of shafts by statics, where two bearings hold each shaft.

Mesh forces act at the pitch points, external loads where the file has them; weights are left out. v and w are the
directions across the shafts, u along them; the axes of all shafts point the same way.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Iterator, Optional

import numpy as np

from orbearing.rexs.drive import SMALL, Drive, determined, gears_of, shaft_of
from orbearing.rexs.geometry import Teeth
from orbearing.rexs.model import Component, Model
from orbearing.rexs.names import direction_of, number_of, place_of, text_of
from orbearing.rexs.parts import is_bearing
from orbearing.rexs.places import Places


@dataclass(frozen=True)
class Force:
    """A force [N] on a shaft at a place along it [m], and moments about v and w [N m]."""

    shaft: int
    place: float
    u: float
    v: float
    w: float
    moment_v: float = 0.0
    moment_w: float = 0.0


def _mesh_forces(drive: Drive, places: Places, model: Model) -> Iterator[Optional[Force]]:
    """Forces of each external pair on its shafts; None where they do not follow from the file."""
    for mesh in model.of_type("cylindrical_stage"):
        gears = gears_of(model, mesh)
        if len(gears) != 2 or any(gear.type == "ring_gear" for gear in gears):
            yield None
            continue
        for gear, mate in (gears, gears[::-1]):
            yield _gear_force(drive, places, model, mesh, gear, mate)


def _gear_force(drive: Drive, places: Places, model: Model, mesh: Component, gear: Component, mate: Component) -> Optional[Force]:
    torque, shaft = drive.mesh_torque(mesh, gear), shaft_of(model, gear)
    here, there = (_axis_of(model, one) for one in (gear, mate))
    numbers = {name: number_of(gear, name).number for name in ("teeth", "module", "helix")}
    place = places.along(gear, shaft, "gear_place")
    if torque is None or shaft is None or not here or not there or place is None or None in numbers.values():
        return None
    across = np.array([there[1] - here[1], there[2] - here[2]])
    distance = float(np.hypot(*across))
    mate_teeth = number_of(mate, "teeth").number
    if distance == 0.0 or not mate_teeth:
        return None
    teeth = Teeth(numbers["module"], _angle(model, gear), numbers["helix"])
    pitch_radius = distance * numbers["teeth"] / (numbers["teeth"] + mate_teeth)
    if pitch_radius <= 0.0:
        return None
    reference_radius = 0.5 * teeth.reference_diameter(numbers["teeth"])
    towards = across / distance
    around = np.array([-towards[1], towards[0]])
    tangential = torque / pitch_radius
    ratio = reference_radius * math.cos(teeth.transverse_angle) / pitch_radius
    if not 0.0 < ratio:
        return None
    radial = abs(tangential) * math.tan(math.acos(min(ratio, 1.0)))
    axial = -torque / reference_radius * math.tan(numbers["helix"])
    v, w = tangential * around - radial * towards
    # The axial force acts at the pitch point: r x F = (v r, w r) x (F along u).
    return Force(shaft.id, place, axial, float(v), float(w), pitch_radius * towards[1] * axial, -pitch_radius * towards[0] * axial)


def _axis_of(model: Model, gear: Component) -> Optional[list[float]]:
    """A point of the gear's axis: its own place, else that of its shaft."""
    shaft = shaft_of(model, gear)
    return place_of(gear) or (place_of(shaft) if shaft is not None else None)


def _angle(model: Model, gear: Component) -> float:
    """[rad]"""
    for relation in model.related("flank", gear=gear.id):
        for side in ("left", "right"):
            flank = model.components.get(relation.part(side) or -1)
            angle = number_of(flank, "pressure_angle").number if flank is not None else None
            if angle is not None:
                return angle
    return math.radians(20.0)


def _external_forces(model: Model) -> Iterator[Optional[Force]]:
    """Forces that the file states on shafts; None where one cannot be read or acts nowhere."""
    for relation in model.related("assembly"):
        shaft, load = (model.components.get(relation.part(role) or -1) for role in ("assembly", "part"))
        if shaft is None or load is None or shaft.type != "shaft" or load.type != "external_load":
            continue
        read = [number_of(load, f"load_{name}") for name in ("force_u", "force_v", "force_w", "torque_v", "torque_w", "place")]
        u, v, w, torque_v, torque_w, place = (one.number or 0.0 for one in read)
        if any(one.problem for one in read) or (read[-1].number is None and (v or w)):
            yield None
        else:
            yield Force(shaft.id, place, u, v, w, torque_v, torque_w)


@dataclass(frozen=True)
class Support:
    """A bearing between a shaft and the casing, or another shaft; places along each [m]."""

    bearing: Component
    inner: Component
    inner_place: float
    outer: Component
    outer_place: float


def _supports(places: Places, model: Model) -> Optional[list[Support]]:
    """All bearings between shafts and casing; None where one has no place."""
    found = []
    for relation in model.related("side"):
        bearing, inner, outer = (model.components.get(relation.part(role) or -1) for role in ("assembly", "inner_part", "outer_part"))
        if not is_bearing(bearing) or inner is None or outer is None:
            continue
        inner_place, outer_place = places.along(bearing, inner, "inner_place"), places.along(bearing, outer, "outer_place")
        if inner_place is None or (outer.type == "shaft" and outer_place is None):
            return None
        found.append(Support(bearing, inner, inner_place, outer, outer_place or 0.0))
    return found


@dataclass(frozen=True)
class BearingForce:
    """What a bearing carries."""

    radial: float  # [N]
    axial: float  # [N]


def bearing_forces(drive: Drive, places: Places, model: Model) -> dict[int, BearingForce]:
    """Force of each bearing that follows from statics alone, at the loads of drive.members(model)."""
    supports = _supports(places, model)
    forces = [*_mesh_forces(drive, places, model), *_external_forces(model)]
    turned = any((direction_of(shaft, "u_axis_vector") or [1.0])[0] < 0.0 for shaft in model.of_type("shaft"))
    if not supports or None in forces or turned or not any(force.u or force.v or force.w or force.moment_v or force.moment_w for force in forces):
        return {}
    shafts = [shaft.id for shaft in model.of_type("shaft")]
    matrix, wanted = np.zeros((4 * len(shafts), 2 * len(supports))), np.zeros(4 * len(shafts))
    for force in forces:
        _add(wanted, 4 * shafts.index(force.shaft), force.place, force.v, force.w, force.moment_v, force.moment_w)
    for column, support in enumerate(supports):
        for part, place, sign in ((support.inner, support.inner_place, 1.0), (support.outer, support.outer_place, -1.0)):
            if part.id in shafts:
                _add(matrix[:, 2 * column], 4 * shafts.index(part.id), place, sign, 0.0, 0.0, 0.0)
                _add(matrix[:, 2 * column + 1], 4 * shafts.index(part.id), place, 0.0, sign, 0.0, 0.0)
    solution = np.linalg.lstsq(matrix, -wanted, rcond=None)[0]
    if np.abs(matrix @ solution + wanted).max() > SMALL * max(np.abs(wanted).max(), 1.0):
        return {}
    sure = determined(matrix)
    axial = _axial(supports, forces)
    return {support.bearing.id: BearingForce(math.hypot(solution[2 * i], solution[2 * i + 1]), axial.get(support.bearing.id, 0.0))
            for i, support in enumerate(supports) if sure[2 * i] and sure[2 * i + 1]}


def _add(column: np.ndarray, row: int, place: float, v: float, w: float, moment_v: float, moment_w: float) -> None:
    """Forces and moments about v and w of a force at a place along u."""
    column[row:row + 4] += v, w, moment_v - place * w, moment_w + place * v


def _axial(supports: list[Support], forces: list[Force]) -> dict[int, float]:
    """Axial force [N] of the bearing that holds each shaft along its axis, where one alone does in that sense."""
    taken = {}
    for shaft in {force.shaft for force in forces}:
        thrust = sum(force.u for force in forces if force.shaft == shaft)
        senses = ("both_directions", "positive" if thrust > 0.0 else "negative")
        holding = [one for one in supports if one.inner.id == shaft and text_of(one.bearing, "axial_sense") in senses]
        if len(holding) == 1:
            taken[holding[0].bearing.id] = abs(thrust)
    return taken

