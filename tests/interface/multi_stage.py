#!/usr/bin/env python3
"""A drivetrain of several sets through the program: power flow, rows of each set, shards, resume, resolved case."""

import csv
import json
import re
import tempfile
import unittest
from pathlib import Path

from sweep_runs import PROGRAM, ROOT, point_files, run, table

THREE = ROOT / "cases" / "three_sets_150kW" / "case.yaml"
REDUCER = ROOT / "cases" / "reducer_150kW" / "case.yaml"
COUPLING = ROOT / "cases" / "coupling_set_150kW" / "case.yaml"
# Ratios of members from a linear solver, lives with their fourth power.
SAME = 1e-9

# A second set drives the ring of the first backwards: power goes round between them.
CIRCULATING = """name: circulating
source: made up
model: planetary-drivetrain
input: {power: 8 kW, speed: 800 rpm}
shafts:
  input: [motor, main.sun, control.sun]
  rings: [main.ring, control.ring]
  output: [main.carrier, load]
  housing: [ground, control.carrier]
sets:
  main: {gearset: {planets: 4, teeth: {sun: 30, planet: 30, ring: 90}, module: 2 mm,
                   profile_shift: {sun: 0, ring: 0}, face_width: 20 mm}}
  control: {gearset: {planets: 3, teeth: {sun: 30, planet: 15, ring: 60}, module: 2 mm,
                      profile_shift: {sun: 0, ring: 0}, face_width: 20 mm}}
"""


def example_of_the_document():
    text = (ROOT / "docs" / "gear_sets.md").read_text(encoding="utf-8")
    return re.search(r"^## Several sets on common shafts$.*?^```yaml\n(.*?)^```$", text, re.M | re.S)[1]


def rows(folder):
    return list(csv.DictReader(table(folder).decode().splitlines()))


