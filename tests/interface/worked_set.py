"""The worked set for ISO/TS 16281 is what the program computes, and what a second program finds."""

import copy
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", "."))
FOLDER = SOURCE / "cases" / "iso16281_worked_set"
sys.dont_write_bytecode = True  # a tool without a suffix would leave a file beside itself


def module(name, path):
    loader = importlib.machinery.SourceFileLoader(name, str(path))
    loaded = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(loaded)
    return loaded


TOOL = module("worked_set", SOURCE / "tools" / "worked_set")
SECOND = module("recompute", FOLDER / "recompute.py")
STORED = json.loads((FOLDER / "results.json").read_text(encoding="utf-8"))["cases"]


class WorkedSet(unittest.TestCase):
    def test_fifty_cases_of_all_kinds(self):
        self.assertEqual(len(STORED), 50)
        bearings = [case["bearing"] for case in STORED.values()]
        profiles = {bearing.get("profile", {}).get("kind", "straight") for bearing in bearings if "rollers" in bearing}
        self.assertGreaterEqual(profiles, {"straight", "iso16281", "circular", "johns-gohar", "lundberg", "table"})
        self.assertGreaterEqual({bearing["contact_angle_deg"] for bearing in bearings if "balls" in bearing}, {0.0, 15.0, 25.0, 40.0})
        self.assertEqual({case["turning_race"] for case in STORED.values()}, {"inner", "outer"})
        for key in ("moment_N_m", "moment_across_N_m", "tilt_mrad"):
            for kind in ("rollers", "balls"):
                self.assertTrue(any(key in case["load"] and kind in case["bearing"] for case in STORED.values()), (key, kind))
        self.assertLess((FOLDER / "results.json").stat().st_size, 1e6)

    def test_is_what_the_program_computes(self):
        with tempfile.TemporaryDirectory() as folder:
            deviation, case, quantity = TOOL.largest_deviation(TOOL.all_computed(folder), STORED)
        self.assertLessEqual(deviation, TOOL.ALLOWED, (case, quantity))

    def test_second_program_agrees(self):
        for name, case in STORED.items():
            with self.subTest(name):
                for quantity, deviation in SECOND.deviations(case, case["values"], SECOND.worked(case)).items():
                    self.assertLessEqual(deviation, SECOND.ALLOWED, quantity)

    def test_each_changed_number_is_seen(self):
        # A tenth of a millionth in any entry that is not small among its like.
        for name in ("r25", "b23"):
            values = STORED[name]["values"]
            for path, _, number, largest in SECOND.pairs(values, values):
                if abs(number) < 0.5 * largest or number == 0.0 or path.startswith("ring."):
                    continue  # the ring's: in the next test
                changed = copy.deepcopy(values)
                *parents, last = path.replace("[", ".").replace("]", "").split(".")
                place = changed
                for key in parents:
                    place = place[int(key)] if isinstance(place, list) else place[key]
                place[int(last) if isinstance(place, list) else last] = number * (1.0 + 1e-7)
                found = SECOND.deviations(STORED[name], changed, values)
                self.assertGreater(max(found.values()), SECOND.ALLOWED, (name, path))

    def test_ring_and_lists_are_measured_by_their_own_size(self):
        case = STORED["b12"]
        for key, number in case["values"]["ring"].items():
            changed = copy.deepcopy(case["values"])
            changed["ring"][key] = number + 1e-6 * max(abs(number), 1.0)
            self.assertGreater(max(SECOND.deviations(case, changed, case["values"]).values()), SECOND.ALLOWED, key)
        shorter = copy.deepcopy(case["values"])
        shorter["contact_loads_N"].pop()
        with self.assertRaises(ValueError):
            SECOND.deviations(case, shorter, case["values"])
        del shorter["gamma"]
        with self.assertRaises(KeyError):
            SECOND.deviations(case, shorter, case["values"])


if __name__ == "__main__":
    if "ORBEARING" not in os.environ:
        print("skipped: ORBEARING does not name the program")
        sys.exit(77)
    unittest.main()
