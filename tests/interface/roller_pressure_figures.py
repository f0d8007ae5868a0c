#!/usr/bin/env python3
"""Figures of the pressure on a roller: from made-up records whose answer is known.

Exit code 77 (skipped) where matplotlib is missing.
"""

import sys
import unittest
from pathlib import Path

try:
    import matplotlib  # noqa: F401
    import numpy as np
except ImportError:
    print("skipped: matplotlib or numpy is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

from orbearing import style  # noqa: E402
from orbearing.figures import roller_pressure  # noqa: E402

MOST_BYTES = 400_000
X = np.linspace(-2.85, 2.85, 40)


def curve(profile, tilt):
    pressure = 2000 + 100 * tilt * X
    return {"profile": profile, "tilt_mrad": tilt, "x_mm": list(X), "pressure_MPa": list(pressure),
            "peak_pressure_MPa": float(pressure.max()), "edge_ratio": 1.1}


def contact(profile):
    y = np.arange(12) * 10.0
    pressure = 2000 * np.sqrt(np.maximum(0, 1 - (y / 85.0) ** 2))
    return {"profile": profile, "tilt_mrad": 0, "x_mm": list(X), "y_um": list(y), "pressure_MPa": [list(pressure)] * len(X)}


def draw(function, *arguments):
    with style.context():
        return function(*arguments)


class Curves(unittest.TestCase):
    def test_one_panel_for_each_tilt_and_one_row_for_each_curve(self):
        block = draw(roller_pressure.block, [curve(p, t) for t in (0.0, 1.0) for p in ("straight", "iso16281")], 2060.0)
        self.assertEqual(len(block.pictures), 1)
        self.assertEqual(block.pictures[0].count('id="roller-pressure-axes_'), 2)
        self.assertEqual([row[:2] for row in block.summary.rows],
                         [("straight", 0.0), ("iso16281", 0.0), ("straight", 1.0), ("iso16281", 1.0)])
        self.assertEqual(len(block.data.rows), 4 * len(X))
        self.assertLess(len(block.pictures[0]), MOST_BYTES)

    def test_more_profiles_than_colours_stay_apart(self):
        looks = {(roller_pressure.COLOURS[n % len(roller_pressure.COLOURS)], n) for n in range(8)}
        self.assertEqual(len({colour for colour, _ in looks}), 8)

    def test_a_corner_out_of_scale_does_not_flatten_the_rest(self):
        sharp = curve("straight", 0.0)
        sharp["pressure_MPa"][0] = sharp["pressure_MPa"][-1] = 90000.0
        self.assertLess(roller_pressure._top([sharp], 2060.0), 4000.0)

    def test_missing_data_are_said(self):
        self.assertIn("no pressure", draw(roller_pressure.block, []).missing)
        uneven = curve("straight", 0.0)
        uneven["x_mm"] = uneven["x_mm"][1:]
        self.assertIn("no pressure", draw(roller_pressure.block, [uneven]).missing)


class Maps(unittest.TestCase):
    def test_width_counts_both_sides(self):
        block = draw(roller_pressure.map_block, [contact("straight"), contact("iso16281")])
        # Rows at 0 to 80 um carry: 17 of 10 um.
        self.assertEqual([row[3] for row in block.summary.rows], [170.0, 170.0])
        self.assertEqual([row[2] for row in block.summary.rows], [2000.0, 2000.0])
        self.assertLess(len(block.pictures[0]), MOST_BYTES)

    def test_the_greatest_width_is_that_of_the_widest_place(self):
        """An end that carries two rows more than the middle, and one that carries nothing, with a pressure of its own."""
        uneven = contact("straight")
        y, rows = np.asarray(uneven["y_um"]), uneven["pressure_MPa"]
        rows[0] = list(np.where(y <= 100.0, 2500.0, 0.0))
        rows[-1] = [0.0] * len(y)
        (row,) = draw(roller_pressure.map_block, [uneven]).summary.rows
        self.assertEqual(row[2:], (2500.0, 210.0))

    def test_missing_data_are_said(self):
        self.assertIn("no pressure", draw(roller_pressure.map_block, [{}]).missing)
        turned = contact("straight")
        turned["x_mm"] = turned["x_mm"][:-1]
        self.assertIn("no pressure", draw(roller_pressure.map_block, [turned]).missing)


if __name__ == "__main__":
    unittest.main()
