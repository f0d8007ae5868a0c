"""What single effects do to life and slip in the dynamic run, at the speeds at which they were left out."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_change, format_number, is_number
from orbearing.figures.ablation import REFERENCE, life_key_of
from orbearing.result_folder import Report, records, slip_of_set

SLUG, TITLE = "dynamic-ablation", "Effect of single terms in motion"
LINEAR = 1.0  # [%] changes of life up to this stand on a linear scale, larger ones on a logarithmic one
SPREAD = 0.8  # of the bars of one effect over the distance between effects
ROW, LEGEND = 0.42, 0.3  # [inch] of each effect, of the legend above all panels
CAPTION = (
    "The dynamic run repeated with one effect left out or added, or one law exchanged. Left: change of life against all effects. Middle "
    "and right: slip of rollers and cage with each, to be held against the bars of all effects. Scales are linear up to 1 % and "
    "logarithmic beyond where they have to be. Effects that barely move life may still decide how rollers and cage move. "
    "orbearing report --every-effect adds those that are left out here."
)
Points = dict[float, dict]


def block(report: Report) -> FigureBlock:
    """Bars for each effect and speed, and the numbers with power loss and load."""
    entries = records(report.record("dynamic").get("ablation"))
    life_key = next(map(life_key_of, entries), report.life_key)
    runs = {str(entry.get("name")): _points(entry) for entry in entries}
    runs = {name: points for name, points in runs.items() if points}
    if not runs or list(runs) == [REFERENCE]:
        return FigureBlock(SLUG, TITLE, missing="No dynamic run of this result leaves out an effect.")
    return FigureBlock(SLUG, TITLE, CAPTION, (_draw(runs, life_key),), summary=_table(runs, life_key))


def _points(entry: dict) -> Points:
    """Points of one run by their speed [rpm], round-off taken away."""
    return {round(point["speed_rpm"], 3): point for point in records(entry.get("points")) if is_number(point.get("speed_rpm"))}


def change_of_life(points: Points, reference: Points, speed: float, life_key: str) -> float:
    """In per cent, NaN where one of the two has no life."""
    life, base = points.get(speed, {}).get(life_key), reference.get(speed, {}).get(life_key)
    return 100 * (life / base - 1) if is_number(life) and is_number(base) and base > 0 else np.nan


def _percent(points: Points, name: str, speed: float) -> float:
    value = points.get(speed, {}).get(name)
    return 100 * value if is_number(value) else np.nan


def _draw(runs: dict[str, Points], life_key: str) -> str:
    figure = Figure(figsize=(7.6, 1.7 + ROW * len(runs)))
    panels = figure.subplots(1, 3, sharey=True)
    of_set, whose = slip_of_set([point for points in runs.values() for point in points.values()])
    speeds, reference = sorted({speed for points in runs.values() for speed in points}), runs.get(REFERENCE, {})
    for index, speed in enumerate(speeds):
        places = np.arange(len(runs)) + SPREAD * ((index + 0.5) / len(speeds) - 0.5)
        columns = ([change_of_life(points, reference, speed, life_key) if name != REFERENCE else np.nan for name, points in runs.items()],
                   [_percent(points, "roller_slip", speed) for points in runs.values()],
                   [_percent(points, of_set, speed) for points in runs.values()])
        for axes, column in zip(panels, columns):
            axes.barh(places, np.nan_to_num(column), 0.9 * SPREAD / len(speeds), color=style.SERIES[(index + 1) % len(style.SERIES)],
                      label=f"{format_number(speed)} rpm")
    for axes, label in zip(panels, (f"change of {style.life_name(life_key)} (%)", "roller slip (%)", f"{whose} slip (%)")):
        _scale(axes)
        axes.axvline(0, color=style.BLACK, linewidth=0.8)
        axes.grid(False, axis="y")
        axes.set_xlabel(label)
        style.thousands(axes.xaxis)
    panels[0].set_yticks(range(len(runs)), [style.legend_label(name) for name in runs])
    panels[0].set_ylim(len(runs) - 0.5, -0.5)
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - LEGEND / figure.get_figheight()))
    figure.legend(*panels[0].get_legend_handles_labels(), loc="upper center", ncol=len(speeds)).set_in_layout(False)
    return style.to_svg(figure, SLUG, f"Change of life, roller slip and {whose} slip with single effects left out")


def _scale(axes: Axes) -> None:
    """Logarithmic beyond LINEAR where effects of very unlike size meet, with few labels so that they stay apart."""
    widths = [bar.get_width() for bar in axes.patches]
    low, high = min(widths, default=0.0), max(widths, default=0.0)
    if max(-low, high) <= 30 * LINEAR:
        return
    axes.set_xscale("symlog", linthresh=LINEAR)
    axes.set_xlim(min(2 * low, -LINEAR), max(2 * high, LINEAR))
    decades = [10.0**k for k in ((2, 5, 8) if max(-low, high) > 100 else (1,))]
    ticks = [0.0, *decades, *(-decade for decade in decades)]
    axes.set_xticks([tick for tick in ticks if 2 * low <= tick <= 2 * high or tick == 0], minor=False)
    axes.minorticks_off()


def _table(runs: dict[str, Points], life_key: str) -> Table:
    reference, rows = runs.get(REFERENCE, {}), []
    of_set, whose = slip_of_set([point for points in runs.values() for point in points.values()])
    for speed in sorted({speed for points in runs.values() for speed in points}):
        for name, points in runs.items():
            point = points.get(speed, {})
            change = "reference" if name == REFERENCE else format_change(point.get(life_key), reference.get(speed, {}).get(life_key))
            rows.append((speed, name, point.get(life_key), change, round(_percent(points, "roller_slip", speed), 3),
                         round(_percent(points, of_set, speed), 3), point.get("power_loss_W"), point.get("inner_load_rms_N"),
                         point.get("outer_load_rms_N")))
    head = ("input speed (rpm)", "what is computed", f"{style.life_name(life_key)} (h)", "against all effects", "roller slip (%)", f"{whose} slip (%)",
            "power loss (W)", "rms load, inner race (N)", "rms load, outer race (N)")
    return Table(head, rows)
