"""Slip of cage and rollers over speed."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, columns_table
from orbearing.result_folder import Report

SLUG, TITLE = "slip", "Slip of cage and rollers"
SERIES = (("roller_slip", "rollers", style.VERMILION, "s"), ("cage_slip", "cage", style.BLUE, "o"))
WITHOUT_CAGE = (("roller_slip", "rollers' spin", style.VERMILION, "s"), ("orbit_slip", "rollers' orbit", style.BLUE, "o"))
CAPTION = (
    "How far cage and rollers stay behind pure rolling, in per cent: one less the cage's speed over its kinematic speed, and one less "
    "the mean spin of the rollers over that at pure rolling. Rollers lose spin wherever they are unloaded. The cage is carried "
    "by the loaded ones; below zero it runs ahead of the kinematic speed. The two pictures have their own scales."
)


CAPTION_WITHOUT_CAGE = (
    "How far the rollers, which no cage keeps apart, stay behind pure rolling, in per cent: one less their mean spin, and one less their "
    "mean orbital speed, over those at pure rolling. Rollers lose spin wherever they are unloaded; loaded ones push the others round. The "
    "two pictures have their own scales."
)


def block(report: Report) -> FigureBlock:
    """Both slips in per cent, each on its own scale."""
    speed = report.point_column("input_speed_rpm")
    caged = not np.isfinite(report.point_column("orbit_slip")).any()
    series, caption = (SERIES, CAPTION) if caged else (WITHOUT_CAGE, CAPTION_WITHOUT_CAGE)
    slips = [100 * report.point_column(name) for name, *_ in series]
    if not any((np.isfinite(speed) & np.isfinite(slip)).any() for slip in slips):
        return FigureBlock(SLUG, TITLE, missing="No point of this sweep has a slip.")
    table = columns_table(("input speed (rpm)", *(f"slip of the {name} (%)" for _, name, *_ in series)), speed, *slips)
    return FigureBlock(SLUG, TITLE if caged else "Slip of the rollers", caption, (_draw(speed, slips, series),), data=table)


def _draw(speed: np.ndarray, slips: list[np.ndarray], series: tuple) -> str:
    figure = Figure(figsize=(5.6, 4.8))
    rows = figure.subplots(2, 1, sharex=True)
    for axes, slip, (_, name, colour, marker) in zip(rows, slips, series):
        axes.axhline(0, color=style.GREY, linewidth=0.8)
        marker = marker if len(speed) <= style.MOST_MARKERS else ""
        axes.plot(speed, slip, color=colour, marker=marker, markerfacecolor="white")
        axes.set_ylabel(f"slip of the {name} (%)")
        style.thousands(axes.yaxis)
    style.speed_axis(rows[-1])
    return style.to_svg(figure, SLUG, f"Slip of the {series[0][1]} and of the {series[1][1]} over input speed")
