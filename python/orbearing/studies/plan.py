"""In which portions the points of a study are handed out: by what a point was seen to take."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orbearing.studies.design import Design

LEAST_SECONDS = 1.0  # of a portion: below it the exchange with a scheduler counts
USUAL_SECONDS = 2.0
MOST_POINTS = 20_000  # of a portion: its results are some MiB
GROWTH = 256  # of portions from one to the next at most: the first points alone tell little of the pace


@dataclass(frozen=True)
class Portion:
    """Points that share all that is no number."""

    ids: np.ndarray
    settings: tuple[tuple[str, str], ...]
    values: np.ndarray  # [SI]


class Plan:
    """The missing points of a design, portion by portion. The order of portions has no effect on results."""

    def __init__(self, design: Design, missing: np.ndarray, at_first: int = 1):
        wanted = np.zeros(design.points, bool)
        wanted[missing] = True
        self._design = design
        self._groups = [(settings, ids[wanted[ids]]) for settings, ids in design.groups()]
        self._groups = [(settings, ids) for settings, ids in self._groups if len(ids)]
        self._group = self._place = 0
        self._largest = max(at_first, 1)
        self._pace = 0.0  # [s] of one point
        self.left = int(len(missing))

    def learn(self, points: int, seconds: float) -> None:
        """What a portion took where it was computed."""
        pace = max(seconds, 1e-6) / points
        # Portions of fewer points say less: their overhead is in them.
        self._pace = pace if self._pace == 0.0 or points > self._largest // 2 else 0.5 * (self._pace + pace)
        self._largest = min(max(self._largest, GROWTH * points), MOST_POINTS)

    def next(self, lanes: int) -> Portion | None:
        """The next portion of those that `lanes` lanes share; towards the end portions become shorter, so that all lanes end together."""
        if self.left == 0:
            return None
        settings, ids = self._groups[self._group]
        ids = ids[self._place:self._place + self._size(lanes)]
        self._place += len(ids)
        self.left -= len(ids)
        if self._place == len(self._groups[self._group][1]):
            self._group, self._place = self._group + 1, 0
        return Portion(ids, settings, self._design.values(ids))

    def _size(self, lanes: int) -> int:
        if self._pace == 0.0:
            return self._largest
        seconds = min(USUAL_SECONDS, max(LEAST_SECONDS, 0.5 * self.left * self._pace / max(lanes, 1)))
        return max(1, min(self._largest, round(seconds / self._pace)))
