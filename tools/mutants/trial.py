"""A copy of the sources that holds errors, its build, and which of its tests fail with one of them."""

import concurrent.futures
import contextlib
import dataclasses
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time

from . import beside
from .draw import Mutant

PROOFS = ("unit", "identities", "literature")  # what says how it shall be; regression says how it was
STAGES = (("unit", "literature"), ("identities",), ("regression",))  # the quick ones first
RECORDED = "tests/interface/recorded_results.py"  # the quick one of the tests from outside, asked before the others
NOT_COPIED = {"build", "dist", "results", ".git", ".cache"}  # of the root
CHOICE = "ORBEARING_MUTANT"  # of the environment: number of the error that acts
REACHED = "ORBEARING_REACHED"  # a file for the numbers of those that were come by
PATIENCE, LEAST_PATIENCE = 10.0, 30.0  # times as long as without an error, and [s]: what runs longer does not end
CHOOSER = """#pragma once
#include <atomic>
#include <cstdio>
#include <cstdlib>
namespace orbearing_mutants {
inline const int chosen = [] {
  const char* text = std::getenv("ORBEARING_MUTANT");
  return text == nullptr ? -1 : std::atoi(text);
}();
inline std::atomic<bool> reached[1000];
// At once, since what is ended by a signal has no end of its own.
[[gnu::noinline, gnu::cold]] inline void tell(int number) {
  if (reached[number].exchange(true)) return;
  const char* name = std::getenv("ORBEARING_REACHED");
  std::FILE* file = name == nullptr ? nullptr : std::fopen(name, "a");
  if (file == nullptr) return;
  std::fprintf(file, "%d\\n", number);
  std::fclose(file);
}
[[gnu::always_inline]] inline bool acts(int number) {
  if (!reached[number].load(std::memory_order_relaxed)) tell(number);
  return chosen == number;
}
}
"""


class Running:
    """Commands that run, each in a session of its own, so that it ends with all that it began."""

    def __init__(self):
        self.leaders: set[int] = set()
        self.lock = threading.RLock()  # a signal may come while this thread holds it
        self.ended = False

    def end_all(self) -> None:
        self.ended = True  # before the signals: no command begins after them
        with self.lock:
            for leader in self.leaders:
                end_session(leader)

    @contextlib.contextmanager
    def of(self, command: list, **options):
        with self.lock:
            if self.ended:
                raise KeyboardInterrupt
            process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                                       start_new_session=True, **options)
            self.leaders.add(process.pid)
        try:
            yield process
        finally:
            end_session(process.pid)  # what it left behind
            with self.lock:
                self.leaders.discard(process.pid)
        if self.ended:  # by us: its exit code says nothing
            raise KeyboardInterrupt


RUNNING = Running()


def end_session(leader: int) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.killpg(leader, signal.SIGKILL)


def run(command: list, seconds: float, **options) -> tuple[int, str]:
    """Exit code and all output; 124 where it had to be ended."""
    with RUNNING.of(command, **options) as process:
        try:
            said = process.communicate(timeout=seconds)[0]
            return process.returncode, said
        except subprocess.TimeoutExpired:
            end_session(process.pid)
            return 124, process.communicate()[0] + "\ndid not end"


def digest(*texts: str) -> str:
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:16]


def offset(text: str, line: int) -> int:
    return sum(len(one) for one in text.splitlines(keepends=True)[:line - 1])


def with_error(text: str, mutant: Mutant) -> str:
    """The text of its file with the error alone."""
    begin = offset(text, mutant.line)
    return text[:begin + mutant.begin] + mutant.fresh + text[begin + mutant.end:]


@dataclasses.dataclass
class TestFile:
    kind: str
    seconds: float
    reached: list[int]
    passes: bool = True


