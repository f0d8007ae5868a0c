"""The table of README.md: its numbers from rows, its words as they stand.

Each line has values by kind of evidence: all, reproduced, trend, missed, and the worst miss in words. The line of friction, heat, slip and
sharing holds those of the measurements that are no frequencies.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path

from orbearing.validation.rows import Row, distinct, once_a_bearing, statistics, is_friction_slip_or_sharing

LINES = {
    "measurement": lambda row: row.kind == "measurement",
    "of these: friction, heat, slip, sharing": is_friction_slip_or_sharing,
    "program": lambda row: row.kind == "program",
    "worked example": lambda row: row.kind == "worked-example",
}
VERDICTS = ("reproduced", "trend", "missed")


def numbers(rows: Iterable[Row]) -> dict[str, list[int]]:
    """Of each line: values, and of them reproduced, trend and missed."""
    counted = once_a_bearing([row for row in distinct(rows) if row.counts])
    found = {}
    for name, belongs in LINES.items():
        of_line = statistics([row for row in counted if belongs(row)])
        found[name] = [of_line.values, *(of_line.verdicts.get(verdict, 0) for verdict in VERDICTS)]
    return found


def updated(text: str, rows: Sequence[Row]) -> str:
    """The text of README.md with the numbers of `rows`. A line that is missing raises ValueError."""
    for name, found in numbers(rows).items():
        line = re.compile(rf"^\| {re.escape(name)} \|(?: \d+ \|){{4}} (.*) \|$", re.M)
        if not line.search(text):
            raise ValueError(f"README.md: no line of the table of validation begins with {name}")
        text = line.sub(lambda one, name=name, found=found: f"| {name} | " + " | ".join(map(str, found)) + f" | {one[1]} |", text)
    return text


def update(file, rows: Sequence[Row]) -> None:
    file = Path(file)
    file.write_text(updated(file.read_text(encoding="utf-8"), rows), encoding="utf-8")
