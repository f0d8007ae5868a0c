"""How the gears vibrate over speed: accelerations of the planets, spectrum of a bearing's load, sharing of the load."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from orbearing import style
from orbearing.blocks import FigureBlock, Table, columns_table, format_number, is_number
from orbearing.figures.gear_modes import ORDERS, excited_meetings, kind_of
from orbearing.result_folder import curve, numbers, record, records

ACCELERATION_SLUG, ACCELERATION_TITLE = "gear-acceleration", "Gears: acceleration of the planets"
SPECTRUM_SLUG, SPECTRUM_TITLE = "gear-spectrum", "Gears: spectrum of the tangential bearing load"
SHARING_SLUG, SHARING_TITLE = "gear-sharing", "Gears: sharing of the load"
PARTS = (("x", "rms"), ("x", "max"), ("y", "rms"), ("y", "max"))
LEAST_AMPLITUDE = 1e-6  # of the largest line: below it is round-off


def _runs(gears: dict) -> list[dict]:
    """Runs with a result, by rising speed."""
    whole = [run for run in records(gears.get("runs")) if is_number(run.get("speed_rpm")) and record(run.get("acceleration_m_per_s2"))]
    return sorted(whole, key=lambda run: run["speed_rpm"])


def _acceleration(run: dict, way: str, measure: str) -> float:
    value = record(record(run["acceleration_m_per_s2"]).get(way)).get(measure)
    return value if is_number(value) else np.nan


def _failed(gears: dict) -> str:
    failed = [run for run in records(gears.get("runs")) if run.get("status") != "ok" and is_number(run.get("speed_rpm"))]
    speeds = ", ".join(f"{format_number(run['speed_rpm'])} rpm ({run.get('status') or 'no reason given'})" for run in failed)
    return f" Not steady or not finished: {speeds}." if failed else ""


def acceleration_block(gears: dict) -> FigureBlock:
    """Root mean square and largest value over speed; above them where a mesh harmonic meets a mode."""
    runs, meetings = _runs(gears), joined(excited_meetings(gears))
    if not runs:
        return FigureBlock(ACCELERATION_SLUG, ACCELERATION_TITLE, missing="No run of the gears in time has a result." + _failed(gears))
    columns = [[_acceleration(run, *part) for run in runs] for part in PARTS]
    caption = ("Acceleration of the planets in the frame of the carrier, x outward and y along carrier rotation, of all planets together: root "
               "mean square, and the largest value of any. The gears alone run in time at each speed of the sweep (markers) and at speeds "
               "between. Ticks above: a harmonic of the mesh frequency meets a mode that it can excite (R rotational, T translational, P "
               "planet, as among the mode shapes); a pair that has split has one name and a bar from the one to the other. A resonance may be "
               "narrower than the steps of speed." + _failed(gears))
    rows = [(m["order"], m["mode"], m["speed_rpm"], m["frequency_Hz"]) for m in meetings]
    table = Table(("mesh harmonic", "mode", "input speed (rpm)", "frequency (Hz)"), rows) if rows else None
    head = ("input speed (rpm)", *(f"{way}, {measure} (m/s²)" for way, measure in PARTS))
    data = columns_table(head, [run["speed_rpm"] for run in runs], *columns)
    return FigureBlock(ACCELERATION_SLUG, ACCELERATION_TITLE, caption, (_draw_acceleration(runs, columns, meetings),), summary=table, data=data)


def joined(meetings: list[dict]) -> list[dict]:
    """One entry for each harmonic and name: of a split pair the mean, with its ends."""
    groups: dict[tuple, list[dict]] = {}
    for meeting in meetings:
        groups.setdefault((meeting["order"], str(meeting.get("mode"))), []).append(meeting)
    rows = []
    for (order, mode), members in groups.items():
        speeds = [m["speed_rpm"] for m in members]
        rows.append({"order": order, "mode": mode, "speed_rpm": float(np.mean(speeds)), "low": min(speeds), "high": max(speeds),
                     "frequency_Hz": float(np.mean([m["frequency_Hz"] for m in members]))})
    return sorted(rows, key=lambda row: (row["order"], row["speed_rpm"]))


def _draw_acceleration(runs: list[dict], columns: list[list[float]], meetings: list[dict]) -> str:
    figure = Figure(figsize=(7.2, 6.4))
    names, upper, lower = figure.subplots(3, 1, sharex=True, height_ratios=(0.65, 1, 1))
    speed = np.array([run["speed_rpm"] for run in runs])
    swept = np.array([run.get("swept") is True for run in runs])
    for axes, way, (first, second) in ((upper, "x", columns[:2]), (lower, "y", columns[2:])):
        for values, colour, dash, marker, measure in ((first, style.BLUE, "-", "o", "rms"), (second, style.VERMILION, "--", "s", "largest")):
            values = np.array(values)
            axes.plot(speed, values, color=colour, linestyle=dash, linewidth=1.3, label=measure)
            axes.plot(speed[swept], values[swept], marker, color=colour, markerfacecolor="white", markersize=4)
        for meeting in meetings:
            axes.axvline(meeting["speed_rpm"], color=kind_of(meeting["mode"])[1], linewidth=0.8, alpha=0.45, zorder=0)
        axes.set_ylim(bottom=0)
        axes.set_ylabel(f"acceleration {way} (m/s²)")
        style.thousands(axes.yaxis)
    _draw_meetings(names, meetings)
    names.legend(*upper.get_legend_handles_labels(), loc="lower left", bbox_to_anchor=(0, 1.02), borderaxespad=0, ncol=2)
    style.speed_axis(lower)
    return style.to_svg(figure, ACCELERATION_SLUG, "Planet accelerations over speed, with speeds at which mesh harmonics meet modes")


def _draw_meetings(axes: Axes, meetings: list[dict]) -> None:
    """A line of names for each harmonic."""
    for meeting in meetings:
        colour = kind_of(meeting["mode"])[1]
        axes.plot([meeting["low"], meeting["high"]], [meeting["order"]] * 2, color=colour, linewidth=3, solid_capstyle="butt")
        axes.plot(meeting["speed_rpm"], meeting["order"], "|", color=colour, markersize=9)
        axes.annotate(meeting["mode"], (meeting["speed_rpm"], meeting["order"]), xytext=(0, 6), textcoords="offset points", ha="center",
                      va="bottom", fontsize=8, color=colour)
    axes.set_ylim(0.6, ORDERS[-1] + 0.9)
    axes.set_yticks(ORDERS, [f"{order} ×" for order in ORDERS])
    axes.set_ylabel("mesh harmonic")
    axes.grid(False)
    axes.tick_params(bottom=False)


def spectrum_block(gears: dict) -> FigureBlock:
    """Amplitudes over frequency at the middle speed."""
    content = record(gears.get("spectrum"))
    order, amplitude = curve(content, "order", "amplitude_N")
    mesh, speed = content.get("mesh_frequency_Hz"), content.get("speed_rpm")
    if not (is_number(mesh) and mesh > 0 and is_number(speed) and (amplitude > 0).any()):
        reason = str(content.get("status") or "no run")
        return FigureBlock(SPECTRUM_SLUG, SPECTRUM_TITLE, missing=f"The gears gave no spectrum at the middle speed: {reason}.")
    caption = (f"Amplitudes of the tangential load on all bearings of the first planet at {format_number(speed)} rpm, the middle speed of the "
               f"sweep; its mean is {format_number(content.get('mean_N'), 4)} N. Marks above: orders of the mesh frequency, "
               f"{format_number(mesh, 4)} Hz. Lines between them would tell of motion that does not repeat with the mesh.")
    whole = np.isclose(order, np.round(order))
    rows = list(zip(order[whole], order[whole] * mesh, amplitude[whole]))
    table = Table(("mesh order", "frequency (Hz)", "amplitude (N)"), rows)
    return FigureBlock(SPECTRUM_SLUG, SPECTRUM_TITLE, caption, (_draw_spectrum(order, amplitude, mesh),), summary=table)


def _draw_spectrum(order: np.ndarray, amplitude: np.ndarray, mesh: float) -> str:
    figure, axes = style.panel((6.4, 3.9))
    largest = np.nanmax(amplitude)
    floor = max(LEAST_AMPLITUDE * largest, np.nanmin(amplitude[amplitude > 0]) / 2)
    axes.vlines(order * mesh / 1e3, floor, np.fmax(amplitude, floor), color=style.BLUE, linewidth=1.4)
    axes.set_yscale("log")
    axes.set_ylim(floor, 8 * largest)
    for number in sorted({int(n) for n in np.round(order) if n >= 1}):
        axes.axvline(number * mesh / 1e3, color=style.GREY, linewidth=0.6, linestyle=":", zorder=0)
        axes.text(number * mesh / 1e3, 3.2 * largest, f"{number} ×", ha="center", va="center", fontsize=8.5,
                  bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0})
    axes.set_xlim(left=0)
    axes.set_xlabel("frequency (kHz)")
    axes.set_ylabel("amplitude (N)")
    style.thousands(axes.yaxis)
    return style.to_svg(figure, SPECTRUM_SLUG, "Spectrum of the tangential bearing load with mesh orders")


def sharing_block(gears: dict) -> FigureBlock:
    """Mean and largest share of each planet over speed."""
    runs = _runs(gears)
    mean, most = ([numbers(record(run.get("load_sharing")).get(name)) for run in runs] for name in ("mean", "largest"))
    planets = min((len(values) for values in (*mean, *most)), default=0)
    if not planets:
        return FigureBlock(SHARING_SLUG, SHARING_TITLE, missing="No run of the gears in time has a result." + _failed(gears))
    speed = np.array([run["speed_rpm"] for run in runs])
    shares = [np.array([values[:planets] for values in side]) for side in (mean, most)]
    caption = ("Tangential load on the bearings of each planet over the mean of all planets. Left: its mean in time, 1 where all planets "
               "share equally. Right: its largest value in time over the same mean, what vibration adds. Lines of planets that carry the same "
               "lie on each other." + _failed(gears))
    head = ("input speed (rpm)", *(f"planet {n + 1}, {side}" for side in ("mean", "largest") for n in range(planets)))
    data = Table(head, [(s, *a, *b) for s, a, b in zip(speed, *shares)])
    return FigureBlock(SHARING_SLUG, SHARING_TITLE, caption, (_draw_sharing(speed, shares, planets),), data=data)


def _draw_sharing(speed: np.ndarray, shares: list[np.ndarray], planets: int) -> str:
    figure = Figure(figsize=(8.4, 3.6))
    for axes, values, label in zip(figure.subplots(1, 2), shares, ("mean share (1)", "largest share in time (1)")):
        for n in range(planets):
            axes.plot(speed, values[:, n], color=style.SERIES[n % len(style.SERIES)], linestyle=style.DASHES[n % len(style.DASHES)],
                      linewidth=1.3, label=f"planet {n + 1}", marker="o" if len(speed) == 1 else "")
        axes.axhline(1.0, color=style.GREY, linewidth=0.8, zorder=0)
        low, high = axes.get_ylim()
        axes.set_ylim(min(low, 0.9), max(high, 1.1))
        axes.xaxis.set_major_locator(MaxNLocator(5))
        style.speed_axis(axes)
        axes.set_ylabel(label)
    style.legend_above(figure.axes[0], columns=2 if planets <= 4 else 3)
    return style.to_svg(figure, SHARING_SLUG, "Mean and largest share of the tangential load of each planet over speed")
