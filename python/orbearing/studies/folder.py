"""The folder of a study: who may write into it, how finished points get there whole or not at all.

    case.resolved.yaml   the case with every default
    study.journal        the design, then chunks of finished points: only ever appended to
    study.nc             the same as named arrays, written anew from time to time and at the end
    points/NNNNN.nc      one file for a point, where asked for
"""

from __future__ import annotations

import json
import os
import time
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from orbearing.errors import CaseError
from orbearing.studies import journal as journals
from orbearing.studies.dataset import content_of, write_netcdf
from orbearing.studies.design import Design, from_content
from orbearing.studies.table import CHUNK, Chunk, ResultTable, decode, encode
from orbearing.whole_files import ASIDE, write_whole

FORMAT = 1
JOURNAL, RESOLVED, DATASET, POINTS = "study.journal", "case.resolved.yaml", "study.nc", "points"
OPENING = b'{"orbearing_study":'
REFRESH_SECONDS = 20.0  # at least, from one writing of study.nc to the next
REFRESH_SHARE = 0.03  # of the time, at most, for writing study.nc


def point_file_name(point: int) -> str:
    return f"{POINTS}/{point:05}.nc"


def header_of(case_name: str, case_hash: str, program: dict[str, str], fidelity: str, life_key: str, design: Design) -> dict:
    """What a study's results belong to; what differs from it is another study."""
    return {"orbearing_study": FORMAT, "case": case_name, "case_hash": case_hash, **program, "fidelity": fidelity, "life_key": life_key, "points": design.points,
            **design.summary()}


def differences(found: dict, required: dict) -> list[str]:
    """In the words of a message."""
    names = {"case": "case", "case_hash": "resolved case with hash", "program_version": "program version", "instruction_set": "instruction set",
             "fidelity": "fidelity", "life_key": "governing life", "points": "number of points", "sampler": "sampler", "seed": "seed", "dimensions": "dimensions"}
    lines = [f"{words} '{found.get(key)}' was found; '{required.get(key)}' is required" for key, words in names.items() if found.get(key) != required.get(key)]
    if found.get("parameters") != required.get("parameters"):
        ours = {p["path"]: p for p in required["parameters"]}
        theirs = {p["path"]: p for p in found.get("parameters", [])}
        lines += [f"values of {path}: {_words(theirs.get(path))} was found; {_words(ours.get(path))} is required"
                  for path in dict.fromkeys((*theirs, *ours)) if theirs.get(path) != ours.get(path)]
    return lines


def _words(parameter: dict | None) -> str:
    return f"'{parameter['from']} ... {parameter['to']}' ({parameter['values']})" if parameter else "none"


def _sound_header(path: Path, contents: journals.Contents) -> dict:
    header = contents.records[0].head
    if header.get("orbearing_study") != FORMAT:
        raise CaseError(f"{path}: written in another format; a folder of a study by this program is required")
    return header


def _names_in(folder: Path) -> list[str]:
    try:
        return sorted(os.listdir(folder))
    except FileNotFoundError:
        return []
    except NotADirectoryError as error:
        raise CaseError(f"{folder}: is not a folder; a new or empty folder is required") from error
    except OSError as error:
        raise CaseError(f"{folder}: cannot be looked into: {error.strerror}; a folder open to you is required") from error


def _require_usable(folder: Path, header: dict, resume: bool) -> None:
    """Raises CaseError unless `folder` may be written to. Changes nothing."""
    names = _names_in(folder)
    if not names:
        return
    if JOURNAL not in names:
        raise CaseError(f"{folder}: holds '{names[0]}', which is no result of a study; a new or empty folder is required")
    if (folder / POINTS).is_symlink():
        raise CaseError(f"{folder / POINTS}: found a link to {os.readlink(folder / POINTS)}; required: a folder of its own, so that nothing outside is "
                        "written to. Give another folder")
    if not resume:
        raise CaseError(f"{folder}: holds results; a new or empty folder is required, or --resume to continue with these")
    path = folder / JOURNAL
    if _is_torn_header(path):
        if len(names) > 1:
            raise CaseError(f"{folder}: holds '{names[0]}' and a journal without its first record; a new or empty folder is required")
        return
    _require_same(folder, _sound_header(path, journals.read(path)), header)


def _require_same(folder: Path, found: dict, required: dict) -> None:
    lines = differences(found, required)
    if lines:
        raise CaseError([f"{folder}: --resume: {line}; use another folder, or the case and the design of these results" for line in lines])


