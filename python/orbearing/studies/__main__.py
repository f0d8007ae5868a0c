"""`orbearing study CASE -o DIR`: many variants of a case in one store; `python3 -m orbearing.studies` is the same.

Exit codes as of the command line: 0 done, 1 the computation failed, wholly or at some points, or a package is missing, 2 bad input or usage.
"""

from __future__ import annotations

import argparse
import os
import re
import signal
import sys
import time
from pathlib import Path

from orbearing.errors import MOST_THREADS, CaseError
from orbearing.terminal import Parser, StatusLine, exit_code, finished, settings_of, stated, whole_number

MOST_ROWS = 40  # of variants on a terminal


def parser() -> argparse.ArgumentParser:
    """The options; their names are those of the other commands where they mean the same."""
    made = Parser(prog="orbearing study", allow_abbrev=False,
                  description="Compute many variants of a case, each over the speeds of its own sweep, into one file: DIR/study.nc.")
    made.add_argument("case", metavar="CASE", type=stated, help="case file")
    made.add_argument("-o", "--output", metavar="DIR", help="folder of the study; created if missing. Optional with --json: nothing is written without it")
    made.add_argument("--vary", metavar="PATH=[...]", action="append", default=[],
                      help="path=[value, value] or path={from: ..., to: ..., step: ...} (or count: ...); for a sample path={from: ..., to: ...}, or a list of "
                           "equally likely values; repeatable")
    made.add_argument("--table", type=stated, metavar="ROWS.csv", help="rows of values that are varied together, in addition to --vary; the head names their paths: "
                                                          "\"path\" over values with their units, or \"path (unit)\" over numbers")
    made.add_argument("--sampler", choices=("grid", "sobol", "lhs"), default="grid", help="use of --vary: all combinations (grid, default), scrambled Sobol points, or a Latin hypercube")
    made.add_argument("--samples", type=whole_number(1), help="number of samples of sobol (a power of two) and lhs")
    made.add_argument("--seed", type=whole_number(0), help="seed of sobol and lhs; default: 1")
    made.add_argument("--points", choices=("none", "peak", "all"), default="none", help="points with a separate file DIR/points/*.nc; default: none")
    made.add_argument("--fidelity", choices=("quasi-static", "dynamic", "co-simulated", "monolithic"), default="quasi-static", help="as for sweep; default: quasi-static")
    made.add_argument("--jobs", type=whole_number(1, MOST_THREADS), help="threads; default: one for each core")
    made.add_argument("--scheduler", type=_address, metavar="tcp://HOST:PORT", help="Dask scheduler of the workers for the computation")
    made.add_argument("--resume", action="store_true", help="continue in DIR with the missing points")
    made.add_argument("--set", metavar="PATH=VALUE", dest="settings", action="append", default=[], help="replace one independent value; repeatable")
    made.add_argument("--json", action="store_true", help="print only the result, as one JSON object")
    made.add_argument("--quiet", action="store_true", help="print errors only")
    return made


def _address(text: str) -> str:
    """HOST:PORT, with or without the protocol."""
    found = re.fullmatch(r"(?:[a-z]+://)?[\w.\[\]:%-]+:([0-9]{1,5})", stated(text), re.ASCII)
    if not found or not 0 < int(found[1]) < 65536:
        raise argparse.ArgumentTypeError(f"found {text!r}; the address that dask scheduler prints is required, as tcp://host:8786")
    return text


def varied(options: list[str]) -> dict:
    """Paths and values of --vary. Raises CaseError with every mistake."""
    from orbearing.studies.design import stated_values

    found, mistakes = {}, []
    for option in options:
        path, equals, text = option.partition("=")
        path = path.strip()
        try:
            if not path or not equals:
                raise ValueError("a path and its values are required")
            values = stated_values(text)
        except ValueError as error:
            mistakes.append(f"--vary: found '{option}'; required: path=[value, value] or path={{from: ..., to: ..., step: ...}} ({error}), e.g. --vary "
                            "\"bearing.radial_clearance=[0 um, 10 um]\"")
            continue
        if path in found:
            mistakes.append(f"--vary: {path}: found twice; required: once")
        found[path] = values
    if mistakes:
        raise CaseError(mistakes)
    return found


