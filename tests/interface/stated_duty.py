#!/usr/bin/env python3
"""Duty as engineers state it, and single runs that keep nothing."""

import math
import os
import tempfile
import unittest
from pathlib import Path

from program import CASES, REDUCER, SETS, answer, run, settings

RPM = math.pi / 30.0
POWER, SPEED = 150e3, 6000.0  # [W], [rpm] of the reducer
TORQUE = POWER / (SPEED * RPM)  # [N m]
SPEEDS = "sweep={input.speed: [3000 rpm, 6000 rpm, 12000 rpm]}"
SAME = 1e-9  # the torque is written with 12 digits


def torque(factor=1.0):
    return f"input.torque={factor * TORQUE:.12g} N.m"


class Duty(unittest.TestCase):
    def assert_near(self, found, right):
        self.assertLess(abs(found / right - 1.0), SAME, (found, right))

    def refusal(self, *values):
        result = run("run", REDUCER, "--json", *settings(values))
        self.assertEqual(result.returncode, 2, result.stdout)
        return result.stderr

    def test_torque_times_speed_is_the_power(self):
        """A torque of --set replaces the power of the file."""
        by_power = answer("run", REDUCER)["points"][0]
        by_torque = answer("run", REDUCER, torque())["points"][0]
        for key in ("planet_load_N", "life_h", "L10h"):
            self.assert_near(by_torque[key], by_power[key])

    def test_sweep_of_a_torque_has_one_tooth_force(self):
        points = answer("sweep", REDUCER, torque(), SPEEDS, options=("--grid-only",))["points"]
        loads = [point["tangential_load_N"] for point in points]
        for load in loads:
            self.assert_near(load, loads[0])
        by_power = answer("sweep", REDUCER, SPEEDS, options=("--grid-only",))["points"]
        self.assert_near(by_power[0]["tangential_load_N"], 2.0 * by_power[1]["tangential_load_N"])

    def test_curve_is_linear_between_its_rows(self):
        curve = f"input.torque_curve=[{{speed: 2000 rpm, torque: {2 * TORQUE:.12g} N.m}}, {{speed: 10000 rpm, torque: 0 N.m}}]"
        points = answer("sweep", REDUCER, curve, "sweep={input.speed: [2000 rpm, 6000 rpm, 8000 rpm]}", options=("--grid-only",))["points"]
        for point, share in zip(points, (2.0, 1.0, 0.5)):
            self.assert_near(point["tangential_load_N"], share * points[1]["tangential_load_N"])
        said = self.refusal(curve, "input.speed=12000 rpm")
        self.assertIn("input.torque_curve: 2000 to 10000 rpm without 12000 rpm; rows on both sides of input.speed are required", said)
        said = self.refusal("input.torque_curve=[{speed: 7000 rpm, torque: 1 N.m}, {speed: 3000 rpm, torque: 2 N.m}]")
        self.assertIn("rows in ascending order of speed are required", said)

    def test_two_statements_of_one_duty_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "case.yaml"
            case.write_text(REDUCER.read_text(encoding="utf-8").replace("  power: 150 kW\n", "  power: 150 kW\n  torque: 100 N.m\n"), encoding="utf-8")
            result = run("run", case, "--json")
        self.assertEqual(result.returncode, 2)
        self.assertIn("a duty stated by input.power and input.torque; one of them is required", result.stderr)
        self.assertIn("a duty stated by", self.refusal("input.power=1 kW", "input.torque=1 N.m"))
        self.assertIn("one of both is required", self.refusal_of_sweep("input.torque=100 N.m", "sweep={input.power: [1 kW, 2 kW]}"))

    def refusal_of_sweep(self, *values):
        result = run("sweep", REDUCER, "--json", *settings(values))
        self.assertEqual(result.returncode, 2, result.stdout)
        return result.stderr

    def test_missing_power_may_be_a_torque(self):
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "case.yaml"
            case.write_text(REDUCER.read_text(encoding="utf-8").replace("  power: 150 kW\n", ""), encoding="utf-8")
            result = run("run", case, "--json")
            self.assertIn("or input.torque or input.torque_curve instead", result.stderr)
            self.assert_near(answer("run", case, torque())["points"][0]["life_h"], answer("run", REDUCER)["points"][0]["life_h"])

    def test_resolved_case_gives_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            first = answer("sweep", REDUCER, torque(), SPEEDS, options=("--grid-only", "-o", str(out)))
            again = answer("sweep", out / "case.resolved.yaml", options=("--grid-only",))
        self.assertEqual([point["life_h"] for point in first["points"]], [point["life_h"] for point in again["points"]])

    def test_application_factor_multiplies_the_loads(self):
        """K_A of ISO 6336-1; with a spectrum it is 1."""
        once, more = (answer("run", REDUCER, f"input.application_factor={factor}")["points"][0] for factor in (1, 1.25))
        self.assert_near(more["tangential_load_N"], 1.25 * once["tangential_load_N"])
        said = self.refusal("input.application_factor=1.25", "spectrum=[{power: 150 kW, speed: 6000 rpm, share: 1}]")
        self.assertIn("1.25 together with a spectrum; 1 is required", said)

    def test_spectrum_by_torque_beside_a_torque(self):
        """Bins of a spectrum state their own power; the headline is the torque's."""
        bins = f"spectrum=[{{torque: {TORQUE:.12g} N.m, speed: 6000 rpm, share: 1}}]"
        found = answer("run", REDUCER, torque(), bins)
        self.assert_near(found["spectrum"]["life_h"], found["points"][0]["life_h"])


