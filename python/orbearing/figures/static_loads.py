"""Loads of the rolling elements of a bearing under a static load, or of the first row of a pair."""

from __future__ import annotations

import numpy as np

from orbearing import style
from orbearing.blocks import FigureBlock, columns_table, format_quantity
from orbearing.result_folder import Report, numbers

SLUG, TITLE = "element-loads", "Loads of the rolling elements"


def block(report: Report, kind: str = "static") -> FigureBlock:
    """A bar for each rolling element at its angle from the line of the load; `kind`: static or pair."""
    study = Report(report.record(kind), report.folder)
    load = numbers(study.content.get("contact_loads_N"))
    if kind == "pair":
        load = load[:len(load) // 2]
    if not len(load):
        return FigureBlock(SLUG, TITLE, missing="This result has no loads of rolling elements.")
    stated = numbers(study.record("steps").get("element_angles_deg"))
    angle = stated if len(stated) == len(load) else np.arange(len(load)) * 360.0 / len(load)
    angle = (angle + 180.0) % 360.0 - 180.0
    order = np.argsort(angle, kind="stable")
    most = format_quantity(float(load.max()), "N", 4)
    whose = "of the first row under the preload" if kind == "pair" else "by its angle from the line of the radial load"
    caption = (f"Load of each rolling element on the inner race {whose}. Largest load: {most}. "
               f"{int((load > 0).sum())} of {len(load)} elements carry load.")
    data = columns_table(("angle (deg)", "load (N)"), angle[order], load[order])
    return FigureBlock(SLUG, TITLE, caption, (_draw(angle[order], load[order]),), data=data)


def _draw(angle: np.ndarray, load: np.ndarray) -> str:
    figure, axes = style.panel()
    axes.bar(angle, load, width=0.7 * 360.0 / len(load), color=style.BLUE)
    axes.set_xlim(-190, 190)
    axes.set_xticks(np.arange(-180, 181, 60))
    axes.set_xlabel("angle from the line of the load (deg)")
    axes.set_ylabel("load of the element (N)")
    style.thousands(axes.yaxis)
    return style.to_svg(figure, SLUG, "Load of each rolling element over its angle")
