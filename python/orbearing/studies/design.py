"""Which variants of a case a study computes: grids, samples, rows of a table, and the speeds of the case's own sweep.

Points are numbered as the elements of an array whose dimensions are, in this order: rows of a table, then the parameters of a grid (or the samples),
then the axes of the case's own sweep, the input speed last and fastest.
"""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from orbearing.errors import CaseError

SPEED = "input.speed"
SAMPLERS = ("grid", "sobol", "lhs")
ROW, SAMPLE = "row", "sample"
MOST_POINTS = 10_000_000
END_TOLERANCE = 1e-9  # part of a step by which rounding may put the last value beside `to`, as in the sweep of a case
SAME_VALUE = 1e-12  # relative: what the conversion of a unit may round off
NUMBERS = ("quantity", "number", "integer")  # kinds of fields that are numbers
DIGITS = 15  # of a coordinate: what a double keeps of a decimal number, so that 10 um reads 10 and not 9.999999999999999


@dataclass(frozen=True)
class Parameter:
    """One varied value of the case and the dimension along which it varies."""

    path: str
    dimension: str
    unit: str  # customary; "1" of a plain number, empty of a choice
    meaning: str
    texts: tuple[str, ...]  # as in a case file, along the dimension
    si: np.ndarray | None  # [SI], along the dimension; None for what is no number
    values: np.ndarray  # [unit], or the texts of choices

    @property
    def is_number(self) -> bool:
        return self.si is not None


@dataclass(frozen=True)
class Design:
    """All points of a study."""

    parameters: tuple[Parameter, ...]  # in the order of their dimensions
    dimensions: tuple[tuple[str, int], ...]  # name and length
    sampler: str
    seed: int

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(length for _, length in self.dimensions)

    @property
    def points(self) -> int:
        return math.prod(self.shape)

    @property
    def over_speed(self) -> bool:
        """Whether the speed is a dimension of its own, so that each variant has a peak of life over it."""
        return bool(self.dimensions) and self.dimensions[-1][0] == SPEED

    @property
    def variants(self) -> int:
        """Points that differ in more than their speed."""
        return self.points // self.dimensions[-1][1] if self.over_speed else self.points

    def numbers(self) -> list[Parameter]:
        return [parameter for parameter in self.parameters if parameter.is_number]

    def along(self, parameter: Parameter, ids: np.ndarray) -> np.ndarray:
        """Where the points `ids` stand along the parameter's dimension."""
        names = [name for name, _ in self.dimensions]
        return np.unravel_index(ids, self.shape)[names.index(parameter.dimension)]

    def values(self, ids: np.ndarray) -> np.ndarray:
        """[SI] Numbers of the points `ids`: one row each, one column for each parameter that is a number."""
        columns = [parameter.si[self.along(parameter, ids)] for parameter in self.numbers()]
        return np.ascontiguousarray(np.column_stack(columns)) if columns else np.empty((len(ids), 0))

    def settings(self, point: int, every: bool = False) -> tuple[tuple[str, str], ...]:
        """What makes the point of the case, as --set would be given: of choices alone, or of every parameter."""
        ids = np.array([point])
        return tuple((p.path, p.texts[self.along(p, ids)[0]]) for p in self.parameters if every or not p.is_number)

    def groups(self) -> list[tuple[tuple[tuple[str, str], ...], np.ndarray]]:
        """Points that share all choices, with the settings of these: numbers alone differ within a group."""
        choices = [parameter for parameter in self.parameters if not parameter.is_number]
        ids = np.arange(self.points)
        if not choices:
            return [((), ids)]
        places = np.column_stack([_first_of_equals(parameter.texts)[self.along(parameter, ids)] for parameter in choices])
        _, which = np.unique(places, axis=0, return_inverse=True)
        which = which.reshape(-1)
        members = [ids[which == group] for group in range(which.max() + 1)]
        return [(self.settings(int(group[0])), group) for group in members]

    def summary(self) -> dict:
        """What two studies must share to be one: short, and unlike wherever a value differs."""
        return {
            "sampler": self.sampler,
            **({"seed": self.seed} if self.sampler != "grid" else {}),
            "dimensions": [list(dimension) for dimension in self.dimensions],
            "parameters": [{"path": p.path, "dimension": p.dimension, "from": p.texts[0], "to": p.texts[-1],
                            "values": hashlib.sha256("\n".join(p.texts).encode()).hexdigest()[:16]} for p in self.parameters],
        }

    def content(self) -> dict:
        """Everything, as JSON keeps it."""
        return {"sampler": self.sampler, "seed": self.seed, "dimensions": [list(d) for d in self.dimensions],
                "parameters": [{"path": p.path, "dimension": p.dimension, "unit": p.unit, "meaning": p.meaning, "texts": list(p.texts),
                                "si": None if p.si is None else p.si.tolist(), "values": p.values.tolist()} for p in self.parameters]}


