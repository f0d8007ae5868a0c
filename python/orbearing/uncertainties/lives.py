"""Lives of samples: many operating points in one call, and the top of each sample's own curve over speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Mapping, Sequence

import numpy as np

SPEED = "input.speed"
RPM = 2.0 * np.pi / 60.0  # [rad/s]
PEAK_RESOLUTION = 2.0  # [rpm]  as of a quasi-static sweep; at low speeds
PEAK_SHARE = 1e-3  # of the speed
MOST_ROUNDS = 60  # of a search that halves at worst

# (paths, values [SI] (points, paths), fidelity) -> numbers by column (points), status by point
Evaluate = Callable[[Sequence[str], np.ndarray, str], "tuple[dict[str, np.ndarray], list[str]]"]


@dataclass(frozen=True)
class Peaks:
    """The longest life of each sample and where it is: a computed point whose neighbours on both sides are shorter and near."""

    speed_rpm: np.ndarray
    life_h: np.ndarray
    at_end: np.ndarray  # life still grows at an end of the speeds
    points: int  # operating points that were computed beyond the curves


def of_worst_bearing(life: str, known: Sequence[str]) -> str:
    """The column of that life of the bearing by which a requirement is judged: over a revolution of the carrier where that is
    computed, else of the bearing with the shortest life where bearings carry unlike loads."""
    return next((name for name in (f"carrier_{life}", f"shortest_{life}") if name in known), life)


def lives_of_worst_bearing(life: str, columns: Mapping[str, np.ndarray]) -> np.ndarray:
    """The same point by point [h]: of several sets the limiting one may be another at each, with bearings that carry alike."""
    lives = np.asarray(columns[life], dtype=float)
    for name in (f"shortest_{life}", f"carrier_{life}"):
        own = np.asarray(columns.get(name, np.nan), dtype=float)
        lives = np.where(np.isfinite(own), own, lives)
    return lives


def refined_peaks(speeds_rpm: np.ndarray, lives: np.ndarray, lives_at: Callable[[np.ndarray, np.ndarray], np.ndarray]) -> Peaks:
    """From curves `lives` (samples, speeds); `lives_at(samples, speeds_rpm)` computes a point of each of some samples.

    Each round adds a point to each curve whose best point has a neighbour further away than 2 rpm (a thousandth of the speed
    below 2000 rpm): at the top of the parabola of ln(life) through the best and its neighbours, or beside the best where that
    is known already. Curves are taken to have one top between grid points; what is returned was computed.
    """
    count = len(lives)
    known = np.where(np.isfinite(lives), lives, -np.inf)
    best = known.argmax(axis=1)
    alive = np.isfinite(lives).all(axis=1)
    at_end = alive & ((best == 0) | (best == len(speeds_rpm) - 1))
    inside = np.clip(best, 1, max(len(speeds_rpm) - 2, 1)) if len(speeds_rpm) > 2 else None
    rows = np.arange(count)
    top, height = speeds_rpm[best].astype(float), np.where(alive, known[rows, best], np.nan)
    active = alive & ~at_end
    if inside is None or not active.any():
        return Peaks(np.where(alive, top, np.nan), height, at_end, 0)
    speed = np.stack([speeds_rpm[inside - 1], speeds_rpm[inside], speeds_rpm[inside + 1]], axis=1).astype(float)
    life = np.stack([known[rows, inside - 1], known[rows, inside], known[rows, inside + 1]], axis=1)
    computed = 0
    for _ in range(MOST_ROUNDS):
        wanted = np.flatnonzero(active & (_widest(speed) > 1.0))
        if not len(wanted):
            break
        asked = _next_speed(speed[wanted], life[wanted])
        found = np.asarray(lives_at(wanted, asked), dtype=float)
        computed += len(wanted)
        failed = ~np.isfinite(found)
        active[wanted[failed]] = False
        alive[wanted[failed]] = False
        good = wanted[~failed]
        speed[good], life[good] = _narrowed(speed[good], life[good], asked[~failed], found[~failed])
    top, height = np.where(at_end, top, speed[:, 1]), np.where(at_end, height, life[:, 1])
    return Peaks(np.where(alive, top, np.nan), np.where(alive, height, np.nan), at_end & alive, computed)


def _resolution(speed: np.ndarray) -> np.ndarray:
    return np.minimum(PEAK_RESOLUTION, PEAK_SHARE * speed)


def _widest(speed: np.ndarray) -> np.ndarray:
    """The wider gap beside the best point, in resolutions."""
    return np.diff(speed, axis=1).max(axis=1) / _resolution(speed[:, 1])


def _next_speed(speed: np.ndarray, life: np.ndarray) -> np.ndarray:
    low, middle, high = speed.T
    left, right = low - middle, high - middle
    with np.errstate(divide="ignore", invalid="ignore"):
        fall_left, fall_right = np.log(life[:, 0] / life[:, 1]), np.log(life[:, 2] / life[:, 1])
        curvature = (fall_right / right - fall_left / left) / (right - left)
        slope = fall_left / left - curvature * left
        vertex = middle - slope / (2.0 * curvature)
    step = 0.9 * _resolution(middle)
    wider_right = high - middle > middle - low
    halved = np.where(wider_right, middle + 0.5 * (high - middle), middle - 0.5 * (middle - low))
    # A top that is known is hemmed in from the side that is still open.
    beside = np.where(wider_right, middle + step, middle - step)
    usable = np.isfinite(vertex) & (curvature < 0.0) & (vertex > low) & (vertex < high)
    asked = np.where(usable, np.where(np.abs(vertex - middle) < step, beside, vertex), halved)
    return np.where((asked > low) & (asked < high) & (asked != middle), asked, halved)


def _narrowed(speed, life, asked, found) -> tuple[np.ndarray, np.ndarray]:
    """The best of four points with its neighbours."""
    four, heights = np.column_stack([speed, asked]), np.column_stack([life, found])
    order = np.argsort(four, axis=1, kind="stable")
    four, heights = np.take_along_axis(four, order, 1), np.take_along_axis(heights, order, 1)
    best = np.clip(heights.argmax(axis=1), 1, 2)
    around = best[:, None] + np.array([-1, 0, 1])
    return np.take_along_axis(four, around, 1), np.take_along_axis(heights, around, 1)
