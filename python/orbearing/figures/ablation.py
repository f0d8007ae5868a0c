"""What single effects are worth: life with one of them switched off or changed, against all of them."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_change, is_number
from orbearing.result_folder import Report, curve, same

REFERENCE = "all effects"
INERTIA, CLEARANCE = "inertia", "clearance"
# Beyond this ratio between the largest and the smallest effect a linear axis hides the small one.
WIDEST_LINEAR = 30.0
SHORT = 30  # names of fewer letters stand in two columns of the legend


def inertia_block(report: Report) -> FigureBlock:
    """Inertial terms of the carrier frame switched off one by one."""
    caption = ("Quasi-static. Each curve leaves out one inertial effect; dots mark the peaks. The lower picture shows the change of life against "
               "all effects together: above zero, life is overestimated without the effect. Its scale is linear up to 1 % and "
               "logarithmic beyond wherever effects of very unlike size meet.")
    return _block(report, INERTIA, "Effect of the inertial terms", caption)


def clearance_block(report: Report) -> FigureBlock:
    """Other clearances, film, and whatever else was varied."""
    caption = ("Quasi-static. Each curve changes clearance, film or another single assumption. Clearance narrows the load zone, so fewer rollers carry "
               "the same load; clearances are in diametral measure. Dots mark the peaks.")
    return _block(report, CLEARANCE, "Effect of clearance and film", caption)


def group_of(entry: dict) -> str:
    """The group an entry names, else the one its name tells: an inertial term is a switch, "no ..."."""
    if entry.get("group") in (INERTIA, CLEARANCE):
        return entry["group"]
    name = str(entry.get("name", "")).lower()
    inertial = ("centrifugal", "coriolis", "orbit", "euler", "inertia")
    return INERTIA if any(word in name for word in inertial) else CLEARANCE


def _block(report: Report, group: str, title: str, caption: str) -> FigureBlock:
    slug = f"ablation-{group}"
    usable = [entry for entry in report.records("ablation") if _has_curve(entry)]
    reference = next((entry for entry in usable if entry.get("name") == REFERENCE), None)
    others = [entry for entry in usable if entry is not reference and group_of(entry) == group]
    if not others:
        return FigureBlock(slug, title, missing="No run of this result leaves out or changes such an effect.")
    entries = ([reference] if reference else []) + others
    return FigureBlock(slug, title, caption, (_draw(entries, reference, slug),), _summary(entries, reference), _data(entries))


def life_key_of(entry: dict) -> str:
    """The life that an entry compares, the governing one."""
    return str(entry.get("life_key") or "life_h")


def _curve(entry: dict) -> tuple[np.ndarray, np.ndarray]:
    speed, life = curve(entry, "speed_rpm", life_key_of(entry))
    known = np.isfinite(speed) & (life > 0)
    order = np.argsort(speed[known], kind="stable")
    return speed[known][order], life[known][order]


def _has_curve(entry: dict) -> bool:
    return len(_curve(entry)[0]) > 0


def change_percent(entry: dict, reference: dict) -> tuple[np.ndarray, np.ndarray]:
    """Speed [rpm] and change of life [%] against the reference, at speeds at which both were computed."""
    speed, life = _curve(entry)
    base_speed, base_life = _curve(reference)
    pairs = [(i, j) for i, one in enumerate(speed) for j in [int(np.argmin(np.abs(base_speed - one)))] if same(float(one), float(base_speed[j]))]
    at, of = (np.array([pair[side] for pair in pairs], dtype=int) for side in (0, 1))
    return speed[at], 100 * (life[at] / base_life[of] - 1)


def _draw(entries: list[dict], reference: dict | None, slug: str) -> str:
    figure = Figure(figsize=style.STACK if reference else style.PANEL)
    rows = figure.subplots(2 if reference else 1, 1, sharex=True, squeeze=False)[:, 0]
    looks = _looks(entries, reference)
    _draw_lives(rows[0], entries, looks)
    if reference:
        _draw_changes(rows[1], [(entry, look) for entry, look in zip(entries, looks) if entry is not reference], reference)
    style.speed_axis(rows[-1])
    return style.to_svg(figure, slug, "Life over speed with single effects changed, and the change in per cent")


def _looks(entries: list[dict], reference: dict | None) -> list[dict]:
    start = 0 if reference else 1
    count = len(style.SERIES)
    return [{"color": style.SERIES[(start + i) % count], "linestyle": style.DASHES[(start + i) % count]} for i in range(len(entries))]


def _draw_lives(axes: Axes, entries: list[dict], looks: list[dict]) -> None:
    for entry, look in zip(entries, looks):
        speed, life = _curve(entry)
        marker = "o" if len(speed) == 1 else ""
        axes.plot(speed, life, marker=marker, label=style.legend_label(str(entry.get("name"))), **look)
        peak_speed, peak_life = entry.get("peak_speed_rpm"), entry.get("peak_life_h")
        if is_number(peak_speed) and is_number(peak_life) and peak_life > 0:
            axes.plot([peak_speed], [peak_life], "o", color=look["color"], markersize=5, markeredgecolor="white")
    style.life_axis(axes, life_key_of(entries[0]))
    style.legend_above(axes, columns=2 if all(len(str(entry.get("name"))) < SHORT for entry in entries) else 1)


def _draw_changes(axes: Axes, pairs: list[tuple[dict, dict]], reference: dict) -> None:
    sizes = []
    for entry, look in pairs:
        speed, change = change_percent(entry, reference)
        sizes.append(np.max(np.abs(change), initial=0))
        axes.plot(speed, change, marker="o" if len(speed) == 1 else "", **look)
    axes.axhline(0, color=style.BLACK, linewidth=1)
    positive = [size for size in sizes if size > 1e-3]
    if positive and max(positive) > WIDEST_LINEAR * min(positive):
        axes.set_yscale("symlog", linthresh=1.0)
        low, high = axes.get_ylim()
        axes.set_ylim(max(low, -100.0), high)  # life cannot lose more than all of it
    style.thousands(axes.yaxis)
    axes.set_ylabel(f"change of {style.life_name(life_key_of(reference))} (%)")


def _summary(entries: list[dict], reference: dict | None) -> Table:
    base = (reference or {}).get("peak_life_h")
    rows = [(entry.get("name"), entry.get("peak_speed_rpm"), entry.get("peak_life_h"),
             "reference" if entry is reference else format_change(entry.get("peak_life_h"), base)) for entry in entries]
    return Table(("what is computed", "peak at (rpm)", f"{style.life_name(life_key_of(entries[0]))} at its peak (h)", "against all effects"), rows)


def _data(entries: list[dict]) -> Table:
    rows = [(entry.get("name"), speed, life) for entry in entries for speed, life in zip(*_curve(entry))]
    return Table(("what is computed", "input speed (rpm)", style.life_label(life_key_of(entries[0]))), rows)
