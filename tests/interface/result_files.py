#!/usr/bin/env python3
"""netCDF files of results open in xarray, whatever the analysis: a dimension has no name of another variable. Exit code 77 (skipped) without xarray."""

import sys
import tempfile
import unittest
from pathlib import Path

import program

try:
    import xarray
except ImportError:
    print("skipped: xarray is missing")
    sys.exit(77)

RUNS = ("ball_6305_iso16281", "duplex_7020", "harris_209", "jones_218", "planet_bearing_iso16281", "reynolds_line", "spin_bearing_7210", "three_sets_150kW")


class ResultFiles(unittest.TestCase):
    def test_open_in_xarray(self):
        analyses = [("run", case) for case in RUNS] + [("stiffness", "reducer_150kW"), ("stiffness", "jones_218"), ("signals", "scratched_rollers")]
        for command, case in analyses:
            with self.subTest(command, case=case), tempfile.TemporaryDirectory() as folder:
                result = program.run(command, program.CASES / case / "case.yaml", "--quiet", "--output", Path(folder) / "a")
                self.assertEqual(result.returncode, 0, result.stderr)
                files = list(Path(folder).rglob("*.nc"))
                self.assertTrue(files)
                for file in files:
                    with xarray.open_dataset(file) as data:
                        self.assertTrue(data.variables)


if __name__ == "__main__":
    unittest.main()
