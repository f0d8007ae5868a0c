#!/usr/bin/env python3
"""Friction of single bearings, by formulas of others, and at thermal reference speeds."""

import importlib.machinery
import importlib.util
import math
import os
import pathlib
import sys
import unittest

from program import CASES, answer

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
ROLLERS, BALLS = (CASES / "validation" / name for name in ("thermal_reference_rollers", "thermal_reference_balls"))


def run_json(case, *values):
    return answer("run", case, *values)


def script(*path):
    """A script of the project as a module."""
    sys.dont_write_bytecode = True
    name = pathlib.Path(path[-1]).stem
    loader = importlib.machinery.SourceFileLoader(name, str(SOURCE.joinpath(*path)))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


class Friction(unittest.TestCase):
    def test_parts_add_up_and_torque_is_power_over_speed(self):
        for case, rpm in ((ROLLERS, 17000), (BALLS, 28000)):
            found = run_json(case)["friction"]
            parts = [found[name] for name in ("rolling_W", "differential_slip_W", "spin_W", "drag_W")]
            self.assertAlmostEqual(found["power_W"], sum(parts), delta=1e-9 * found["power_W"])
            self.assertAlmostEqual(found["torque_N_mm"], 1e3 * found["power_W"] / (rpm * math.pi / 30), delta=1e-9 * found["torque_N_mm"])
            self.assertTrue(all(part >= 0.0 for part in parts))

    def test_formulas_of_others_by_hand(self):
        """NU 204, d 20, D 47, B 14 mm, 1100 N, 17000 rpm, 12 mm2/s: tests/unit/friction has the sums."""
        found = run_json(ROLLERS)["friction_by_standards"]
        self.assertAlmostEqual(found["palmgren"]["load_free_N_mm"], 26.057, delta=0.005)
        self.assertAlmostEqual(found["palmgren"]["load_dependent_N_mm"], 11.055, delta=1e-9)
        self.assertAlmostEqual(found["skf"]["sliding_N_mm"], 1.1055, delta=1e-9)
        self.assertAlmostEqual(found["iso_tr_14179_2"]["load_free_N_mm"], 1.5 * 26.057, delta=0.01)
        self.assertAlmostEqual(found["reference_heat_W"], 47.149, delta=0.001)

    def test_factors_of_others_act_on_the_rolling_part_alone(self):
        for case in (ROLLERS, BALLS):
            found = run_json(case)
            ours, others = found["friction"], found["friction_by_standards"]
            self.assertLessEqual(ours["idle_W"], ours["rolling_W"])
            self.assertLessEqual(ours["rolling_W"], ours["flooded_rolling_W"])
            self.assertLess(ours["flooded_rolling_W"], ours["isothermal_rolling_W"])
            rest = ours["power_W"] - ours["rolling_W"]
            for key, factor in (("ours_with_inlet_heating_W", others["skf"]["inlet_heating"]),
                                ("ours_with_starvation_W", others["skf"]["inlet_heating"] * others["skf"]["starvation"])):
                self.assertAlmostEqual(others[key], rest + factor * ours["isothermal_rolling_W"], delta=1e-9 * ours["power_W"])

    def test_starvation_acts_on_the_rolling_part_of_rollers(self):
        flooded, skf, returned = (run_json(ROLLERS, f"traction.starvation={name}") for name in ("none", "skf", "replenished"))
        factor = flooded["friction_by_standards"]["skf"]["starvation"]
        self.assertAlmostEqual(skf["friction"]["rolling_W"], factor * flooded["friction"]["rolling_W"], delta=1e-9 * flooded["friction"]["rolling_W"])
        less = run_json(ROLLERS, "traction.starvation=replenished", "lubricant.share=0.01")["friction"]
        self.assertLess(less["rolling_W"], returned["friction"]["rolling_W"])
        for one in (skf["friction"], returned["friction"]):
            self.assertEqual(one["flooded_rolling_W"], flooded["friction"]["flooded_rolling_W"])
            self.assertEqual(one["drag_W"], flooded["friction"]["drag_W"])

    def test_oil_takes_the_heat_of_rollers_along(self):
        """1.7 MJ/(m3 K) times the flow times the rise is the friction; at the stated 70 degC it is that without heat, but for the flow."""
        oil = ["heat.enabled=true", "heat.model=oil", "lubricant.flow=0.3 L/min"]
        for inlet in (30, 50):
            found = run_json(ROLLERS, *oil, f"heat.inlet={inlet} degC")["friction"]
            self.assertAlmostEqual(1.7e6 * 0.3e-3 / 60 * (found["oil_temperature_degC"] - inlet), found["power_W"], delta=1e-6 * found["power_W"])
        cold, warm = (run_json(ROLLERS, *oil, f"heat.inlet={inlet} degC")["friction"] for inlet in (30, 50))
        self.assertLess(warm["power_W"], cold["power_W"])
        stated = run_json(ROLLERS, "lubricant.flow=0.3 L/min")["friction"]
        self.assertNotIn("oil_temperature_degC", stated)
        inlet = 70.0 - stated["power_W"] / (1.7e6 * 0.3e-3 / 60)
        at_70 = run_json(ROLLERS, *oil, f"heat.inlet={inlet} degC")["friction"]
        self.assertAlmostEqual(at_70["oil_temperature_degC"], 70.0, delta=0.01)
        self.assertAlmostEqual(at_70["power_W"], stated["power_W"], delta=1e-3 * stated["power_W"])

    def test_heated_oil_starves_by_its_own_viscosity(self):
        """By the factor of SKF, which the formula beside it states, against flooded contacts at the same temperature: between those of two inlets."""
        heated = ["heat.enabled=true", "heat.model=oil", "lubricant.flow=0.3 L/min"]
        starved = run_json(ROLLERS, *heated, "heat.inlet=30 degC", "traction.starvation=skf")
        factor, at = starved["friction_by_standards"]["skf"]["starvation"], starved["friction"]["oil_temperature_degC"]
        self.assertLess(factor, 0.8)  # 0.88 in the oil as stated, at 70 degC
        below, above = (run_json(ROLLERS, *heated, f"heat.inlet={inlet} degC")["friction"] for inlet in (22, 25))
        share = (at - below["oil_temperature_degC"]) / (above["oil_temperature_degC"] - below["oil_temperature_degC"])
        self.assertTrue(0.0 < share < 1.0, share)
        flooded = below["rolling_W"] + share * (above["rolling_W"] - below["rolling_W"])
        self.assertAlmostEqual(starved["friction"]["rolling_W"] / flooded, factor, delta=1e-3)

    def test_a_ball_bearing_in_time_has_them_too(self):
        found = run_json(CASES / "deep_groove_motor", "bearing.outside_diameter=52 mm", "simulation.duration=20 ms")
        others = found["friction_by_standards"]
        torque = others["palmgren"]["ours_over_it"] * others["palmgren"]["torque_N_mm"]
        self.assertAlmostEqual(torque, abs(found["friction_torque_N_mm"]), delta=1e-9 * torque)

    def test_series_are_those_of_the_designation(self):
        """R_1 of 22 over that of 2: 1.40/1.09; both have one d_m."""
        narrow, wide = (run_json(ROLLERS, f"bearing.designation={name}")["friction_by_standards"] for name in ("NU 205", "NU 2205"))
        self.assertAlmostEqual(wide["skf"]["rolling_N_mm"] / narrow["skf"]["rolling_N_mm"], 1.40 / 1.09, delta=1e-9)
        self.assertAlmostEqual(wide["palmgren"]["load_free_N_mm"] / narrow["palmgren"]["load_free_N_mm"], 1.5, delta=1e-9)

    def test_none_without_oil_or_speed(self):
        found = run_json(CASES / "harris_209")
        self.assertNotIn("friction", found)

    def test_stated_sizes_serve_in_place_of_a_designation(self):
        sizes = [f"bearing.{name}={value} mm" for name, value in (("bore", 45), ("outside_diameter", 85), ("width", 19))]
        oil = ["lubricant.grade=ISO VG 32", "operation.shaft_speed=3000 rpm"]
        self.assertNotIn("friction_by_standards", run_json(CASES / "harris_209", *oil))
        found = run_json(CASES / "harris_209", *oil, *sizes)
        self.assertAlmostEqual(found["friction_by_standards"]["reference_heat_W"], 0.016 * math.pi * 19 * 130, delta=1e-6)

    def test_balls_have_friction_by_stated_sizes_too(self):
        case, sizes = CASES / "ball_6305_iso16281", [f"bearing.{name}={value} mm" for name, value in (("bore", 25), ("outside_diameter", 62), ("width", 17))]
        oil = ["lubricant.kinematic_viscosity=20 mm2/s", "operation.shaft_speed=3000 rpm", "life.cleanliness=high"]
        self.assertNotIn("friction", run_json(case, *oil))
        two = run_json(case, *oil, *sizes[:2])
        self.assertNotIn("friction", two)
        self.assertTrue(any(text.startswith("bearing.bore:") and "counts only where" in text and "bearing.width are given" in text for text in two["warnings"]), two["warnings"])
        found = run_json(case, *oil, *sizes)
        self.assertAlmostEqual(found["friction_by_standards"]["reference_heat_W"], 0.016 * math.pi * 17 * 87, delta=1e-6)
        self.assertGreater(found["friction"]["rolling_W"], 0.0)
        wider = run_json(case, *oil, *sizes[:2], "bearing.width=19 mm")["friction"]
        self.assertEqual(wider["rolling_W"], found["friction"]["rolling_W"])
        self.assertNotEqual(wider["drag_W"], found["friction"]["drag_W"])


