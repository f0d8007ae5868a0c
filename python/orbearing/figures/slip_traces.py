"""Slip of cage and rollers over one revolution of the cage, or of the rollers that have none."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, is_number
from orbearing.point_file import load_zone, one_roller, read_point
from orbearing.result_folder import Report

SLUG, TITLE = "slip-traces", "Slip over one cage revolution"
RAD_PER_S = np.pi / 30  # of 1 rpm
EVERY = 5  # one in so many stored instants stands in the table
CAPTION = (
    "Slip in time, at the speed of the peak: one less the speed over that at pure rolling. Above: one roller's spin, with its load zone "
    "shaded, and the mean of all rollers; the roller is brought to rolling where it is squeezed and loses spin where it is free. Below: "
    "the cage, which follows the rollers that push it; below zero it runs ahead of pure rolling. The two pictures have their own scales."
)


CAPTION_WITHOUT_CAGE = (
    "Slip in time, at the speed of the peak: one less the speed over that at pure rolling. Above: one roller's spin, with its load zone "
    "shaded, and the mean of all rollers; the roller is brought to rolling where it is squeezed and loses spin where it is free. Below: "
    "the mean orbital speed of the rollers, which push one another. The two pictures have their own scales."
)


def block(report: Report) -> FigureBlock:
    """Both traces in per cent over time."""
    speed = report.peak_speed
    point = read_point(report, speed)
    rolling = [report.record("kinematics").get(name) for name in ("roller_spin", "cage")]
    found = one_roller(point, "roller_spin")
    caged = point.get("time", "orbit_speed") is None
    stored = point.get("time", "roller_spin", "cage_speed" if caged else "orbit_speed")
    if found is None or stored is None or len(stored[2]) != len(stored[0]) or not np.isfinite(found[2]).any():
        return FigureBlock(SLUG, TITLE, missing=point.problem or "No spins over time were stored at the speed of the peak.")
    if not all(is_number(ratio) and ratio for ratio in rolling):
        return FigureBlock(SLUG, TITLE, missing="The speeds at pure rolling are not given.")
    spin, cage = (ratio * speed * RAD_PER_S for ratio in rolling)
    one = [found[0], slip(found[2], spin)]
    known = np.isfinite(stored[0]) & np.isfinite(stored[1]).any(axis=0)
    time, spins, cage_speed = (values[..., known] for values in stored)
    every = [time - time[0], slip(np.nanmean(spins, axis=0), spin), slip(cage_speed, cage)]
    rows = zip(1e3 * every[0][::EVERY], np.interp(every[0], *one)[::EVERY], *(values[::EVERY] for values in every[1:]))
    table = Table(("time (ms)", "one roller (%)", "mean of the rollers (%)", "cage (%)" if caged else "mean orbit of the rollers (%)"), list(rows))
    picture = _draw(speed, one, every, load_zone(point, found[1]), caged)
    return FigureBlock(SLUG, TITLE if caged else "Slip over one orbit of the rollers", CAPTION if caged else CAPTION_WITHOUT_CAGE, (picture,),
                       data=table)


def slip(speed: np.ndarray, rolling: float) -> np.ndarray:
    """In per cent of the speed at pure rolling."""
    return 100 * (1 - speed / rolling)


def _draw(speed: float, one: list[np.ndarray], every: list[np.ndarray], zone: np.ndarray, caged: bool) -> str:
    figure = Figure(figsize=(5.6, 5.0))
    rollers, cage = figure.subplots(2, 1, sharex=True)
    rollers.plot(1e3 * one[0], one[1], color=style.VERMILION, label="one roller")
    rollers.plot(1e3 * every[0], every[1], color=style.BLACK, linestyle="--", linewidth=1.1, label="mean of all")
    cage.plot(1e3 * every[0], every[2], color=style.BLUE)
    style.shade(rollers, 1e3 * one[0], zone, "load zone of the one")
    for axes, label in ((rollers, "slip of rollers (%)"), (cage, "slip of the cage (%)" if caged else "slip of the orbit (%)")):
        axes.axhline(0, color=style.GREY, linewidth=0.8)
        axes.set_ylabel(label)
        style.thousands(axes.yaxis)
    cage.set_xlim(0, 1e3 * every[0][-1])
    cage.set_xlabel(f"time at {format_number(speed)} rpm input speed (ms)")
    style.legend_above(rollers, columns=3)
    return style.to_svg(figure, SLUG, f"Slip of one roller, of all rollers and of {'the cage' if caged else 'their orbit'} over one revolution")
