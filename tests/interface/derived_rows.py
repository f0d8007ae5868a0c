#!/usr/bin/env python3
"""What `check` derives, beside closed forms: gears (working angles, contact and overlap ratios), speeds, forces, races.

Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import math
import unittest

from program import CASES, REDUCER, WIND, answer

PAIR = CASES / "mesh_62_62" / "case.yaml"


def involute(angle):
    return math.tan(angle) - angle


def inverse_involute(value):
    low, high = 0.0, 1.5
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if involute(middle) < value else (low, middle)
    return middle


class Case:
    """Inputs as numbers of SI, rows by path with their units."""

    SIZES = {"mm": 1e-3, "um": 1e-6, "deg": math.pi / 180, "rpm": math.pi / 30, "kW": 1e3, "g": 1e-3, "kg": 1.0, "N": 1.0, "N.m": 1.0, "N/m": 1.0, "Hz": 1.0, "1": 1.0, "": 1.0,
             "kg/m3": 1.0}

    def __init__(self, case, *settings):
        data = answer("check", case, *settings)
        self.given = {row["path"]: row["given"] for row in data["inputs"]}
        self.rows = {row["path"]: row for row in data["derived"]}

    def input(self, path):
        words = self.given[path].split()
        return float(words[0]) * self.SIZES[words[1] if len(words) > 1 else ""]

    def pair(self, path):
        return [float(word) for word in self.given[path].strip("[]").split(",")]

    def row(self, path):
        row = self.rows[path]
        return row["value"] * self.SIZES[row["unit"]]


class Derived(unittest.TestCase):
    def close(self, case, path, value, unit, relative=1e-9):
        self.assertEqual(case.rows[path]["unit"], unit, path)
        self.assertAlmostEqual(case.row(path), value, delta=relative * max(abs(value), 1e-12), msg=path)

    def test_lives_of_a_single_bearing_under_its_load(self):
        """ISO 281 by hand from the rows that `check` shows, and the lives that a run gives for the same case."""
        settings = ("operation.shaft_speed=3000 rpm", "lubricant.grade=ISO VG 68", "life.cleanliness=high", "life.reliability=0.95")
        for case, exponent in (("ball_6305_iso16281", 3), ("harris_209", 10 / 3)):
            with self.subTest(case):
                file = CASES / case / "case.yaml"
                one, run = Case(file, *settings), answer("run", file, *settings)
                at = {path: row["value"] for path, row in one.rows.items()}
                hours = 1e6 / (60 * 3000)
                ratio = run["C_N"] / at["life.equivalent_load"]
                self.close(one, "life.load_ratio", ratio, "1")
                units = {"life.L10": "Mrev", "life.L10h": "h", "life.kappa": "1", "life.e_C": "1", "life.a_ISO": "1", "life.L10m": "Mrev", "life.L10mh": "h"}
                self.assertEqual({path: row["unit"] for path, row in one.rows.items() if path in units}, units)
                reliable = 0.95 * (math.log(0.95) / math.log(0.9)) ** (2 / 3) + 0.05
                for path, value in (("life.L10", ratio**exponent), ("life.L10h", hours * ratio**exponent),
                                    ("life.L10m", reliable * at["life.a_ISO"] * ratio**exponent), ("life.L10mh", hours * at["life.L10m"])):
                    self.assertAlmostEqual(at[path] / value, 1, delta=1e-9, msg=path)
                for path, key in (("life.L10", "L10_Mrev"), ("life.L10m", "L10m_Mrev"), ("life.L10h", "L10h"), ("life.L10mh", "L10mh"), ("life.kappa", "kappa"), ("life.e_C", "e_C"),
                                  ("life.a_ISO", "a_ISO")):
                    self.assertAlmostEqual(at[path] / run[key], 1, delta=1e-9, msg=path)

    def test_a_pair_of_gears_with_shifts_and_helix(self):
        case = Case(PAIR, "pair.helix_angle=12 deg", "pair.profile_shift=[0.2, 0.1]", "pair.teeth=[31, 47]")
        normal, helix, module = math.radians(20), math.radians(12), case.input("pair.module")
        transverse = math.atan(math.tan(normal) / math.cos(helix))
        z, x = case.pair("pair.teeth"), case.pair("pair.profile_shift")
        working = inverse_involute(involute(transverse) + 2 * math.tan(normal) * sum(x) / sum(z))
        base = [0.5 * module / math.cos(helix) * teeth * math.cos(transverse) for teeth in z]
        centre = sum(base) / math.cos(working)
        tips = [module * (0.5 * teeth / math.cos(helix) + 1.0 + shift) for teeth, shift in zip(z, x)]
        path = sum(math.sqrt(tip**2 - b**2) for tip, b in zip(tips, base)) - centre * math.sin(working)
        self.close(case, "pair.centre_distance", centre, "mm")
        self.close(case, "pair.working_pressure_angle", working, "deg")
        self.close(case, "pair.contact_ratio", path / (math.pi * module / math.cos(helix) * math.cos(transverse)), "1", 1e-6)
        self.close(case, "pair.overlap_ratio", case.input("pair.face_width") * math.sin(helix) / (math.pi * module), "1")
        meshes = answer("mesh", PAIR, "pair.helix_angle=12 deg", "pair.profile_shift=[0.2, 0.1]", "pair.teeth=[31, 47]")["meshes"]
        self.close(case, "pair.mesh_stiffness", meshes[0]["mean_N_per_m"], "N/m", 1e-6)

    def test_parts_of_a_mesh_by_gear(self):
        """Each gear's parts and the contact are compliances in series, and named after their own gear."""
        mesh = answer("mesh", PAIR, "pair.teeth=[31, 47]")["meshes"][0]
        point = mesh["at_pitch_point"]
        parts = [one[f"{part}_N_per_m"] for one in point["gears"] for part in ("bending", "shear", "axial", "foundation")]
        self.assertAlmostEqual(1 / point["pair_N_per_m"], 1 / point["hertz_N_per_m"] + sum(1 / part for part in parts), delta=1e-9 / point["pair_N_per_m"])
        self.assertEqual([one["gear"] for one in point["gears"]], ["first gear", "second gear"])

    def gears(self, case):
        z = {name: case.input(f"gearset.teeth.{name}") for name in ("sun", "planet", "ring")}
        x = {"sun": case.input("gearset.profile_shift.sun"), "ring": case.input("gearset.profile_shift.ring"), "planet": case.row("gearset.profile_shift.planet")}
        return z, x

    def test_meshes_of_a_planetary_set(self):
        for file in (REDUCER, WIND):
            case = Case(file)
            z, x = self.gears(case)
            normal, helix, module = case.input("gearset.pressure_angle"), case.input("gearset.helix_angle"), case.input("gearset.module")
            transverse = math.atan(math.tan(normal) / math.cos(helix))
            pitch = module / math.cos(helix) * math.cos(transverse)  # of the base circles: 2 r_b / z
            sun = inverse_involute(involute(transverse) + 2 * math.tan(normal) * (x["sun"] + x["planet"]) / (z["sun"] + z["planet"]))
            ring = inverse_involute(involute(transverse) + 2 * math.tan(normal) * (x["ring"] - x["planet"]) / (z["ring"] - z["planet"]))
            self.close(case, "gearset.sun_mesh.pressure_angle", sun, "deg", 1e-7)
            self.close(case, "gearset.ring_mesh.pressure_angle", ring, "deg", 1e-7)
            for teeth, angle in ((z["sun"] + z["planet"], sun), (z["ring"] - z["planet"], ring)):
                self.close(case, "gearset.centre_distance", 0.5 * pitch * teeth / math.cos(angle), "mm", 1e-7)
            self.close(case, "gearset.planet_angle", 2 * math.pi / case.input("gearset.planets"), "deg")
            if helix:
                self.close(case, "gearset.transverse_module", module / math.cos(helix), "mm")
                self.close(case, "gearset.base_helix_angle", math.asin(math.sin(helix) * math.cos(normal)), "deg")
                self.close(case, "gearset.overlap_ratio", case.input("gearset.face_width") * math.sin(helix) / (math.pi * module), "1")

    def test_contact_ratios_of_a_set_whose_teeth_are_not_undercut(self):
        """Between the tips: the wind stage's meshes have unlike paths of contact."""
        case = Case(WIND)
        z, x = self.gears(case)
        normal, helix, module = case.input("gearset.pressure_angle"), case.input("gearset.helix_angle"), case.input("gearset.module")
        transverse = math.atan(math.tan(normal) / math.cos(helix))
        base = {name: 0.5 * module / math.cos(helix) * teeth * math.cos(transverse) for name, teeth in z.items()}
        tip = {name: module * (0.5 * z[name] / math.cos(helix) + sign * (1.0 + sign * x[name])) for name, sign in (("sun", 1), ("planet", 1), ("ring", -1))}
        reach = {name: math.sqrt(tip[name] ** 2 - base[name] ** 2) for name in z}
        centre, step = case.row("gearset.centre_distance"), math.pi * module / math.cos(helix) * math.cos(transverse)
        sun, ring = (case.row(f"gearset.{name}_mesh.pressure_angle") for name in ("sun", "ring"))
        self.close(case, "gearset.sun_mesh.contact_ratio", (reach["sun"] + reach["planet"] - centre * math.sin(sun)) / step, "1", 1e-6)
        self.close(case, "gearset.ring_mesh.contact_ratio", (reach["planet"] - reach["ring"] + centre * math.sin(ring)) / step, "1", 1e-6)

    def test_speeds_and_forces(self):
        for file in (REDUCER, WIND):
            case = Case(file)
            z, _ = self.gears(case)
            speed, planets = case.input("input.speed"), case.input("gearset.planets")
            by_sun = case.given["input.member"] == "sun"
            carrier = speed * z["sun"] / (z["sun"] + z["ring"]) if by_sun else speed
            sun = speed if by_sun else speed * (z["sun"] + z["ring"]) / z["sun"]
            power = case.input("input.power") * (1 if by_sun else -1)  # of the sun on the gears
            self.close(case, "operation.carrier_speed", carrier, "rpm")
            self.close(case, "operation.planet_speed", -(sun - carrier) * z["sun"] / z["planet"], "rpm")
            self.close(case, "gearset.dynamics.mesh_frequency", (sun - carrier) * z["sun"] / (2 * math.pi), "Hz")
            torque = power / sun
            self.close(case, "operation.input_torque_sun", torque, "N.m")
            normal, helix, module = case.input("gearset.pressure_angle"), case.input("gearset.helix_angle"), case.input("gearset.module")
            transverse = math.atan(math.tan(normal) / math.cos(helix))
            base = 0.5 * module / math.cos(helix) * z["sun"] * math.cos(transverse)
            force = abs(torque) / planets / base
            self.close(case, "operation.mesh_normal_force", force, "N")
            angles = [case.row(f"gearset.{name}_mesh.pressure_angle") for name in ("sun", "ring")]
            bearings = float(case.given.get("bearing.per_planet", "1"))
            sense = 1 if by_sun else -1
            self.close(case, "operation.bore_load_y", sense * force * sum(map(math.cos, angles)) / bearings, "N", 1e-6)
            centrifugal = case.row("gearset.planet_mass") * case.row("gearset.centre_distance") * carrier**2
            radial = force * (math.sin(angles[0]) - math.sin(angles[1]))
            self.close(case, "operation.bore_load_x", (centrifugal + radial) / bearings, "N", 1e-6)
            if helix:
                axial = force * math.tan(math.asin(math.sin(helix) * math.cos(normal)))
                self.close(case, "operation.mesh_axial_force", axial, "N", 1e-6)
                self.close(case, "operation.thrust.sun", planets * axial, "N", 1e-6)
                self.close(case, "operation.thrust.ring", -planets * axial, "N", 1e-6)

    def test_cost_of_one_pin_off(self):
        """K_gamma and the shortest life with one pin off by js7, as a run with that error gives them."""
        rows = Case(REDUCER).rows
        size = 1e3 * Case(REDUCER).row("gearset.centre_distance")
        error = 0.5 * 16 * (0.45 * size ** (1 / 3) + 0.001 * size)  # [um]
        run = answer("run", REDUCER, f"gearset.dynamics.pin_error.tangential=[{error:.6g} um, 0 um, 0 um, 0 um]")["points"][0]
        for path, key, unit in (("one_pin_off.load_share", "largest_load_share", "1"), ("one_pin_off.shortest_life", "shortest_life_h", "h")):
            self.assertEqual(rows[path]["unit"], unit)
            self.assertAlmostEqual(rows[path]["value"] / run[key], 1, delta=1e-9)
        self.assertGreater(rows["one_pin_off.load_share"]["value"], 1.5)
        # A rim that bends lets the planets share better.
        self.assertLess(Case(REDUCER, "gearset.planet_rim=elastic").rows["one_pin_off.load_share"]["value"], rows["one_pin_off.load_share"]["value"])

    def test_races_and_rollers(self):
        for file in (REDUCER, WIND):
            case = Case(file)
            pitch, roller, clearance = (case.input(f"bearing.{name}") for name in ("pitch_diameter", "roller_diameter", "radial_clearance"))
            self.close(case, "bearing.inner_raceway_diameter", pitch - roller - clearance / 2, "mm")
            self.close(case, "bearing.outer_raceway_diameter", pitch + roller + clearance / 2, "mm")


if __name__ == "__main__":
    unittest.main()
