"""Steady states that a sweep up and a sweep down in speed lead to, in one plot."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, is_number
from orbearing.result_folder import Report, lies_on, record, records, same, slip_of_set

SLUG, TITLE = "branches", "Branches: speed followed up and down"
LOADS = ("inner_load_rms_N", "outer_load_rms_N")
PANELS = (("outer_load_rms_N", "rms load (N)", 1.0), ("outer_load_max_N", "largest load (N)", 1.0))
LOOKS = {"up": (style.BLUE, "-", "^"), "down": (style.VERMILION, "--", "v"), "own start": (style.BLACK, ":", "o")}
ORDER = tuple(LOOKS)
CAPTION = (
    "Each point of a branch starts where its neighbour in speed ended: up from the lowest speed, down from the highest. Where the two "
    "part, the bearing has more than one steady state at that speed, and which one it takes depends on where it comes from. {verdict} "
    "Loads are those of the outer race; the loads that are compared are the rms loads of both races. {unsteady}"
)


def block(report: Report) -> FigureBlock:
    """One picture with every branch there is."""
    content, line = report.record("branches"), report.record("slice")
    runs = {str(run.get("name")): _points(run, line) for run in records(content.get("runs"))}
    runs = {name: runs[name] for name in ORDER if runs.get(name)}
    if not runs:
        return FigureBlock(SLUG, TITLE, missing="No point of the branches has a result.")
    drift = content.get("load_drift")
    pairs = compared(runs, drift if is_number(drift) else 0.0)
    caption = CAPTION.format(verdict=_verdict(runs, pairs, drift), unsteady=_unsteady(runs)).strip()
    return FigureBlock(SLUG, TITLE, caption, (_draw(runs, pairs),), summary=_summary(runs, pairs), data=_data(runs))


def _points(run: dict, line: dict) -> list[dict]:
    """Points with a result on the line of speeds that is shown, by rising speed."""
    whole = [p for p in records(run.get("points")) if lies_on(p, line) and is_number(p.get("input_speed_rpm"))
             and all(is_number(p.get(name)) for name in LOADS)]
    return sorted(whole, key=lambda p: p["input_speed_rpm"])


def compared(runs: dict[str, list[dict]], drift: float) -> list[tuple]:
    """For each speed of the first two branches: speed, both points, largest relative difference of an rms load, whether it
    is more than two windows of one steady state may differ by."""
    if len(runs) < 2:
        return []
    one, other = list(runs.values())[:2]
    pairs = [(p, q) for p in one for q in other if same(p["input_speed_rpm"], q["input_speed_rpm"])]
    rows = []
    for p, q in pairs:
        gap = max(abs(p[name] - q[name]) / max(abs(p[name]), abs(q[name]), 1e-300) for name in LOADS)
        rows.append((p["input_speed_rpm"], p, q, gap, gap > drift))
    return rows


def _verdict(runs: dict, pairs: list[tuple], drift: float) -> str:
    if len(runs) < 2:
        return ("Only one branch is shown: sweep into another folder with --continue the other way and draw both by "
                "orbearing report DIR --with DIR2.")
    if not pairs:
        return "The branches have no speed in common."
    apart = [pair for pair in pairs if pair[4]]
    limit = f"{100 * drift:.3g} %, the drift below which a run counts as steady" if is_number(drift) else "nothing"
    if not apart:
        largest = max(pair[3] for pair in pairs)
        return (f"At none of the {len(pairs)} speeds do the loads differ by more than {limit} (largest difference "
                f"{100 * largest:.2g} %): no coexisting states are found here.")
    speeds = ", ".join(format_number(pair[0]) for pair in apart)
    return f"Loads differ by more than {limit}, at {len(apart)} of {len(pairs)} speeds: coexisting states at {speeds} rpm."


def _unsteady(runs: dict) -> str:
    drifting = [f"{format_number(p['input_speed_rpm'])} rpm ({name})" for name, points in runs.items() for p in points if p.get("steady") == 0]
    return f"Still drifting when observed, so not yet a state: {', '.join(drifting)}." if drifting else ""


def _draw(runs: dict, pairs: list[tuple]) -> str:
    figure = Figure(figsize=(5.6, 7.0))
    slip, whose = slip_of_set([p for points in runs.values() for p in points])
    panels = (*PANELS, (slip, f"{whose} slip (%)", 100.0))
    rows = figure.subplots(len(panels), 1, sharex=True)
    for axes, (column, label, scale) in zip(rows, panels):
        for name, points in runs.items():
            colour, dash, marker = LOOKS[name]
            speed = [p["input_speed_rpm"] for p in points]
            value = [scale * p[column] if is_number(p.get(column)) else np.nan for p in points]
            axes.plot(speed, value, color=colour, linestyle=dash, marker=marker if len(speed) <= style.MOST_MARKERS else "",
                      markerfacecolor="none", markersize=7 if name == "down" else 5, label=name)
        for index, pair in enumerate(pair for pair in pairs if pair[4]):
            axes.axvline(pair[0], color=style.ORANGE, linewidth=5, alpha=0.25, zorder=0, label=None if index else "states that differ")
        axes.set_ylabel(label)
        style.thousands(axes.yaxis)
    rows[-1].axhline(0, color=style.GREY, linewidth=0.8)
    style.speed_axis(rows[-1])
    style.legend_above(rows[0], columns=4)
    return style.to_svg(figure, SLUG, f"Rms load, largest load and {whose} slip over speed, followed up and down")


def _summary(runs: dict, pairs: list[tuple]) -> Table | None:
    if not pairs:
        return None
    names = list(runs)[:2]
    column, whose = slip_of_set([p for points in runs.values() for p in points])
    rows = [(speed, p["outer_load_rms_N"], q["outer_load_rms_N"], round(100 * gap, 3), _slip(p, column), _slip(q, column),
             "two states" if apart else "one state") for speed, p, q, gap, apart in pairs]
    head = ("input speed (rpm)", *(f"rms load, outer race, {name} (N)" for name in names), "largest difference (%)",
            *(f"{whose} slip, {name} (%)" for name in names), "reading")
    return Table(head, rows)


def _slip(point: dict, column: str) -> float | None:
    value = record(point).get(column)
    return round(100 * value, 3) if is_number(value) else None


def _data(runs: dict) -> Table:
    columns = ("input_speed_rpm", "inner_load_rms_N", "outer_load_rms_N", "inner_load_max_N", "outer_load_max_N", "cage_slip", "orbit_slip", "roller_slip", "steady")
    rows = [(name, *(p.get(column) for column in columns)) for name, points in runs.items() for p in points]
    return Table(("branch", *columns), rows)
