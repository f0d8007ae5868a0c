#!/usr/bin/env python3
"""REXS files that people exchange, with what is right of them by elementary geometry and statics (facts and figures of public cases).

Each case is held by files of the same contents that rexs_files.py writes. The published files themselves are not part of the project: ORBEARING_REFERENCE
names their folder, with rexs/ and public_cases_2/, and they are read as well where it does.
"""

import json
import os
import pathlib
import tempfile
import unittest
import zipfile

import program
import rexs_files

orbearing = program.package()

from orbearing.rexs.__main__ import main  # noqa: E402

REFERENCE = pathlib.Path(os.environ.get("ORBEARING_REFERENCE", "/nonexistent"))
FILES = REFERENCE / "public_cases_2"
NO_REFERENCE = "ORBEARING_REFERENCE names no folder with public_cases_2/: the published files are not part of the project"


published = unittest.skipUnless(FILES.is_dir(), NO_REFERENCE)


class PublicFiles(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)
        self.out = self.place / "out"

    def made(self, model, name="model.rexs"):
        return model.write(self.place / name)

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
        self.two_stages(self.made(rexs_files.coaxial_gearbox()), [70.0, 80.0, 60.0])

    def shares(self, *stated):
        """The gearbox with other shares of time [%] of its load cases; None: not stated."""
        model = rexs_files.coaxial_gearbox()
        for i, share in enumerate(stated):
            number, parts = model.load_cases[i]
            unit = [(component, kind, [("operating_time_fraction", share, "%")] if share is not None else []) for component, kind, _ in parts[:1]]
            model.load_cases[i] = (number, unit + parts[1:])
        return self.convert(self.made(model), 2)

    def test_a_load_case_that_never_acts_does_no_damage(self):
        report = self.shares(20.0, 0.0, 65.0, 15.0)
        self.assertEqual(report["notes"], [])
        entry = self.bearing(report, "6210-2Z")
        lives = [one["figures"]["L10h"] for one in entry["load_cases"]]
        self.near(entry["lives"]["L10h"], 1.0 / (0.2 / lives[0] + 0.65 / lives[2] + 0.15 / lives[3]), 1e-9)

    def test_a_load_case_without_a_share_is_named(self):
        report = self.shares(20.0, None, 65.0, 15.0)
        self.assertIn("no share of time is stated of load case 2: lives under all load cases together are left out", report["notes"])
        self.assertEqual(self.bearing(report, "6210-2Z")["lives"], {})

    def test_gears_without_a_place_are_on_their_shafts(self):
        report = self.convert(self.made(rexs_files.coaxial_gearbox(places=False)), 2)
        self.all_near(self.forces(report, "6210-2Z"), (3821.2, 1688.1, 2263.2, 4365.6), 1e-4)

    def test_a_force_along_one_axis_without_its_place_leaves_all_forces_open(self):
        """The load at the front states a force along v alone: its moment is not known."""
        model = rexs_files.coaxial_gearbox()
        model.components = [(number, kind, name, [row for row in rows if (number, row[0]) != (52, "u_coordinate_on_shaft")])
                            for number, kind, name, rows in model.components]
        report = self.convert(self.made(model), 2)
        self.assertNotIn("radial_force_N", self.bearing(report, "6210-2Z")["load_cases"][0]["figures"])

    @published
    def test_the_published_file(self):
        self.two_stages(FILES / "FVA-Industriegetriebe_2_stufig_1-6.rexs", [70.0] * 4 + [80.0, 60.0])

    def test_the_other_hand_has_other_forces(self):
        """A reader that takes a positive helix for a left-handed one finds these."""
        model = rexs_files.coaxial_gearbox()
        model.components = [(number, kind, name, [(key, (-value if key == "helix_angle_reference_diameter" else value), unit) for key, value, unit in rows])
                            for number, kind, name, rows in model.components]
        report = self.convert(self.made(model), 2)
        self.all_near(self.forces(report, "6210-2Z"), (5467.3, 2917.3, 3874.5, 6976.0), 1e-4)
        self.all_near(self.forces(report, "K 50x58x25"), (4354.3, 2885.6, 3802.2, 6412.0), 1e-4)

    def two_stages(self, file, sections):
        """bearinx_two_stage_1_6: geometry to 1e-4, speeds to 1e-5, forces of 6210 and cage under each load case to 0.2 %."""
        report = self.convert(file, 2)
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
        self.assertEqual([one["figures"]["outside_diameters_mm"] for one in report["shafts"]], [[50.0, 60.0, 50.0], [80.0, 90.0, 80.0], sections])
        reasons = {(entry["attribute"], str(entry["value"])): entry["reason"] for entry in report["left_out"]}
        self.assertIn("plausible", reasons["tip_diameter", "1.0"])  # of a gear of 23 teeth
        for pair, ratios in zip(report["pairs"], ((1.47047, 1.26747), (1.53764, 0.62927))):
            mesh = program.answer("mesh", self.out / pair["case"], "pair.root_fillet_radius=0")["meshes"][0]
            self.near(mesh["contact_ratio"], ratios[0], 1e-4)
            self.near(mesh["overlap_ratio"], ratios[1], 1e-4)
        self.out = self.place / "again"
        summary = self.said(file)
        self.assertIn("load case 3: 2263.24 N radial, 2689.97 N axial for 35 % of the time", summary)
        self.assertIn("all load cases together: L10h ", summary)

    @published
    def test_the_same_gearbox_in_version_1_4(self):
        report = self.convert(REFERENCE / "rexs" / "FVA-Industriegetriebe_2stufig_1-4.rexs", 2)
        self.all_near(self.forces(report, "6210-2Z"), (3821.2, 1688.1, 2263.2, 4365.6), 1e-4)
        self.all_near(self.forces(report, "K 50x58x25"), (5715.6, 3660.9, 4829.4, 8225.5), 1e-4)
        self.assertEqual(report["notes"], [])

    @published
    def test_gears_of_version_1_0_are_where_they_are_in_space(self):
        """6207: 6.243 kN (7.644 half a face width off); 6308: 2.021 kN (0.920)."""
        report = self.convert(REFERENCE / "rexs" / "SEW_3-stage_cylindrical_gearbox_1.0.rexs", 2)
        for name, force in (("6207", 6243.4), ("6308", 2021.4)):
            self.near(self.bearing(report, name)["figures"]["radial_force_N"], force, 1e-4)
        self.assertTrue(any("u_coordinate_on_shaft of 6 gears" in note and "half a face width" in note for note in report["notes"]), report["notes"])


