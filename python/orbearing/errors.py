"""What goes wrong, as exceptions."""

from __future__ import annotations

import operator
import re
from typing import NamedTuple, Optional


MOST_THREADS = 4096


class Mistake(NamedTuple):
    """One thing that is wrong: where, which input, what was found and what is required."""

    file: Optional[str]
    line: Optional[int]
    column: Optional[int]
    key: Optional[str]
    text: str


_KEY = r"[A-Za-z_]\w*(?:\.[A-Za-z_][\w-]*(?:\[\d+\])?)*"
_PLACED = re.compile(rf"(?P<file>[^:]+):(?P<line>\d+):(?P<column>\d+): (?:(?P<key>{_KEY}): )?(?P<text>.*)", re.S)
_KEYED = re.compile(rf"(?:[^\s:]+: )?(?P<key>{_KEY}): (?P<text>.*)", re.S)


def _mistake(message: str) -> Mistake:
    placed = _PLACED.fullmatch(message)
    if placed:
        return Mistake(placed["file"], int(placed["line"]), int(placed["column"]), placed["key"], placed["text"])
    keyed = _KEYED.fullmatch(message)
    return Mistake(None, None, None, keyed["key"], keyed["text"]) if keyed else Mistake(None, None, None, None, message)


class CaseError(ValueError):
    """A case, an input, an option or a folder that cannot be used; every mistake at once.

    messages: a text for each mistake, as the command line prints them: place, what was found, what is required.
    mistakes: the same with file, line, column and key apart.
    """

    def __init__(self, messages: list[str] | str):
        self.messages = [messages] if isinstance(messages, str) else list(messages)
        self.mistakes = [_mistake(message) for message in self.messages]
        super().__init__("\n".join(self.messages))

    def without_option(self) -> "CaseError":
        """The same of a value that was set in Python: without the option --set, by which the command line would have set it."""
        return CaseError([message.removeprefix("--set: ") for message in self.messages])

    def __reduce__(self):
        return CaseError, (self.messages,)


def require_whole(name: str, value, least: int, most: int = 10**8) -> None:
    """Raises CaseError for what is no whole number in these bounds."""
    try:
        whole = not isinstance(value, bool) and least <= operator.index(value) <= most
    except TypeError:
        whole = False
    if not whole:
        raise CaseError(f"{name}: {value!r} found; a whole number of at least {least} and at most {most} is required")


class ComputationError(RuntimeError):
    """Sound input whose computation could not be completed."""
