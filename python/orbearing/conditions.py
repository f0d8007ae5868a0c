"""`python3 -m orbearing.conditions RECORD.csv [--conditions N] [--json]`: the typical conditions of an operating record.

The record has columns for time, speed and load with their units in the names: time_s (or time_h), speed_rpm, load_N (or load_kN). Its samples are
clustered by k-means (SciPy) into a few conditions, each with its speed, load and share of the time, for the life of a bearing that sees them all:
1/L = sum of share_i / L_i.

Exit codes: 0 done, 1 SciPy is missing, 2 bad input or usage.
"""

from __future__ import annotations

import csv
import json
import sys
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from orbearing.errors import CaseError
from orbearing.terminal import Parser, finished, whole_number
from orbearing.units import units_in

COLUMNS = {"time": {"time_s": 1.0, "time_h": 3600.0}, "speed": {"speed_rpm": 1.0}, "load": {"load_N": 1.0, "load_kN": 1e3}}
MOST_SAMPLES = 20000  # even ones, that are clustered
STARTS = 20  # k-means finds a near optimum: the best of so many
LIFE_EXPONENT = 3.0  # of ball bearings


@dataclass(frozen=True)
class Condition:
    """Means over the samples of one cluster; the equivalent load gives the same life in revolutions at their speeds."""

    speed_rpm: float
    load_N: float
    equivalent_load_N: float
    share: float  # of the time


def read_record(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times [s], speeds [rpm] and loads [N]; raises CaseError with the line."""
    try:
        with open(path, newline="", encoding="utf-8") as stream:
            rows = csv.DictReader(stream)
            names = [_column(path, rows.fieldnames or [], quantity) for quantity in COLUMNS]
            values = [_numbers(path, line, row, names) for line, row in enumerate(rows, start=2)]
    except (OSError, UnicodeDecodeError) as error:
        raise CaseError(f"{path}: cannot be read ({error}); a CSV file is required") from error
    if len(values) < 2:
        raise CaseError(f"{path}: {len(values)} samples found; at least 2 are required")
    time, speed, load = np.array(values).T
    falling = np.flatnonzero(np.diff(time) <= 0)
    if len(falling):
        raise CaseError(f"{path}:{falling[0] + 3}: a time that is not later than the one before; rising times are required")
    return time, speed, load


def _column(path: Path, found: list[str], quantity: str) -> tuple[str, float]:
    for name, factor in COLUMNS[quantity].items():
        if name in found:
            return name, factor
    raise CaseError(f"{path}:1: no column for the {quantity} found; {' or '.join(COLUMNS[quantity])} is required")


def _numbers(path: Path, line: int, row: dict, names: list[tuple[str, float]]) -> list[float]:
    try:
        numbers = [factor * float(row[name]) for name, factor in names]
    except (TypeError, ValueError) as error:
        raise CaseError(f"{path}:{line}: {error}; a number in each column is required") from error
    if not np.isfinite(numbers).all():
        raise CaseError(f"{path}:{line}: a number that is not finite found; finite ones are required")
    return numbers


def typical_conditions(time: np.ndarray, speed: np.ndarray, load: np.ndarray, count: int, seed: int = 1) -> list[Condition]:
    """`count` conditions, or as many as there are unlike samples, that of the largest share first. A sample holds until the next one."""
    from scipy.cluster.vq import kmeans2, vq

    step = max(np.diff(time).min(), (time[-1] - time[0]) / MOST_SAMPLES)
    even = np.arange(time[0], time[-1], step)
    held = np.searchsorted(time, even, side="right") - 1
    speed, load = speed[held], load[held]
    samples = np.column_stack([_scaled(speed), _scaled(load)])
    count = min(count, len(np.unique(samples, axis=0)))
    best = None
    for start in range(STARTS):
        centres, _ = kmeans2(samples, count, minit="++", seed=seed + start, missing="warn")
        labels, distances = vq(samples, centres)
        if best is None or np.sum(distances**2) < best[0]:
            best = np.sum(distances**2), labels
    groups = [best[1] == label for label in np.unique(best[1])]
    found = [_condition(speed[group], load[group], len(even)) for group in groups]
    return sorted(found, key=lambda condition: -condition.share)


def _scaled(values: np.ndarray) -> np.ndarray:
    """Speeds and loads count by how much they vary."""
    spread = values.std()
    return (values - values.mean()) / (spread if spread > 0 else 1.0)


def _condition(speed: np.ndarray, load: np.ndarray, samples: int) -> Condition:
    turns = np.abs(speed) if np.any(speed) else np.ones(len(speed))
    equivalent = (np.sum(turns * np.abs(load) ** LIFE_EXPONENT) / np.sum(turns)) ** (1.0 / LIFE_EXPONENT)
    return Condition(float(speed.mean()), float(load.mean()), float(equivalent), len(speed) / samples)


def main(arguments: list[str]) -> int:
    """Print the conditions; messages go to standard error."""
    parser = Parser(prog="python3 -m orbearing.conditions", description="Typical conditions of an operating record.")
    parser.add_argument("record", type=Path, help="CSV with time_s, speed_rpm and load_N")
    parser.add_argument("--conditions", type=whole_number(1), default=4, help="how many; default: 4")
    parser.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    options = parser.parse_args(arguments)
    try:
        found = typical_conditions(*read_record(options.record), options.conditions)
    except CaseError as error:
        print(error, file=sys.stderr)
        return 2
    except ImportError as error:
        print(f"conditions: {error}; SciPy is required; on Debian install python3-scipy", file=sys.stderr)
        return 1
    if options.json:
        rows = [asdict(condition) for condition in found]
        print(json.dumps({"conditions": rows, "units": units_in(rows)}, indent=2))
    else:
        print(f"{'speed [rpm]':>12} {'load [N]':>12} {'equivalent [N]':>15} {'share':>8}")
        for one in found:
            print(f"{one.speed_rpm:12.1f} {one.load_N:12.1f} {one.equivalent_load_N:15.1f} {one.share:8.4f}")
    return 0


if __name__ == "__main__":
    sys.exit(finished(lambda: main(sys.argv[1:])))
