#!/usr/bin/env python3
"""One governing life: key and number of it by every command, by Python and by the page are the same to the digit, in ten cases."""

import importlib.util
import json
import math
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import program
from page import page

orbearing = program.package()

TEMPLATES = program.CASES / "templates"
REQUIRED = {"requirements.life": "1000 h"}
# name: file, values replaced, governing life: by life.method, which is iso-16281 where C is known or a requirement is stated; with a_ISO where the oil is.
DRIVETRAINS = {
    "industrial": (TEMPLATES / "industrial.yaml", {}, "L10mrh"),
    "e-drive": (TEMPLATES / "e-drive.yaml", {}, "L10mrh"),
    "wind-stage": (TEMPLATES / "wind-stage.yaml", {}, "L10mrh"),
    "reducer_150kW": (program.REDUCER, {}, "life_h"),
    "reducer_150kW with a requirement": (program.REDUCER, REQUIRED, "L10rh"),
    "reducer_nu204": (program.CASES / "reducer_nu204" / "case.yaml", {}, "life_h"),
    "reducer_nu204 by ISO 281": (program.CASES / "reducer_nu204" / "case.yaml", {"life.method": "iso-281"}, "L10h"),
    "wind_stage_750kW": (program.WIND, {}, "life_h"),
    "wind_stage_tapered with a requirement": (program.CASES / "wind_stage_tapered" / "case.yaml", REQUIRED, "L10mrh"),
    "industrial, 95 %": (TEMPLATES / "industrial.yaml", {"life.reliability": "0.95"}, "L10mrh"),
}
SINGLE = {"roller-bearing": "L10mrh", "ball-bearing": "L10mrh"}
CROWNED = ("reducer_150kW with a requirement", "reducer_nu204 by ISO 281", "wind_stage_750kW", "wind_stage_tapered with a requirement", "industrial, 95 %")  # every day
UNCERTAIN = {"uncertain": {"input.power": {"normal": {"relative_standard_deviation": 0.01}}}}
A_1_OF_95 = 0.95 * (math.log(0.95) / math.log(0.9)) ** (2.0 / 3.0) + 0.05  # ISO 281: 0.638
ROUND_OFF = 1e-12  # speeds and powers go to SI and back
NODE = shutil.which("node") or shutil.which("nodejs")
# The chief tile of the page by its own script, of the results that the page's server has sent.
TILES = """
import fs from 'node:fs';
const {tilesOf} = await import(process.argv[1]);
const meanings = {of: () => ({}), label: (key) => key};
const chief = (run) => tilesOf({run, point: run.points[0], overSpeed: true, meanings, sweptSpeeds: () => [0]}).find((one) => one.chief);
process.stdout.write(JSON.stringify(JSON.parse(fs.readFileSync(0, 'utf8')).map((run) => [chief(run).key, chief(run).value])));
"""


def worst_of(row, key):
    """Name of the governing life that a requirement is judged by: of the worst bearing where bearings carry unlike loads."""
    return next(name for name in (f"carrier_{key}", f"shortest_{key}", key) if row.get(name) is not None)


