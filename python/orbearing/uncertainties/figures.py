"""Pictures of an uncertain life."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from orbearing import style

WIDE = (5.6, 4.2)
PAIR = (7.6, 3.6)
BINS = 40


def figures(result) -> dict[str, Figure]:
    """Each figure by its name, in the look of the reports."""
    with style.context():
        return {"life_band": life_band(result), "peak": peak(result), "indices": indices(result)}


def life_name(data: dict) -> str:
    """The life that is studied, in words: "life", "L10mrh", "system L10mrh"."""
    return data["life"].replace("_h", "").replace("_", " ")


def life_band(result) -> Figure:
    """Bands of life over speed: by what is not known, and the scatter of single bearings beside."""
    figure, axes = style.panel(WIDE)
    rows = result.data["speeds"]
    speed = np.array([row["speed_rpm"] for row in rows])
    band = _percentiles(rows, "of_uncertain_inputs")
    single = _percentiles(rows, "of_single_bearings_at_the_case")
    both = _percentiles(rows, "of_both")
    axes.fill_between(speed, band["5"], band["95"], color=style.SKY, alpha=0.35, linewidth=0, label="inputs: 5 to 95 %")
    axes.fill_between(speed, band["25"], band["75"], color=style.BLUE, alpha=0.45, linewidth=0, label="inputs: 25 to 75 %")
    axes.plot(speed, band["50"], color=style.BLUE, label="inputs: median")
    axes.plot(speed, result.case_lives, color=style.BLACK, linestyle="--", label="the case as it stands")
    for edge in ("5", "95"):
        axes.plot(speed, single[edge], color=style.ORANGE, linestyle="-.", linewidth=1.1,
                  label="single bearings at the case: 5 and 95 %" if edge == "5" else None)
        axes.plot(speed, both[edge], color=style.VERMILION, linestyle=":", linewidth=1.3,
                  label="inputs and bearings: 5 and 95 %" if edge == "5" else None)
    point = result.data["operating_point"]
    moving = [row["dynamic_h"] for row in result.data["motion"] if row["dynamic_h"] is not None]
    if moving:
        axes.plot([point["speed_rpm"]] * len(moving), moving, linestyle="", marker="x", color=style.PURPLE, label="samples in motion")
    if len(speed) == 1:
        axes.set_xlim(0.9 * speed[0], 1.1 * speed[0])
    style.speed_axis(axes)
    style.life_axis(axes)
    axes.set_ylabel(f"{life_name(result.data)} (h)")
    style.legend_above(axes)
    return figure


def peak(result) -> Figure:
    """How the peak's speed and life are spread."""
    figure = Figure(figsize=PAIR)
    record = result.data["peak"]
    for i, (values, key, label, colour) in enumerate(((result.peak_speeds, "speed", "input speed of the peak (rpm)", style.BLUE),
                                                      (result.peak_lives, "life", f"{life_name(result.data)} at the peak (h)", style.GREEN))):
        axes = figure.add_subplot(1, 2, i + 1)
        values = values[np.isfinite(values)]
        if len(values):
            axes.hist(values, bins=min(BINS, max(int(np.sqrt(len(values))), 5)), color=colour, alpha=0.7)
            low, high = np.percentile(values, [5, 95])
            axes.axvline(low, color=style.GREY, linestyle=":", label="5 and 95 %")
            axes.axvline(high, color=style.GREY, linestyle=":")
        nominal = record[f"{key}_at_the_case_" + ("rpm" if key == "speed" else "h")]
        if nominal is not None:
            axes.axvline(nominal, color=style.BLACK, linestyle="--", label="the case as it stands")
        axes.set_xlabel(label)
        axes.set_ylabel("curves")
        axes.locator_params(axis="x", nbins=4)
        style.thousands(axes.xaxis)
        style.legend_above(axes, columns=1)
    return figure


def indices(result) -> Figure:
    """First and total indices of each result as bars, the input to measure first on top."""
    of = [(f"life at {result.data['operating_point']['speed_rpm']:g} rpm", result.data["operating_point"]["indices"]),
          ("speed of the peak", result.data["peak"]["speed_rpm"]["indices"]),
          ("life at the peak", result.data["peak"]["life_h"]["indices"])]
    names = [row["inputs"] for row in sorted(of[0][1], key=lambda row: row["total"])]
    figure = Figure(figsize=(7.6, 1.5 + 0.42 * len(names)))
    places = np.arange(len(names))
    shared = None
    for i, (title, rows) in enumerate(of):
        axes = figure.add_subplot(1, 3, i + 1, sharey=shared)
        shared = shared or axes
        by_name = {row["inputs"]: row for row in rows}
        for shift, key, colour, label in ((0.2, "first", style.BLUE, "first"), (-0.2, "total", style.ORANGE, "total")):
            sizes = np.array([by_name[name][key] for name in names])
            edges = np.array([by_name[name][key + "_95"] for name in names])
            bars = np.abs(np.clip(np.stack([sizes - edges[:, 0], edges[:, 1] - sizes]), 0.0, None))
            axes.barh(places + shift, sizes, height=0.36, color=colour, xerr=bars, error_kw={"linewidth": 0.9, "ecolor": style.BLACK},
                      label=label)
        axes.set_title(title)
        axes.set_xlabel("share of the variance")
        axes.set_xlim(min(0.0, axes.get_xlim()[0]), 1.05)
        axes.set_yticks(places, [_short(name) for name in names] if i == 0 else None)
        axes.grid(axis="y", visible=False)
        if i:
            axes.tick_params(labelleft=False)
    shared.legend(loc="lower right")
    return figure


def _short(name: str) -> str:
    """The end of a path, which tells inputs apart; groups on lines of their own."""
    return "\n".join(".".join(one.split(".")[-2:]) for one in name.split(" + "))


def _percentiles(rows: list[dict], band: str) -> dict[str, np.ndarray]:
    keys = rows[0][band]["percentiles"]
    return {key: np.array([np.nan if row[band]["percentiles"][key] is None else row[band]["percentiles"][key] for row in rows])
            for key in keys}
