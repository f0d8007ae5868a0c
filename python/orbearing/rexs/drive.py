"""Speeds and torques of a gearbox: which parts rotate together, and what gears make of the loads that the file states.

Bodies are sets of components that are rigidly joined. Each gear stage is one linear condition on their speeds; by
virtual power the same coefficients, times one unknown torque each, are the torques that the stage exerts.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Iterable, Optional

import numpy as np

from orbearing.rexs.model import Component, Model, Relation
from orbearing.rexs.names import direction_of, in_unit, is_true, number_of

JOINTS = ("coupling", "switchable_coupling", "involute_spline_connection", "feather_key_connection", "cylindrical_interference_fit",
          "tapered_interference_fit")
GEARED = ("cylindrical_stage", "bevel_stage")
FLOOR = "casing"
SMALL = 1e-6  # relative: speeds and torques in files have at least six digits
SAME_POWER = 1e-3  # relative, of a load that states torque and power


@dataclass
class Planetary:
    """A planetary stage: its central gears, planets and the shafts that carry them."""

    stage: Component
    sun: Component
    ring: Component
    planets: list[Component]
    planet_shafts: list[Component]
    sun_meshes: list[Component]
    ring_meshes: list[Component]
    pins: list[Component]
    bodies: dict[str, object] = field(default_factory=dict)
    directions: dict[str, float] = field(default_factory=dict)  # -1 where a member's shaft points against the gear unit


@dataclass(frozen=True)
class Member:
    """A member of a stage at one load; power enters the stage where it is positive."""

    speed: float  # [rad/s]
    torque: float  # [N m]

    @property
    def power(self) -> float:
        """[W]"""
        return self.speed * self.torque


class Bodies:
    """Which components rotate as one."""

    def __init__(self, model: Model):
        self._model = model
        self._parent: dict[object, object] = {}
        for casing in model.of_type("gear_casing"):
            self.join(casing.id, FLOOR)
        for relation in model.relations:
            self._join(relation)

    def of(self, component: object) -> object:
        """The body of a component."""
        while (parent := self._parent.get(component, component)) != component:
            component = parent
        return component

    def join(self, one: object, other: object) -> None:
        """Joins two components; the casing stays the name of its body."""
        first, second = self.of(one), self.of(other)
        if first == second:
            return
        if first == FLOOR:
            first, second = second, first
        self._parent[first] = second

    def _join(self, relation: Relation) -> None:
        if relation.type == "side":
            assembly = self._model.components.get(relation.part("assembly") or -1)
            if assembly is not None and assembly.type in JOINTS and self._engaged(assembly):
                others = [component for role, component in relation.refs if role != "assembly"]
                for other in others[1:]:
                    self.join(others[0], other)
        elif relation.type == "assembly":
            whole = self._model.components.get(relation.part("assembly") or -1)
            part = self._model.components.get(relation.part("part") or -1)
            if whole is None or part is None:
                return
            if whole.type == "planet_carrier" or (whole.type in ("shaft", "gear_casing") and part.type.endswith("gear")):
                self.join(part.id, whole.id)  # the whole gives the body its name

    def _engaged(self, assembly: Component) -> bool:
        """Whether a clutch is closed in the gear that the model is shifted to."""
        attribute = assembly.attributes.get("is_engaged")
        states = attribute.value if attribute is not None else None
        if not isinstance(states, list) or not states:
            return True  # a single value is not of the attribute's type; the reader notes it
        unit = next(iter(self._model.of_type("gear_unit")), None)
        index = (number_of(unit, "gear_shift").number or 1) - 1 if unit is not None else 0
        return states[min(max(index, 0), len(states) - 1)] in (True, "true")


def shaft_of(model: Model, gear: Component) -> Optional[Component]:
    """The shaft that carries a gear."""
    for relation in model.related("assembly", part=gear.id):
        whole = model.components.get(relation.part("assembly") or -1)
        if whole is not None and whole.type == "shaft":
            return whole
    return None


def gears_of(model: Model, stage: Component) -> list[Component]:
    """Both gears of a stage, or fewer where the file does not name them."""
    for relation in model.related("stage", stage=stage.id):
        found = [model.components.get(relation.part(role) or -1) for role in ("gear_1", "gear_2")]
        return [gear for gear in found if gear is not None]
    return []


def planetary(model: Model, stage: Component) -> Planetary | str:
    """The parts of a planetary stage, or why it cannot be a case."""
    shafts = {one.id: one for one in model.parts("planet_shaft", "planetary_stage", stage.id, "shaft")}
    if not shafts:
        return "no planet shaft is named (relation planet_shaft)"
    planets: dict[int, Component] = {}
    central: dict[int, Component] = {}
    meshes: dict[int, list[Component]] = {}
    for mesh in model.of_type("cylindrical_stage"):
        gears = gears_of(model, mesh)
        carried = [(shaft_of(model, gear), gear) for gear in gears]
        of_planet = [gear for shaft, gear in carried if shaft is not None and shaft.id in shafts]
        others = [gear for gear in gears if gear not in of_planet]
        if len(of_planet) == 2:
            return "two planets mesh with each other; one row of planets between sun and ring is required"
        if len(of_planet) == 1 and len(others) == 1:
            planets.setdefault(of_planet[0].id, of_planet[0])
            central.setdefault(others[0].id, others[0])
            meshes.setdefault(others[0].id, []).append(mesh)
    return _planetary_of(model, stage, shafts, planets, central, meshes)


def _planetary_of(model: Model, stage: Component, shafts: dict, planets: dict, central: dict, meshes: dict) -> Planetary | str:
    suns = [gear for gear in central.values() if gear.type == "cylindrical_gear"]
    rings = [gear for gear in central.values() if gear.type == "ring_gear"]
    if len(suns) != 1 or len(rings) != 1:
        return f"found {len(suns)} suns and {len(rings)} rings; one of each is required"
    carried: dict[int, list[Component]] = {}
    for planet in planets.values():
        carried.setdefault(shaft_of(model, planet).id, []).append(planet)
    if any(len(gears) > 1 for gears in carried.values()):
        return "stepped planets: two gears on a planet shaft; planets of one gear are required"
    if len({_teeth(planet) for planet in planets.values()}) > 1:
        return "planets with different numbers of teeth; equal planets are required"
    pins = model.parts("planet_pin", "planetary_stage", stage.id, "shaft")
    return Planetary(stage, suns[0], rings[0], list(planets.values()), list(shafts.values()), meshes[suns[0].id], meshes[rings[0].id], pins)


def _teeth(gear: Component) -> float:
    return abs(number_of(gear, "teeth").number or 0.0)


class Drive:
    """The kinematic chain of a model."""

    def __init__(self, model: Model, stages: Iterable[Planetary]):
        self.model = model
        self.bodies = Bodies(model)
        self.stages = list(stages)
        self._join_carriers()
        self._rows: list[dict[object, float]] = []
        self._row_of: dict[int, int] = {}
        planet_meshes = set()
        for stage in self.stages:
            self._add_planetary(stage)
            planet_meshes |= {mesh.id for mesh in (*stage.sun_meshes, *stage.ring_meshes)}
        for mesh in model.of_type(*GEARED):
            if mesh.id not in planet_meshes:
                self._add_pair(mesh)
        self.nodes = self._nodes()
        self.torque_of_mesh: dict[int, float] = {}

    def _join_carriers(self) -> None:
        for stage in self.stages:
            shafts = self.model.parts("planet_carrier_shaft", "planetary_stage", stage.stage.id, "shaft")
            carriers = [one for one in self.model.parts("assembly", "assembly", stage.stage.id, "part") if one.type == "planet_carrier"]
            carrier = f"carrier of {stage.stage.id}"
            for one in (*shafts, *carriers):
                self.bodies.join(carrier, one.id)
            stage.bodies.update(sun=self.bodies.of(stage.sun.id), ring=self.bodies.of(stage.ring.id), carrier=self.bodies.of(carrier))
            stage.directions = {name: _direction(self.model, shaft_of(self.model, gear)) for name, gear in (("sun", stage.sun), ("ring", stage.ring))}
            stage.directions["carrier"] = _direction(self.model, next(iter(shafts), None))
        for stage in self.stages:  # after all have joined
            stage.bodies = {name: self.bodies.of(body) for name, body in stage.bodies.items()}

    def _add_planetary(self, stage: Planetary) -> None:
        sun, ring = _teeth(stage.sun), _teeth(stage.ring)
        if not sun or not ring:
            return
        row: dict[object, float] = {}
        for member, teeth in (("sun", sun), ("ring", ring), ("carrier", -sun - ring)):
            row[stage.bodies[member]] = row.get(stage.bodies[member], 0.0) + teeth * stage.directions[member]
        self._row_of[stage.stage.id] = len(self._rows)
        self._rows.append(row)

    def _add_pair(self, mesh: Component) -> None:
        gears = gears_of(self.model, mesh)
        if len(gears) != 2 or not all(_teeth(gear) for gear in gears):
            return
        row: dict[object, float] = {}
        for gear, inward in ((gears[0], 1.0), (gears[1], -1.0 if any(one.type == "ring_gear" for one in gears) else 1.0)):
            body = self.body_of(gear)
            row[body] = row.get(body, 0.0) + inward * _direction(self.model, shaft_of(self.model, gear)) * _teeth(gear)
        self._row_of[mesh.id] = len(self._rows)
        self._rows.append(row)

    def hold(self, body: object) -> None:
        """Holds a body by the casing."""
        self.bodies.join(body, FLOOR)
        self._rows = [_renamed(row, body) for row in self._rows]
        for stage in self.stages:
            stage.bodies = {name: FLOOR if one == body else one for name, one in stage.bodies.items()}
        self.nodes = self._nodes()

    def pair_torque(self, mesh: Component) -> Optional[float]:
        """Torque [N m] that the stage's first gear takes from its shaft at the loads of the last call of members()."""
        row, torque = self._row_of.get(mesh.id), self.torque_of_mesh.get(mesh.id)
        gears = gears_of(self.model, mesh)
        if row is None or torque is None or not gears:
            return None
        return -torque * self._rows[row].get(self.body_of(gears[0]), 0.0)

    def mesh_torque(self, mesh: Component, gear: Component) -> Optional[float]:
        """Torque [N m] that the stage exerts on one of its gears, about the gear's own axis, at the same loads."""
        row, torque = self._row_of.get(mesh.id), self.torque_of_mesh.get(mesh.id)
        if row is None or torque is None:
            return None
        return torque * self._rows[row].get(self.body_of(gear), 0.0)

    def body_of(self, gear: Component) -> object:
        """The body of a gear with its shaft."""
        shaft = shaft_of(self.model, gear)
        return self.bodies.of(shaft.id if shaft is not None else gear.id)

    def _nodes(self) -> list[object]:
        found: dict[object, None] = {}
        for row in self._rows:
            found.update(dict.fromkeys(row))
        for shaft in self.model.of_type("shaft"):
            found[self.bodies.of(shaft.id)] = None
        return list(found)

    def _matrix(self) -> np.ndarray:
        matrix = np.zeros((len(self._rows), len(self.nodes)))
        for index, row in enumerate(self._rows):
            for node, value in row.items():
                matrix[index, self.nodes.index(node)] = value
        return matrix

    def speeds(self, model: Model) -> tuple[dict[object, float], list[str]]:
        """Speed [rad/s] of each body that follows from the stated ones, and contradictions."""
        rows, values = list(self._matrix()), [0.0] * len(self._rows)
        rows = [row / max(np.abs(row).max(), 1.0) for row in rows]
        known = [(self.bodies.of(shaft.id), number_of(shaft, "speed").number) for shaft in model.of_type("shaft")]
        known = [(body, speed) for body, speed in known if speed is not None and body != FLOOR]
        for body, speed in [*known, *([(FLOOR, 0.0)] if FLOOR in self.nodes else [])]:
            rows.append(np.eye(len(self.nodes))[self.nodes.index(body)])
            values.append(speed)
        if not rows or not known:
            return {}, []
        matrix, wanted = np.array(rows), np.array(values)
        solution = np.linalg.lstsq(matrix, wanted, rcond=None)[0]
        largest = max(abs(speed) for _, speed in known) or 1.0
        notes = [] if np.abs(matrix @ solution - wanted).max() <= 1e3 * SMALL * largest else \
            ["the speeds that the file states contradict the numbers of teeth"]
        sure = determined(matrix)
        return {node: float(solution[i]) for i, node in enumerate(self.nodes) if sure[i]}, notes

    def _loads(self, model: Model, speeds: dict[object, float], notes: list[str]) -> tuple[dict[object, float], set[object]]:
        """Stated torques [N m] by body, and bodies with a load whose torque follows from the others."""
        stated: dict[object, float] = {}
        free: set[object] = set()
        loads = [(self.bodies.of(relation.part("assembly")), model.components.get(relation.part("part") or -1))
                 for relation in model.related("assembly") if relation.part("assembly") is not None]
        loads = [(body, load) for body, load in loads if load is not None and load.type == "external_load"]
        defining = any(is_true(load, "defines_torque") for _, load in loads)
        for body, load in loads:
            torque = number_of(load, "torque").number
            power = number_of(load, "load_power").number
            if power is not None and speeds.get(body):
                by_power = power / speeds[body]
                if torque is not None and abs(by_power - torque) > SAME_POWER * abs(torque):
                    notes.append(f"component {load.id} ('{load.name}'): torque_around_u_axis is {torque:.6g} N m; its power at "
                                 f"{in_unit(speeds[body], 'rpm'):.6g} rpm gives {by_power:.6g} N m; the torque is taken")
                torque = by_power if torque is None else torque
            transmits = load.attributes.get("transmits_torque")
            if transmits is not None and transmits.value is False:
                continue
            if torque is None or (defining and not is_true(load, "defines_torque")):
                free.add(body)
            else:
                stated[body] = stated.get(body, 0.0) + torque
        return stated, free - set(stated)

    def members(self, model: Model) -> tuple[dict[int, dict[str, Member]], dict[object, float], list[str]]:
        """Members of each planetary stage at the loads of `model`, about the axis of the gear unit; speeds of all bodies; contradictions."""
        speeds, notes = self.speeds(model)
        stated, free = self._loads(model, speeds, notes)
        stage_torques = self._stage_torques(stated, free) if stated else {}
        if stage_torques is None:
            if not self._has_other_stages():
                notes.append("the torques that the file states contradict each other")
            stage_torques = {}
        members: dict[int, dict[str, Member]] = {}
        for stage in self.stages:
            torque = stage_torques.get(stage.stage.id)
            if torque is None or not all(body in speeds for body in stage.bodies.values()):
                continue
            sun, ring = _teeth(stage.sun), _teeth(stage.ring)
            factors = {"sun": -sun, "ring": -ring, "carrier": sun + ring}
            members[stage.stage.id] = {name: Member(speeds[stage.bodies[name]] * stage.directions[name], torque * factor)
                                       for name, factor in factors.items()}
        self.torque_of_mesh = stage_torques
        return members, speeds, notes

    def _stage_torques(self, stated: dict[object, float], free: set[object]) -> Optional[dict[int, float]]:
        """The torque of each stage per tooth, where it is determined; None where the stated ones contradict each other."""
        if not self.nodes:
            return {}
        for unstated in (free | {node for node in self.nodes if node == FLOOR or not isinstance(node, int)}
                         | {node for node in self.nodes if self.is_open(node)}, set(self.nodes) - set(stated)):
            unknown = [node for node in self.nodes if node in unstated - set(stated)]
            matrix = np.zeros((len(self.nodes), len(self._rows) + len(unknown)))
            matrix[:, :len(self._rows)] = self._matrix().T
            for column, node in enumerate(unknown):
                matrix[self.nodes.index(node), len(self._rows) + column] = 1.0
            wanted = -np.array([stated.get(node, 0.0) for node in self.nodes])
            solution = np.linalg.lstsq(matrix, wanted, rcond=None)[0]
            if np.abs(matrix @ solution - wanted).max() <= SMALL * np.abs(wanted).max():
                sure = determined(matrix)
                return {stage: float(solution[row]) for stage, row in self._row_of.items() if sure[row]}
        return None

    def _has_other_stages(self) -> bool:
        """Whether torques pass through stages that are no rows: worms, bevels without teeth."""
        meshes = {mesh.id for stage in self.stages for mesh in (*stage.sun_meshes, *stage.ring_meshes)}
        return any(one.type.endswith("_stage") and one.id not in self._row_of and one.id not in meshes for one in self.model.components.values())

    def is_open(self, node: object) -> bool:
        """Whether the body is a gear without a shaft: what it is joined to is not in the file."""
        component = self.model.components.get(node) if isinstance(node, int) else None
        return component is not None and component.type.endswith("gear")


def _renamed(row: dict[object, float], body: object) -> dict[object, float]:
    renamed: dict[object, float] = {}
    for node, value in row.items():
        name = FLOOR if node == body else node
        renamed[name] = renamed.get(name, 0.0) + value
    return renamed


def _direction(model: Model, shaft: Optional[Component]) -> float:
    """-1 where the shaft's axis points against that of the gear unit."""
    axis = direction_of(shaft, "u_axis_vector") if shaft is not None else None
    unit = next(iter(model.of_type("gear_unit")), None)
    main = direction_of(unit, "u_axis_vector") if unit is not None else None
    return -1.0 if axis and np.dot(axis, main or [1.0, 0.0, 0.0]) < 0.0 else 1.0


def determined(matrix: np.ndarray) -> np.ndarray:
    """Which unknowns of the equations have one value alone."""
    _, singular, rows = np.linalg.svd(matrix)
    rank = int((singular > 1e-9 * singular.max()).sum()) if len(singular) else 0
    return (np.abs(rows[rank:]) < SMALL).all(axis=0) if rank < matrix.shape[1] else np.ones(matrix.shape[1], dtype=bool)