def from_content(content: dict) -> Design:
    """The inverse of Design.content."""
    parameters = tuple(
        Parameter(p["path"], p["dimension"], p["unit"], p["meaning"], tuple(p["texts"]), None if p["si"] is None else np.array(p["si"], float),
                  np.array(p["values"], float if p["si"] is not None else object)) for p in content["parameters"])
    return Design(parameters, tuple((name, length) for name, length in content["dimensions"]), content["sampler"], content["seed"])


def _require_unlike(parameter: Parameter) -> None:
    """Refuses a value that is listed twice in different words, as 5 um and 0.005 mm."""
    if parameter.si is None or len(parameter.si) < 2:
        return
    order = np.argsort(parameter.si, kind="stable")
    sorted_si = parameter.si[order]
    equal = np.flatnonzero(np.diff(sorted_si) <= SAME_VALUE * np.abs(sorted_si[1:]))
    if len(equal):
        one, other = (parameter.texts[order[equal[0] + i]] for i in (0, 1))
        raise CaseError(f"{parameter.path}: '{one}' and '{other}' are one value; each value once is required")


def _first_of_equals(texts: Sequence[str]) -> np.ndarray:
    first: dict[str, int] = {}
    return np.array([first.setdefault(text, index) for index, text in enumerate(texts)])


def design_of(core, varied: Mapping[str, Any], *, sampler: str = "grid", samples: int | None = None, seed: int = 1,
              paired: Sequence[Mapping[str, Any]] = ()) -> Design:
    """The points of a study of `core` (a CoreCase).

    `varied` maps a path of the case to a list of values ("10 um", or numbers where the field is a plain number), to {"from", "to", "step"} (or
    "count" in place of "step"), or to a pair (numbers, "unit"). Of a sample "sobol" or "lhs" it maps to {"from", "to"}, evenly distributed, or to a
    list of which each is as likely. `paired` are rows of a table: the values of a row go together, beside the grid or sample.
    Raises CaseError with every mistake, or where the case cannot have a value.
    """
    if sampler not in SAMPLERS:
        raise CaseError(f"sampler: found '{sampler}'; required: grid, sobol or lhs")
    fields = {entry["path"]: entry for entry in core.inputs()}
    reader = _Reader(core, fields)
    rows = _rows(paired)
    axes = case_axes(core)
    own = {**{path: None for path in rows}, **varied}
    reader.require_known(own)
    twice = [path for path in rows if path in varied]
    if twice:
        raise CaseError(f"{twice[0]}: found in the rows of the table and outside them; required: one of both")
    parameters = [reader.parameter(path, ROW, values) for path, values in rows.items()]
    dimensions = [(ROW, len(paired))] if rows else []
    _require_few(sampler, varied, rows, axes)
    if sampler == "grid":
        if samples is not None:
            raise CaseError("samples: found with a grid; required: the sampler sobol or lhs")
        for path, stated in varied.items():
            texts = reader.grid(path, stated)
            parameters.append(reader.parameter(path, path, texts))
            _require_unlike(parameters[-1])
            dimensions.append((path, len(texts)))
    elif varied:
        drawn = _drawn(sampler, len(varied), samples, seed)
        for column, (path, stated) in enumerate(varied.items()):
            parameters.append(reader.parameter(path, SAMPLE, reader.sampled(path, stated, drawn[:, column])))
        dimensions.append((SAMPLE, len(drawn)))
    else:
        raise CaseError(f"sampler: found {sampler} without a value to vary; required: at least one")
    # Those of the case's own sweep follow; the speed is the last, also where the study states its values.
    for path, texts in axes.items():
        if path not in own:
            parameters.append(reader.parameter(path, path, texts))
            dimensions.append((path, len(texts)))
    dimensions.sort(key=lambda dimension: dimension[0] == SPEED)
    order = [name for name, _ in dimensions]
    parameters.sort(key=lambda parameter: order.index(parameter.dimension))
    design = Design(tuple(parameters), tuple(dimensions), sampler, seed)
    _require_few_points(design.points)
    _require_possible(core, design)
    return design


