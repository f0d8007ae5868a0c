"""Power lost in one bearing over speed, by cause."""

from __future__ import annotations

import numpy as np

from orbearing import style
from orbearing.blocks import FigureBlock, Table, columns_table
from orbearing.result_folder import Report

SLUG, TITLE = "power-loss", "Power loss by cause"
CAUSES = {
    "power_loss_rolling_W": "rolling resistance",
    "power_loss_pockets_W": "cage pockets",
    "power_loss_drag_W": "oil drag",
    "power_loss_guidance_W": "cage guidance",
    "power_loss_neighbours_W": "between rollers",
    "power_loss_outer_traction_W": "sliding, outer race",
    "power_loss_inner_traction_W": "sliding, inner race",
    "power_loss_race_damping_W": "contact damping",
    "power_loss_support_W": "pin support",
}
COLOURS = (style.BLUE, style.ORANGE, style.SKY, style.GREEN, "#F0E442", style.VERMILION, style.PURPLE, style.GREY, style.BLACK)
LEAST_SHARE = 0.5  # [%] what never reaches this is too thin to see and is only named
ALONE = 0.03  # half-width of the strip that stands for a single point, over its speed


def block(report: Report) -> FigureBlock:
    """Watts and shares, both stacked."""
    speed = report.point_column("input_speed_rpm")
    losses = np.array([report.point_column(name) for name in CAUSES])
    there = np.isfinite(losses).any(axis=1) if len(speed) else np.zeros(len(CAUSES), dtype=bool)  # a bearing has a cage or it has none
    known = np.isfinite(speed) & np.isfinite(losses).any(axis=0) if len(speed) else np.zeros(0, dtype=bool)
    if not known.any():
        return FigureBlock(SLUG, TITLE, missing="No point of this sweep has power losses by cause.")
    order = np.argsort(speed[known], kind="stable")
    speed, losses = speed[known][order], np.maximum(np.nan_to_num(losses[:, known][:, order]), 0.0)
    total = losses.sum(axis=0)
    shares = 100 * losses / np.where(total > 0, total, 1.0)
    seen = shares.max(axis=1) >= LEAST_SHARE
    if not seen.any():
        return FigureBlock(SLUG, TITLE, missing="No point of this sweep loses power.")
    pictures = (_draw(speed, losses, seen, "power lost in one bearing (W)", "watts"),
                _draw(speed, shares, seen, "share of the loss (%)", "shares"))
    return FigureBlock(SLUG, TITLE, _caption(seen | ~there), pictures, data=_table(speed, losses, total))


def _draw(speed: np.ndarray, values: np.ndarray, seen: np.ndarray, label: str, slug: str) -> str:
    figure, axes = style.panel((4.6, 4.3))
    if len(speed) == 1:
        speed, values = speed * np.array([1 - ALONE, 1 + ALONE]), np.repeat(values, 2, axis=1)
    names = [name for name, shown in zip(CAUSES.values(), seen) if shown]
    colours = [colour for colour, shown in zip(COLOURS, seen) if shown]
    axes.stackplot(speed, values[seen], labels=names, colors=colours, edgecolor="white", linewidth=0.6)
    axes.set_xlim(speed[0], speed[-1])
    axes.set_ylim(0, 100 if slug == "shares" else None)
    style.speed_axis(axes)
    axes.set_ylabel(label)
    style.thousands(axes.yaxis)
    style.legend_above(axes)
    return style.to_svg(figure, f"{SLUG}-{slug}", f"{TITLE}: {label} over input speed, stacked")


def _caption(seen: np.ndarray) -> str:
    text = ("Mean power lost in one bearing, stacked by cause: first in watts, then as shares of the whole. The broadest "
            "band is what to improve first; a band that widens among the shares is a cause that grows faster than the rest.")
    thin = [name for name, shown in zip(CAUSES.values(), seen) if not shown]
    return text + (f" Below {LEAST_SHARE} % everywhere and so not drawn: {', '.join(thin)}." if thin else "")


def _table(speed: np.ndarray, losses: np.ndarray, total: np.ndarray) -> Table:
    return columns_table(("input speed (rpm)", *(f"{name} (W)" for name in CAUSES.values()), "sum (W)"), speed, *losses, total)
