"""The life that governs a case, and the lives of one bearing side by side, as the core lays them out below `life_table`."""

from __future__ import annotations

import json
from html import escape

from orbearing.blocks import Table, format_number, format_quantity, is_number
from orbearing.result_folder import Report, record, records
from orbearing.tables import table


LUNDBERG_PALMGREN = "life_h"  # key of that life; the others have the names of ISO 281 and ISO 16281
LIVES = ("L10h", "L10rh", "L10mh", "L10mrh", LUNDBERG_PALMGREN)  # of one bearing, in hours; system_ before them: of all
WITH_RELIABILITY = ("L10mh", "L10mrh")  # lives that hold a_1 of ISO 281, for life.reliability; the others are for 90 %
_NAMES = {LUNDBERG_PALMGREN: "Lundberg-Palmgren life", "L10h": "basic rating life of ISO 281", "L10rh": "basic reference rating life of ISO 16281",
          "L10mh": "modified rating life of ISO 281", "L10mrh": "modified reference rating life of ISO 16281"}


def governing_life(core) -> dict | None:
    """Which life governs a case (`orbearing._core.CoreCase`), as `check` states it: `key`, `method`, `reason`. None of a model without one."""
    from orbearing import _core

    return json.loads(_core.compute(core, "check", {})[0]).get("governing_life")


def governing_number(content: dict) -> tuple[str, float, str] | None:
    """Key, number and unit of the governing life of one bearing whose run printed `content`: in hours, else in million revolutions; of L10r where it has
    no number."""
    key = str(record(content.get("life_table")).get("governing") or "L10mrh")
    names = [(key, key, "h"), (key.removesuffix("h").removesuffix("_"), revolutions_of(key), "million revolutions"),
             ("L10rh", "L10rh", "h"), ("L10r", "L10r_Mrev", "million revolutions")]
    return next(((name, content[column], unit) for name, column, unit in names if is_number(content.get(column))), None)


def name_of_worst(row: dict, life: str, before: str = "") -> str:
    """Key of that life in a row of the bearing that requirements are judged by: over a revolution of the carrier where that is computed, else the one with
    the shortest life where bearings carry unlike loads. `before`: what columns of one of several sets begin with."""
    names = (f"{before}carrier_{life}", f"{before}shortest_{life}")
    return next((name for name in names if is_number(row.get(name))), before + life)


def revolutions_of(key: str) -> str:
    """Key of the same life in million revolutions."""
    return f"{key.removesuffix('h').removesuffix('_')}_Mrev"


def life_in_words(name: str) -> str | None:
    """Of a life by its key, of one bearing or (`system_`) of all; None of any other name."""
    key = name.removeprefix("system_")
    if key not in _NAMES:
        return None
    share = "life.reliability" if key in WITH_RELIABILITY else "90 % reliability"
    return f"{_NAMES[key]} of {'one bearing' if key == name else 'all bearings together'}, {share}"


def lives_table(content: dict) -> Table:
    """A line for each life, with the clause it is by."""
    rows = [(row.get("key"), row.get("hours"), row.get("Mrev"), row.get("by")) for row in records(content.get("lives"))]
    return Table(("Life of one bearing", "hours", "million revolutions", "by"), rows)


def loads_line(content: dict) -> str:
    """Ratings, loads and factors in one line; what has no number is left out."""
    parts = [f"{row.get('symbol')} {format_quantity(row['value'], row['unit']) if row.get('unit') else format_number(row['value'])}"
             for row in records(content.get("loads")) if is_number(row.get("value"))]
    return ", ".join(parts)


def section(report: Report) -> str:
    """What a page begins with: lives, what they rest on, and by which to design. Empty where the core stated none."""
    content = report.record("life_table")
    if not records(content.get("lives")):
        return ""
    speed = content.get("speed_rpm")
    where = f'<p>At {escape(format_quantity(speed, "rpm", 4))} input speed:</p>\n' if is_number(speed) else ""
    advice = "\n".join(f"<p>{escape(line)}</p>" for line in str(content.get("advice") or "").splitlines() if line)
    return f'<section id="lives">{where}{table(lives_table(content))}\n<p>{escape(loads_line(content))}</p>\n{advice}</section>'
