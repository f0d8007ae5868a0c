#!/usr/bin/env python3
"""Which features of a planetary case work together, at rest, in motion and in an FMU.

Every pair of features goes through the program's own commands. What it accepts must count: a feature that changes the
result by itself changes it beside another one too. `docs/combinations.md` shows what was found; it is written by
`combinations.py --record`, and this test fails where it is no longer what the program does.

What the page says of motion and FMUs is what the program accepts. Pairs are also run in motion and stepped in an FMU: with
ORBEARING_FULL=yes all that work, else those of MOVED_DAILY and STEPPED_DAILY.
"""

import concurrent.futures
import dataclasses
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
import zipfile

from program import BRIEF_GEARS, CASES, LEFT_TO_FULL, REDUCER, SECONDS, SETS, run, settings

PAGE = CASES.parent / "docs" / "combinations.md"
SAME = 1e-9  # of a number: searches that take another way to the same end
ANGLES = [round(step * 360.0 / 116.0, 9) for step in (0, 28, 58, 87)]  # [deg]  at which teeth of 37 + 79 fit


@dataclasses.dataclass(frozen=True)
class Feature:
    """`values` are those of a set; `shared` stand at the top of a case."""

    name: str
    values: tuple = ()
    shared: tuple = ()


SEVERAL = "several sets"
DEFECT = "scratched bearing"
FEATURES = (
    Feature("elastic rim", ("gearset.planet_rim=elastic",)),
    Feature("helix", ("gearset.helix_angle=12 deg",)),
    Feature("computed tilt", ("bearing.laminae=10", "bearing.tilt_state=computed", "bearing.clearance_differences=[4 um, 0 um]")),
    Feature("pin errors", ("gearset.dynamics.pin_error.tangential=[5 um, 0 um, -2 um, 0 um]",)),
    Feature("unequal angles", (f"gearset.planet_angles=[{', '.join(f'{angle} deg' for angle in ANGLES)}]",)),
    Feature(SEVERAL),
    Feature("spectrum in rows", (), ("spectrum=[{power: 150 kW, speed: 6000 rpm, share: 0.5}, {power: 120 kW, speed: 3000 rpm, share: 0.5}]",)),
    Feature("spectrum from a file", (), ("spectrum={file: bins.csv}",)),
    Feature("laminae", ("bearing.laminae=10", "bearing.profile.kind=circular", "bearing.profile.drop=4 um")),
    Feature("loaded teeth", ("gearset.tooth_contact=loaded",)),
    Feature(DEFECT, (), ("defect.race=outer", "defect.width=0.3 mm", "defect.depth=0.02 mm")),
)
BINS = "torque_N_m,speed_rpm,share\n238.7,6000,0.4\n381.9,3000,0.6\n"
# A short run of a bearing in time: sufficient to see which inputs have an effect.
BRIEF = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2", "simulation.length_error=2e-6 mm", *BRIEF_GEARS)
# --fidelity dynamic runs gears that vibrate anew with each fitted bearing. Where this takes long, meshes keep their mean stiffness.
MEAN_MESHES = ("gearset.mesh_variation=false",)
SPECTRA = ("spectrum in rows", "spectrum from a file")
EXPENSIVE = ("elastic rim", "computed tilt", *SPECTRA)
# These have no effect on meshes of mean stiffness. They move with all bearings as one system, as a scratched bearing does; helical ones as all others.
VIBRATING = "loaded teeth"
SCRATCHED = ("signal.sampling_rate=25.6 kHz", "signal.carrier_revolutions=0.2", "signal.carrier_settling=0.05")
SCRATCHED_SET = "defect.set=reduction"  # of several
# Each feature at least once, and each way to move: one bearing, bearings on their seats, gears and bearings as one system.
MOVED_DAILY = (("elastic rim", "helix"), ("elastic rim", "scratched bearing"), ("computed tilt", "pin errors"), ("computed tilt", "scratched bearing"),
               ("unequal angles", "laminae"), ("pin errors", "several sets"), ("several sets", "scratched bearing"), ("spectrum in rows", "laminae"),
               ("spectrum from a file", "scratched bearing"), ("loaded teeth", "scratched bearing"))
STEPPED_DAILY = (("helix", "laminae"), ("pin errors", "loaded teeth"), ("computed tilt", "unequal angles"))
FIDELITIES = {"at rest": "quasi-static", "in motion": "dynamic"}
COLUMNS = ("at rest", "in motion", "FMU")
# Why a pair is refused together, by words of the program's message: what is physics, and what is not built.
PHYSICS, NOT_BUILT = "physics", "not built"
REASONS = ()
# Two forms of one input.
PAIRS = [pair for pair in itertools.combinations(FEATURES, 2) if not all(feature.name.startswith("spectrum") for feature in pair)]


