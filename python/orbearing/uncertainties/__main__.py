"""`orbearing uncertainty CASE -o DIR`; `python3 -m orbearing.uncertainties` is the same.

Exit codes as of the command line: 0 done, 1 the computation failed, wholly or at some points, 2 bad input or usage, or OpenTURNS is missing.
"""

from __future__ import annotations

import argparse
import signal
import sys
from pathlib import Path

from orbearing.errors import MOST_THREADS, CaseError
from orbearing.terminal import Parser, StatusLine, exit_code, finished, settings_of, stated, whole_number
from orbearing.uncertainties.design import METHODS
from orbearing.uncertainties.settings import Settings



def parser() -> argparse.ArgumentParser:
    """The options; their names are those of the other commands where they mean the same."""
    made = Parser(prog="orbearing uncertainty", allow_abbrev=False,
                  description="Uncertainty of the life of a case with uncertain inputs in its block 'uncertain:'. Results: bands of life over speed, speed and life of the peak, Sobol indices, and the value to measure first.")
    made.add_argument("case", metavar="CASE", type=stated, help="case file")
    made.add_argument("-o", "--output", metavar="DIR", help="folder of the results; created if missing. Optional with --json: nothing is written without it")
    made.add_argument("--samples", type=whole_number(2), default=Settings.samples, help="number of lives at the operating point; default: %(default)s")
    made.add_argument("--curves", type=whole_number(2), default=Settings.curves, help="number of curves of life over speed, each with its peak; default: %(default)s")
    made.add_argument("--index-samples", type=whole_number(2), default=Settings.index_samples,
                      help="number of rows of the design for the Sobol indices at the operating point, (inputs + 2) lives each; default: %(default)s")
    made.add_argument("--method", choices=METHODS, default=Settings.method,
                      help="independent points, a Latin hypercube, or Sobol's sequence shifted at random; default: %(default)s")
    made.add_argument("--seed", type=whole_number(0), default=Settings.seed, help="seed of all designs; default: %(default)s")
    made.add_argument("--speeds", type=stated, metavar="LIST", help="input speeds with their unit, separated by commas, e.g. \"3000 rpm, 6000 rpm\"; default: those of the case's sweep")
    made.add_argument("--life", type=stated, metavar="COLUMN", help="column of the life in the sweep's table; default: the governing life (life.method)")
    made.add_argument("--motion", type=whole_number(0), default=0, metavar="N", help="number of samples at percentiles of the life that are also computed in motion")
    made.add_argument("--jobs", type=whole_number(0, MOST_THREADS), default=0, help="threads; default: one for each core")
    made.add_argument("--resume", action="store_true", help="continue in DIR with the missing lives")
    made.add_argument("--set", metavar="PATH=VALUE", dest="settings", action="append", default=[], help="replace one independent value; repeatable")
    made.add_argument("--json", action="store_true", help="print only the result, as one JSON object")
    made.add_argument("--quiet", action="store_true", help="print errors only")
    return made


def _folder(options: argparse.Namespace) -> Path | None:
    """Where the results go. Raises CaseError where they would go nowhere."""
    if options.output is None:
        if not options.json:
            raise CaseError("--output: missing; required: a folder for the results, or --json to print them alone")
        if options.resume:
            raise CaseError("--resume: found without --output; required: the folder to continue")
        return None
    if not options.output:
        raise CaseError("--output: found an empty name; required: a folder")
    return Path(options.output)


def _speeds(core, text: str | None) -> tuple[float, ...] | None:
    from orbearing.uncertainties.lives import SPEED
    from orbearing.uncertainties.study import rpm

    return None if text is None else tuple(rpm(core.si(SPEED, one.strip())) for one in text.split(","))


class _Line(StatusLine):
    """How far a batch is, on a terminal."""

    def __call__(self, done: int) -> None:
        if self.is_due:
            self.show(f"uncertainty: {done} points of this batch done")


def print_result(data: dict) -> None:
    """Tables for people."""
    from orbearing.uncertainties.page import headline, summary_table

    print(headline(data))
    table = summary_table(data)
    width = max(len(str(row[0])) for row in [table.head, *table.rows])
    for row in [table.head, *table.rows]:
        print(f"  {row[0]:{width}}" + "".join(f"{_cell(value):>11}" for value in row[1:]))
    print("indices (95 %), the input to measure first on top:")
    rows = sorted(data["operating_point"]["indices"], key=lambda row: -row["first"])
    width = max((len(row["inputs"]) for row in rows), default=0)
    for row in rows:
        print(f"  {row['inputs']:{width}}  first {row['first']:6.3f} ({row['first_95'][0]:6.3f} to {row['first_95'][1]:6.3f})"
              f"  total {row['total']:6.3f} ({row['total_95'][0]:6.3f} to {row['total_95'][1]:6.3f})")
    for row in data["measure_first"]:
        print(f"{row['result']}: measure {row['measure']} first; the standard deviation of {_cell(row['standard_deviation'])} becomes "
              f"{_cell(row['expected_standard_deviation_after'])}, as expected")
    for row in data["motion"]:
        print(f"in motion, percentile {row['percentile']:g}: {_cell(row['dynamic_h'])} h, at rest {_cell(row['quasi_static_h'])} h ({row['status']})")
    for text in data["warnings"]:
        print(f"warning: {text}")


def _cell(value) -> str:
    return "none" if value is None else f"{value:,.0f}" if isinstance(value, float) and abs(value) >= 1000 else f"{value:.4g}" if isinstance(value, float) else str(value)


def run(options: argparse.Namespace) -> int:
    """The study of the options; the exit code."""
    from orbearing import _core
    from orbearing.uncertainties.parts import openturns, xarray
    from orbearing.uncertainties.study import of_case, open_store

    openturns()  # before any work
    folder = _folder(options)
    if folder:
        xarray()
    core = _core.load(options.case, settings_of(options.settings))
    settings = Settings(options.samples, options.curves, options.index_samples, options.seed, options.method, _speeds(core, options.speeds),
                        options.life, options.motion, options.jobs)
    line = _Line(not options.quiet and not options.json)
    store = open_store(folder, core, settings, options.resume) if folder else None
    try:
        result = of_case(core, settings, line, store)
        if folder:
            result.save(folder, core.resolved())
    finally:
        line.end()
        if store:
            store.close()
    if options.json:
        print(result.json(), end="")
    elif not options.quiet:
        print_result(result.data)
        print(folder / "uncertainty.html")
    if result.failed:
        print(f"uncertainty: {result.failed} points without a life", file=sys.stderr)
    return 1 if result.failed else 0


def main(arguments: list[str]) -> int:
    """Compute a study; messages go to standard error."""
    options = parser().parse_args(arguments)
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # a wish to stop, as SIGINT
    stays = f"; what is done stays in {options.output}, --resume continues" if options.output else ""
    packages = "numpy, matplotlib, OpenTURNS; on Debian install python3-numpy python3-matplotlib python3-openturns"
    return exit_code("uncertainty", lambda: run(options), packages, stays)


if __name__ == "__main__":
    sys.exit(finished(lambda: main(sys.argv[1:])))
