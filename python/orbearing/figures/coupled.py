"""Gears and bearings that act on each other: what that changes, and what energy the exchange makes or loses."""

from __future__ import annotations

import numpy as np

from orbearing import style
from orbearing.blocks import FigureBlock, Table, columns_table, format_change, format_number, is_number
from orbearing.result_folder import Report, curve, record

SLUG, TITLE = "two-way", "Gears and bearings: one way against two ways"
RESIDUAL_SLUG, RESIDUAL_TITLE = "interface-energy", "Energy that the exchange makes or loses"
RESIDUAL = "interface_energy_residual"
CAPTION = (
    "One way, the gears vibrate on springs and dampers that are fitted to the bearing, and shake it; two ways, rollers, film and cage act "
    "back on the gears. {change} Points of this sweep: {how}."
)
RESIDUAL_CAPTION = (
    "Between two exchanges each side works with an estimate of the other's force or motion. What the bearings give at their ports and the "
    "gears take there then differ; shown is the sum of the differences of all windows over the energy that passed the ports."
)


def blocks(report: Report) -> list[FigureBlock]:
    """All that a two-way sweep has to show."""
    found = [_comparison(report)]
    if report.fidelity != "co-simulated":  # one system exchanges nothing
        return found
    residual = report.point_column(RESIDUAL)
    if np.any(np.isfinite(residual)):
        found.append(_residual(report, residual))
    return found


def _comparison(report: Report) -> FigureBlock:
    name = style.life_name(report.life_key)
    one_speed, one_life = curve(record(report.record("coupled").get("one_way")), "speed_rpm", report.life_key)
    speed, life = report.point_column("input_speed_rpm"), report.point_column(report.life_key)
    if not np.any(life > 0):
        return FigureBlock(SLUG, TITLE, missing=f"No point of this sweep has {style.a_life(report.life_key)}.")
    figure, axes = style.panel()
    axes.plot(one_speed, np.where(one_life > 0, one_life, np.nan), "s--", color=style.GREEN, markerfacecolor="white", label="one way")
    axes.plot(speed, np.where(life > 0, life, np.nan), "o-", color=style.BLUE, label=f"two ways ({report.fidelity})")
    style.speed_axis(axes)
    style.life_axis(axes, report.life_key)
    style.legend_above(axes, columns=2)
    rows = [(s, one, two, format_change(two, one)) for s, one, two in _pairs(one_speed, one_life, speed, life)]
    table = Table(("input speed (rpm)", f"{name}, one way (h)", f"{name}, two ways (h)", "change"), rows)
    caption = CAPTION.format(change=_change(rows, name), how=report.record("coupled").get("how") or report.fidelity)
    return FigureBlock(SLUG, TITLE, caption, (style.to_svg(figure, SLUG, "Life over speed, one way and two ways"),), summary=table)


def _pairs(one_speed, one_life, speed, life) -> list[tuple]:
    known = {round(float(s), 6): float(h) for s, h in zip(one_speed, one_life)}
    return [(float(s), known.get(round(float(s), 6)), float(h) if h > 0 else None) for s, h in zip(speed, life)]


def _change(rows: list[tuple], name: str) -> str:
    both = [(speed, two / one - 1) for speed, one, two, _ in rows if is_number(one) and is_number(two) and one > 0]
    if not both:
        return "No speed has both lives."
    speed, most = max(both, key=lambda pair: abs(pair[1]))
    sign = "longer" if most > 0 else "shorter"
    return f"The largest change of {name} is at {format_number(speed)} rpm: {format_number(100 * abs(most), 3)} % {sign} than one way."


def _residual(report: Report, residual: np.ndarray) -> FigureBlock:
    speed = report.point_column("input_speed_rpm")
    figure, axes = style.panel()
    axes.plot(speed, 100 * np.abs(residual), "o-", color=style.BLUE)
    axes.set_ylim(bottom=0)
    axes.set_ylabel("energy residual / energy passed (%)")
    style.speed_axis(axes)
    table = columns_table(("input speed (rpm)", "energy residual / energy passed"), speed, residual)
    picture = style.to_svg(figure, RESIDUAL_SLUG, "Energy residual of the ports over speed")
    return FigureBlock(RESIDUAL_SLUG, RESIDUAL_TITLE, RESIDUAL_CAPTION, (picture,), data=table)