def _require_few_points(points: int) -> None:
    if points > MOST_POINTS:
        raise CaseError(f"study: found {points} points; at most {MOST_POINTS} are required: vary fewer values, or sample them (--sampler sobol)")


def _require_few(sampler: str, varied: Mapping[str, Any], rows: Mapping[str, list], axes: Mapping[str, list[str]]) -> None:
    """Counts the points before a value is read: a range of many values costs as much as they are."""
    lengths = [len(texts) for path, texts in axes.items() if path not in varied and path not in rows]
    lengths += [len(next(iter(rows.values())))] if rows else []
    if sampler == "grid":
        lengths += [_count_of(path, stated) for path, stated in varied.items()]
    _require_few_points(math.prod(lengths))


def _count_of(path: str, stated: Any) -> int:
    """How many values an axis of a grid states; 1 where that is seen only when they are read."""
    if isinstance(stated, Mapping):
        return _range_of(path, stated)[3]
    if isinstance(stated, tuple) and len(stated) == 2 and isinstance(stated[1], str) and not isinstance(stated[0], str) and hasattr(stated[0], "__len__"):
        return len(stated[0])
    return len(stated) if hasattr(stated, "__len__") and not isinstance(stated, str) else 1


def _require_possible(core, design: Design) -> None:
    """Refuses what cannot be before the first point is computed: each combination of choices, and the ends of each number beside the first of the
    others. Between them single points may fail, and say so."""
    point = core.without_sweep()
    tried = [int(ids[0]) for _, ids in design.groups()]
    for parameter in design.numbers():
        along = design.along(parameter, np.arange(design.points))
        tried += [int(np.argmax(along == place)) for place in (parameter.si.argmin(), parameter.si.argmax())]
    for number in dict.fromkeys(tried):
        try:
            point.with_settings(list(design.settings(number, every=True)))
        except CaseError as error:
            raise error.without_option() from error


def case_axes(core) -> dict[str, list[str]]:
    """The axes of the case's own sweep and the texts of their values; the operating speed alone where it has none."""
    axes = {path: [str(text) for text in texts] for path, texts in core.axes().items()}
    if SPEED not in axes and any(entry["path"] == SPEED and entry["given"] is not None for entry in core.inputs()):
        axes[SPEED] = [str(core.given(SPEED))]
    return axes


def stated_values(text: str) -> list[str] | dict[str, str]:
    """What a list "[a, b]" or a range "{from: a, to: b, step: c}" holds, as in a case file. Raises ValueError for another text."""
    text = text.strip()
    if len(text) < 2 or text[0] + text[-1] not in ("[]", "{}"):
        raise ValueError("a list or a range is required")
    entries, depth = [""], 0
    for sign in text[1:-1]:
        depth += (sign in "[{") - (sign in "]}")
        if sign == "," and depth == 0:
            entries.append("")
        else:
            entries[-1] += sign
    entries = [entry.strip() for entry in entries]
    if any(not entry for entry in entries):
        raise ValueError("a value between commas is required")
    if text[0] == "[":
        return [_unquoted(entry) for entry in entries]
    pairs = [entry.partition(":") for entry in entries]
    if any(not colon for _, colon, _ in pairs) or len({key.strip() for key, _, _ in pairs}) < len(pairs):
        raise ValueError("{from: ..., to: ..., step: ...} is required")
    return {key.strip(): _unquoted(value.strip()) for key, _, value in pairs}


def _unquoted(text: str) -> str:
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'" else text


def _rows(paired: Sequence[Mapping[str, Any]]) -> dict[str, list[Any]]:
    """The columns of a table given by its rows, each of which must have them all."""
    columns: dict[str, list[Any]] = {}
    for number, row in enumerate(paired, start=1):
        if number > 1 and set(row) != set(columns) or not row:
            raise CaseError(f"paired: row {number} has {', '.join(sorted(row)) or 'no values'}; required: the values of the first row, "
                           f"{', '.join(sorted(columns)) or 'at least one'}")
        for path, value in row.items():
            columns.setdefault(path, []).append(value)
    return columns


