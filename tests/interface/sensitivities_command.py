"""`orbearing sensitivities` from outside."""

import csv
import functools
import json
import pathlib
import sys
import tempfile
import unittest

from program import CASES, run as call, settings


def case(name):
    return CASES / name / "case.yaml"


def loaded(*arguments):
    result = call(*arguments, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


@functools.cache
def of_itself(name):
    """Of a case as it stands; callers leave it as it is."""
    return loaded("sensitivities", case(name))


class Text(unittest.TestCase):
    def test_it_is_as_its_page_shows(self):
        """Warnings, the result, the table; what has no effect is last, in lines of a screen."""
        lines = call("sensitivities", case("reducer_150kW")).stdout.splitlines()
        page = (CASES.parent / "docs" / "sensitivities.md").read_text(encoding="utf-8")
        shown = [line[4:] for line in page[page.index("    quantity  life_h"):].split("\n\n- ")[0].splitlines()]
        first = lines.index(shown[0])
        self.assertEqual(lines[first:first + len(shown)], shown)
        self.assertTrue(all(line.startswith("warning: ") or not line for line in lines[:first]), lines[:first])
        self.assertFalse(any(line.startswith("warning: ") for line in lines[first:]))
        place = lines.index("without_effect: inputs on which the result does not depend")
        self.assertGreater(len(lines) - place, 3)
        self.assertLessEqual(max(len(line) for line in lines[place:]), 160)
        named = " ".join(lines[place + 1:]).replace(",", " ").split()
        self.assertEqual(named, of_itself("reducer_150kW")["without_effect"])

    def test_by_an_input_without_effect_it_is_refused(self):
        refused = call("sensitivities", case("reducer_nu204"), "--by", "bearing.radial_clearance")
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertIn("bearing.radial_clearance: found a varied input that has no effect: it counts only where bearing.clearance_class is not given", refused.stderr)


class Contract(unittest.TestCase):
    def test_of_a_drivetrain(self):
        found = of_itself("reducer_150kW")
        point = loaded("run", case("reducer_150kW"))["points"][0]
        self.assertEqual(found["quantity"], "life_h")
        self.assertAlmostEqual(found["life_h"] / point["life_h"], 1, places=9)
        rows = {row["path"]: row for row in found["inputs"]}
        self.assertIsNone(rows["bearing.radial_clearance"]["elasticity"])  # its value is zero
        self.assertAlmostEqual(rows["life.reduction_factor"]["elasticity"], 4, places=8)
        # A percent of power by the run itself; what is of second order is left.
        more, less = (loaded("run", case("reducer_150kW"), "--set", f"input.power={p} kW")["points"][0]["life_h"] for p in (150.15, 149.85))
        self.assertAlmostEqual((more - less) / 0.3 / rows["input.power"]["derivative"], 1, places=4)
        named = {row["path"] for row in found["inputs"] + found["not_differentiable"]} | set(found["without_effect"])
        for row in loaded("check", case("reducer_150kW"))["inputs"]:
            if row["path"] not in ("name", "source", "model"):
                self.assertIn(row["path"], named)

    def test_of_a_single_bearing(self):
        found = of_itself("ball_6305_iso16281")
        self.assertEqual(found["quantity"], "L10r_Mrev")
        self.assertAlmostEqual(found["L10r_Mrev"], loaded("run", case("ball_6305_iso16281"))["L10r_Mrev"], places=6)

    def test_of_the_life_that_life_method_chooses(self):
        # By (C/P)^(10/3) the capacity has the elasticity 10/3.
        found = loaded("sensitivities", case("reducer_150kW"), "--set", "life.method=iso-281", "--set", "bearing.dynamic_capacity=17 kN")
        self.assertEqual(found["quantity"], "L10h")
        rows = {row["path"]: row["elasticity"] for row in found["inputs"]}
        self.assertAlmostEqual(rows["bearing.dynamic_capacity"], 10 / 3, places=8)
        self.assertIn("life.reduction_factor", found["without_effect"])
        # With it lives are those of the run, and the reliability factor has a part in them.
        oil = ["--set", "life.method=iso-16281", "--set", "life.viscosity_ratio=1.5", "--set", "life.contamination_factor=0.5"]
        modified = loaded("sensitivities", case("reducer_150kW"), *oil)
        self.assertEqual(modified["quantity"], "L10mrh")
        row = next(one for one in modified["inputs"] if one["path"] == "life.contamination_factor")
        more, less = (loaded("run", case("reducer_150kW"), *oil[:4], "--set", f"life.contamination_factor={e_c}")["points"][0]["L10mrh"]
                      for e_c in (0.501, 0.499))
        self.assertAlmostEqual((more - less) / 0.002 / row["derivative"], 1, places=4)

    def test_at_another_point(self):
        here = of_itself("reducer_150kW")
        there = loaded("sensitivities", case("reducer_150kW"), "--set", "input.speed=3000 rpm")
        self.assertNotEqual(here["inputs"][0]["derivative"], there["inputs"][0]["derivative"])

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            result = call("sensitivities", case("harris_209"), "-o", pathlib.Path(folder) / "s", "--quiet")
            self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
            written = json.loads((pathlib.Path(folder) / "s" / "sensitivities.json").read_text())
            with open(pathlib.Path(folder) / "s" / "sensitivities.csv", newline="") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(len(rows), sum(len(written[key]) for key in ("inputs", "not_differentiable", "without_effect")))
            for row, wanted in zip(rows, written["inputs"]):
                self.assertEqual(row["input"], wanted["path"])
                self.assertAlmostEqual(float(row["derivative_Mrev_per_unit"]) / wanted["derivative"], 1, places=10)
            again = call("sensitivities", case("harris_209"), "-o", pathlib.Path(folder) / "s")
            self.assertEqual(again.returncode, 2)
            self.assertEqual(call("sensitivities", case("harris_209"), "-o", pathlib.Path(folder) / "s", "--resume").returncode, 0)

    def test_text(self):
        text = call("sensitivities", case("reducer_150kW")).stdout
        self.assertIn("bearing.roller_diameter", text)
        self.assertIn("a whole number", text)
        self.assertEqual(call("sensitivities", case("reducer_150kW"), "--quiet").stdout, "")


class AnyResult(unittest.TestCase):
    def test_errors_are_stated(self):
        found = of_itself("harris_209")
        for row in found["inputs"]:
            self.assertLess(row["error"], 1e-3 * abs(row["derivative"]), row["path"])
            self.assertGreater(row["error"], 0.0, row["path"])

    def test_of_another_number_of_the_run(self):
        found = loaded("sensitivities", case("harris_209"), "--result", "displacement/radial_um", "--by", "load.radial")
        self.assertEqual((found["quantity"], [row["path"] for row in found["inputs"]]), ("displacement/radial_um", ["load.radial"]))
        load = found["inputs"][0]
        more, less = (loaded("run", case("harris_209"), "--set", f"load.radial={load['value'] + step} N")["displacement"]["radial_um"] for step in (1, -1))
        self.assertAlmostEqual((more - less) / 2 / load["derivative"], 1, places=5)

    def test_in_motion_by_inputs_that_are_named(self):
        # The reduction factor has no effect on the motion: its elasticity is that of the capacity.
        with tempfile.TemporaryDirectory() as folder:
            short = settings(("simulation.observed_revolutions=1", "simulation.most_revolutions=2", "simulation.length_error=2e-6 mm"))
            command = ["sensitivities", case("reducer_150kW"), *short, "--fidelity", "dynamic", "--by", "life.reduction_factor", "-o", pathlib.Path(folder) / "s"]
            found = loaded(*command)
            row, = found["inputs"]
            self.assertAlmostEqual(row["elasticity"], 4, places=8)
            self.assertGreater(row["error"] / found["life_h"] * row["value"], 0.01)  # what the scatter of a motion allows
            # For n inputs 2 n runs are kept besides that of the case; --resume uses them unchanged.
            kept = pathlib.Path(folder) / "s" / "runs.jsonl"
            runs = [json.loads(line) for line in kept.read_text().splitlines()]
            self.assertEqual(len(runs), 2)
            for run in runs:
                run["result"] *= 2 if "+1" in run["run"] else 1
            kept.write_text("".join(json.dumps(run) + "\n" for run in runs))
            manifest = pathlib.Path(folder) / "s" / "manifest.jsonl"
            manifest.write_text(manifest.read_text().splitlines(keepends=True)[0])
            resumed, = loaded(*command, "--resume")["inputs"]
            self.assertGreater(resumed["elasticity"], 6)
            other = call(*command[:-3], "input.power", "-o", pathlib.Path(folder) / "s", "--resume")
            self.assertEqual(other.returncode, 2)


class Refusals(unittest.TestCase):
    def test_cases_without_a_life_at_rest(self):
        for name in ("mesh_62_62", "lin_parker_1999", "deep_groove_motor", "scratch_defect", "planet_scratch"):
            result = call("sensitivities", case(name))
            self.assertEqual((result.returncode, result.stdout), (2, ""), name)
            self.assertIn("required", result.stderr)

    def test_nothing_to_resume(self):
        self.assertEqual(call("sensitivities", case("harris_209"), "--resume").returncode, 2)


class Validation(unittest.TestCase):
    def test_assumptions_by_each_unit(self):
        rows = loaded("validate", case("reducer_150kW"))["assumptions"]
        by_path = {row["assumption"]: row for row in rows}
        self.assertAlmostEqual(by_path["life.reduction_factor"]["elasticity"], 4, places=8)
        self.assertIsNone(by_path["film.enabled"]["derivative_h_per_unit"])
        found = of_itself("reducer_150kW")  # whose speed is that of the peak
        rows = {row["path"]: row for row in found["inputs"]}
        self.assertAlmostEqual(by_path["bearing.radial_clearance"]["derivative_h_per_unit"] / rows["bearing.radial_clearance"]["derivative"], 1, places=9)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
