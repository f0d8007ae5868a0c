"""Runs of the program whose computing time and memory are of interest."""
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

# The complete model of a planet bearing: what cases/reducer_150kW leaves out, as its source does.
COMPLETE = ["film.enabled=true"]
# What commit d33b5f5 does not know of it.
COMPLETE_SINCE = ["contact.squeeze=true", "bearing.cage.pocket_film=hydrodynamic"]


class Run:
    """One run: `result` [parsed JSON], `cpu` [s] of all its threads, `wall` [s], `peak_MB` resident."""

    def __init__(self, program, arguments):
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "output")
            errors = os.path.join(folder, "errors")
            command = [program, *arguments, "--json", "--quiet", "-o", os.path.join(folder, "result")]
            began = time.monotonic()
            with open(output, "w") as out, open(errors, "w") as err:
                process = subprocess.Popen(command, stdout=out, stderr=err)
                _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            self.wall = time.monotonic() - began
            if process.returncode != 0:
                with open(errors) as text:
                    raise RuntimeError(f"{' '.join(command)}: {text.read().strip()}")
            with open(output) as text:
                self.result = json.load(text)
        self.cpu = usage.ru_utime + usage.ru_stime
        self.peak_MB = usage.ru_maxrss / 1024.0


def settings(values):
    return [word for value in values for word in ("--set", value)]


def one_system(revolutions):
    """Settings under which one system does two cage revolutions that are not looked at, then `revolutions` that are:
    all last as long as at the kinematic speed, in every version."""
    return [f"simulation.observed_revolutions={revolutions}", "simulation.most_revolutions=2",
            "simulation.load_drift=1e-9"]


def middle(values):
    """Median, lower and upper quartile (the extremes of less than three)."""
    if len(values) < 3:
        return statistics.median(values), min(values), max(values)
    quarters = statistics.quantiles(values, n=4, method="inclusive")
    return quarters[1], quarters[0], quarters[2]


def say(text):
    print("bench:", text, file=sys.stderr, flush=True)
