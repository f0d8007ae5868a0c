"""The figures of the report, in the order in which they stand on the page."""

from orbearing.blocks import FigureBlock
from orbearing.figures import (
    ablation, bearing_drawing, branches, cage_orbit, carrier_revolution, coupled, dynamic_ablation, dynamic_polar, gears, life_curve, load_spectrum, planet_load, polar_loads, power_loss,
    roller_history, roller_loads, roller_orbit, slip, slip_map, slip_traces,
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
    slip_traces.block,
    cage_orbit.block,
    slip.block,
    power_loss.block,
)


def blocks_of(report: Report) -> list[FigureBlock]:
    """Every figure of this result; what only motion in time can show follows at the end."""
    line = report.along_speed()
    blocks = [block(line) for block in (*BLOCKS, *(DYNAMIC_BLOCKS if report.is_dynamic else ()))]
    if report.record("carrier"):
        blocks.insert(2, carrier_revolution.block(report))
    if report.content.get("spectrum"):
        blocks.insert(1, load_spectrum.block(report))
    if report.is_dynamic and not report.is_coupled:  # effects are left out of runs one way only
        blocks.append(dynamic_ablation.block(line))
    if report.is_dynamic and report.records("axes"):
        blocks.append(slip_map.block(report))
    if report.is_coupled:
        blocks += coupled.blocks(line)
    blocks += gears.blocks(report)
    if report.record("branches"):
        blocks.append(branches.block(line))
    return blocks
