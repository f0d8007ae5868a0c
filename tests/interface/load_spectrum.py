#!/usr/bin/env python3
"""Load spectra from outside: rows, files, folders, shards, records over time, crown, the page."""

import csv
import io
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from program import BRIEF_GEARS

ROOT = Path(os.environ.get("ORBEARING_SOURCE_DIR", Path(__file__).resolve().parents[2]))
PROGRAM = os.environ.get("ORBEARING", str(ROOT / "build" / "release" / "bin" / "orbearing"))
CASE = ROOT / "cases" / "reducer_150kW" / "case.yaml"
SHIPPED = "spectrum={file: loads.csv}"
OIL = "lubricant.grade=ISO VG 220"
COARSE = "sweep.input.speed=[3000 rpm, 6000 rpm, 9000 rpm]"
SAME = 1e-12
WAIT = 600  # [s]


def call(*arguments, folder=None):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=WAIT, check=False, cwd=folder)


def settings(*texts):
    return [word for text in texts for word in ("--set", text)]


class LoadSpectrum(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def answer(self, *arguments):
        result = call(*arguments, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def refusal(self, *arguments):
        result = call(*arguments)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        return result.stderr

    def test_sweep_by_miner(self):
        found = self.answer("sweep", CASE, "--grid-only", *settings(SHIPPED, OIL, COARSE))
        self.assertEqual(len(found["points"]), 3)  # the bins stand apart
        spectrum = found["spectrum"]
        for name, part in (("life_h", "damage_share"), ("L10mh", "damage_share_L10mh")):
            used = [one["share"] / one[name] if one["speed_rpm"] else 0.0 for one in spectrum["bins"]]
            self.assertAlmostEqual(spectrum[name] * sum(used), 1.0, delta=SAME)
            for one, damage in zip(spectrum["bins"], used):
                self.assertAlmostEqual(one[part], damage / sum(used), delta=SAME)
        self.assertEqual(spectrum["bins"][-1]["status"], "at rest")

    def test_what_its_rows_state_is_not_swept_and_no_time_uses_up_nothing(self):
        rows = "spectrum=[{power: 150 kW, speed: 6000 rpm, share: 1.0}, {power: 1 kW, speed: 20 rpm, share: 0.0}]"
        thin = ("lubricant.grade=ISO VG 10", "lubricant.temperature=120 degC")  # kappa below 0.1 at 20 rpm
        found = self.answer("run", CASE, *settings(rows, *thin))["spectrum"]
        self.assertEqual([one["damage_share_L10mh"] for one in found["bins"]], [1.0, 0.0])
        self.assertGreater(found["L10mh"], 0.0)
        powers = self.answer("sweep", CASE, "--grid-only", *settings(SHIPPED, "sweep={input.power: [100 kW, 150 kW]}"))["spectrum"]
        self.assertIsInstance(powers, dict)
        self.assertNotIn("input.power_kW", powers)

    def test_folder_resume_and_shards_hold_the_same_rows(self):
        grid = settings(SHIPPED, COARSE)
        for folder, options in (("whole", ()), ("one", ("--shard", "1/2")), ("two", ("--shard", "2/2"))):
            self.assertEqual(call("sweep", CASE, "-o", self.place / folder, "--quiet", *grid, *options).returncode, 0)
        self.assertEqual(call("merge", self.place / "one", self.place / "two", "-o", self.place / "merged", "--quiet").returncode, 0)
        self.assertFalse((self.place / "one" / "spectrum.csv").exists())
        for name in ("sweep.csv", "spectrum.csv"):
            self.assertEqual((self.place / "merged" / name).read_bytes(), (self.place / "whole" / name).read_bytes(), name)
        before = (self.place / "whole" / "spectrum.csv").read_bytes()
        (self.place / "whole" / "points" / "00004.nc").unlink()  # of a bin
        self.assertEqual(call("sweep", CASE, "-o", self.place / "whole", "--resume", "--quiet", *grid).returncode, 0)
        self.assertEqual((self.place / "whole" / "spectrum.csv").read_bytes(), before)
        rows = list(csv.DictReader(io.StringIO(before.decode())))
        self.assertEqual([row["status"] for row in rows], ["ok"] * 7 + ["at rest"])
        # The resolved case holds the rows and gives the same again, without the file.
        again = call("run", self.place / "whole" / "case.resolved.yaml", "-o", self.place / "again", "--quiet")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.place / "again" / "spectrum.csv").read_bytes(), before)

    def test_page(self):
        out = self.place / "out"
        self.assertEqual(call("sweep", CASE, "-o", out, "--grid-only", "--quiet", *settings(SHIPPED, COARSE, *BRIEF_GEARS)).returncode, 0)
        made = call("report", out)
        if "matplotlib" in made.stderr and made.returncode == 1:
            self.skipTest(made.stderr)
        self.assertEqual(made.returncode, 0, made.stderr)
        page = (out / "report.html").read_text(encoding="utf-8")
        self.assertIn("Load spectrum and what it uses up", page)
        self.assertIn("load-spectrum-map", page)
        self.assertIn("Skid risk, P/C below 0.02 (life.minimum_load): ", page)

    def test_crown(self):
        found = self.answer("crown", CASE, *settings(SHIPPED, "bearing.rollers=7"), "--drops", "0 um, 3 um, 6 um", "--tilts", "0 mrad, 1 mrad", "--starts", 1)
        advice = found["recommended"]
        self.assertEqual(list(advice)[:6], ["status", "shortens_governing_life", "profile", "drop_um", "least_drop_um", "most_drop_um"])
        self.assertLessEqual(advice["least_drop_um"], advice["drop_um"])
        self.assertGreaterEqual(advice["most_drop_um"], advice["drop_um"])
        self.assertEqual(len(advice["points"]), 7)
        self.assertAlmostEqual(sum(one["damage_share"] for one in advice["points"]), 1.0, delta=1e-9)
        used = sum(one["share"] / one["governing_life_h"] for one in advice["points"])
        self.assertAlmostEqual(used * advice["governing_life_h"], 1.0, delta=1e-6)
        self.assertIn("one of both", self.refusal("crown", CASE, "-o", self.place / "no", "--spectrum", *settings(SHIPPED)))

    def test_record_over_time_becomes_a_spectrum_that_a_case_takes(self):
        record = self.place / "series.csv"
        record.write_text("time_s,speed_rpm,torque_N_m\n" + "".join(
            f"{t},{6000 if t % 4 else 0},{238.732414637843}\n" for t in range(41)))
        loads = self.place / "loads.csv"
        found = self.answer("spectrum", record, "-o", loads)
        self.assertEqual(len(found["bins"]), 2)  # constant, and rest
        self.assertEqual(found["duration_s"], 40)
        spectrum = self.answer("run", CASE, *settings(f"spectrum={{file: {loads}}}"))["spectrum"]
        plain = self.answer("run", CASE)["points"][0]["life_h"]
        self.assertAlmostEqual(spectrum["life_h"] * 0.75 / plain, 1.0, delta=1e-10)
        # A file that an option names and that the case's folder lacks is looked for where the command is given.
        self.assertEqual(call("check", CASE, *settings("spectrum={file: loads.csv}"), folder=self.place).returncode, 0)

    def test_few_bins_never_lengthen_a_life(self):
        # Bins by the power 10/3 gave lives by the power 4 that were 12 % too long in one bin.
        record = self.place / "uneven.csv"
        torques = [60.0, 400.0, 120.0, 300.0, 200.0, 80.0, 350.0, 250.0, 150.0]
        record.write_text("time_s,speed_rpm,torque_N_m\n" + "".join(f"{t},3000,{torque}\n" for t, torque in enumerate(torques)))

        def lives(bins, *more):
            loads = self.place / "bins.csv"
            found = self.answer("spectrum", record, "-o", loads, "--bins", bins, *more)
            result = self.answer("run", CASE, *settings(f"spectrum={{file: {loads}}}", "lubricant.grade=ISO VG 220", "life.cleanliness=-/15/12",
                                                        "inertia.carrier_centrifugal=false", "inertia.own_orbit=false", "inertia.coriolis=false",
                                                        "gearset.mesh_variation=false"))
            return found, result["spectrum"]

        one, life_of_one = lives("1x1")
        many, life_of_many = lives("64x1")
        self.assertEqual((one["torque_exponent"], len(one["bins"]), len(many["bins"])), (4.0, 1, 8))
        # By hand: the last sample lasts for no time.
        mean = (sum(torque**4 for torque in torques[:-1]) / 8) ** 0.25
        self.assertAlmostEqual(one["bins"][0]["torque_N_m"] / mean, 1.0, delta=1e-9)
        self.assertAlmostEqual(life_of_one["life_h"] / life_of_many["life_h"], 1.0, delta=1e-6)  # one power, one life
        for life in ("L10h", "L10rh"):
            self.assertLessEqual(life_of_one[life], life_of_many[life] * (1.0 + 1e-9), life)
        # Lives with a_ISO fall faster: a warning says by how much one bin may lengthen them, and --exponent 8 never does.
        self.assertEqual([text for text in many["warnings"] if "--exponent" in text], [])
        (warning,) = [text for text in one["warnings"] if "--exponent" in text]
        excess = sum(torque**8 for torque in torques[:-1]) / 8 / mean**8 - 1.0
        self.assertIn(f"up to {100 * excess:.2g} % too long", warning)
        for life in ("L10mh", "L10mrh"):
            self.assertLess(life_of_one[life] / life_of_many[life], 1.0 + excess, life)
        safe, life_of_safe = lives("1x1", "--exponent", "8")
        self.assertEqual([text for text in safe["warnings"] if "--exponent" in text], [])
        for life in ("life_h", "L10h", "L10rh", "L10mh", "L10mrh"):
            self.assertLess(life_of_safe[life], life_of_many[life], life)
        _, before = lives("1x1", "--exponent", str(10 / 3))
        self.assertGreater(before["life_h"] / life_of_many["life_h"], 1.05)
        self.assertIn("--exponent", self.refusal("spectrum", record, "-o", self.place / "none.csv", "--exponent", "0.5"))

    def test_bad_input(self):
        fit = self.refusal("check", CASE, *settings("bearing.clearance_state=unmounted", "bearing.fit.pin_bore=26 mm"))
        self.assertIn("bearing.fit.pin_bore", fit)
        out = self.place / "never"
        self.assertIn("--bins", self.refusal("spectrum", CASE, "--bins", "3", "-o", out))
        self.assertIn("required", self.refusal("spectrum", self.place / "none.csv", "-o", out))
        self.assertIn("--output", self.refusal("spectrum", CASE))
        wrong = self.place / "wrong.csv"
        wrong.write_text("torque_N_m,speed_rpm,share\n100,6000,half\n")
        message = self.refusal("sweep", CASE, "-o", out, *settings(f"spectrum={{file: {wrong}}}"))
        self.assertTrue(message.startswith(f"{wrong}:2:10: spectrum: "), message)
        self.assertIn("--continue", self.refusal("sweep", CASE, "-o", out, "--fidelity", "dynamic", "--continue", "up", *settings(SHIPPED)))
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
