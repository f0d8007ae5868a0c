#!/usr/bin/env python3
"""Each choice of each field that has choices runs in at least one case, with the status ok and counting there."""

import json
import os
import subprocess
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from program import LEFT_TO_FULL

SOURCE = Path(os.environ["ORBEARING_SOURCE_DIR"])
FULL = os.environ.get("ORBEARING_FULL", "yes") == "yes"
CASES = SOURCE / "cases"
REDUCER, INDUSTRIAL = CASES / "reducer_150kW/case.yaml", CASES / "templates/industrial.yaml"
# Cases for choices that no entry below names; they are tried one after the other.
ANYWHERE = (INDUSTRIAL, CASES / "templates/roller-bearing.yaml", CASES / "templates/ball-bearing.yaml", CASES / "templates/duplex.yaml",
            CASES / "templates/defect.yaml", CASES / "spin_film_guo2013/case.yaml", CASES / "mesh_62_62/case.yaml", CASES / "deep_groove_motor/case.yaml")
MOVING = ("--fidelity", "dynamic")
SHORT = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2", "gearset.mesh_variation=false")
COMPUTED = ("bearing.laminae=30", "bearing.tilt_state=computed")
LAMINAE = ("bearing.laminae=30",)
LOADED = ("gearset.tooth_contact=loaded", "gearset.tip_relief.sun=20 um", "gearset.tip_relief.planet=20 um")
# Cases whose planets are not on cylindrical rollers one by one.
GEARS = """name: choices
source: none
model: planetary-drivetrain
input: {member: sun, power: 20 kW, speed: 1500 rpm}
gearset:
  planets: 3
  teeth: {sun: 33, planet: 21, ring: %d}
  module: 4 mm
  profile_shift: {sun: 0.2, ring: 0.3}
  face_width: 40 mm
%s
bearing: {type: %s, per_planet: 1, pitch_diameter: 42 mm, radial_clearance: 20 um, bore: 30 mm, outside_diameter: 55 mm, width: 25 mm,
          cage: {inner_diameter: 38 mm, outer_diameter: 46 mm, width: 20 mm, density: 8500 kg/m3}, %s}
"""
ROLLERS = "rollers: 14, roller_diameter: 7 mm, roller_length: 16 mm"
WRITTEN = {
    "pairs": GEARS % (93, "  second_planet: {teeth: 23, first_profile_shift: 0.1, profile_shift: 0.15}", "cylindrical-roller", ROLLERS),
    "balls": GEARS % (75, "", "deep-groove-ball", "balls: 8, ball_diameter: 9 mm"),
    "spherical": GEARS % (75, "", "spherical-roller", "rows: {contact_angle: 10 deg}, " + ROLLERS),
}
# Inputs that a choice requires for an effect: the case, settings, words, and the command.
BESIDE = {
    "support.pin_ends": (INDUSTRIAL, COMPUTED, ()),
    "bearing.tilt_state": (INDUSTRIAL, LAMINAE, ()),
    ("bearing.clearance_state", "operating"): (REDUCER, (), ()),
    ("bearing.profile.kind", "table"): (INDUSTRIAL, (*LAMINAE, "bearing.profile.x=[-4 mm, 0 mm, 4 mm]", "bearing.profile.drops=[5 um, 0 um, 5 um]"), ()),
    "bearing.rings": (REDUCER, SHORT, MOVING),
    "bearing.rows.arrangement": (CASES / "wind_stage_tapered/case.yaml", (), ()),
    ("bearing.type", "tapered-roller"): (CASES / "wind_stage_tapered/case.yaml", (), ()),
    ("bearing.type", "spherical-roller"): ("spherical", (), ()),
    ("bearing.type", "deep-groove-ball"): ("balls", (), ()),
    "contact.lubrication": (INDUSTRIAL, (*SHORT, "contact.roughness=0.3 um"), MOVING),
    "defect.also": (CASES / "planet_scratch/case.yaml", (), ()),
    ("defect.form", "profile"): (CASES / "templates/defect.yaml", ("defect.profile=[0, 1, 0]",), ()),
    ("defect.race", "roller"): (CASES / "scratched_rollers/case.yaml", (), ()),
    ("gearset.fixed", "sun"): (INDUSTRIAL, ("input.member=carrier",), ()),
    "gearset.second_planet.side": ("pairs", (), ()),
    "gearset.sun_thrust": (INDUSTRIAL, ("gearset.helix_angle=10 deg",), (), "mesh"),
    "gearset.tip_relief.form": (INDUSTRIAL, LOADED, (), "mesh"),
    "gearset.tooth_contact": (INDUSTRIAL, (), (), "mesh"),
    "heat.model": (CASES / "deep_groove_motor/case.yaml", ("heat.enabled=true", "lubricant.flow=0.5 L/min", "simulation.duration=0.001 s"), ()),
    ("input.member", "ring"): (INDUSTRIAL, ("gearset.fixed=carrier",), ()),
    ("input.speed_of", "ring"): (INDUSTRIAL, ("gearset.fixed=carrier",), ()),
    ("life.cleanliness", "-/21/18"): (INDUSTRIAL, ("life.lubrication=oil-bath",), ()),
    ("life.cleanliness", "lowest"): (INDUSTRIAL, ("life.lubrication=oil-bath",), ()),
    ("life.lubrication", "grease"): (INDUSTRIAL, ("life.cleanliness=high",), ()),
    ("lubricant.grade", "stated"): (INDUSTRIAL, ("lubricant.viscosity_40=220 mm2/s", "lubricant.viscosity_100=19 mm2/s"), ()),
    "lubricant.fill": (CASES / "deep_groove_motor/case.yaml", ("lubricant.flow=0.5 L/min", "simulation.duration=0.001 s"), ()),
    ("pair.kind", "internal"): (CASES / "mesh_62_62/case.yaml", ("pair.teeth=[62, 140]",), (), "mesh"),
    "simulation.exchange.order": (INDUSTRIAL, SHORT, ("--fidelity", "co-simulated")),
    "simulation.form": (CASES / "deep_groove_acceleration/case.yaml", ("simulation.duration=0.001 s",), ()),
    "simulation.integrator": (INDUSTRIAL, SHORT, MOVING),
    "traction.rolling_law": (INDUSTRIAL, SHORT, MOVING),
}
# Not fields: parts of what a value may be.
NO_FIELDS = ("model", "class", "stiffness")


