#!/usr/bin/env python3
"""All that the page draws and sends is as it was recorded: each element, text, attribute, point of a path, request and message after each step of page_scenes.py.

    page_drawn_record.py                    compares with page_drawn_record.json.xz; the message names scene, step and element with both values
    page_drawn_record.py --record           writes it anew, after a change that is meant; look at what it prints. Names of scenes behind it: these alone
    page_drawn_record.py --record --cases   checks the cases by the program and takes the schemas anew before, into page_cases.json.xz

The program is not asked otherwise: cases and schemas are those of page_cases.json.xz, so that a new input or default changes no record.
"""

import json
import lzma
import re
import subprocess
import sys
import unittest

from page_fixture import HERE, KEYS, NODE, RESULTS, SPEED, WEB, check_of
from page_scenes import SCENES, TEXTS
from page_tables import arguments
from program import CASES

RECORD, GIVEN = HERE / "page_drawn_record.json.xz", HERE / "page_cases.json.xz"
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
CLOSE = 1e-6  # of a number; geometry has sines, whose last digits are not those of each machine
MOST_SHOWN = 12
LEFT_OUT = {"parallel_stage", "contact", "film", "inertia", "numerics", "simulation", "drag", "heat", "assumed", "dynamics", "carrier", "tip_relief", "lead_crown", "lead_slope",
            "stepped_planet", "second_planet", "addendum_of", "clearance_of", "web", "misalignment", "inner_race", "outer_race", "fit", "support", "traction", "defect", "signal", "uncertain", "spectrum", "equilibrium", "response"}
MANY = 12
FEW = {"name", "model", "sweep", "input", "input.speed", "speed", "power", "torque", "torque_curve", "pair", "teeth", "load", "radial"}  # inputs of scenes that are not about the form


def read(file):
    return json.loads(lzma.decompress(file.read_bytes()))


def write(file, content):
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":"))
    file.write_bytes(lzma.compress(text.encode(), preset=9 | lzma.PRESET_EXTREME))


def shorter(part, few):
    """A part of the schema of cases with some inputs of each kind: hundreds of like rows take long and find no more."""
    part = {**part, **{of: {name: shorter(one, few) if isinstance(one, dict) else one for name, one in part[of].items() if name not in LEFT_OUT}
                       for of in ("properties", "patternProperties") if of in part}}
    if len(part.get("examples", [])) > MANY:  # designations of a catalogue; those that the scenes name, and others
        part["examples"] = [one for one in part["examples"] if one in ("NU 204", "NU 2206")] + part["examples"][:MANY]
    if few and "properties" in part:
        part["properties"] = {name: one for name, one in part["properties"].items() if name in FEW}
    return part


def given_anew():
    result, case = (json.loads((CASES / f"{which}.schema.json").read_text(encoding="utf-8")) for which in ("result", "case"))
    of_sets = case["$defs"]["planetary-drivetrain"]["properties"]
    for name in ("sweep", "uncertain"):
        of_sets[name] = {key: dict(list(value.items())[:6]) if key in ("properties", "patternProperties") else value for key, value in of_sets[name].items()}
    schemas = {"result": result, "case": {"$defs": {model: shorter(part, False) for model, part in case["$defs"].items()}},
               "few": {"$defs": {model: shorter(part, True) for model, part in case["$defs"].items()}}}
    checks = {name: {"text": text, **check_of(text)} for name, text in TEXTS.items()}
    for one in checks.values():
        one["check"]["inputs"] = [{key: value for key, value in entry.items() if key != "origin"} for entry in one["check"]["inputs"]]  # a path of this machine
    return {"schemas": schemas, "keys": KEYS, "checks": checks}


FUNCTIONS = "functions"  # in the place of a scene: what functions give for the arguments of page_tables.py


def node_of(program, given):
    done = subprocess.run([NODE, str(HERE / program)], input=json.dumps(given), capture_output=True, text=True, timeout=300, check=False)
    return done.stderr[-2000:] if done.returncode else json.loads(done.stdout)


def computed(given):
    """The tables as steps, of which each row has its place."""
    found = node_of("page_functions.mjs", arguments(WEB, given["schemas"]["result"]))
    if isinstance(found, str):
        return [{"step": "functions", "page": {}, "log": [], "failed": found}]
    return [{"step": name, "log": [], "page": {(json.dumps(key) if isinstance(table, dict) else f"row {key + 1}"): json.dumps(one, ensure_ascii=False)
                                              for key, one in (table.items() if isinstance(table, dict) else enumerate(table if isinstance(table, list) else [table]))}} for name, table in found.items()]


