#!/usr/bin/env python3
"""Several records with shares or hours, lives and damage by file with --case, time in skid risk, the exponent of the life in use."""

import csv
import json
import os
import pathlib
import tempfile
import unittest

from program import REDUCER, answer, run, settings

REFERENCE = pathlib.Path(os.environ.get("ORBEARING_REFERENCE", "/nowhere"))
SAME = 1e-9
LIVES = ("life_h", "L10h", "L10rh", "L10mh", "L10mrh")
OIL = ("lubricant.grade=ISO VG 220", "life.cleanliness=-/15/12")
NO_INERTIA = ("inertia.carrier_centrifugal=false", "inertia.own_orbit=false", "inertia.coriolis=false")
# Torque [N m] and speed [rpm]: a high load, a low one, idling.
LOADS = {"high": (400.0, 3000.0), "low": (150.0, 6000.0), "idle": (1.0, 1000.0)}


class RatedRecords(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.files = {name: self.record(name, [load] * 3) for name, load in LOADS.items()}

    def record(self, name, loads):
        file = self.folder / f"{name}.csv"
        file.write_text("time_s,speed_rpm,torque_N_m\n" + "".join(f"{i},{speed},{torque}\n" for i, (torque, speed) in enumerate(loads)))
        return file

    def spectrum(self, *arguments, values=()):
        result = run("spectrum", *arguments, "--json", *settings(values))
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def refusal(self, *arguments):
        result = run("spectrum", *arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stdout + result.stderr)
        return result.stderr

    def assert_near(self, found, right, tolerance=SAME):
        self.assertLess(abs(found / right - 1.0), tolerance, (found, right))

    def test_several_records_by_share_and_by_hours(self):
        high, low, idle = self.files.values()
        found = self.spectrum(high, low, "--share", "0.3, 0.7", "-o", self.folder / "loads.csv")
        self.assertNotIn("series", found)
        self.assertEqual([(one["file"], one["samples"], one["share"]) for one in found["files"]], [(str(high), 3, 0.3), (str(low), 3, 0.7)])
        self.assertEqual([(one["file"], one["share"]) for one in found["bins"]], [(str(high), 0.3), (str(low), 0.7)])
        for one, (torque, speed) in zip(found["bins"], LOADS.values()):
            self.assert_near(one["torque_N_m"], torque)
            self.assert_near(one["speed_rpm"], speed)
        hours = self.spectrum(high, low, idle, "--hours", "300,700,1000", "-o", self.folder / "hours.csv")
        self.assertEqual([(one["share"], one["hours"]) for one in hours["bins"]], [(0.15, 300.0), (0.35, 700.0), (0.5, 1000.0)])
        # Files that a case takes: damage by file there, too.
        for name, column in (("loads.csv", "share"), ("hours.csv", "hours")):
            with open(self.folder / name, encoding="utf-8") as stream:
                self.assertEqual(next(csv.reader(stream)), ["torque_N_m", "speed_rpm", column, "file"])
        spectrum = answer("run", REDUCER, f"spectrum={{file: {self.folder}/loads.csv}}")["spectrum"]
        self.assertEqual([one["file"] for one in spectrum["files"]], [str(high), str(low)])
        self.assertEqual([one["damage_share"] for one in spectrum["files"]], [one["damage_share"] for one in spectrum["bins"]])

    def test_bins_of_several_records_have_the_same_edges(self):
        wide = self.record("wide", [(100.0, 1000.0), (500.0, 1000.0), (500.0, 1000.0)])
        narrow = self.record("narrow", [(100.0, 1000.0), (140.0, 1000.0), (140.0, 1000.0)])
        found = self.spectrum(wide, narrow, "--share", "0.5,0.5", "--bins", "4x1")
        self.assertEqual([one["file"] for one in found["bins"]], [str(wide), str(wide), str(narrow)])
        self.assert_near(found["bins"][2]["torque_N_m"], ((100.0**4 + 140.0**4) / 2) ** 0.25)

    def test_shares_and_hours_that_do_not_fit_are_refused(self):
        high, low, _ = self.files.values()
        for words, said in (
                ((high, low), "--share: missing together with 2 files; required: the share of time of each file, as in --share 0.3,0.7, or the hours, as in --hours 1000,5000"),
                ((high, low, "--share", "0.3,0.7", "--hours", "1,2"), "--hours: found together with --share; required: one of both"),
                ((high, low, "--share", "0.3,0.6"), "--share: found a sum of 0.9; required: 1; --hours require no sum"),
                ((high, low, "--share", "0,3,0,7"), "--share: found 4 numbers for 2 files; required: one for each file"),
                ((high, low, "--share", "30%,70%"), "--share: found '30%'; required: numbers from 0, comma between them"),
                ((high, low, "--hours", "-1,2"), "--hours: found '-1'; required: numbers from 0, comma between them"),
                ((high, low, "--hours", "0,0"), "--hours: found a sum of 0; required: finite hours above 0 for at least one file"),
                ((high, high, "--share", "0.3,0.7"), f"SERIES: found {high} twice; required: each file once"),
                ((high, "--set", "input.power=1 kW"), "--set requires --case"),
                ((high, "--case", REDUCER, "--set", "spectrum=[{power: 1 kW, speed: 1000 rpm, share: 1}]"),
                 "--set: spectrum: found together with records; required: one of both"),
                ((high, "--case", REDUCER.parents[1] / "harris_209" / "case.yaml"), "model: found roller-bearing; required: planetary-drivetrain"),
                ((high, "--case", REDUCER, "--resume"), "--resume: found without a folder; required: -o DIR, the folder to continue")):
            with self.subTest(said):
                self.assertIn(said, self.refusal(*words, "--json"))

    def test_lives_and_damage_by_bin_and_by_file_are_those_of_the_case(self):
        high, low, idle = self.files.values()
        out = self.folder / "out"
        found = self.spectrum(high, low, idle, "--hours", "300,600,100", "--case", REDUCER, "-o", out, values=OIL)
        spectrum = found["spectrum"]
        alone = {name: answer("run", REDUCER, *OIL, f"input.speed={speed} rpm", f"input.torque={torque} N.m")["points"][0]
                 for name, (torque, speed) in LOADS.items()}
        for life in LIVES:
            used = sum(share / alone[name][life] for name, share in zip(LOADS, (0.3, 0.6, 0.1)))
            self.assert_near(spectrum[life] * used, 1.0)
        for one, (name, share) in zip(spectrum["files"], zip(LOADS, (0.3, 0.6, 0.1))):
            self.assertEqual((one["file"], one["hours"]), (str(self.files[name]), 1000.0 * share))
            for key, life in (("damage_share", "life_h"), ("damage_share_L10mh", "L10mh")):
                self.assert_near(one[key], share / alone[name][life] * spectrum[life])
        self.assert_near(sum(one["damage_share"] for one in spectrum["bins"]), 1.0)
        self.assertEqual(spectrum["used_up"], 1000.0 / spectrum["life_h"])
        # Kept as a run keeps it: with the rows in the case, which gives the same again.
        with open(out / "spectrum.csv", encoding="utf-8") as stream:
            self.assertEqual([row["file"] for row in csv.DictReader(stream)], [str(file) for file in self.files.values()])
        again = answer("run", out / "case.resolved.yaml")["spectrum"]
        self.assertEqual(again, spectrum)
        resumed = self.spectrum(high, low, idle, "--hours", "300,600,100", "--case", REDUCER, "-o", out, "--resume", values=OIL)
        self.assertEqual(resumed["spectrum"], spectrum)
        # A name that ends in .csv keeps the rows.
        rows = self.folder / "rows.csv"
        self.spectrum(high, low, idle, "--hours", "300,600,100", "--case", REDUCER, "-o", rows, values=OIL)
        self.assertEqual(answer("run", REDUCER, *OIL, f"spectrum={{file: {rows}}}")["spectrum"], spectrum)

    def test_time_in_skid_risk(self):
        high, low, idle = self.files.values()
        arguments = (high, low, idle, "--hours", "300,600,100", "--case", REDUCER)
        found = self.spectrum(*arguments, values=NO_INERTIA)
        spectrum = found["spectrum"]
        (told,) = [one for one in found["assumptions"] if one["key"] == "life.minimum_load"]
        self.assertEqual((told["value"], told["reason"]), ("0.02", "default: makers' rule of thumb for roller bearings [SKFMinimumLoad]"))
        self.assertEqual((spectrum["minimum_load"], spectrum["skid_risk_share"], spectrum["skid_risk_hours"]), (0.02, 0.1, 100.0))
        for one in spectrum["bins"]:
            self.assertEqual(one["skid_risk"], one["P_N"] < 0.02 * one["C_N"])
        self.assertEqual([one["skid_risk_hours"] for one in spectrum["files"]], [0.0, 0.0, 100.0])
        # A minimum load of the user's own: between the loads of both other bins.
        loads = sorted(one["P_N"] / one["C_N"] for one in spectrum["bins"])
        own = f"life.minimum_load={0.5 * (loads[1] + loads[2]):.4f}"
        spectrum = self.spectrum(*arguments, values=(*NO_INERTIA, own))["spectrum"]
        self.assertEqual([one["skid_risk"] for one in spectrum["bins"]], [False, True, True])
        self.assertEqual(spectrum["skid_risk_hours"], 700.0)
        # In sweeps, of shares, with time at rest, where nothing skids.
        rows = "spectrum=[{torque: 400 N.m, speed: 3000 rpm, share: 0.5}, {torque: 1 N.m, speed: 1000 rpm, share: 0.2}, {power: 0 kW, speed: 0 rpm, share: 0.3}]"
        swept = answer("sweep", REDUCER, rows, *NO_INERTIA, "sweep.input.speed=[6000 rpm]", options=("--grid-only",))["spectrum"]
        self.assertEqual((swept["skid_risk_share"], [one["skid_risk"] for one in swept["bins"]]), (0.2, [False, True, False]))
        self.assertNotIn("skid_risk_hours", swept)
        both = answer("sweep", REDUCER, rows, *NO_INERTIA, "sweep={life.minimum_load: [0.02, 0.9]}", options=("--grid-only",))["spectrum"]
        self.assertEqual([(one["minimum_load"], one["skid_risk_share"]) for one in both], [(0.02, 0.2), (0.9, 0.7)])
        self.assertNotIn("files", swept)
        unused = answer("run", REDUCER, "life.minimum_load=0.03")
        self.assertTrue(any("life.minimum_load" in warning for warning in unused["warnings"]), unused["warnings"])
        text = run("spectrum", *arguments, *settings(NO_INERTIA)).stdout
        self.assertIn("skid risk: P/C below 0.02 (life.minimum_load) for 10 % of the time, 100 h", text)

    def test_a_run_states_skid_risk_and_in_motion_slip_and_losses(self):
        brief = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2")
        for power, at_risk in (("150 kW", False), ("5 kW", True)):
            duty = (f"input.power={power}", "input.speed=2000 rpm", *brief)
            still, moving = answer("run", REDUCER, *duty[:2]), answer("run", REDUCER, *duty, options=("--fidelity", "dynamic"))
            for found in (still, moving):
                (point,) = found["points"]
                self.assertEqual((found["skid_risk"], found["minimum_load"]), (at_risk, 0.02))
                self.assertAlmostEqual(found["P_over_C"], point["P_N"] / point["C_N"], places=12)
            lines = run("run", REDUCER, "--fidelity", "dynamic", *settings(duty)).stdout.splitlines()
            (point,) = moving["points"]
            self.assertEqual(lines[0], f"slip: cage {100 * point['cage_slip']:.3g} %, rollers {100 * point['roller_slip']:.3g} %")
            losses = {key[len("power_loss_"):-2].replace("_", " "): value for key, value in point.items()
                      if key.startswith("power_loss_") and key != "power_loss_W" and value}
            head, _, causes = lines[1].partition(" W: ")
            self.assertEqual(head, f"power loss of one bearing: {point['power_loss_W']:.4g}")
            self.assertEqual(causes.split(", "), [f"{name} {value:.3g}" for name, value in sorted(losses.items(), key=lambda one: -abs(one[1]))])
            self.assertAlmostEqual(sum(losses.values()) / point["power_loss_W"], 1.0, places=6)
            self.assertEqual(lines[2], f"skid risk: {'yes' if at_risk else 'no'}: P/C {moving['P_over_C']:.3g}, minimum load 0.02")

    def test_the_mean_torque_of_a_bin_is_that_of_the_life_in_use_and_never_lengthens_it(self):
        """Bins by the exponent of the life that is used, their mean conservative."""
        uneven = self.record("uneven", [(torque, 3000.0) for torque in (60.0, 400.0, 120.0, 300.0, 200.0, 80.0, 350.0, 250.0, 150.0)])
        plain = (*NO_INERTIA, "gearset.mesh_variation=false")
        for values, life, exponent in (((), "life_h", 4.0), (("life.method=iso-281",), "L10h", 10 / 3), (("life.method=iso-16281",), "L10rh", 4.0),
                                       (("life.method=iso-281", *OIL), "L10mh", 8.0), (("life.method=iso-16281", *OIL), "L10mrh", 8.0),
                                       (("requirements.life=1 h", *OIL), "L10mh", 8.0), (("requirements={life: 1 h, life_key: L10h}",), "life_h", 4.0)):
            with self.subTest(life=life, values=values):
                one, many = (self.spectrum(uneven, "--case", REDUCER, "--bins", bins, values=(*plain, *values)) for bins in ("1x1", "64x1"))
                self.assertEqual((one["torque_exponent"], len(one["bins"]), len(many["bins"])), (exponent, 1, 8))
                self.assertLessEqual(one["spectrum"][life], many["spectrum"][life] * (1.0 + 1e-6))
                if exponent < 8.0:
                    self.assert_near(one["spectrum"][life], many["spectrum"][life], 1e-6)
                # Lives that are steeper are warned of, where the case has them.
                said = [warning for warning in one["warnings"] if "too long" in warning]
                self.assertEqual(["life_h and L10rh" in text for text in said], [True] if exponent < 4.0 else [])
                self.assertEqual([text for text in many["warnings"] if "too long" in text], [])
        oil = self.spectrum(uneven, "--case", REDUCER, "--bins", "1x1", values=(*plain, *OIL))
        self.assertTrue(any("L10mh and L10mrh can be up to" in warning for warning in oil["warnings"]), oil["warnings"])
        self.assertEqual(self.spectrum(uneven, "--case", REDUCER, "--exponent", "8", values=plain)["torque_exponent"], 8.0)

    def test_rows_of_a_case_are_replaced_with_a_warning(self):
        case = self.folder / "case.yaml"
        case.write_text(REDUCER.read_text(encoding="utf-8") + "\nspectrum:\n  - {power: 150 kW, speed: 6000 rpm, share: 1, file: other}\n", encoding="utf-8")
        found = self.spectrum(self.files["low"], "--case", case)
        self.assertEqual(len(found["spectrum"]["bins"]), 1)
        self.assertIn("spectrum: the bins of the records replace the rows of the case", found["warnings"])
        check = {one["path"]: one for one in answer("check", case)["inputs"]}
        self.assertEqual(check["spectrum"]["value"][0]["file"], "other")

    @unittest.skipUnless(REFERENCE.is_dir(), "ORBEARING_REFERENCE names no folder of reference data")
    def test_simulations_of_others(self):
        folder = REFERENCE / "openfast"
        found = self.spectrum(folder / "fastout_allnodes.outb", folder / "FASTOutBin_ID4.outb", "--torque", "RotTorq", "--speed", "RotSpeed",
                              "--share", "0.4,0.6", "--bins", "3x3")
        self.assert_near(sum(one["share"] for one in found["bins"] if "allnodes" in one["file"]), 0.4)
        self.assert_near(sum(one["share"] for one in found["bins"]), 1.0)


if __name__ == "__main__":
    unittest.main()