def _drawn(sampler: str, columns: int, samples: int | None, seed: int) -> np.ndarray:
    """Numbers from 0 to 1, one row for each sample. The same for the same seed, whatever is computed when."""
    if samples is None or samples < 1:
        raise CaseError(f"samples: found {samples}; required with {sampler}: at least 1")
    if sampler == "sobol" and samples & (samples - 1):
        above = 1 << samples.bit_length()
        raise CaseError(f"samples: found {samples}; required with sobol: a power of two, as {above // 2} or {above}, without which its points are not balanced")
    try:
        from scipy.stats import qmc
    except ImportError as error:
        raise CaseError(f"samples: the Python library scipy was not found ({error}); required: scipy (Debian: python3-scipy; PyPI: scipy)") from error

    drawing = qmc.Sobol(columns, scramble=True, seed=seed) if sampler == "sobol" else qmc.LatinHypercube(columns, seed=seed)
    return drawing.random(samples)


def _split(text: str) -> tuple[float, str]:
    """Number and unit of "10 um"; the unit is empty for a plain number. Raises ValueError where it is neither."""
    found = re.fullmatch(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*)", text.strip())
    if not found:
        raise ValueError("a number is required")
    return float(found[1]), found[2]


def _number_text(value: float, unit: str) -> str:
    shown = repr(float(value))
    shown = shown[:-2] if shown.endswith(".0") else shown
    return f"{shown} {unit}" if unit else shown


def _range_texts(path: str, stated: Mapping[str, Any]) -> list[str]:
    """The values of {from, to, step} or {from, to, count}, in the unit of `from`."""
    first, last, step, count, unit = _range_of(path, stated)
    if step is None:
        return [_number_text(float(f"{value:.{DIGITS}g}"), unit) for value in np.linspace(first, last, count)]
    return [_number_text(first + index * step, unit) for index in range(count)]


def _range_of(path: str, stated: Mapping[str, Any]) -> tuple[float, float, float | None, int, str]:
    """First, last, step (None of a count), number of values and unit."""
    keys = set(stated)
    if keys not in ({"from", "to", "step"}, {"from", "to", "count"}):
        raise CaseError(f"{path}: found a range of {', '.join(sorted(keys)) or 'nothing'}; required: {{from: ..., to: ..., step: ...}} or {{from: ..., to: ..., count: ...}}")
    (first, unit), (last, other) = _ends(path, stated)
    if unit != other:
        raise CaseError(f"{path}: found a range from '{stated['from']}' to '{stated['to']}'; required: one unit for both")
    if "count" in keys:
        return first, last, None, _whole(path, stated["count"]), unit
    step, step_unit = _quantity(path, stated["step"])
    if step_unit != unit or not step > 0 or last < first:
        raise CaseError(f"{path}: found a step of '{stated['step']}' from '{stated['from']}' to '{stated['to']}'; required: a positive one in the same unit, upwards")
    steps = (last - first) / step
    if steps > MOST_POINTS:
        raise CaseError(f"{path}: found {steps + 1:.4g} values from '{stated['from']}' to '{stated['to']}'; at most {MOST_POINTS} are required")
    if abs(steps - round(steps)) > END_TOLERANCE:
        raise CaseError(f"{path}: a step of '{stated['step']}' from '{stated['from']}' does not end at '{stated['to']}'; required: one that does")
    return first, last, step, round(steps) + 1, unit


def _whole(path: str, value: Any) -> int:
    try:
        count = int(str(value))
    except ValueError:
        count = 0
    if not 1 < count <= MOST_POINTS:
        raise CaseError(f"{path}: found a count of '{value}'; required: a whole number from 2 to {MOST_POINTS}")
    return count


def _ends(path: str, stated: Mapping[str, Any]) -> list[tuple[float, str]]:
    return [_quantity(path, stated[key]) for key in ("from", "to")]


def _quantity(path: str, value: Any) -> tuple[float, str]:
    try:
        number, unit = _split(str(value))
    except ValueError as error:
        raise CaseError(f"{path}: found '{value}'; required: a number, with its unit where it has one") from error
    if not math.isfinite(number):
        raise CaseError(f"{path}: found '{value}'; required: a finite number")
    return number, unit


