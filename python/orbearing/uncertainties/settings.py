"""What is asked for beside the case."""

from __future__ import annotations

import math
from dataclasses import dataclass

from orbearing.errors import MOST_THREADS, CaseError, require_whole
from orbearing.uncertainties.design import METHODS


@dataclass(frozen=True)
class Settings:
    """Sizes of the study; the same ones give the same numbers to the last bit, whatever `jobs`."""

    samples: int = 10000  # lives at the operating point
    curves: int = 1000  # whole curves of life over speed
    index_samples: int = 1000  # rows of the design behind the indices at the operating point, each (inputs + 2) lives
    seed: int = 1
    method: str = "sobol"  # monte-carlo, lhs or sobol
    speeds_rpm: tuple[float, ...] | None = None  # None: those that the case sweeps
    life: str | None = None  # column; None: the governing life (life.method)
    motion: int = 0  # samples that are computed in motion too
    jobs: int = 0  # threads; 0: one for each core

    def __post_init__(self):
        for name, least in (("samples", 2), ("curves", 2), ("index_samples", 2), ("seed", 0), ("motion", 0), ("jobs", 0)):
            require_whole(name, getattr(self, name), least, MOST_THREADS if name == "jobs" else 10**8)
        if self.method not in METHODS:
            raise CaseError(f"method: {self.method!r} found; one of {', '.join(METHODS)} is required")
        if self.speeds_rpm is not None:
            speeds = tuple(float(speed) for speed in self.speeds_rpm)
            if not speeds or sorted(set(speeds)) != list(speeds) or not speeds[0] > 0.0 or not math.isfinite(speeds[-1]):
                raise CaseError(f"speeds: {list(speeds)} found; speeds above 0 rpm, each once and rising, are required")
            object.__setattr__(self, "speeds_rpm", speeds)
