"""Copies of the page's scripts that hold one error each, and whether the page's own tests fail with it; nothing is built."""

import os
import pathlib
import queue
import re
import shutil
import sys
import time

from .draw import Mutant
from .trial import LEAST_PATIENCE, PATIENCE, run, with_error

FOLDER = "page/web"
TESTS = "page_drawn*.py"  # what the page draws, by node without a browser
LONGEST = 1800.0  # [s] of a test without an error
SKIPPED = 77


def _linked(here: pathlib.Path, place: pathlib.Path, without: str) -> pathlib.Path:
    """A folder at `place` with links to all that is in `here` but one entry."""
    place.mkdir()
    for entry in here.iterdir():
        if entry.name not in (without, "build", ".git"):
            (place / entry.name).symlink_to(entry)
    return place / without


class PageCopies:
    """In home/page_0, home/page_1 and so on: the sources as tests see them, all links but the page's scripts."""

    def __init__(self, root: pathlib.Path, home: pathlib.Path, build: pathlib.Path, jobs: int):
        self.root, self.program = root, build / "bin" / "orbearing"
        self.tests = sorted((root / "tests" / "interface").glob(TESTS))
        if not self.tests:
            raise RuntimeError(f"tests/interface/{TESTS} is required, which judges errors in {FOLDER}")
        self.times: dict[str, float] = {}
        self.free: queue.Queue[pathlib.Path] = queue.Queue()
        for number in range(jobs):
            self.free.put(self._copy(home / f"page_{number}"))

    def _copy(self, place: pathlib.Path) -> pathlib.Path:
        shutil.rmtree(place, ignore_errors=True)
        here, at = self.root, place
        for part in pathlib.PurePosixPath(FOLDER).parts:
            at, here = _linked(here, at, part), here / part
        shutil.copytree(here, at)
        return place

    def ask(self, test: pathlib.Path, place: pathlib.Path, seconds: float) -> tuple[int, str]:
        environment = os.environ | {"ORBEARING": str(self.program), "ORBEARING_SOURCE_DIR": str(place), "PYTHONDONTWRITEBYTECODE": "1"}
        code, output = run([sys.executable, str(test), "--failfast"], seconds, env=environment, cwd=place)
        if code == SKIPPED:
            raise RuntimeError(f"{test.name} is {output.strip()}; it judges errors in {FOLDER}")
        return code, output

    def measure(self, tell) -> None:
        """How long tests take without an error; what fails then judges nothing."""
        place = self.free.get()
        for test in list(self.tests):
            begin = time.monotonic()
            code, output = self.ask(test, place, LONGEST)
            self.times[test.name] = time.monotonic() - begin
            if code != 0:
                tell(f"{test.name} is left out: it fails without any error\n{output[-600:]}")
                self.tests.remove(test)
        self.tests.sort(key=lambda test: self.times[test.name])  # quick ones first
        self.free.put(place)

    def finder(self, mutant: Mutant) -> tuple[str, str]:
        """The first test that fails with the error; "no program" where node cannot read it."""
        whole = (self.root / mutant.file).read_text(encoding="utf-8")
        place = self.free.get()
        file = place / mutant.file
        try:
            file.write_text(with_error(whole, mutant), encoding="utf-8")
            module = place / "checked.mjs"
            shutil.copy(file, module)
            if run([shutil.which("node") or shutil.which("nodejs") or "node", "--check", str(module)], 60.0)[0] != 0:
                return "no program", ""
            for test in self.tests:
                code, output = self.ask(test, place, LEAST_PATIENCE + PATIENCE * self.times.get(test.name, 60.0))
                if code != 0:
                    failed = re.findall(r"^(?:FAIL|ERROR): (\w+)", output, re.M)
                    return "interface", f"{test.name}: {failed[0] if failed else '?'}{' (did not end)' if code == 124 and not failed else ''}"
            return "none", ""
        finally:
            file.write_text(whole, encoding="utf-8")
            self.free.put(place)
