"""The figures of the report, in the order in which they stand on the page."""

from orbearing.blocks import FigureBlock
from orbearing.figures import (
    ablation, bearing_drawing, cage_orbit, dynamic_ablation, dynamic_polar, life_curve, planet_load, polar_loads, power_loss,
    roller_history, roller_loads, roller_orbit, slip,
)
from orbearing.result_folder import Report

BLOCKS = (
    life_curve.block,
    planet_load.block,
    polar_loads.block,
    bearing_drawing.block,
    ablation.inertia_block,
    ablation.clearance_block,
    roller_loads.block,
)
DYNAMIC_BLOCKS = (
    dynamic_polar.block,
    roller_history.block,
    roller_orbit.block,
    cage_orbit.block,
    slip.block,
    power_loss.block,
    dynamic_ablation.block,
)


def blocks_of(report: Report) -> list[FigureBlock]:
    """Every figure of this result; what only motion in time can show follows at the end."""
    return [block(report) for block in (*BLOCKS, *(DYNAMIC_BLOCKS if report.is_dynamic else ()))]