def rows_of_table(file: Path) -> list[dict[str, str]]:
    """Rows of --table, by path. Raises CaseError with the line."""
    try:
        lines = [(number, line) for number, line in enumerate(_text_of(file).split("\n"), start=1) if line.strip(" \t\r,")]
    except OSError as error:
        raise CaseError(f"{file}: cannot be read ({error.strerror}); a CSV file is required") from error
    if len(lines) < 2:
        raise CaseError(f"{file}: found {max(len(lines) - 1, 0)} rows under a head; at least 1 is required")
    names = [name for name, _ in _cells(lines[0][1])]
    heads = [re.fullmatch(r"((?:[a-z]\w*)(?:\.[\w\[\]-]+)+)(?:\s*\((.+)\))?", name) for name in names]
    if not all(heads) or len({head[1] for head in heads if head}) < len(heads):
        # The content of a file that is no table of numbers is not shown.
        shown = f"the head '{', '.join(names)}'" if any(heads) else "a first line that names no paths"
        if any(";" in name for name in names):
            shown += " (semicolons in it: commas separate columns here, and decimals follow a point)"
        raise CaseError(f"{file}:{lines[0][0]}:1: found {shown}; required: each path once, as bearing.rollers or 'bearing.radial_clearance (um)'")
    rows, mistakes = [], []
    for number, line in lines[1:]:
        placed = _cells(line)
        cells = [cell for cell, _ in placed]
        if len(cells) != len(heads) or not all(cells):
            column = placed[len(heads)][1] if len(cells) > len(heads) else 1
            mistakes.append(f"{file}:{number}:{column}: found {sum(map(bool, cells))} values{_decimal_comma(cells, len(heads))}; "
                            f"required: {len(heads)}, one under each head")
        rows.append({head[1]: f"{cell} {head[2]}" if head[2] else cell for head, cell in zip(heads, cells)})
    if mistakes:
        raise CaseError(mistakes)
    return rows


def _text_of(file: Path) -> str:
    """The text of a file in UTF-8. Raises CaseError with the place of what is not."""
    content = file.read_bytes()
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise CaseError(f"{file}:1:1: found a file in UTF-16; required: a text file in UTF-8 (save it as UTF-8)")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line, column = content.count(b"\n", 0, error.start) + 1, error.start - content.rfind(b"\n", 0, error.start)
        raise CaseError(f"{file}:{line}:{column}: found a byte that is not UTF-8; "
                        "required: a text file in UTF-8") from error


def _cells(line: str) -> list[tuple[str, int]]:
    """The values of a line and their columns, from 1."""
    found, begin, quoted = [], 0, False
    for place, letter in enumerate(line + ","):
        if letter == '"':
            quoted = not quoted
        if place == len(line) or (letter == "," and not quoted):
            text = line[begin:place]
            cell = text.strip()
            if len(cell) > 1 and cell[0] == cell[-1] == '"':
                cell = cell[1:-1].replace('""', '"').strip()
            found.append((cell, begin + 1 + len(text) - len(text.lstrip())))
            begin = place + 1
    return found


def _decimal_comma(cells: Sequence[str], columns: int) -> str:
    """What to say of surplus values that can be the decimals of others."""
    halves, place = 0, 0
    while place + 1 < len(cells):
        if re.fullmatch(r"[+-]?\d+", cells[place]) and re.fullmatch(r"\d+([eE].*)?", cells[place + 1]):
            halves, place = halves + 1, place + 1
        place += 1
    surplus = len(cells) - columns
    return " (a decimal comma splits a number in two: commas separate values here, decimals follow a point)" if 0 < surplus <= halves and not any("." in cell for cell in cells) else ""


def _checked(options: argparse.Namespace) -> None:
    """What contradicts itself. Raises CaseError with every mistake."""
    mistakes = []
    if options.output == "":
        mistakes.append("--output: found an empty name; required: a folder")
    elif options.output is None and not options.json:
        mistakes.append("--output: missing; required: a folder for the results, or --json to print them alone")
    for name, given in (("--resume", options.resume), ("--points", options.points != "none")):
        if given and not options.output:
            mistakes.append(f"{name}: found without --output; required: the folder of the study")
    if options.scheduler and options.jobs:
        mistakes.append("--jobs: found with --scheduler; required: one of both, since its workers have their own threads")
    for name, given in (("--samples", options.samples), ("--seed", options.seed)):
        if given is not None and options.sampler == "grid":
            mistakes.append(f"{name}: found with the sampler grid; required: --sampler sobol or lhs")
    if mistakes:
        raise CaseError(mistakes)


