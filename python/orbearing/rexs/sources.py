"""Parts that stand in other files beside the model, as libraries of bearings and shafts do (attributes data_source and
referenced_component_id, REXS 1.5): read from the folder of the model and put into it.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Iterator, Optional

from orbearing.errors import CaseError
from orbearing.rexs import reading
from orbearing.rexs.model import Attribute, Component, Model, Relation

SOURCE, REFERENCED = "data_source", "referenced_component_id"
WHOLES = ("assembly", "origin", "gear", "workpiece")  # roles of the part that others belong to
BETWEEN = ("side", "stage", "stage_gear_data", "flank_pair")  # relations with parts that stand for themselves


def completed(model: Model, file: Path) -> Model:
    """The model with what stands in files of its own folder. What is not found is a note, and each part keeps what it states itself."""
    files: dict[Path, Model | str] = {}
    for component in list(model.components.values()):
        stated = component.attributes.get(SOURCE)
        if stated is None or stated.value is None:
            continue
        found = _referenced(component, str(stated.value), file, files)
        if isinstance(found, str):
            model.unread[component.id] = found
            model.notes.append(f"component {component.id} ('{component.name}'): {found}; not read")
        else:
            _take_over(model, component, str(stated.value), *found)
    return model


def _referenced(component: Component, name: str, file: Path, files: dict) -> tuple[Model, Component] | str:
    """The other file's model and the part in it; or why there is none."""
    other = _model_beside(name, file, files)
    if isinstance(other, str):
        return other
    attribute = component.attributes.get(REFERENCED)
    number = _whole(attribute)
    if number is None:
        return f"the file '{name}' is named without the id of a component in it ({REFERENCED})"
    part = other.components.get(number)
    if part is None:
        return f"the file '{name}' has no component {number}"
    if part.type != component.type:
        return f"component {number} of the file '{name}' is a {part.type}, this one a {component.type}"
    return other, part


def _whole(attribute: Optional[Attribute]) -> Optional[int]:
    value = attribute.value if attribute is not None else None
    return int(value) if isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e18 and value == int(value) else None


def _model_beside(name: str, file: Path, files: dict) -> Model | str:
    """The model of a file in the folder of this one."""
    folder = file.resolve().parent
    try:
        path = (folder / name).resolve()
    except (OSError, ValueError, RuntimeError):
        return f"'{name}' is no name of a file"
    if not path.is_relative_to(folder):
        return f"the file '{name}' is outside the folder of the model"
    if path not in files:
        files[path] = _read(path, name) if path != file.resolve() else f"the file '{name}' is the model itself"
    return files[path]


def _read(path: Path, name: str) -> Model | str:
    if not path.is_file():
        others = sorted(one.name for one in path.parent.glob("*") if one.stem == path.stem and one.name.lower().endswith(reading.MODEL_NAMES)) \
            if path.parent.is_dir() else []
        return f"the file '{name}' is not in the folder of the model" + (f", which has '{others[0]}'" if others else "")
    try:
        return reading.read(path)
    except CaseError as error:
        return f"the file '{name}' cannot be read ({error.mistakes[0].text})"


def _take_over(model: Model, component: Component, name: str, other: Model, part: Component) -> None:
    """Attributes that the component does not state itself, and the parts that belong to the other."""
    for attribute in part.attributes.values():
        own = component.attributes.get(attribute.id)
        if attribute.id not in (SOURCE, REFERENCED) and (own is None or own.value is None):
            component.attributes[attribute.id] = replace(attribute, file=name)
    if SOURCE in part.attributes:
        model.notes.append(f"component {component.id} ('{component.name}'): component {part.id} of the file '{name}' refers to a third file; not read")
    fresh = max(model.components) + 1
    numbers = {part.id: component.id}
    for inner in _belonging(other, part):
        numbers[inner.id] = fresh
        model.components[fresh] = Component(fresh, inner.type, inner.name,
                                            {key: replace(attribute, file=name) for key, attribute in inner.attributes.items()})
        fresh += 1
    for relation in other.relations:
        if relation.type not in BETWEEN and all(one in numbers for _, one in relation.refs) and relation.refs:
            model.relations.append(Relation(f"{name}: {relation.id}", relation.type, tuple((role, numbers[one]) for role, one in relation.refs)))


def _belonging(model: Model, part: Component) -> Iterator[Component]:
    """Components that belong to a part, and to these in turn."""
    seen, waiting = {part.id}, [part.id]
    while waiting:
        whole = waiting.pop(0)
        for relation in model.relations:
            if relation.type in BETWEEN or whole not in (one for role, one in relation.refs if role in WHOLES):
                continue
            for role, one in relation.refs:
                if role not in WHOLES and one not in seen and one in model.components:
                    seen.add(one)
                    waiting.append(one)
                    yield model.components[one]
