#!/usr/bin/env python3
"""A study over an input without effect is refused before it computes: by study, table, sweep, sensitivities, uncertainty, signals, in Python and for
OpenMDAO. The message names the axis and the input that replaces it."""

import pathlib
import tempfile
import unittest

import program
from program import CASES, REDUCER, answer, run

orbearing = program.package()
from orbearing.openmdao import Responses  # noqa: E402  of the package that program.package() found
from orbearing.studies.__main__ import main as study_main  # noqa: E402
from orbearing.uncertainties.__main__ import main as uncertainty_main  # noqa: E402

# A clearance class replaces bearing.radial_clearance.
CLASSED = CASES / "reducer_nu204" / "case.yaml"
CLEARANCE = "bearing.radial_clearance"
REPLACED = f"{CLEARANCE}: found a varied input that has no effect: it counts only where bearing.clearance_class is not given"
SWEPT = f"sweep.{CLEARANCE}: a sweep of an input that has no effect: it counts only where bearing.clearance_class is not given"


class VariedWithoutEffect(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def refused(self, done, *said):
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stdout + done.stderr)
        for text in said:
            self.assertIn(text, done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_commands(self):
        over = f"{CLEARANCE}=0 um..20 um"
        values = f"{CLEARANCE}=[0 um, 10 um, 20 um]"
        self.refused(program.within(study_main, CLASSED, "-o", self.folder / "s", "--vary", values), REPLACED)
        self.refused(run("table", CLASSED, "-o", self.folder / "t", "--over", over), SWEPT)
        self.refused(run("sweep", CLASSED, "-o", self.folder / "w", "--set", f"sweep={{{CLEARANCE}: [0 um, 10 um]}}"), SWEPT)
        self.refused(run("sensitivities", CLASSED, "--by", CLEARANCE), REPLACED)
        # A number that another input gives cannot be uncertain; one that lives at rest do not take can be stated, and not sampled.
        self.refused(run("check", CLASSED, "--set", f"uncertain={{{CLEARANCE}: {{uniform: {{from: 0 um, to: 10 um}}}}}}"), "a number that another input replaces")
        self.refused(program.within(uncertainty_main, REDUCER, "-o", self.folder / "u", "--samples", "8", "--set", "uncertain={bearing.cage.pocket_clearance: {normal: {standard_deviation: 10 um}}}"),
                     "bearing.cage.pocket_clearance: found a varied input that has no effect on --fidelity quasi-static; used by --fidelity dynamic")

    def test_limits_and_names_change_no_result(self):
        """A requirement judges results: none differs by it, nor by what the case is called. By each command that varies inputs, and in Python."""
        limit, text = "requirements.life", "found a varied input with which no result changes; required: an input that has an effect"
        axis = f"sweep={{{limit}: [1 h, 2 h]}}"
        for command in ("check", "run", "sweep"):
            self.refused(run(command, REDUCER, "--json", "--set", axis), f"--set: sweep.{limit}: a limit, which judges results and changes none; ")
        self.refused(run("table", REDUCER, "-o", self.folder / "t", "--over", f"{limit}=1 h..2 h"), f"--over: {limit}: a limit, which judges results")
        self.refused(run("check", REDUCER, "--json", "--set", f"{limit}=5 h", "--set", f"uncertain={{{limit}: {{uniform: {{from: 1 h, to: 9 h}}}}}}"),
                     f"--set: uncertain.{limit}: a limit, which judges results and changes none; ")
        self.refused(run("sensitivities", REDUCER, "--by", limit, "--set", f"{limit}=5 h"), f"{limit}: {text}")
        self.refused(run("sensitivities", REDUCER, "--by", "name"), f"name: {text}")
        self.refused(run("signals", CASES / "scratch_defect", "-o", self.folder / "x", "--vary", "source=[a, b]"), f"source: {text}")
        for path, values in ((limit, "[1 h, 2 h]"), ("name", "[a, b]"), ("source", "[a, b]"), ("requirements.S0", "[1, 2]")):
            self.refused(program.within(study_main, REDUCER, "-o", self.folder / "s", "--vary", f"{path}={values}"), f"{path}: {text}")
        case = orbearing.load(REDUCER)
        for call in (lambda: case.study({limit: ["1 h", "2 h"]}, progress=False), lambda: case.evaluate([limit], [[3600.0]]),
            lambda: case.sensitivities(by=["name"])):
            with self.assertRaises(orbearing.CaseError) as caught:
                call()
            self.assertIn(text, str(caught.exception))

    def test_an_input_that_this_fidelity_does_not_take(self):
        done = program.within(study_main, REDUCER, "-o", self.folder / "s", "--vary", "bearing.cage.pocket_clearance=[0.1 mm, 0.2 mm]")
        self.refused(done, "bearing.cage.pocket_clearance: found a varied input that has no effect on --fidelity quasi-static; used by --fidelity dynamic")

    def test_python(self):
        case = orbearing.load(CLASSED)
        for call in (lambda: case.study({CLEARANCE: ["0 um", "10 um"]}, progress=False), lambda: case.evaluate([CLEARANCE], [[0.0], [1e-5]]),
                     lambda: orbearing.evaluate(case, ["input.speed", CLEARANCE], [[600.0, 0.0]]), lambda: Responses(case, [CLEARANCE], ["life_h"]),
                     lambda: case.sensitivities(by=[CLEARANCE])):
            with self.assertRaises(orbearing.CaseError) as caught:
                call()
            self.assertIn(REPLACED, str(caught.exception))

    def test_what_counts_at_some_points_alone_is_varied(self):
        """An input may count beside another varied one: laminae beside a profile, a clearance where the class is left out."""
        case = orbearing.load(REDUCER)
        found = case.study({"bearing.profile.kind": ["straight", "iso16281"], "bearing.laminae": [30, 40], "input.speed": ["6000 rpm"]}, progress=False)
        self.assertEqual((found.points, found.failed), (4, 0))
        rows = {(row["bearing.profile.kind"], row["bearing.laminae"]) for row in found.variants()}
        self.assertEqual(len(rows), 4)
        columns, numbers, _ = case.evaluate([CLEARANCE], [[0.0], [1e-5]])
        self.assertNotEqual(*numbers[:, columns.index("life_h")])

    def test_signals(self):
        scratch = CASES / "scratch_defect" / "case.yaml"
        done = run("signals", scratch, "-o", self.folder / "x", "--vary", "bearing.cage.density=[1000 kg/m3, 2000 kg/m3]")
        self.refused(done, "bearing.cage.density: found a varied input that has no effect on ")

    def test_what_run_warns_of_is_still_a_warning(self):
        found = answer("run", CLASSED, f"{CLEARANCE}=10 um")
        self.assertTrue(any(text.startswith(f"{CLEARANCE}: 10 um has no effect: it counts only where bearing.clearance_class") for text in found["warnings"]))


if __name__ == "__main__":
    unittest.main()
