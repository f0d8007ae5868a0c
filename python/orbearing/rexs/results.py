"""Lives and loads of a run back into its REXS file: the file as it is, with result attributes added."""

from __future__ import annotations

import json
import math
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterable, Optional

from orbearing.errors import CaseError
from orbearing.rexs import reading
from orbearing.rexs.model import Component, Model
from orbearing.whole_files import write_whole

MARK = b"\xef\xbb\xbf"  # the format asks for it
SAME_SPEED = 1e-6  # relative
LAMINAE_FROM = (1, 3)  # the version that brought contacts of rolling elements
DEGREE_IN_WORDS = (1, 4)  # the version that wrote deg in place of the sign
LAMINAE = ("angle", "lamina_place", "inner_lamina_load", "outer_lamina_load")
ARRAYS = (*LAMINAE, "bearing_load", "bearing_L10h", "bearing_L10rh", "bearing_L10mh", "bearing_L10mrh")
SAME_LOAD = 1e-6  # relative
INNER, OUTER = "inner_raceway_contact", "outer_raceway_contact"


@dataclass(frozen=True)
class Spelling:
    """How an attribute is called from a version on, its unit, and the factor from our column's unit."""

    since: tuple[int, int]
    attribute: str
    unit: str
    factor: float


@dataclass(frozen=True)
class Result:
    """A column of a sweep and its REXS attribute."""

    column: str
    spellings: tuple[Spelling, ...]

    def of(self, version: tuple[int, int]) -> Optional[Spelling]:
        """The spelling of a version; None where the version has no such attribute."""
        return next((one for one in reversed(self.spellings) if one.since <= version), None)


def _hours(column: str, *spellings: tuple[tuple[int, int], str]) -> Result:
    return Result(column, tuple(Spelling(since, name, "h", 1.0) for since, name in spellings))


def _turns(column: str, *spellings: tuple[tuple[int, int], str]) -> Result:
    """Revolutions until version 1.5, millions of them since."""
    return Result(column, tuple(Spelling(since, name, "MRev" if since >= (1, 6) else "none", 1.0 if since >= (1, 6) else 1e6)
                                for since, name in spellings))


RESULTS = (
    _hours("L10h", ((1, 0), "nominal_rating_life_time_din_iso_281"), ((1, 1), "nominal_rating_life_time_iso_281_2007")),
    _turns("L10_Mrev", ((1, 0), "nominal_rating_life_rotations_din_iso_281"), ((1, 1), "nominal_rating_life_rotations_iso_281_2007"),
           ((1, 6), "nominal_rating_life_rotations_iso_281_2007")),
    _hours("L10mh", ((1, 6), "modified_rating_life_time_iso_281_2007")),
    _turns("L10m_Mrev", ((1, 6), "modified_rating_life_rotations_iso_281_2007")),
    _hours("L10rh", ((1, 0), "nominal_reference_rating_life_time_din_26281"), ((1, 7), "nominal_reference_rating_life_time_iso_16281_2008")),
    _turns("L10r_Mrev", ((1, 0), "nominal_reference_rating_life_rotations_din_26281"), ((1, 6), "nominal_reference_rating_life_rotations_din_26281"),
           ((1, 7), "nominal_reference_rating_life_rotations_iso_16281_2008")),
    _hours("L10mrh", ((1, 0), "modified_reference_rating_life_time_din_26281"), ((1, 7), "modified_reference_rating_life_time_iso_16281_2008")),
    _turns("L10mr_Mrev", ((1, 0), "modified_reference_rating_life_rotations_din_26281"), ((1, 6), "modified_reference_rating_life_rotations_din_26281"),
           ((1, 7), "modified_reference_rating_life_rotations_iso_16281_2008")),
    Result("P_N", (Spelling((1, 0), "equivalent_dynamic_bearing_load_din_iso_281", "kN", 1e-3),
                   Spelling((1, 1), "equivalent_dynamic_bearing_load_iso_281_2007", "kN", 1e-3))),
    Result("kappa", (Spelling((1, 0), "viscosity_ratio_din_26281", "none", 1.0), Spelling((1, 1), "viscosity_ratio_according_to_iso_281_2007", "none", 1.0),
                     Spelling((2, 0), "viscosity_ratio_iso_281_2007", "none", 1.0))),
    Result("S0", (Spelling((1, 0), "static_load_safety", "none", 1.0), Spelling((2, 0), "static_safety_factor_iso_76_2006", "none", 1.0))),
    Result("contact_pressure_max_MPa", (Spelling((1, 3), "maximum_hertzian_pressure", "N / mm^2", 1.0),
                                        Spelling((2, 0), "maximum_hertzian_pressure", "MPa", 1.0))),
)