class SeveralSets(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def done(self, *arguments):
        result = run([PROGRAM, *map(str, arguments)])
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def sweep(self, case, name, *options):
        self.done("sweep", case, "-o", self.place / name, "--quiet", *options)
        return self.place / name

    def test_the_example_of_the_document_is_a_whole_case(self):
        """docs/gear_sets.md: speeds by Willis' equation, what is refused beside shafts, a parallel stage behind the load's shaft."""
        with tempfile.TemporaryDirectory() as place:
            case = Path(place) / "two.yaml"
            case.write_text(example_of_the_document(), encoding="utf-8")

            def check(setting, *options):
                return run([PROGRAM, "check", str(case), "--set", setting, *options])

            result = json.loads(check("parallel_stage.behind=[25, 50]", "--json").stdout)
            speeds = {(row["set"], row["member"]): row["speed_rpm"] for row in result["power_flow"]}
            self.assertAlmostEqual(speeds["second", "carrier"], 1500 / ((1 + 90 / 24) * (1 + 84 / 28)), delta=1e-4)
            load = next(row["value"] for row in result["derived"] if row["path"] == "operation.load_speed")
            self.assertAlmostEqual(load, -25 / 50 * speeds["second", "carrier"], delta=1e-4)
            self.assertIn("the shafts, which say where motor and ground are", check("input.member=carrier").stderr)
            self.assertEqual(check("sets.first.bearing.radial_clearance=30 um").returncode, 0)

    def test_power_flow_balances_in_every_set_and_shaft(self):
        checked = json.loads(self.done("check", THREE, "--json"))
        flow = checked["power_flow"]
        self.assertEqual(len(flow), 9)
        for name in ("reduction", "coupling", "transmission"):
            of_set = [row for row in flow if row["set"] == name]
            self.assertAlmostEqual(sum(row["power_W"] for row in of_set), 0.0, delta=1e-6)
            self.assertAlmostEqual(sum(row["torque_N_m"] for row in of_set), 0.0, delta=1e-8)
        for shaft in ("first", "second"):
            self.assertAlmostEqual(sum(row["power_W"] for row in flow if row["shaft"] == shaft), 0.0, delta=1e-6)
        output = flow[-1]
        self.assertEqual((output["set"], output["member"], output["shaft"]), ("transmission", "carrier", "output"))
        ratio = (1 + 79 / 37) * (1 + 66 / 30) * (1 + 57 / 23)
        self.assertAlmostEqual(output["speed_rpm"], 6000 / ratio, delta=1e-9)
        self.assertFalse(checked["power_circulation"]["present"])

    def test_circulating_power_is_shown_and_needs_a_bearing_to_sweep(self):
        case = self.place / "circulating.yaml"
        case.write_text(CIRCULATING, encoding="utf-8")
        circulation = json.loads(self.done("check", case, "--json"))["power_circulation"]
        self.assertTrue(circulation["present"])
        self.assertAlmostEqual(circulation["largest_share"], 3.0, delta=1e-9)
        self.assertEqual(circulation["members"], ["main.sun", "main.ring", "control.sun", "control.ring"])
        self.assertRegex(self.done("check", case), r"power_circulation.members +main.sun, main.ring")
        result = run([PROGRAM, "sweep", str(case), "-o", str(self.place / "none")])
        self.assertEqual(result.returncode, 2)
        self.assertIn("no set with a bearing", result.stderr)

    def test_row_is_that_of_the_shortest_life_and_each_set_follows(self):
        three = rows(self.sweep(THREE, "three", "--grid-only"))
        alone = rows(self.sweep(REDUCER, "alone", "--grid-only"))
        self.assertEqual(len(three), 12)
        for row, reducer in zip(three, alone):
            lives = {name: float(row[f"sets.{name}.life_h"]) for name in ("reduction", "coupling")}
            self.assertEqual(row["limiting_set"], min(lives, key=lives.get))
            self.assertEqual(float(row["life_h"]), min(lives.values()))
            together = sum((life * 8 ** (-8 / 9)) ** (-9 / 8) for life in lives.values()) ** (-8 / 9)
            self.assertAlmostEqual(float(row["system_life_h"]) / together, 1.0, delta=SAME)
            self.assertAlmostEqual(lives["reduction"] / float(reducer["life_h"]), 1.0, delta=SAME)
        self.assertEqual({row["limiting_set"] for row in three}, {"reduction", "coupling"})

    def test_a_set_of_the_drive_is_as_it_is_alone_at_its_speed(self):
        three = json.loads(self.done("run", THREE, "-o", self.place / "three", "--json"))
        speed = next(row for row in three["power_flow"] if (row["set"], row["member"]) == ("coupling", "sun"))
        alone = json.loads(self.done("run", COUPLING, "-o", self.place / "alone", "--json", "--set",
                                     f"input.speed={speed['speed_rpm']} rpm"))
        for key in ("life_h", "planet_load_N", "inner_load_max_N"):
            ratio = three["points"][0]["sets.coupling." + key] / alone["points"][0][key]
            self.assertAlmostEqual(ratio, 1.0, delta=SAME)
        self.assertNotIn("limiting_set", alone["points"][0])
        self.assertEqual(len(alone["power_flow"]), 3)

    def test_resolved_case_gives_the_same_numbers(self):
        first = self.sweep(THREE, "first", "--set", "sets.coupling.gearset.planets=3", "--set",
                           "sweep.sets.coupling.bearing.rollers=[11, 12]", "--grid-only")
        again = self.sweep(first / "case.resolved.yaml", "again", "--grid-only")
        self.assertEqual(table(again), table(first))
        self.assertEqual((again / "case.resolved.yaml").read_bytes(), (first / "case.resolved.yaml").read_bytes())
        self.assertIn("sets.coupling.bearing.rollers", rows(first)[0])
        self.assertEqual(len(rows(first)), 24)

    def test_shards_merge_and_finished_points_are_kept(self):
        whole = self.sweep(THREE, "whole")
        shards = [self.sweep(THREE, f"shard{i}", "--shard", f"{i}/2", "--jobs", "1") for i in (1, 2)]
        self.done("merge", *shards, "-o", self.place / "merged", "--quiet")
        self.assertEqual(table(self.place / "merged"), table(whole))
        before = point_files(whole)
        self.sweep(THREE, "whole", "--resume")
        self.assertEqual(point_files(whole), before)


if __name__ == "__main__":
    unittest.main()