def case_of(features):
    return SETS if any(feature.name == SEVERAL for feature in features) else REDUCER


def settings_of(features):
    """The settings of all; of several sets, those of the first one."""
    prefix = "sets.reduction." if case_of(features) == SETS else ""
    values = [prefix + value for feature in features for value in feature.values]
    shared = [value for feature in features for value in feature.shared]
    return list(dict.fromkeys(values + shared))


def scratched(values, case):
    return [*values, *SCRATCHED, *((SCRATCHED_SET,) if case == SETS else ())]


def is_defect(features):
    return any(feature.name == DEFECT for feature in features)


def reason_of(result):
    """The first complaint, without the place where the value stands and without the name of the first set."""
    line = next((line for line in result.stderr.splitlines() if line.strip()), "")
    line = re.sub(r"^(?:--set|\S+\.yaml(?::\d+: ?\d+)?): ", "", line)
    return line.replace("sets.reduction.", "")


def numbers(value, path=""):
    """All numbers of a result by where they are; those of the machine and of the inputs left out."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key not in ("units", "versions", "assumptions", "warnings", "spectrum_file", "case"):
                yield from numbers(inner, f"{path}/{key}")
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from numbers(inner, f"{path}/{index}")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path, float(value)


def differs(one, other):
    """Whether two results say other things."""
    first, second = dict(numbers(one)), dict(numbers(other))
    if first.keys() != second.keys():
        return True
    return any(not math.isclose(first[key], second[key], rel_tol=SAME, abs_tol=1e-12) for key in first)


@dataclasses.dataclass
class Outcome:
    refused: str = ""  # why; empty: it works
    result: dict | None = None


def outcome_of(result):
    if result.returncode == 0:
        return Outcome(result=json.loads(result.stdout))
    assert result.returncode == 2, (result.returncode, result.stderr)
    return Outcome(refused=reason_of(result))


class Trials:
    """What the program makes of features, alone and in pairs; each is tried once."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        (self.folder / "bins.csv").write_text(BINS, encoding="utf-8")
        os.chdir(self.folder)
        self.known = {}

    def run(self, column, features):
        values, case = settings_of(features), case_of(features)
        nowhere = self.folder / "bins.csv" / "none"  # a folder that cannot be: the case is judged before it
        judged = lambda result: nowhere.name in result.stderr and "cannot be made" in result.stderr
        if column == "FMU":
            outcomes = {model: run("fmu", case, "--model", model, "-o", nowhere / "a.fmu", *settings(values)) for model in ("bearing", "gearset")}
            works = [model for model, result in outcomes.items() if judged(result)]
            return Outcome(result={"models": works}) if works else outcome_of(outcomes["gearset"])
        if is_defect(features):
            values = scratched(values, case)
            return outcome_of(run("run", case, "--json", *(("--fidelity", "quasi-static") if column == "at rest" else ()), *settings(values)))
        options = ("--json", "--fidelity", FIDELITIES[column])
        if column == "at rest":
            return outcome_of(run("run", case, *options, *settings(values)))
        result = run("run", case, *options, "-o", nowhere, *settings(values))
        return Outcome() if judged(result) else outcome_of(result)

    def of(self, column, *features):
        key = (column, *sorted(feature.name for feature in features))
        if key not in self.known:
            self.known[key] = self.run(column, features)
        return self.known[key]

    def all(self):
        some = [(), *((feature,) for feature in FEATURES), *PAIRS]
        wanted = [(column, *features) for column in COLUMNS for features in some]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda one: self.of(*one), wanted))
        return self


def names_of(pair):
    return " and ".join(feature.name for feature in pair)


class Motions:
    """Features alone and in pairs, really in motion, each once."""

    def __init__(self):
        self.known = {}

    @staticmethod
    def way_of(pair):
        """How features move where a pair is looked at: as one system of gears and bearings or not, on meshes of mean stiffness or not."""
        names = {feature.name for feature in pair}
        as_one_system = DEFECT in names or (VIBRATING in names and not names.intersection(("helix", *SPECTRA)))
        return as_one_system, not as_one_system and bool(names.intersection(EXPENSIVE))

    def is_idle(self, one, pair):
        """Several sets are another drivetrain; a vibration has no life, and meshes that give mean forces do not vibrate."""
        as_one_system, mean = self.way_of(pair)
        several = any(feature.name == SEVERAL for feature in pair)
        return one.name == SEVERAL or (one.name in SPECTRA and as_one_system) or (one.name == VIBRATING and not as_one_system and (mean or several))

    def of(self, features, pair):
        key = (self.way_of(pair), *sorted(feature.name for feature in features))
        if key not in self.known:
            self.known[key] = self.run(features, *self.way_of(pair))
        return self.known[key]

    def prepare(self, pair):
        for features in (pair, pair[:1], pair[1:]):
            self.of(features, pair)

    def run(self, features, as_one_system, mean):
        case, values = case_of(features), settings_of(features)
        if as_one_system:
            values = scratched(values if is_defect(features) else [*values, "defect.race=none"], case)
        else:
            brief = (*BRIEF, *(MEAN_MESHES if mean else ()))
            values = [*values, *(value for value in brief if case == REDUCER or not value.startswith("gearset."))]
        done = run("run", case, "--json", *(() if as_one_system else ("--fidelity", "dynamic")), *settings(values))
        assert done.returncode == 0, (values, done.stderr)
        return json.loads(done.stdout)


