"""Figures of a ball bearing in time: slip, loads on the cage, one ball, the cage's place, heat by cause."""

from __future__ import annotations

import numpy as np

from orbearing import style
from orbearing.blocks import FigureBlock, Table
from orbearing.point_file import PointFile
from orbearing.result_folder import Report

WIDE = (7.4, 3.6)
CAUSES = {
    "sliding": "sliding in the contacts",
    "differential_slip": "curved ellipses",
    "spin": "spin",
    "rolling": "rolling resistance",
    "contact_damping": "contact damping",
    "cage": "pockets and lands",
    "churning": "drag and churning",
}
LAST = 0.2  # share of the run at its end that shows single passages


def blocks(report: Report, file: PointFile) -> list[FigureBlock]:
    """In the order of the page."""
    study = Report(report.record("balls"), report.folder)
    return [slip(file), heat(study), cage_loads(file), one_ball(file), cage_place(file)]


def _missing(slug: str, title: str, file: PointFile) -> FigureBlock:
    return FigureBlock(slug, title, missing=file.problem or "This result holds no motion in time.")


def _over_time(slug: str, title: str, file: PointFile, name: str, label: str, caption: str, factor: float = 1.0, last: bool = False) -> FigureBlock:
    found = file.get("time", name)
    if found is None:
        return _missing(slug, title, file)
    time, values = found
    shown = time >= (1.0 - LAST) * time[-1] if last else np.ones(len(time), dtype=bool)
    figure, axes = style.panel(WIDE)
    axes.plot(1e3 * time[shown], factor * values[shown], color=style.BLUE, linewidth=0.7)
    axes.set_xlabel("time (ms)")
    axes.set_ylabel(label)
    style.thousands(axes.xaxis)
    return FigureBlock(slug, title, caption, (style.to_svg(figure, slug, f"{title}: {label} over time"),))


def slip(file: PointFile) -> FigureBlock:
    """1 - speed of the cage over that of pure rolling."""
    return _over_time("ball-slip", "Slip of the cage", file, "cage_slip", "slip (%)",
                      "How far the cage lags behind pure rolling of the balls on both races, at the speed that the rings have at each instant.", 100.0)


def cage_loads(file: PointFile) -> FigureBlock:
    """Largest load of a ball on its pocket."""
    return _over_time("ball-impacts", "Loads of balls on the cage", file, "pocket_load", "largest load (N)",
                      "The largest of all balls since the sample before: none is missed between samples.")


def one_ball(file: PointFile) -> FigureBlock:
    """Load of the first ball on the inner race."""
    return _over_time("ball-load", "One ball", file, "first_ball_inner_load", "load on the inner race (N)",
                      "The first ball in the last fifth of the run: it carries while it passes the loaded zone.", last=True)


def cage_place(file: PointFile) -> FigureBlock:
    """Centre of the cage in the plane of the bearing."""
    slug, title = "ball-cage", "Place of the cage"
    found = file.get("time", "cage_x", "cage_y")
    if found is None:
        return _missing(slug, title, file)
    time, x, y = found
    shown = time >= (1.0 - LAST) * time[-1]
    figure, axes = style.panel((4.2, 4.0))
    axes.plot(1e6 * x[shown], 1e6 * y[shown], color=style.BLUE, linewidth=0.6)
    axes.set_xlabel("along the radial load (µm)")
    axes.set_ylabel("across it (µm)")
    axes.set_aspect("equal", adjustable="datalim")
    return FigureBlock(slug, title, "The cage's centre in the last fifth of the run.", (style.to_svg(figure, slug, title),))


def heat(study: Report) -> FigureBlock:
    """Mean power lost, by cause."""
    slug, title = "ball-heat", "Heat by cause"
    stored = study.record("heat_W")
    powers = [(label, stored.get(cause)) for cause, label in CAUSES.items() if isinstance(stored.get(cause), (int, float))]
    if not powers:
        return FigureBlock(slug, title, missing="This result holds no heat by cause.")
    figure, axes = style.panel(WIDE)
    names, values = zip(*powers)
    axes.barh(range(len(values)), values, color=style.ORANGE)
    axes.set_yticks(range(len(values)), names)
    axes.invert_yaxis()
    axes.set_xlabel("mean power lost (W)")
    caption = "Over the observed time. Friction in the contacts is shared by the motion that does the work: one share alone may be slightly negative."
    return FigureBlock(slug, title, caption, (style.to_svg(figure, slug, title),), data=Table(("cause", "power (W)"), powers))
