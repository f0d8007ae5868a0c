"""What a figure hands to the page: pictures, a caption and the numbers behind them."""

from __future__ import annotations

import html
import math
from dataclasses import dataclass, field
from typing import Any, Sequence

MISSING = "–"


@dataclass(frozen=True)
class Table:
    """Headings and rows; cells are text or numbers, None where a value is missing."""

    head: tuple[str, ...]
    rows: list[tuple[Any, ...]]


@dataclass(frozen=True)
class FigureBlock:
    """One section of the page.

    `pictures` are SVG elements that may stand side by side. Where nothing could be drawn
    they are empty and `missing` says why. `summary` is always shown, `data` on demand.
    """

    slug: str
    title: str
    caption: str = ""
    pictures: tuple[str, ...] = field(default=())
    summary: Table | None = None
    data: Table | None = None
    missing: str = ""

    def _repr_html_(self) -> str:
        """Title, pictures and caption, as a notebook shows them."""
        body = "".join(f"<div>{picture}</div>" for picture in self.pictures) or f"<p>{html.escape(self.missing)}</p>"
        return f"<h4>{html.escape(self.title)}</h4>{body}<p>{html.escape(self.caption)}</p>"


def is_number(value: Any) -> bool:
    """True for a finite number; a truth value is none."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def format_number(value: Any, digits: int = 5) -> str:
    """A number for people: `digits` significant ones, thousands apart, a dash where it is missing."""
    if not is_number(value):
        return MISSING
    if value == 0:
        return "0"
    size = math.floor(math.log10(abs(value)))
    if size >= 7 or size < -4:
        return f"{value:.{digits - 1}e}".replace("-", "\u2212")
    text = f"{value:,.{max(digits - 1 - size, 0) if size < 3 else 0}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return text.replace("-", "\u2212")


def format_quantity(value: Any, unit: str, digits: int = 5) -> str:
    """A number with its unit, or a dash alone."""
    return f"{format_number(value, digits)} {unit}" if is_number(value) else MISSING


def format_change(value: Any, reference: Any) -> str:
    """The relative change from `reference` in per cent, with its sign; large ones as a factor."""
    if not (is_number(value) and is_number(reference)) or reference == 0:
        return MISSING
    if value / reference > 3:
        return f"\u00d7 {format_number(value / reference, 3)}"
    return f"{100 * (value / reference - 1):+.1f} %".replace("-", "\u2212")


def columns_table(head: Sequence[str], *columns: Sequence[Any]) -> Table:
    """A table from its columns, as long as the longest; short ones end in missing values."""
    length = max((len(column) for column in columns), default=0)
    padded = [[*column, *[None] * (length - len(column))] for column in columns]
    return Table(tuple(head), list(zip(*padded)))
