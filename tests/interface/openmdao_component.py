#!/usr/bin/env python3
"""A run as a component of OpenMDAO, its values and derivatives; the component itself where that package can be had (PyPI)."""

import json
import os
import pathlib
import subprocess
import sys
import unittest
from unittest import mock

from program import CASES, LEFT_TO_FULL, REDUCER, answer, package
from virtual_environment import build_folder, environment

orbearing = package()
from orbearing import openmdao  # noqa: E402

HARRIS = CASES / "harris_209"
INPUTS = ["load.radial", "bearing.radial_clearance"]
OUTPUTS = ["L10r_Mrev", "displacement/radial_um"]
PACKAGES = ("openmdao==3.45.1",)
MODEL = """
import json, sys
import openmdao.api as om
import orbearing
from orbearing.openmdao import component
case = orbearing.load(sys.argv[1])
problem = om.Problem(reports=False)
problem.model.add_subsystem("run", component(case, ["load.radial", "bearing.radial_clearance"], ["L10r_Mrev", "displacement/radial_um"]))
problem.setup()
problem.set_val("run.load:radial", 4.0, units="kN")
problem.set_val("run.bearing:radial_clearance", 20.0, units="um")
problem.run_model()
values = [float(problem.get_val("run.L10r_Mrev")[0]), float(problem.get_val("run.displacement:radial_um", units="m")[0])]
checked = problem.check_partials(out_stream=None, method="fd", form="central", step=1e-4, step_calc="rel")["run"]
print(json.dumps({"values": values, "partials": {f"{of} {by}": [float(row["J_fwd"][0][0]), float(row["J_fd"][0][0])] for (of, by), row in checked.items()}}))
"""


