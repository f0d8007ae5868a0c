"""Copies of the Python package that hold one error each, and which tests of the program from outside fail with it; nothing is built."""

import ast
import json
import os
import pathlib
import queue
import re
import shutil
import sys
import time

from .draw import Mutant
from .trial import LEAST_PATIENCE, PATIENCE, digest, run, with_error

FOLDER = "python/orbearing"
LONGEST = 1800.0  # [s] of a test without an error
USES = re.compile(r"\borbearing\b(?! (run|sweep|check)\b)|\bpackage\(|\"(report|study|uncertainty|validate)\"")
CALLS = re.compile(r"^(from|import) program\b|\bORBEARING\b", re.M)  # the program, which takes longer
SLOW = 100.0  # [s]  of a test without an error: asked after the others, unless it is named like the error's module
SKIPPED = (0, 77)
OF_THIS_TOOL = "mutation_tool.py"  # names the package's folder and does not use it


class PackageCopies:
    """In home/package_0, home/package_1 and so on: bin, lib and python as in the folder of a build, whose program and library are used.

    Tests that take more than `longest` [s] are not asked.
    """

    def __init__(self, root: pathlib.Path, home: pathlib.Path, build: pathlib.Path, jobs: int, longest: float = LONGEST):
        self.root, self.home, self.build, self.longest = root, home, build, longest
        self.free: queue.Queue[pathlib.Path] = queue.Queue()
        for number in range(jobs):
            self.free.put(self._copy(home / f"package_{number}"))
        self.times_file = home / "package_tests.json"
        self.times = json.loads(self.times_file.read_text()) if self.times_file.exists() else {}

    def _copy(self, folder: pathlib.Path) -> pathlib.Path:
        program = self.build / "bin" / "orbearing"
        if not program.exists():
            raise RuntimeError(f"{program} is required; build it by tools/test or name another build by --program")
        shutil.rmtree(folder, ignore_errors=True)
        (folder / "bin").mkdir(parents=True)
        for file in (self.build / "bin").iterdir():  # a link would lead the program back to the package of its build
            try:
                os.link(file, folder / "bin" / file.name)
            except OSError:
                shutil.copy(file, folder / "bin" / file.name)
        (folder / "lib").symlink_to(self.build / "lib")
        shutil.copytree(self.root / FOLDER, folder / FOLDER, ignore=shutil.ignore_patterns("__pycache__"))
        self._link(self.root, folder, "python", "tests", "build", ".git", "bin", "lib")  # cases, which the package finds above itself
        return folder

    @staticmethod
    def _link(source: pathlib.Path, folder: pathlib.Path, *left_out: str) -> None:
        """Links in `folder` to all that is in `source` but these."""
        for entry in source.iterdir():
            if entry.name not in left_out:
                (folder / entry.name).symlink_to(entry)

    def tests(self, mutant: Mutant) -> list[pathlib.Path]:
        """Those that use the package: first those with a name like the error's module or folder, then records, which ask most of it in a few seconds,
        then those that name the module; the quick ones first."""
        path = pathlib.PurePosixPath(mutant.file)
        words = [path.stem.split("_")[0]] + ([path.parent.name] if path.parent.name != "orbearing" else [])
        found = []
        for test in sorted((self.root / "tests" / "interface").glob("*.py")):
            text = test.read_text(encoding="utf-8")
            if test.name != OF_THIS_TOOL and re.search(r"^if __name__ == .__main__.:", text, re.M) and USES.search(text):
                seconds = self.times.get(test.name, 30.0)
                if seconds > self.longest:
                    continue
                unlike = sum(not test.name.startswith(word[:8].removesuffix("s")) for word in words)
                unnamed = sum(re.search(rf"\b{word}", text) is None for word in words)
                found.append((unlike, seconds > SLOW, not test.name.endswith("_recorded.py"), unnamed, CALLS.search(text) is not None, seconds, test))
        return [test for *_, test in sorted(found)]

    def ask(self, test: pathlib.Path, folder: pathlib.Path, seconds: float) -> tuple[int, str]:
        environment = os.environ | {"ORBEARING": str(folder / "bin" / "orbearing"), "ORBEARING_MACHINE_RUN": str(folder / "bin" / "orbearing_machine_run"),
                                    "ORBEARING_FMU_LOADER": str(folder / "bin" / "orbearing_fmu_loader"), "ORBEARING_SOURCE_DIR": str(self.seen_from(folder)),
                                    "PYTHONPATH": str(folder / "python"), "PYTHONDONTWRITEBYTECODE": "1"}
        return run([sys.executable, str(self.seen_from(folder) / "tests" / "interface" / test.name)], seconds, env=environment, cwd=folder)

    def seen_from(self, folder: pathlib.Path) -> pathlib.Path:
        """The folder of sources as tests see it: all links to the right ones but the package, which tests find beside themselves."""
        place = folder / "source"
        if not place.exists():
            place.mkdir()
            self._link(self.root, place, "python", "tests", "build", ".git")
            shutil.copytree(self.root / "tests", place / "tests", ignore=shutil.ignore_patterns("__pycache__"))
            (place / "python").mkdir()
            for entry in (self.root / "python").iterdir():
                (place / "python" / entry.name).symlink_to(folder / FOLDER if entry.name == "orbearing" else entry)
        return place

    def passes(self, test: pathlib.Path, folder: pathlib.Path, tell) -> bool:
        """Whether it does without an error, asked once while test and package stay."""
        key = digest(test.read_text(), *(path.read_text() for path in sorted((self.root / FOLDER).rglob("*.py"))))
        known = self.times.get(f"{test.name} {key}")
        if known is None:
            begin = time.monotonic()
            code, output = self.ask(test, folder, LONGEST)
            self.times[test.name] = time.monotonic() - begin
            known = self.times[f"{test.name} {key}"] = code in SKIPPED
            self.times_file.write_text(json.dumps(self.times, indent=1))
            if not known:
                tell(f"{test.name} is left out: it fails without any error\n{output[-600:]}")
        return known

    def finder(self, mutant: Mutant, tell) -> tuple[str, str]:
        """The first test that fails with the error; "no program" where Python cannot read it."""
        whole = (self.root / mutant.file).read_text(encoding="utf-8")
        wrong = with_error(whole, mutant)
        if mutant.file.endswith(".py"):
            try:
                if ast.dump(ast.parse(wrong)) == ast.dump(ast.parse(whole)):
                    return "same program", ""
            except SyntaxError:
                return "no program", ""
        folder = self.free.get()
        place = folder / mutant.file
        try:
            for test in self.tests(mutant):
                place.write_text(wrong, encoding="utf-8")
                begin = time.monotonic()
                code, output = self.ask(test, folder, LEAST_PATIENCE + PATIENCE * self.times.get(test.name, 60.0))
                if code in SKIPPED:
                    self.times.setdefault(test.name, time.monotonic() - begin)
                    continue
                place.write_text(whole, encoding="utf-8")
                if self.passes(test, folder, tell):
                    failed = re.findall(r"^(?:FAIL|ERROR): (\w+)", output, re.M)
                    how = "" if failed else " (did not end)" if code == 124 else ""
                    return "interface", f"{test.name}: {failed[0] if failed else '?'}{how}"
            return "none", ""
        finally:
            place.write_text(whole, encoding="utf-8")
            self.free.put(folder)
