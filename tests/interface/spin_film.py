"""`orbearing run` and `check` of a contact that rolls and spins, and of a ball bearing on such films, from outside."""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import netCDF4

CASES = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases"
FILM = CASES / "spin_film_guo2013" / "case.yaml"
BEARING = CASES / "spin_bearing_7210" / "case.yaml"
SECONDS = 600
KEYS = ["load_N", "rolling_speed_m_s", "spin_rad_s", "h_c_um", "h_min_um", "h_c_HamrockDowson_um", "h_min_HamrockDowson_um"]
# Rows of [Guo2013]: load, rolling speed, spin; film, then that of Hamrock and Dowson, central and least.
PRINTED = [(500, 5, 200, 0.4041, 0.3210, 0.4040, 0.3268), (500, 10, 300, 0.6429, 0.4891, 0.6428, 0.5236),
           (500, 15, 400, 0.8436, 0.6015, 0.8435, 0.6898)]
ASKED = 0.015


def call(*arguments):
    command = [os.environ["ORBEARING"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


def run(case, *settings):
    result = call("run", case, "--json", *(part for setting in settings for part in ("--set", setting)))
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


class Contact(unittest.TestCase):
    def test_keys_and_printed_rows(self):
        found = run(FILM)
        self.assertEqual(found["warnings"], [])
        self.assertEqual(len(found["film"]), len(PRINTED))
        for row, printed in zip(found["film"], PRINTED):
            self.assertEqual(list(row)[: len(KEYS)], KEYS)
            for key, value in zip(KEYS, printed):
                self.assertLess(abs(row[key] / value - 1), ASKED, (key, printed))

    def test_points_by_an_option(self):
        found = run(FILM, "points=[[1500 N, 5 m/s, 200 rad/s], [1.5 kN, 600 m/min, 0.3 rad/ms]]")["film"]
        self.assertEqual([[row[key] for key in KEYS[:3]] for row in found], [[1500, 5, 200], [1500, 10, 300]])
        # Spin leaves the central film as it is and lowers the least one.
        still = run(FILM, "points=[[1500 N, 5 m/s, 0 rad/s]]")["film"][0]
        self.assertEqual(still["h_c_um"], found[0]["h_c_um"])
        self.assertGreater(still["h_min_um"], found[0]["h_min_um"])
        self.assertEqual(still["h_min_HamrockDowson_um"], found[0]["h_min_HamrockDowson_um"])

    def test_what_lies_beyond_the_regressions_is_reported(self):
        warnings = run(FILM, "points=[[500 N, 5 m/s, 200 rad/s], [100 N, 50 m/s, 900 rad/s]]")["warnings"]
        self.assertEqual(len(warnings), 3)
        for warning, word in zip(warnings, ("rolling speed", "load", "spin")):
            self.assertIn("row 2", warning)
            self.assertIn(word, warning)
        self.assertTrue(any("ellipticity" in one for one in run(FILM, "contact.ellipticity=12")["warnings"]))

    def test_what_is_assumed_is_reported(self):
        assumed = {row["key"] for row in run(FILM)["assumptions"]}
        for path in ("contact.rolling_radius", "contact.ellipticity", "lubricant.viscosity", "lubricant.pressure_viscosity"):
            self.assertIn(path, assumed)
        inputs = {row["path"]: row for row in json.loads(call("check", FILM, "--json").stdout)["inputs"]}
        self.assertEqual(inputs["points"]["value"][1], [500, 10, 300])

    def test_a_contact_is_an_ellipse_or_a_line(self):
        with tempfile.TemporaryDirectory() as place:
            neither = pathlib.Path(place) / "case.yaml"
            neither.write_text("".join(line + "\n" for line in FILM.read_text().splitlines() if "ellipticity" not in line))
            refused = call("run", neither, "--json")
            self.assertEqual(refused.returncode, 2)
            self.assertIn("contact.ellipticity: missing", refused.stderr)
            self.assertIn("or contact.length instead", refused.stderr)
            line = pathlib.Path(place) / "line"
            done = call("run", CASES / "reynolds_line" / "case.yaml", "-o", line, "--json")
            row = json.loads(done.stdout)["film"][0]
            self.assertEqual(list(row)[3:], ["h_c_um", "h_min_um", "h_flow_um", "h_min_DowsonHigginson_um", "rolling_resistance_N", "status"])
            self.assertTrue((line / "film_line_1.csv").read_text().startswith("x_mm,pressure_GPa,film_um,oil_fraction\n"))

    def test_folder(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "out"
            self.assertEqual(call("run", FILM, "-o", folder, "--quiet").stdout, "")
            with open(folder / "film.csv", newline="") as stream:
                rows = list(csv.DictReader(stream))
            with netCDF4.Dataset(folder / "points" / "00000.nc") as data:
                for i, row in enumerate(rows):
                    self.assertAlmostEqual(float(row["h_min_um"]), 1e6 * float(data["h_min"][i]), places=8)
            again = run(folder / "case.resolved.yaml")
            self.assertEqual(again["film"], run(FILM)["film"])
            self.assertEqual(call("run", FILM, "-o", folder).returncode, 2)
            self.assertEqual(call("run", FILM, "-o", folder, "--resume").returncode, 0)

    def test_a_film_that_is_not_solved_fails(self):
        thin = ["film.solver=reynolds", "contact.ellipticity=1", "points=[[2000 N, 0.001 m/s, 0 rad/s]]"]
        done = call("run", FILM, "--json", *(part for setting in thin for part in ("--set", setting)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual([row["status"] for row in json.loads(done.stdout)["film"]], ["failed"])

    def test_bad_input(self):
        for setting, words in (("points=[[1500 N, 5 m/s]]", "rows [load, rolling speed, spin]"), ("points=[1500 N]", "as a row"),
                               ("points=[[1500 N, 5 m/s, 200 Hz]]", "states no angle"), ("points=[[-5 N, 5 m/s, 0 rad/s]]", "out of range"),
                               ("points=[[5 m, 5 m/s, 0 rad/s]]", "force"), ("points=[]", "points"), ("contact.ellipticity=-1", "out of range"),
                               ("bearing.balls=5", "does not use"), ("sweep.contact.ellipticity=[1, 2]", "a sweep of a")):
            result = call("run", FILM, "--json", "--set", setting)
            self.assertEqual((result.returncode, result.stdout), (2, ""), setting)
            self.assertIn(words, result.stderr, setting)
        self.assertEqual(call("run", FILM, "--json", "--fidelity", "dynamic").returncode, 2)
        self.assertEqual(call("sweep", FILM, "--json").returncode, 2)


class Bearing(unittest.TestCase):
    def test_films_of_both_races(self):
        found = run(BEARING)
        self.assertEqual(len(found["film"]), 30)
        for row in found["film"]:
            self.assertEqual(set(row), {"ball", "race", *KEYS, "h_0_um"})
        first = {row["race"]: row for row in found["film"] if row["ball"] == 0}
        self.assertAlmostEqual(first["inner"]["load_N"], found["contact_loads_N"][0], places=9)
        self.assertAlmostEqual(first["outer"]["load_N"], found["outer_contact_loads_N"][0], places=9)
        self.assertTrue(any("outside of the ranges" in one for one in found["warnings"]))
        self.assertNotIn("film", run(BEARING, "film.enabled=false"))

    # Figs. 7 to 12.
    def test_over_speed(self):
        found = run(BEARING)
        rows = found["over_speed"]
        self.assertEqual([row["speed_rpm"] for row in rows][:2], [0, 500])
        rows = rows[1:]
        difference = [row["hertz_axial_um"] - row["film_axial_um"] for row in rows]
        self.assertGreater(difference[0], 0)
        self.assertEqual(difference, sorted(difference))
        for race, sign in (("inner", 1), ("outer", -1)):
            for key, direction in (("load_N", -sign), ("contact_angle_deg", sign)):
                values = [direction * row[f"film_{race}_{key}"] for row in rows]
                self.assertEqual(values, sorted(values), (race, key))
                for row in rows:
                    self.assertLess(abs(row[f"film_{race}_{key}"] / row[f"hertz_{race}_{key}"] - 1), 0.02)
            central = [row[f"film_{race}_h_c_um"] for row in rows]
            self.assertEqual(central, sorted(central))
            least = [row[f"film_{race}_h_min_um"] for row in rows]
            turning = found["least_film_turns_at_rpm"][race]
            self.assertAlmostEqual(rows[least.index(max(least))]["speed_rpm"], turning, delta=250)
            self.assertTrue(10000 < turning < 14000, turning)

    def test_one_speed_is_the_table_s(self):
        row = run(BEARING, "operation.speeds=[9000 rpm]")["over_speed"][0]
        found = run(BEARING, "operation.shaft_speed=9000 rpm")
        self.assertAlmostEqual(row["film_axial_um"], found["displacement"]["axial_um"], places=9)
        self.assertAlmostEqual(row["film_inner_load_N"], max(found["contact_loads_N"]), places=6)
        self.assertIsNone(run(BEARING, "operation.speeds=[9000 rpm]")["least_film_turns_at_rpm"]["inner"])

    def test_film_on_rings_at_rest_is_reported(self):
        settings = ["operation.shaft_speed=0 rpm", "operation.speeds=[0 rpm]"]
        self.assertTrue(any(one.startswith("film.enabled") for one in run(BEARING, *settings)["warnings"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
