"""A result folder as the report sees it: report.json, read leniently where values are missing."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from orbearing.blocks import is_number
from orbearing.errors import CaseError


SAME_VALUE = 1e-9  # relative; far above round-off, far below any step of a sweep


def numbers(values: Any) -> np.ndarray:
    """An array in which everything that is not a finite number has become NaN."""
    items = values if isinstance(values, list) else []
    return np.array([value if is_number(value) else np.nan for value in items], dtype=float)


def curve(block: dict, *names: str) -> list[np.ndarray]:
    """Columns of equal length: all are cut to the shortest of those that are there."""
    columns = [numbers(block.get(name)) for name in names]
    length = min((len(column) for column in columns if len(column)), default=0)
    return [column[:length] if len(column) else np.full(length, np.nan) for column in columns]


def records(value: Any) -> list[dict]:
    """The objects of a list; anything else is left out."""
    return [item for item in value if isinstance(item, dict)] if isinstance(value, list) else []


def record(value: Any) -> dict:
    """The object, or an empty one where there is none."""
    return value if isinstance(value, dict) else {}


def same(one: Any, other: Any) -> bool:
    """Whether two numbers differ by no more than the round-off of a unit's conversion."""
    return is_number(one) and is_number(other) and abs(one - other) <= SAME_VALUE * max(abs(one), abs(other))


def lies_on(row: dict, line: dict) -> bool:
    """Whether a row of the sweep lies on the line of speeds that has these values on the other axes."""
    return all(same(row.get(column), value) for column, value in line.items())


def slip_of_set(points: list[dict]) -> tuple[str, str]:
    """What goes round with the rollers: the column of its slip and its name, of the cage or, without one, of the rollers' mean orbit."""
    without = any(is_number(record(point).get("orbit_slip")) for point in points)
    return ("orbit_slip", "orbit") if without else ("cage_slip", "cage")


def peak_of(points: list[dict], life_key: str = "life_h") -> dict:
    """The longest life among these points: of the grid's, and of all where points were added to it."""
    alive = [p for p in points if is_number(p.get(life_key)) and is_number(p.get("input_speed_rpm"))]
    grid = [p for p in alive if p.get("refined") is not True]
    peak = {"life_key": life_key}
    for prefix, those in (("", grid), *([("refined_", alive)] if len(grid) < len(alive) else [])):
        best = max(those, key=lambda p: p[life_key], default={})
        peak |= {f"{prefix}speed_rpm": best.get("input_speed_rpm"), f"{prefix}life_h": best.get(life_key)}
    return peak


@dataclass(frozen=True)
class Report:
    """The content of report.json; keys and units as the file names them."""

    content: dict
    folder: Path | None = None  # where the files of the points lie

    def record(self, key: str) -> dict:
        return record(self.content.get(key))

    def of(self, kind: str) -> Report:
        """What the run of a single bearing or of a pair printed, with what its case states."""
        return Report({**self.record(kind), "given": self.content.get("given")}, self.folder)

    def records(self, key: str) -> list[dict]:
        return records(self.content.get(key))

    def point_column(self, name: str) -> np.ndarray:
        """One column of the sweep, NaN at failed points."""
        return numbers([point.get(name) for point in self.records("points")])

    def along_speed(self) -> Report:
        """What plots over speed show: of a sweep with more axes the one line of speeds that `slice` names."""
        line = self.record("slice")
        if not line:
            return self
        points = [point for point in self.records("points") if lies_on(point, line)]
        return replace(self, content={**self.content, "points": points, "peak": peak_of(points, self.life_key)})

    @property
    def life_key(self) -> str:
        """The governing life (`life.method`)."""
        return str(self.record("peak").get("life_key") or "life_h")

    @property
    def line(self) -> str:
        """Where that line lies, in words; empty for a sweep over speed alone."""
        return ", ".join(f"{column} = {value:.10g}" for column, value in self.record("slice").items() if is_number(value))

    @property
    def fidelity(self) -> str:
        return str(self.content.get("fidelity") or "unknown fidelity")

    @property
    def is_dynamic(self) -> bool:
        """Whether the bearing moves in time."""
        return self.fidelity == "dynamic" or self.is_coupled

    @property
    def is_coupled(self) -> bool:
        """Whether the bearings act back on the gears."""
        return self.fidelity in ("co-simulated", "monolithic")

    @property
    def peak_speed(self) -> float | None:
        """Speed [rpm] of the best point of the sweep, those added to its grid included."""
        peak = self.record("peak")
        speeds = (peak.get("refined_speed_rpm"), peak.get("speed_rpm"))
        return next((speed for speed in speeds if is_number(speed)), None)

    @property
    def shown_speeds(self) -> list[float]:
        """Lowest, best and highest speed [rpm] of the points that have the governing life."""
        speeds = [p["input_speed_rpm"] for p in self.records("points")
                  if is_number(p.get("input_speed_rpm")) and is_number(p.get(self.life_key))]
        best = [min(speeds, key=lambda speed: abs(speed - self.peak_speed))] if speeds and self.peak_speed else []
        return sorted({min(speeds), *best, max(speeds)}) if speeds else []

    @property
    def failed_points(self) -> list[dict]:
        """Points without the governing life."""
        return [p for p in self.records("points") if not str(p.get("status")).startswith(("ok", "implausible: ")) or not is_number(p.get(self.life_key))]


def read_report(folder: Path) -> Report:
    """Read DIR/report.json; raises CaseError with the remedy where that cannot be done."""
    path = folder / "report.json"
    remedy = f"Run `orbearing report {folder}`, which writes it from the results of a sweep"
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise CaseError(f"{path}: cannot be read ({error.strerror}); a readable file is required. {remedy}") from error
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        raise CaseError(f"{path}: is not JSON ({error}); one JSON object is required. {remedy}") from error
    if not isinstance(content, dict):
        raise CaseError(f"{path}: found {type(content).__name__}; one JSON object is required. {remedy}")
    return Report(content, folder)
