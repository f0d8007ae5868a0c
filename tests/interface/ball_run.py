"""Ball bearings in time by the command line: keys, files, refusals."""
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["ORBEARING"]
CASES = Path(os.environ["ORBEARING_SOURCE_DIR"]) / "cases"
MOTOR = CASES / "deep_groove_motor" / "case.yaml"
SHORT = ["--set", "simulation.duration=0.05 s", "--set", "simulation.samples=100", "--set", "simulation.start=rolling"]


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


class BallRun(unittest.TestCase):
    def test_json_has_the_keys_that_scripts_read(self):
        done = run("run", MOTOR, "--json", *SHORT)
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(done.stdout)
        for key in ("life_h", "slip_settling_s", "cage_impact_max_N", "cage_slip", "heat_W"):
            self.assertIn(key, result)
        heat = result["heat_W"]
        self.assertAlmostEqual(heat["total"], sum(value for key, value in heat.items() if key != "total"), places=9)
        self.assertLess(abs(result["cage_slip"]), 0.1)
        self.assertIn("bearing.cage.width", {entry["key"] for entry in result["assumptions"]})

    def test_folder_holds_the_run_over_time(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            done = run("run", MOTOR, "-o", out, *SHORT)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("friction torque", done.stdout)
            again = run("run", out / "case.resolved.yaml", "--json")
            self.assertEqual(again.returncode, 0, again.stderr)
            try:
                import netCDF4
            except ImportError:
                return
            with netCDF4.Dataset(next((out / "points").glob("*.nc"))) as file:
                self.assertEqual(file["cage_slip"].shape, (101,))
                self.assertEqual(file["heat_rolling"].units, "W")
                self.assertEqual(file.status, "ok")
                self.assertAlmostEqual(json.loads(again.stdout)["life_h"] / float(file["life"][:]), 1.0, places=9)

    def test_report_draws_the_run(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            self.assertEqual(run("run", MOTOR, "-o", out, "--quiet", *SHORT).returncode, 0)
            done = run("report", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            page = (out / "report.html").read_text(encoding="utf-8")
            for title in ("Slip of the cage", "Heat by cause", "Loads of balls on the cage", "One ball", "Place of the cage"):
                self.assertIn(title, page)
            self.assertEqual(page.count("<svg"), 5)
            self.assertIn("its cage slips", page)

    def test_temperatures_follow_from_the_friction_where_asked(self):
        stated = json.loads(run("run", MOTOR, "--json", *SHORT).stdout)
        self.assertIsNone(stated["temperature_C"])
        self.assertLess(stated["life_with_balls_h"], stated["life_h"])
        done = run("run", MOTOR, "--json", "--set", "heat.enabled=true", "--set", "heat.surroundings=40 degC", *SHORT)
        self.assertEqual(done.returncode, 0, done.stderr)
        warm = json.loads(done.stdout)
        self.assertEqual(list(warm["temperature_C"]), ["balls", "inner_ring", "outer_ring", "oil", "housing"])
        for temperature in warm["temperature_C"].values():
            self.assertTrue(40.0 < temperature < 60.0)
        self.assertGreater(warm["heat_W"]["total"], stated["heat_W"]["total"])  # the oil is stated at 70 degC
        # Races of 36 -+ (9.52 + 0.01) mm and balls of 9.52 mm, stated at 20 degC.
        above = {body: temperature - 20 for body, temperature in warm["temperature_C"].items()}
        clearance = 20 + 11.5e-6 * 1e3 * (45.53 * above["outer_ring"] - 26.47 * above["inner_ring"] - 2 * 9.52 * above["balls"])
        self.assertAlmostEqual(warm["running_clearance_um"], clearance, delta=0.02)
        self.assertAlmostEqual(stated["running_clearance_um"], 20.0, places=9)
        unused = run("run", MOTOR, "--json", "--set", "heat.inlet=50 degC", *SHORT)
        self.assertTrue(any("heat.inlet" in warning for warning in json.loads(unused.stdout)["warnings"]))

    def test_oil_that_goes_round_churns_less_and_is_warned_of(self):
        rest = json.loads(run("run", MOTOR, "--json", *SHORT).stdout)
        done = run("run", MOTOR, "--json", "--set", "drag.mixture=carried", *SHORT)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotEqual(json.loads(done.stdout)["heat_W"]["churning"], rest["heat_W"]["churning"])
        self.assertEqual(run("run", MOTOR, "--json", "--set", "drag.mixture=still", *SHORT).returncode, 2)

    def test_animation_plays_the_run(self):
        try:
            import matplotlib  # noqa: F401
            import netCDF4  # noqa: F401
        except ImportError:
            self.skipTest("pictures need matplotlib and netCDF4")
        with tempfile.TemporaryDirectory() as folder:
            out, film = Path(folder) / "out", Path(folder) / "motor.gif"
            self.assertEqual(run("run", MOTOR, "-o", out, "--quiet", *SHORT).returncode, 0)
            animate = [sys.executable, "-m", "orbearing.animate"]
            done = subprocess.run([*animate, str(out), "-o", str(film), "--frames", "4"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(film.read_bytes()[:6], b"GIF89a")
            nothing = subprocess.run([*animate, folder, "-o", str(film)], capture_output=True, text=True)
            self.assertNotEqual(nothing.returncode, 0)
            self.assertIn("required: the folder of a run of a ball bearing in time", nothing.stderr)

    def test_the_printed_form_gives_like_statistics(self):
        complete = json.loads(run("run", MOTOR, "--json", *SHORT).stdout)
        done = run("run", MOTOR, "--json", "--set", "simulation.form=printed", "--set", "simulation.step=2 us", *SHORT)
        self.assertEqual(done.returncode, 0, done.stderr)
        printed = json.loads(done.stdout)
        self.assertAlmostEqual(printed["inner"]["load_rms_N"] / complete["inner"]["load_rms_N"], 1.0, delta=0.01)

    def test_refusals_name_the_field(self):
        without_cage = run("run", CASES / "ball_6305_iso16281" / "case.yaml", "--json",
                           "--set", "simulation.duration=0.1 s")
        self.assertEqual(without_cage.returncode, 2)
        for path in ("bearing.cage.width", "bearing.cage.density", "simulation.duration"):
            self.assertIn(path, without_cage.stderr)
        tilt = run("run", MOTOR, "--json", "--set", "load.tilt=1 mrad", *SHORT)
        self.assertEqual(tilt.returncode, 2)
        self.assertIn("load.tilt", tilt.stderr)
        missing = run("run", MOTOR, "--json", "--set", "simulation.start=rolling", "--set", "simulation.duration=-1 s")
        self.assertEqual(missing.returncode, 2)

    def test_static_case_is_not_touched(self):
        static = run("run", CASES / "ball_6305_iso16281" / "case.yaml", "--json")
        self.assertEqual(static.returncode, 0, static.stderr)
        self.assertIn("L10r_Mrev", json.loads(static.stdout))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