class Planetary(PublicFiles):
    def test_power_in_place_of_torque(self):
        for name in ("model.rexs", "model.rexsj"):
            self.out = self.place / f"out_{name}"
            self.powered(self.made(rexs_files.powered_planets(), name))

    @published
    def test_the_published_file(self):
        self.powered(FILES / "FVA_Planetary_stage_-_Minus_gearing_1.1_vers2.rexsj")

    def powered(self, file):
        """rexs_planetary_power_1_4."""
        report = self.convert(file, 0)
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

    def shelf(self, name, form=".rexs", **parts):
        """The report of a model in a folder of its own, beside both libraries."""
        folder = self.place / name
        folder.mkdir()
        rexs_files.shelf_bearing().write(folder / f"bearings{form}")
        rexs_files.shelf_shaft().write(folder / f"shafts{form}")
        self.out = folder / "out"
        return self.convert(rexs_files.on_the_shelf(**parts).write(folder / f"model{form}"), 2)

    def is_22206(self, report, files):
        figures = self.bearing(report, "Rolling bearing")["figures"]
        for name, right in {"bore_mm": 30.0, "outside_diameter_mm": 62.0, "width_mm": 20.0, "rows": 2, "contact_angle_deg": 11.68, "C_kN": 66.1, "C0_kN": 60.0,
                            "C_u_kN": 6.4, "e_C": 0.5, "e": 0.31, "Y1": 2.2, "Y2": 3.3}.items():
            self.near(figures[name], right, 1e-12)
        self.assertEqual(report["shafts"][0]["figures"]["outside_diameters_mm"], [30.0, 50.0])
        self.assertEqual(report["notes"], [])
        for key in ("taken", "left_out"):
            self.assertLessEqual({entry["file"] for entry in report[key] if "file" in entry}, files)
        self.assertEqual({entry["file"] for entry in report["left_out"] if "file" in entry}, files)

    def test_a_bearing_and_a_shaft_of_a_library(self):
        self.is_22206(self.shelf("one"), {"./bearings.rexs", "./shafts.rexs"})
        self.out = self.place / "again"
        said = self.said(self.place / "one" / "model.rexs")
        self.assertIn("    30 x 62 x 20 mm, 2 rows, contact angle 11.68 deg, C 66.1 kN, C0 60 kN, C_u 6.4 kN, e_C 0.5, e 0.31, Y1 2.2, Y2 3.3\n", said)
        self.assertIn("  shaft 3 'Shaft [3]': outside diameters 30, 50 mm\n", said)

    def test_what_is_missing_is_named(self):
        for name, said, form, parts in (
                ("no_file", "the file './none.rexs' is not in the folder of the model", ".rexs", {"bearing": "./none.rexs"}),
                ("no_part", "the file './shafts.rexs' has no component 60", ".rexs", {"bearing": "./shafts.rexs"}),
                ("material", "component 50 of the file './shafts.rexs' is a material, this one a shaft", ".rexs", {"shaft_id": 50}),
                ("json", "which has 'bearings.rexsj'", ".rexsj", {"shaft": "./shafts.rexsj"})):
            report = self.shelf(name, form, **parts)
            self.assertTrue(any(said in note for note in report["notes"]), report["notes"])
            if name.startswith("no_"):
                self.assertIn(said, report["bearings"][0]["problems"][0])
                self.assertEqual(report["shafts"][0]["figures"]["outside_diameters_mm"], [30.0, 50.0])  # the rest is reported

    def test_a_library_alone(self):
        self.of_a_library(self.convert(self.made(rexs_files.shelf_bearing()), 2))

    def of_a_library(self, report):
        entry = report["bearings"][0]
        self.assertIn("no relation side states between which parts it is: load and speeds do not follow from the file", entry["problems"])
        self.assertEqual(entry["figures"]["C_kN"], 66.1)

    @published
    def test_published_files(self):
        folder = FILES / "rexs_external"
        report = self.convert(folder / "example_1" / "placeholder_model.rexs", 2)
        self.is_22206(report, {"./database_bearing.rexs", "./database_shaft.rexs"})
        self.out = self.place / "alone"
        self.of_a_library(self.convert(folder / "example_1" / "database_bearing.rexs", 2))
        for example, said in ((7, "the file './database_bearing.rexs' is not in the folder of the model"), (9, "the file './database_shaft.rexs' has no component 60"),
                              (3, "the file './database_material.rexs' has no component 42"),
                              (4, "component 8 of the file './database_material.rexs' is a material, this one a shaft"), (8, "which has 'database_bearing.rexsj'")):
            self.out = self.place / f"example{example}"
            report = self.convert(folder / f"example_{example}" / ("placeholder_model.rexs" + "j" * (example == 8)), 2)
            self.assertTrue(any(said in note for note in report["notes"]), report["notes"])
        for example in (2, 5, 6):
            self.out = self.place / f"example{example}"
            self.assertEqual(self.convert(folder / f"example_{example}" / "placeholder_model.rexs", 2)["notes"], [])


