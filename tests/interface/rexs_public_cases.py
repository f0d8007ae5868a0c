#!/usr/bin/env python3
"""REXS files that people exchange, with what is right of them by elementary geometry and statics (facts and figures of the second collection of public cases).

The files are not part of the project: ORBEARING_REFERENCE names their folder, with rexs/ and public_cases_2/.
"""

import json
import os
import pathlib
import tempfile
import unittest

import program

orbearing = program.package()

from orbearing.rexs.__main__ import main  # noqa: E402

REFERENCE = pathlib.Path(os.environ.get("ORBEARING_REFERENCE", "/nonexistent"))
FILES = REFERENCE / "public_cases_2"
NO_REFERENCE = "ORBEARING_REFERENCE names no folder with public_cases_2/: the published files are not part of the project"


@unittest.skipUnless(FILES.is_dir(), NO_REFERENCE)
class PublicFiles(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.out = pathlib.Path(place.name) / "out"

    def convert(self, file, code):
        """The report."""
        result = program.within(main, file, "-o", self.out, "--json")
        self.assertEqual(result.returncode, code, result.stderr)
        return json.loads(result.stdout)

    def said(self, file, code=2):
        """What is printed for people."""
        result = program.within(main, file, "-o", self.out)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        return result.stdout + result.stderr

    def near(self, value, right, tolerance):
        self.assertLessEqual(abs(value / right - 1.0), tolerance, (value, right))

    def all_near(self, values, right, tolerance):
        for value, one in zip(values, right, strict=True):
            self.near(value, one, tolerance)

    def bearing(self, report, name):
        return next(one for one in report["bearings"] if name in one["name"])

    def case(self, path):
        return orbearing.load(self.out / path)

    def forces(self, report, name, key="radial_force_N"):
        """Of a bearing under each load case."""
        return [one["figures"][key] for one in self.bearing(report, name)["load_cases"]]


class Gearbox(PublicFiles):
    def test_two_stages_with_a_load_spectrum(self):
        """bearinx_two_stage_1_6: geometry to 1e-4, speeds to 1e-5, forces of 6210 and cage under each load case to 0.2 %."""
        report = self.convert(FILES / "FVA-Industriegetriebe_2_stufig_1-6.rexs", 2)
        self.all_near([one["figures"]["centre_distance_mm"] for one in report["pairs"]], (190.0, 190.0), 1e-4)
        self.all_near(self.forces(report, "6210-2Z"), (3821.2, 1688.1, 2263.2, 4365.6), 1e-4)
        self.all_near(self.forces(report, "6210-2Z", "axial_force_N"), (3344.8, 2035.2, 2690.0, 4654.4), 1e-4)
        self.all_near(self.forces(report, "K 50x58x25"), (5715.6, 3660.9, 4829.4, 8225.5), 1e-4)
        shares = [one["share"] for one in self.bearing(report, "6210-2Z")["load_cases"]]
        self.all_near(shares, (0.2, 0.3, 0.35, 0.15), 1e-12)
        self.all_near(self.forces(report, "6210-2Z", "shaft_speed_rpm"), (543, 3456, 1234, 789), 1e-9)
        self.all_near([abs(one) for one in self.forces(report, "33016", "shaft_speed_rpm")], (287.471, 1829.647, 653.294, 417.706), 1e-5)
        self.all_near(self.forces(report, "33014", "shaft_speed_rpm"), (194.465, 1237.702, 441.934, 282.566), 1e-5)
        for name in ("33014", "33012", "K 50x58x25", "33016"):  # tapered and concept bearings are no case; their forces are reported
            self.assertIsNone(self.bearing(report, name)["case"])
            self.assertTrue(all(force > 1000.0 for force in self.forces(report, name)))
        # Lives of a case for each load, and of all together by the rule of Palmgren and Miner.
        entry = self.bearing(report, "6210-2Z")
        lives = [one["figures"]["L10h"] for one in entry["load_cases"]]
        self.assertAlmostEqual(lives[2] / 4606.0, 1.0, 3)
        self.near(entry["lives"]["L10h"], 1.0 / sum(share / life for share, life in zip(shares, lives)), 1e-9)
        for one, force in zip(entry["load_cases"], (3821.2, 1688.1, 2263.2, 4365.6)):
            self.near(self.case(one["case"])["load.radial"], force, 1e-4)
        self.assertEqual(sorted(one["figures"]["speed_rpm"] for one in report["shafts"])[-1], 1234.0)
        self.assertEqual([one["figures"]["outside_diameters_mm"] for one in report["shafts"]], [[50.0, 60.0, 50.0], [80.0, 90.0, 80.0], [70.0] * 4 + [80.0, 60.0]])
        reasons = {(entry["attribute"], str(entry["value"])): entry["reason"] for entry in report["left_out"]}
        self.assertIn("plausible", reasons["tip_diameter", "1.0"])  # of a gear of 23 teeth
        for pair, ratios in zip(report["pairs"], ((1.47047, 1.26747), (1.53764, 0.62927))):
            mesh = program.answer("mesh", self.out / pair["case"], "pair.root_fillet_radius=0")["meshes"][0]
            self.near(mesh["contact_ratio"], ratios[0], 1e-4)
            self.near(mesh["overlap_ratio"], ratios[1], 1e-4)
        summary = self.said_again("FVA-Industriegetriebe_2_stufig_1-6.rexs")
        self.assertIn("load case 3: 2263.24 N radial, 2689.97 N axial for 35 % of the time", summary)
        self.assertIn("all load cases together: L10h ", summary)

    def said_again(self, name):
        self.out = self.out.parent / "again"
        return self.said(FILES / name)

    def test_the_same_gearbox_in_version_1_4(self):
        report = self.convert(REFERENCE / "rexs" / "FVA-Industriegetriebe_2stufig_1-4.rexs", 2)
        self.all_near(self.forces(report, "6210-2Z"), (3821.2, 1688.1, 2263.2, 4365.6), 1e-4)
        self.all_near(self.forces(report, "K 50x58x25"), (5715.6, 3660.9, 4829.4, 8225.5), 1e-4)
        self.assertEqual(report["notes"], [])

    def test_gears_of_version_1_0_are_where_they_are_in_space(self):
        """6207: 6.243 kN (7.644 half a face width off); 6308: 2.021 kN (0.920)."""
        report = self.convert(REFERENCE / "rexs" / "SEW_3-stage_cylindrical_gearbox_1.0.rexs", 2)
        for name, force in (("6207", 6243.4), ("6308", 2021.4)):
            self.near(self.bearing(report, name)["figures"]["radial_force_N"], force, 1e-4)
        self.assertTrue(any("u_coordinate_on_shaft of 6 gears" in note and "half a face width" in note for note in report["notes"]), report["notes"])


class Planetary(PublicFiles):
    def test_power_in_place_of_torque(self):
        """rexs_planetary_power_1_4."""
        report = self.convert(FILES / "FVA_Planetary_stage_-_Minus_gearing_1.1_vers2.rexsj", 0)
        self.assertEqual(report["version"], "1.4")
        figures = report["stages"][0]["figures"]
        for name, right, tolerance in (("centre_distance_mm", 78.0, 1e-9), ("sun_torque_N_m", 636.62, 1e-5), ("carrier_speed_rpm", 326.923, 1e-5),
                                       ("carrier_torque_N_m", -2920.96, 1e-5), ("planet_relative_speed_rpm", 906.469, 1e-5), ("pin_force_N", 12482.8, 1e-3)):
            self.near(figures[name], right, tolerance)
        case = self.case(report["stages"][0]["case"])
        self.assertEqual([case[f"gearset.teeth.{name}"] for name in ("sun", "planet", "ring")], [17, 22, 61])
        self.assertEqual((case.given("input.power"), case.given("input.speed"), case.given("input.member")), ("100 kW", "1500 rpm", "sun"))
        self.assertTrue(any("lubricant" in note and "without a bearing does not use" in note for note in report["notes"]), report["notes"])


class Beside(PublicFiles):
    """rexs_external_database: shaft and bearing in other files of the folder."""

    def report(self, example, name="placeholder_model.rexs"):
        return self.convert(FILES / "rexs_external" / f"example_{example}" / name, 2)

    def test_a_bearing_and_a_shaft_of_a_library(self):
        report = self.report(1)
        figures = self.bearing(report, "Rolling bearing")["figures"]
        for name, right in {"bore_mm": 30.0, "outside_diameter_mm": 62.0, "width_mm": 20.0, "rows": 2, "contact_angle_deg": 11.68, "C_kN": 66.1, "C0_kN": 60.0,
                            "C_u_kN": 6.4, "e_C": 0.5, "e": 0.31, "Y1": 2.2, "Y2": 3.3}.items():
            self.near(figures[name], right, 1e-12)
        self.assertEqual(report["shafts"][0]["figures"]["outside_diameters_mm"], [30.0, 50.0])
        self.assertEqual(report["notes"], [])
        self.assertEqual({entry["file"] for entry in report["left_out"] if "file" in entry}, {"./database_bearing.rexs", "./database_shaft.rexs"})

    def test_what_is_missing_is_named(self):
        for example, said in ((7, "the file './database_bearing.rexs' is not in the folder of the model"), (9, "the file './database_shaft.rexs' has no component 60"),
                              (3, "the file './database_material.rexs' has no component 42"),
                              (4, "component 8 of the file './database_material.rexs' is a material, this one a shaft")):
            self.out = self.out.parent / f"example{example}"
            report = self.report(example)
            self.assertTrue(any(said in note for note in report["notes"]), report["notes"])
            if example in (7, 9):
                self.assertIn(said, report["bearings"][0]["problems"][0])
                self.assertEqual(report["shafts"][0]["figures"]["outside_diameters_mm"], [30.0, 50.0])  # the rest is reported
        self.out = self.out.parent / "example8"
        report = self.report(8, "placeholder_model.rexsj")
        self.assertTrue(any("which has 'database_bearing.rexsj'" in note for note in report["notes"]), report["notes"])

    def test_a_library_alone(self):
        entry = self.report(1, "database_bearing.rexs")["bearings"][0]
        self.assertIn("no relation side states between which parts it is: load and speeds do not follow from the file", entry["problems"])
        self.assertEqual(entry["figures"]["C_kN"], 66.1)

    def test_the_other_examples_are_read(self):
        for example in (2, 5, 6):
            self.out = self.out.parent / f"example{example}"
            self.assertEqual(self.report(example)["notes"], [])


class Refused(PublicFiles):
    """rexs_wrong_contents."""

    def test_a_worm_stage(self):
        said = self.said(FILES / "FVA_worm_stage_1-4.rexs")
        self.assertIn("no case: a worm stage: cylindrical gears are known", said)
        self.assertIn("no planetary stage found; 1 gear pair, 4 bearings, 2 shafts in conversion.json", said)
        self.assertEqual(said.count("\n  shaft "), 2)

    def test_archives(self):
        said = self.said(FILES / "no_rexs_file.rexsz")
        self.assertIn("a ZIP file with 0 REXS models (", said)
        self.assertEqual(said.count("\n"), 1)
        self.assertFalse(self.out.exists())
        for name in ("example_xml.rexs.zip", "example_json.rexs.zip"):
            self.out = self.out.parent / name
            self.assertIn("no planetary stage found", self.said(FILES / name))


if __name__ == "__main__":
    unittest.main()
