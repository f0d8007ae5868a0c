"""The results of a study as they come in: one row of numbers and one status for each point."""

from __future__ import annotations

import json
import zlib
from dataclasses import dataclass, field

import numpy as np

from orbearing.studies.journal import Record

DONE = "ok"
NOT_COMPUTED = "not computed"
SPEED_COLUMN = "input_speed_rpm"
CHUNK = "chunk"


@dataclass(frozen=True)
class Chunk:
    """Finished points: their numbers, one row of each, and the status of each that is not "ok", by its place here."""

    ids: np.ndarray
    columns: tuple[str, ...]
    rows: np.ndarray  # (points, columns)
    statuses: dict[int, str] = field(default_factory=dict)
    seconds: float = 0.0  # that computing took


def encode(chunk: Chunk) -> Record:
    """The journal's record of a chunk."""
    content = np.ascontiguousarray(chunk.ids, "<i8").tobytes() + np.ascontiguousarray(chunk.rows, "<f8").tobytes()
    head = {"record": CHUNK, "points": len(chunk.ids), "columns": list(chunk.columns)}
    if chunk.statuses:
        head["statuses"] = {str(place): text for place, text in chunk.statuses.items()}
    return Record(head, zlib.compress(content, 1))


def decode(record: Record) -> Chunk:
    """The inverse of `encode`."""
    count, columns = record.head["points"], tuple(record.head["columns"])
    content = zlib.decompress(record.payload)
    ids = np.frombuffer(content, "<i8", count)
    rows = np.frombuffer(content, "<f8", offset=ids.nbytes).reshape(count, len(columns))
    return Chunk(ids, columns, rows, {int(place): text for place, text in record.head.get("statuses", {}).items()})


class ResultTable:
    """All points of a study, those that are missing with NaN and a status that says so."""

    def __init__(self, points: int):
        self.columns: tuple[str, ...] = ()
        self.finished = np.zeros(points, bool)
        self.rows = np.empty((points, 0))
        self.status = np.full(points, NOT_COMPUTED, object)

    def add(self, chunk: Chunk) -> Chunk | None:
        """Takes the points that are not there yet and returns these; None where there are none. Raises ValueError for other columns."""
        if not self.columns:
            self.columns = tuple(chunk.columns)
            self.rows = np.full((len(self.finished), len(self.columns)), np.nan)
        if tuple(chunk.columns) != self.columns:
            raise ValueError(f"results with the columns {json.dumps(chunk.columns)} among others with {json.dumps(self.columns)}")
        new = ~self.finished[chunk.ids]
        if not new.all():
            places = np.flatnonzero(new)
            chunk = Chunk(chunk.ids[places], chunk.columns, chunk.rows[places],
                          {place: chunk.statuses[int(old)] for place, old in enumerate(places) if int(old) in chunk.statuses}, chunk.seconds)
        if not len(chunk.ids):
            return None
        self.finished[chunk.ids] = True
        self.rows[chunk.ids] = chunk.rows
        self.status[chunk.ids] = DONE
        for place, text in chunk.statuses.items():
            self.status[chunk.ids[place]] = text
        return chunk

    def missing(self) -> np.ndarray:
        return np.flatnonzero(~self.finished)

    def column(self, name: str) -> np.ndarray:
        """One column over all points, NaN where there is none."""
        return self.rows[:, self.columns.index(name)] if name in self.columns else np.full(len(self.finished), np.nan)

    @property
    def failed(self) -> int:
        """Finished points that have no result."""
        return int(np.count_nonzero(self.finished & (self.status != DONE)))