def version_of(text: str) -> tuple[int, int]:
    """Major and minor version."""
    major, minor = text.split(".")[:2]
    return int(major), int(minor)


@dataclass
class Run:
    """A run folder: its case and the row of its operating point."""

    folder: Path
    case: str
    row: dict[str, Any]
    arrays: dict[str, list]
    resolved: Any

    def value(self, column: str, index: int) -> Optional[float]:
        """A column of the row; lives of the bearing of this index, where they differ: of those of a planet, or of all of unlike planets in turn."""
        value = self.row.get(column)
        if not isinstance(value, (int, float)) or isinstance(value, bool):
            return None
        hours = column if column.endswith("h") else column.removesuffix("_Mrev") + "h"
        own, whole = self.arrays.get(f"bearing_{hours}") or [], self.row.get(hours)
        return value * own[index % len(own)] / whole if own and whole else float(value)


def read_run(folder: Path) -> Run:
    """The operating point of a run. Raises CaseError."""
    from orbearing import _core

    try:
        lines = [json.loads(line) for line in (folder / "manifest.jsonl").read_text(encoding="utf-8").splitlines() if line.strip()]
        head, points = lines[0], [line for line in lines[1:] if "row" in line]
    except (OSError, ValueError, IndexError) as error:
        raise CaseError(f"--results: {folder}: no results of a run ({getattr(error, 'strerror', None) or 'its manifest.jsonl cannot be read'}); "
                        "a folder that 'orbearing run' or 'orbearing sweep' wrote is required") from error
    resolved = _core.load(str(folder / "case.resolved.yaml"))
    point = _operating_point(folder, points, resolved)
    if point["row"].get("status") != "ok":
        raise CaseError(f"--results: {folder}: its operating point failed ({point['row'].get('status')}); a run that succeeded is required")
    return Run(folder, str(head.get("case")), point["row"], _arrays(folder / str(point.get("file", ""))), resolved)


def _arrays(file: Path) -> dict[str, list]:
    """What the point's own file has by bearing, place and lamina."""
    import netCDF4

    if not file.is_file():
        return {}
    with netCDF4.Dataset(file) as data:
        return {name: data.variables[name][:].tolist() for name in ARRAYS if name in data.variables}


def _operating_point(folder: Path, points: list[dict], resolved: Any) -> dict:
    """The only point, or that at the case's own speed."""
    if len(points) == 1:
        return points[0]
    try:
        wanted = resolved.value("input.speed") * 30.0 / math.pi
    except (TypeError, ValueError):
        wanted = None
    for point in points:
        speed = point["row"].get("input_speed_rpm")
        if wanted and speed and abs(speed - wanted) <= SAME_SPEED * wanted:
            return point
    raise CaseError(f"--results: {folder}: found {len(points)} points, none at the case's input.speed; a run at that speed is required")


def write_back(file: Path, content: bytes, conversion: Any, runs: list[Path], folder: Path) -> list[dict]:
    """The file with the results of these runs, in its own form, in `folder`. Returns what was written. Raises CaseError."""
    model = reading.read(file, content)  # what cannot be read is refused here
    inner, member = reading.unpacked(content)
    document = _Json(inner) if reading.form_of(inner) == "json" else _Xml(inner)
    written = [_write_run(model, document, conversion, read_run(run)) for run in runs]
    for entry in written:
        entry["file"] = file.name
    whole = document.bytes() if not member else reading.packed(file, content, member, document.bytes())
    folder.mkdir(parents=True, exist_ok=True)
    write_whole(folder / file.name, whole)
    return written