class Responses(unittest.TestCase):
    def test_values_are_those_of_the_run(self):
        responses = openmdao.Responses(orbearing.load(HARRIS), INPUTS, OUTPUTS)
        self.assertEqual(responses.input_units, {"load.radial": "N", "bearing.radial_clearance": "m"})
        self.assertEqual(responses.output_units["displacement/radial_um"], "um")
        found = responses.values({"load.radial": 4000.0, "bearing.radial_clearance": 20e-6})
        right = answer("run", HARRIS, "load.radial=4 kN", "bearing.radial_clearance=20 um")
        self.assertEqual(found, {"L10r_Mrev": right["L10r_Mrev"], "displacement/radial_um": right["displacement"]["radial_um"]})
        self.assertEqual(responses.values({}), responses.values(responses.start))

    def test_derivatives_of_both_kinds_agree(self):
        case = orbearing.load(HARRIS, {"load.radial": "4 kN"})
        at = {"bearing.radial_clearance": 20e-6}
        by_program = openmdao.Responses(case, INPUTS, OUTPUTS).slopes(at)
        by_steps = openmdao.Responses(case, INPUTS, OUTPUTS, steps={"load.radial": 1.0, "bearing.radial_clearance": 1e-8}).slopes(at)
        self.assertEqual(set(by_program), {(key, path) for key in OUTPUTS for path in INPUTS})
        for key, slope in by_program.items():
            self.assertLess(abs(by_steps[key] / slope - 1.0), 1e-4, key)
        self.assertAlmostEqual(by_program["displacement/radial_um", "bearing.radial_clearance"], 0.59e6, delta=0.005e6)  # um per m: more than half the clearance

    def test_a_drivetrain_gives_its_point(self):
        responses = openmdao.Responses(orbearing.load(REDUCER), ["bearing.roller_diameter", "lubricant.viscosity"], ["life_h"])
        self.assertEqual(responses.values({}), {"life_h": answer("run", REDUCER)["points"][0]["life_h"]})
        slopes = responses.slopes({})
        self.assertAlmostEqual(slopes["life_h", "bearing.roller_diameter"] * 0.00524 / responses.values({})["life_h"], 4.538, delta=0.01)
        self.assertEqual(slopes["life_h", "lubricant.viscosity"], 0.0)

    def test_an_input_whose_value_is_zero_has_a_slope_in_si(self):
        """The clearance of the case is 0 um: the table has the derivative by one micrometre, the component by one metre."""
        row = answer("sensitivities", REDUCER, options=["--by=bearing.radial_clearance"])["inputs"][0]
        self.assertEqual((row["value"], row["unit"]), (0.0, "um"))
        slopes = openmdao.Responses(orbearing.load(REDUCER), ["bearing.radial_clearance"], ["life_h"]).slopes({})
        self.assertAlmostEqual(slopes["life_h", "bearing.radial_clearance"] / row["derivative"], 1e6, delta=1e-3)

    def test_what_cannot_be_is_refused(self):
        case = orbearing.load(HARRIS)
        for inputs, outputs, more, text in (
                (["load.radia"], OUTPUTS, {}, "load.radia: no input of the case; required: a number of it, as load.radial"),
                (["bearing.rollers"], OUTPUTS, {}, "bearing.rollers: found the kind integer; required: a number that may change by small steps"),
                (["operation.turning_race"], OUTPUTS, {}, "found the kind choice"),
                (["load.tilt"], OUTPUTS, {}, "load.tilt: the case has no value"),
                ([], OUTPUTS, {}, "inputs: found none"),
                (INPUTS, [], {}, "outputs: found none"),
                (INPUTS, ["L10"], {}, "L10: the run has no number of this name; required: a key of `orbearing run --json`; nearest: "),
                (INPUTS, OUTPUTS, {"steps": {"load.radial": 1.0}}, "steps: found load.radial; required: a step above 0 for each of load.radial, ")):
            with self.subTest(text), self.assertRaises(orbearing.CaseError) as raised:
                openmdao.Responses(case, inputs, outputs, **more)
            self.assertIn(text, str(raised.exception))
        with self.assertRaisesRegex(orbearing.CaseError, "speed: no input of these responses"):
            openmdao.Responses(case, INPUTS, OUTPUTS).values({"speed": 1.0})

    def test_names_and_units_of_openmdao(self):
        self.assertEqual(openmdao.variable_name("bearing.radial_clearance"), "bearing:radial_clearance")
        for ours, theirs in (("kg/m3", "kg/m**3"), ("N.m", "N*m"), ("Pa-1", "Pa**-1"), ("mm2/s", "mm**2/s"), ("1", None), ("", None), ("h", "h"), ("N m", "N*m")):
            self.assertEqual(openmdao.openmdao_unit(ours), theirs)

    def test_without_the_package_it_says_so(self):
        with mock.patch.dict(sys.modules, {"openmdao": None, "openmdao.api": None}), self.assertRaisesRegex(ImportError, "pip install openmdao"):
            openmdao.component(orbearing.load(HARRIS), INPUTS, OUTPUTS)


class Component(unittest.TestCase):
    def test_in_openmdao(self):
        if LEFT_TO_FULL:
            self.skipTest("a package of others; tools/test --full runs it, or by hand")
        python, reason = environment(*PACKAGES)
        if reason:
            self.skipTest(reason)
        done = subprocess.run([python, "-c", MODEL, HARRIS], capture_output=True, text=True, check=False,
                              env={**os.environ, "PYTHONPATH": str(build_folder() / "python"), "OPENMDAO_REPORTS": "0"}, cwd=pathlib.Path(build_folder()))
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout.splitlines()[-1])
        right = answer("run", HARRIS, "load.radial=4 kN", "bearing.radial_clearance=20 um")
        self.assertAlmostEqual(found["values"][0] / right["L10r_Mrev"], 1.0, 12)
        self.assertAlmostEqual(found["values"][1] / (1e-6 * right["displacement"]["radial_um"]), 1.0, 12)
        self.assertEqual(len(found["partials"]), 4)
        for name, (ours, theirs) in found["partials"].items():
            self.assertLess(abs(ours / theirs - 1.0), 1e-3, name)


if __name__ == "__main__":
    unittest.main()
