#!/usr/bin/env python3
"""A bearing in the process of a script: in a few lines of numpy, beside its FMU, and in Exudyn.

The first part needs no more than the Python package; that in Exudyn and beside FMPy is skipped where these cannot be had.
"""

# The live machine; its examples run as tests.
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import program
from virtual_environment import build_folder, environment

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
CASE = SOURCE / "cases" / "reducer_150kW" / "case.yaml"
PACKAGE = build_folder() / "python"
orbearing = program.package()
sys.path.insert(0, str(SOURCE / "docs" / "multibody"))
from live_planet import run  # noqa: E402

QUIET = 3e-6  # [m]  the planet sways by less than 1 um
BESIDE_ITS_FMU = """
import json, sys
import numpy as np, orbearing
from planet_bearing import Bearing, LiveBearing, duty_of, run_bearing
case = orbearing.load(sys.argv[1])
case.fmu(sys.argv[2])
duty = duty_of(case.check())
ways = []
for bearing in (Bearing(sys.argv[2]), LiveBearing(case)):
    rest = bearing.place_under(duty.static)
    ways.append(run_bearing(bearing, duty, rest, 300, 1e-6, "half a step ahead, slopes")[0])
    bearing.close()
print(json.dumps([float(np.abs(ways[0] - ways[1]).max()), float(np.ptp(ways[0], axis=0).max())]))
"""
IN_EXUDYN = """
import json, sys
import numpy as np
from exudyn_planet import bearing_and_duty, errors, run_exudyn
bearing, duty = bearing_and_duty(sys.argv[1])
found = {f"{solver}, {share}, {slopes}": row for (solver, share, slopes), row in errors(bearing, duty, (1e-6, 4e-6)).items()}
print(json.dumps(found))
"""


def in_environment(script, *packages):
    python, reason = environment(*packages)
    if reason:
        raise unittest.SkipTest(reason)
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([python, "-c", script, CASE, "bearing.fmu"], capture_output=True, text=True, cwd=folder,
                              env={**os.environ, "PYTHONPATH": f"{PACKAGE}:{SOURCE / 'docs' / 'multibody'}"})
    if done.returncode:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout.splitlines()[-1])


class InNumpy(unittest.TestCase):
    def test_the_planet_stays_on_its_bearing(self):
        places, forces, planet = run(orbearing.load(CASE))
        self.assertLess(np.abs(places - places[0]).max(), QUIET)
        self.assertGreater(planet.output("life_used"), 0.0)
        mean = forces[500:].mean(axis=0)
        duty = {row["path"]: row["value"] for row in orbearing.load(CASE).check()["derived"]}
        np.testing.assert_allclose(-mean, [duty["operation.bore_load_x"], duty["operation.bore_load_y"]], rtol=0.02)

    def test_shorter_steps_agree(self):
        """Better than order 1; contacts that open and close within a step keep it from order 2."""
        case = orbearing.load(CASE)
        fine = run(case, 2400, 1.25e-7)[0]
        errors = [np.abs(run(case, round(3e-4 / size), size)[0] - fine[round(size / 1.25e-7) - 1::round(size / 1.25e-7)]).max()
                  for size in (4e-6, 2e-6, 1e-6)]
        print("errors [m] of 4, 2 and 1 us:", *(f"{error:.2e}" for error in errors))
        self.assertGreater(errors[0] / errors[2], 4.0)
        self.assertLess(errors[0], 0.01 * QUIET)


@unittest.skipIf(program.LEFT_TO_FULL, "installs FMPy and Exudyn: tools/test --full, or by hand")
class BesideOthers(unittest.TestCase):
    def test_its_fmu_goes_the_same_way(self):
        apart, way = in_environment(BESIDE_ITS_FMU, "fmpy==0.3.32", "xarray", "matplotlib")
        print(f"FMU and live bearing: {apart:.1e} m apart on a way of {way:.1e} m")
        self.assertLess(apart, 1e-9 * way)

    def test_in_exudyn(self):
        found = in_environment(IN_EXUDYN, "fmpy==0.3.32", "exudyn==1.13.6", "xarray")
        for exchange in ("generalised alpha, 1.0, True", "Runge-Kutta, 0.5, True"):
            coarse, fine = found[exchange][1], found[exchange][0]
            print(f"Exudyn, {exchange}: {1e6 * coarse:.4f} and {1e6 * fine:.4f} um at 4 and 1 us")
            self.assertGreater(coarse / fine, 4.0)  # better than order 1
            self.assertLess(coarse, 0.01 * QUIET)


if __name__ == "__main__":
    unittest.main()
