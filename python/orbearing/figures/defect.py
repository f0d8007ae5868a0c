"""Figures of a bearing with scratches: vibration, spectrum and envelope spectrum with their lines, one ball."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number
from orbearing.point_file import PointFile
from orbearing.result_folder import Report

TURNS = 5  # of the shaft, that pictures over time show
WIDE = (7.4, 3.6)
MOST_MARKED = 8
SHOWN_PASSES = 8


def blocks(report: Report, file: PointFile) -> list[FigureBlock]:
    """In the order of the page."""
    study = Report(report.record("defect"), report.folder)
    return [vibration(study, file), envelope_spectrum(study, file), spectrum(study, file), one_ball(study, file)]


def _brief(study: Report, time: np.ndarray) -> np.ndarray:
    turns = study.content.get("shaft_Hz") or 0.0
    return time <= (TURNS / turns if turns > 0 else np.inf)


def _missing(slug: str, title: str, file: PointFile) -> FigureBlock:
    return FigureBlock(slug, title, missing=file.problem or "This result holds no vibration in time.")


def vibration(study: Report, file: PointFile) -> FigureBlock:
    """Acceleration along the load over some turns of the shaft, and its envelope."""
    title, slug = "Acceleration of the outer ring", "defect-vibration"
    found = file.get("time", "acceleration", "envelope")
    if found is None:
        return _missing(slug, title, file)
    time, acceleration, envelope = found
    brief = _brief(study, time)
    figure, axes = style.panel(WIDE)
    axes.plot(1e3 * time[brief], acceleration[0][brief], color=style.BLUE, linewidth=0.6, label="along the load")
    axes.plot(1e3 * time[brief], envelope[brief], color=style.VERMILION, linewidth=0.9, label="envelope in the band")
    axes.set_xlabel("time (ms)")
    axes.set_ylabel("acceleration (m/s²)")
    style.legend_above(axes)
    caption = (f"{TURNS} turns of the shaft. Each ball that meets a scratch strikes the ring, which dies away at its natural frequency; a scratch "
               "that turns with the shaft strikes harder in the load zone.")
    return FigureBlock(slug, title, caption, (style.to_svg(figure, slug, "Acceleration of the outer ring over time"),))


def is_run_up(study: Report) -> bool:
    """Whether lines stand at orders of the shaft in place of frequencies."""
    return study.content.get("orders") is not None


def _mark(axes: Axes, peaks: list[dict], where: str, highest: float) -> None:
    for number, peak in enumerate(p for p in peaks if p[where] <= highest):
        if number == MOST_MARKED:
            break
        axes.plot([peak[where]], [peak["amplitude"]], color=style.VERMILION, marker="v", linestyle="")
        axes.annotate(peak["is"], (peak[where], peak["amplitude"]), textcoords="offset points", xytext=(4, 3), fontsize=7, color=style.BLACK)


def _lines(study: Report, file: PointFile, name: str, peaks: dict[bool, str], slug: str, title: str, caption: str, highest: float,
           logarithmic: bool) -> FigureBlock:
    """`highest` in Hz; `peaks` are the keys over frequency and over orders."""
    run_up = is_run_up(study)
    where, unit = ("order", "order of the shaft") if run_up else ("frequency_Hz", "frequency (Hz)")
    if run_up:
        highest /= study.content.get("shaft_Hz") or 1.0
    found = file.get("order" if run_up else "frequency", name)
    if found is None:
        return _missing(slug, title, file)
    frequency, amplitude = found
    shown = (frequency > 0) & (frequency <= highest)
    figure, axes = style.panel(WIDE)
    axes.plot(frequency[shown], amplitude[shown], color=style.BLUE, linewidth=0.8)
    marked = study.records(peaks[run_up])
    _mark(axes, marked, where, highest)
    if logarithmic and amplitude[shown].max() > 0:
        axes.set_yscale("log")
        axes.set_ylim(1e-5 * amplitude[shown].max(), 3 * amplitude[shown].max())
    axes.set_xlabel(unit)
    axes.set_ylabel("amplitude (m/s²)")
    style.thousands(axes.xaxis)
    rows = [(p[where], p["amplitude"], p["is"]) for p in marked]
    return FigureBlock(slug, title, caption, (style.to_svg(figure, slug, title),), data=Table((unit, "amplitude (m/s²)", "is"), rows))


def envelope_spectrum(study: Report, file: PointFile) -> FigureBlock:
    """Up to some passes of the balls, the strongest lines named."""
    passes = [study.content.get(key) or 0.0 for key in ("outer_pass_Hz", "inner_pass_Hz", "ball_pass_Hz", "roller_pass_Hz")]
    band = study.content.get("band_Hz") or [0.0, 0.0]
    caption = (f"Of the acceleration between {format_number(band[0], 4)} and {format_number(band[1], 4)} Hz, the band whose power comes most unevenly in "
               "time unless the case states one. The strongest lines have their names: passings of the defect, their harmonics and side bands.")
    return _lines(study, file, "envelope_spectrum", {False: "envelope_peaks", True: "orders"}, "defect-envelope", "Spectrum of the envelope", caption,
                  SHOWN_PASSES * max(passes), False)


def spectrum(study: Report, file: PointFile) -> FigureBlock:
    """Up to twice the natural frequency."""
    caption = "Lines of the passings, highest about the natural frequency of the ring that they strike."
    return _lines(study, file, "acceleration_spectrum", {False: "spectrum_peaks", True: "spectrum_orders"}, "defect-spectrum",
                  "Spectrum of the acceleration", caption, 2.0 * (study.content.get("natural_frequency_Hz") or 0.0), True)


def one_ball(study: Report, file: PointFile) -> FigureBlock:
    """Approach of the races at the first ball, and its load."""
    title, slug = "One ball", "defect-ball"
    found = file.get("time", "ball_deflection", "ball_load")
    if found is None:
        return _missing(slug, title, file)
    time, deflection, load = found
    brief = _brief(study, time)
    pictures = []
    for name, values, label in (("deflection", 1e6 * np.maximum(deflection, 0.0), "deflection of both contacts (µm)"), ("load", load, "contact load (N)")):
        figure, axes = style.panel()
        axes.plot(1e3 * time[brief], values[brief], color=style.BLUE, linewidth=0.9)
        axes.set_xlabel("time (ms)")
        axes.set_ylabel(label)
        pictures.append(style.to_svg(figure, f"{slug}-{name}", f"{label} over time"))
    caption = f"The first ball over {TURNS} turns of the shaft: it carries while it passes the load zone and is free outside it."
    return FigureBlock(slug, title, caption, tuple(pictures))
