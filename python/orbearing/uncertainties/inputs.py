"""What is not known for sure: numbers of a case as distributions, joined by correlations of their normal scores."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from orbearing.errors import CaseError
from orbearing.uncertainties.parts import openturns


@dataclass(frozen=True)
class UncertainNumber:
    """One number of a case; sizes in SI, NaN for what its distribution does not have."""

    path: str  # "input.power"; of a list "gearset.dynamics.pin_error.tangential[0]"
    distribution: str  # normal, truncated-normal, uniform, triangular
    value: float  # the case's own
    mean: float = math.nan  # of a normal distribution before it is cut off
    standard_deviation: float = math.nan  # the same
    least: float = math.nan
    peak: float = math.nan  # likeliest of a triangle
    most: float = math.nan
    si_unit: str = "1"
    unit: str = "1"  # in which people say it
    units_per_si: float = 1.0
    given: str = ""  # as the case says it
    reason: str = ""

    @classmethod
    def of_record(cls, record: dict) -> UncertainNumber:
        """From a row of `uncertain.inputs` in what `orbearing check --json` prints."""
        number = {key: math.nan if record[key] is None else float(record[key])
                  for key in ("value", "mean", "standard_deviation", "from", "peak", "to")}
        if number["standard_deviation"] == 0.0:
            raise CaseError(f"uncertain.{record['path']}: a standard deviation of 0 found; required: one above 0, or a mean "
                            "other than 0 together with relative_standard_deviation")
        return cls(record["path"], record["distribution"], number["value"], number["mean"], number["standard_deviation"],
                   number["from"], number["peak"], number["to"], record["si_unit"], record["unit"],
                   float(record["units_per_si"]), record["given"], record["reason"])

    def _place_and_scale(self) -> tuple[float, float]:
        """x = place + scale t, so that t is of order 1 whatever the unit of x."""
        if math.isfinite(self.standard_deviation):
            return self.mean, self.standard_deviation
        return 0.5 * (self.least + self.most), 0.5 * (self.most - self.least)

    def marginal(self):
        """The distribution of t."""
        ot = openturns()
        place, scale = self._place_and_scale()
        least, peak, most = ((edge - place) / scale for edge in (self.least, self.peak, self.most))
        if self.distribution == "uniform":
            return ot.Uniform(-1.0, 1.0)
        if self.distribution == "triangular":
            return ot.Triangular(-1.0, peak, 1.0)
        if self.distribution == "normal":
            return ot.Normal()
        if math.isnan(least):
            return ot.TruncatedDistribution(ot.Normal(), most, ot.TruncatedDistribution.UPPER)
        if math.isnan(most):
            return ot.TruncatedDistribution(ot.Normal(), least, ot.TruncatedDistribution.LOWER)
        return ot.TruncatedNormal(0.0, 1.0, least, most)


def _map(values: np.ndarray, before: list, after: list) -> np.ndarray:
    """Each column from one distribution to another by equal probabilities."""
    return np.asarray(openturns().MarginalTransformationEvaluation(before, after)(values))


class UncertainInputs:
    """Distributions of all uncertain numbers together: their own, and a normal copula.

    `correlations` are Pearson's of the normal scores (the parameter of the copula), which for normal numbers are their
    own. Samples are made from points of the unit cube, which `values` turns to numbers in SI.
    """

    def __init__(self, numbers: list[UncertainNumber], correlations=None):
        count = len(numbers)
        self.numbers = tuple(numbers)
        self.correlations = np.eye(count) if correlations is None else np.array(correlations, dtype=float)
        self.paths = tuple(number.path for number in numbers)
        self._marginals = [number.marginal() for number in numbers]
        self._place, self._scale = np.array([number._place_and_scale() for number in numbers]).reshape(count, 2).T
        self._cholesky = np.linalg.cholesky(self.correlations)
        self.groups = _connected(self.correlations)

    @classmethod
    def of_record(cls, record: dict) -> UncertainInputs:
        """From `uncertain` in what `orbearing check --json` prints."""
        return cls([UncertainNumber.of_record(one) for one in record["inputs"]], record["correlations"])

    def __len__(self) -> int:
        return len(self.numbers)

    @property
    def nominal(self) -> np.ndarray:
        """The case's own values [SI]."""
        return np.array([number.value for number in self.numbers])

    @property
    def group_names(self) -> tuple[str, ...]:
        """Correlated numbers can only be distinguished together: the paths of each group, joined by ' + '."""
        return tuple(" + ".join(self.paths[i] for i in group) for group in self.groups)

    def _correlated(self) -> list[int]:
        return [i for group in self.groups if len(group) > 1 for i in group]

    def values(self, cube: np.ndarray) -> np.ndarray:
        """Numbers [SI] (samples, inputs) of points of the unit cube (samples, inputs)."""
        ot = openturns()
        uniform, normal = ot.Uniform(0.0, 1.0), ot.Normal()
        cube = np.array(cube, dtype=float)
        joined = self._correlated()
        if joined:
            scores = _map(cube, [uniform] * len(self), [normal] * len(self)) @ self._cholesky.T
            cube[:, joined] = _map(scores, [normal] * len(self), [uniform] * len(self))[:, joined]
        return self._place + self._scale * _map(cube, [uniform] * len(self), self._marginals)

    def standard(self, cube: np.ndarray) -> tuple[np.ndarray, list]:
        """Independent variables of order 1 that make the same numbers, and their distributions: each number's own where
        it is by itself, else the normal scores from which the correlated ones are mixed."""
        ot = openturns()
        joined = set(self._correlated())
        own = [ot.Normal() if i in joined else marginal for i, marginal in enumerate(self._marginals)]
        return _map(np.asarray(cube, dtype=float), [ot.Uniform(0.0, 1.0)] * len(self), own), own


def _connected(correlations: np.ndarray) -> tuple[tuple[int, ...], ...]:
    """Inputs that hang together by correlations, directly or through others; each group ascending, by its first."""
    left, groups = list(range(len(correlations))), []
    while left:
        group, fresh = set(), {left[0]}
        while fresh:
            group |= fresh
            fresh = {j for i in fresh for j in left if correlations[i, j] != 0.0} - group
        groups.append(tuple(sorted(group)))
        left = [i for i in left if i not in group]
    return tuple(groups)
