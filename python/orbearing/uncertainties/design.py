"""Designs: points of the unit cube, the same for the same seed."""

from __future__ import annotations

from contextlib import contextmanager

import numpy as np

from orbearing.uncertainties.parts import openturns

METHODS = ("monte-carlo", "lhs", "sobol")


@contextmanager
def seeded(seed: int):
    """OpenTURNS' generator from `seed` on; what it held before is put back."""
    generator = openturns().RandomGenerator
    before = generator.GetState()
    generator.SetSeed(seed)
    try:
        yield
    finally:
        generator.SetState(before)


def points(method: str, count: int, dimension: int, seed: int) -> np.ndarray:
    """`count` points (count, dimension) of the unit cube.

    monte-carlo: independent ones; lhs: a Latin hypercube in random order; sobol: Sobol's sequence shifted at random.
    """
    ot = openturns()
    # Its name in newer versions, or in older ones.
    joint = getattr(ot, "JointDistribution", None) or ot.ComposedDistribution
    cube = joint([ot.Uniform(0.0, 1.0)] * dimension)
    with seeded(seed):
        if method == "monte-carlo":
            experiment = ot.MonteCarloExperiment(cube, count)
        elif method == "lhs":
            experiment = ot.LHSExperiment(cube, count)
        else:
            experiment = ot.LowDiscrepancyExperiment(ot.SobolSequence(), cube, count)
            experiment.setRandomize(True)
        found = np.array(experiment.generate())
    # A shifted point may fall on a face, where a normal number has no value.
    inside = 0.5 / 2.0**53
    return np.clip(found, inside, 1.0 - inside)


def pick_freeze(method: str, count: int, groups: tuple[tuple[int, ...], ...], dimension: int, seed: int) -> np.ndarray:
    """Points (count (groups + 2), dimension) for Sobol indices: A, B, and for each group A with that group's columns from B."""
    both = points(method, count, 2 * dimension, seed)
    first, second = both[:, :dimension], both[:, dimension:]
    blocks = [first, second]
    for group in groups:
        mixed = first.copy()
        mixed[:, group] = second[:, group]
        blocks.append(mixed)
    return np.vstack(blocks)
