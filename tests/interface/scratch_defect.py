"""`orbearing run`, `check` and `report` of a bearing with scratches, from outside."""

import csv
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import netCDF4
import numpy

CASE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases" / "scratch_defect" / "case.yaml"
SECONDS = 600
BRIEF = "signal.revolutions=20"


def call(*arguments):
    command = [os.environ["ORBEARING"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


def options(settings):
    return [part for setting in settings for part in ("--set", setting)]


def run(*settings):
    """JSON of one run."""
    result = call("run", CASE, "--json", *options(settings))
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def peak(found, name):
    return next(one for one in found["envelope_peaks"] if one["is"] == name)


class Json(unittest.TestCase):
    def test_keys_of_the_contract(self):
        found = run(BRIEF)
        for key in ("shaft_Hz", "cage_Hz", "defect_Hz"):
            self.assertIsInstance(found[key], float, key)
        for one in found["envelope_peaks"]:
            self.assertEqual(set(one), {"frequency_Hz", "amplitude", "is"})
        levels = [one["amplitude"] for one in found["envelope_peaks"]]
        self.assertEqual(levels, sorted(levels, reverse=True))
        self.assertEqual(found["warnings"], [])

    def test_another_bearing_has_other_lines(self):
        other = ["bearing.balls=9", "bearing.ball_diameter=7.94 mm", "bearing.pitch_diameter=39.04 mm", "operation.shaft_speed=1800 rpm",
                 "bearing.radial_clearance=5 um", "load.radial=600 N", BRIEF]
        gamma = 7.94 / 39.04
        for race, multiple in (("outer", 4.5 * (1 - gamma)), ("inner", 4.5 * (1 + gamma))):
            found = run(f"defect.race={race}", *other)
            self.assertAlmostEqual(found["defect_Hz"], 30 * multiple, places=9)
            self.assertAlmostEqual(peak(found, f"{race} race defect")["frequency_Hz"], 30 * multiple, delta=0.005 * 30 * multiple)

    def test_side_bands_are_those_of_the_shaft(self):
        found = run("defect.race=inner", BRIEF)
        middle = peak(found, "inner race defect")["frequency_Hz"]
        for name, side in (("inner race defect - shaft", -25), ("inner race defect + shaft", 25)):
            self.assertAlmostEqual(peak(found, name)["frequency_Hz"] - middle, side, delta=0.125)

    def test_a_scratched_ball(self):
        found = run("defect.race=ball", BRIEF)
        gamma = 11.509 / 48.5
        self.assertAlmostEqual(found["defect_Hz"], 25 / gamma * (1 - gamma**2), places=9)
        self.assertAlmostEqual(peak(found, "ball defect")["frequency_Hz"], found["defect_Hz"], delta=0.005 * found["defect_Hz"])

    def test_without_a_scratch_it_says_what_is_idle(self):
        found = run("defect.race=none", BRIEF)
        self.assertIsNone(found["defect_Hz"])
        self.assertTrue(all("ball passage" in one["is"] for one in found["envelope_peaks"]))
        self.assertTrue(any(text.startswith("defect.width") for text in found["warnings"]))

    def test_check(self):
        result = call("check", CASE, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        derived = {row["path"]: row["value"] for row in json.loads(result.stdout)["derived"]}
        self.assertAlmostEqual(derived["defect.outer_pass_frequency"], 76.3, delta=0.05)


class RunUp(unittest.TestCase):
    def test_orders_beside_the_envelope_and_in_the_picture(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "out"
            result = call("run", CASE, "-o", folder, "--json", *options(["defect.race=inner", "signal.run_up_from=0.5", BRIEF]))
            self.assertEqual(result.returncode, 0, result.stderr)
            found = json.loads(result.stdout)
            self.assertEqual((found["envelope_peaks"], found["spectrum_peaks"]), ([], []))
            for one in found["orders"]:
                self.assertEqual(set(one), {"order", "amplitude", "is"})
            order = next(one["order"] for one in found["orders"] if one["is"] == "inner race defect")
            self.assertAlmostEqual(order, 123.73 / 25, delta=0.005 * 123.73 / 25)
            with netCDF4.Dataset(folder / "points" / "00000.nc") as data:
                self.assertEqual(data["order"].units, "1")
                self.assertTrue((numpy.diff(data["shaft_angle"][...]) > 0).all())
            report = call("report", folder)
            self.assertEqual(report.returncode, 0, report.stderr)
            page = (folder / "report.html").read_text()
            self.assertIn("order of the shaft", page)
            self.assertIn("turns of the shaft: ", page)

    def test_a_steady_run_has_none(self):
        self.assertIsNone(run(BRIEF)["orders"])


class Rollers(unittest.TestCase):
    ROLLERS = CASE.parents[1] / "scratched_rollers" / "case.yaml"

    def test_a_scratched_roller(self):
        result = call("run", self.ROLLERS, "--json", "--set", "defect.race=roller", "--set", BRIEF)
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads(result.stdout)
        self.assertEqual(found["warnings"], [])
        self.assertAlmostEqual(found["defect_Hz"], 25 * (6.5 - 1 / 6.5), places=9)
        self.assertAlmostEqual(peak(found, "roller defect")["frequency_Hz"], found["defect_Hz"], delta=0.005 * found["defect_Hz"])

    def test_what_it_cannot(self):
        for arguments, words in ((["--fidelity", "dynamic"], "planetary drivetrain with a block 'defect'"),
                                 (["--set", "defect.race=ball"], "'ball' in a bearing of rollers"),
                                 (["--set", "bearing.balls=8"], "bearing.balls")):
            result = call("run", self.ROLLERS, "--json", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
            self.assertIn(words, result.stderr)


class Files(unittest.TestCase):
    def test_folder_and_report(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "out"
            result = call("run", CASE, "-o", folder, "--json", "--set", BRIEF)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(json.loads((folder / "defect.json").read_text()), json.loads(result.stdout))
            with netCDF4.Dataset(folder / "points" / "00000.nc") as data:
                signal = numpy.asarray(data["acceleration"][0])
                rate = float(data["sampling_rate"][...])
                self.assertEqual(data["acceleration"].units, "m s-2")
                for name in ("displacement", "ball_load", "ball_deflection", "envelope", "acceleration_spectrum", "envelope_spectrum"):
                    self.assertTrue(numpy.isfinite(data[name][...]).all(), name)
            self.check_csv(folder, signal, rate)
            self.check_wav(folder, signal, rate)
            again = call("run", CASE, "-o", folder, "--set", BRIEF)
            self.assertEqual(again.returncode, 2)
            self.assertEqual(call("run", CASE, "-o", folder, "--resume", "--set", BRIEF).returncode, 0)
            report = call("report", folder)
            self.assertEqual(report.returncode, 0, report.stderr)
            page = (folder / "report.html").read_text()
            for slug in ("defect-vibration", "defect-envelope", "defect-spectrum", "defect-ball"):
                self.assertIn(f'<section id="{slug}">', page)
            self.assertEqual(page.count("<svg"), 5)
            self.assertIn("outer race defect", page)

    def check_csv(self, folder, signal, rate):
        with open(folder / "signal.csv", newline="") as stream:
            rows = list(csv.reader(stream))
        self.assertEqual(rows[0], ["time_s", "acceleration_m_s2"])
        self.assertEqual(len(rows) - 1, len(signal))
        self.assertAlmostEqual(float(rows[2][0]), 1 / rate, places=12)
        self.assertAlmostEqual(float(rows[100][1]), signal[99], delta=1e-8 * abs(signal).max())

    def check_wav(self, folder, signal, rate):
        content = (folder / "signal.wav").read_bytes()
        self.assertEqual(content[:4] + content[8:16], b"RIFFWAVEfmt ")
        kind, channels, per_second, _, _, bits = struct.unpack("<HHIIHH", content[20:36])
        self.assertEqual((kind, channels, per_second, bits), (3, 1, round(rate), 32))
        samples = numpy.frombuffer(content[44:], "<f4")
        self.assertEqual(len(samples), len(signal))
        self.assertLess(abs(samples - signal / abs(signal).max()).max(), 1e-6)


class Refusals(unittest.TestCase):
    def test_bad_input(self):
        for setting, words in (("defect.race=cage", "none of the choices"), ("defect.width=20 mm", "half a ball diameter"),
                               ("operation.shaft_speed=0 rpm", "a speed is required"), ("operation.shaft_speed=25 Hz", "states no angle"),
                               ("signal.sampling_rate=100 rad/s", "angle"), ("signal.sampling_rate=1 kHz", "samples a revolution"),
                               ("signal.band=[4 kHz]", "lower and upper end"), ("load.radial=0 N", "radial load greater"),
                               ("bearing.balls=30", "do not fit"), ("load.axial=5 N", "does not use")):
            result = call("run", CASE, "--json", "--set", setting)
            self.assertEqual(result.returncode, 2, setting)
            self.assertIn(words, result.stderr, setting)
            self.assertEqual(result.stdout, "")

    def test_what_a_scratch_needs(self):
        text = CASE.read_text().replace("  width: 0.8 mm\n", "")
        with tempfile.TemporaryDirectory() as place:
            file = pathlib.Path(place) / "case.yaml"
            file.write_text(text)
            result = call("run", file, "--json")
            self.assertEqual(result.returncode, 2)
            self.assertIn("defect.race: 'outer' without defect.width", result.stderr)

    def test_other_rungs(self):
        self.assertEqual(call("run", CASE, "--json", "--fidelity", "monolithic").returncode, 2)
        self.assertEqual(call("sweep", CASE, "--json").returncode, 2)

    def test_all_in_motion(self):
        """--fidelity dynamic: the same keys, and what the cage really turned."""
        short = ("--set", "signal.revolutions=4", "--set", "signal.sampling_rate=25.6 kHz")
        result = call("run", CASE, "--json", "--fidelity", "dynamic", *short)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        found = json.loads(result.stdout)
        self.assertEqual(found["warnings"], [])
        self.assertAlmostEqual(found["defect_Hz"], 76.27, delta=0.01)
        turned = found["turned"]
        self.assertAlmostEqual(turned["outer_pass_Hz"], 8 * turned["cage_Hz"], delta=1e-9)
        self.assertAlmostEqual(turned["cage_Hz"], (1 - turned["cage_slip"]) * found["cage_Hz"], delta=1e-9)
        ball = call("run", CASE, "--json", "--fidelity", "dynamic", "--set", "defect.race=ball")
        self.assertEqual(ball.returncode, 0, ball.stderr)
        found = json.loads(ball.stdout)
        self.assertAlmostEqual(peak(found, "cage")["frequency_Hz"], found["turned"]["cage_Hz"], delta=0.05 * found["turned"]["cage_Hz"])
        unfelt = call("run", CASE, "--json", "--fidelity", "dynamic", *short, "--set", "contact.damping_ratio=0.1")
        self.assertIn("contact.damping_ratio", json.loads(unfelt.stdout)["warnings"][0])
        cage = call("run", CASE, "--json", *short, "--set", "bearing.cage.density=1400 kg/m3")
        self.assertIn("bearing.cage.density", json.loads(cage.stdout)["warnings"][0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