def _write_run(model: Model, document: Any, conversion: Any, run: Run) -> dict:
    planets = conversion.bearings.get(run.case)
    if planets is None:
        known = ", ".join(conversion.bearings) or "none"
        raise CaseError(f"--results: {run.folder}: its case '{run.case}' is no case of this file with a bearing ({known})")
    version, load_case = version_of(model.version), conversion.load_cases.get(run.case, "")
    attributes, not_written = [], []
    for result in RESULTS:
        spelling = result.of(version)
        if spelling is None:
            if run.value(result.column, 0) is not None:
                not_written.append({"column": result.column, "reason": f"REXS {model.version} has no attribute for it"})
            continue
        for planet, bearings in enumerate(planets):
            for index, bearing in enumerate(bearings):
                value = run.value(result.column, planet * len(bearings) + index)
                if value is not None:
                    attributes.append(_written(document, bearing, spelling, value * spelling.factor, result.column, load_case))
    contacts = 0
    if load_case:
        not_written.append({"column": "lamina loads", "reason": f"of load case {load_case} alone; a bearing has one set of contacts"})
    elif version < LAMINAE_FROM:
        not_written.append({"column": "lamina loads", "reason": f"REXS {model.version} has no contacts of rolling elements"})
    else:
        contacts = _write_contacts(model, document, _with_lamina_loads(planets, run, not_written), run, not_written)
    return {"run": str(run.folder), "case": run.case, "written": attributes, "contacts": contacts, "not_written": not_written}


def _written(document: Any, bearing: Component, spelling: Spelling, value: float, column: str, load_case: str) -> dict:
    replaced = document.put(bearing.id, spelling.attribute, spelling.unit, value, load_case)
    return {"component": bearing.id, "attribute": spelling.attribute, "value": value, "unit": spelling.unit, "column": column,
            **({"load_case": load_case} if load_case else {}), **({"replaced": replaced} if replaced is not None else {})}


def _with_lamina_loads(planets: list[list[Component]], run: Run, not_written: list[dict]) -> list[Component]:
    """The bearings whose rollers the run describes: all where they carry alike, else that of each planet that carries most."""
    loads = run.arrays.get("bearing_load") or []
    every = [bearing for bearings in planets for bearing in bearings]
    if len(loads) not in (len(planets[0]), len(every)) or max(loads) - min(loads) <= SAME_LOAD * max(loads):
        return every
    most = loads.index(max(loads))
    if len(loads) == len(every) > len(planets[0]):
        not_written.append({"column": "lamina loads", "reason": "of unlike planets' bearings the run has those of the one that carries most"})
        return [every[most]]
    not_written.append({"column": "lamina loads", "reason": "of a planet's bearings the run has those of the one that carries most"})
    return [bearings[most] for bearings in planets]


def _write_contacts(model: Model, document: Any, bearings: list[Component], run: Run, not_written: list[dict]) -> int:
    """Loads of each roller and of its laminae on both races, as contacts of rolling elements. Returns how many contacts."""
    loads = _lamina_loads(run)
    if loads is None:
        not_written.append({"column": "lamina loads", "reason": "the run has none"})
        return 0
    degree = "deg" if version_of(model.version) >= DEGREE_IN_WORDS else "\u00b0"
    for bearing in bearings:
        row, elements = _row_of(model, document, bearing)
        for index, (angle, contacts) in enumerate(loads):
            element = elements[index].id if index < len(elements) else _like_first(document, row, elements, index)
            document.put(element, "angular_position_around_u", degree, angle)
            for kind, force, places, laminae in contacts:
                contact = document.add("rolling_element_contact", [("rolling_element_contact_type", "none", kind), ("rolling_element_force", "kN", force),
                                                                   ("rolling_element_coordinate", "mm", places), ("rolling_element_lamina_load", "N", laminae)])
                document.relate("assembly", [("assembly", element), ("part", contact)], None)
    return len(bearings) * sum(len(contacts) for _, contacts in loads)


def _row_of(model: Model, document: Any, bearing: Component) -> tuple[int, list[Component]]:
    """The first row of a bearing, made where it has none, and the elements that the file has of it."""
    rows = [one for one in model.parts("ordered_assembly", "assembly", bearing.id, "part") if one.type == "rolling_bearing_row"]
    if rows:
        parts = model.parts("ordered_assembly", "assembly", rows[0].id, "part")
        return rows[0].id, [one for one in parts if one.type == "rolling_element"]
    row = document.add("rolling_bearing_row", [])
    document.relate("ordered_assembly", [("assembly", bearing.id), ("part", row)], 1)
    return row, []


