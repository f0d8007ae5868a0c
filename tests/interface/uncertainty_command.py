#!/usr/bin/env python3
"""`orbearing uncertainty` and `orbearing.uncertainty(...)`: bands, files, the same bits, messages, beside a sweep and Monte Carlo."""

# Uncertainty of a case.
import importlib
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

for library, debian in (("openturns", "python3-openturns"), ("xarray", "python3-xarray")):
    if importlib.util.find_spec(library) is None:
        print(f"{library} was not found (Debian: {debian})")
        sys.exit(77)

import program

orbearing = program.package()
BUILT = pathlib.Path(orbearing.__file__).parents[1]

from orbearing.uncertainties.__main__ import main  # noqa: E402

POWER = "input.power: {normal: {standard_deviation: 5 kW}, reason: 'so: said'}"
CLEARANCE = "bearing.radial_clearance: {triangular: {from: 0 um, peak: 5 um, to: 20 um}}"
UNCERTAIN = "uncertain={" + POWER + ", " + CLEARANCE + "}"
COARSE = "sweep.input.speed=[3000 rpm, 5000 rpm, 6000 rpm, 8000 rpm]"
FEW = ("--samples", "60", "--curves", "20", "--index-samples", "20")
SETTINGS = program.settings((UNCERTAIN, COARSE))


