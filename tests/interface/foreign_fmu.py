#!/usr/bin/env python3
"""A planet that a tool which is not ours exported, with FMI 2.0 and 3.0, drives our bearing: as our own planet does.

Needs ORBEARING (for the build folder), ORBEARING_SOURCE_DIR and ORBEARING_FOREIGN_DRIVE. Skipped where the exporters
(PyPI: pythonfmu, pythonfmu3) or the shared library of Python, in which their FMUs run, are missing.
"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from virtual_environment import interpreter_with, python_library, skip

FOREIGN = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"], "tests", "foreign")
EXPORTERS = {2: ("pythonfmu", "pythonfmu==0.7.0"), 3: ("pythonfmu3", "pythonfmu3==0.3.4")}
# [-] Two programs round unlike; rollers that come and go multiply that by less than 1e5 in 0.3 ms.
ROUND_OFF = 1e-9
# Held forces are of order 2 in the window; the error of the exchange, of order 2 as well, stirs the ratio of two
# windows, one half of the other.
RATIO = (2.5, 6.0)
ITERATED = 3  # passes
# [m] Windows that end a rounding apart may be cut into other steps, each of which may err by so much.
STEP_ERROR = 2e-10
# Of a quarter of the window: at least order 1, which is that of the damping, whose velocity is half a window old.
HELD_RATIO = 4.0


def planet_fmu(version, folder):
    module, package = EXPORTERS[version]
    python = interpreter_with(package)
    subprocess.run([python, "-m", module, "build", "-f", FOREIGN / f"planet_fmi{version}.py", "-d", folder,
                    "--handle-state", "--serialize-state", FOREIGN / "planet_motion.py"],
                   check=True, capture_output=True)
    return pathlib.Path(folder, "PlanetModel.fmu")


def drive(version):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([os.environ["ORBEARING_FOREIGN_DRIVE"], planet_fmu(version, folder), LIBRARY],
                              capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()]


def own(version):
    with tempfile.TemporaryDirectory() as folder:
        fmu = pathlib.Path(folder, "bearing.fmu")
        case = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"], "cases", "reducer_150kW", "case.yaml")
        subprocess.run([os.environ["ORBEARING"], "fmu", case, "-o", fmu, "--fmi", str(version), "--quiet"], check=True,
                       capture_output=True)
        done = subprocess.run([os.environ["ORBEARING_OWN_DRIVE"], fmu], capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()]


def distance(runs, first, second):
    return [max(abs(a - b) for a, b in zip(run[first], run[second])) for run in runs]


class ForeignPlanet(unittest.TestCase):
    def check(self, version):
        runs = drive(version)
        self.assertEqual(len(runs), 6)
        way = max(abs(value) for run in runs for value in run["held"])
        print(f"FMI {version}.0: from our own planet at most {max(distance(runs, 'foreign', 'held')) / way:.1e}")
        self.assertLess(max(distance(runs, "foreign", "held")), ROUND_OFF * way)
        errors = distance([run for run in runs if run["passes"] == ITERATED], "foreign", "following")
        print("  held forces against those of a course [m], window 10, 5, 2.5 us:", *(f"{e:.2e}" for e in errors))
        for longer, shorter in zip(errors, errors[1:]):
            self.assertGreater(longer / shorter, RATIO[0])
            self.assertLess(longer / shorter, RATIO[1])

    def test_of_fmi_2_drives_our_bearing_as_our_own_does(self):
        self.check(2)

    def test_of_fmi_3_drives_our_bearing_as_our_own_does(self):
        self.check(3)


class OwnBearing(unittest.TestCase):
    def distances(self, version):
        runs = own(version)
        self.assertEqual([run["fmi"] for run in runs], [version] * 3)
        print(f"our bearing by FMI {version}.0, from the machine inside [m], window 4, 2, 1 us:",
              *(f"{run['distance_m']:.1e}" for run in runs), f"of {runs[-1]['way_m']:.1e}")
        return [run["distance_m"] for run in runs], runs[-1]["way_m"]

    def test_by_fmi_2_is_the_machine_inside(self):
        distances, way = self.distances(2)
        self.assertLess(max(distances), STEP_ERROR)
        self.assertLess(min(distances), ROUND_OFF * way)

    def test_by_fmi_3_without_slopes_comes_near_it(self):
        (longest, _, shortest), way = self.distances(3)
        self.assertGreater(longest / shortest, HELD_RATIO)
        self.assertLess(longest, 1e-2 * way)


if __name__ == "__main__":
    LIBRARY = python_library() or skip("no shared library of this Python (Debian: libpython3.11)")
    for _, needed in EXPORTERS.values():
        interpreter_with(needed)
    unittest.main()
