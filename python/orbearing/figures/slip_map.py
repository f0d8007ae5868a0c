"""Slip of cage and rollers as a map over speed and load."""

from __future__ import annotations

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import Normalize, TwoSlopeNorm
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, columns_table, format_number, is_number
from orbearing.drawn import states_map
from orbearing.result_folder import Report, lies_on, same

SLUG, TITLE = "slip-map", "Slip over speed and load"
SLIPS = (("cage_slip", "cage"), ("orbit_slip", "orbit"), ("roller_slip", "rollers"))
MOST_LABELLED = 80  # cells of a map that show their number
CELL = 0.5  # [inch] wide, for a number of four letters
CAPTION = (
    "Slip in per cent at each operating point of the sweep, over input speed and {axis}; {loads} the load on one bearing's bore in "
    "newtons, the carrier's centrifugal field included. {limits} Published measurements and models of cylindrical roller bearings with a "
    "turning inner ring report slip that grows with speed and falls with load, up to 60 % of cage and rollers in the load zone and 80 % of "
    "rollers outside it under light loads [GuoKeller2020]. In a planet the load itself grows with the square of the speed and rollers are "
    "pressed on a race by the carrier's rotation, so the table says how far that trend holds here: in how many steps from one point to its "
    "neighbour slip rises."
)


def block(report: Report) -> FigureBlock:
    """A map for the cage and one for the rollers, where speed and one other axis span a grid."""
    chosen = _axis(report)
    if chosen is None:
        return FigureBlock(SLUG, TITLE, missing="The sweep has no second axis that spans a grid with input.speed.")
    points = _on_plane(report, chosen)
    speeds, values = _levels(points, "input_speed_rpm"), _levels(points, chosen)
    maps = {name: 100 * _grid(points, chosen, speeds, values, name) for name, _ in SLIPS}
    if not any(np.isfinite(one).any() for one in maps.values()):
        return FigureBlock(SLUG, TITLE, missing="No point of this sweep has a slip.")
    load = _grid(points, chosen, speeds, values, "planet_load_N")
    pictures = tuple(_draw(speeds, values, maps[name], load, chosen, title, f"{SLUG}-{title}") for name, title in SLIPS
                     if np.isfinite(maps[name]).any())
    caption = CAPTION.format(axis=_label(chosen), loads="below it" if load.size <= MOST_LABELLED else "thin lines are", limits=_limits(report))
    return FigureBlock(SLUG, TITLE, caption, pictures, summary=_trend(maps, chosen), data=_data(points, chosen))


def _axis(report: Report) -> str | None:
    """The first axis that has more than one value on the plane through the shown line of speeds."""
    for axis in report.records("axes"):
        column = str(axis.get("column"))
        points = _on_plane(report, column)
        if len(_levels(points, column)) > 1 and len(_levels(points, "input_speed_rpm")) > 1:
            return column
    return None


def _on_plane(report: Report, column: str) -> list[dict]:
    """Points whose other axes have the values that are shown."""
    others = {key: value for key, value in report.record("slice").items() if key != column}
    return [p for p in report.records("points") if lies_on(p, others)]


def _levels(points: list[dict], column: str) -> np.ndarray:
    levels: list[float] = []
    for value in sorted(p[column] for p in points if is_number(p.get(column))):
        if not levels or not same(levels[-1], value):
            levels.append(value)
    return np.array(levels)


def _grid(points: list[dict], column: str, speeds: np.ndarray, values: np.ndarray, name: str) -> np.ndarray:
    """(values, speeds), NaN where a point is missing."""
    grid = np.full((len(values), len(speeds)), np.nan)
    for p in points:
        if is_number(p.get(name)) and is_number(p.get(column)) and is_number(p.get("input_speed_rpm")):
            grid[np.argmin(abs(values - p[column])), np.argmin(abs(speeds - p["input_speed_rpm"]))] = p[name]
    return grid


def _label(column: str) -> str:
    """input.power_kW -> input.power (kW)"""
    name, _, unit = column.rpartition("_")
    return f"{name} ({unit.replace('_per_', '/')})" if name else column


def _limits(report: Report) -> str:
    """What slip can be at most, and what it is at pure rolling."""
    text = "Zero is the kinematic limit, pure rolling on both races; black contours mark it where it is crossed. "
    cage, inner, outer = (report.record("kinematics").get(name) for name in ("cage", "inner_race", "outer_race"))
    if not all(is_number(value) for value in (cage, inner, outer)) or cage == 0:
        return text.strip()
    ends = sorted(100 * (1 - race / cage) for race in (inner, outer))
    return text + (f"A cage, or rollers without one, that turned with one race would slip by {format_number(ends[0], 3)} % or {format_number(ends[1], 3)} %: "
                   "traction of the races takes it no further.")