class Refused(PublicFiles):
    """rexs_wrong_contents."""

    def test_a_worm_stage(self):
        self.worm(self.made(rexs_files.worm_gearbox()))

    def worm(self, file):
        said = self.said(file)
        self.assertIn("no case: a worm stage: cylindrical gears are known", said)
        self.assertIn("no planetary stage found; 1 gear pair, 4 bearings, 2 shafts in conversion.json", said)
        self.assertEqual(said.count("\n  shaft "), 2)

    def archive(self, name, **members):
        with zipfile.ZipFile(self.place / name, "w") as archive:
            for member, text in members.items():
                archive.writestr(member.replace("__", "."), text)
        return self.place / name

    def test_archives(self):
        beside = {"teeth__gde": "", "neutral_data__knd": ""}
        said = self.said(self.archive("no_model.rexsz", **beside))
        self.assertIn("a ZIP file with 0 REXS models (teeth.gde, neutral_data.knd)", said)
        self.assertEqual(said.count("\n"), 1)
        self.assertFalse(self.out.exists())
        bare = rexs_files.Rexs()
        bare.add(1, "gear_unit", "empty")
        for name, member, text in (("xml.rexs.zip", "example__rexs", bare.xml()), ("json.rexs.zip", "example__rexsj", bare.json())):
            self.out = self.place / name.split(".")[0]
            self.assertIn("no planetary stage found", self.said(self.archive(name, **{member: text}, **beside)))

    @published
    def test_published_files(self):
        self.worm(FILES / "FVA_worm_stage_1-4.rexs")
        self.out = self.place / "none"
        self.assertIn("a ZIP file with 0 REXS models (", self.said(FILES / "no_rexs_file.rexsz"))
        self.assertFalse(self.out.exists())
        for name in ("example_xml.rexs.zip", "example_json.rexs.zip"):
            self.out = self.place / name.split(".")[0]
            self.assertIn("no planetary stage found", self.said(FILES / name))


if __name__ == "__main__":
    unittest.main()
