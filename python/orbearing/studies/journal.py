"""An append-only file of checksummed records: what stood in it before a kill stands in it after.

A record is one line of JSON with the length and the checksum of the bytes that follow it, these bytes, and an end of line. Each is on the disk
when `append` returns. A kill leaves at most one torn record, the last; it is cut off when the file is opened for writing again.
"""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
from dataclasses import dataclass
from pathlib import Path

from orbearing.errors import CaseError

END = b"\n"


@dataclass(frozen=True)
class Record:
    """`head` says what the payload is; both are under the checksum."""

    head: dict
    payload: bytes


@dataclass(frozen=True)
class Contents:
    """Sound records in their order, the length without a torn last one [byte], and the positions of damaged ones [byte]."""

    records: list[Record]
    sound_bytes: int
    damaged: list[int]


def encoded(record: Record) -> bytes:
    """The bytes of a record as they stand in the file."""
    line = {**record.head, "bytes": len(record.payload)}
    line["checksum"] = _checksum(line, record.payload)
    return _text(line) + END + record.payload + END


def read(path: Path) -> Contents:
    """Every record of a journal. Raises CaseError where a line that is not the last is none of ours."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise CaseError(f"{path}: cannot be read ({error.strerror}); a readable file is required") from error
    records, damaged, position = [], [], 0
    while position < len(data):
        end = data.find(END, position)
        if end < 0:
            break
        line = _line(data[position:end])
        if line is None:
            # After a loss of power the last record may have its length, yet not its content.
            if records and data.find(END, end + 1) < 0:
                break
            raise CaseError(f"{path}: byte {position}: not a record that this program wrote; an undamaged folder of a study is required, "
                           "or an empty one for a new start")
        after = end + 1 + line["bytes"] + len(END)
        if after > len(data):
            break
        payload = data[end + 1:after - len(END)]
        stated = line.pop("checksum")
        if _checksum(line, payload) != stated or data[after - len(END):after] != END:
            if after == len(data):
                break
            damaged.append(position)
        else:
            line.pop("bytes")
            records.append(Record(line, payload))
        position = after
    return Contents(records, position, damaged)


def _line(text: bytes) -> dict | None:
    try:
        line = json.loads(text)
    except ValueError:
        return None
    sound = isinstance(line, dict) and isinstance(line.get("bytes"), int) and line["bytes"] >= 0 and isinstance(line.get("checksum"), str)
    return line if sound else None


def _text(line: dict) -> bytes:
    return json.dumps(line, separators=(",", ":"), allow_nan=False).encode()


def _checksum(line: dict, payload: bytes) -> str:
    sum_of = hashlib.blake2b(_text(line), digest_size=8)
    sum_of.update(payload)
    return sum_of.hexdigest()


class Journal:
    """A journal open for writing, locked against a second writer for as long as it is open."""

    def __init__(self, path: Path):
        """Opens or makes the file. Raises CaseError where another study writes into it."""
        self.path = path
        try:
            self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC | os.O_NOFOLLOW, 0o666)
        except OSError as error:
            raise CaseError(f"{path}: cannot be written: {error.strerror}; a folder that may be written to is required") from error
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            os.close(self._file)
            raise CaseError(f"{path}: another run is writing here; wait for its end, or use another folder") from error
        except OSError:
            pass  # a file system without locks is no reason to refuse
        self._length = os.fstat(self._file).st_size

    def cut(self, length: int) -> None:
        """Leaves the first `length` bytes."""
        if length != self._length:
            os.ftruncate(self._file, length)
            self._length = length

    def append(self, record: Record) -> None:
        """Raises OSError where the disk does not take the record; what was kept before stays sound."""
        data = memoryview(encoded(record))
        try:
            rest = data
            while rest:
                rest = rest[os.write(self._file, rest):]
            os.fsync(self._file)
        except OSError as error:
            os.ftruncate(self._file, self._length)
            raise OSError(error.errno, f"cannot be written: {error.strerror}", str(self.path)) from error
        self._length += len(data)

    def close(self) -> None:
        if self._file >= 0:
            os.close(self._file)
            self._file = -1
