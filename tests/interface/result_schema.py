#!/usr/bin/env python3
"""cases/result.schema.json: what every command prints of every shipped case fits it, key by key and unit by unit.

Needs the source folder in ORBEARING_SOURCE_DIR and the program in ORBEARING. Exit code 77 (skipped) where jsonschema is missing.
"""

import json
import sys
import unittest

from program import CASES, LEFT_TO_FULL, REDUCER, run, settings

try:
    import jsonschema
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

SCHEMA = json.loads((CASES / "result.schema.json").read_text(encoding="utf-8"))
QUICK = [["check"], ["run"], ["run", "--gears"], ["mesh"], ["modes"], ["modes", "--speed=3000 rpm"], ["stiffness"]]
LONG = [["sweep", "--grid-only"], ["sensitivities"], ["validate"], ["crown", "--drops=0 um, 4 um, 8 um", "--tilts=0 mrad, 1 mrad", "--starts=1"]]
# Cases in motion or with many points, in few steps.
SHORT = {"deep_groove_motor": ["simulation.duration=5 ms"], "deep_groove_acceleration": ["simulation.duration=5 ms"],
         "nasa_35mm": ["simulation.duration=2 ms"], "planet_scratch": ["signal.carrier_revolutions=1"]}


def faults_of(name, found):
    return [f"{name}: {'/'.join(map(str, fault.path))}: {fault.message}"
            for fault in jsonschema.Draft202012Validator(SCHEMA["$defs"][name]).iter_errors(found)]


def wrong_units(schema, found, units, above=""):
    """Numbers of a result whose units are not those of the schema."""
    for key, value in found.items():
        known = schema.get("properties", {}).get(key, {})
        stated = units.get(above + key, units.get(key))
        if "unit" in known and value is not None and known["unit"] != stated:
            yield f"{above}{key}: {stated} in place of {known['unit']}"
        for part in value if isinstance(value, list) else [value]:
            if isinstance(part, dict):
                yield from wrong_units(known.get("items", known), part, units, f"{above}{key}/")


class ResultSchema(unittest.TestCase):
    def test_is_a_schema(self):
        for schema in SCHEMA["$defs"].values():
            jsonschema.Draft202012Validator.check_schema(schema)

    def test_every_number_has_a_meaning(self):
        self.assertEqual(SCHEMA["$defs"]["run sweep"]["properties"]["points"]["items"]["properties"]["C_N"],
                         {"type": ["number", "null"], "description": "basic dynamic load rating", "unit": "N", "symbol": "C"})

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_has_what_is_printed(self):
        for case in sorted(CASES.glob("*/case.yaml")):
            for command in QUICK if LEFT_TO_FULL and case != REDUCER else QUICK + LONG:
                if case.parent.name in SHORT and command in LONG:
                    continue  # in motion
                with self.subTest(f"{command} {case.parent.name}"):
                    self.check(*command, case=case)

    def check(self, name, *options, case):
        result = run(name, case, "--json", *options, *settings(SHORT.get(case.parent.name, [])))
        if result.returncode == 2 or not result.stdout:
            return  # no command for this model
        found = json.loads(result.stdout)
        names = [one for one in SCHEMA["$defs"] if one.split(maxsplit=1)[0] == name]
        faults = {one: faults_of(one, found) for one in names}
        fitting = min(names, key=lambda one: len(faults[one]))
        self.assertEqual(faults[fitting][:5], [])
        if name != "check":  # units of paths
            self.assertEqual(list(wrong_units(SCHEMA["$defs"][fitting], found, found["units"])), [])


if __name__ == "__main__":
    unittest.main()