def _like_first(document: Any, row: int, elements: list[Component], index: int) -> int:
    """One more rolling element of a row, with the sizes of the first."""
    sizes = [(one.id, one.unit, one.value) for element in elements[:1] for one in element.attributes.values()
             if one.id != "angular_position_around_u" and isinstance(one.value, (int, float, str))]
    element = document.add("rolling_element", sizes)
    document.relate("ordered_assembly", [("assembly", row), ("part", element)], index + 1)
    return element


def _lamina_loads(run: Run) -> Optional[list[tuple]]:
    """Per roller its angle [deg], and per race force [kN], places [mm] and loads [N] of its laminae; None where the run has none."""
    rollers = run.resolved.value("bearing.rollers") if run.resolved.model() in ("planetary-drivetrain", "roller-bearing") else None
    if not rollers or any(name not in run.arrays for name in LAMINAE):
        return None
    angles, places, inner, outer = (run.arrays[name] for name in LAMINAE)
    step = 2.0 * math.pi / rollers
    found = []
    for roller in range(int(rollers)):
        place = min(range(len(angles)), key=lambda i: abs(math.remainder(angles[i] - roller * step, 2.0 * math.pi)))
        contacts = [(kind, 1e-3 * sum(loads[place]), [1e3 * one for one in places], loads[place]) for kind, loads in ((INNER, inner), (OUTER, outer))]
        found.append((math.degrees(angles[place]) % 360.0, contacts))
    return found


def _text(value: Any) -> str:
    return repr(float(value)) if isinstance(value, float) else str(value)


class _Xml:
    """An XML model that is changed in place; comments and order stay."""

    def __init__(self, content: bytes):
        self._root = reading.xml_root(content)
        space = self._root.tag.rpartition("}")[0].lstrip("{")
        self._space = f"{{{space}}}" if space else ""
        if space:
            ElementTree.register_namespace("", space)
        blocks = [block for block in self._root if reading.local(block) == "components"]  # the file has a bearing, so it has one
        self._components = blocks[0]
        self._relations = next((block for block in self._root if reading.local(block) == "relations"), None)
        if self._relations is None:
            self._relations = ElementTree.SubElement(self._root, f"{self._space}relations")
        self._by_id = {int(one.get("id")): one for block in blocks for one in block if reading.local(one) == "component"}
        self._next = max(self._by_id, default=0) + 1
        self._next_relation = 1 + max((int(one.get("id")) for one in self._relations if (one.get("id") or "").isdecimal()), default=0)

    def put(self, component: int, attribute: str, unit: str, value: Any, load_case: str = "") -> Any:
        """Sets an attribute, that of a load case where one is named; the value it had before."""
        whole = self._of_load_case(load_case, component) if load_case else self._by_id[component]
        found = next((one for one in whole if reading.local(one) == "attribute" and one.get("id") == attribute), None)
        before = None
        if found is None:
            if len(whole):
                found = ElementTree.SubElement(whole, f"{self._space}attribute", id=attribute)
                found.tail, whole[-2].tail = whole[-2].tail, whole.text
            else:
                whole.text, found = "\n      ", ElementTree.SubElement(whole, f"{self._space}attribute", id=attribute)
                found.tail = "\n    "
        else:
            before = reading.scalar("".join(found.itertext()))
        found.set("unit", unit)
        self._fill(found, value)
        return before

    def _of_load_case(self, load_case: str, component: int) -> ElementTree.Element:
        """What a load case states of a component; begun where it states nothing."""
        cases = [one for block in self._root if reading.local(block) == "load_spectrum" for one in block if reading.local(one) == "load_case"]
        case = next(one for number, one in enumerate(cases) if one.get("id", str(number + 1)) == load_case)
        for one in case:
            if reading.local(one) == "component" and int(one.get("id")) == component:
                return one
        begun = ElementTree.SubElement(case, f"{self._space}component", id=str(component), type=self._by_id[component].get("type", ""))
        begun.tail = "\n    "
        return begun

    def _fill(self, element: ElementTree.Element, value: Any) -> None:
        for child in list(element):
            element.remove(child)
        element.text = None if isinstance(value, list) else _text(value)
        if isinstance(value, list):
            array = ElementTree.SubElement(element, f"{self._space}array")
            for one in value:
                ElementTree.SubElement(array, f"{self._space}c").text = _text(one)

    def add(self, type_: str, attributes: Iterable[tuple[str, str, Any]]) -> int:
        """A new component; its id."""
        number, self._next = self._next, self._next + 1
        self._by_id[number] = ElementTree.SubElement(self._components, f"{self._space}component", id=str(number), name="", type=type_)
        self._by_id[number].tail = "\n    "
        for attribute, unit, value in attributes:
            self.put(number, attribute, unit, value)
        return number

    def relate(self, type_: str, refs: list[tuple[str, int]], order: Optional[int]) -> None:
        """A new relation."""
        relation = ElementTree.SubElement(self._relations, f"{self._space}relation", id=str(self._next_relation), type=type_)
        self._next_relation += 1
        relation.tail = "\n    "
        if order is not None:
            relation.set("order", str(order))
        for role, component in refs:
            ElementTree.SubElement(relation, f"{self._space}ref", hint=self._by_id[component].get("type", ""), id=str(component), role=role)

    def bytes(self) -> bytes:
        """The file's content."""
        return MARK + b'<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(self._root, encoding="unicode").encode("utf-8") + b"\n"


