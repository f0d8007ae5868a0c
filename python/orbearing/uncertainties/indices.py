"""Sobol indices: which input the variance of a result comes from."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

BOOTSTRAP = 500  # resamples behind a confidence interval
CONFIDENCE = 0.95
CHUNK = 2**22  # counts of resamples held at a time


@dataclass(frozen=True)
class SobolIndices:
    """Of one result, for each group of inputs (most groups are a single one).

    first: share of the variance that goes, as expected, once the group is known; total: share that stays, as expected, while
    the group alone is not known. Intervals (groups, 2) hold the index with 95 % confidence.
    """

    names: tuple[str, ...]
    first: np.ndarray
    first_interval: np.ndarray
    total: np.ndarray
    total_interval: np.ndarray
    variance: float
    by: str  # pick-freeze or chaos
    samples: int  # results behind them

    def order(self) -> np.ndarray:
        """Groups by what measuring them is worth, the best first; equal ones as they stand."""
        return np.argsort(-self.first, kind="stable")

    def remaining_deviation(self) -> np.ndarray:
        """Standard deviation of the result that is expected once the group is known, sqrt(V (1 - S)), by group."""
        return np.sqrt(self.variance * np.clip(1.0 - self.first, 0.0, 1.0))

    def record(self) -> list[dict]:
        """A row for each group, in the order of the inputs."""
        after = self.remaining_deviation()
        return [{"inputs": name, "first": float(self.first[i]), "first_95": [float(edge) for edge in self.first_interval[i]],
                 "total": float(self.total[i]), "total_95": [float(edge) for edge in self.total_interval[i]],
                 "expected_reduction_of_variance": float(self.first[i] * self.variance),
                 "expected_standard_deviation_after": float(after[i])} for i, name in enumerate(self.names)]


def no_variance(names: tuple[str, ...], count: int, by: str) -> SobolIndices:
    """Of a result that is the same whatever the inputs."""
    zero, edges = np.zeros(len(names)), np.zeros((len(names), 2))
    return SobolIndices(names, zero, edges, zero, edges, 0.0, by, count)


def interval(resampled: np.ndarray) -> np.ndarray:
    """Edges (groups, 2) that hold the middle 95 % of resampled indices (resamples, groups)."""
    outside = 0.5 * (1.0 - CONFIDENCE)
    return np.quantile(resampled, [outside, 1.0 - outside], axis=0).T


def by_pick_freeze(results: np.ndarray, names: tuple[str, ...], seed: int) -> SobolIndices:
    """From results of the design `pick_freeze`, by correlations (Martinez): with f at A, f' at B and f_i at A with group i from B,

        S_i = c_i - (1 - c_i) corr(f', f),   c_i = corr(f', f_i),   T_i = 1 - corr(f, f_i)     (1)

    and intervals by resampling. corr(f', f) is zero but for the chance of a finite design, most of which it takes from a small S_i. A row of the design fails as a whole: with any of its results missing it is left out.
    """
    blocks = np.asarray(results, dtype=float).reshape(len(names) + 2, -1)
    blocks = blocks[:, np.isfinite(blocks).all(axis=0)]
    count = blocks.shape[1]
    if count < 3 or np.ptp(blocks[:2]) == 0.0:
        return no_variance(names, count, "pick-freeze")
    variance = float(np.var(blocks[:2], ddof=1))
    blocks = (blocks - blocks[:2].mean()) / np.sqrt(variance)
    first, total = _correlation_indices(np.ones((1, count)), blocks)
    generator = np.random.Generator(np.random.PCG64(seed))
    resampled = [_correlation_indices(counts, blocks) for counts in _resamples(generator, count)]
    intervals = [interval(np.vstack(one)) for one in zip(*resampled)]
    return SobolIndices(names, first[0], intervals[0], total[0], intervals[1], variance, "pick-freeze", blocks.size)


def _resamples(generator, count: int):
    """How often each row stands in each resample, some resamples at a time."""
    at_once = max(CHUNK // count, 1)
    for begin in range(0, BOOTSTRAP, at_once):
        yield generator.multinomial(count, np.full(count, 1.0 / count), size=min(at_once, BOOTSTRAP - begin)).astype(float)


def _correlation_indices(counts: np.ndarray, blocks: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Eq. (1) (resamples, groups) with rows counted so often."""
    weights = counts / counts.sum(axis=1, keepdims=True)
    others = blocks[1:]
    mean = weights @ blocks.T
    deviation = np.sqrt(np.maximum(weights @ (blocks**2).T - mean**2, 1e-300))

    def correlation(other: int) -> np.ndarray:
        product = weights @ (blocks[other] * others).T - mean[:, [other]] * mean[:, 1:]
        return product / (deviation[:, [other]] * deviation[:, 1:])

    with_first, with_second = correlation(0), correlation(1)[:, 1:]
    by_chance = with_first[:, :1]
    return with_second - (1.0 - with_second) * by_chance, 1.0 - with_first[:, 1:]
