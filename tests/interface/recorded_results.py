#!/usr/bin/env python3
"""Answers of the program are those on record: the commands of recorded_results.txt, one a line, run every day.

An answer is reduced to counts, weighted sums and sums of magnitudes by the path of their keys (recorded_reduction.py). A failure names the
command, the path, what the record has and what was found. A record is no proof: a change of a result that is meant is recorded anew.

    recorded_results.py                            compares with recorded_results.json.xz
    recorded_results.py --record                   writes that file
    recorded_results.py --list                     the commands with their numbers
    recorded_results.py --only 3 14                compares these alone; ends at the first that differs
    recorded_results.py --times                    processor time of each command
    recorded_results.py --whole --record FILE      every case with every command that takes it, broken cases, changed inputs
    recorded_results.py --whole --compare FILE     what that record holds, again (recorded_whole.py); some ten minutes of one core
"""

import argparse
import concurrent.futures
import contextlib
import dataclasses
import json
import lzma
import math
import os
import pathlib
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time

import recorded_whole
from program import LEFT_TO_FULL
from recorded_reduction import FOLDER, differences, is_number, reduced_run, spread_of

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
HERE = pathlib.Path(__file__).resolve().parent
COMMANDS, RECORD = HERE / "recorded_results.txt", HERE / "recorded_results.json.xz"
SHOWN, SHOWN_OF_WHOLE = 40, 5000  # differences of one comparison
SECONDS = 120.0  # of the processor, of one command
PATIENCE = 30.0  # times as long on the wall as of the processor
THEN = "&&"  # between commands of one line, which share a folder; what the last one answers counts
# What may change round-off alone: (environment, words). One that a case or a processor does not have is left out.
SAME_ANSWER = (({"ORBEARING_INSTRUCTION_SET": "baseline"}, ()), ({"ORBEARING_INSTRUCTION_SET": "avx2"}, ()),
               ({}, ("--set", "material.poisson_ratio=0.30000000000001")))


@dataclasses.dataclass(frozen=True)
class Entry:
    """`name`: the line that it is written as; `text`: content of a case of its own, if it has no file."""

    name: str
    words: tuple
    text: str = ""


def entry_of(line):
    """`run $reducer_150kW "input.power=75 kW" --fidelity dynamic`: settings as words with '='; `text run ...`: printed without --json."""
    words = shlex.split(line)
    words = words[1:] if words[0] == "full" else words
    as_text = words[0] == "text"
    words = words[1:] if as_text else words
    made = [words[0]]
    for word in words[1:]:
        if word == THEN and not as_text:
            made.append("--json")
        if word.startswith("$"):
            made.append(str(case_file(word[1:])))
        elif re.match(r"[a-z_A-Z0-9.]+=", word) and made[-1] not in ("--over", "--vary"):
            made += ["--set", word]
        else:
            made.append(word)
    return Entry(line, (*made, *(() if as_text else ("--json",))))


def case_file(name):
    for folder in (SOURCE / "cases", SOURCE / "cases" / "validation"):
        if (folder / name / "case.yaml").exists():
            return folder / name / "case.yaml"
    for file in (SOURCE / "cases" / "templates" / f"{name}.yaml", HERE / "recorded_cases" / f"{name}.yaml", HERE / "recorded_cases" / name):
        if file.exists():
            return file
    raise FileNotFoundError(f"no case {name}")


def daily():
    lines = [line.strip() for line in COMMANDS.read_text(encoding="utf-8").splitlines()]
    # Builds under sanitizers have no library of our FMUs.
    without = () if (pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1] / "lib/orbearing/fmu/linux64").exists() else ("fmu ", "full text fmu ")
    return [entry_of(line) for line in lines if line and not line.startswith(("#", *without))]


def ended(entry, folder, seconds=SECONDS, environment=None):
    """The process of a command, or nothing where it had to be ended. FOLDER in its words is a folder of its own, whose files are reduced too."""
    if entry.text:
        (pathlib.Path(folder) / "case.yaml").write_text(entry.text, encoding="utf-8")
    words, done = [word.replace(FOLDER, folder) for word in entry.words], None
    while words and (done is None or done.returncode == 0):
        end = words.index(THEN) if THEN in words else len(words)
        command, words = words[:end], words[end + 1:]
        done = within(seconds, [os.environ["ORBEARING"], *command], folder, os.environ | {"COLUMNS": "100", "LC_ALL": "C.UTF-8"} | (environment or {}))
    return done


