"""Polynomial chaos: a result as a sum of polynomials of its inputs that are orthogonal under their distributions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orbearing.uncertainties.indices import SobolIndices, interval, no_variance
from orbearing.uncertainties.parts import openturns

MOST_TRAINING = 1000  # results from which an expansion is made
RESULTS_PER_TERM = 5  # at least
MOST_TERMS = 150
HYPERBOLIC = 0.6  # q of the norm that orders the terms: few inputs act on one another at a time
BOOTSTRAP = 100


@dataclass(frozen=True)
class ChaosExpansion:
    """Mean and spread of a result by its expansion; predictivity: 1 - (mean square error at a result that is left out) / variance."""

    mean: float
    standard_deviation: float
    predictivity: float
    terms: int
    training: int
    indices: SobolIndices

    def record(self) -> dict:
        return {"mean": self.mean, "standard_deviation": self.standard_deviation, "predictivity": self.predictivity,
                "terms": self.terms, "training_samples": self.training}


def expansion(standard: np.ndarray, marginals: list, results: np.ndarray, groups, names, seed: int) -> ChaosExpansion:
    """From results at samples of independent variables with these distributions (`UncertainInputs.standard`).

    Of nested bases, terms ordered by a hyperbolic norm of their degrees, the one whose results are best foretold when they
    are left out; least squares. Mean and variance are the first coefficient and the sum of squares of the others; those of
    the terms in which a group's inputs stand, alone or at all, make its first and total index [Sudret2008].
    """
    good = np.flatnonzero(np.isfinite(results))[:MOST_TRAINING]
    standard, results = standard[good], results[good]
    training = len(results)
    if training < 2 * RESULTS_PER_TERM or np.ptp(results) == 0.0:
        mean = float(results.mean()) if training else np.nan
        return ChaosExpansion(mean, 0.0, np.nan, 1, training, no_variance(names, training, "chaos"))
    place, scale = float(results.mean()), float(results.std())
    scaled = (results - place) / scale
    terms, degrees = _terms(standard, marginals, min(MOST_TERMS, training // RESULTS_PER_TERM))
    kept, left_out = _best_size(terms, scaled)
    terms, degrees = terms[:, :kept], degrees[:kept]
    coefficients = np.linalg.lstsq(terms, scaled, rcond=None)[0]
    first, total, variance = _shares(coefficients, degrees, groups)
    generator = np.random.Generator(np.random.PCG64(seed))
    resampled = [_shares(_resampled(generator, terms, scaled), degrees, groups)[:2] for _ in range(BOOTSTRAP)]
    edges = [interval(np.array(one)) for one in zip(*resampled)]
    indices = SobolIndices(names, first, edges[0], total, edges[1], scale**2 * variance, "chaos", training)
    return ChaosExpansion(place + scale * float(coefficients[0]), scale * float(np.sqrt(variance)), 1.0 - left_out, kept,
                          training, indices)


def _terms(standard: np.ndarray, marginals: list, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Orthonormal products of polynomials at the samples (samples, terms) and their degrees (terms, inputs)."""
    ot = openturns()
    order = ot.HyperbolicAnisotropicEnumerateFunction(len(marginals), HYPERBOLIC)
    degrees = np.array([list(order(i)) for i in range(count)])
    single = [_polynomials(ot.StandardDistributionPolynomialFactory(marginal), standard[:, i], degrees[:, i].max())
              for i, marginal in enumerate(marginals)]
    values = np.ones((len(standard), count))
    for column, polynomials in enumerate(single):
        values *= polynomials[degrees[:, column]].T
    return values, degrees


def _polynomials(family, at: np.ndarray, degree: int) -> np.ndarray:
    """Orthonormal polynomials up to that degree (degree + 1, samples), each from the two before it."""
    values = [np.zeros_like(at), np.ones_like(at)]
    for n in range(degree):
        slope, shift, before = family.getRecurrenceCoefficients(n)
        values.append((slope * at + shift) * values[-1] + before * values[-2])
    return np.array(values[1:])


def _best_size(terms: np.ndarray, results: np.ndarray) -> tuple[int, float]:
    """How many of the first terms foretell best, and the mean square error at results that are left out [of their variance]:
    with the hat matrix H of least squares, (r_j / (1 - H_jj))^2 on average."""
    basis = np.linalg.qr(terms)[0]
    residual = results[:, None] - np.cumsum(basis * (basis.T @ results), axis=1)
    leverage = np.minimum(np.cumsum(basis**2, axis=1), 1.0 - 1e-12)
    error = np.mean((residual / (1.0 - leverage)) ** 2, axis=0) / np.var(results)
    best = int(np.argmin(error))
    return best + 1, float(error[best])


def _resampled(generator, terms: np.ndarray, results: np.ndarray) -> np.ndarray:
    """Coefficients from as many results drawn with repetition."""
    root = np.sqrt(generator.multinomial(len(results), np.full(len(results), 1.0 / len(results))))
    weighted = root[:, None] * terms
    square, right = weighted.T @ weighted, weighted.T @ (root * results)
    try:
        return np.linalg.solve(square, right)
    except np.linalg.LinAlgError:  # too few different results
        return np.linalg.lstsq(square, right, rcond=None)[0]


def _shares(coefficients: np.ndarray, degrees: np.ndarray, groups) -> tuple[np.ndarray, np.ndarray, float]:
    """First and total indices of groups, and the variance, by the squares of the coefficients."""
    squares = coefficients**2
    touched = np.array([degrees[:, list(group)].any(axis=1) for group in groups])  # (groups, terms)
    variance = float(squares[touched.any(axis=0)].sum())
    if variance == 0.0:
        return np.zeros(len(groups)), np.zeros(len(groups)), 0.0
    alone = touched & (touched.sum(axis=0) == 1)
    return (alone * squares).sum(axis=1) / variance, (touched * squares).sum(axis=1) / variance, variance