def choices():
    """Of the shipped schema: {path: choices}."""
    found = {}

    def walk(part, path):
        if isinstance(part, dict):
            if "enum" in part and path:
                found.setdefault(path, set()).update(str(one) for one in part["enum"])
            for key, inner in part.items():
                if key == "properties":
                    for name, below in inner.items():
                        walk(below, f"{path}.{name}" if path else name)
                else:
                    walk(inner, path)
        elif isinstance(part, list):
            for inner in part:
                walk(inner, path)

    walk(json.loads((CASES / "case.schema.json").read_text()), "")
    return {path: sorted(names) for path, names in sorted(found.items()) if not path.startswith(("sets.", "stages."))}


def statuses(found):
    """Of points, or of the result itself."""
    points = found.get("points")
    return {one.get("status", "ok") for one in points} if points else {found.get("status", "ok")}


def runs(path, choice, case, settings, words, command=None):
    """Empty where the case runs with the choice, else why not."""
    sets = [word for setting in (*settings, f"{path}={choice}") for word in ("--set", setting)]
    if isinstance(case, str):
        case = Path(tempfile.gettempdir()) / f"every_choice_{os.getpid()}_{case}.yaml"
    command = [os.environ["ORBEARING"], command or ("mesh" if case.parent.name == "mesh_62_62" else "run"), str(case), "--json", *words, *sets]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
    if done.returncode != 0:
        return f"exit {done.returncode}: {done.stderr.strip()[-300:]}"
    found = json.loads(done.stdout)
    if statuses(found) != {"ok"}:
        return f"status {statuses(found)}"
    idle = [warning for warning in found.get("warnings", []) if f"{path}:" in warning and "no effect" in warning]
    return idle[0] if idle else ""


def first_that_runs(path, choice):
    stated = BESIDE.get((path, choice)) or BESIDE.get(path)
    reasons = []
    for where in [stated] if stated else [(case, (), ()) for case in ANYWHERE]:
        reason = runs(path, choice, *where)
        if not reason:
            return ""
        reasons.append(f"{where[0]}: {reason}")
    return "\n".join(reasons)


@unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
class EveryChoice(unittest.TestCase):
    def test_runs_somewhere(self):
        for name, text in WRITTEN.items():
            file = Path(tempfile.gettempdir()) / f"every_choice_{os.getpid()}_{name}.yaml"
            file.write_text(text)
            self.addCleanup(file.unlink)
        asked = [(path, choice) for path, names in choices().items() for choice in names if path not in NO_FIELDS]
        if not FULL:
            asked = asked[::4] + [one for one in asked if one[0] == "support.pin_ends"]
        with ThreadPoolExecutor(2) as pool:
            for (path, choice), reason in zip(asked, pool.map(lambda one: first_that_runs(*one), asked)):
                with self.subTest(path=path, choice=choice):
                    self.assertEqual(reason, "")


if __name__ == "__main__":
    unittest.main(verbosity=2)
