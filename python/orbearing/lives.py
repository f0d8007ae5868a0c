"""The lives of one bearing side by side, as the core lays them out below `life_table`."""

from __future__ import annotations

from html import escape

from orbearing.blocks import Table, format_number, format_quantity, is_number
from orbearing.result_folder import Report, records
from orbearing.tables import table


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
