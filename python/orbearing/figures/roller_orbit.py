"""Sliding and film of one roller along its orbit."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number
from orbearing.point_file import load_zone, one_roller, read_point
from orbearing.result_folder import Report

SLUG, TITLE = "roller-orbit", "Sliding and film along the orbit"
NAMES = ("roller_inner_sliding", "roller_outer_sliding", "roller_inner_film", "roller_outer_film")
MICRO = 1e6  # [µm/m]
EVERY = 5  # one in so many stored instants stands in the table
CAPTION = (
    "One roller at the speed of the peak, by its place: 0° outward, 90° along carrier rotation, 180° towards the sun; it moves "
    "towards {sense} angles. Shaded is the load zone. Above: surface speed of each race less that of the roller; at zero it rolls. "
    "In the zone traction brings the roller to rolling, outside it loses spin to drag and slides until it enters again. "
    "Below: least film on each race; it thins where the load is high and where entrainment is low."
)


def block(report: Report) -> FigureBlock:
    """Sliding above, film below, over the place of the roller."""
    point = read_point(report, report.peak_speed)
    found = one_roller(point, *NAMES)
    if found is None or not any(np.isfinite(values).any() for values in found[2:]):
        return FigureBlock(SLUG, TITLE, missing=point.problem or "No sliding and film over time were stored at the speed of the peak.")
    sense = "rising" if np.unwrap(found[1])[-1] > found[1][0] else "falling"
    order = np.argsort(found[1], kind="stable")
    angle, *series = (values[order] for values in found[1:])
    columns = [np.degrees(angle), *series[:2], *(MICRO * film for film in series[2:])]
    head = ("place (deg)", "sliding, inner (m/s)", "sliding, outer (m/s)", "film, inner (µm)", "film, outer (µm)")
    table = Table(head, list(zip(*(values[::EVERY] for values in columns))))
    picture = _draw(report.peak_speed, columns, load_zone(point, angle))
    return FigureBlock(SLUG, TITLE, CAPTION.format(sense=sense), (picture,), data=table)


def _draw(speed: float, columns: list[np.ndarray], zone: np.ndarray) -> str:
    place, inner_sliding, outer_sliding, inner_film, outer_film = columns
    figure = Figure(figsize=(5.6, 5.6))
    sliding, film = figure.subplots(2, 1, sharex=True)
    for axes, inner, outer in ((sliding, inner_sliding, outer_sliding), (film, inner_film, outer_film)):
        axes.plot(place, outer, color=style.VERMILION, label="outer race")
        axes.plot(place, inner, color=style.BLUE, linestyle="--", label="inner race")
        style.shade(axes, place, zone, "load zone")
    sliding.axhline(0, color=style.GREY, linewidth=0.8)
    sliding.set_ylabel("sliding speed (m/s)")
    film.set_ylabel("least film (µm)")
    film.set_ylim(bottom=0)
    film.set_xlim(0, 360)
    film.set_xticks(range(0, 361, 45), [f"{place}°" for place in range(0, 361, 45)])
    film.set_xlabel(f"place of the roller, at {format_number(speed)} rpm input speed")
    style.legend_above(sliding, columns=3)
    return style.to_svg(figure, SLUG, "Sliding speed and film thickness of one roller by place on its orbit")