def _draw(speeds: np.ndarray, values: np.ndarray, slip: np.ndarray, load: np.ndarray, column: str, title: str, slug: str) -> str:
    figure, axes = style.panel((max(5.0, 2.0 + CELL * len(speeds)) if slip.size <= MOST_LABELLED else 5.0, 4.2))
    x, y = np.arange(len(speeds)), np.arange(len(values))
    colours, scale = _colours(slip)
    mesh = axes.pcolormesh(x, y, np.ma.masked_invalid(slip), shading="nearest", cmap=colours, norm=scale, edgecolors="white", linewidth=0.4)
    if slip.size <= MOST_LABELLED:
        _number(axes, slip, load, colours, scale)
    elif np.isfinite(load).all():
        lines = states_map(axes.contour(x, y, load, 5, colors=style.GREY, linewidths=0.8), x, y, load)
        axes.clabel(lines, fmt=lambda value: f"{value:,.0f}", fontsize=7)
    if np.isfinite(slip).all() and slip.min() < 0 < slip.max():
        states_map(axes.contour(x, y, slip, [0.0], colors=style.BLACK, linewidths=1.8), x, y, slip)
    _ticks(axes.xaxis, x, speeds)
    _ticks(axes.yaxis, y, values)
    axes.grid(False)
    axes.set_xlabel("input speed (rpm)")
    axes.set_ylabel(_label(column))
    bar = figure.colorbar(mesh, ax=axes, shrink=0.9)
    bar.solids.set(rasterized=False, edgecolor="face")
    bar.set_label(f"slip of the {title} (%)")
    style.thousands(bar.ax.yaxis)
    return style.to_svg(figure, slug, f"Slip of the {title} over input speed and {_label(column)}")


def _ticks(axis, places: np.ndarray, levels: np.ndarray) -> None:
    """The grid's own values, evenly spaced as its cells are, so that uneven steps stay legible; at most twelve."""
    step = -(-len(levels) // 12)
    axis.set_ticks(places[::step], [format_number(float(value)) for value in levels[::step]])


def _colours(slip: np.ndarray):
    """White at pure rolling; both colours where the cage runs ahead somewhere and behind elsewhere."""
    low, high = np.nanmin(slip), np.nanmax(slip)
    reach = max(abs(low), abs(high), 1e-9)
    if low < 0 < high:
        return colormaps["PuOr_r"], TwoSlopeNorm(0.0, -reach, reach)
    return (colormaps["Oranges"], Normalize(0, reach)) if high > 0 else (colormaps["Purples_r"], Normalize(-reach, 0))


def _number(axes: Axes, slip: np.ndarray, load: np.ndarray, colours, scale) -> None:
    """Slip and, below it, the load in each cell."""
    for row, column in np.argwhere(np.isfinite(slip)):
        red, green, blue, _ = colours(scale(slip[row, column]))
        dark = 0.3 * red + 0.59 * green + 0.11 * blue < 0.5
        colour = "white" if dark else style.BLACK
        axes.text(column, row + 0.08, f"{slip[row, column]:.2g}".replace("-", "\u2212"), ha="center", va="bottom", fontsize=8, color=colour)
        if np.isfinite(load[row, column]):
            axes.text(column, row - 0.08, f"{load[row, column]:,.0f}", ha="center", va="top", fontsize=6, color=colour)


def _trend(maps: dict[str, np.ndarray], column: str) -> Table:
    rows = []
    for name, title in SLIPS:
        if not np.isfinite(maps[name]).any():
            continue
        for along, what in ((1, "input speed"), (0, _label(column))):
            steps = np.diff(maps[name], axis=along)
            known = steps[np.isfinite(steps)]
            rows.append((f"slip of the {title}", what, f"{int((known > 0).sum())} of {len(known)} steps"))
    return Table(("quantity", "as this grows", "it rises in"), rows)


def _data(points: list[dict], column: str) -> Table:
    names = ("input_speed_rpm", column, "planet_load_N", "cage_slip", "orbit_slip", "roller_slip", "status")
    return columns_table(names, *([p.get(name) for p in points] for name in names))
