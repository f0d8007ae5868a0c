"""Scatter of the lives of single bearings at given inputs, which no measurement of an input takes away; and both together.

At given inputs the life that a share s of all bearings reaches is, by Weibull's distribution of two parameters,

    t(s) = L (ln(1/s) / ln(1/R))^(1/e)                                                    (1)

with the life L that the share R reaches (L10: R = 0.9) and the slope e, 9/8 of rollers and 10/9 of balls [LundbergPalmgren1947].
L10mh and L10mrh for another reliability hold the factor a_1 of ISO 281, whose slope is 1.5 with a least life; their L10 is L / a_1, not L by (1).
Where L itself is not known, the share that has failed at t is the mean over what L may be:

    F(t) = mean_i (1 - R^((t / L_i)^e))                                                   (2)
"""

from __future__ import annotations

import functools
import math
from typing import Mapping

import numpy as np

from orbearing.lives import WITH_RELIABILITY

ROLLER_SLOPE = 9.0 / 8.0
BALL_SLOPE = 10.0 / 9.0
L10_RELIABILITY = 0.9
HALVINGS = 200  # more than the bits of a number


def reliability_factors(life: str, columns: Mapping[str, np.ndarray]) -> np.ndarray:
    """a_1 in the lives of the column `life`: 1 where they are for 90 %, else by L10mh = a_1 a_ISO L10h of one bearing."""
    if not life.endswith(WITH_RELIABILITY):
        return np.ones(len(columns[life]))
    # Without sets the row is that of one bearing; with them L10h and L10mh of the row are the shortest of all sets.
    names = [name for name in columns if name.startswith("sets.") and name.endswith(".a_ISO")] or ["a_ISO"]
    before = [name.removesuffix("a_ISO") for name in names]
    own = [one for one in before if life.startswith(one)] or before
    found = [np.asarray(columns[one + "L10mh"], dtype=float) / (np.asarray(columns[one + "a_ISO"], dtype=float) * np.asarray(columns[one + "L10h"], dtype=float))
             for one in own]
    return functools.reduce(lambda first, other: np.where(np.isfinite(first), first, other), found)


def single_lives(life, failed, slope: float = ROLLER_SLOPE, reliability: float = L10_RELIABILITY) -> np.ndarray:
    """Lives at which the shares `failed` in (0, 1) of all bearings have failed, Eq. (1); in the unit of `life`, which the
    share `reliability` reaches."""
    failed = np.asarray(failed, dtype=float)
    return life * (np.log1p(-failed) / math.log(reliability)) ** (1.0 / slope)


def failed_share(time, lives, slope: float = ROLLER_SLOPE, reliability: float = L10_RELIABILITY) -> float:
    """Share of bearings that have failed at `time` where lives may be any of `lives`, Eq. (2)."""
    return float(np.mean(-np.expm1(math.log(reliability) * (time / np.asarray(lives)) ** slope)))


def joint_lives(lives, failed, slope: float = ROLLER_SLOPE, reliability: float = L10_RELIABILITY) -> np.ndarray:
    """Lives at which the shares `failed` have failed, inputs and bearings both uncertain: Eq. (2) solved by halving."""
    lives = np.asarray(lives, dtype=float)
    return np.array([_time_of(share, lives, slope, reliability) for share in np.atleast_1d(failed)])


def _time_of(share: float, lives: np.ndarray, slope: float, reliability: float) -> float:
    low, high = (math.log(float(single_lives(edge, share, slope, reliability))) for edge in (lives.min(), lives.max()))
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        if failed_share(math.exp(middle), lives, slope, reliability) < share:
            low = middle
        else:
            high = middle
    return math.exp(0.5 * (low + high))
