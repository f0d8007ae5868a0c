"""Single effects that a report switches are data: each one does something, a switch undoes itself, and what does not fit the case is left out."""

import contextlib
import io
import os
import pathlib
import tempfile
import unittest

import program
from program import BRIEF_GEARS, REDUCER, SETS

from orbearing import effects
from orbearing.report_data import Program, complete, published

LAND = "bearing.cage.guide_land_diameter"
SHORT = (*BRIEF_GEARS, "simulation.most_revolutions=2", "simulation.observed_revolutions=1")


def inputs(case, *settings):
    return {row["path"]: row for row in program.answer("check", case, *settings)["inputs"]}


def named(changes):
    return {change.name: change.settings for change in changes}


class EffectsInMotion(unittest.TestCase):
    def test_a_switch_undoes_itself(self):
        stated = inputs(REDUCER)
        before = named(effects.in_motion(stated, True))
        switches = {"film in the approach": "no film in the approach", "limiting-shear traction": "Coulomb traction",
                    "mixed lubrication": "no mixed lubrication", "film in the pockets": "no film in the pockets",
                    "cage on the inner ring": "cage on the outer ring"}
        settings = [setting for name in switches for setting in before[name]]
        changed = inputs(REDUCER, *settings)
        self.assertAlmostEqual(changed[LAND]["value"], 33.44e-3 - 0.34e-3, delta=1e-12)
        after = named(effects.in_motion(changed, True))
        self.assertFalse(set(switches) & set(after))
        back = inputs(REDUCER, *settings, *(setting for name in switches.values() for setting in after[name]))
        self.assertEqual(set(named(effects.in_motion(back, True))), set(before))
        self.assertAlmostEqual(back[LAND]["value"], 38.88e-3, delta=1e-12)

    def test_of_several_sets_that_one_is_changed_which_is_looked_at(self):
        changes = named(effects.in_motion(inputs(SETS), True, "reduction"))
        self.assertNotIn("constant mesh stiffness", changes)
        changed = inputs(SETS, *changes["cage on the inner ring"])
        self.assertAlmostEqual(changed[f"sets.reduction.{LAND}"]["value"], 33.44e-3 - 0.34e-3, delta=1e-12)
        self.assertEqual(changed[f"sets.coupling.{LAND}"]["value"], inputs(SETS)[f"sets.coupling.{LAND}"]["value"])

    def test_what_the_case_has_not_or_has_already_is_left_out(self):
        stated = inputs(REDUCER, "contact.squeeze=true")
        del stated[LAND]
        left = named(effects.in_motion(stated, True))
        self.assertIn("constant mesh stiffness", left)
        self.assertNotIn("cage on the inner ring", left)
        self.assertNotIn("squeeze of the films", left)

    def test_forms_of_the_case_are_kept(self):
        block = "bearing.outer_race.out_of_roundness"
        form = (f"{block}.order=[3]", f"{block}.amplitude=[1 um]", f"{block}.phase=[30 deg]")
        changed = inputs(REDUCER, *form, *named(effects.in_motion(inputs(REDUCER, *form), True))["oval bore, 5 um"])
        self.assertEqual(changed[f"{block}.order"]["value"], [3, 2])
        self.assertEqual(changed[f"{block}.amplitude"]["value"], [1e-6, 5e-6])
        self.assertEqual(changed[f"{block}.phase"]["value"][1], 0.0)


