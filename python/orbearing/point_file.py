"""The netCDF files of single points: loads by place and, of a dynamic run, everything over time."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from orbearing.blocks import format_number, is_number
from orbearing.result_folder import Report, lies_on, record

# Speeds in report.json and in the manifest agree but for the last digits.
SAME_SPEED = 1e-6
# Below this share of the largest mean load a place counts as unloaded: resting rollers carry a few newtons.
LOAD_ZONE_SHARE = 0.05


@dataclass(frozen=True)
class PointFile:
    """The variables of one file by name, in SI units; where there are none, `problem` says why."""

    values: dict[str, np.ndarray] = field(default_factory=dict)
    problem: str = ""

    def get(self, *names: str) -> list[np.ndarray] | None:
        """The variables, or None where one of them is absent or has no finite value."""
        found = [self.values.get(name, np.empty(0)) for name in names]
        return found if all(np.isfinite(values).any() for values in found) else None


def read_point(report: Report, speed_rpm: float | None) -> PointFile:
    """The file of the point at this input speed [rpm]; never raises."""
    if not is_number(speed_rpm):
        return PointFile(problem="No point of this result is whole.")
    where = f"the point at {format_number(speed_rpm)} rpm"
    path = _path(report.folder, speed_rpm, report.record("slice"))
    if path is None:
        return PointFile(problem=f"The file of {where} is not named in manifest.jsonl.")
    return _read(path, where)


def read_only_point(folder: Path | None) -> PointFile:
    """The file of a result that has but one; never raises."""
    return _read(folder / "points" / "00000.nc", "the result") if folder else PointFile(problem="This result has no folder.")


def _read(path: Path, where: str) -> PointFile:
    try:
        import netCDF4
    except ImportError:
        return PointFile(problem="The results over time cannot be read: the Python module netCDF4 is missing "
                                 "(Debian: python3-netcdf4).")
    try:
        with netCDF4.Dataset(path) as data:
            return PointFile({name: _plain(variable) for name, variable in data.variables.items()})
    except (OSError, RuntimeError, ValueError) as error:
        return PointFile(problem=f"The file of {where}, {path.name}, cannot be read ({getattr(error, 'strerror', None) or 'damaged'}).")


def load_zone(point: PointFile, angle: np.ndarray) -> np.ndarray:
    """Whether each place [rad] lies where the inner race carries on average; nowhere if that is not stored."""
    stored = point.get("angle", "inner_load")
    if stored is None or len(stored[0]) != len(stored[1]):
        return np.zeros(len(angle), dtype=bool)
    places, load = stored
    mean = np.interp(angle, places, np.nan_to_num(load), period=2 * np.pi)
    return mean > LOAD_ZONE_SHARE * np.nanmax(load)


def one_roller(point: PointFile, *names: str, roller: int = 0) -> list[np.ndarray] | None:
    """Time [s] from zero, place [rad] and the named variables of one roller over one revolution; None if not stored."""
    found = point.get("time", "roller_angle", *names)
    if found is None or any(values.ndim != 2 or values.shape[1] != len(found[0]) for values in found[1:]):
        return None
    time, angle, *series = found[0], *(values[roller] for values in found[1:])
    known = np.isfinite(time) & np.isfinite(angle)
    if known.sum() < 2:
        return None
    columns = [values[known] for values in (time, angle, *series)]
    turned = np.abs(np.unwrap(columns[1]) - columns[1][0])
    once = np.logical_and.accumulate(turned <= 2 * np.pi)
    time, angle, *series = (values[once] for values in columns)
    return [time - time[0], np.mod(angle, 2 * np.pi), *series]


def _path(folder: Path | None, speed_rpm: float, others: dict) -> Path | None:
    """The manifest says which file belongs to which speed on the line of speeds that is shown."""
    if folder is None:
        return None
    try:
        lines = (folder / "manifest.jsonl").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return None
    for line in lines:
        entry = _entry(line)
        row = record(entry.get("row"))
        speed = row.get("input_speed_rpm")
        if lies_on(row, others) and is_number(speed) and abs(speed - speed_rpm) <= SAME_SPEED * abs(speed_rpm) and isinstance(entry.get("file"), str):
            return folder / entry["file"]
    return None


def _entry(line: str) -> dict:
    """A line may be torn where a run was killed."""
    try:
        return record(json.loads(line))
    except json.JSONDecodeError:
        return {}


def _plain(variable) -> np.ndarray:
    """Numbers with NaN for what is not filled in; text is left out."""
    values = np.ma.asarray(variable[...])
    return np.ma.filled(values.astype(float), np.nan) if values.dtype.kind in "fiu" else np.empty(0)
