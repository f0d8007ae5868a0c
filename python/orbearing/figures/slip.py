"""Slip of cage and rollers over speed."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, columns_table
from orbearing.result_folder import Report

SLUG, TITLE = "slip", "Slip of cage and rollers"
SERIES = (("roller_slip", "rollers", style.VERMILION, "s"), ("cage_slip", "cage", style.BLUE, "o"))
CAPTION = (
    "How far cage and rollers stay behind pure rolling, in per cent: one less the cage's speed over its kinematic speed, and one less "
    "the mean spin of the rollers over that at pure rolling. Rollers lose spin wherever they are unloaded. The cage is carried "
    "by the loaded ones; below zero it runs ahead of the kinematic speed. The two pictures have their own scales."
)


def block(report: Report) -> FigureBlock:
    """Both slips in per cent, each on its own scale."""
    speed = report.point_column("input_speed_rpm")
    slips = [100 * report.point_column(name) for name, *_ in SERIES]
    if not any((np.isfinite(speed) & np.isfinite(slip)).any() for slip in slips):
        return FigureBlock(SLUG, TITLE, missing="No point of this sweep has a slip.")
    table = columns_table(("input speed (rpm)", "roller slip (%)", "cage slip (%)"), speed, *slips)
    return FigureBlock(SLUG, TITLE, CAPTION, (_draw(speed, slips),), data=table)


def _draw(speed: np.ndarray, slips: list[np.ndarray]) -> str:
    figure = Figure(figsize=(5.6, 4.8))
    rows = figure.subplots(2, 1, sharex=True)
    for axes, slip, (_, name, colour, marker) in zip(rows, slips, SERIES):
        axes.axhline(0, color=style.GREY, linewidth=0.8)
        marker = marker if len(speed) <= style.MOST_MARKERS else ""
        axes.plot(speed, slip, color=colour, marker=marker, markerfacecolor="white")
        axes.set_ylabel(f"slip of the {name} (%)")
        style.thousands(axes.yaxis)
    style.speed_axis(rows[-1])
    return style.to_svg(figure, SLUG, "Slip of the rollers and of the cage over input speed")