def is_sound(result):
    """Lives of a point, levels of a vibration: there, and above zero."""
    if "points" not in result:
        return all(result[view]["rms"] > 0.0 for view in ("carrier_frame", "housing")) and result["contact_load_max_N"] > 0.0
    point = result["points"][0]
    return point["status"] == "ok" and all(point[key] > 0.0 for key in ("life_h", "system_life_h", "inner_load_max_N", "power_loss_W"))


# Inputs of an FMU with their values, and outputs.
STEPS, STEP = 2, 1e-5
INPUTS = {"bearing": {"planet.displacement.x": 2e-6, "planet.displacement.y": 25e-6}, "gearset": {"planet[1].force.y": -1900.0}}
OUTPUTS = {"bearing": ("force.x", "force.y", "moment", "cage.speed"), "gearset": ("planet[1].displacement.y", "planet[2].speed", "planet[3].sun_mesh_force")}


def stepped(pair, model, folder):
    """Exported, unpacked and stepped by a bare importer: outputs by FMI 2.0 and 3.0. All FMUs of a model have one library."""
    file = folder / "a.fmu"
    done = run("fmu", case_of(pair), "--model", model, "-o", file, "--quiet", *settings(settings_of(pair)))
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(file) as archive:
        library = f"binaries/linux64/orbearing_{model}.so"
        for name in ("resources/model.txt", "modelDescription.xml", *(() if (folder / library).exists() else (library,))):
            archive.extract(name, folder)
    root = xml.parse(folder / "modelDescription.xml").getroot()
    references = {one.get("name"): one.get("valueReference") for one in root.iter("ScalarVariable")}
    inputs = [f"{references[name]}={value!r}" for name, value in INPUTS[model].items()]
    done = subprocess.run([os.environ["ORBEARING_FMU_LOADER"], folder / library, folder / "resources", root.get("guid"), str(STEPS), str(STEP), *inputs,
                           *(references[name] for name in OUTPUTS[model])], capture_output=True, text=True, timeout=SECONDS, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    rows = dict(re.findall(r"^(fmi[23]) (.*)$", done.stdout, re.MULTILINE))
    return [[float(word) for word in rows[version].split()] for version in ("fmi2", "fmi3")]


EFFECT, NONE = "works", "no effect"


@dataclasses.dataclass
class Cell:
    kind: str  # works, or why not: "alone", PHYSICS or NOT_BUILT
    text: str


def kind_of(reason):
    for words, kind in REASONS:
        if words in reason:
            return kind
    return None


class Table:
    """What a pair is in each column, and the reasons by number."""

    def __init__(self, trials):
        self.trials, self.reasons = trials, []

    def number_of(self, reason):
        if reason not in self.reasons:
            self.reasons.append(reason)
        return self.reasons.index(reason) + 1

    def cell(self, column, pair):
        found = self.trials.of(column, *pair)
        if not found.refused:
            models = (found.result or {}).get("models")
            text = " and ".join(models) if column == "FMU" and models else "yes"
            idle = [] if column != "at rest" else [one.name for one, other in (pair, pair[::-1]) if not self.counts(column, one, other)]
            return Cell(EFFECT, text + (f" ({', '.join(idle)}: not modelled)" if idle else ""))
        alone = [one for one in pair if self.trials.of(column, one).refused]
        if alone:
            return Cell("alone", "; ".join(f"no: {one.name} [{self.number_of(self.trials.of(column, one).refused)}]" for one in alone))
        return Cell(kind_of(found.refused) or "", f"no [{self.number_of(found.refused)}]")

    def counts(self, column, feature, *beside):
        """Whether a feature changes the result, beside another one too; several sets are another drivetrain."""
        if feature.name == SEVERAL:
            return True
        return differs(self.trials.of(column, feature, *beside).result, self.trials.of(column, *beside).result)

    def cells(self):
        return {pair: {column: self.cell(column, pair) for column in COLUMNS} for pair in PAIRS}


def page_of(table):
    cells = table.cells()
    kinds = {column: [row[column].kind for row in cells.values()] for column in COLUMNS}
    lines = ["# Which features work together", "",
             "Written by `tests/interface/combinations.py --record`, which tries each pair of features with the program itself. The test",
             "of the same name fails where this page is no longer what the program does.", "",
             f"{len(cells)} pairs of {len(FEATURES)} features:", "",
             "| | at rest | in motion | FMU |", "|---|---|---|---|"]
    for words, kind in (("work", EFFECT), ("do not, since one of both does not by itself", "alone"), ("refused together, by physics", PHYSICS),
                        ("refused together, not built", NOT_BUILT)):
        lines.append(f"| {words} | " + " | ".join(str(kinds[column].count(kind)) for column in COLUMNS) + " |")
    lines += ["", "At rest: `run`. In motion: `run --fidelity dynamic`; of a scratched bearing, `run`. FMU: the models that `fmu` exports; it warns of features that",
              "an FMU does not include.",
              "`not modelled`: the feature has no effect on mean loads at rest, and the results are those without it.",
              "Pairs that work are run in motion and stepped in an FMU too (all of them with `ORBEARING_FULL=yes`). `tests/interface/neutral_features.py` has",
              "a relation for each pair: a feature of neutral strength gives what the other one gives alone.", "",
              "| feature | stated as |", "|---|---|"]
    for feature in FEATURES:
        stated = ", ".join(f"`{value.split('=')[0]}`" for value in (*feature.values, *feature.shared)) or "`sets`, `shafts`"
        lines.append(f"| {feature.name} | {stated} |")
    lines += ["", "## Pairs", "", "| features | at rest | in motion | FMU |", "|---|---|---|---|"]
    for pair, row in cells.items():
        lines.append(f"| {pair[0].name}, {pair[1].name} | " + " | ".join(row[column].text for column in COLUMNS) + " |")
    lines += ["", "## Reasons", "", "As the program states them:", ""]
    for number, reason in enumerate(table.reasons, 1):
        lines.append(f"{number}. {reason}")
    return "\n".join(lines) + "\n"


class Combinations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.addClassCleanup(os.chdir, os.getcwd())
        cls.trials = Trials(folder.name).all()
        cls.table = Table(cls.trials)

    def test_page_is_what_the_program_does(self):
        self.assertEqual(PAGE.read_text(encoding="utf-8"), page_of(self.table), "run tests/interface/combinations.py --record")

    def test_each_refusal_of_a_pair_has_a_known_reason(self):
        for pair, row in self.table.cells().items():
            for column, cell in row.items():
                self.assertIn(cell.kind, (EFFECT, "alone", PHYSICS, NOT_BUILT), (pair[0].name, pair[1].name, column, cell.text))

    def test_what_changes_a_result_changes_it_beside_another(self):
        """A pair that is accepted and leaves one of both out is the defect that this looks for."""
        column = COLUMNS[0]
        for pair in PAIRS:
            for one, other in (pair, pair[::-1]):
                tried = (self.trials.of(column, *pair), self.trials.of(column, other), self.trials.of(column, one))
                if any(outcome.result is None for outcome in tried) or not self.table.counts(column, one):
                    continue
                with self.subTest(column=column, feature=one.name, beside=other.name):
                    self.assertTrue(self.table.counts(column, one, other))

    def chosen(self, column, daily):
        """Pairs that work and are tried today."""
        return [pair for pair in PAIRS if not self.trials.of(column, *pair).refused
                and (not LEFT_TO_FULL or (pair[0].name, pair[1].name) in daily)]

    def test_pairs_move(self):
        """What is accepted in motion is run, has a result, and differs from the run without the one or the other."""
        motions = Motions()
        pairs = self.chosen("in motion", MOVED_DAILY)
        self.assertTrue(pairs)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(motions.prepare, pairs))
        for pair in pairs:
            with self.subTest(pair=names_of(pair)):
                both = motions.of(pair, pair)
                self.assertTrue(is_sound(both), both)
                for one, other in (pair, pair[::-1]):
                    if not motions.is_idle(one, pair):
                        self.assertTrue(differs(both, motions.of((other,), pair)), one.name)

    def test_pairs_step_in_an_fmu(self):
        with tempfile.TemporaryDirectory() as folder:
            for pair in self.chosen("FMU", STEPPED_DAILY):
                for model in self.trials.of("FMU", *pair).result["models"]:
                    with self.subTest(pair=names_of(pair), model=model):
                        first, second = stepped(pair, model, pathlib.Path(folder))
                        self.assertEqual(first, second)
                        self.assertTrue(all(math.isfinite(value) and value != 0.0 for value in first), first)


def record():
    with tempfile.TemporaryDirectory() as folder:
        PAGE.write_text(page_of(Table(Trials(folder).all())), encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:] == ["--record"]:
        record()
    else:
        unittest.main(verbosity=2)
