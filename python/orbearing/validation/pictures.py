"""One picture for each class of quantities: ours over theirs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from orbearing import style
from orbearing.validation.rows import KINDS, Row

SIZE = (8.6, 4.5)
LOOKS = dict(zip(KINDS, (("o", style.VERMILION), ("s", style.BLUE), ("^", style.GREEN), ("x", style.GREY), ("+", style.PURPLE))))
DECADE = 10.0
LEAST_OFF = 0.1  # [%] deviations below are not drawn larger than they are


def scatter(name: str, rows: Sequence[Row]) -> Figure:
    """Ours over theirs, and beside it how far ours is off. Bars: standard deviation of the measurement as stated, and the
    middle 90 % of ours where inputs are uncertain."""
    with style.context():
        figure = Figure(figsize=SIZE)
        whole, off = figure.subplots(1, 2)
        shown = [row for row in rows if row.log_ratio is not None]
        for kind, (marker, colour) in LOOKS.items():
            _points(whole, off, [row for row in shown if row.kind == kind], kind, marker, colour)
        _whole_axes(whole, shown)
        _off_axes(off, shown)
        figure.suptitle(name, fontsize=11)
        style.legend_above(whole, columns=2)
        return figure


def _points(whole, off, rows: Sequence[Row], kind: str, marker: str, colour: str) -> None:
    if not rows:
        return
    theirs, ours = (np.abs([getattr(row, side) for row in rows]) for side in ("published", "ours"))
    spread = np.array([row.scatter or 0.0 for row in rows])
    ends = np.array([_ends(row) for row in rows]).T
    bars = np.maximum([ours - ends[0], ends[1] - ours], 0.0)
    look = {"linestyle": "", "marker": marker, "color": colour, "markersize": 4.5, "elinewidth": 0.9, "alpha": 0.8}
    with_bars = spread > 0.0, (bars > 0.0).any(axis=0)
    whole.errorbar(theirs, ours, xerr=np.where(spread > 0, spread * theirs, np.nan) if with_bars[0].any() else None,
                   yerr=np.where(bars > 0, bars, np.nan) if with_bars[1].any() else None, label=f"{kind} ({len(rows)})", **look)
    percent = 100.0 * (ours / theirs - 1.0)
    off.errorbar(theirs, percent, yerr=np.where(bars > 0, 100.0 * bars / theirs, np.nan) if with_bars[1].any() else None, **look)
    if with_bars[0].any():
        off.errorbar(theirs, np.zeros(len(theirs)), yerr=np.where(spread > 0, 100.0 * spread, np.nan), linestyle="", marker="",
                     ecolor=style.GREY, elinewidth=3.0, alpha=0.35)


def _ends(row: Row) -> tuple[float, float]:
    if not row.band:
        return abs(row.ours), abs(row.ours)
    ends = abs(row.band["low_90"]), abs(row.band["high_90"])
    return min(ends), max(ends)


def _spans_decades(rows: Sequence[Row]) -> bool:
    theirs = [abs(row.published) for row in rows]
    return bool(theirs) and max(theirs) > DECADE * min(theirs)


def _whole_axes(axes, rows: Sequence[Row]) -> None:
    if not rows:
        return
    if _spans_decades(rows):
        axes.set_xscale("log")
        axes.set_yscale("log")
    numbers = [abs(number) for row in rows for number in (row.published, row.ours)]
    low, high = min(numbers), max(numbers)
    pad = 1.15
    axes.plot([low / pad, high * pad], [low / pad, high * pad], color=style.BLACK, linewidth=0.9, linestyle="--")
    axes.set_xlabel("published (units of the rows)")
    axes.set_ylabel("ours")


def _off_axes(axes, rows: Sequence[Row]) -> None:
    low, high = axes.get_ylim()
    axes.set_ylim(min(low, -LEAST_OFF), max(high, LEAST_OFF))
    axes.axhline(0.0, color=style.BLACK, linewidth=0.9, linestyle="--")
    if _spans_decades(rows):
        axes.set_xscale("log")
    axes.set_xlabel("published (units of the rows)")
    axes.set_ylabel("ours less published (%)")