class Drivetrains(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.runs, cls.cases = {}, {}
        for name, (file, values, _) in DRIVETRAINS.items():
            cls.runs[name] = cls.answer("run", name)
            cls.cases[name] = orbearing.load(file, values)

    def each(self, test):
        """`test(name, case, row, key)` for each case: its row of the run and the key of its governing life."""
        for name, (_, _, key) in DRIVETRAINS.items():
            with self.subTest(name):
                test(name, self.cases[name], self.runs[name]["points"][0], key)

    @staticmethod
    def answer(command, name, *settings, options=()):
        file, values, _ = DRIVETRAINS[name]
        return program.answer(command, file, *(f"{path}={value}" for path, value in values.items()), *settings, options=options)

    def test_check_names_it(self):
        def test(name, case, _, key):
            self.assertEqual(self.answer("check", name)["governing_life"]["key"], key)
            self.assertEqual((case.life_key, case.check()["governing_life"]["key"]), (key, key))

        self.each(test)

    def test_run_sweep_and_python(self):
        def test(name, case, row, key):
            self.assertGreater(row[key], 0.0)
            sweep = self.answer("sweep", name, f"sweep={{input.speed: [{row['input_speed_rpm']:g} rpm]}}", options=("--grid-only",))
            here = case.run()
            self.assertEqual((here.life_key, float(here.column(key)[0])), (key, row[key]))
            for found in (self.runs[name], sweep, here):
                self.assertEqual(found["points"][0][key], row[key])
                self.assertEqual((found["peak"]["life_key"], found["peak"]["life_h"]), (key, row[key]))

        self.each(test)

    def test_text(self):
        def test(name, _, row, key):
            file, values, _ = DRIVETRAINS[name]
            text = program.run("run", file, *program.settings(f"{path}={value}" for path, value in values.items())).stdout
            self.assertIn(f"Governing life: {key} (life.method)", text)

        self.each(test)

    def test_verdict(self):
        judged = []

        def test(name, _, row, key):
            for one in self.runs[name].get("verdicts", []):
                if one["requirement"] == "life":
                    judged.append(name)
                    self.assertEqual((one["key"].removeprefix("carrier_").removeprefix("shortest_"), one["value"]), (key, row[worst_of(row, key)]))

        self.each(test)
        self.assertEqual(len(judged), 6)

    def test_study(self):
        def test(name, case, row, key):
            result = case.study({"input.speed": [f"{row['input_speed_rpm']:g} rpm"]}, progress=False)
            self.assertEqual((result.life_key, result.variants()[0]["peak_life_h"]), (key, row[key]))
            self.assertEqual(float(result.to_xarray()[key].squeeze()), row[key])

        self.each(test)

    def test_study_of_another_method_is_refused(self):
        with self.assertRaisesRegex(orbearing.CaseError, "life.method: varied, iso-281, iso-16281 found; required: one method"):
            self.cases["industrial"].study({"life.method": ["iso-281", "iso-16281"]}, progress=False)

    def test_sensitivities(self):
        def test(name, case, row, key):
            found, worst = case.sensitivities(by=["input.power"]), worst_of(row, key)
            self.assertEqual((found["quantity"], found[worst]), (worst, row[worst]))

        self.each(test)

    @unittest.skipIf(importlib.util.find_spec("openturns") is None, "openturns was not found (Debian: python3-openturns)")
    def test_uncertainty(self):
        """Bearings scatter about one L10 whatever the reliability: L10 = L/a_1 with a_1 = L10mh/(a_ISO L10h)."""
        def test(name, case, row, key):
            few = {"samples": 2, "curves": 2, "index_samples": 2, "speeds_rpm": [row["input_speed_rpm"]]}
            data = case.copy(UNCERTAIN).uncertainty(**few).data
            worst = worst_of(row, key)
            self.assertEqual(data["life"], worst)
            for found in (data["operating_point"], data["speeds"][0], data["peak"]):
                self.assertAlmostEqual(found["life_at_the_case_h"] / row[worst], 1.0, delta=ROUND_OFF)
            a_1 = row["L10mh"] / (row["a_ISO"] * row["L10h"]) if key == "L10mrh" else 1.0
            self.assertAlmostEqual(a_1, A_1_OF_95 if name == "industrial, 95 %" else 1.0, delta=ROUND_OFF)
            l10 = self.runs["industrial"]["points"][0][worst] if name == "industrial, 95 %" else row[worst]
            self.assertAlmostEqual(data["weibull"]["a_1"], a_1, delta=ROUND_OFF)
            self.assertAlmostEqual(data["operating_point"]["of_single_bearings_at_the_case"]["L10"] / l10, 1.0, delta=ROUND_OFF)

        self.each(test)

    def test_table(self):
        """The computed value of the point to the digit; an interpolated one within the error that is stated with it."""
        def test(name, _, row, key):
            speed = row["input_speed_rpm"]
            with tempfile.TemporaryDirectory() as place:
                found = self.answer("table", name, options=("--over", f"input.speed={0.999 * speed!r} rpm..{1.001 * speed!r} rpm", "--points", 13, "-o", f"{place}/table"))
                table = orbearing.Table(f"{place}/table")
                self.assertEqual(([one["name"] for one in found["results"]], table.results), ([key], (key,)))
                exact, near = table.answer(key, bound=1e-15), table.answer(key)
                self.assertTrue(exact.computed)
                self.assertEqual(float(exact.value), row[key])
                self.assertLessEqual(abs(float(near.value) - row[key]), float(near.error))

        self.each(test)

    def test_crown(self):
        """`in_run` is the life of the case as it is, of the bearing by which a requirement is judged."""
        def test(name, _, row, key):
            if program.LEFT_TO_FULL and name not in CROWNED:
                return
            tilts = ("--tilts", "0 mrad") if worst_of(row, key) == key else ()
            options = ("--drops", "4 um", "--starts", "1", *tilts)
            if name.startswith("wind_stage_tapered"):
                file, values, _ = DRIVETRAINS[name]
                refused = program.run("crown", file, "--json", *options, *program.settings(f"{path}={value}" for path, value in values.items()))
                self.assertEqual(refused.returncode, 2)
                self.assertIn("bearing.type", refused.stderr)
                return
            found = self.answer("crown", name, options=options)
            self.assertEqual((found["in_run"]["life_key"], found["in_run"]["case_h"]), (worst_of(row, key), row[worst_of(row, key)]))
            # L10h takes no account of a profile: a crown is chosen by the life that does.
            self.assertEqual(found["life_key"], "life_h" if key == "L10h" else key)

        self.each(test)

    @unittest.skipIf(NODE is None, "node is missing (Debian: nodejs)")
    def test_tile_of_the_page(self):
        results = []
        with page() as server:
            for file, values, _ in DRIVETRAINS.values():
                status, _, data = server.request("run", pathlib.Path(file).read_text(encoding="utf-8"), [f"{path}={value}" for path, value in values.items()])
                self.assertEqual(status, 200, data)
                results.append(json.loads(data))
        script = (program.CASES.parent / "page" / "web" / "tiles.js").resolve().as_uri()
        done = subprocess.run([NODE, "--input-type=module", "-e", TILES, script], input=json.dumps(results), capture_output=True, text=True, check=False, timeout=program.SECONDS)
        self.assertEqual(done.returncode, 0, done.stderr)
        tiles = dict(zip(DRIVETRAINS, json.loads(done.stdout), strict=True))

        def test(name, _, row, key):
            self.assertEqual(tiles[name], [key, row[worst_of(row, key)]])

        self.each(test)

    def test_spectrum_of_the_operating_point_alone(self):
        row, power, key = self.runs["industrial"]["points"][0], self.cases["industrial"]["input.power"], "L10mrh"
        found = self.answer("run", "industrial", f"spectrum=[{{power: {power!r} W, speed: {row['input_speed_rpm']:g} rpm, share: 1}}]")
        spectrum, verdict = found["spectrum"], next(one for one in found["verdicts"] if one["requirement"] == "life")
        self.assertEqual((spectrum["life_key"], spectrum["bins"][0][key]), (key, row[key]))
        for name in (key, f"system_{key}"):
            self.assertAlmostEqual(spectrum[name] / row[name], 1.0, delta=ROUND_OFF)
        self.assertEqual((verdict["key"], verdict["value"], verdict["at"]), (key, spectrum[key], "load spectrum"))


class SingleBearings(unittest.TestCase):
    def test_check_run_verdict_and_text(self):
        for name, key in SINGLE.items():
            with self.subTest(name):
                file = TEMPLATES / f"{name}.yaml"
                case, found = orbearing.load(file), program.answer("run", file)
                self.assertEqual((case.life_key, found["life_table"]["governing"]), (key, key))
                row = next(one for one in found["life_table"]["lives"] if one["key"] == key)
                self.assertEqual((row["hours"], case.run()[key]), (found[key], found[key]))
                verdict = next(one for one in found["verdicts"] if one["requirement"] == "life")
                self.assertEqual((verdict["key"], verdict["value"]), (key, found[key]))
                self.assertIn(f"Governing life: {key} (life.method)", program.run("run", file).stdout)

                from orbearing.lives import governing_number
                self.assertEqual(governing_number(found), (key, found[key], "h"))


if __name__ == "__main__":
    unittest.main()