class ReferenceSpeeds(unittest.TestCase):
    def test_expected_values_are_those_of_the_catalogue(self):
        module = script("tools", "thermal_reference")
        for family, name in module.CASES.items():
            text = (CASES / "validation" / name / "expected.yaml").read_text(encoding="utf-8")
            self.assertEqual(text, module.expected(family, module.WHY[family]), "tools/thermal_reference --write")
            self.assertGreaterEqual(sum(1 for _ in module.rows(family)), 40)


class Laws(unittest.TestCase):
    """docs/friction/laws.py and docs/friction/ablation.py."""

    LAWS = script("docs", "friction", "laws.py")

    def test_rigid_cylinders_and_published_laws_by_hand(self):
        """U = 1e-11, W = 1e-4, G = 4000: the ratios to 1.47 (2U)^0.75 are those of [BibouletHoupert2010], 0.939 and 1.00 at 2U = 1e-11."""
        laws, U, W, G = self.LAWS, 0.5e-11, 1e-4, 4000.0
        unit = 1.47 * (2 * U) ** 0.75
        self.assertAlmostEqual(laws.zhou_hoeprich(U, W, G) / unit, 0.939, delta=0.005)
        self.assertAlmostEqual(laws.goksem_hargreaves(U, W, G) / unit, 1.00, delta=0.01)
        self.assertAlmostEqual(laws.hamrock(U, W, G) / unit, 1.71, delta=0.01)
        self.assertAlmostEqual(laws.biboulet_houpert(U, W, G) / unit, 1.0, delta=1e-3)
        self.assertAlmostEqual(laws.rigid(U, W, G), 1.4705 * (2 * U * W) ** 0.5, delta=1e-20)

    def test_the_default_is_the_law_of_the_program(self):
        """Power of all contacts within the spread over positions of the cage; the resistance of one line contact within the fit's 4.1 %."""
        for name in self.LAWS.TAPERED:
            bearing = self.LAWS.Bearing(os.environ["ORBEARING"], name)
            self.assertAlmostEqual(bearing.isothermal(self.LAWS.DEFAULT) / bearing.friction["isothermal_rolling_W"], 1.0, delta=0.01)
            self.assertAlmostEqual(bearing.torque(self.LAWS.DEFAULT) / bearing.friction["torque_N_mm"], 1.0, delta=1e-6)
            regression = self.LAWS.LAWS["Goksem and Hargreaves, 1978"]
            self.assertAlmostEqual(bearing.power(regression) / (bearing.friction["regression_rolling_W"] + bearing.friction["drag_W"]), 1.0, delta=0.05)
        U, W = 1e-11, 3e-5
        found = run_json(CASES / "reynolds_line")["film"][0]["rolling_resistance_N"]
        self.assertAlmostEqual(self.LAWS.DEFAULT(U, W, 4560.0) * 228e9 * 0.01 * 0.01 / found, 1.0, delta=0.041)

    def test_a_cylindrical_bearing_has_the_loads_of_a_tapered_one(self):
        """Sums of loads and of their parts along the radial load, and the settings of the cases."""
        radial, clearance = self.LAWS.stand_in(6500.0, 15000.0, 15.64, 16, 22.7)
        tilt = math.radians(15.64)
        loads = run_json(CASES / "validation" / "wingertszahn_32216", f"load.radial={radial:.6g} N", f"bearing.radial_clearance={clearance:.5f} um")["contact_loads_N"]
        self.assertAlmostEqual(sum(loads) * math.sin(tilt), 6500.0, delta=5.0)
        across = sum(load * math.cos(2 * math.pi * j / 16) for j, load in enumerate(loads))
        self.assertAlmostEqual(across * math.cos(tilt), 15000.0, delta=5.0)
        text = (CASES / "validation" / "wingertszahn_32216" / "expected.yaml").read_text(encoding="utf-8")
        self.assertIn(f"load.radial={radial:.5g} N", text)
        self.assertIn(f"bearing.radial_clearance={clearance:.4f} um", text)

    def test_tables_of_the_page_are_those_of_the_script(self):
        """docs/friction/laws.py PROGRAM --write."""
        page = (SOURCE / "docs" / "friction.md").read_text(encoding="utf-8")
        measured = self.LAWS.measured(os.environ["ORBEARING"])
        for table in (self.LAWS.exponents_table(), self.LAWS.moments_table(), self.LAWS.measured_table(measured, self.at_speeds(page))):
            self.assertTrue(table in page, table)

    def at_speeds(self, page):
        """The last column, which takes half a minute, as the page has it."""
        rows = [line.strip("| ").split(" | ") for line in page.split(self.LAWS.BEGIN)[1].split(self.LAWS.END)[0].splitlines()]
        return {row[0]: float(row[-1]) for row in rows if row[0] in self.LAWS.LAWS and len(row) == 10}

    def test_tables_of_parts_are_those_of_the_script(self):
        """Each group of the page on ablation has its rows once in its case and each variant once in its table; quick ones are computed again."""
        ablation = script("docs", "friction", "ablation.py")
        page = (SOURCE / "docs" / "ablation.md").read_text(encoding="utf-8")
        for group in ablation.GROUPS:
            title, case, parts, variants = group
            for part, _ in parts:
                ablation.row_of(case, part)  # there is one
            self.assertIn(f"| {title} |", page)
            table = page[page.index(f"| {title} |"):].split("\n\n")[0].splitlines()
            self.assertEqual([line.split(" | ")[0] for line in table[2:]], [f"| {name}" for name, _ in variants], title)
            self.assertEqual([line.count("|") for line in table], [len(parts) + 2] * len(table), title)
            if case in ("validation/zhou_hoeprich_lm12700", "validation/cruz_hm801349"):
                self.assertEqual("\n".join(table), ablation.group_table(os.environ["ORBEARING"], group))


if __name__ == "__main__":
    unittest.main()