class _Json:
    """A JSON model that is changed in place."""

    def __init__(self, content: bytes):
        self._data = reading.json_of(content)
        model = self._data["model"]
        if not isinstance(model.get("relations"), list):
            model["relations"] = []
        self._components, self._relations = model["components"], model["relations"]  # the file has a bearing, so it has components
        self._by_id = {int(one["id"]): one for one in self._components if isinstance(one, dict)}
        self._next = max(self._by_id, default=0) + 1
        self._next_relation = 1 + max((one["id"] for one in self._relations if isinstance(one, dict) and isinstance(one.get("id"), int)), default=0)

    def put(self, component: int, attribute: str, unit: str, value: Any, load_case: str = "") -> Any:
        """Sets an attribute, that of a load case where one is named; the value it had before."""
        whole = self._of_load_case(load_case, component) if load_case else self._by_id[component]
        if not isinstance(whole.get("attributes"), list):
            whole["attributes"] = []
        attributes = whole["attributes"]
        found = next((one for one in attributes if isinstance(one, dict) and one.get("id") == attribute), None)
        kind = "floating_point_array" if isinstance(value, list) else "enum" if isinstance(value, str) else "floating_point"
        fresh = {"id": attribute, "unit": unit, kind: value}
        if found is None:
            attributes.append(fresh)
            return None
        before = next((one for key, one in found.items() if key not in ("id", "unit")), None)
        found.clear()
        found.update(fresh)
        return before

    def _of_load_case(self, load_case: str, component: int) -> dict:
        """What a load case states of a component; begun where it states nothing."""
        cases = [one for one in self._data["model"]["load_spectrum"]["load_cases"] if isinstance(one, dict)]
        case = next(one for one in cases if str(one.get("id")) == load_case)
        if not isinstance(case.get("components"), list):
            case["components"] = []
        for one in case["components"]:
            if isinstance(one, dict) and int(one["id"]) == component:
                return one
        case["components"].append({"id": component, "type": self._by_id[component].get("type", ""), "attributes": []})
        return case["components"][-1]

    def add(self, type_: str, attributes: Iterable[tuple[str, str, Any]]) -> int:
        """A new component; its id."""
        number, self._next = self._next, self._next + 1
        self._by_id[number] = {"id": number, "type": type_, "attributes": []}
        self._components.append(self._by_id[number])
        for attribute, unit, value in attributes:
            self.put(number, attribute, unit, value)
        return number

    def relate(self, type_: str, refs: list[tuple[str, int]], order: Optional[int]) -> None:
        """A new relation."""
        relation: dict[str, Any] = {"id": self._next_relation, "type": type_}
        self._next_relation += 1
        if order is not None:
            relation["order"] = order
        relation["refs"] = [{"id": component, "role": role, "hint": self._by_id[component].get("type", "")} for role, component in refs]
        self._relations.append(relation)

    def bytes(self) -> bytes:
        """The file's content."""
        try:
            return json.dumps(self._data, ensure_ascii=False, indent=1, allow_nan=False).encode("utf-8") + b"\n"
        except ValueError as error:
            raise CaseError(f"--results: the file holds a number beyond all bounds ({error}), which JSON does not have; results are not written "
                            "into it") from error
