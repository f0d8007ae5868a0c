"""The whole corpus of recorded_results.py: what is run of all cases, and broken and changed cases drawn by a fixed seed.

A record of it is what a reconstruction of the program is compared with. It is large and not kept in the repository.
"""

import json
import random
import re

SECONDS = 30.0  # of the processor, of a command; what takes longer is left out of a comparison
SEED = 20250611
BROKEN, CHANGED = 500, 1000
COMMANDS = ("check", "run", "sweep", "crown", "modes", "mesh", "stiffness", "carrier", "signals", "sensitivities", "table")
# Of these a part that is long enough.
OPTIONS = {"table": ("--points", "60", "--bound", "0.5"), "sweep": ("--grid-only",)}
UNITS = ("mm", "um", "kW", "rpm", "N", "deg", "kg", "mPa.s", "GPa", "s", "bogus", "")
# Two statements of one thing, or what excludes itself.
CONTRADICTIONS = (
    ("input.power=10 kW", "input.torque=5 N.m"), ("bearing.radial_clearance=5 um", "bearing.clearance_class=C3"), ("spectrum={file: loads.csv}", "input.power=5 kW"),
    ("bearing.rows.preload=1 kN", "bearing.rows.approach=5 um"), ("lubricant.grade=ISO VG 68", "lubricant.viscosity=10 mPa.s"),
    ("gearset.fixed=sun", "input.member=sun"), ("load.tilt=0 mrad", "load.moment=5 N.m"), ("bearing.fit.inner_interference=5 um", "bearing.fit.pin_class=k5"),
    ("bearing.designation=NU 204", "bearing.bore=33 mm"), ("bearing.complement=full", "bearing.cage.material=brass"),
    ("heat.enabled=true", "lubricant.flow=0 L/min"), ("defect.race=outer", "defect.depth=null"), ("life.method=iso-281", "life.stress_riser=standard"),
    ("gearset.teeth.sun=38", "gearset.planets=7"), ("simulation.observed_revolutions=9", "simulation.most_revolutions=2"), ("bearing.rings=none", "bearing.bore=25 mm"),
    ("traction.law=limiting-shear", "traction.friction=0.05"), ("preload=100 N", "spacer_difference=5 um"), ("operation.shaft_speed=1000 rpm", "operation.speeds=[0 rpm]"),
    ("gearset.helix_angle=10 deg", "bearing.per_planet=1"), ("bearing.tilt_state=computed", "bearing.misalignment.planet_tilt=1 mrad"),
)


def case_files(source):
    folder = source / "cases"
    return sorted([*folder.glob("*/case.yaml"), *folder.glob("validation/*/case.yaml"), *folder.glob("templates/*.yaml"), *folder.glob("*/in_time.yaml"),
                   *(source / "tests" / "interface" / "recorded_cases").glob("*.yaml")])


def entries(source, entry):
    made = []
    for file in case_files(source):
        name = file.relative_to(source).as_posix()
        made += [entry(f"{command} {name}", (command, str(file), *OPTIONS.get(command, ()), "--json")) for command in COMMANDS]
        made.append(entry(f"spectrum {name}", ("spectrum", str(source / "tests/interface/recorded_cases/record.csv"), "--case", str(file), "--bins", "2x2", "--json")))
    return made + list(broken(source, entry)) + list(changed(source, entry))


# --- broken cases

def leaf_lines(lines):
    """Numbers of lines that state a value."""
    return [number for number, line in enumerate(lines) if re.match(r"\s*[\w.]+: *\S", line) and not line.startswith(("name:", "source:"))]


def misspelt(draw, line):
    head, rest = line.split(":", 1)
    letters = list(head)
    at = draw.choice([index for index, letter in enumerate(letters) if letter.isalpha()])
    letters[at] = draw.choice(["", letters[at] * 2, draw.choice("aeioxz")])
    return "".join(letters) + ":" + rest


def with_value(line, value):
    return line.split(":", 1)[0] + ": " + value


def in_other_unit(draw, line):
    return re.sub(r"(?<=\d) *[a-zA-Z.%/0-9-]*(?=[\s,}\]]*$)", lambda _: " " + draw.choice(UNITS), line, count=1)


def out_of_range(draw, line):
    return re.sub(r"-?\d[\d.]*(e-?\d+)?", lambda found: draw.choice(["-" + found[0], "0", found[0] + "e9", found[0] + "e-12", "1e400", "nan"]), line, count=1)


def another_text(draw, line):
    return with_value(line, draw.choice(["nonsense", "true", "[1, 2, 3]", "{a: 1}", "~", '""', "12", "1,5 mm", "5 mm mm"]))


