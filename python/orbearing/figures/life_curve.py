"""Life over input speed, with the published values, the grid's peak and the refined one."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from orbearing import style
from orbearing.blocks import FigureBlock, columns_table, format_number, is_number
from orbearing.figures.gear_modes import campbell_beside_life, excited_meetings
from orbearing.lives import LUNDBERG_PALMGREN
from orbearing.result_folder import Report, curve

TITLE = "Life over speed"
# Half-width of the second picture relative to the peak's speed: wide enough for neighbours on a coarse grid.
ZOOM = 0.3
CAMPBELL_SIZE = (4.6, 4.4)


def block(report: Report) -> FigureBlock:
    """Both pictures; where no point has a life, a sentence in their place."""
    speed, life = report.point_column("input_speed_rpm"), report.point_column(report.life_key)
    if not np.any(np.isfinite(speed) & (life > 0)):
        return FigureBlock("life", TITLE, missing=f"No point of this sweep has {style.a_life(report.life_key)}, so there is no curve to show.")
    pictures = [_whole_range(report)]
    if is_number(report.peak_speed):
        pictures.append(_near_peak(report))
    swept = speed[np.isfinite(speed)]
    campbell = campbell_beside_life(report.record("gears"), swept.min(), swept.max(), CAMPBELL_SIZE) if report.is_dynamic else None
    if campbell:
        pictures.append(campbell)
    points = report.records("points")
    table = columns_table(
        ("input speed (rpm)", style.life_label(report.life_key), style.life_label(report.life_key).replace("one bearing", "all bearings"),
         "nearest resonance", "status"),
        speed, life, report.point_column(f"system_{report.life_key}"), [resonance_of(p) for p in points],
        [f"{p.get('status')}, added" if p.get("refined") is True else p.get("status") for p in points],
    )
    return FigureBlock("life", TITLE, _caption(report), tuple(pictures), data=table)


def resonance_of(point: dict) -> str:
    """The nearest resonance of a point in words, as 2 × P1 at 6,063 rpm."""
    order, speed = point.get("resonance_harmonic"), point.get("resonance_speed_rpm")
    if not (is_number(order) and is_number(speed)):
        return ""
    return f"{order:g} × {point.get('resonance_mode')} at {speed:,.0f} rpm"


def _whole_range(report: Report) -> str:
    figure, axes = style.panel((4.6, 4.4))  # higher than its neighbour by the legend
    _draw_curves(axes, report)
    _draw_failed(axes, report)
    style.speed_axis(axes)
    style.life_axis(axes, report.life_key)
    style.legend_above(axes, columns=1)
    return style.to_svg(figure, "life-range", "Life of one bearing over input speed, logarithmic life axis")


def _near_peak(report: Report) -> str:
    figure, axes = style.panel()
    _draw_curves(axes, report)
    centre = report.peak_speed
    low, high = (1 - ZOOM) * centre, (1 + ZOOM) * centre
    heights = [y for line in axes.lines for x, y in zip(line.get_xdata(), line.get_ydata()) if low <= x <= high and y > 0]
    axes.set_xlim(low, high)
    if heights:
        margin = 0.12 * (max(heights) - min(heights)) or 0.1 * max(heights)
        axes.set_ylim(max(min(heights) - margin, 0), max(heights) + margin)
    axes.set_title("near the peak, linear scale", loc="left")
    _draw_resonances(axes, report, low, high)
    style.speed_axis(axes)
    axes.set_ylabel(style.life_label(report.life_key))
    style.thousands(axes.yaxis)
    return style.to_svg(figure, "life-peak", "Life of one bearing near its peak, linear life axis")


def _draw_curves(axes: Axes, report: Report) -> None:
    fine_speed, fine_life = curve(report.record("fine"), "speed_rpm", report.life_key)
    if np.any(fine_life > 0):
        axes.plot(fine_speed, _positive(fine_life), color=style.BLUE, label="quasi-static, fine grid")
    _draw_points(axes, report, with_fine_curve=len(fine_speed) > 0)
    _draw_peaks(axes, report)
    for published, marker in zip(_published(report), "DvP<>hp8"):
        label = f"published: {published['source']}, {format_number(published['life_h'])} h"
        axes.plot([published["speed_rpm"]], [published["life_h"]], marker, color=style.VERMILION,
                  label=style.legend_label(label), zorder=6, markeredgecolor="white")


def _draw_points(axes: Axes, report: Report, with_fine_curve: bool) -> None:
    """The grid's points, those added around the peak, and in motion the line through all, with its dips."""
    speed, life = report.point_column("input_speed_rpm"), _positive(report.point_column(report.life_key))
    added = np.array([point.get("refined") is True for point in report.records("points")], dtype=bool)
    colour = style.GREEN if report.is_dynamic else style.BLUE
    look = {"marker": "o", "linestyle": "", **style.points_look(int((~added).sum()), with_fine_curve)}
    if added.any() and report.is_dynamic:
        order = np.argsort(speed, kind="stable")
        axes.plot(speed[order], life[order], color=colour, linewidth=0.9, zorder=2.1)
    if added.any():
        look["linestyle"] = ""
        axes.plot(speed[added], life[added], color=colour, marker="o", markersize=2.6, linestyle="", zorder=2.2,
                  label="points added until the peak is known")
    axes.plot(speed[~added], life[~added], color=colour, markerfacecolor="white", zorder=2.3,
              label=f"points of the sweep ({report.fidelity})", **look)


