#!/usr/bin/env python3
"""Files that ParaView opens, read as their format states: loads of laminae, rollers in motion."""

import base64
import contextlib
import importlib.util
import io
import sys
import tempfile
import unittest
import xml.etree.ElementTree as tree
from pathlib import Path

from program import BRIEF_GEARS, CASES, REDUCER, package, run, settings

READS = all(importlib.util.find_spec(name) for name in ("numpy", "netCDF4"))
if not READS:
    print("skipped: numpy and netCDF4 are required")
    sys.exit(77)

import netCDF4
import numpy as np

package()
from orbearing import paraview  # pylint: disable=wrong-import-position

KINDS = {"Float64": "<f8", "Int32": "<i4"}


def arrays(file):
    """Every DataArray by its name."""
    found = {}
    for one in tree.parse(file).getroot().iter("DataArray"):
        content = base64.b64decode(one.text)
        size = int(np.frombuffer(content[:4], "<u4")[0])
        assert size == len(content) - 4
        values = np.frombuffer(content[4:], KINDS[one.get("type")])
        found[one.get("Name")] = values.reshape(-1, int(one.get("NumberOfComponents", 1))).squeeze()
    return found


def prisms(found, rollers, slices):
    """Middle of each slice of each roller [m], and what its sides carry."""
    corners = found["position"][found["connectivity"].reshape(-1, 4)]
    sides = len(corners) // (rollers * slices)
    middle = corners.reshape(rollers, slices, sides * 4, 3).mean(axis=2)
    return middle, {name: found[name].reshape(rollers, slices, sides) for name in found if len(found[name]) == len(corners)}


class Files(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def computed(self, case, *values, options=()):
        result = run("run", case, "-o", self.place / "run", "--quiet", *options, *settings(values))
        self.assertEqual(result.returncode, 0, result.stderr)
        return netCDF4.Dataset(next((self.place / "run" / "points").glob("*.nc")))

    def written(self, *options):
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(paraview.main([str(self.place / "run"), "-o", str(self.place / "out"), *options]), 0)
        return self.place / "out"

    def test_loads_of_laminae(self):
        with self.computed(CASES / "harris_209") as data:
            loads, angles = data["lamina_load"][...].data, data["steps_element_angles"][...].data
        found = arrays(self.written() / "rollers.vtp")
        middle, numbers = prisms(found, *loads.shape)
        np.testing.assert_array_equal(numbers["load_N"], np.broadcast_to(loads[:, :, None], numbers["load_N"].shape))
        np.testing.assert_allclose(numbers["load_per_length_N_per_m"][:, :, 0], loads * 40 / 9.6e-3, rtol=1e-12)
        np.testing.assert_allclose(middle[:, 0, :2], 32.5e-3 * np.stack([np.cos(angles), np.sin(angles)], axis=1), atol=1e-12)
        np.testing.assert_allclose(middle[0, [0, -1], 2], [-4.68e-3, 4.68e-3], rtol=1e-12)
        np.testing.assert_array_equal(found["offsets"], np.arange(4, len(found["connectivity"]) + 1, 4))  # where each of four corners ends
        radius = np.hypot(*(found["position"][:2] - [*middle[0, 0, :2], 0])[:, :2].T)
        np.testing.assert_allclose(radius, 5e-3, rtol=1e-12)

    def test_rollers_in_motion(self):
        with self.computed(REDUCER, *BRIEF_GEARS, options=("--fidelity", "dynamic")) as data:
            times, angles, loads = (data[name][...].data for name in ("time", "roller_angle", "roller_outer_load"))
        out = self.written("--frames", "5")
        rows = list(tree.parse(out / "rollers.pvd").getroot().iter("DataSet"))
        self.assertEqual(len(rows), 5)
        self.assertEqual(float(rows[-1].get("timestep")), float(f"{times[-1]:.12g}"))
        for row in (rows[0], rows[-1]):
            at = int(np.argmin(abs(times - float(row.get("timestep")))))
            middle, numbers = prisms(arrays(out / row.get("file")), len(angles), 1)
            np.testing.assert_allclose(middle[:, 0, :2], 17.82e-3 * np.stack([np.cos(angles[:, at]), np.sin(angles[:, at])], axis=1), atol=1e-12)
            np.testing.assert_array_equal(numbers["roller_outer_load"][:, 0, 0], loads[:, at])

    def test_refusals(self):
        self.computed(CASES / "ball_6305_iso16281").close()
        for options, said in (((), "found no bearing.roller_diameter"), (("--point", "7"), "found 7 of 1 points")):
            with self.assertRaises(SystemExit) as end:
                self.written(*options)
            self.assertIn(said, str(end.exception))


if __name__ == "__main__":
    unittest.main()
