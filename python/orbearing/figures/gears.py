"""The gears of a set: teeth in contact, stiffness of the meshes, modes, and what the vibration does over speed."""

from __future__ import annotations

from orbearing.blocks import FigureBlock
from orbearing.figures import gear_modes, gear_teeth, gear_vibration
from orbearing.result_folder import Report

BLOCKS = (
    gear_teeth.pair_block,
    gear_teeth.stiffness_block,
    gear_modes.shape_block,
    gear_modes.campbell_block,
    gear_vibration.acceleration_block,
    gear_vibration.spectrum_block,
    gear_vibration.sharing_block,
)


def blocks(report: Report) -> list[FigureBlock]:
    """None for a result without gears: a case without teeth, or of several sets."""
    gears = report.record("gears")
    return [block(gears) for block in BLOCKS] if gears else []
