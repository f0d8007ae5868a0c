"""A REXS model in memory, the same for XML, JSON and ZIP: components with attributes, relations, load cases."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Iterator, Optional


@dataclass(frozen=True)
class Attribute:
    """A value as the file states it; `value` is a number, a text, a truth value, a list, or None where it is empty."""

    id: str
    unit: str
    value: Any
    file: str = ""  # beside the model, which states it; empty: the model itself


@dataclass
class Component:
    """A part or a result set, with its attributes by id."""

    id: int
    type: str
    name: str
    attributes: dict[str, Attribute] = field(default_factory=dict)

    def __hash__(self) -> int:
        return hash(self.id)


@dataclass(frozen=True)
class Relation:
    """Which components belong together: pairs of role and component id."""

    id: str
    type: str
    refs: tuple[tuple[str, int], ...]

    def part(self, role: str) -> Optional[int]:
        """The component in this role, or None."""
        return next((component for name, component in self.refs if name == role), None)


@dataclass
class LoadCase:
    """Attributes that replace or extend those of the components while this load acts."""

    id: str
    components: list[Component] = field(default_factory=list)


@dataclass
class Model:
    """All that a file states. `notes` are what the reader could not use."""

    version: str
    application: str
    components: dict[int, Component] = field(default_factory=dict)
    relations: list[Relation] = field(default_factory=list)
    load_cases: list[LoadCase] = field(default_factory=list)
    accumulation: list[Component] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    unread: dict[int, str] = field(default_factory=dict)  # by component: why what stands in another file is not there

    def of_type(self, *types: str) -> list[Component]:
        """Components of these types in the order of the file."""
        return [component for component in self.components.values() if component.type in types]

    def related(self, type_: str, **roles: int) -> Iterator[Relation]:
        """Relations of a type in which these components have these roles."""
        for relation in self.relations:
            if relation.type == type_ and all(relation.part(role) == wanted for role, wanted in roles.items()):
                yield relation

    def parts(self, type_: str, whole: str, component: int, part: str) -> list[Component]:
        """Components in the role `part` of the relations where `component` has the role `whole`."""
        found = (relation.part(part) for relation in self.related(type_, **{whole: component}))
        return [self.components[one] for one in found if one in self.components]

    def with_load_case(self, load_case: LoadCase) -> "Model":
        """The model while this load acts."""
        components = dict(self.components)
        for change in load_case.components:
            base = components.get(change.id)
            if base is not None:
                components[change.id] = Component(base.id, base.type, base.name, {**base.attributes, **change.attributes})
        return Model(self.version, self.application, components, self.relations)
