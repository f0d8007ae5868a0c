"""Largest and rms load of one roller over speed, on both races."""

from __future__ import annotations

import numpy as np

from orbearing import style
from orbearing.blocks import FigureBlock, columns_table
from orbearing.result_folder import Report

TITLE = "Roller loads over speed"
SERIES = (
    ("outer_load_max_N", "outer race, largest", style.VERMILION, "-", "s"),
    ("inner_load_max_N", "inner race, largest", style.BLUE, "--", "o"),
    ("outer_load_rms_N", "outer race, rms", style.VERMILION, "-.", "D"),
    ("inner_load_rms_N", "inner race, rms", style.BLUE, (0, (1, 1.2)), "^"),
)


def block(report: Report) -> FigureBlock:
    """One picture from the points of the sweep."""
    speed = report.point_column("input_speed_rpm")
    columns = [report.point_column(name) for name, *_ in SERIES]
    if not any(np.isfinite(column).any() for column in columns):
        return FigureBlock("roller-loads", TITLE, missing="No point of this sweep has roller loads.")
    head = ("input speed (rpm)", *(f"{label} (N)" for _, label, *_ in SERIES))
    caption = ("Contact load of a single roller: the largest anywhere around the bearing, and the root mean square over time, "
               "unloaded time included. The races differ by the inertia of the roller itself: its own orbit loads the outer "
               "race, the carrier's rotation throws it away from the sun, and so on the inner race where the load zone lies there.")
    return FigureBlock("roller-loads", TITLE, caption, (_draw(speed, columns),), data=columns_table(head, speed, *columns))


def _draw(speed: np.ndarray, columns: list[np.ndarray]) -> str:
    figure, axes = style.panel((5.6, 4.0))
    for values, (_, label, colour, dash, marker) in zip(columns, SERIES):
        marker = marker if len(speed) <= style.MOST_MARKERS else ""
        axes.plot(speed, values, color=colour, linestyle=dash, marker=marker, markerfacecolor="white", label=label,
                  markersize=7 if colour == style.VERMILION else 4)  # both stay visible where they coincide
    axes.set_ylim(bottom=0)
    style.speed_axis(axes)
    axes.set_ylabel("contact load of one roller (N)")
    style.thousands(axes.yaxis)
    style.legend_above(axes)
    return style.to_svg(figure, "roller-loads", "Largest and rms roller load on inner and outer race over speed")