class _Line(StatusLine):
    """How far a study is, on a terminal."""

    def __init__(self, shown: bool):
        super().__init__(shown)
        self._begin = time.monotonic()
        self._kept: int | None = None

    def __call__(self, done: int, points: int) -> None:
        self._kept = done if self._kept is None else self._kept
        if not self.is_due:
            return
        text = f"{done} of {points} points done, {points - done} left"
        if self._kept < done < points:
            text += f", {_clock((time.monotonic() - self._begin) / (done - self._kept) * (points - done))} to go"
        self.show(f"study: {text}")


def _clock(seconds: float) -> str:
    whole = round(seconds)
    return f"{whole // 60}:{whole % 60:02}" if whole < 3600 else f"{whole // 3600}:{whole // 60 % 60:02}:{whole % 60:02}"


def _client(address: str):
    """A client of the scheduler. Raises CaseError where there is none, ImportError without Dask."""
    from distributed import Client

    try:
        return Client(address, timeout=10, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise CaseError(f"--scheduler: found '{address}', where no scheduler answers ({error}); required: the address that dask scheduler prints, as tcp://host:8786") from error


def print_variants(result) -> None:
    """A table for people."""
    variants = result.variants()
    units = {p.path: p.unit for p in result.design.parameters if p.unit not in ("", "1")}
    names = list(variants[0])
    heads = [f"{name} [{units[name]}]" if name in units else name for name in names]
    widths = [max(len(head), 10) for head in heads]
    print("  ".join(head.rjust(width) for head, width in zip(heads, widths)))
    for variant in variants[:MOST_ROWS]:
        print("  ".join(_cell(variant[name]).rjust(width) for name, width in zip(names, widths)))
    if len(variants) > MOST_ROWS:
        print(f"{len(variants) - MOST_ROWS} more variants are in study.nc")


def _cell(value) -> str:
    return "none" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)


def run(options: argparse.Namespace) -> int:
    """The study of the options; the exit code."""
    from orbearing import _core
    from orbearing.studies.result import json_of
    from orbearing.studies.run import study

    _checked(options)
    core = _core.load(options.case, settings_of(options.settings))
    paired = rows_of_table(Path(options.table)) if options.table else []
    values = varied(options.vary)
    line = _Line(not options.quiet and not options.json)
    client = _client(options.scheduler) if options.scheduler else None
    try:
        result = study(core, values, sampler=options.sampler, samples=options.samples, seed=1 if options.seed is None else options.seed, paired=paired,
                       fidelity=options.fidelity, executor=client or "threads", jobs=options.jobs or 0, output=options.output, resume=options.resume,
                       points=options.points, progress=line)
    finally:
        line.end()
        if client is not None:
            client.close(timeout=2)
    for reason, count in result.failures().items():
        print(f"{count} points: {reason}", file=sys.stderr)
    if options.json:
        print(json_of(result))
    elif not options.quiet:
        print_variants(result)
        for warning in result.warnings:
            print(f"warning: {warning}")
        print(f"governing life: {result.life_key}")
        if options.output:
            print(os.path.join(options.output, "study.nc"))
    return 1 if result.failed else 0


def main(arguments: list[str]) -> int:
    """Compute a study; messages go to standard error."""
    options = parser().parse_args(arguments)
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # a wish to stop, as SIGINT
    stays = f"; what is done stays in {options.output}, --resume continues" if options.output else ""
    packages = ("numpy, netCDF4, SciPy for samples, Dask for --scheduler; on Debian install python3-numpy python3-netcdf4 python3-scipy "
                "python3-distributed")
    return exit_code("study", lambda: run(options), packages, stays)


if __name__ == "__main__":
    sys.exit(finished(lambda: main(sys.argv[1:])))