class _Reader:
    """Values of the case's fields by the case's own reader."""

    def __init__(self, core, fields: Mapping[str, dict]):
        self.core, self.fields = core, fields

    def require_known(self, paths: Iterable[str]) -> None:
        for path in paths:
            if path not in self.fields:
                self.core.value(path)  # refuses it in its own words, with the nearest path that it knows

    def grid(self, path: str, stated: Any) -> list[Any]:
        """The values of a grid's axis, each once."""
        values = _range_texts(path, stated) if isinstance(stated, Mapping) else self._listed(path, stated)
        texts = [_text(value) for value in values]
        twice = next((text for index, text in enumerate(texts) if text in texts[:index]), None) if len(set(texts)) < len(texts) else None
        if twice is not None:
            raise CaseError(f"{path}: '{twice}' is listed twice; each value once is required")
        return values

    def sampled(self, path: str, stated: Any, drawn: np.ndarray) -> list[Any]:
        """Values for numbers drawn from 0 to 1."""
        if not isinstance(stated, Mapping):
            values = self._listed(path, stated)
            return [values[int(number * len(values))] for number in drawn]
        if set(stated) != {"from", "to"}:
            raise CaseError(f"{path}: found a range of {', '.join(sorted(stated))}; required of a sample: {{from: ..., to: ...}}, or a list of equally likely values")
        (first, unit), (last, other) = _ends(path, stated)
        if unit != other or not first < last:
            raise CaseError(f"{path}: found a range from '{stated['from']}' to '{stated['to']}'; required: one unit for both, upwards")
        if self.fields[path]["kind"] == "integer":
            raise CaseError(f"{path}: found a range of a whole number; required of a sample: a list of values")
        return [_number_text(float(f"{first + number * (last - first):.{DIGITS}g}"), unit) for number in drawn]

    def _listed(self, path: str, stated: Any) -> list[Any]:
        if isinstance(stated, tuple) and len(stated) == 2 and isinstance(stated[1], str) and not isinstance(stated[0], str) and isinstance(stated[0], Iterable):
            return [_number_text(float(value), stated[1]) for value in stated[0]]
        if isinstance(stated, str) or not isinstance(stated, Iterable):
            raise CaseError(f"{path}: found {stated!r}; required: a list of values, {{from, to, step}}, or numbers with their unit, as ([0, 10], 'um')")
        values = list(stated)
        if not values:
            raise CaseError(f"{path}: found an empty list; required: at least one value")
        return values

    def parameter(self, path: str, dimension: str, values: Sequence[Any]) -> Parameter:
        """The parameter with its values read by the case."""
        field = self.fields[path]
        texts = tuple(_text(value) for value in values)
        if field["kind"] not in NUMBERS:
            return Parameter(path, dimension, "", field["meaning"], texts, None, np.array(texts, object))
        si = np.array(self.core.si(path, list(texts)))
        unit, values = self._customary(field, texts, si)
        return Parameter(path, dimension, unit, field["meaning"], texts, si, values)

    def _customary(self, field: Mapping[str, Any], texts: Sequence[str], si: np.ndarray) -> tuple[str, np.ndarray]:
        """A unit and the values in it: as the user wrote them where all are in the customary unit, else converted."""
        unit = field["unit"] or "1"
        if unit == "1":
            return unit, si
        split = [_split(text) for text in texts]
        if all(written == unit for _, written in split):
            return unit, np.array([number for number, _ in split])
        # A unit is a factor and, of a temperature, an offset: two values of its own tell both, where the field's range has them.
        for size in (f"e{power}" for power in (0, 1, 2, 3, -1, -2, -3, 4, 5, 6, -4, -5, -6)):
            try:
                one, two = self.core.si(field["path"], [f"1{size} {unit}", f"2{size} {unit}"])
            except CaseError:
                continue
            step = two - one
            offset = one - step if abs(one - step) > 1e-9 * abs(one) else 0.0
            return unit, np.array([float(f"{float('1' + size) * ((value - offset) / step):.{DIGITS}g}") for value in si])
        return field["si_unit"], si


def _text(value: Any) -> str:
    """A value as in a case file."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (float, np.floating)):
        return _number_text(float(value), "")
    return json.dumps(value) if isinstance(value, (list, tuple, dict)) else str(value)