class Copy:
    """The copy of the sources in home/tree, built in home/tree/build/all, or in build/libraries without the program and its tests."""

    def __init__(self, root: pathlib.Path, home: pathlib.Path, texts: dict[str, str], jobs: int, program: bool = True, package: bool = False):
        """`program`: builds it and asks its tests; `package`: its Python package, too, whose tests come by the commands' errors."""
        self.root, self.home, self.texts, self.jobs, self.program, self.package = root, home, texts, jobs, program, package
        self.tree = home / "tree"
        self.folder = self.tree / "build" / ("all" if program else "libraries")
        self.tests = self.folder / "bin" / "orbearing_tests"
        self.chooser = home / "chooser.hpp"
        self.files: dict[str, TestFile] = {}
        self.inside: dict[int, Mutant] = {}
        self.answers: dict[str, dict] = {}  # recorded ones, by number

    def refresh(self) -> None:
        """All files as they are now, except those that hold errors: what is the same is not touched, nor built again."""
        self.tree.mkdir(parents=True, exist_ok=True)
        ours = set()
        for folder, folders, names in os.walk(self.root):
            folders[:] = [name for name in folders if name not in (NOT_COPIED if pathlib.Path(folder) == self.root else {"__pycache__"})]
            for name in names:
                source = pathlib.Path(folder, name)
                place = source.relative_to(self.root)
                ours.add(place)
                target = self.tree / place
                if place.as_posix() in self.texts and target.exists():
                    continue
                if not target.exists() or target.read_bytes() != source.read_bytes():
                    target.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy(source, target)
        for folder, folders, names in os.walk(self.tree):
            folders[:] = [name for name in folders if pathlib.Path(folder) != self.tree or name not in NOT_COPIED]
            for name in names:
                if pathlib.Path(folder, name).relative_to(self.tree) not in ours:
                    pathlib.Path(folder, name).unlink()

    def write(self, changed: dict[str, str]) -> None:
        """These texts of the physics, and all others without an error."""
        for name, text in (self.texts | changed).items():
            target = self.tree / name
            if target.read_text(encoding="utf-8") != text:
                target.write_text(text, encoding="utf-8")

    def holding(self, mutants: dict[int, Mutant], form: dict[int, int]) -> tuple[dict[str, str], list[int]]:
        """Texts that hold these errors, each in its form; numbers of those that have no such form."""
        texts, without = {}, []
        for name in {mutant.file for mutant in mutants.values()}:
            whole = self.texts[name]
            bare = beside.without_comments(whole)
            edits = []
            for number, mutant in mutants.items():
                if mutant.file != name:
                    continue
                begin = offset(whole, mutant.line)
                ways = list(beside.forms(bare, begin + mutant.begin, begin + mutant.end, mutant.fresh, number))[form[number]:]
                ways = [way for way in ways if all(way[1] <= other[0] or other[1] <= way[0] for other in edits)]
                edits += ways[:1]
                if not ways:
                    without.append(number)
            for begin, stop, text in sorted(edits, reverse=True):
                whole = whole[:begin] + text + whole[stop:]
            texts[name] = f'#include "{self.chooser}"\n#line 1\n{whole}'
        return texts, without

    def make(self, *targets: str) -> bool:
        if not self.chooser.exists() or self.chooser.read_text() != CHOOSER:
            self.chooser.write_text(CHOOSER)
        if not (self.folder / "build.ninja").exists():
            code, self.log = run(["cmake", "-S", self.tree, "--preset", "release", "-B", self.folder, "-DORBEARING_BUILD_WIN64=OFF",
                                  f"-DORBEARING_BUILD_APP={'ON' if self.program else 'OFF'}",
                                  f"-DORBEARING_BUILD_PYTHON={'ON' if self.package else 'OFF'}",
                                  "-DORBEARING_WARNINGS_AS_ERRORS=OFF"], 600.0, cwd=self.tree)
            if code != 0:
                return False
        code, self.log = run(["ninja", "-C", self.folder, "-k", "0", "-j", str(self.jobs), *(targets or ("orbearing_tests",))], 7200.0)
        return code == 0

    def hold_all(self, mutants: dict[int, Mutant], tell) -> list[int]:
        """Builds the tests with the errors beside the right statements; the numbers of those with which that cannot be done."""
        kept_in = self.home / "forms.json"
        known = json.loads(kept_in.read_text()) if kept_in.exists() else {}
        form = {number: known.get(mutant.key, 0) for number, mutant in mutants.items()}
        inside, alone = dict(mutants), []
        while True:
            kept_in.write_text(json.dumps(known | {mutants[number].key: way for number, way in form.items()}))
            texts, without = self.holding(inside, form)
            alone += without
            inside = {number: mutant for number, mutant in inside.items() if number not in without}
            self.write(texts)
            tell(f"building the tests with {len(inside)} errors in them")
            if self.make():
                self.inside = inside
                return alone
            places = [((self.folder / name).resolve().as_posix(), int(line))
                      for name, line in re.findall(r"([^\s:]+\.[ch]pp):(\d+)(?::\d+)?[:,]", self.log)]
            # A statement of several lines is written into its first.
            suspects = [number for number, mutant in inside.items()
                        if any(name == (self.tree / mutant.file).resolve().as_posix() and -12 <= line - mutant.line <= 3
                               for name, line in places)]
            if not suspects:
                raise RuntimeError(f"the copy does not build, and not for the sake of an error:\n{self.log[-3000:]}")
            for number in suspects:
                form[number] += 1
            tell(f"written in another way: {' '.join(map(str, suspects))}")

    def measure(self, kinds: tuple[str, ...], tell) -> None:
        """Time of the tests of each file without an error, and which errors they come by; kept for files that have not changed."""
        kept_in = self.home / f"tests_{self.folder.name}.json"
        kept = json.loads(kept_in.read_text()) if kept_in.exists() else {}
        shared = digest(json.dumps({str(number): mutant.key for number, mutant in sorted(self.inside.items())}),
                        *(self.texts[name] for name in sorted(self.texts)),
                        *(path.read_text() for path in sorted((self.tree / "tests").rglob("*.hpp"))))

        def once(path: pathlib.Path) -> tuple[str, dict]:
            name = path.relative_to(self.tree / "tests").as_posix()
            key = digest(shared, path.read_text())
            if name in kept and kept[name]["key"] == key:
                return name, kept[name]
            reached = self.home / f"reached_{key}.txt"
            begin = time.monotonic()
            code, output = run([self.tests, "--gtest_brief=1", f"--gtest_filter={name}"], 1800.0,
                               env=os.environ | {REACHED: str(reached)})
            numbers = sorted({int(line) for line in reached.read_text().split()}) if reached.exists() else []
            reached.unlink(missing_ok=True)
            if code != 0:
                tell(f"{name} is left out: it fails without any error\n{output[-800:]}")
            return name, {"key": key, "seconds": time.monotonic() - begin, "passes": code == 0, "reached": numbers}

        paths = sorted(path for kind in kinds for path in (self.tree / "tests" / kind).rglob("*_test.cpp")
                       if self.program or not re.search(r"/tests/\w+/app_", path.as_posix()))
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for name, entry in pool.map(once, paths):
                if entry["passes"] and kept.get(name) != entry:  # one that fails is asked again
                    kept[name] = entry
                    kept_in.write_text(json.dumps(kept))
                self.files[name] = TestFile(name.split("/")[0], entry["seconds"], entry["reached"], entry["passes"])

    def order(self, mutant: Mutant, number: int, kinds: tuple[str, ...]) -> list[str]:
        """Files of tests of these kinds that come by the error: those of its own folder and the quick ones first."""
        folder = pathlib.PurePosixPath(mutant.file).parent.name
        names = [name for name, file in self.files.items()
                 if file.passes and file.kind in kinds and (number not in self.inside or number in file.reached)]

        def rank(name: str):
            file = self.files[name]
            own = f"/{folder}/" in name or pathlib.PurePosixPath(mutant.file).stem in name
            return (file.seconds > 5.0, not own, file.seconds)

        return sorted(names, key=rank)

    def finder(self, mutant: Mutant, number: int, kinds: tuple[str, ...]) -> tuple[str, str, int]:
        """Kind and name of the first test that fails, crashes or does not end, and how many files were asked."""
        names = self.order(mutant, number, kinds)
        for asked, name in enumerate(names, 1):
            file = self.files[name]
            code, output = run([self.tests, "--gtest_fail_fast", f"--gtest_filter={name}"],
                               LEAST_PATIENCE + PATIENCE * file.seconds, env=os.environ | {CHOICE: str(number)})
            if code != 0:
                failed = re.findall(r"\[  FAILED  \] ([^\s,]+)", output)
                begun = re.findall(r"\[ RUN      \] (\S+)", output)
                test = failed[0] if failed else begun[-1] if begun else "?"
                how = "" if failed else " (did not end)" if code == 124 else " (crashed)"
                return file.kind, f"{name}: {test}{how}", asked
        return "none", "", len(names)

    def make_program(self) -> None:
        if not self.make("orbearing_tests", "orbearing", "orbearing_machine_run", "orbearing_fmu_loader"):  # others check the sources
            raise RuntimeError(f"the program does not build:\n{self.log[-3000:]}")

    def recorded(self, *words: str, seconds: float = 600.0, **environment: str) -> tuple[int, str]:
        """The test of recorded answers (tests/interface/recorded_results.py), of the copy's program."""
        return run([sys.executable, self.tree / RECORDED, *words, "--jobs", "1"], seconds,
                   env=os.environ | {"ORBEARING": str(self.folder / "bin" / "orbearing"), "ORBEARING_SOURCE_DIR": str(self.tree)} | environment)

    def measure_recorded(self, tell) -> None:
        """Time of each recorded answer without an error, and which errors it comes by; kept for commands that have not changed."""
        self.make_program()
        kept_in = self.home / "recorded.json"
        kept = json.loads(kept_in.read_text()) if kept_in.exists() else {}
        folder = (self.tree / RECORDED).parent
        shared = digest(json.dumps({str(number): mutant.key for number, mutant in sorted(self.inside.items())}),
                        *(self.texts[name] for name in sorted(self.texts)), (folder / "recorded_results.txt").read_text(),
                        *(path.read_text() for path in sorted(folder.glob("recorded_*.py"))), (folder / "recorded_results.json.xz").read_bytes().hex())
        if kept.get("shared") != shared:
            kept = {"shared": shared, "commands": {}}
            for line in self.recorded("--list")[1].splitlines():
                number, command = line.split(" ", 1)
                reached = self.home / "reached_recorded.txt"
                begin = time.monotonic()
                code, output = self.recorded("--only", number, **{REACHED: str(reached)})
                seconds = time.monotonic() - begin
                if code != 0:
                    tell(f"recorded answer {number} is left out: it differs without any error\n{output[-800:]}")
                kept["commands"][number] = {"command": command, "seconds": seconds, "passes": code == 0,
                                            "reached": sorted({int(one) for one in reached.read_text().split()}) if reached.exists() else []}
                reached.unlink(missing_ok=True)
            kept_in.write_text(json.dumps(kept))
        self.answers = {number: one for number, one in kept["commands"].items() if one["passes"]}

    def recorded_finder(self, number: int) -> tuple[str, str, int]:
        """The recorded answer that differs with the error, of those that come by it, the quick ones first."""
        asked = sorted((one for one, entry in self.answers.items() if number not in self.inside or number in entry["reached"]),
                       key=lambda one: self.answers[one]["seconds"])
        if not asked:
            return "none", "", 0
        patience = LEAST_PATIENCE + PATIENCE * sum(self.answers[one]["seconds"] for one in asked)
        code, output = self.recorded("--only", *asked, seconds=patience, **{CHOICE: str(number)})
        if code == 0:
            return "none", "", len(asked)
        return "interface", f"recorded_results: {output.splitlines()[0] if output else '?'}{' (did not end)' if code == 124 else ''}", len(asked)

    def interface_finder(self, number: int, tell, quick: bool = False) -> tuple[str, str]:
        """The same of the tests of the program from outside, which are asked last: they take minutes, but for the messages."""
        self.make_program()
        messages, left_out = "^interface.messages$", ["windows", "wine", "recorded_results"]
        for chosen in (messages,) if quick else (messages, "^interface"):
            for _ in range(20):
                ctest = ["ctest", "--test-dir", self.folder, "-L", "^interface$", "-R", chosen, "-E", "|".join(left_out), "--stop-on-failure",
                         "-j", str(self.jobs)]
                _, output = run(ctest, 3600.0, env=os.environ | {CHOICE: str(number)})
                failed = re.findall(r"^\t *\d+ - (\S+) \((?!Skipped|Not Run)", output, re.MULTILINE)
                for name in failed:
                    again, _ = run(["ctest", "--test-dir", self.folder, "-R", f"^{re.escape(name)}$"], 3600.0, env=os.environ | {CHOICE: "-1"})
                    if again == 0:
                        return "interface", name
                    tell(f"{name} is left out: it fails without any error")
                    left_out.append(f"^{re.escape(name)}$")
                if not failed:
                    break
            left_out.append(messages)
        return "none", ""

    def judge_alone(self, mutant: Mutant, quick: bool = False) -> tuple[str, str, int]:
        """Of an error that cannot stand beside the right statement: built by itself. "no program" where it does not compile."""
        inside, self.inside = self.inside, {}
        kept = (self.tree / mutant.file).read_text(encoding="utf-8")
        (self.tree / mutant.file).write_text(with_error(self.texts[mutant.file], mutant), encoding="utf-8")
        try:
            # One file is asked first: most slips of the pen do not compile, and a build of all takes minutes.
            if not self.compiles(mutant) or not self.make():
                return "no program", "", 0
            asked = 0
            for kinds in STAGES[:1] if quick else STAGES:
                kind, test, more = self.finder(mutant, -1, kinds)
                asked += more
                if kind != "none":
                    break
            if kind == "none" and self.program and self.answers:
                self.make_program()
                kind, test, more = self.recorded_finder(-1)
                asked += more
            return kind, test, asked
        finally:
            (self.tree / mutant.file).write_text(kept, encoding="utf-8")
            self.inside = inside

    def commands(self, file: str) -> list[tuple[pathlib.Path, list[str]]]:
        """Commands that compile a source, or those that include a header, to `out.o` in home: nearest first, not in batches."""
        entries = json.loads((self.folder / "compile_commands.json").read_text())
        library = "analysis" if file.startswith("coupling/analysis/") else file.split("/")[0]
        command = next((shlex.split(entry["command"]) for entry in entries
                        if re.search(rf"/orbearing_{library}(_case|_core)?\.dir/", entry["command"]) and "instruction" not in entry["command"]
                        and "-mavx" not in entry["command"] and "cmake_pch" not in entry["file"]), None)
        if command is None:
            return []
        if file.endswith(".cpp"):
            names = [file]
        else:
            stems = [name for name in self.texts if name.endswith(".cpp") and f'#include "{file}"' in self.texts[name]]
            own = file[:-4] + ".cpp"
            names = sorted(stems, key=lambda name: (name != own, name))[:6]
        drop = {"-o", "-c", "-MF", "-MT", "-MQ", "-include"}  # the last: headers that are precompiled with the options of a batch
        kept, skip = [], False
        for word in command:
            if skip:
                skip = False
            elif word in drop:
                skip = True
            elif word not in ("-MD", "-MMD", "-Winvalid-pch") and not word.endswith("ccache"):
                kept.append(word)
        views = [f"-I{self.folder}/view/{one}" for one in ("mechanics", "gearset", "bearing", "coupling", "app", "page")]
        return [(self.tree / name, [*kept, *views, "-w", "-g0", "-c", str(self.tree / name)]) for name in names]

    def compiles(self, mutant: Mutant) -> bool:
        """Whether the copy's file as it stands compiles, asked of one source; True where none is known."""
        for _, command in self.commands(mutant.file)[:1]:
            return run([*command, "-fsyntax-only"], 600.0, cwd=self.folder)[0] == 0
        return True

    def same_program(self, mutant: Mutant) -> bool:
        """Whether the compiler makes the same object code with and without the error, in each source that includes it."""
        path = self.tree / mutant.file
        kept, times = path.read_text(encoding="utf-8"), path.stat()
        commands = self.commands(mutant.file)
        try:
            for _, command in commands:
                objects = []
                for text in (self.texts[mutant.file], with_error(self.texts[mutant.file], mutant)):
                    path.write_text(text, encoding="utf-8")
                    out = self.home / "out.o"
                    code, _ = run([*command, "-o", str(out)], 900.0, cwd=self.folder)
                    if code != 0:
                        return False
                    objects.append(out.read_bytes())
                if objects[0] != objects[1]:
                    return False
            return bool(commands)
        finally:  # nothing was built meanwhile, and need not be built for this
            path.write_text(kept, encoding="utf-8")
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