class SpeedOfAnyMember(unittest.TestCase):
    """`input.speed_of`."""

    assert_near = Duty.assert_near

    Z = {"sun": 37, "planet": 22, "ring": 79}  # of the reducer: the ring is held, the sun driven
    SUN = SPEED * RPM  # [rad/s]
    CARRIER = SUN * Z["sun"] / (Z["sun"] + Z["ring"])
    PLANET = (SUN - CARRIER) * Z["sun"] / Z["planet"]  # relative to its pin
    ROUND_OFF = 1e-12

    def stated(self, member, speed):
        return f"input.speed_of={member}", f"input.speed={speed!r} rad/s"

    def assert_same(self, found, right):
        """All numbers but the stated speed itself."""
        self.assertEqual(found.keys(), right.keys())
        for key, value in right.items():
            if isinstance(value, float) and key != "input_speed_rpm":
                self.assertLessEqual(abs(found[key] - value), self.ROUND_OFF * abs(value) * 100, key)

    def refusal(self, *values, case=REDUCER):
        result = run("check", case, *settings(values))
        self.assertEqual(result.returncode, 2, result.stdout)
        return result.stderr

    def test_each_member_gives_the_result_of_the_converted_speed(self):
        right = answer("run", REDUCER)["points"][0]
        for member, speed in (("motor", self.SUN), ("load", self.CARRIER), ("carrier", self.CARRIER), ("sun", self.SUN), ("planet", self.PLANET)):
            with self.subTest(member):
                found = answer("run", REDUCER, *self.stated(member, speed))["points"][0]
                self.assertAlmostEqual(found["input_speed_rpm"] * RPM / speed, 1.0, 12)
                self.assert_same(found, right)

    def test_sweep_torque_and_spectrum_are_those_of_the_member(self):
        """The carrier's torque at half the speed: half the power."""
        grid = ("--grid-only",)
        sweep = "sweep={input.speed: [%r rad/s, %r rad/s]}"
        torque = f"input.torque={POWER / self.CARRIER!r} N.m"
        bins = "spectrum=[{torque: %r N.m, speed: %r rad/s, share: 0.5}, {power: 75 kW, speed: %r rad/s, share: 0.5}]"
        right = answer("sweep", REDUCER, sweep % (0.5 * self.SUN, self.SUN), f"input.torque={POWER / self.SUN!r} N.m",
                       bins % (POWER / self.SUN, self.SUN, 0.5 * self.SUN), options=grid)
        found = answer("sweep", REDUCER, *self.stated("carrier", self.CARRIER), sweep % (0.5 * self.CARRIER, self.CARRIER), torque,
                       bins % (POWER / self.CARRIER, self.CARRIER, 0.5 * self.CARRIER), options=grid)
        for one, other in zip(found["points"], right["points"], strict=True):
            self.assert_same(one, other)
        self.assertAlmostEqual(found["peak"]["speed_rpm"] * self.SUN / self.CARRIER / right["peak"]["speed_rpm"], 1.0, 12)
        self.assert_near(found["spectrum"]["life_h"], right["spectrum"]["life_h"])

    def test_conversion_follows_teeth_and_parallel_stages(self):
        """Teeth that another value changes, and stages before and behind: the load's speed is that of the last shaft."""
        stages = ("parallel_stage.front=[20, 63]", "parallel_stage.behind=[70, 25]", "gearset.planets=2", "gearset.teeth.sun=39", "gearset.teeth.ring=81")
        carrier = self.SUN * 20 / 63 * 39 / (39 + 81)
        right = answer("run", REDUCER, *stages)["points"][0]
        self.assert_same(answer("run", REDUCER, *stages, *self.stated("load", carrier * 70 / 25))["points"][0], right)
        self.assert_same(answer("run", REDUCER, *stages, *self.stated("carrier", carrier))["points"][0], right)
        checked = answer("check", REDUCER, *stages, *self.stated("carrier", carrier))
        rows = {row["path"]: row["value"] for row in checked["derived"]}
        self.assertAlmostEqual(rows["operation.motor_speed"] / SPEED, 1.0, 12)
        flow = next(row["speed_rpm"] for row in checked["power_flow"] if row["set"] == "gearset" and row["member"] == "carrier")
        self.assertAlmostEqual(abs(flow) * RPM / carrier, 1.0, 12)

    def test_load_of_several_sets(self):
        out = next(row["speed_rpm"] for row in answer("check", SETS)["power_flow"] if row["shaft"] == "output")
        right = answer("run", SETS)["points"][0]
        found = answer("run", SETS, "input.speed_of=load", f"input.speed={abs(out)!r} rpm")["points"][0]
        self.assertAlmostEqual(found["life_h"] / right["life_h"], 1.0, 9)

    def test_what_cannot_be_is_refused(self):
        self.assertIn("input.speed_of: ring, which is stationary; a member that rotates is required", self.refusal("input.speed_of=ring"))
        self.assertIn("input.speed_of: planet together with input.torque; the speed of a shaft", self.refusal("input.speed_of=planet", "input.torque=1 N.m"))
        self.assertIn("planet together with spectrum", self.refusal("input.speed_of=planet", "spectrum=[{torque: 1 N.m, speed: 60 rpm, share: 1}]"))
        self.assertIn("input.speed_of: carrier of several sets; motor or load is required", self.refusal("input.speed_of=carrier", case=SETS))
        self.assertIn("one of motor, load, sun, ring, carrier, planet is required", self.refusal("input.speed_of=pin"))


