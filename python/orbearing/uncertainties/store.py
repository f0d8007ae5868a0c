"""The folder of a study of uncertainty while it is computed: who may write into it, and the lives that are kept.

    uncertainty.journal   what the lives belong to, then portions of them: only ever appended to (`orbearing.studies.journal`)

A study that is killed is gone over again: portions that stand in the journal are taken from it, the others are computed.
"""

from __future__ import annotations

import hashlib
import json
import os
import zlib
from pathlib import Path
from typing import Sequence

import numpy as np

from orbearing.errors import CaseError
from orbearing.studies import journal as journals
from orbearing.uncertainties.lives import Evaluate

FORMAT = 2
JOURNAL = "uncertainty.journal"
PORTION = 2048  # points in one record
DONE = "ok"


def header_of(case_name: str, case_hash: str, program: dict[str, str], settings: dict) -> dict:
    """What the lives belong to; what differs from it is another study. `settings` as the result states them, with speeds and life."""
    return {"orbearing_uncertainty": FORMAT, "case": case_name, "case_hash": case_hash, **program, **settings}


class Store:
    """An open folder of a study, locked against a second writer for as long as it is open."""

    def __init__(self, folder: Path, header: dict, resume: bool):
        """Raises CaseError unless the folder may be written to; nothing is changed then."""
        self.folder = folder
        _require_usable(folder, resume)
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise CaseError(f"{folder}: cannot be made: {error.strerror}; a writable path is required") from error
        self._journal = journals.Journal(folder / JOURNAL)
        try:
            self._kept = self._begin(header)
        except BaseException:
            self._journal.close()
            raise

    def _begin(self, header: dict) -> dict[str, bytes]:
        contents = journals.read(self._journal.path)
        if contents.records:
            self._require_same(contents.records[0].head, header)
        self._journal.cut(contents.sound_bytes)
        if not contents.records:
            self._journal.append(journals.Record(header, b""))
        return {record.head["of"]: record.payload for record in contents.records[1:]}

    def _require_same(self, found: dict, required: dict) -> None:
        lines = [f"{self.folder}: --resume: {key.replace('_', ' ')} '{found.get(key)}' was found; '{required.get(key)}' is required; use another folder, or the case and the options of these results" for key in dict.fromkeys((*found, *required))
                 if found.get(key) != required.get(key)]
        if lines:
            raise CaseError(lines)

    def keeping(self, evaluate: Evaluate) -> Evaluate:
        """The same, portion by portion, each kept in the journal or taken from it. Of the columns lives in hours and their factors a_ISO are kept."""

        def kept(paths: Sequence[str], values: np.ndarray, fidelity: str):
            portions = [self._portion(evaluate, paths, values[begin:begin + PORTION], fidelity) for begin in range(0, len(values), PORTION)]
            columns = {name: np.concatenate([portion[0][name] for portion in portions]) for name in portions[0][0]}
            return columns, [text for portion in portions for text in portion[1]]

        return kept

    def _portion(self, evaluate: Evaluate, paths, values: np.ndarray, fidelity: str):
        key = _key(paths, values, fidelity)
        if key not in self._kept:
            columns, status = evaluate(paths, values, fidelity)
            lives = {name: np.asarray(numbers, dtype=float) for name, numbers in columns.items() if name.endswith(("h", "a_ISO"))}
            self._kept[key] = _encoded(lives, list(status))
            self._journal.append(journals.Record({"of": key}, self._kept[key]))
        return _decoded(self._kept[key])

    def close(self) -> None:
        self._journal.close()


def _key(paths, values: np.ndarray, fidelity: str) -> str:
    sum_of = hashlib.blake2b(json.dumps([list(paths), fidelity, list(values.shape)]).encode(), digest_size=16)
    sum_of.update(np.ascontiguousarray(values, dtype=float).tobytes())
    return sum_of.hexdigest()


def _encoded(lives: dict[str, np.ndarray], status: list[str]) -> bytes:
    head = json.dumps({"columns": list(lives), "points": len(status), "status": {str(i): text for i, text in enumerate(status) if text != DONE}})
    return zlib.compress(head.encode() + journals.END + b"".join(np.ascontiguousarray(one, dtype="<f8").tobytes() for one in lives.values()))


def _decoded(payload: bytes):
    head, _, numbers = zlib.decompress(payload).partition(journals.END)
    found = json.loads(head)
    table = np.frombuffer(numbers, dtype="<f8").reshape(len(found["columns"]), found["points"])
    return dict(zip(found["columns"], table)), [found["status"].get(str(i), DONE) for i in range(found["points"])]


def _require_usable(folder: Path, resume: bool) -> None:
    """Raises CaseError unless `folder` may be written to. Changes nothing."""
    if folder.exists() and not folder.is_dir():
        raise CaseError(f"{folder}: found a file; required: a folder for the results")
    names = sorted(os.listdir(folder)) if folder.is_dir() else []
    if not names:
        return
    if JOURNAL not in names:
        raise CaseError(f"{folder}: found a folder that holds '{names[0]}'; required: an empty one, or one that does not exist yet")
    if not resume:
        journals.Journal(folder / JOURNAL).close()  # says so where another writes here at this moment
        raise CaseError(f"{folder}: found a folder that holds a study of uncertainty; required: an empty one, one that does not exist yet, or --resume to continue with this one")
