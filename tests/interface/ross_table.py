#!/usr/bin/env python3
"""ROSS reads our table of stiffness, and a rotor on it has the critical speeds that the table says; releases 2 and 3.

Skipped where ross-rotordynamics cannot be had from PyPI, each release with its reason. Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from virtual_environment import build_folder, environment, left_to_full, skip

CASE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"]) / "cases" / "spin_bearing_7210" / "case.yaml"
RELEASES = {2: ("ross-rotordynamics==2.3.0", "plotly<6"), 3: ("ross-rotordynamics>=3,<4",)}
AXIAL, BALLS, DIAMETER, ANGLE = 2000.0, 15, 12.7e-3, 40.0  # [N], [-], [m], [deg]
# A shaft of steel, 45 mm across and 0.6 m long, a disk in its middle; one undamped bearing at either end.
ROTOR = """
import json, math, sys, warnings
import numpy as np
import ross
caught = warnings.catch_warnings(record=True)
told = caught.__enter__()
warnings.simplefilter("always")
table, balls, diameter, load, angle = sys.argv[1], *map(float, sys.argv[2:6])
steel = ross.Material("steel", rho=7810, E=211e9, G_s=81.2e9)
def rotor(bearings):
    shaft = [ross.ShaftElement(L=0.05, idl=0, odl=0.045, material=steel, n=n) for n in range(12)]
    disk = ross.DiskElement.from_geometry(6, steel, width=0.04, i_d=0.045, o_d=0.22)
    return ross.Rotor(shaft, [disk], bearings)
def criticals(bearings):
    machine = rotor(bearings)
    found = []
    speeds = np.linspace(20, 1500, 38)
    lines = np.array([np.sort(machine.run_modal(speed, num_modes=16).wn)[:2] for speed in speeds])
    for line in lines.T:
        above = line - speeds
        i = np.nonzero((above[:-1] > 0) & (above[1:] <= 0))[0]
        if len(i):
            share = above[i[0]] / (above[i[0]] - above[i[0] + 1])
            found.append(speeds[i[0]] + share * (speeds[1] - speeds[0]))
    return found
ours = [ross.BearingElement.from_table(n=n, file=table) for n in (0, 12)]
import orbearing
case = orbearing.load(sys.argv[6], dict(word.split("=", 1) for word in sys.argv[7:]))
live = case.stiffness().ross_element(0)
at = [0.0, 300.0, 800.0]
read = [[float(np.asarray(ours[0].K(w))[0, 0]) for w in at], [float(np.asarray(ours[0].K(w))[1, 1]) for w in at]]
theirs = [ross.BallBearingElement(n=n, n_balls=balls, d_balls=diameter, fs=load, alpha=math.radians(angle)) for n in (0, 12)]
stiff = [ross.BearingElement(n=n, kxx=1e15, cxx=0) for n in (0, 12)]
k = np.asarray(theirs[0].K(0))
# Of the tables alone: release 3 warns of fewer than five points.
few = [str(one.message) for one in told if "point" in str(one.message) and ("few" in str(one.message) or "5" in str(one.message))]
print(json.dumps({"few": few, "read": read, "ours": criticals(ours), "theirs": criticals(theirs), "rigid": criticals(stiff),
                  "ross": [float(k[0, 0]), float(k[1, 1])],
                  "live": max(abs(float(np.asarray(live.K(w))[i, i]) / read[i][j] - 1) for i in (0, 1) for j, w in enumerate(at))}))
"""


def call(*arguments):
    return subprocess.run([os.environ["ORBEARING"], *map(str, arguments)], capture_output=True, text=True, timeout=600, check=True)


class Ross(unittest.TestCase):
    def test_release_2(self):
        self.rotor_on_our_table(2)

    def test_release_3(self):
        self.rotor_on_our_table(3)

    def rotor_on_our_table(self, release):
        interpreter, reason = INTERPRETERS[release]
        if reason:
            self.skipTest(f"ROSS {release}: {reason}")
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "out"
            settings = [f"load.axial={AXIAL} N",
                        "operation.speeds=[0 rad/s, 100 rad/s, 300 rad/s, 550 rad/s, 800 rad/s, 1100 rad/s, 1500 rad/s]"]
            result = call("stiffness", CASE, "-o", folder, "--json", *(word for one in settings for word in ("--set", one)))
            points = {round(point["speed_rpm"] * 0.10471975511965977): point["stiffness"] for point in json.loads(result.stdout)["points"]}
            done = subprocess.run([interpreter, "-c", ROTOR, folder / "ross.xls", str(BALLS), str(DIAMETER), str(AXIAL), str(ANGLE), CASE, *settings],
                                  capture_output=True, text=True, timeout=600, cwd=place,
                                  env={**os.environ, "PYTHONPATH": str(build_folder() / "python")})
            self.assertEqual(done.returncode, 0, done.stderr[-2000:])
            found = json.loads(done.stdout.splitlines()[-1])
        print(f"critical speeds [rad/s]: our table {found['ours']}, BallBearingElement {found['theirs']}, "
              f"rigid bearings {found['rigid']}; K_xx, K_yy of ROSS {found['ross']}, ours at rest {found['read'][0][0]:.4g}")
        self.assertEqual(found["few"], [])
        for axis in (0, 1):
            for speed, read in zip((0, 300, 800), found["read"][axis]):
                self.assertAlmostEqual(read / points[speed][axis][axis], 1, delta=1e-4)
        self.assertLess(found["live"], 1e-4)  # the package's own element has the same stiffness
        # Both directions stand alike under thrust, but for what gyroscopes part: two critical speeds of the first bending.
        self.assertEqual(len(found["ours"]), 2)
        rigid = sum(found["rigid"]) / 2
        for ours in found["ours"]:
            self.assertLess(ours, rigid)
            self.assertGreater(ours, 0.5 * rigid)
        # ROSS's formula is that of a radial load alone, at one speed.
        for ours, theirs in zip(found["ours"], found["theirs"]):
            self.assertLess(abs(ours / theirs - 1), 0.25)


if __name__ == "__main__":
    left_to_full("installs ROSS with 1.4 GB of packages")
    INTERPRETERS = {release: environment(*packages) for release, packages in RELEASES.items()}
    for release, (_, reason) in INTERPRETERS.items():
        print(f"ROSS {release}: {reason or 'installed'}")
    if all(reason for _, reason in INTERPRETERS.values()):
        skip("no release of ROSS can be installed")
    unittest.main()
