"""Rows of the validation table, and what they say together."""

from __future__ import annotations

import json
import math
import statistics as stat
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

# In the order in which they are listed; those that count as values of others first.
KINDS = ("measurement", "program", "worked-example", "closed-form", "recomputed")
COUNTED = KINDS[:3]
TREND = "trend"
PASSING_LINES = "characteristic frequency"  # of elements that pass: they follow from one formula


@dataclass(frozen=True)
class Row:
    """One published value beside ours, as `orbearing validate --json` has it; what it lacks is None."""

    case: str
    source: str
    kind: str
    of: str
    quantity: str
    meaning: str
    reading: str
    published: Optional[float]
    ours: Optional[float]
    tolerance: float  # [-] relative
    scatter: Optional[float]  # [-] relative standard deviation of the measurement
    band: Optional[dict]  # ends of our middle 50 % and 90 %, from uncertain inputs
    verdict: str
    why: str
    memory: bool
    fitted: bool  # constants of the case were identified from it

    @property
    def counts(self) -> bool:
        return self.kind in COUNTED and not self.memory and self.published is not None

    @property
    def key(self) -> str:
        """Of the source in REFERENCES.md."""
        return self.source[self.source.find("["):self.source.find("]") + 1] or self.source

    @property
    def name(self) -> tuple:
        """What tells a row from all others."""
        return self.case, self.source, self.quantity, self.reading, self.meaning

    @property
    def log_ratio(self) -> Optional[float]:
        """Natural logarithm of ours over theirs; None where there is none."""
        if self.ours is None or self.published is None or self.of == TREND or not self.ours * self.published > 0.0:
            return None
        return math.log(self.ours / self.published)


def read(files: Iterable) -> list[Row]:
    """Rows of the files, each what one call of `orbearing validate --json` printed; a row that several hold counts once."""
    rows: dict[tuple, Row] = {}
    for file in files:
        for one in json.loads(Path(file).read_text(encoding="utf-8"))["rows"]:
            row = Row(**{name: one[name] for name in Row.__dataclass_fields__ if name != "kind"}, kind=one["evidence"])
            rows.setdefault(row.name, row)
    return list(rows.values())


RUBBING = frozenset(("friction", "heat", "friction and heat", "temperature", "slip", "load sharing", "trend"))


def is_friction_slip_or_sharing(row: Row) -> bool:
    """Whether a row is a measurement of friction, heat, slip or sharing of loads, trends of them included."""
    return row.kind == "measurement" and row.of in RUBBING and not row.quantity.startswith("modes:")


def distinct(rows: Iterable[Row]) -> list[Row]:
    """One row for each value: source, value and settings tell values apart."""
    found: dict[tuple, Row] = {}
    for row in rows:
        if row.published is not None:
            found.setdefault((row.source, tuple(sorted(row.reading.split(", "))), row.published), row)
    return list(found.values())


def once_a_bearing(rows: Iterable[Row]) -> list[Row]:
    """Lines of passing elements are one value a bearing and kind of evidence, however many recordings show them: the one with the median deviation."""
    kept: list[Row] = []
    lines: dict[tuple, list[Row]] = {}
    for row in rows:
        if row.of == PASSING_LINES:
            lines.setdefault((row.case, row.kind, row.memory), []).append(row)
        else:
            kept.append(row)
    for of_bearing in lines.values():
        of_bearing.sort(key=lambda row: math.inf if row.log_ratio is None else abs(row.ours / row.published - 1))
        kept.append(of_bearing[(len(of_bearing) - 1) // 2])
    return kept


@dataclass(frozen=True)
class Statistics:
    """Of the logarithms of ours over theirs [-]."""

    values: int  # those without a ratio too
    sources: int
    bias: Optional[float]  # mean
    deviation: Optional[float]  # standard deviation
    of_measurement: Optional[float]  # root mean square of the stated scatters
    verdicts: dict[str, int]

    @property
    def of_model(self) -> Optional[float]:
        """What is left of the deviation without the scatter of the measurements; None where that is not stated."""
        if self.deviation is None or self.of_measurement is None:
            return None
        return math.sqrt(max(self.deviation**2 - self.of_measurement**2, 0.0))


def statistics(rows: Sequence[Row]) -> Statistics:
    ratios = [row.log_ratio for row in rows if row.log_ratio is not None]
    scatters = [row.scatter for row in rows if row.scatter is not None]
    verdicts: dict[str, int] = {}
    for row in rows:
        verdicts[row.verdict] = verdicts.get(row.verdict, 0) + 1
    return Statistics(len(rows), len({row.key for row in rows}), stat.fmean(ratios) if ratios else None,
                      stat.stdev(ratios) if len(ratios) > 1 else None,
                      math.sqrt(stat.fmean(s * s for s in scatters)) if scatters else None, verdicts)


@dataclass(frozen=True)
class Calibration:
    """Of measurements whose case states how uncertain its inputs are."""

    values: int
    in_50: int
    in_90: int
    in_both_50: int  # of the bands widened by the scatter of the measurement as stated
    in_both_90: int


def calibration(rows: Iterable[Row]) -> Calibration:
    """How many lie within our bands; those that constants were identified from tell nothing and are left out."""
    banded = [row for row in rows if row.band and row.counts and row.kind == "measurement" and not row.fitted]

    def within(share: int, widened: bool) -> int:
        return sum(low <= row.published <= high for row in banded for low, high in [_ends(row, share, widened)])

    return Calibration(len(banded), within(50, False), within(90, False), within(50, True), within(90, True))


# Half of the middle 50 and 90 % of the normal distribution, in standard deviations.
_HALF = {50: 0.67449, 90: 1.64485}


def _ends(row: Row, share: int, widened: bool) -> tuple[float, float]:
    """Ends of the band; widened, each of its halves and that of a normal scatter of the measurement add as squares do."""
    low, high = row.band[f"low_{share}"], row.band[f"high_{share}"]
    if not widened or row.scatter is None or row.ours is None:
        return low, high
    half = _HALF[share] * row.scatter * abs(row.ours)
    return row.ours - math.hypot(max(row.ours - low, 0.0), half), row.ours + math.hypot(max(high - row.ours, 0.0), half)


def changed_verdicts(before: Iterable[Row], now: Iterable[Row]) -> list[str]:
    """A line for each row whose verdict is another one, or that is new or gone."""
    old, new = ({row.name: row.verdict for row in rows} for rows in (before, now))
    lines = []
    for name in {**old, **new}:
        was, is_now = old.get(name, "no such row"), new.get(name, "no such row")
        if was != is_now:
            case, source, quantity, reading, meaning = name
            lines.append(f"{case}: {source}, {quantity}{' | ' + reading if reading else ''} ({meaning}): was {was}, is {is_now}")
    return lines
