"""The path of the cage's centre inside the clearance of its guidance."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from matplotlib.ticker import MaxNLocator

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, is_number
from orbearing.point_file import read_point
from orbearing.result_folder import Report

SLUG, TITLE = "cage-orbit", "Cage orbit in its clearance"
SIZE = (3.3, 3.45)  # [inch], three stand side by side
MICRO = 1e6  # [µm/m]
SMALL = 0.5  # an orbit smaller than this share of the clearance is shown enlarged as well
EVERY = 10  # one in so many stored instants stands in the table
CAPTION = (
    "Path of the cage's centre over one cage revolution, x outward (up), y along carrier rotation (left). {circle} The cross is the "
    "mean, the dot the first instant. A cage that is pressed to one side of its land stays near one spot: a small ring marks it and the "
    "inset enlarges the path. A cage that whirls draws a large ring."
)
CIRCLE = ("The circle is the clearance of the guide land: on it the film is used up and cage and land touch; the elastic "
          "land lets the centre pass it by a little.")
NO_CIRCLE = "The clearance of the guide land is not given, so no circle is drawn."


def block(report: Report) -> FigureBlock:
    """One picture for each of the lowest, best and highest speed."""
    radius = clearance(report.record("drawing"))
    orbits, problem = [], "No point of this result has a life."
    for speed in report.shown_speeds:
        point = read_point(report, speed)
        stored = point.get("time", "cage_position")
        if stored is None or stored[1].shape != (2, len(stored[0])):
            without = point.get("time", "orbit_speed") is not None
            problem = "This bearing has no cage." if without else point.problem or "The files of the points hold no path of the cage."
            continue
        orbits.append((speed, stored[0] - stored[0][0], MICRO * stored[1]))
    if not orbits:
        return FigureBlock(SLUG, TITLE, missing=problem)
    pictures = tuple(_draw(orbit, radius, f"{SLUG}-{index}") for index, orbit in enumerate(orbits, start=1))
    caption = CAPTION.format(circle=CIRCLE if radius else NO_CIRCLE)
    return FigureBlock(SLUG, TITLE, caption, pictures, summary=_summary(orbits, radius), data=_data(orbits))


def clearance(drawing: dict) -> float | None:
    """Radial clearance of the guidance [µm]: the land lies outside the cage, or inside it."""
    land, inner, outer = (drawing.get(name) for name in ("guide_land_mm", "cage_inner_mm", "cage_outer_mm"))
    if is_number(land) and is_number(outer) and land > outer:
        return 1e3 * (land - outer) / 2
    if is_number(land) and is_number(inner) and 0 < land < inner:
        return 1e3 * (inner - land) / 2
    return None


def _draw(orbit: tuple, radius: float | None, slug: str) -> str:
    speed, _, path = orbit
    figure, axes = style.panel(SIZE)
    reach = 1.15 * max(radius or 0.0, np.nanmax(np.abs(path)), 1e-3)
    if radius:
        axes.add_patch(Circle((0, 0), radius, facecolor="#f3f3f3", edgecolor=style.GREY, linewidth=1.2))
    axes.plot([0], [0], "+", color=style.GREY, markersize=8)
    small = _is_small(path, radius)
    if small:  # a ring shows where to look, the inset shows the path
        axes.plot(path[1], path[0], color=style.BLUE, linewidth=1.0)
        axes.plot([np.nanmean(path[1])], [np.nanmean(path[0])], "o", color=style.BLUE, markersize=13, markerfacecolor="none")
        _enlarge(axes, path)
    else:
        _trace(axes, path)
    _frame(axes, (0, 0), reach)
    axes.set_xlabel("y, along carrier rotation (µm)")
    axes.set_ylabel("x, outward from the sun (µm)")
    axes.set_title(f"{format_number(speed)} rpm")
    return style.to_svg(figure, slug, f"Path of the cage centre at {format_number(speed)} rpm")


def _trace(axes: Axes, path: np.ndarray) -> None:
    axes.plot(path[1], path[0], color=style.BLUE, linewidth=1.0)
    axes.plot(path[1][:1], path[0][:1], "o", color=style.BLUE, markersize=4, zorder=4)
    axes.plot([np.nanmean(path[1])], [np.nanmean(path[0])], "x", color=style.VERMILION, markersize=6, zorder=4)


def _frame(axes: Axes, centre: tuple[float, float], reach: float) -> None:
    """Equal scales around a centre (x, y), y to the left as in all pictures."""
    axes.set_xlim(centre[1] + reach, centre[1] - reach)
    axes.set_ylim(centre[0] - reach, centre[0] + reach)
    axes.set_aspect("equal")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
        style.thousands(axis)


def _half_widths(path: np.ndarray) -> list[float]:
    return [(np.nanmax(values) - np.nanmin(values)) / 2 for values in path]


def _is_small(path: np.ndarray, radius: float | None) -> bool:
    """Small beside the clearance and away from its middle, where the inset stands."""
    near = np.nanmin(np.hypot(*path))
    return bool(radius and 0 < 2 * max(_half_widths(path)) < SMALL * radius < near)


def _enlarge(axes: Axes, path: np.ndarray) -> None:
    """The path once more, in the free middle of the circle."""
    half = _half_widths(path)
    centre = [np.nanmin(values) + size for values, size in zip(path, half)]
    inset = axes.inset_axes([0.3, 0.3, 0.42, 0.42])
    inset.set_facecolor("white")
    _trace(inset, path)
    _frame(inset, (centre[0], centre[1]), 1.25 * max(half))
    for axis in (inset.xaxis, inset.yaxis):
        axis.set_major_locator(MaxNLocator(2))
    inset.tick_params(labelsize=7, length=2, pad=1.5)
    inset.spines[["top", "right"]].set_visible(True)


def _summary(orbits: list[tuple], radius: float | None) -> Table:
    rows = []
    for speed, _, path in orbits:
        distance, mean = np.hypot(*path), np.nanmean(path, axis=1)
        share = 100 * np.nanmax(distance) / radius if radius else None
        spread = np.nanmax(np.hypot(*(path - mean[:, None])))
        direction = np.degrees(np.arctan2(mean[1], mean[0])) % 360
        rows.append((speed, *(round(value, 1) for value in (np.hypot(*mean), direction, spread, np.nanmax(distance))),
                     round(share, 1) if share else None))
    head = ("input speed (rpm)", "distance of the mean (µm)", "its direction (deg)", "farthest from the mean (µm)",
            "farthest from the middle (µm)", "of the clearance (%)")
    return Table(head, rows)


def _data(orbits: list[tuple]) -> Table:
    rows = [(speed, 1e3 * t, x, y) for speed, time, path in orbits for t, x, y in zip(time[::EVERY], *path[:, ::EVERY])]
    return Table(("input speed (rpm)", "time (ms)", "cage centre x (µm)", "cage centre y (µm)"), rows)
