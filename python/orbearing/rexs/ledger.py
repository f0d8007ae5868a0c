"""What became of each attribute of a file: taken into a case, missing for it, or left out."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Optional

from orbearing.rexs.model import Attribute, Component, Model
from orbearing.rexs.names import CATALOGUE, KNOWN, is_number, is_rigid, same_number, unit_of

IN_SPACE = {"support_vector", "u_axis_vector", "w_axis_vector", "reference_component_for_position", "rotating_angle_around_neg_u_axis"}
DESCRIBING = {"part_number", "revision_number", "sequence_number", "version", "modification_date", "display_color", "customer",
              "model_name", "material_designation"}


@dataclass
class Draft:
    """A case in the making: texts of its values by path, where each comes from, and reasons of what is assumed."""

    name: str
    model: str
    source: str
    values: dict[str, Any] = field(default_factory=dict)
    origins: dict[str, list[tuple[Component, Attribute]]] = field(default_factory=dict)
    assumed: dict[str, str] = field(default_factory=dict)
    of_load_cases: list[tuple[str, str, Component, Attribute]] = field(default_factory=list)  # path, load case, and what states it there

    def put(self, path: str, value: Any, *origins: tuple[Component, Optional[Attribute]]) -> None:
        """A value that the file states."""
        self.values[path] = value
        self.origins[path] = [(component, attribute) for component, attribute in origins if attribute is not None]

    def put_of_load_case(self, path: str, load_case: str, component: Component, attribute: Attribute) -> None:
        """Where a value that the draft holds stands in a load case."""
        self.of_load_cases.append((path, load_case, component, attribute))

    def assume(self, path: str, value: Any, reason: str) -> None:
        """A value that the file does not state."""
        self.values[path] = value
        self.assumed[path] = reason

    def remove(self, path: str) -> list[str]:
        """Takes out a value, or all of a block; their paths."""
        gone = [one for one in self.values if one == path or one.startswith(path + ".")]
        for one in gone:
            del self.values[one]
            self.assumed.pop(one, None)
        return gone


class Ledger:
    """The report: three lists, and nothing of the file in none of them."""

    def __init__(self, model: Model):
        self._model = model
        self.taken: list[dict] = []
        self.missing: list[dict] = []
        self.left_out: list[dict] = []
        self._left: dict[tuple, str] = {}
        self._copies: dict[int, list[Component]] = {}
        self._originals: dict[int, int] = {}
        self._contradictions: dict[tuple, list[int]] = {}
        self._unlike: dict[tuple, list[int]] = {}  # of copies
        self.refused: dict[str, list[str]] = {}  # values of the file that the check of a case does not let pass: path and reason, and in which cases

    def miss(self, case: str, key: str, name: str, component: Optional[Component], reason: str, instead: Any = None) -> None:
        """A key of a case for which the file has nothing; `instead`: what the case takes."""
        known = KNOWN.get(name)
        self.missing.append({"component": component.id if component is not None else None,
                             "attribute": known.names[0] if known else None, "value": None, "unit": known.unit if known else None,
                             "case": case, "key": key, "instead": instead, "reason": reason})

    def forget(self, case: str, blocks: tuple[str, ...]) -> None:
        """Takes back what was said to be missing in blocks of a case that it no longer has."""
        self.missing = [entry for entry in self.missing if entry["case"] != case or entry["key"].split(".")[0] not in blocks]

    def leave(self, component: Component, attribute: Optional[Attribute], reason: str, load_case: str = "") -> None:
        """An attribute that no case takes, with the particular reason; the last one stays."""
        if attribute is not None:
            self._left[(load_case, component.id, attribute.id)] = reason

    def contradict(self, component: Component, attribute: Optional[Attribute], reason: str) -> None:
        """An attribute that contradicts itself or another one, which the case takes; `notes` reports it."""
        if attribute is not None:
            self.leave(component, attribute, reason)
            _list(self._contradictions, component, attribute, reason)

    @property
    def notes(self) -> list[str]:
        """The contradictions: which attribute of which components, and why it is left out."""
        taken = {(entry["component"], entry["attribute"]) for entry in self.taken}  # of a planet's second bearing, as of the first planet's second
        unlike = {key: [one for one in components if (one, key[0]) not in taken] for key, components in self._unlike.items()}
        return [f"{', '.join(names)}: {what}; left out" for what, names in self.refused.items()] + [
            f"component {', '.join(map(str, components))}: {name} {value[:40]}{f' {unit}' if unit not in ('', 'none') else ''}: {reason}"
            for (name, value, unit, reason), components in [*self._contradictions.items(), *unlike.items()] if components]

    def alike(self, original: Component, copies: list[Component]) -> None:
        """Parts that a case states once: those of the other planets."""
        self._copies.setdefault(original.id, []).extend(copies)
        for copy in copies:
            self._originals.setdefault(copy.id, original.id)

    def take(self, draft: Draft) -> None:
        """All that the draft holds in the end; copies with it, where they are as their original."""
        for path in (*draft.values, "model"):
            own = {(component.id, attribute.id) for component, attribute in draft.origins.get(path, [])}
            for component, attribute in draft.origins.get(path, []):
                self._take(component, attribute, draft.name, path)
                for copy in self._copies.get(component.id, []):
                    other = copy.attributes.get(attribute.id)
                    if other is None or (copy.id, other.id) in own:
                        continue
                    if _same(other, attribute):
                        self._take(copy, other, draft.name, path, copy_of=component.id)
                    else:
                        reason = f"differs from component {component.id}; all planets of a case, and all bearings of a planet, are alike"
                        self.leave(copy, other, reason)
                        _list(self._unlike, copy, other, reason)
        for path, load_case, component, attribute in draft.of_load_cases:
            if path in draft.values:
                self._take(component, attribute, draft.name, path, load_case=load_case)

    def _take(self, component: Component, attribute: Attribute, case: str, key: str, **more: Any) -> None:
        self.taken.append({**_entry(component, attribute), "case": case, "key": key, **more})

    def take_spectrum(self, draft: Draft, rows: list[tuple[str, Component, Attribute]]) -> None:
        """Attributes of load cases that became rows of the spectrum or the operating point."""
        for load_case, component, attribute in rows:
            self._take(component, attribute, draft.name, "spectrum" if "spectrum" in draft.values else "input", load_case=load_case)

    def close(self) -> None:
        """Lists as left out what has been neither taken nor named so far."""
        taken = {(entry.get("load_case", ""), entry["component"], entry["attribute"]) for entry in self.taken}
        for load_case, component in [("", one) for one in self._model.components.values()] \
                + [(case.id, one) for case in self._model.load_cases for one in case.components] \
                + [("accumulation", one) for one in self._model.accumulation]:
            for attribute in component.attributes.values():
                key = (load_case, component.id, attribute.id)
                if key not in taken:
                    reason = self._reason(component, attribute, load_case)
                    self.left_out.append({**_entry(component, attribute), "reason": reason, **({"load_case": load_case} if load_case else {})})

    def _reason(self, component: Component, attribute: Attribute, load_case: str) -> str:
        particular = self._left.get((load_case, component.id, attribute.id))
        original, seen = self._originals.get(component.id), {component.id}
        while particular is None and original is not None and original not in seen:  # a file may name parts in circles
            seen.add(original)
            inherited = self._left.get((load_case, original, attribute.id))
            particular = f"as of component {original}: {inherited}" if inherited else None
            original = self._originals.get(original)
        return particular or reason_of(component, attribute, load_case)


def _list(found: dict[tuple, list[int]], component: Component, attribute: Attribute, reason: str) -> None:
    """Adds a component to those of which the same attribute says the same wrong."""
    components = found.setdefault((attribute.id, str(attribute.value), attribute.unit, reason), [])
    if component.id not in components:
        components.append(component.id)


def _entry(component: Component, attribute: Attribute) -> dict:
    entry = {"component": component.id, "type": component.type, "attribute": attribute.id, "value": _json_value(attribute.value), "unit": attribute.unit}
    return {**entry, "file": attribute.file} if attribute.file else entry


def _json_value(value: Any) -> Any:
    """The value; a number that JSON does not have, as text."""
    if isinstance(value, list):
        return [_json_value(one) for one in value]
    if isinstance(value, dict):
        return {str(key): _json_value(one) for key, one in value.items()}
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


def _same(one: Attribute, other: Attribute) -> bool:
    units = unit_of(one.unit), unit_of(other.unit)
    if is_number(one.value) and is_number(other.value) and None not in units and units[0].quantity == units[1].quantity:
        return same_number(*(value.value * unit.factor + unit.offset for value, unit in zip((one, other), units)))
    return (one.value, one.unit) == (other.value, other.unit)


def reason_of(component: Component, attribute: Attribute, load_case: str) -> str:
    """Why an attribute is left out, where nothing particular is known."""
    if load_case == "accumulation":
        return "a result of another program"
    if attribute.value is None:
        return "has no value"
    if attribute.id in IN_SPACE:
        return "position in space; a case states distances along the shaft and between axes alone"
    if attribute.id in ("data_source", "referenced_component_id"):
        return "names the part of another file that describes this one"
    if attribute.id in DESCRIBING:
        return "describes the part, does not size it"
    if is_rigid(attribute):
        return "says that the part is rigid; not taken as a number"
    if attribute.id.startswith("custom_"):
        return "an extension of one program"
    if component.type in CATALOGUE and any(word in attribute.id for word in ("rating_life", "equivalent", "life_modification", "hertzian",
                                                                             "deflection", "acting_on", "viscosity_ratio")):
        return "a result of another program"
    if attribute.id.startswith("u_coordinate_on_shaft"):
        return "place along a shaft that no key of a case needs"
    return "no key of a case takes this attribute of this type of component"