def within(seconds, command, folder, environment):
    """The ended process; nothing where it takes more time of the processor, or waits much longer. On a busy machine a clock on the wall tells nothing."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True, errors="replace", cwd=folder,
                               env=environment)
    with contextlib.suppress(ProcessLookupError):
        resource.prlimit(process.pid, resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds)))
    try:
        out, err = process.communicate(timeout=PATIENCE * seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return None
    return None if process.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else subprocess.CompletedProcess(command, process.returncode, out, err)


def answers_of(entries, jobs, seconds=SECONDS, environment=None, with_words=True):
    """(entry, answer) in their order. Commands run beside each other; reduced is here alone, since netCDF takes one thread."""
    begin = time.monotonic()

    def run(entry):
        folder = tempfile.TemporaryDirectory()
        return folder, ended(entry, folder.name, seconds, environment)

    pool = concurrent.futures.ThreadPoolExecutor(jobs)
    try:
        for number, (entry, (folder, done)) in enumerate(zip(entries, pool.map(run, entries)), 1):
            answer = {"time": "limit"} if done is None else reduced_run(done, pathlib.Path(folder.name), SOURCE, "--json" in entry.words, with_words)
            folder.cleanup()
            if sys.stderr.isatty() or number % 250 == 0:
                print(f"\r{number} of {len(entries)}, {time.monotonic() - begin:.0f} s ", end="", file=sys.stderr, flush=True)
            yield entry, answer
    finally:  # where the first that differs is enough
        pool.shutdown(cancel_futures=True)


def recorded(entries, jobs, seconds, variations=SAME_ANSWER, with_words=True):
    """Answers by name, with the spread of what answers the same."""
    answers = {entry.name: answer for entry, answer in answers_of(entries, jobs, seconds, None, with_words)}
    others = {name: [] for name in answers}
    for environment, words in variations:
        changed = [dataclasses.replace(entry, words=(*entry.words, *words)) for entry in entries if answers[entry.name].get("exit") == 0]
        for entry, answer in answers_of(changed, jobs, seconds, environment, with_words):
            # Another input is named among what the case states: its numbers alone count.
            kept = {path: one for path, one in answer.get("found", {}).items() if not words or is_number(one)}
            others[entry.name].append(answer | {"found": (answers[entry.name].get("found", {}) if words else {}) | kept})
    for name, answer in answers.items():
        if spread := spread_of(answer, others[name]):
            answer["spread"] = spread
    return answers


def with_commands(entries, answers):
    """Of the whole corpus a record holds what was run, too: new cases change what is drawn."""
    for entry in entries:
        answers[entry.name] |= {"command": [word.replace(str(SOURCE), "SOURCE") for word in entry.words], "text": entry.text}


def commands_of(answers):
    return [Entry(name, tuple(word.replace("SOURCE", str(SOURCE)) for word in one["command"]), one["text"]) for name, one in answers.items()]


def written(file, answers):
    text = json.dumps(answers, indent=0, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    file.write_bytes(lzma.compress(text.encode(), preset=9 | lzma.PRESET_EXTREME))


def read(file):
    return json.loads(lzma.decompress(file.read_bytes()))


def compare(entries, recorded, jobs, first=False, seconds=SECONDS, with_words=True):
    """Prints what differs; the number of commands that do."""
    shown = differing = limited = 0
    most = SHOWN if with_words else SHOWN_OF_WHOLE
    for entry, found in answers_of(entries, jobs, seconds, None, with_words):
        expected = recorded.get(entry.name)
        if "time" in found or "time" in (expected or {}):
            limited += 1
            continue
        texts = ["is not on record; `recorded_results.py --record`"] if expected is None else list(differences(expected, found))
        differing += bool(texts)
        for text in texts:
            shown += 1
            if shown <= most:
                print(f"{entry.name}\n    {text}", flush=True)
        if first and texts:
            break
    left_out = ("fmu ", "full text fmu ", *(("full ",) if LEFT_TO_FULL else ()))
    gone = {name for name in recorded if not name.startswith(left_out)} - {entry.name for entry in entries}
    if shown > most:
        print(f"... {shown - most} more differences")
    print(f"{len(entries)} commands: {differing} differ" + (f", {limited} reached the time limit" if limited else ""))
    return differing, gone


def times_of(entries):
    for number, entry in enumerate(entries):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        answer = dict(answers_of([entry], 1))[entry]
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        print(f"{used:6.2f} s  exit {answer.get('exit')}  {number}  {entry.name}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--record", nargs="?", const=RECORD, type=pathlib.Path, metavar="FILE")
    parser.add_argument("--compare", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--times", action="store_true")
    parser.add_argument("--only", type=int, nargs="+", metavar="N")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seconds", type=float, default=SECONDS, help="limit of the processor time of each command")
    choice = parser.parse_args()
    if choice.whole:
        entries = commands_of(read(choice.compare)) if choice.compare else recorded_whole.entries(SOURCE, Entry)
    else:
        entries = daily()
    if choice.whole and choice.seconds == SECONDS:
        choice.seconds = recorded_whole.SECONDS
    if choice.list:
        print("\n".join(f"{number} {entry.name}" for number, entry in enumerate(entries)))
        return 0
    names = {entry.name for entry in entries}
    if LEFT_TO_FULL and not (choice.only or choice.record or choice.whole):
        entries = [entry for entry in entries if not entry.name.startswith("full ")]
    if choice.only:
        entries = [entries[number] for number in choice.only]
    if choice.times:
        times_of(entries)
        return 0
    if choice.record:
        answers = recorded(entries, choice.jobs, choice.seconds, SAME_ANSWER[:1] if choice.whole else SAME_ANSWER, not choice.whole)
        if choice.whole:
            with_commands(entries, answers)
        kept = {name: answer for name, answer in read(choice.record).items() if name in names} if choice.only else {}
        written(choice.record, kept | answers)
        return 0
    differing, gone = compare(entries, read(choice.compare or RECORD), choice.jobs, bool(choice.only), choice.seconds, not choice.whole)
    if gone and not choice.only:
        print("on record and no longer run:", *sorted(gone)[:SHOWN], sep="\n    ")
    return int(bool(differing or (gone and not choice.only)))


if __name__ == "__main__":
    if "ORBEARING" not in os.environ:
        print("skipped: ORBEARING does not name the program")
        sys.exit(77)
    sys.exit(main())
