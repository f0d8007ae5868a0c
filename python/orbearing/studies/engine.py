"""What computes the points of a study, here or on another machine: a case as text, and the core that reads it."""

from __future__ import annotations

import functools
import time
from collections.abc import Sequence

import numpy as np

from orbearing.errors import ComputationError
from orbearing.studies.table import DONE, Chunk


class OtherProgram(ComputationError):
    """A worker has another version of the program, or another instruction set: its results are not equal to the last bit."""


@functools.lru_cache(maxsize=8)
def _core_of(text: str):
    from orbearing import _core

    return _core.parse(text, "case.resolved.yaml")


@functools.lru_cache(maxsize=64)
def _changed(text: str, settings: tuple[tuple[str, str], ...]):
    core = _core_of(text)
    return core.with_settings(list(settings)) if settings else core


def program() -> dict[str, str]:
    """Version of the program and instruction set: results are equal to the last bit within one of both only."""
    from orbearing import _core

    return {"program_version": _core.version, "instruction_set": _core.instruction_set}


class CoreEngine:
    """Points of one case by the core. It travels as the text of its case, so that no worker needs a file."""

    def __init__(self, text: str, paths: Sequence[str], fidelity: str):
        self.text, self.paths, self.fidelity = text, list(paths), fidelity
        self.program = program()

    def compute(self, ids: np.ndarray, settings: tuple[tuple[str, str], ...], values: np.ndarray, jobs: int) -> Chunk:
        """The points `ids`, whose numbers are `values` [SI]. Raises OtherProgram where this process has another program."""
        from orbearing import _core

        if program() != self.program:
            raise OtherProgram(f"found {_words(program())} on a worker; required: {_words(self.program)}, as where the study began")
        begin = time.perf_counter()
        columns, rows, status = _core.evaluate(_changed(self.text, settings), self.paths, values, fidelity=self.fidelity, jobs=jobs,
                                               without_effect=True)
        statuses = {place: text for place, text in enumerate(status) if text != DONE}
        return Chunk(np.asarray(ids), tuple(columns), np.asarray(rows), statuses, time.perf_counter() - begin)


def _words(found: dict[str, str]) -> str:
    return f"version {found['program_version']}, {found['instruction_set']}"
