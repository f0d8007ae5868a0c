"""The program as the interface tests call it, and the cases that they call it with."""

import contextlib
import importlib
import io
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

# Whoever started the tests may ignore Ctrl-C, as a shell does for work in the background: programs that a test starts do not.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

CASES = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases"
REDUCER = CASES / "reducer_150kW" / "case.yaml"
SETS = CASES / "three_sets_150kW" / "case.yaml"
WIND = CASES / "wind_stage_750kW" / "case.yaml"
SECONDS = 600
# A report runs the gears at forty speeds between those of its sweep, at one alone of a sweep of one: so briefly where no settled means are asked for.
BRIEF_GEARS = ("gearset.dynamics.observed_periods=8", "gearset.dynamics.settling_periods=100")
# Tests that repeat the daily ones in more circumstances, or try our files in more programs of others.
LEFT_TO_FULL = os.environ.get("ORBEARING_FULL") == "no"  # as tools/test sets it; by hand all is run


def package():
    """The Python package of the build; ends the test as skipped where there is none, as under a sanitizer."""
    folder = pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1] / "python"
    if not (folder / "orbearing").exists():
        print("skipped: the build has no Python package (ORBEARING_BUILD_PYTHON)")
        sys.exit(77)
    sys.path.insert(0, str(folder))
    sys.modules.pop("orbearing", None)  # that of the source tree
    return importlib.import_module("orbearing")


def run(*arguments):
    command = [os.environ["ORBEARING"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


class InFolder(unittest.TestCase):
    """Tests that write cases into a folder of their own."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def case(self, text):
        file = self.folder / "case.yaml"
        file.write_text(text, encoding="utf-8")
        return file


def within(main, *arguments):
    """As `run`, of a command that Python carries out: in this process, which has loaded its packages once."""
    said, complained = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complained):
        try:
            code = main([*map(str, arguments)])
        except SystemExit as end:
            code = end.code
    return subprocess.CompletedProcess(arguments, code, said.getvalue(), complained.getvalue())


def wait_until_it_computes(process, seconds):
    """Until the program catches Ctrl-C and has had so much of the processor: on a busy machine that is later. Returns where it ends before."""
    def catches():
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
        caught = next(line.split()[1] for line in status.splitlines() if line.startswith("SigCgt:"))
        return int(caught, 16) >> (signal.SIGINT - 1) & 1

    def of_the_processor():
        words = pathlib.Path(f"/proc/{process.pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
        return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

    while process.poll() is None and not (catches() and of_the_processor() > seconds):
        time.sleep(0.01)


def settings(values):
    return [word for value in values for word in ("--set", value)]


def answer(command, case, *values, options=()):
    """What the program prints with --json; it must succeed."""
    result = run(command, case, "--json", *options, *settings(values))
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def warned(result, text):
    return any(text in warning for warning in result["warnings"])