def played(name, given):
    """What the page draws and sends in a scene: of each step {step, page, log}."""
    if name == FUNCTIONS:
        return computed(given)
    scene = SCENES[name]
    checks = [{"speed": SPEED, **given["checks"][name]} for name in scene["texts"]]
    for case in scene.get("made", {}).values():
        checks.append({"speed": SPEED, "check": case["edit"](given["checks"][case["base"]]["check"]), **{key: case[key] for key in ("text", "results", "nulls", "errors") if key in case}})
    fixture = {"recorded": True, "web": str(WEB), "given_schemas": {"case": given["schemas"][scene.get("inputs", "few")], "result": given["schemas"]["result"]}, "keys": given["keys"], "checks": checks, "units": {}, "width": 800, "box": [13, 29],
               "opened": {"kind": "case", "name": "case.yaml", "file": "case.yaml", "text": checks[0]["text"], "checksum": "as opened", "writable": True, "folder": "/x"},
               "takes": {"sweep": 30, "run": 7, "check": 3}, **{key: value for key, value in scene.items() if key not in ("texts", "made", "inputs", "results")},
               "results": {**RESULTS, **scene.get("results", {})}}
    found = node_of("page_dom.mjs", fixture)
    if isinstance(found, str):
        return [{"step": "the page", "page": {}, "log": [], "failed": found}]
    return [*found["record"], {"step": "at the end", "page": {}, "log": [["failures", *(one.split("\n")[0] for one in found["failures"])], ["downloads", *found["downloads"]], ["copied", *found["copied"]]]}]


def is_close(one, other):
    if one == other:
        return True
    a, b = float(one), float(other)
    places = min(len(text.partition(".")[2]) for text in (one, other)) if "e" not in one + other else 0
    return abs(a - b) <= max(CLOSE * max(abs(a), abs(b)), 1.01 * 10.0**-places if places > 1 else 0, 1e-9)


def is_same(one, other):
    """Words alike, numbers to their sixth digit or the last that is written."""
    if one == other:
        return True
    if not isinstance(one, str) or not isinstance(other, str) or NUMBER.sub("#", one) != NUMBER.sub("#", other):
        return False
    return all(map(is_close, NUMBER.findall(one), NUMBER.findall(other)))


def differences(scene, found, recorded):
    """Of the first step that differs, in words."""
    for step, before in zip(found, recorded):
        where = f"scene {scene}, step {before['step']!r}"
        if step.get("failed"):
            return [f"{where}: {step['failed']}"]
        said = [f"{where}, {place or 'the document'}:\n    recorded {before['page'].get(place, 'as before')!r}\n    found    {step['page'].get(place, 'as before')!r}"
                for place in {**before["page"], **step["page"]} if not is_same(before["page"].get(place, 0), step["page"].get(place, 0))]
        for what in ("step", "title", "focused"):
            if step.get(what) != before.get(what):
                said.append(f"{where}, {what}: recorded {before.get(what)!r}, found {step.get(what)!r}")
        logs = [[json.dumps(one, ensure_ascii=False) for one in of["log"]] for of in (before, step)]
        if len(logs[0]) != len(logs[1]) or not all(map(is_same, *logs)):
            first = next((i for i, (one, other) in enumerate(zip(*logs)) if not is_same(one, other)), min(map(len, logs)))
            one, other = ([*log, "nothing more"][first:first + 1][0] if first <= len(log) else "nothing" for log in logs)
            said.append(f"{where}, what is sent and done, number {first + 1}:\n    recorded {one}\n    found    {other}")
        if said:
            return said
    return [] if len(found) == len(recorded) else [f"scene {scene}: {len(recorded)} steps are recorded, {len(found)} were found"]


class Recorded(unittest.TestCase):
    """One test for each scene, below."""

    given = record = None

    @classmethod
    def setUpClass(cls):
        cls.given, cls.record = read(GIVEN), read(RECORD)

    def test_scenes_are_those_of_the_record(self):
        self.assertEqual(sorted([*SCENES, FUNCTIONS]), sorted(self.record))

    def play(self, name):
        said = differences(name, json.loads(json.dumps(played(name, self.given))), self.record[name])
        more = f"\nand {len(said) - MOST_SHOWN} more" if len(said) > MOST_SHOWN else ""
        if said:
            self.fail("\n".join(one if len(one) < 3000 else f"{one[:3000]} ..." for one in ["", *said[:MOST_SHOWN]]) + more + "\n--record writes the record anew where this is meant")


def test_of(name):
    return lambda self: self.play(name)


for scene_name in (*SCENES, FUNCTIONS):
    setattr(Recorded, f"test_{scene_name.replace(' ', '_')}", test_of(scene_name))


def main(words):
    if "--record" not in words:
        unittest.main()
    if "--cases" in words:
        write(GIVEN, given_anew())
    given, before = read(GIVEN), read(RECORD) if RECORD.exists() else {}
    wanted = [word for word in words if not word.startswith("--")] or [*SCENES, FUNCTIONS]
    found = {name: played(name, given) for name in wanted}
    for name, steps in found.items():
        print(name, "is new" if name not in before else "\n".join(differences(name, steps, before[name])[:3]) or "as before", sep=": ")
        for step in steps:
            if step.get("failed"):
                sys.exit(step["failed"])
    write(RECORD, {name: found.get(name, before.get(name)) for name in (*SCENES, FUNCTIONS)})


if __name__ == "__main__":
    main(sys.argv[1:])
