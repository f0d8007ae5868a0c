"""What the commands of the package have in common: --set, exit codes, and a line of progress that is written over."""

from __future__ import annotations

import argparse
import math
import os
import re
import sys
import time
from typing import Callable

from orbearing.errors import CaseError, ComputationError

PAUSE_SECONDS = 0.1  # between two lines of progress
WIPED = "\r\x1b[K"


# Control characters, marks that turn the direction of writing, and halves of a pair of UTF-16: as printable() of the C++ commands.
CONTROL = re.compile("[\x00-\x1f\x7f-\x9f\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff\ud800-\udfff]")
_SHORT = {"\n": "\\n", "\t": "\\t", "\r": "\\r"}


def printable(text: str) -> str:
    """A text of a file or of the user on one line of a terminal: what moves the cursor or turns the writing is escaped."""
    return CONTROL.sub(lambda found: _SHORT.get(found[0]) or (f"\\x{ord(found[0]):02x}" if ord(found[0]) < 0x100 else f"\\u{ord(found[0]):04x}"), text)


def settings_of(options: list[str]) -> list[tuple[str, str]]:
    """--set options, "path=value", as pairs. Raises CaseError with all that are none."""
    pairs = [option.partition("=") for option in options]
    wrong = [option for option, (path, equals, _) in zip(options, pairs) if not path.strip() or not equals]
    if wrong:
        raise CaseError([f"--set: found '{option}'; required: path=value" for option in wrong])
    return [(path.strip(), value.strip()) for path, _, value in pairs]


def stated(text: str) -> str:
    """A text of an option, for argparse: not empty, as a shell makes it of a variable that is not set."""
    if not text.strip():
        raise argparse.ArgumentTypeError("found an empty text; a value is required")
    return text


def whole_number(least: int, most: int = 10**18 - 1) -> Callable[[str], int]:
    """Reads a whole number in these bounds, for argparse; digits of ASCII alone, as the C++ commands do."""
    def read(text: str) -> int:
        found = re.fullmatch(r"[+-]?[0-9]{1,18}", text.strip(), re.ASCII)
        if not found or not least <= int(found[0]) <= most:
            above = f" and at most {most}" if most < 10**18 - 1 else ""
            raise argparse.ArgumentTypeError(f"found {text!r}; a whole number of at least {least}{above} is required")
        return int(found[0])
    return read


def finite(text: str) -> float:
    """Reads a finite decimal number, for argparse."""
    if not re.fullmatch(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?", text.strip(), re.ASCII) or not math.isfinite(float(text)):
        raise argparse.ArgumentTypeError(f"found {text!r}; a finite number is required")
    return float(text)


class Parser(argparse.ArgumentParser):
    """Of the package's commands: what the user wrote stands in its messages without what moves the cursor."""

    def error(self, message: str):
        """Prints the usage and the mistake; exit code 2."""
        super().error(printable(message))


def exit_code(name: str, run: Callable[[], int], packages: str, stays: str = "") -> int:
    """That of the command `name`: of `run`, or of its error, which is printed: 2 bad input, 1 anything else.

    packages: what is required where one is missing; stays: what an interrupted or failed computation leaves behind.
    """
    try:
        return run()
    except CaseError as error:
        for message in error.messages:
            print(printable(message), file=sys.stderr)
        return 2
    except ImportError as error:
        print(f"{name}: {error}; required: {packages}", file=sys.stderr)
    except KeyboardInterrupt:
        print(f"{name}: interrupted{stays}", file=sys.stderr)
    except ComputationError as error:
        print(f"{name}: {error}{stays}", file=sys.stderr)
    except OSError as error:  # without a file it is of a line that was printed
        print(f"{name}: {error.filename or 'standard output'}: {error.strerror}{stays}", file=sys.stderr)
    return 1


class _StandardError:
    """Standard error that may be closed, or a file on a full disk: what becomes of a message changes no exit code."""

    def __init__(self, stream):
        self._stream = stream

    def write(self, text: str) -> int:
        """All of it, or nothing any more."""
        self._try(lambda: self._stream.write(text))
        return len(text)

    def flush(self) -> None:
        """As far as anyone reads it."""
        self._try(self._stream.flush)

    def _try(self, call: Callable[[], object]) -> None:
        try:
            call()
        except (OSError, ValueError):
            # The rest of the buffer would be written once more at the end, and fail there.
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)

    def __getattr__(self, name: str):
        return getattr(self._stream, name)


def finished(command: Callable[[], int]) -> int:
    """The exit code of a command once all that it printed is written; 1 where that fails, as on a full disk. Messages on
    standard error may be lost, and it stays the same."""
    sys.stderr = _StandardError(sys.stderr if sys.stderr is not None else open(os.devnull, "w", encoding="utf-8"))
    try:
        code = command()
    except SystemExit as end:  # of --help, of wrong options, and with a message
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
    except OSError as error:
        if error.filename:
            print(f"{error.filename}: {error.strerror}", file=sys.stderr)
            return 1
        return _not_printed(error, 1)
    try:
        sys.stdout.flush()
    except OSError as error:
        return _not_printed(error, code)
    return code


def _not_printed(error: OSError, code: int) -> int:
    print(f"standard output: cannot be written: {error.strerror}; make room, then give the command again", file=sys.stderr)
    # The rest of the buffer would be written once more at the end.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return code or 1


class StatusLine:
    """One line on standard error, on a terminal alone and not more often than anyone reads."""

    def __init__(self, shown: bool):
        self._shown = shown and sys.stderr.isatty()
        self._last = 0.0

    @property
    def is_due(self) -> bool:
        return self._shown and time.monotonic() - self._last >= PAUSE_SECONDS

    def show(self, text: str) -> None:
        self._last = time.monotonic()
        sys.stderr.write(WIPED + text)
        sys.stderr.flush()

    def end(self) -> None:
        if self._shown:
            sys.stderr.write(WIPED)
            sys.stderr.flush()