def _is_torn_header(path: Path) -> bool:
    """True for the start of a first record that a kill cut short."""
    with open(path, "rb") as file:
        start = file.read(len(OPENING))
    return OPENING.startswith(start[:len(OPENING)]) and not journals.read(path).records


class StudyFolder:
    """An open folder of a study, or none: then results are kept in memory alone.

    A kill at any moment leaves a folder that `resume` accepts, with every point that `keep` returned from.
    """

    def __init__(self, folder: Path | None, header: dict, design: Design, attributes: dict[str, Any], resolved: str, resume: bool):
        self.folder, self.header, self.design, self.attributes = folder, header, design, attributes
        self.table = ResultTable(design.points)
        self.damaged: list[str] = []
        self._journal: journals.Journal | None = None
        self._written = time.monotonic()
        self._cost = 0.0  # [s] of the last writing of study.nc
        if folder is None:
            return
        _require_usable(folder, header, resume)
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise CaseError(f"{folder}: cannot be made: {error.strerror}; a writable path is required") from error
        self._journal = journals.Journal(folder / JOURNAL)
        try:
            self._begin(resolved)
        except BaseException:
            self.close()
            raise

    def _begin(self, resolved: str) -> None:
        path = self.folder / JOURNAL
        contents = journals.read(path)
        if contents.records:
            # Another study may have come between the look and the lock.
            _require_same(self.folder, _sound_header(path, contents), self.header)
            self._journal.cut(contents.sound_bytes)
            self.table = read_table(contents, self.design.points)
            self.damaged = [f"{path}: byte {position}: a damaged record; its points are computed again" for position in contents.damaged]
        else:
            self._journal.cut(0)
            design = zlib.compress(json.dumps(self.design.content(), separators=(",", ":")).encode(), 6)
            self._journal.append(journals.Record({**self.header, "attributes": self.attributes}, design))
        for name in _names_in(self.folder):
            if name.endswith(ASIDE):
                (self.folder / name).unlink()
        _write_text(self.folder / RESOLVED, resolved)
        _sync(self.folder)

    def keep(self, chunk: Chunk) -> int:
        """Takes a chunk's points that are not there yet; on the disk when it returns. How many there were."""
        new = self.table.add(chunk)
        if new is None:
            return 0
        if self._journal is not None:
            self._journal.append(encode(new))
            pause = max(REFRESH_SECONDS, self._cost / REFRESH_SHARE)
            if time.monotonic() - self._written > pause:
                self.write()
        return len(new.ids)

    def content(self):
        return content_of(self.design, self.table, self.attributes)

    def write(self) -> None:
        """study.nc of what is finished."""
        if self.folder is None:
            return
        begin = time.monotonic()
        write_netcdf(self.folder / DATASET, self.content())
        _sync(self.folder)
        self._written = time.monotonic()
        self._cost = self._written - begin

    def close(self) -> None:
        if self._journal is not None:
            self._journal.close()
            self._journal = None


def read_table(contents: journals.Contents, points: int) -> ResultTable:
    """All chunks of a journal."""
    table = ResultTable(points)
    for record in contents.records[1:]:
        if record.head.get("record") == CHUNK:
            table.add(decode(record))
    return table


def read_folder(folder: Path) -> tuple[dict, Design, ResultTable]:
    """Header, design and results of a folder, finished or not, also while a study writes into it."""
    path = folder / JOURNAL
    if not path.is_file():
        raise CaseError(f"{folder}: no {JOURNAL} was found; the folder of a study is required")
    contents = journals.read(path)
    if not contents.records:
        raise CaseError(f"{folder}: holds no results yet; continue its study with --resume first")
    header = _sound_header(path, contents)
    design = from_content(json.loads(zlib.decompress(contents.records[0].payload)))
    return header, design, read_table(contents, design.points)


def finished_counts(folder: Path) -> np.ndarray:
    """How often each point stands in the journal: once, where all is well."""
    contents = journals.read(folder / JOURNAL)
    counts = np.zeros(contents.records[0].head["points"], int)
    for record in contents.records[1:]:
        np.add.at(counts, decode(record).ids, 1)
    return counts


def _write_text(path: Path, text: str) -> None:
    if path.is_file() and path.read_text(encoding="utf-8") == text:
        return
    write_whole(path, text)


def _sync(folder: Path) -> None:
    opened = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(opened)
    except OSError:
        pass  # some network file systems cannot do this for folders
    finally:
        os.close(opened)
