"""Life over input speed, with the published values, the grid's peak and the refined one."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from orbearing import style
from orbearing.blocks import FigureBlock, columns_table, format_number, is_number
from orbearing.result_folder import Report, curve

TITLE = "Life over speed"
# Half-width of the second picture relative to the peak's speed: wide enough for neighbours on a coarse grid.
ZOOM = 0.3


def block(report: Report) -> FigureBlock:
    """Both pictures; where no point has a life, a sentence in their place."""
    speed, life = report.point_column("input_speed_rpm"), report.point_column("life_h")
    if not np.any(np.isfinite(speed) & (life > 0)):
        return FigureBlock("life", TITLE, missing="No point of this sweep has a life, so there is no curve to show.")
    pictures = [_whole_range(report)]
    if is_number(_peak_speed(report)):
        pictures.append(_near_peak(report))
    table = columns_table(
        ("input speed (rpm)", "life of one bearing (h)", "life of all bearings (h)", "status"),
        speed, life, report.point_column("system_life_h"), [p.get("status") for p in report.records("points")],
    )
    return FigureBlock("life", TITLE, _caption(report), tuple(pictures), data=table)


def _peak_speed(report: Report) -> float | None:
    peak = report.record("peak")
    refined = peak.get("refined_speed_rpm")
    return refined if is_number(refined) else peak.get("speed_rpm")


def _whole_range(report: Report) -> str:
    figure, axes = style.panel((4.6, 4.4))  # higher than its neighbour by the legend
    _draw_curves(axes, report)
    _draw_failed(axes, report)
    style.speed_axis(axes)
    style.life_axis(axes)
    style.legend_above(axes, columns=1)
    return style.to_svg(figure, "life-range", "Life of one bearing over input speed, logarithmic life axis")


def _near_peak(report: Report) -> str:
    figure, axes = style.panel()
    _draw_curves(axes, report)
    centre = _peak_speed(report)
    low, high = (1 - ZOOM) * centre, (1 + ZOOM) * centre
    heights = [y for line in axes.lines for x, y in zip(line.get_xdata(), line.get_ydata()) if low <= x <= high and y > 0]
    axes.set_xlim(low, high)
    if heights:
        margin = 0.12 * (max(heights) - min(heights)) or 0.1 * max(heights)
        axes.set_ylim(max(min(heights) - margin, 0), max(heights) + margin)
    axes.set_title("near the peak, linear scale", loc="left")
    style.speed_axis(axes)
    axes.set_ylabel("life of one bearing (h)")
    style.thousands(axes.yaxis)
    return style.to_svg(figure, "life-peak", "Life of one bearing near its peak, linear life axis")


def _draw_curves(axes: Axes, report: Report) -> None:
    fine_speed, fine_life = curve(report.record("fine"), "speed_rpm", "life_h")
    if np.any(fine_life > 0):
        axes.plot(fine_speed, _positive(fine_life), color=style.BLUE, label="quasi-static, fine grid")
    speed, life = report.point_column("input_speed_rpm"), _positive(report.point_column("life_h"))
    look = {"marker": "o", "linestyle": "", **style.points_look(len(speed), len(fine_speed) > 0)}
    colour = style.GREEN if report.is_dynamic else style.BLUE
    axes.plot(speed, life, color=colour, markerfacecolor="white", label=f"points of the sweep ({report.fidelity})", **look)
    _draw_peaks(axes, report)
    for published, marker in zip(_published(report), "DvP<>hp8"):
        label = f"published: {published['source']}, {format_number(published['life_h'])} h"
        axes.plot([published["speed_rpm"]], [published["life_h"]], marker, color=style.VERMILION,
                  label=style.legend_label(label), zorder=6, markeredgecolor="white")


def _draw_peaks(axes: Axes, report: Report) -> None:
    peak = report.record("peak")
    marks = (("", "grid peak", "s", "none"), ("refined_", "refined peak", "*", style.ORANGE))
    for prefix, name, marker, colour in marks:
        speed, life = peak.get(f"{prefix}speed_rpm"), peak.get(f"{prefix}life_h")
        if is_number(speed) and is_number(life) and life > 0:
            label = f"{name}: {format_number(speed)} rpm, {format_number(life)} h"
            axes.plot([speed], [life], marker, color=colour, markeredgecolor=style.BLACK, label=label, zorder=5,
                      markersize=10 if prefix else 9)


def _draw_failed(axes: Axes, report: Report) -> None:
    speeds = [p["input_speed_rpm"] for p in report.failed_points if is_number(p.get("input_speed_rpm"))]
    if speeds:
        axes.plot(speeds, [0.02] * len(speeds), "x", color=style.GREY, transform=axes.get_xaxis_transform(),
                  label="point without a life", clip_on=False)


def _positive(values: np.ndarray) -> np.ndarray:
    return np.where(values > 0, values, np.nan)


def _published(report: Report) -> list[dict]:
    """Published lives that have a place on this curve."""
    rows = report.records("published")
    return [{**r, "source": str(r.get("source") or "unnamed source")} for r in rows
            if is_number(r.get("speed_rpm")) and is_number(r.get("life_h")) and r["life_h"] > 0]


def _caption(report: Report) -> str:
    text = ("At constant power torque and tooth forces fall as speed rises, while the planet's centrifugal force grows with the "
            "square of speed: life climbs where the first rule and falls where the second does, and the peak lies between. ")
    if report.is_dynamic and report.record("gears"):
        text += ("Points are those in motion, shaken by the meshes unless the case leaves that out: they lie below the line most "
                 "where a mesh harmonic meets a mode of the gears (acceleration of the planets, below). ")
    if len(report.records("points")) == 1:
        text += "This result has a single point, so there is no curve of points to follow. "
    if report.failed_points:
        text += f"{len(report.failed_points)} point(s) gave no life; crosses on the axis mark their speeds. "
    if not _published(report):
        text += "No published life is given for this case. "
    return text.strip()