def _draw_resonances(axes: Axes, report: Report, low: float, high: float) -> None:
    """Where a mesh harmonic meets a mode that it excites; named at the top, close ones once."""
    if not report.is_dynamic:
        return
    last = -np.inf
    for meeting in sorted(excited_meetings(report.record("gears")), key=lambda m: m["speed_rpm"]):
        speed = meeting["speed_rpm"]
        if not low < speed < high:
            continue
        axes.axvline(speed, color=style.GREY, linewidth=0.8, linestyle=(0, (2, 2)), zorder=1)
        if speed - last > 0.03 * (high - low):
            axes.text(speed, 0.02, f" {meeting['order']} × {meeting.get('mode')}", transform=axes.get_xaxis_transform(), rotation=90,
                      ha="right", va="bottom", fontsize=8, color=style.GREY)
            last = speed


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
                  label=f"point without {style.a_life(report.life_key)}", clip_on=False)


def _positive(values: np.ndarray) -> np.ndarray:
    return np.where(values > 0, values, np.nan)


def _published(report: Report) -> list[dict]:
    """Published lives that have a place on this curve: they are those of Lundberg and Palmgren."""
    rows = report.records("published") if report.life_key == LUNDBERG_PALMGREN else []
    return [{**r, "source": str(r.get("source") or "unnamed source")} for r in rows
            if is_number(r.get("speed_rpm")) and is_number(r.get("life_h")) and r["life_h"] > 0]


AT_CONSTANT_POWER = ("At constant power torque and tooth forces fall as speed rises, while the planet's centrifugal force grows with the "
                     "square of speed: life climbs where the first rule and falls where the second does, and the peak lies between. ")
BY_TORQUE = {"input.torque": "The torque is the same at all speeds. Tooth forces do not change, and the planet's centrifugal force grows with the square of speed. ",
             "input.torque_curve": "Torque and tooth forces follow the torque curve of the case, and the planet's centrifugal force grows with the square of speed. "}


def _caption(report: Report) -> str:
    duty = next((str(row.get("reason")).split(" ")[0] for row in report.records("assumptions") if row.get("key") == "input.power"), "")
    text = BY_TORQUE.get(duty, AT_CONSTANT_POWER)
    if any(point.get("refined") is True for point in report.records("points")):
        text += "Small points were added by the sweep until the speed of the longest life was known; each of them was computed. "
    if report.is_dynamic and report.record("gears"):
        text += ("Points are those in motion, shaken by the meshes unless the case leaves that out: they lie below the line most "
                 "where a mesh harmonic meets a mode of the gears: dashed lines, and rings in the Campbell diagram beside. The modes are those of gears "
                 "on springs as stiff as the bearings under the mean load, so that a dip lies near its line and not on it. ")
    if len(report.records("points")) == 1:
        text += "This result has a single point, so there is no curve of points to follow. "
    if report.failed_points:
        text += f"{len(report.failed_points)} point(s) gave no {style.life_name(report.life_key)}; crosses on the axis mark their speeds. "
    if not _published(report):
        text += "No published life is compared with this case. "
    return text.strip()
