"""Tables of a page."""

from __future__ import annotations

from html import escape
from typing import Any

from orbearing.blocks import MISSING, Table, format_number, is_number

SHORT, SHORT_CELL = 14, ' class="short"'  # letters of a text that stays on one line, as a number with its unit


def cell(value: Any) -> str:
    """A table cell: numbers rounded for reading, text escaped, a dash for what is missing."""
    if is_number(value):
        return f'<td class="number">{format_number(float(value))}</td>'
    if value is None or value == "" or isinstance(value, float):  # a float that is no number is missing
        return f'<td class="number">{MISSING}</td>'
    text = str(value)
    return f'<td{SHORT_CELL if len(text) <= SHORT else ""}>{escape(text)}</td>'


def table(content: Table) -> str:
    """An HTML table that scrolls sideways where the screen is narrow."""
    head = "".join(f'<th scope="col">{escape(text)}</th>' for text in content.head)
    rows = "\n".join("<tr>" + "".join(cell(value) for value in row) + "</tr>" for row in content.rows)
    return f'<div class="scroll"><table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}\n</tbody>\n</table></div>'
