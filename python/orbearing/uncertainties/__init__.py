"""Uncertainty: how far a life is known, what the rest is owed to, and which value to measure first.

`orbearing.uncertainty(case, samples=...)` studies the numbers that the case's block `uncertain:` names;
`python3 -m orbearing.uncertainties` is the command.
"""

from __future__ import annotations

from orbearing.uncertainties.settings import Settings


def uncertainty(case, samples: int = Settings.samples, curves: int = Settings.curves, index_samples: int = Settings.index_samples,
                seed: int = Settings.seed, method: str = Settings.method, speeds_rpm=None, life: str | None = None, motion: int = 0,
                jobs: int = 0, progress=None):
    """Spread of the lives of a case whose block `uncertain:` says what is not known for sure; an `UncertaintyResult`.

    samples: lives at the operating point; curves: whole curves of life over `speeds_rpm` (default: the speeds that the case
    sweeps), each with its own peak; index_samples: rows of the design behind the Sobol indices at the operating point, (inputs + 2)
    lives each; method: monte-carlo, lhs or sobol; life: a column of the sweep's table that holds lives (default: the governing
    life, by life.method); motion: samples that are computed in motion too; jobs: threads, 0 for one on each core;
    `progress(done)` receives how many points of a batch are done. The same settings give the same bits whatever `jobs`.

    Raises CaseError for input that is of no use, also where OpenTURNS is missing; KeyboardInterrupt when stopped.
    """
    from orbearing.uncertainties.study import of_case

    settings = Settings(samples, curves, index_samples, seed, method, None if speeds_rpm is None else tuple(speeds_rpm), life, motion, jobs)
    return of_case(getattr(case, "core", case), settings, progress)


__all__ = ["Settings", "uncertainty"]