class SingleRuns(unittest.TestCase):
    def test_run_without_a_folder_prints_and_keeps_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            before = os.getcwd()
            os.chdir(folder)
            try:
                for case in ("reducer_150kW", "harris_209", "duplex_7020"):
                    result = run("run", (Path(before) / CASES / case / "case.yaml").resolve())
                    self.assertEqual(result.returncode, 0, result.stderr)
                    self.assertTrue(result.stdout)
                self.assertEqual(list(Path(folder).iterdir()), [])
            finally:
                os.chdir(before)

    def test_folder_with_a_case_is_a_case(self):
        self.assertEqual(answer("run", CASES / "harris_209"), answer("run", CASES / "harris_209" / "case.yaml"))
        said = run("run", CASES / "validation").stderr
        self.assertIn("a folder without a file case.yaml", said)

    def test_single_bearing_prints_hours_kappa_and_load_ratio(self):
        values = ("operation.shaft_speed=1500 rpm", "lubricant.grade=ISO VG 100", "life.cleanliness=high", "lubricant.temperature=70 degC")
        text = run("run", CASES / "harris_209", *settings(values)).stdout
        found = answer("run", CASES / "harris_209", *values)
        self.assertIn(f"C/P {found['C_over_P']:.5g}", text)
        self.assertIn(f"kappa {found['kappa']:.5g}", text)
        self.assertIn(f"{found['L10h']:.6g}", text)

    def test_stiffness_of_a_pair(self):
        """That of `run`, with tilts as rotations about x and y."""
        case = CASES / "duplex_7020"
        by_run = answer("run", case)["stiffness_matrix"]
        point = answer("stiffness", case)["points"][0]
        found, signs, order = point["stiffness"], (1, 1, 1, 1, -1), (0, 1, 2, 4, 3)
        largest = max(abs(value) for row in by_run for value in row)
        for i in range(5):
            for k in range(5):
                right = signs[i] * signs[k] * by_run[order[i]][order[k]]
                self.assertLess(abs(found[i][k] - right), 1e-12 * largest)
        self.assertEqual(point["load"]["preload_N"], 540.0)

    def test_defect_lines_by_name(self):
        """FTF, BPFO, BPFI and BSF need dimensions and a speed, no masses."""
        found = answer("run", CASES / "harris_209", "operation.shaft_speed=1500 rpm")["defect_frequencies"]
        shaft, rollers, ratio = 25.0, 14, 10.0 / 65.0  # [Hz], D_r/d_m
        right = {
            "shaft_Hz": shaft,
            "FTF_Hz": 0.5 * shaft * (1 - ratio),
            "BPFO_Hz": 0.5 * rollers * shaft * (1 - ratio),
            "BPFI_Hz": 0.5 * rollers * shaft * (1 + ratio),
            "BSF_Hz": 0.5 * shaft / ratio * (1 - ratio**2),
        }
        self.assertEqual(set(found), set(right))
        for name, value in right.items():
            self.assertAlmostEqual(found[name] / value, 1.0, 12)
        self.assertNotIn("defect_frequencies", answer("run", CASES / "harris_209"))


if __name__ == "__main__":
    unittest.main()
