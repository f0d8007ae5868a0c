"""The page of a case in a browser, from Python."""

from __future__ import annotations

import atexit
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Optional, Union

from orbearing.case import Case
from orbearing.errors import CaseError, ComputationError


class Page:
    """A page that is served: `address` is what a browser opens. It ends a minute after its last tab is closed, or by close()."""

    def __init__(self, process: subprocess.Popen, address: str, case: Optional["_CaseFolder"]):
        self._process, self.address, self._case = process, address, case
        atexit.register(self.close)

    def close(self) -> None:
        """Ends it. Results of jobs and files that were saved are kept; their folders are printed."""
        atexit.unregister(self.close)
        if self._process.poll() is None:
            self._process.terminate()
        if not self._process.stdout.closed:
            print(self._process.communicate()[0], end="")
        if self._case is not None:
            self._case.end()
            self._case = None

    def __enter__(self) -> "Page":
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"Page({self.address!r})"


class _CaseFolder:
    """A Case as a file in a folder of its own, which stays where something is saved into it."""

    def __init__(self, text: str):
        self.file, self._text = Path(tempfile.mkdtemp(prefix="orbearing-")) / "case.yaml", text
        self.file.write_text(text, encoding="utf-8")

    def end(self) -> None:
        folder = self.file.parent
        if [one.name for one in folder.iterdir()] == [self.file.name] and self.file.read_text(encoding="utf-8") == self._text:
            shutil.rmtree(folder)
        else:
            print(f"saved files are kept in {folder}")


def open(what: Union[None, str, "os.PathLike[str]", Case] = None, browser: bool = True, port: int = 0) -> Page:  # pylint: disable=redefined-builtin
    """Opens the page of a case: a Case with its changes, a file, a template by its name, or a folder of results.

    browser: whether one is opened; port: on the loopback address, 0 one that is free.
    Raises CaseError for what cannot be opened, ComputationError where the port is taken.
    """
    case = _CaseFolder(what.resolved) if isinstance(what, Case) else None
    words = [sys.executable, "-m", "orbearing.command_line", "open", *([] if browser else ["--no-browser"]), *([f"--port={port}"] if port else [])]
    words += [] if what is None else ["--", os.fspath(case.file if case else what)]
    here = str(Path(__file__).parents[1])
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, [here, os.environ.get("PYTHONPATH")]))}
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as messages:  # a pipe that nobody reads would fill
        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=messages, text=True, env=environment)  # pylint: disable=consider-using-with
        address = process.stdout.readline().strip()
        if address:
            return Page(process, address, case)
        process.communicate()
        messages.seek(0)
        message = messages.read().strip()
    if case is not None:
        case.end()
    raise (CaseError if process.returncode == 2 else ComputationError)(message)
