"""Roller loads by place around the bearing, in the carrier frame."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, is_number
from orbearing.result_folder import Report, curve

TITLE = "Roller loads around the bearing"
SIZE = (3.3, 3.9)  # [inch], three stand side by side
CAPTION = (
    "Contact load of the rollers by their place, seen so that the sun lies below and the carrier turns counter-clockwise: x "
    "outward, y along carrier rotation. The arrow is the direction of the load on the planet; its rollers carry on the side "
    "opposite to where it points, because there the bore is pressed against the pin. At low speed the load is tangential; the "
    "faster the carrier turns, the more it points outward and the more the load zone moves towards the sun. The two races differ "
    "by the inertia of the rollers: their own orbit presses them on the outer race, the carrier's rotation away from the sun, "
    "which on the sun side is on the inner race. Each picture has its own load scale."
)


def block(report: Report) -> FigureBlock:
    """One picture for each speed that has loads."""
    usable = [entry for entry in report.records("polar") if _has_loads(entry)]
    if not usable:
        return FigureBlock("polar", TITLE, missing="No roller loads by place were stored for this result.")
    pictures = tuple(_draw(entry, f"polar-{index}") for index, entry in enumerate(usable, start=1))
    left_out = len(report.records("polar")) - len(usable)
    caption = "Quasi-static. " + CAPTION + (f" {left_out} speed(s) without loads are left out." if left_out else "")
    return FigureBlock("polar", TITLE, caption, pictures, data=_table(usable))


def columns(entry: dict) -> list[np.ndarray]:
    """Angle [deg], inner and outer load [N], by rising angle."""
    unsorted = curve(entry, "angle_deg", "inner_load_N", "outer_load_N")
    order = np.argsort(np.mod(unsorted[0], 360.0), kind="stable")
    return [column[order] for column in unsorted]


def _has_loads(entry: dict) -> bool:
    angle, inner, outer = columns(entry)
    return bool(np.any(np.isfinite(angle) & (np.isfinite(inner) | np.isfinite(outer))))


def _draw(entry: dict, slug: str) -> str:
    angle, inner, outer = columns(entry)
    figure = Figure(figsize=SIZE)
    axes = figure.add_subplot(projection="polar")
    turn(axes)
    series = ((outer, "outer race", style.VERMILION, "s", 4.6), (inner, "inner race", style.BLUE, "o", 3.2))
    for load, label, colour, marker, size in series:
        _ring(axes, angle, load, label=label, color=colour, marker=marker if len(angle) <= style.MOST_MARKERS else "",
              markersize=size)
    reach = np.nanmax([np.nanmax(column, initial=0) for column in (inner, outer)]) or 1.0
    axes.set_ylim(0, 1.12 * reach)
    _arrow(axes, entry, reach)
    axes.yaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10], prune="lower"))
    style.thousands(axes.yaxis)
    speed = format_number(entry.get("speed_rpm"))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncol=2, borderaxespad=0)
    axes.set_title(f"{speed} rpm, load in N", pad=12)
    return style.to_svg(figure, slug, f"Roller loads around the bearing at {speed} rpm")


def turn(axes: PolarAxes) -> None:
    """Outward is up and carrier rotation counter-clockwise."""
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(1)
    ticks = {0: "x, outward\n0°", 45: "45°", 90: "y\n90°", 135: "135°",
             180: "180°\nto the sun", 225: "225°", 270: "270°", 315: "315°"}
    axes.set_xticks(np.radians(list(ticks)), list(ticks.values()))
    axes.tick_params(axis="x", labelsize=8, pad=1)
    axes.tick_params(axis="y", labelsize=8)


def _ring(axes: PolarAxes, angle: np.ndarray, load: np.ndarray, **look) -> None:
    known = np.isfinite(angle) & np.isfinite(load)
    theta, radius = np.radians(angle[known]), load[known]
    if len(theta):
        if look["color"] == style.BLUE:  # one filled ring: two would mix to grey
            axes.fill(theta, radius, color=look["color"], alpha=0.15, linewidth=0)
        axes.plot(np.append(theta, theta[0]), np.append(radius, radius[0]), linewidth=1.3, **look)


def load_direction(entry: dict) -> float | None:
    """Direction of the load on the planet [rad]; from the roller loads where it is not stored.

    The rollers push the bore outward with their outer loads, and these balance the load on the planet.
    """
    x, y = entry.get("planet_load_x_N"), entry.get("planet_load_y_N")
    if is_number(x) and is_number(y):
        return float(np.arctan2(y, x))
    angle, _, outer = curve(entry, "angle_deg", "inner_load_N", "outer_load_N")
    total = np.nansum(outer * np.exp(1j * np.radians(angle)))
    return float(np.angle(-total)) if abs(total) > 0 else None


def _arrow(axes: PolarAxes, entry: dict, reach: float) -> None:
    direction = load_direction(entry)
    if direction is None:
        return
    axes.annotate("", xy=(direction, 0.8 * reach), xytext=(direction, 0),
                  arrowprops={"arrowstyle": "-|>", "color": style.BLACK, "linewidth": 1.8, "shrinkA": 0, "shrinkB": 0})
    # The scale stands a little beside the arrow: there the rollers carry least.
    axes.set_rlabel_position(np.degrees(direction) + 45)


def _table(entries: list[dict]) -> Table:
    rows = [(entry.get("speed_rpm"), *row) for entry in entries for row in zip(*columns(entry))]
    return Table(("input speed (rpm)", "place (deg)", "inner race (N)", "outer race (N)"), rows)
