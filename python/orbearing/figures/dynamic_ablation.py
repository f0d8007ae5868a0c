"""What single effects do to life and slip in the dynamic run, at the speeds at which they were left out."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_change, format_number, is_number
from orbearing.figures.ablation import REFERENCE
from orbearing.result_folder import Report, records

SLUG, TITLE = "dynamic-ablation", "Worth of effects in motion"
LINEAR = 1.0  # [%] changes of life up to this stand on a linear scale, larger ones on a logarithmic one
GROUP = 0.8  # width of the bars of one speed over the distance between speeds
CAPTION = (
    "The dynamic run repeated with one effect left out or one law exchanged. Above: change of life against all effects; the scale is "
    "linear up to 1 % and logarithmic beyond where it has to be. Middle and below: slip of rollers and cage with each, to be held "
    "against the bar of all effects. Effects that barely move life may still decide how rollers and cage move."
)
Points = dict[float, dict]


def block(report: Report) -> FigureBlock:
    """Bars for each speed, and the numbers with power loss and load."""
    runs = {str(entry.get("name")): _points(entry) for entry in records(report.record("dynamic").get("ablation"))}
    runs = {name: points for name, points in runs.items() if points}
    if not runs or list(runs) == [REFERENCE]:
        return FigureBlock(SLUG, TITLE, missing="No dynamic run of this result leaves out an effect.")
    return FigureBlock(SLUG, TITLE, CAPTION, (_draw(runs),), summary=_table(runs))


def _points(entry: dict) -> Points:
    """Points of one run by their speed [rpm], round-off taken away."""
    return {round(point["speed_rpm"], 3): point for point in records(entry.get("points")) if is_number(point.get("speed_rpm"))}


def change_of_life(points: Points, reference: Points, speed: float) -> float:
    """In per cent, NaN where one of the two has no life."""
    life, base = points.get(speed, {}).get("life_h"), reference.get(speed, {}).get("life_h")
    return 100 * (life / base - 1) if is_number(life) and is_number(base) and base > 0 else np.nan


def _percent(points: Points, name: str, speed: float) -> float:
    value = points.get(speed, {}).get(name)
    return 100 * value if is_number(value) else np.nan


def _draw(runs: dict[str, Points]) -> str:
    figure = Figure(figsize=(5.6, 7.0))
    life, roller, cage = figure.subplots(3, 1, sharex=True)
    speeds, reference = sorted({speed for points in runs.values() for speed in points}), runs.get(REFERENCE, {})
    for index, (name, points) in enumerate(runs.items()):
        columns = ([change_of_life(points, reference, speed) if name != REFERENCE else np.nan for speed in speeds],
                   [_percent(points, "roller_slip", speed) for speed in speeds],
                   [_percent(points, "cage_slip", speed) for speed in speeds])
        for axes, column in zip((life, roller, cage), columns):
            _bars(axes, column, index, len(runs), style.legend_label(name))
    _scale_changes(life)
    for axes, label in ((life, "change of life (%)"), (roller, "roller slip (%)"), (cage, "cage slip (%)")):
        axes.axhline(0, color=style.BLACK, linewidth=0.8)
        axes.grid(False, axis="x")
        axes.set_ylabel(label)
        style.thousands(axes.yaxis)
    cage.set_xticks(range(len(speeds)), [f"{format_number(speed)} rpm" for speed in speeds])
    cage.set_xlabel("input speed")
    style.legend_above(life)
    return style.to_svg(figure, SLUG, "Change of life, roller slip and cage slip with single effects left out")


def _bars(axes: Axes, values: list[float], index: int, count: int, label: str) -> None:
    width = GROUP / count
    places = np.arange(len(values)) + (index + 0.5) * width - GROUP / 2
    axes.bar(places, np.nan_to_num(values), 0.9 * width, color=style.SERIES[index % len(style.SERIES)], label=label)


def _scale_changes(axes: Axes) -> None:
    heights = [abs(bar.get_height()) for bar in axes.patches]
    if max(heights, default=0.0) > 30 * LINEAR:
        axes.set_yscale("symlog", linthresh=LINEAR)
        low, high = axes.get_ylim()
        axes.set_ylim(max(low, -100.0), 2 * high)


def _table(runs: dict[str, Points]) -> Table:
    reference, rows = runs.get(REFERENCE, {}), []
    for speed in sorted({speed for points in runs.values() for speed in points}):
        for name, points in runs.items():
            point = points.get(speed, {})
            change = "reference" if name == REFERENCE else format_change(point.get("life_h"), reference.get(speed, {}).get("life_h"))
            rows.append((speed, name, point.get("life_h"), change, round(_percent(points, "roller_slip", speed), 3),
                         round(_percent(points, "cage_slip", speed), 3), point.get("power_loss_W"), point.get("outer_load_rms_N")))
    head = ("input speed (rpm)", "what is computed", "life (h)", "against all effects", "roller slip (%)", "cage slip (%)",
            "power loss (W)", "rms load, outer race (N)")
    return Table(head, rows)
