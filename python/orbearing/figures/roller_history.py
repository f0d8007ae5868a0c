"""The loads of one roller over one revolution of the cage, with the load zone: over time and round the bearing."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number
from orbearing.figures.polar_loads import turn
from orbearing.point_file import load_zone, one_roller, read_point
from orbearing.result_folder import Report

SLUG, TITLE = "roller-history", "One roller over one cage revolution"
LOUPE = 0.06  # share of the largest load that the lower picture shows
EVERY = 5  # one in so many stored instants stands in the table
PLACES = {0: "0° outward", 90: "90°", 180: "180° to the sun", 270: "270°"}
CAPTION = (
    "Contact loads of one roller as it goes round once, at the speed of the peak; its place stands above. Shaded is the load "
    "zone, where the mean load on the inner race is more than a twentieth of its largest. Within it the roller is squeezed "
    "between both races. The lower picture enlarges the small loads, a dot for each stored instant: outside the zone the roller "
    "rests on the race to which inertia presses it or knocks against it, and flies free where both loads are zero. The round "
    "picture shows the same loads by place: 0° outward, 90° along carrier rotation, 180° towards the sun."
)


def block(report: Report) -> FigureBlock:
    """Whole loads above, the small ones enlarged below."""
    point = read_point(report, report.peak_speed)
    found = one_roller(point, "roller_inner_load", "roller_outer_load")
    if found is None or not all(np.isfinite(load).any() for load in found[2:]):
        return FigureBlock(SLUG, TITLE, missing=point.problem or "No roller loads over time were stored at the speed of the peak.")
    time, angle, inner, outer = (values[::EVERY] for values in found)
    head = ("time (ms)", "place (deg)", "inner race (N)", "outer race (N)")
    table = Table(head, list(zip(1e3 * time, np.degrees(angle), inner, outer)))
    pictures = (_draw(report.peak_speed, found, load_zone(point, found[1])), _draw_round(report.peak_speed, found))
    return FigureBlock(SLUG, TITLE, CAPTION, pictures, data=table)


def _draw(speed: float, found: list[np.ndarray], zone: np.ndarray) -> str:
    time, angle, inner, outer = found
    figure = Figure(figsize=(5.6, 5.6))
    whole, loupe = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": (2, 1)})
    whole.plot(1e3 * time, outer, color=style.VERMILION, linewidth=1.4, label="outer race")
    whole.plot(1e3 * time, inner, color=style.BLUE, linewidth=1.2, linestyle=(0, (3, 1)), label="inner race")
    for load, colour in ((outer, style.VERMILION), (inner, style.BLUE)):
        loupe.plot(1e3 * time, load, ".", color=colour, markersize=3)  # joined, the knocks would hide each other
    for axes in (whole, loupe):
        style.shade(axes, 1e3 * time, zone, "load zone")
        style.thousands(axes.yaxis)
    reach = max(np.nanmax(inner), np.nanmax(outer)) or 1.0
    whole.set_ylim(0, 1.06 * reach)
    loupe.set_ylim(-0.03 * LOUPE * reach, LOUPE * reach)
    whole.set_xlim(0, 1e3 * time[-1])
    whole.set_ylabel("contact load (N)")
    loupe.set_ylabel("enlarged (N)")
    loupe.set_xlabel(f"time at {format_number(speed)} rpm input speed (ms)")
    _name_places(whole, time, angle)
    style.legend_above(whole, columns=3, height=1.12)
    return style.to_svg(figure, SLUG, "Inner and outer load of one roller over one cage revolution")


def _draw_round(speed: float, found: list[np.ndarray]) -> str:
    _, angle, inner, outer = found
    figure = Figure(figsize=(4.4, 5.0))
    axes = figure.add_subplot(projection="polar")
    turn(axes)
    axes.plot(angle, outer, color=style.VERMILION, linewidth=1.2, label="outer race")
    axes.plot(angle, inner, color=style.BLUE, linewidth=1.0, linestyle=(0, (3, 1)), label="inner race")
    axes.set_ylim(0, 1.1 * (max(np.nanmax(inner), np.nanmax(outer)) or 1.0))
    centre = np.nansum(inner * np.exp(1j * angle))
    axes.set_rlabel_position(np.degrees(np.angle(-centre)) + 45)
    axes.yaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10], prune="lower"))
    style.thousands(axes.yaxis)
    axes.set_title(f"{format_number(speed)} rpm, load in N", pad=12)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncol=2, borderaxespad=0)
    return style.to_svg(figure, f"{SLUG}-round", "Inner and outer load of one roller by place over one orbit")


def _name_places(axes: Axes, time: np.ndarray, angle: np.ndarray) -> None:
    """A second axis above names the quarters of the orbit at the instants at which the roller passes them."""
    path = np.degrees(np.unwrap(angle))
    if path[-1] == path[0]:
        return
    order = np.argsort(path)
    quarters = [q for q in range(-720, 1081, 90) if path.min() <= q <= path.max()]
    ticks = np.interp(quarters, path[order], 1e3 * time[order])
    above = axes.secondary_xaxis("top")
    above.set_xticks(ticks, [PLACES[q % 360] for q in quarters])
    above.tick_params(labelsize=8.5, length=3)
    above.spines["top"].set_visible(False)
