"""The load on the planet's bore over speed, split by its causes."""

from __future__ import annotations

import numpy as np

from orbearing import style, summary
from orbearing.blocks import FigureBlock, columns_table, format_number, is_number
from orbearing.result_folder import Report, curve

TITLE = "Planet load and its parts"
NAMES = ("planet_load_N", "tangential_load_N", "radial_mesh_load_N", "centrifugal_load_N")
LABELS = ("total (magnitude)", "tangential, both meshes (y)", "radial, both meshes (x)", "centrifugal (x)")
LINES = ((style.BLACK, "-"), (style.BLUE, "--"), (style.GREEN, "-."), (style.VERMILION, (0, (1, 1.2))))
MARKERS = "os^D"


def block(report: Report) -> FigureBlock:
    """Lines from the fine curve, markers from the sweep, whichever is there."""
    fine = curve(report.record("fine"), "speed_rpm", *NAMES)
    points = [report.point_column(name) for name in ("input_speed_rpm", *NAMES)]
    if not any(np.isfinite(column).any() for column in (*fine[1:], *points[1:])):
        return FigureBlock("planet-load", TITLE, missing="No point of this result has a planet load.")
    table = columns_table(("input speed (rpm)", *(f"{label} (N)" for label in LABELS)), *(fine if len(fine[0]) else points))
    return FigureBlock("planet-load", TITLE, _caption(fine if len(fine[0]) else points, report), (_draw(fine, points),), data=table)


def _draw(fine: list[np.ndarray], points: list[np.ndarray]) -> str:
    figure, axes = style.panel((5.6, 4.0))
    axes.axhline(0, color=style.GREY, linewidth=0.8)
    has_fine = len(fine[0]) > 0
    for index, (label, (colour, dash), marker) in enumerate(zip(LABELS, LINES, MARKERS), start=1):
        if has_fine:
            axes.plot(fine[0], fine[index], color=colour, linestyle=dash, label=label)
        look = {"marker": marker, "linestyle": "", **style.points_look(len(points[0]), has_fine)}
        axes.plot(points[0], points[index], color=colour, markerfacecolor="white", markersize=4,
                  label=None if has_fine else label, **look)
    style.speed_axis(axes)
    axes.set_ylabel("load on one bearing (N)")
    style.thousands(axes.yaxis)
    style.legend_above(axes)
    return style.to_svg(figure, "planet-load", "Planet load and its tangential, radial and centrifugal parts over speed")


def _caption(columns: list[np.ndarray], report: Report) -> str:
    text = ("Loads of one bearing; x points outward from the sun axis, y along carrier rotation. Lines: quasi-static; markers: "
            "points of the sweep. The tangential part falls with speed, the centrifugal part rises with its square; the "
            "total, their vector sum, is least where the one takes over from the other")
    speed, total = columns[0], columns[1]
    if np.isfinite(total).sum() <= 2:
        return text + "."
    least = int(np.nanargmin(total))
    text += f": here {format_number(total[least], 4)} N at {format_number(speed[least], 4)} rpm."
    peak = summary.best(report)[0]
    if is_number(peak) and peak < speed[least]:
        text += f" Life peaks at a lower speed, {format_number(peak, 4)} rpm, since hours also run down with speed."
    return text
