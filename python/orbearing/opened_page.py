"""The page of a case in a browser, from Python."""

from __future__ import annotations

import atexit
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Optional, Union

from orbearing.case import Case
from orbearing.errors import CaseError, ComputationError


class Page:
    """A page that is served: `address` is what a browser opens. It ends a minute after its last tab is closed, or by close()."""

    def __init__(self, process: subprocess.Popen, address: str, folder: Optional[tempfile.TemporaryDirectory]):
        self._process, self.address, self._folder = process, address, folder
        atexit.register(self.close)

    def close(self) -> None:
        """Ends it; results of jobs are kept."""
        atexit.unregister(self.close)
        if self._process.poll() is None:
            self._process.terminate()
        self._process.communicate()
        if self._folder is not None:
            self._folder.cleanup()

    def __enter__(self) -> "Page":
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"Page({self.address!r})"


def open(what: Union[None, str, "os.PathLike[str]", Case] = None, browser: bool = True, port: int = 0) -> Page:  # pylint: disable=redefined-builtin
    """Opens the page of a case: a Case with its changes, a file, a template by its name, or a folder of results.

    browser: whether one is opened; port: on the loopback address, 0 one that is free.
    Raises CaseError for what cannot be opened, ComputationError where the port is taken.
    """
    folder = None
    if isinstance(what, Case):
        folder = tempfile.TemporaryDirectory(prefix="orbearing-")
        file = Path(folder.name) / "case.yaml"
        file.write_text(what.resolved, encoding="utf-8")
        what = file
    words = [sys.executable, "-m", "orbearing.command_line", "open", *([] if browser else ["--no-browser"]), *([f"--port={port}"] if port else [])]
    words += [] if what is None else ["--", os.fspath(what)]
    here = str(Path(__file__).parents[1])
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, [here, os.environ.get("PYTHONPATH")]))}
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)  # pylint: disable=consider-using-with
    address = process.stdout.readline().strip()
    if address:
        return Page(process, address, folder)
    message = process.communicate()[1].strip()
    if folder is not None:
        folder.cleanup()
    raise (CaseError if process.returncode == 2 else ComputationError)(message)