def study(*words, case=program.REDUCER):
    return program.within(main, case, *FEW, *SETTINGS, *words)


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name) / "new" / "results"
        cls.done = program.run("uncertainty", program.REDUCER, *FEW, *SETTINGS, "-o", cls.folder)
        cls.data = json.loads((cls.folder / "uncertainty.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def test_writes_what_it_found(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual(sorted(file.name for file in self.folder.iterdir()),
                         sorted(["uncertainty.json", "uncertainty.journal", "samples.nc", "uncertainty.html", "case.resolved.yaml",
                                 *(f"{name}.{ending}" for name in ("life_band", "peak", "indices") for ending in ("svg", "png"))]))
        self.assertIn("measure", self.done.stdout)
        units = json.loads((self.folder / "uncertainty.json").read_text())["units"]
        self.assertEqual((units["speed_rpm"], units["life_at_the_case_h"]), ("rpm", "h"))
        page = (self.folder / "uncertainty.html").read_text()
        self.assertIn("so: said", page)
        self.assertNotIn("http", page.replace("http://www.w3.org", ""))

    def test_the_resolved_case_gives_the_same_numbers_whatever_the_jobs(self):
        again = program.within(main, self.folder / "case.resolved.yaml", *FEW, "--json", "--jobs", "1")
        self.assertEqual(again.stdout, (self.folder / "uncertainty.json").read_text())

    def test_the_case_as_it_stands_is_its_sweep(self):
        sweep = program.answer("sweep", program.REDUCER, COARSE, options=("--grid-only",))
        self.assertEqual([row["life_at_the_case_h"] for row in self.data["speeds"]], [point["life_h"] for point in sweep["points"]])
        refined = program.answer("sweep", program.REDUCER, COARSE)["peak"]
        self.assertAlmostEqual(self.data["peak"]["speed_at_the_case_rpm"], refined["refined_speed_rpm"], delta=4.0)
        self.assertAlmostEqual(self.data["peak"]["life_at_the_case_h"] / refined["refined_life_h"], 1.0, delta=1e-5)

    def test_samples_are_points_of_a_sweep(self):
        import xarray

        with xarray.open_dataset(self.folder / "samples.nc") as samples:
            row = {path: float(samples[path][7]) for path in ("input.power", "bearing.radial_clearance")}
            self.assertEqual(samples["bearing.radial_clearance"].attrs["units"], "um")
            life, peak, speed = float(samples["life"][7]), float(samples["peak_life"][3]), float(samples["peak_speed"][3])
            curve = {path: float(samples[f"curve.{path}"][3]) for path in row}
        for values, rpm, found in ((row, 6000.0, life), (curve, speed, peak)):
            point = program.answer("run", program.REDUCER, "sweep={}", f"input.speed={rpm!r} rpm", f"input.power={values['input.power']!r} kW",
                                   f"bearing.radial_clearance={values['bearing.radial_clearance']!r} um")["points"][0]
            self.assertAlmostEqual(point["life_h"] / found, 1.0, delta=1e-9)  # units there and back

    def test_bands_stand_in_order(self):
        for row in (self.data["operating_point"], *self.data["speeds"]):
            for name in ("of_uncertain_inputs", "of_single_bearings_at_the_case", "of_both"):
                band = list(row[name]["percentiles"].values())
                self.assertEqual(band, sorted(band))
            single, both = row["of_single_bearings_at_the_case"]["percentiles"], row["of_both"]
            self.assertLess(single["5"], row["life_at_the_case_h"])
            self.assertLess(both["percentiles"]["5"], both["L10"])
            self.assertLess(both["L10"], both["percentiles"]["25"])

    def test_names_a_spectrum_that_it_leaves_out(self):
        few = ("--samples", "16", "--curves", "2", "--index-samples", "4")
        spectrum = program.settings(("spectrum=[{power: 150 kW, speed: 6000 rpm, share: 1}]",))
        done = program.within(main, program.REDUCER, *few, *SETTINGS, *spectrum, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        named = [text for text in json.loads(done.stdout)["warnings"] if text.startswith("spectrum: has no effect on uncertainty")]
        self.assertEqual(len(named), 1)
        self.assertFalse([text for text in self.data["warnings"] if text.startswith("spectrum")])

    def test_refuses_what_is_of_no_use(self):
        for words, text in ((("-o", self.folder), "holds a study of uncertainty"), ((), "--output: missing"),
                            (("--json", "--samples", "1"), "at least 2"), (("--json", "--speeds", "3 mm"), "does not measure"),
                            (("--json", "--life", "cage_slip"), "one of life_h"), (("--json", "--method", "grid"), "invalid choice"),
                            (("--json", "--set", "uncertain.input.speed={uniform: {from: 1 rpm, to: 2 rpm}}"), "uncertain speed"),
                            (("--json", "--set", "uncertain={}"), "uncertain: missing"),
                            (("--json", "--set", "uncertain.input.powr=3"), "did you mean 'input.power'?")):
            with self.subTest(words):
                done = study(*words)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertIn(text, done.stderr)
        done = study("--json", case=program.CASES / "harris_209" / "case.yaml")
        self.assertEqual(done.returncode, 2)

    def test_says_what_is_missing_without_openturns(self):
        with tempfile.TemporaryDirectory() as place:
            (pathlib.Path(place) / "openturns.py").write_text("raise ImportError('not here')\n")
            done = subprocess.run([sys.executable, "-m", "orbearing.uncertainties", str(program.REDUCER), "--json", *SETTINGS], capture_output=True, text=True,
                                  check=False, env={**os.environ, "PYTHONPATH": f"{place}:{BUILT}"})
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("python3-openturns", done.stderr)


class Called(unittest.TestCase):
    def case(self):
        return orbearing.load(program.REDUCER, {"uncertain": {"input.power": {"normal": {"standard_deviation": "5 kW"}},
                                                              "bearing.radial_clearance": {"uniform": {"from": "0 um", "to": "20 um"}}}})

    def test_chaos_beside_monte_carlo(self):
        result = orbearing.uncertainty(self.case(), samples=3000, curves=2, index_samples=2, method="monte-carlo", speeds_rpm=[6000.0])
        lives, expansion = result.point_lives, result.data["operating_point"]["chaos"]
        self.assertLess(expansion["training_samples"], 0.5 * len(lives))
        self.assertAlmostEqual(expansion["mean"] / lives.mean(), 1.0, delta=0.01)
        self.assertAlmostEqual(expansion["standard_deviation"] / lives.std(), 1.0, delta=0.05)

    def test_a_function_and_a_method_of_the_case(self):
        for callee in (orbearing.uncertainty, orbearing.Case.uncertainty):
            result = callee(self.case(), samples=20, curves=5, index_samples=5, speeds_rpm=[5000.0, 6000.0, 7000.0])
            self.assertEqual(result.point_lives.shape, (20,))
            self.assertIn("UncertaintyResult(reducer_150kW", repr(result))
            self.assertIn("<table>", result._repr_html_())

    def test_writes_a_page(self):
        result = orbearing.uncertainty(self.case(), samples=20, curves=5, index_samples=5, speeds_rpm=[5000.0, 6000.0, 7000.0], motion=0)
        with tempfile.TemporaryDirectory() as place:
            first = result.report(pathlib.Path(place) / "page.html").read_bytes()
            self.assertEqual(first, result.report(pathlib.Path(place) / "again.html").read_bytes())

    def test_needs_something_uncertain(self):
        with self.assertRaisesRegex(orbearing.CaseError, "uncertain: missing"):
            orbearing.uncertainty(orbearing.load(program.REDUCER))


if __name__ == "__main__":
    unittest.main()
