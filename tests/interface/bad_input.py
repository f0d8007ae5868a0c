#!/usr/bin/env python3
"""Bad input through the program itself: exit code 2, and a message with place, what was found and what is required.

Needs the program's path in ORBEARING and the source folder in ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
SHIPPED = SOURCE / "cases" / "reducer_150kW" / "case.yaml"
THREE = SOURCE / "cases" / "three_sets_150kW" / "case.yaml"
SECONDS = 600  # a mistake is found at once; this stops a hang

# Mistakes: the text to replace in the shipped case, its replacement, the line of the message and a part of it.
CHANGED_FILES = {
    "wrong syntax": ("  power: 150 kW", "   power: 150 kW", 6, r"\(file\): wrong YAML"),
    "tab for indentation": ("  power: 150 kW", "\tpower: 150 kW", 6, r"\(file\): a tab in the indentation"),
    "quotation not closed": ('reduction set"', "reduction set", None, r"\(file\): "),
    "second document": ("assumed:\n", "---\nassumed:\n", None, r"\(file\): a second YAML document"),
    "anchor": ("power: 150 kW", "power: &p 150 kW", 6, r"\(file\): an anchor"),
    "tag": ("power: 150 kW", "power: !!str 150 kW", 6, r"\(file\): the YAML tag"),
    "unknown key": ("  module:", "  modul:", 14, r"gearset\.modul: unknown key; .*did you mean 'gearset\.module'"),
    "unknown block": ("gearset:\n", "gearsets:\n", 10, r"gearsets: unknown key; .*'gearset'"),
    "duplicate key": ("  planets: 4\n", "  planets: 4\n  planets: 3\n", 13, r"gearset\.planets: duplicate key"),
    "missing key": ("  power: 150 kW\n", "", 4, r"input\.power: missing; a power like '150 kW'"),
    "missing block": ("input:\n  member: sun\n  power: 150 kW\n  speed: 6000 rpm\n", "", 1, r"input\.power: missing"),
    "no value": ("power: 150 kW", "power:", 6, r"input\.power: nothing found"),
    "block for a value": ("power: 150 kW", "power: {value: 150 kW}", 6, r"input\.power: a block found"),
    "value for a block": ("teeth: {sun: 37, planet: 22, ring: 79}", "teeth: 37", 13, r"gearset\.teeth: '37' found"),
    "unknown model": ("planetary-drivetrain", "planets", 3, r"model: 'planets' is none of the choices"),
    "unknown assumption": ("  contact.law:", "  contact.low:", None, r"assumed\.contact\.low: unknown path"),
    "control character": ("reduction set", "reduction\x04set", 2, r"\(file\): a control character"),
}

# Settings of the shipped case, the key of the message and a part of it.
SETTINGS = {
    "no unit": ("bearing.roller_diameter=5.24", "bearing.roller_diameter", "no unit; write number and unit, as in '3 mm'"),
    "unknown unit": ("gearset.module=3 mmm", "gearset.module", "unit 'mmm' is not known"),
    "wrong dimension": ("gearset.module=3 kg", "gearset.module", "does not measure the same"),
    "speed in hertz": ("input.speed=100 Hz", "input.speed", "states no angle"),
    "unit on a ratio": ("life.reduction_factor=0.83 mm", "life.reduction_factor", "number without unit"),
    "infinite": ("input.power=.inf kW", "input.power", "finite number"),
    "not a number": ("life.reduction_factor=.nan", "life.reduction_factor", "finite number"),
    "overflow": ("input.power=1e999 kW", "input.power", "too large"),
    "wrong sign": ("gearset.module=-3 mm", "gearset.module", "greater than 0 mm"),
    "zero power": ("input.power=0 kW", "input.power", "at least 1e-06 kW"),
    "zero speed": ("input.speed=0 rpm", "input.speed", "at least 0.001 rpm"),
    "beyond the range": ("material.poisson_ratio=0.5", "material.poisson_ratio", "less than 0.5"),
    "fraction of a tooth": ("gearset.teeth.sun=37.5", "gearset.teeth.sun", "not a whole number"),
    "word for a switch": ("film.enabled=yes", "film.enabled", "true or false"),
    "unknown choice": ("gearset.fixed=pin", "gearset.fixed", "one of sun, ring, carrier"),
    "unknown path": ("input.powr=3 kW", "input.powr", "did you mean 'input.power'"),
    "no equals sign": ("input.power", "input.power", "has no '='"),
    "teeth that cannot be assembled": ("gearset.planets=5", "gearset.planets", "equally spaced planets"),
    "too many planets": ("gearset.planets=29", "gearset.planets", "at most 24"),
    "block for a number": ("gearset.planets={}", "gearset.planets", "a block found"),
    "fixed member driven": ("input.member=ring", "input.member", "fixed member"),
    "rollers around the pitch circle": ("bearing.rollers=22", "bearing.rollers", "do not fit around"),
    "rollers between the races": ("bearing.pitch_diameter=29 mm", "bearing.bore", "does not fit"),
    "outer race beyond the ring": ("bearing.pitch_diameter=42 mm", "bearing.outside_diameter", "does not fit"),
    "cage in the raceway": ("bearing.cage.outer_diameter=41 mm", "bearing.cage.outer_diameter", "does not fit"),
    "rollers wider than rings": ("bearing.roller_length=12 mm", "bearing.roller_length", "does not fit"),
    "bearings wider than the planet": ("bearing.per_planet=3", "bearing.per_planet", "does not fit"),
    "bearing larger than the planet": ("bearing.outside_diameter=60 mm", "bearing.outside_diameter", "root diameter"),
    "sweep of an unknown field": ("sweep.input.sped=[1 rpm]", "sweep.input.sped", "did you mean 'input.speed'"),
    "sweep step zero": ("sweep.input.speed.step=0 rpm", "sweep.input.speed.step", "greater than 0 rpm"),
    "sweep backwards": ("sweep.input.speed.to=500 rpm", "sweep.input.speed.to", "less than 'from'"),
    "sweep without end": ("sweep.input.speed.step=1e-9 rpm", "sweep.input.speed.step", "too many points"),
    "sweep of a choice": ("sweep.gearset.fixed=[sun]", "sweep.gearset.fixed", "no number"),
    "sweep beside its end": ("sweep.input.speed.step=7777 rpm", "sweep.input.speed.step", "divides the range"),
    "sweep of wrong planets": ("sweep.gearset.planets=[3, 4]", "sweep.gearset.planets", "found 3 equally spaced"),
    "reciprocal unit": ("gearset.module=333 m-1", "gearset.module", "does not measure the same"),
    "empty reason": ("assumed.film.enabled=", "assumed.film.enabled", "the reason"),
}


# Faulty arrangements of the three sets: what to replace, by what, the line of the message and a part of it.
HOUSING = "[ground, reduction.ring, coupling.ring, transmission.ring]"
ARRANGEMENTS = {
    "two grounds on one set": (
        "  first: [reduction.carrier, coupling.sun]\n  second:",
        "  bracket: [ground, reduction.carrier]\n  first: [coupling.sun, load]\n  second:", 11,
        r"shafts\.bracket: speeds that contradict each other: .*reduction\.carrier \(on 'bracket'\)"),
    "floating member": (
        HOUSING, "[ground, reduction.ring, coupling.ring]", 85,
        r"sets\.transmission: transmission\.ring on no shaft, so that it floats; each member"),
    "member alone on a shaft": (
        HOUSING, "[ground, reduction.ring, coupling.ring]\n  loose: [transmission.ring]", 15,
        r"shafts\.loose: transmission\.ring alone, so that it floats; another member"),
    "contradictory shafts": (
        "[motor, reduction.sun]\n  first: [reduction.carrier, coupling.sun]",
        "[motor, reduction.sun, reduction.carrier]\n  first: [coupling.sun, load]", 14,
        r"shafts\.housing: speeds that contradict each other: .*reduction\.sun \(on 'input'\), reduction\.ring"),
    "motor missing": ("[motor, reduction.sun]", "[load, reduction.sun]", 10, r"shafts: no motor on any shaft; one shaft"),
    "two motors": ("[transmission.carrier, load]", "[transmission.carrier, load, motor]", 10,
                   r"shafts\.input: motors on 'input' and 'output'"),
    "load missing": ("[transmission.carrier, load]", "[transmission.carrier, ground]", 10, r"shafts: no load on any shaft"),
    "open torques": ("[coupling.carrier, transmission.sun]", "[coupling.carrier, transmission.sun, load]", 12,
                     r"shafts\.second: torques undetermined: how the loads on 'second' and 'output' share"),
    "open speeds": (", transmission.ring]", "]\n  other: [transmission.ring, load]", 13,
                    r"shafts\.output: speeds undetermined: of transmission\.carrier"),
    "member on two shafts": ("[transmission.carrier, load]", "[transmission.carrier, load, reduction.ring]", 14,
                             r"shafts\.housing: reduction\.ring on 'output' and 'housing'; each member once"),
    "unknown member": ("[motor, reduction.sun]", "[motor, reduktion.sun]", 10,
                       r"shafts\.input: 'reduktion\.sun' cannot be joined; .*as in 'reduction\.sun'"),
    "no shafts": ("shafts:\n", "shaft:\n", 9, r"shaft: unknown key; .*did you mean 'shafts'"),
    "one set beside several": ("sets:\n", "gearset: {planets: 4}\nsets:\n", 16, r"gearset: the fields of one set together with"),
    "bad name": ("  coupling:\n", "  coupling-set:\n", None, r"sets\.coupling-set: the name 'coupling-set'; a name"),
    "missing in a set": ("      rollers: 12\n", "", None, r"sets\.coupling\.bearing\.rollers: missing"),
    "fixed in a set": ("      face_width: 40 mm\n", "      face_width: 40 mm\n      fixed: ring\n", None,
                       r"sets\.transmission\.gearset\.fixed: unknown key; .*'ground'"),
}

# Settings of the three sets, the key of the message and a part of it.
SETTINGS_OF_SETS = {
    "teeth that cannot be assembled": ("sets.reduction.gearset.planets=5", "sets.reduction.gearset.planets", "5 equally"),
    "unknown set": ("sets.reducer.gearset.planets=4", "sets.reducer.gearset.module", "missing"),
    "field of one set": ("gearset.planets=4", "gearset", "together with 'sets' and 'shafts'"),
    "driven member": ("input.member=sun", "input.member", "several sets does not use"),
    "sweep within a set": ("sweep.sets.coupling.gearset.planets=[4, 5]", "sweep.sets.coupling.gearset.planets", "5 equally"),
    "wrong unit in a set": ("sets.coupling.gearset.module=4 kg", "sets.coupling.gearset.module", "does not measure"),
}


def run(*arguments):
    command = [os.environ["ORBEARING"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


class BadInput(unittest.TestCase):
    def expect_message(self, result, pattern):
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, re.compile(pattern, re.MULTILINE))
        for trace in ("std::", "YAML::", "terminate", "what()"):
            self.assertNotIn(trace, result.stderr)

    def test_shipped_case_is_good(self):
        result = run("check", SHIPPED)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("reducer_150kW", result.stdout)

    def test_missing_keys_and_what_tooth_numbers_tell_are_one_round(self):
        """Four planets at equal steps need a sum of teeth that 4 divides: 24 + 90 = 114; 16 keys are missing beside it."""
        text = ("name: b\nmodel: planetary-drivetrain\ninput: {power: 160 Nm}\n"
                "gearset: {planets: 4, teeth: {sun: 24, planet: 33, ring: 90}, module: 3 kg}\nbearing: {rollers: 5.5}\n")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "b.yaml"
            file.write_text(text, encoding="utf-8")
            result = run("check", file)
        for said in (r"^\S*: input\.power: '160 Nm': its unit 'Nm' does not measure the same as 'W' \(it is one of torque\); .*; did you mean 'input\.torque'\?$",
                     r"gearset\.planets: found 4 equally spaced planets; a divisor of sun \+ ring teeth = 114 is required",
                     r"gearset\.module: '3 kg': its unit 'kg' does not measure the same as 'm' \(it is one of mass\)",
                     r"input\.speed: missing", r"bearing\.per_planet: missing", r"bearing\.rollers: '5\.5' is not a whole number"):
            self.expect_message(result, said)
        self.assertNotIn("source", result.stderr)

    def test_the_source_is_the_file_unless_it_is_given(self):
        text = re.sub(r"^source:.*\n", "", SHIPPED.read_text(encoding="utf-8"), flags=re.M)
        with tempfile.TemporaryDirectory() as folder:
            for name, shown in (("mine.yaml", "mine.yaml"), ("gearbox/case.yaml", "gearbox/case.yaml")):
                file = pathlib.Path(folder) / name
                file.parent.mkdir(exist_ok=True)
                file.write_text(text, encoding="utf-8")
                result = run("run", file, "--json")
                self.assertEqual(result.returncode, 0, result.stderr)
                (told,) = [one for one in json.loads(result.stdout)["assumptions"] if one["key"] == "source"]
                self.assertEqual((told["value"], told["reason"]), (shown, "default: name of the case file"))

    def test_changed_files(self):
        self.expect_refused(SHIPPED, CHANGED_FILES)

    def test_faulty_arrangements_name_their_members(self):
        self.expect_refused(THREE, ARRANGEMENTS)

    def expect_refused(self, shipped, changes):
        text = shipped.read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "case.yaml"
            for kind, (old, new, line, pattern) in changes.items():
                with self.subTest(kind):
                    self.assertIn(old, text)
                    path.write_text(text.replace(old, new, 1), encoding="utf-8")
                    where = rf"{re.escape(str(path))}:{line or '[0-9]+'}:[0-9]+: "
                    self.expect_message(run("check", path), "^" + where + pattern)

    def test_settings(self):
        self.expect_settings_refused(SHIPPED, SETTINGS)

    def test_settings_of_multi_stage(self):
        self.expect_settings_refused(THREE, SETTINGS_OF_SETS)

    def expect_settings_refused(self, shipped, settings):
        for kind, (setting, key, part) in settings.items():
            with self.subTest(kind):
                result = run("check", shipped, "--set", setting)
                # A contradiction is reported at the key that does not fit, which may stand in the file.
                self.expect_message(result, rf"^(--set|.*:[0-9]+:[0-9]+): {re.escape(key)}: .*{re.escape(part)}")

    def test_files_that_are_none(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "empty.yaml").write_bytes(b"")
            (root / "bytes.yaml").write_bytes(bytes(range(128, 256)))
            (root / "list.yaml").write_text("- 1\n", encoding="utf-8")
            (root / "deep.yaml").write_text("[" * 100 + "]" * 100, encoding="utf-8")
            (root / "large.yaml").write_text("# " + "x" * (1 << 21), encoding="utf-8")
            for name in ("missing.yaml", "empty.yaml", "bytes.yaml", "list.yaml", "deep.yaml", "large.yaml", "."):
                with self.subTest(name):
                    self.expect_message(run("check", root / name), r":1:[0-9]+: \(file\): .*; .* required$")

    def test_a_wrong_or_missing_model_is_named_in_every_case(self):
        """Nothing that follows from the model may be looked for before it is known."""
        with tempfile.TemporaryDirectory() as folder:
            for shipped in sorted(SOURCE.glob("cases/*/case.yaml")):
                text = shipped.read_text(encoding="utf-8")
                path = pathlib.Path(folder) / "case.yaml"
                for model in ("model: planetary-drivetrian\n", "model: [ball-bearing]\n", "model:\n", ""):
                    with self.subTest(case=shipped.parent.name, model=model):
                        path.write_text(re.sub(r"^model:.*\n", model, text, flags=re.MULTILINE), encoding="utf-8")
                        self.expect_message(run("check", path), rf"^{re.escape(str(path))}:[0-9]+:[0-9]+: model: .* required")
                        self.assertEqual(run("check", shipped, "--set", "model=ball-baering").returncode, 2)

    def test_a_result_wants_a_place_or_json(self):
        for command in ("sweep", "crown"):
            with self.subTest(command):
                self.expect_message(run(command, SHIPPED), r"^--output: missing; required: .*--json")
                self.expect_message(run(command, SHIPPED, "--json", "--resume"), r"^--resume: found without --output")
                self.assertEqual(run(command, SHIPPED, "-o", "").returncode, 2)

    def test_all_mistakes_at_once_in_order(self):
        result = run("check", SHIPPED, "--set", "life.reduction_factor=2", "--set", "input.power=1 m", "--set", "x=1")
        self.assertEqual(result.returncode, 2)
        keys = [line.split(": ")[1] for line in result.stderr.splitlines() if line.startswith("--set: ")]
        self.assertEqual(keys, ["life.reduction_factor", "input.power", "x"])

    def test_every_command_refuses_and_writes_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            for command in ("run", "sweep"):
                with self.subTest(command):
                    output = pathlib.Path(folder) / command
                    result = run(command, SHIPPED, "-o", output, "--set", "input.power=0 kW")
                    self.expect_message(result, r"^--set: input\.power: ")
                    self.assertFalse(output.exists())

    # Every text that comes in is UTF-8, or refused with its place.
    def test_bytes_that_are_not_utf8(self):
        command = os.environ["ORBEARING"].encode()
        case = os.fsencode(SHIPPED)
        with tempfile.TemporaryDirectory() as folder:
            root = os.fsencode(folder)
            text = SHIPPED.read_bytes()
            surrogate, record, expected = root + b"/case.yaml", root + b"/a.csv", root + b"/expected.yaml"
            pathlib.Path(os.fsdecode(surrogate)).write_bytes(text.replace(b"reducer_150kW", b"\xed\xb3\xa4", 1))
            pathlib.Path(os.fsdecode(record)).write_bytes(b"time_s,speed_rpm,torque_N_m\n0,1,1\n1,1,\xff\n")
            for arguments, pattern in (
                    ([b"sweep", case, b"-o", root + b"/s", b"--set", b"name=\xff"], rb"^--set: .*not UTF-8"),
                    ([b"check", case, b"--set", b"name=\x1b[31mred"], rb"^--set: name: a control character"),
                    ([b"check", surrogate, b"--json"], rb"case.yaml:1:7: \(file\): a byte that is not UTF-8"),
                    ([b"check", root + b"/\xff.yaml"], rb"^argument 2: found .*not UTF-8"),
                    ([b"spectrum", record, b"-o", root + b"/o.csv"], rb"a.csv:3:5: found '\xc3\xbf' as torque")):
                done = subprocess.run([command, *arguments], capture_output=True, timeout=SECONDS, check=False)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, re.compile(pattern, re.MULTILINE))
            pathlib.Path(os.fsdecode(surrogate)).write_bytes(text)
            pathlib.Path(os.fsdecode(expected)).write_bytes(b'published:\n  - source: "\xff"\n')
            done = run("validate", os.fsdecode(surrogate))
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"expected.yaml:2:14: .*a byte that is not UTF-8")

    def test_a_moving_bearing_without_load_has_a_place(self):
        text = (SOURCE / "cases" / "deep_groove_motor" / "case.yaml").read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "case.yaml"
            path.write_text(re.sub(r"^(load:.*\n(  .*\n)*|.*load\.radial.*\n)", "", text, flags=re.MULTILINE), encoding="utf-8")
            for command in ("check", "run"):
                self.expect_message(run(command, path, "--json"), rf"^{re.escape(str(path))}:[0-9]+:[0-9]+: load\.radial: missing")

    def test_a_contact_ratio_below_one_is_a_warning(self):
        for command in ("check", "modes", "mesh", "run"):
            done = run(command, SHIPPED, "--json", "--set", "gearset.pressure_angle=10 deg")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(any("contact ratio" in text for text in json.loads(done.stdout)["warnings"]), command)

    # Mistakes of first users, and their remedies.
    def test_remedies(self):
        remedies = {
            "lubricant.grade=ISO VG 321": r"did you mean 'ISO VG 320'",
            "bearing.designation=NU 2242": r"NU 2242' is not in the catalogue; .*nearest: NU 2240, .*number, diameter and pitch diameter",
            "lubricant.grade=ISO VG 3": r"ISO VG 3' is none of the choices",
            "lubricant.grade=VG 220": r"'VG 220' is none of the choices \(did you mean 'ISO VG 220'\?\)",
            "life.cleanliness=17/15/12": r"\(did you mean '-/15/12'\?\)",
            "gearset.teeth.ring=90": r"gearset\.teeth\.ring: found 90, where sun \+ 2 planet = 37 \+ 2 x 22 = 81",
        }
        for setting, pattern in remedies.items():
            with self.subTest(setting):
                self.assertRegex(run("check", SHIPPED, "--set", setting).stderr, pattern)

    def test_check_refuses_what_run_refuses(self):
        """By the same rules and with the same words: what depends on the case alone."""
        cases = SOURCE / "cases"
        for case, settings, text in (
                (cases / "harris_209", ("lubricant.grade=ISO VG 10",), "lubricant.grade: a viscosity for rings that do not rotate; operation.shaft_speed is required"),
                (cases / "templates" / "roller-bearing.yaml", ("operation.shaft_speed=0 rpm",), "lubricant.grade: a viscosity for rings that do not rotate"),
                (cases / "harris_209", ("lubricant.kinematic_viscosity=0.01 mm2/s", "life.cleanliness=high", "operation.shaft_speed=1000 rpm"),
                 "lubricant.kinematic_viscosity: a viscosity ratio kappa of 0.000554 by a viscosity of 0.01 mm2/s; at least 0.1 is required, where a_ISO begins"),
                (cases / "harris_209", ("lubricant.grade=ISO VG 10", "lubricant.temperature=140 degC", "operation.shaft_speed=10 rpm"), "lubricant.grade: a viscosity ratio kappa of 0.00"),
                (cases / "templates" / "defect.yaml", ("defect.width=1e-6 mm", "signal.revolutions=3"), "defect.width: '1e-6 mm'"),
                (cases / "scratch_defect", ("defect.width=0.1 um",), "at least 0.001 mm"),
                (cases / "scratch_defect", ("bearing.outer_ring_mass=1e-9 kg",), "bearing.outer_ring_mass: 1e-9 kg, with which the ring vibrates at 5.21e+07 Hz"),
                (cases / "wind_stage_tapered", ("bearing.balls=4",), "bearing.balls: 4 in a bearing with rollers; none is required, or bearing.type: deep-groove-ball without rollers"),
                (cases / "templates" / "industrial.yaml", ("bearing.balls=4",), "bearing.balls: 4 in a bearing with rollers"),
                (cases / "reducer_150kW", ("bearing.ball_diameter=5 mm",), "bearing.ball_diameter: 5 mm in a bearing with rollers")):
            words = [word for setting in settings for word in ("--set", setting)]
            said = [subprocess.run([os.environ["ORBEARING"], command, str(case), "--json", *words], capture_output=True, text=True, timeout=SECONDS, check=False)
                    for command in ("check", "run")]
            for one in said:
                self.assertEqual((one.returncode, one.stdout), (2, ""), (case, settings, one.stderr))
            self.assertEqual(said[0].stderr, said[1].stderr)
            self.assertIn(text, said[0].stderr)
            self.assertTrue(all(line.startswith("--set: ") for line in said[0].stderr.splitlines()), said[0].stderr)

    def test_balls_beside_rollers_have_their_place(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "case.yaml"
            file.write_text(SHIPPED.read_text(encoding="utf-8").replace("  rollers: 15\n", "  rollers: 15\n  balls: 4\n"), encoding="utf-8")
            for command in ("check", "run", "mesh", "modes"):
                said = subprocess.run([os.environ["ORBEARING"], command, str(file), "--json"], capture_output=True, text=True, timeout=SECONDS, check=False)
                self.assertEqual(said.returncode, 2, command)
                self.assertRegex(said.stderr, r"case\.yaml:\d+:10: bearing\.balls: 4 in a bearing with rollers; ")

    def test_an_empty_number_is_none(self):
        for words in (("signals", SOURCE / "cases" / "scratch_defect", "--noise", ""), ("run", SHIPPED, "--jobs", ""), ("sweep", SHIPPED, "--jobs=")):
            said = subprocess.run([os.environ["ORBEARING"], *map(str, words), "--json"], capture_output=True, text=True, timeout=SECONDS, check=False)
            self.assertEqual((said.returncode, said.stdout), (2, ""), words)
            self.assertIn(next(word for word in map(str, words) if word.startswith("--")).rstrip("="), said.stderr)

    def test_values_of_options_are_what_they_seem(self):
        """No value that every range holds, that becomes another one, or that a shell makes of a variable that is not set; by each command."""
        scratch, reducer = SOURCE / "cases" / "scratch_defect", SOURCE / "cases" / "reducer_150kW"
        natural, signed = "a whole number from 0, of at most 18 digits", "a whole number of at most 18 digits"
        with tempfile.TemporaryDirectory() as folder:
            record = pathlib.Path(folder) / "r.csv"
            record.write_text("time_s,speed_rpm,torque_N_m\n0,1500,10\n1,1500,20\n", encoding="utf-8")
            for words, said in ((("signals", scratch, "--json", "--noise", "nan"), "--noise: found 'nan'; required: a finite number"),
                                (("signals", scratch, "--json", "--noise", "0x10"), "--noise: found '0x10'; required: a finite number"),
                                (("signals", scratch, "--json", "--noise", "1", "--seed", "-1"), f"--seed: found '-1'; required: {natural}"),
                                (("signals", scratch, "--json", "--noise", "1", "--seed", "9" * 20),
                                    f"--seed: found '{'9' * 20}'; required: {natural}"),
                                (("spectrum", record, "--json", "--exponent", "nan"), "--exponent: found 'nan'; required: a finite number"),
                                (("table", reducer, "--json", "--bound", "nan"), "--bound: found 'nan'; required: a finite number"),
                                (("sweep", reducer, "--json", "--jobs", "0x10"), f"--jobs: found '0x10'; required: {signed}"),
                                (("open", "", "--no-browser"), "WHAT: found an empty text; required: a value"),
                                (("check", ""), "CASE: found an empty text; required: a value"),
                                (("crown", reducer, "--json", "--of", ""), "--of: found an empty text; required: a value"),
                                (("modes", reducer, "--json", "--speed", " "), "--speed: found an empty text; required: a value"),
                                (("signals", scratch, "--json", "--vary", "load.radial=[1e30 N]"), "--vary: load.radial: '1e30 N' is out of range"),
                                (("signals", scratch, "--json", *(word for key in ("load.radial",
                                    "bearing.radial_clearance") for word in ("--vary", f"{key}=[{'1 N,' * 400}1 N]"))),
                                 "--vary: found more than 100000 combinations; required: at most as many"),
                                (("run", reducer, "--fidelity", "\x1b[2J"), "--fidelity: \\x1b[2J not in {quasi-static"),
                                (("run", reducer, "--nosuch\x1b[2J"), "\\x1b[2J")):
                with self.subTest(words[:1] + words[2:]):
                    done = subprocess.run([os.environ["ORBEARING"], *map(str, words)], capture_output=True, text=True, timeout=SECONDS, check=False)
                    self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                    self.assertIn(said, done.stderr)
                    self.assertNotIn("\x1b", done.stderr)
            record.write_text("time_s,speed_rpm,torque_N_m\n0,1e9,1e3\n1,1e9,1e3\n", encoding="utf-8")
            done = subprocess.run([os.environ["ORBEARING"], "spectrum", str(record), "--case", str(reducer), "--json"], capture_output=True,
                text=True, timeout=SECONDS, check=False)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, r"^records: speed: '1000000000 rpm' is out of range")

    def test_json_keeps_standard_output_clean(self):
        self.expect_message(run("check", SHIPPED, "--json", "--set", "input.power=0 kW"), r"^--set: input\.power: ")


if __name__ == "__main__":
    if "ORBEARING" not in os.environ:
        print("skipped: ORBEARING does not name the program")
        sys.exit(77)
    unittest.main()
