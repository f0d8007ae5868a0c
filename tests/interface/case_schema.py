#!/usr/bin/env python3
"""The JSON Schema of case files: valid itself, accepts every shipped case, and refuses what the program refuses.

Needs the source folder in ORBEARING_SOURCE_DIR. Exit code 77 (skipped) where jsonschema or yaml is missing.
"""

import copy
import json
import os
import pathlib
import sys
import unittest

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
SCHEMA = json.loads((SOURCE / "cases" / "case.schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def load(name):
    return yaml.safe_load((SOURCE / "cases" / name / "case.yaml").read_text(encoding="utf-8"))


class CaseSchema(unittest.TestCase):
    def test_schema_is_valid(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_accepts_every_shipped_case(self):
        for path in sorted((SOURCE / "cases").glob("*/case.yaml")):
            with self.subTest(path.parent.name):
                self.assertEqual([error.message for error in VALIDATOR.iter_errors(load(path.parent.name))], [])

    def test_refuses_what_the_program_refuses(self):
        changes = {
            "unknown key": lambda case: case["gearset"].update(modul="3 mm"),
            "missing key": lambda case: case["input"].pop("power"),
            "number without unit": lambda case: case["gearset"].update(module=3),
            "text without unit": lambda case: case["gearset"].update(module="3"),
            "too few rollers": lambda case: case["bearing"].update(rollers=2),
            "fraction": lambda case: case["bearing"].update(rollers=15.5),
            "open bound": lambda case: case["material"].update(poisson_ratio=0.5),
            "unknown choice": lambda case: case["gearset"].update(fixed="pin"),
            "unknown model": lambda case: case.update(model="planets"),
            "sweep of a choice": lambda case: case["sweep"].update({"gearset.fixed": ["sun"]}),
            "unknown assumption": lambda case: case["assumed"].update({"gearset.modul": "why"}),
        }
        self.expect_refused(load("reducer_150kW"), changes)

    def test_refuses_faulty_sets(self):
        changes = {
            "no shafts": lambda case: case.pop("shafts"),
            "one set beside several": lambda case: case.update(gearset={}, bearing={}),
            "unknown key in a set": lambda case: case["sets"]["coupling"]["gearset"].update(modul="3 mm"),
            "missing key in a set": lambda case: case["sets"]["coupling"]["bearing"].pop("rollers"),
            "fixed member in a set": lambda case: case["sets"]["coupling"]["gearset"].update(fixed="ring"),
            "bad name": lambda case: case["sets"].update({"a-b": case["sets"]["coupling"]}),
            "shaft that is no list": lambda case: case["shafts"].update(input="motor"),
            "unknown assumption": lambda case: case["assumed"].update({"sets.coupling.gearset.modul": "why"}),
        }
        self.expect_refused(load("three_sets_150kW"), changes)

    def expect_refused(self, good, changes):
        for kind, change in changes.items():
            with self.subTest(kind):
                case = copy.deepcopy(good)
                change(case)
                self.assertFalse(VALIDATOR.is_valid(case))


if __name__ == "__main__":
    unittest.main()