def break_lines(draw, lines):
    """One of the ways a case is broken; its name and the lines."""
    at = draw.choice(leaf_lines(lines))
    way = draw.choice(("misspelt", "unit", "range", "text", "missing", "twice", "indented", "tab", "open", "choice"))
    line = lines[at]
    fresh = {"misspelt": lambda: [misspelt(draw, line)], "unit": lambda: [in_other_unit(draw, line)], "range": lambda: [out_of_range(draw, line)],
             "text": lambda: [another_text(draw, line)], "missing": lambda: [], "twice": lambda: [line, line], "indented": lambda: ["  " + line],
             "tab": lambda: ["\t" + line], "open": lambda: [line + " {"], "choice": lambda: [with_value(line, draw.choice(["sun", "outer", "iso-281", "caged"]))]}[way]()
    return way, [*lines[:at], *fresh, *lines[at + 1:]]


def broken(source, entry):
    draw, files = random.Random(SEED), case_files(source)
    for number in range(BROKEN):
        file = draw.choice(files)
        name = file.relative_to(source).as_posix()
        if draw.random() < 0.2:
            pair = draw.choice(CONTRADICTIONS)
            blocks = {re.split(r"[.=]", one)[0] for one in pair}
            fitting = [one for one in files if all(f"\n{block}:" in one.read_text(encoding="utf-8") for block in blocks)]
            file = draw.choice(fitting or files)
            name = file.relative_to(source).as_posix()
            yield entry(f"broken {number}: contradicting {name}", ("check", str(file), "--json", *(word for one in pair for word in ("--set", one))))
            continue
        lines = file.read_text(encoding="utf-8").splitlines()
        names = []
        for _ in range(draw.choice((1, 1, 1, 2, 4))):
            way, lines = break_lines(draw, lines)
            names.append(way)
        yield entry(f"broken {number}: {', '.join(names)} {name}", ("check", "case.yaml", "--json"), "\n".join(lines) + "\n")


# --- changed cases

def leaves(value, path=""):
    if isinstance(value, dict):
        for key, inner in value.items():
            if path or key not in ("name", "source", "model", "assumed", "uncertain", "measured", "sweep", "requirements"):
                yield from leaves(inner, f"{path}.{key}" if path else str(key))
    elif not isinstance(value, list):
        yield path, value


def choices_of(schema):
    """Choices by path, as in case.schema.json."""
    found = {}

    def walk(part, path):
        if isinstance(part, dict):
            if "enum" in part and path:
                found.setdefault(path, set()).update(map(str, part["enum"]))
            for key, inner in part.items():
                if key == "properties":
                    for name, below in inner.items():
                        walk(below, f"{path}.{name}" if path else name)
                else:
                    walk(inner, path)
        elif isinstance(part, list):
            for inner in part:
                walk(inner, path)

    walk(schema, "")
    return {path: sorted(names) for path, names in found.items()}


def drawn_value(draw, path, value, choices):
    """Another value near by; None for what has none."""
    plain = re.sub(r"^sets\.\w+\.", "", path)
    if plain in choices and not isinstance(value, bool):
        return draw.choice(choices[plain])
    if isinstance(value, bool):
        return str(not value).lower()
    factor = round(draw.uniform(0.7, 1.4), 3)
    if isinstance(value, int):  # numbers of teeth and planets rarely fit each other afterwards
        return str(value + draw.choice((-1, 1, 2))) if draw.random() < 0.2 else None
    found = re.fullmatch(r"(-?\d[\d.]*(?:e-?\d+)?)(.*)", str(value))
    return f"{float(found[1]) * factor:.6g}{found[2]}" if found else None


def changed(source, entry):
    import yaml  # of the whole corpus alone

    draw, files = random.Random(SEED + 1), case_files(source)
    choices = choices_of(json.loads((source / "cases" / "case.schema.json").read_text(encoding="utf-8")))
    stated = {file: [(path, value) for path, value in leaves(yaml.safe_load(file.read_text(encoding="utf-8")))] for file in files}
    for number in range(CHANGED):
        file = draw.choice(files)
        settings = {}
        for path, value in draw.sample(stated[file], min(len(stated[file]), draw.choice((1, 1, 2, 3)))):
            fresh = drawn_value(draw, path, value, choices)
            if fresh is not None:
                settings[path] = fresh
        words = [word for path, value in settings.items() for word in ("--set", f"{path}={value}")]
        yield entry(f"changed {number}: {file.relative_to(source).as_posix()} {' '.join(words[1::2])}", ("check", str(file), "--json", *words))
