"""`orbearing stiffness` of ball, roller and planet bearings, from outside."""

import csv
import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import netCDF4
import numpy

CASES = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases"
SECONDS = 600


def call(*arguments):
    command = [os.environ["ORBEARING"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


def case(name):
    return CASES / name / "case.yaml"


def options(settings):
    return [part for setting in settings for part in ("--set", setting)]


def stiffness(name, *settings):
    result = call("stiffness", case(name), "--json", *options(settings))
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def run(name, *settings):
    result = call("run", case(name), "--json", *options(settings))
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


class Contract(unittest.TestCase):
    def check_points(self, found):
        self.assertEqual(found["order"], ["x", "y", "z", "tilt_x", "tilt_y"])
        self.assertIsNone(found["damping"]["value"])
        self.assertTrue(found["damping"]["reason"])
        for point in found["points"]:
            self.assertLessEqual({"speed_rpm", "load", "stiffness", "displacement"}, set(point))
            self.assertEqual(numpy.shape(point["stiffness"]), (5, 5))
            self.assertEqual(len(point["displacement"]), 5)
            self.assertEqual(point["status"], "ok")

    def test_balls(self):
        found = stiffness("jones_218")
        self.check_points(found)
        self.assertEqual([point["speed_rpm"] for point in found["points"]], [10000])
        self.assertEqual(found["points"][0]["load"]["axial_N"], 17800)

    def test_rollers(self):
        found = stiffness("harris_209")
        self.check_points(found)
        point = found["points"][0]
        self.assertEqual(point["load"]["radial_N"], 4450)
        self.assertEqual([point["stiffness"][2][i] for i in range(5)], [0] * 5)  # no axial load is borne

    def test_planets(self):
        found = stiffness("reducer_150kW")
        self.check_points(found)
        self.assertEqual([point["speed_rpm"] for point in found["points"]], [1000 * i for i in range(1, 13)])
        for point in found["points"]:
            k = numpy.array(point["stiffness"])
            self.assertLess(abs(k - k.T).max(), 1e-8 * abs(k).max())
            across = numpy.linalg.eigvalsh(k[:2, :2])
            self.assertTrue((across > 1e7).all() and (across < 2e9).all(), across)
            self.assertGreater(k[3, 3], 0)
        # At constant power the load falls with speed until rollers are thrown outward; the frame is the carrier's.
        self.assertGreater(found["points"][0]["load"]["y_N"], found["points"][5]["load"]["y_N"])

    def test_planets_of_multi_stage(self):
        found = stiffness("three_sets_150kW", "sweep.input.speed=[3000 rpm, 6000 rpm]")
        self.check_points(found)
        self.assertEqual(len({point["set"] for point in found["points"]}) * 2, len(found["points"]))


class Values(unittest.TestCase):
    def test_run_has_the_same(self):
        for name in ("jones_218", "harris_209", "ball_6305_iso16281"):
            self.assertEqual(run(name)["stiffness"], stiffness(name)["points"][0]["stiffness"], name)

    def test_displacement_is_that_of_run(self):
        settings = ["load.axial=500 N", "load.moment=3 N.m"]
        point, found = stiffness("ball_6305_iso16281", *settings)["points"][0], run("ball_6305_iso16281", *settings)
        x, y, z, about_x, about_y = point["displacement"]
        self.assertAlmostEqual(1e6 * x, found["displacement"]["radial_um"], places=9)
        self.assertAlmostEqual(1e6 * z, found["displacement"]["axial_um"], places=9)
        self.assertAlmostEqual(-1e3 * about_y, found["tilt_mrad"], places=9)
        self.assertAlmostEqual(y, 0, places=12)
        self.assertAlmostEqual(about_x, 0, places=12)

    # The check of a user: a little more load, and the displacement of the ring.
    def test_slope_of_what_run_prints(self):
        for speed in ("0 rpm", "9000 rpm"):
            common = [f"operation.shaft_speed={speed}", "operation.speeds=[0 rpm]"]
            where = lambda axial: run("spin_bearing_7210", *common, f"load.axial={axial} N")["displacement"]["axial_um"]
            slope = 10.0 / (1e-6 * (where(10005) - where(9995)))
            point = stiffness("spin_bearing_7210", f"operation.speeds=[{speed}]")["points"][0]
            self.assertLess(abs(slope / point["stiffness"][2][2] - 1), 1e-6)

    def test_symmetric_at_rest(self):
        for name in ("jones_218", "harris_209"):
            point = stiffness(name, "operation.shaft_speed=0 rpm")["points"][0]
            k = numpy.array(point["stiffness"])
            self.assertLess(abs(k - k.T).max(), 1e-10 * abs(k).max())

    def test_over_speed_and_load(self):
        found = stiffness("spin_bearing_7210", "operation.speeds=[0 rpm, 5000 rpm, 10000 rpm]", "operation.load_factors=[0.5, 1]",
                          "film.enabled=false")
        points = found["points"]
        self.assertEqual([(point["speed_rpm"], point["load"]["axial_N"]) for point in points],
                         [(0, 5000), (5000, 5000), (10000, 5000), (0, 10000), (5000, 10000), (10000, 10000)])
        self.assertGreater(points[3]["stiffness"][2][2], points[0]["stiffness"][2][2])
        axial = [point["stiffness"][2][2] for point in points[3:]]
        self.assertGreater(axial[0], axial[2])  # balls thrown outward soften an angular-contact row


class Files(unittest.TestCase):
    def test_files_hold_the_same(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "out"
            settings = options(["operation.speeds=[2000 rpm, 8000 rpm]", "operation.load_factors=[0.5, 1]"])
            result = call("stiffness", case("spin_bearing_7210"), "-o", folder, "--json", *settings)
            self.assertEqual(result.returncode, 0, result.stderr)
            points = json.loads(result.stdout)["points"]
            with netCDF4.Dataset(folder / "points" / "00000.nc") as data:
                for i, point in enumerate(points):
                    numpy.testing.assert_array_equal(data["stiffness"][i], point["stiffness"])
                    numpy.testing.assert_array_equal(data["displacement"][i], point["displacement"])
                    self.assertAlmostEqual(float(data["speed"][i]) * 30 / math.pi, point["speed_rpm"], places=8)
                    self.assertEqual(float(data["load_axial"][i]), point["load"]["axial_N"])
            with open(folder / "stiffness.csv", newline="") as stream:
                for row, point in zip(csv.DictReader(stream), points, strict=True):
                    self.assertEqual(float(row["k_z_z [N/m]"]), point["stiffness"][2][2])
                    self.assertEqual(float(row["k_tilt_x_y [N m/m]"]), point["stiffness"][3][1])
            for number in (1, 2):
                self.check_sheet((folder / f"ross_{number}.xls").read_bytes(), points[2 * number - 2:2 * number])
            self.assertEqual(call("stiffness", case("spin_bearing_7210"), "-o", folder).returncode, 2)

    def check_sheet(self, content, points):
        cells, at = {}, 0
        while at < len(content):
            kind, length = struct.unpack_from("<HH", content, at)
            data, at = content[at + 4:at + 4 + length], at + 4 + length
            if kind == 0x0203:
                row, column, _, value = struct.unpack("<HHHd", data)
                cells[row, column] = value
            elif kind == 0x0204:
                row, column, _, size = struct.unpack_from("<HHHH", data)
                cells[row, column] = data[8:8 + size].decode()
        heads = [cells[0, i] for i in range(10)]
        self.assertEqual(heads[:9], ["kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy", "speed"])
        self.assertIn("x is along the load", heads[9])  # across_over_along: weight in ROSS is along y
        self.assertIn("in ROSS is along y", heads[9])
        # Five rows at least; those between the points are linear.
        rows = max(row for row, _ in cells)
        parts = -(-4 // (len(points) - 1))
        self.assertEqual(rows, 1 + parts * (len(points) - 1))
        self.assertGreaterEqual(rows, 5)
        for row in range(1, rows + 1):
            before, share = divmod(row - 1, parts)
            first, second = points[before], points[min(before + 1, len(points) - 1)]
            wanted = [[(1 - share / parts) * a + share / parts * b for a, b in zip(*pair)] for pair in zip(first["stiffness"][:2], second["stiffness"][:2])]
            for i in range(4):
                self.assertAlmostEqual(cells[row, i], wanted[i // 2][i % 2], delta=1e-12 * abs(wanted[0][0]))
            speed = first["speed_rpm"] + share / parts * (second["speed_rpm"] - first["speed_rpm"])
            self.assertAlmostEqual(cells[row, 8], speed * math.pi / 30, places=9)


class Refusals(unittest.TestCase):
    def test_cases_without_a_bearing_in_balance(self):
        for name in ("mesh_62_62", "lin_parker_1999", "deep_groove_motor", "scratch_defect", "spin_film_guo2013"):
            result = call("stiffness", case(name), "--json")
            self.assertEqual((result.returncode, result.stdout), (2, ""), name)
            self.assertIn("required", result.stderr)

    def test_somewhere_to_go(self):
        self.assertEqual(call("stiffness", case("jones_218")).returncode, 2)

    def test_bad_input(self):
        for setting in ("operation.load_factors=[0]", "operation.speeds=[5 m]", "operation.speeds=[]"):
            self.assertEqual(call("stiffness", case("jones_218"), "--json", "--set", setting).returncode, 2, setting)
        self.assertEqual(call("stiffness", case("reducer_150kW"), "--json", "--set", "operation.speeds=[5 rpm]").returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