class Points(unittest.TestCase):
    """Of a result folder, as the page asks for them."""

    def program(self, *settings):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        results = pathlib.Path(folder.name) / "run"
        done = program.run("run", REDUCER, "-o", results, "--quiet", *program.settings(settings))
        self.assertEqual(done.returncode, 0, done.stderr)
        return Program(results, os.environ["ORBEARING"])

    def points(self, asked, changes, fidelity):
        return asked.points(settings=[], set="", changes=[change.settings for change in changes], speeds=[628.0], fidelity=fidelity, loads=False)

    def test_each_effect_changes_the_motion(self):
        asked = self.program(*SHORT)
        changes = [change for change in effects.in_motion(asked.inputs(), True) if change.group != effects.GEARS]
        self.assertEqual(len(named(changes)), len(changes))
        points = [found[0] for found in self.points(asked, changes, "dynamic")]
        for change, point in list(zip(changes, points))[1:]:
            with self.subTest(change.name):
                self.assertGreater(point["life_h"], 0)
                # Only the cage's reference leaves the rollers as they were; the path to it differs all the same.
                for name in ("cage_slip", "power_loss_W"):
                    self.assertNotEqual(point[name], points[0][name])

    def test_a_clearance_that_the_cage_has_no_room_for_is_left_out(self):
        self.assertEqual(len(effects.at_rest(inputs(REDUCER))), 9)
        asked = self.program("bearing.radial_clearance=38 um", "bearing.cage.inner_diameter=30.385 mm")
        changes = effects.at_rest(asked.inputs())
        found = dict(zip(named(changes), self.points(asked, changes, "quasi-static")))
        self.assertIsNone(found["clearance 0 um"])
        self.assertIsNotNone(found["clearance 37 um"])


class Stopped(Exception):
    """Where the motions would begin."""


class AtRestAlone(Program):
    """Answers of the program at rest, all alike."""

    def inputs(self):
        return inputs(REDUCER)

    def influences(self, assumed, result=""):
        return {}

    def points(self, **wanted):
        if wanted["fidelity"] == "dynamic":
            raise Stopped
        point = {"life_h": 1.0, "angle_deg": [0.0], "inner_load_N": [1.0], "outer_load_N": [1.0]}
        return [[point for _ in wanted["speeds"]] for _ in wanted["changes"]]


class Progress(unittest.TestCase):
    """A page of one point in motion takes a minute."""

    def said(self, fidelity, quiet):
        shown = {"set": "", "settings": [], "speeds_rpm": [1480.0], "peak_speed_rpm": 1480.0}
        content = {"fidelity": fidelity, "drawing": {"rollers": 1}, "shown": shown}
        text = io.StringIO()
        with contextlib.redirect_stderr(text), self.assertRaises(Stopped):
            complete(content, AtRestAlone(pathlib.Path("nowhere"), quiet=quiet))
        return text.getvalue()

    def test_motions_are_announced_before_they_are_computed(self):
        effects_of_case = len(effects.in_motion(inputs(REDUCER), False))
        self.assertEqual(self.said("dynamic", False), f"report: single effects in motion: {effects_of_case} at 1480 rpm, each a run in time\n")
        self.assertEqual(self.said("monolithic", False), "report: the same speeds without feedback of the bearings on the gears: 1 point in motion\n")
        self.assertEqual(self.said("dynamic", True), "")


class Published(unittest.TestCase):
    """10,504 h were printed for 49,356 h where a line between 3000 and 9000 rpm passes 6000 rpm."""

    def test_the_point_is_computed_and_nothing_interpolated(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        results = pathlib.Path(folder.name) / "sweep"
        sweep = program.answer("sweep", REDUCER, "sweep.input.speed=[3000 rpm, 9000 rpm]", options=("-o", results, "--grid-only"))
        asked = Program(results, os.environ["ORBEARING"])
        rows = [{"source": "a", "quantity": "peak_speed_rpm", "published": 6000, "reading": ""},
                {"source": "a", "quantity": "peak_life_h", "published": 5e4, "reading": ""},
                {"source": "a", "quantity": "peak_life_h", "published": 4e4, "reading": "another"}]
        content = {"points": sweep["points"], "validation": rows, "fidelity": "quasi-static"}
        one, = published(content, lambda rpm: asked.lundberg_palmgren_life_at(rpm, []))
        life = program.answer("sweep", REDUCER, "sweep.input.speed=[6000 rpm]", options=("--grid-only",))["points"][0]["life_h"]
        self.assertEqual((one["speed_rpm"], one["life_h"], one["ours_h"]), (6000, 5e4, life))
        self.assertIsNone(published({**content, "fidelity": "dynamic"}, self.fail)[0]["ours_h"])  # which nothing here computes
        there = published({**content, "validation": [{**rows[0], "published": 3000}, rows[1]]}, self.fail)[0]
        self.assertEqual((there["ours_h"], there["ours_by"]), (sweep["points"][0]["life_h"], "point of the sweep"))


if __name__ == "__main__":
    unittest.main()
