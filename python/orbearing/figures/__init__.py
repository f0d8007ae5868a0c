"""The figures of the report, in the order in which they stand on the page."""

from orbearing.figures import ablation, bearing_drawing, life_curve, planet_load, polar_loads, roller_loads

BLOCKS = (
    life_curve.block,
    planet_load.block,
    polar_loads.block,
    bearing_drawing.block,
    ablation.inertia_block,
    ablation.clearance_block,
    roller_loads.block,
)
