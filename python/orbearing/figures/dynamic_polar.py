"""Quasi-static and dynamic roller loads laid over each other, and their difference."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_change, format_number, is_number
from orbearing.figures.polar_loads import columns, turn
from orbearing.point_file import read_point
from orbearing.result_folder import Report, record, records

SLUG, TITLE = "dynamic-polar", "Roller loads, quasi-static and dynamic"
SIZE = (3.3, 5.5)  # [inch], three stand side by side
# [share of the picture] fixed, so that neighbours stand in line whatever their labels need.
RINGS, DIFFERENCE = (0.13, 0.44, 0.74, 0.444), (0.16, 0.06, 0.8, 0.2)
RACES = (("outer", style.VERMILION), ("inner", style.BLUE))
PALE = {"outer": ("#f6cfae", 8.0), "inner": ("#b5d7ea", 4.0)}  # colour and width [pt] of the quasi-static rings
SAME_SPEED = 1e-3  # relative; far below the step of any sweep
CAPTION = (
    "Above: contact load by place; broad pale rings are quasi-static, thin lines the mean of the dynamic run over the rollers that "
    "pass each place. Where the lines lie within the rings, motion changes little on average. Below: dynamic less quasi-static by "
    "place, on its own scale: peaks at the ends of the load zone are rollers entering and leaving it, and a dip along it means that "
    "rollers stand closer there than evenly spaced, so that each carries less, or that part of the load takes another way. Places: "
    "0° outward, 90° along carrier rotation, 180° towards the sun."
)


def block(report: Report) -> FigureBlock:
    """One picture for each speed that has a dynamic result; the quasi-static ring where there is one."""
    pairs, problem = [], "No point of this result has a life."
    for speed in report.shown_speeds:
        dynamic, why = _dynamic(report, speed)
        problem = why or problem
        if dynamic:
            pairs.append((speed, dynamic, _quasi_static(report, speed)))
    if not pairs:
        return FigureBlock(SLUG, TITLE, missing=problem)
    pictures = tuple(_draw(pair, f"{SLUG}-{index}") for index, pair in enumerate(pairs, start=1))
    return FigureBlock(SLUG, TITLE, CAPTION, pictures, summary=_summary(pairs), data=_data(pairs))


def _dynamic(report: Report, speed: float) -> tuple[list[np.ndarray] | None, str]:
    """Place [deg], inner and outer load [N] of the dynamic run, or why there are none."""
    point = read_point(report, speed)
    stored = point.get("angle", "inner_load", "outer_load")
    if stored is None or len({values.shape for values in stored}) > 1:
        return None, point.problem or "The files of the points hold no loads by place."
    return [np.degrees(stored[0]), *stored[1:]], ""


def _quasi_static(report: Report, speed: float) -> list[np.ndarray] | None:
    stored = records(record(report.record("dynamic").get("quasi_static")).get("polar")) or report.records("polar")
    for entry in stored:
        other = entry.get("speed_rpm")
        if is_number(other) and abs(other - speed) <= SAME_SPEED * speed:
            angle, inner, outer = columns(entry)
            known = np.isfinite(angle) & np.isfinite(inner) & np.isfinite(outer)
            return [values[known] for values in (angle, inner, outer)] if known.any() else None
    return None


def _at(places: np.ndarray, loads: list[np.ndarray] | None) -> list[np.ndarray]:
    """Inner and outer load of a ring at other places [deg]."""
    if loads is None:
        return [np.full(len(places), np.nan)] * 2
    return [np.interp(places, loads[0], load, period=360.0) for load in loads[1:]]


def _draw(pair: tuple, slug: str) -> str:
    speed, dynamic, quasi_static = pair
    figure = Figure(figsize=SIZE)
    figure.set_layout_engine("none")
    _draw_rings(figure.add_axes(RINGS, projection="polar"), speed, dynamic, quasi_static)
    _draw_difference(figure.add_axes(DIFFERENCE), dynamic, quasi_static)
    return style.to_svg(figure, slug, f"Quasi-static and dynamic roller loads at {format_number(speed)} rpm")


def _draw_rings(axes: PolarAxes, speed: float, dynamic: list[np.ndarray], quasi_static: list[np.ndarray] | None) -> None:
    turn(axes)
    for index, (race, colour) in zip((2, 1), RACES):
        if quasi_static:
            pale, width = PALE[race]
            _ring(axes, quasi_static[0], quasi_static[index], color=pale, linewidth=width, label=f"{race}, quasi-static", zorder=2)
        _ring(axes, dynamic[0], dynamic[index], color=colour, linewidth=1.3, linestyle="-" if race == "outer" else "--",
              label=f"{race}, dynamic", zorder=3)
    reach = max(np.nanmax(load) for load in (*dynamic[1:], *(quasi_static or ())[1:])) or 1.0
    axes.set_ylim(0, 1.12 * reach)
    centre = np.nansum(dynamic[2] * np.exp(1j * np.radians(dynamic[0])))
    axes.set_rlabel_position(np.degrees(np.angle(-centre)) + 45)  # where the rollers carry least, and off the horizontal
    axes.yaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10], prune="lower"))
    style.thousands(axes.yaxis)
    axes.set_title(f"{format_number(speed)} rpm, load in N", pad=12)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), ncol=2, borderaxespad=0, handlelength=1.8, columnspacing=1.0)


def _ring(axes: PolarAxes, angle: np.ndarray, load: np.ndarray, **look) -> None:
    known = np.isfinite(angle) & np.isfinite(load)
    theta, radius = np.radians(angle[known]), load[known]
    axes.plot(np.append(theta, theta[:1]), np.append(radius, radius[:1]), **look)


def _draw_difference(axes: Axes, dynamic: list[np.ndarray], quasi_static: list[np.ndarray] | None) -> None:
    axes.axhline(0, color=style.GREY, linewidth=0.8)
    expected = _at(dynamic[0], quasi_static)
    for index, (race, colour) in zip((2, 1), RACES):
        axes.plot(dynamic[0], dynamic[index] - expected[index - 1], color=colour, linewidth=1.2,
                  linestyle="-" if race == "outer" else "--")
    axes.set_xlim(0, 360)
    axes.set_xticks(range(0, 361, 90), [f"{place}°" for place in range(0, 361, 90)])
    axes.tick_params(labelsize=8)
    axes.set_ylabel("difference (N)", fontsize=8.5)


def _summary(pairs: list[tuple]) -> Table:
    rows = []
    for speed, dynamic, quasi_static in pairs:
        for index, (race, _) in zip((2, 1), RACES):
            before = np.max(quasi_static[index]) if quasi_static else None
            after, gap = np.nanmax(dynamic[index]), dynamic[index] - _at(dynamic[0], quasi_static)[index - 1]
            largest = round(np.nanmax(np.abs(gap)), 2) if np.isfinite(gap).any() else None
            rows.append((speed, race, before, after, format_change(after, before), largest))
    head = ("input speed (rpm)", "race", "largest, quasi-static (N)", "largest mean, dynamic (N)", "change", "largest difference at a place (N)")
    return Table(head, rows)


def _data(pairs: list[tuple]) -> Table:
    rows = []
    for speed, dynamic, quasi_static in pairs:
        rows += [(speed, *row) for row in zip(dynamic[0], *_at(dynamic[0], quasi_static), *dynamic[1:])]
    head = ("input speed (rpm)", "place (deg)", "inner, quasi-static (N)", "outer, quasi-static (N)", "inner, dynamic (N)", "outer, dynamic (N)")
    return Table(head, rows)
