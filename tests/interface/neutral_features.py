#!/usr/bin/env python3
"""A metamorphic test of each pair of features that works.

A feature of neutral strength beside another feature gives what the other one gives alone. Pairs and features are those of
`combinations.py`; here each feature has its neutral strength, and the tolerance that follows from it. Where planets carry
unlike loads, each planet also takes the pin of its neighbour: the planets change their numbers, and nothing else changes.
"""

import concurrent.futures
import dataclasses
import json
import math
import os
import pathlib
import tempfile
import unittest

from combinations import ANGLES, BINS, DEFECT, FEATURES, PAIRS, SEVERAL
from program import LEFT_TO_FULL, REDUCER, SETS, run, settings

FEATURE = {feature.name: feature for feature in FEATURES}
ROUND_OFF = 1e-9  # searches that take another way to the same end
SEARCHED = 1e-6  # the same, of planets in balance with their gears
# Forces along the axis are proportional to a small helix angle: what is neutral there is zero.
ALONG_AXIS = ("axial_mesh_force_N", "overturning_moment_N_m", "sun_thrust_N")
# ISO/TS 16281 rates laminae by their loads, and whole contacts by ISO 281.
BY_LAMINAE = ("L10rh", "L10r_Mrev", "system_L10rh", "shortest_L10rh")
# A vibration of 0.3 ms, in which a roller meets the scratch: impacts that differ by round-off part after half a millisecond.
SHORT = ("signal.sampling_rate=400 kHz", "signal.carrier_revolutions=0.01", "signal.carrier_settling=0", "defect.angle=4 deg")
SCRATCH = ("defect.race=outer", "defect.width=0.3 mm")
IN_MOTION = ("/carrier_frame/rms", "/housing/rms", "/contact_load_max_N", "/turned/cage_Hz", "/turned/planet_Hz", "/turned/carrier_Hz", "/turned/mesh_Hz")
MOVED = 1e-3  # steps of the motion are those of its tolerance
# Results of a feature alone, or the name of one of several equal planets.
OWN = ("largest_bearing_tilt_mrad", "largest_bearing_share", "shortest_life_planet", "rim_ovality_um")


@dataclasses.dataclass(frozen=True)
class Neutral:
    """`values` beside `common` give what `common` gives alone, within `tolerance`."""

    values: tuple
    tolerance: float
    common: tuple = ()
    in_set: bool = False  # as the single one of several sets
    not_beside: tuple = ()  # features beside which these values are not neutral, by physics
    left_out: tuple = ()  # keys
    moved: float = MOVED  # tolerance of a vibration


NEUTRAL = {
    # Thick, and as stiff as a case may state: the rim adds some 1e-3 to what meshes and rollers deflect, and five times that to lives.
    # At 500 rpm a vibration takes 4 ms.
    "elastic rim": Neutral(("gearset.planet_rim=elastic",), 2e-2, moved=5e-2, left_out=("static_safety",),
                           common=("gearset.module=9 mm", "input.speed=500 rpm", "input.power=12.5 kW", "material.youngs_modulus=1000 GPa")),
    # The moment of the axial force is 2e-6 of force times radius, and lives change by five times what it makes.
    # In motion the jumps of the mesh stiffness become ramps.
    "helix": Neutral(("gearset.helix_angle=0.0001 deg",), 2e-5, moved=5e-3, left_out=ALONG_AXIS),
    # A single bearing in the middle of the face tilts only under the moment of axial forces.
    "computed tilt": Neutral(("bearing.tilt_state=computed",), SEARCHED, common=("bearing.laminae=10", "bearing.per_planet=1"), not_beside=("helix",)),
    "pin errors": Neutral(("gearset.dynamics.pin_error.tangential=[1e-6 um, 0 um, 0 um, 0 um]",), SEARCHED),
    "unequal angles": Neutral(("gearset.planet_angles=[0 deg, 90 deg, 180 deg, 270 deg]",), ROUND_OFF),
    SEVERAL: Neutral((), ROUND_OFF, in_set=True),
    "spectrum in rows": Neutral(("spectrum=[{power: 150 kW, speed: 6000 rpm, share: 1}]",), ROUND_OFF),
    "spectrum from a file": Neutral(("spectrum={file: one.csv}",), ROUND_OFF),
    # Straight laminae at no tilt are the whole contact, whose law they share out.
    "laminae": Neutral(("bearing.laminae=10", "bearing.profile.kind=circular", "bearing.profile.drop=0 um"), 1e-5, left_out=BY_LAMINAE),
    # Not modelled at rest, but for the mean stiffness where that counts: there loaded teeth have no neutral strength.
    "loaded teeth": Neutral(("gearset.tooth_contact=loaded",), 0.0, not_beside=("computed tilt", "pin errors", "unequal angles", DEFECT)),
    DEFECT: Neutral((*SCRATCH, "defect.depth=1e-9 mm"), 0.0, common=("defect.race=none",)),
}
ONE_BIN = f"torque_N_m,speed_rpm,share\n{150e3 / (6000 * math.pi / 30)!r},6000,1\n"
OUTSIDE = ("gearset", "bearing")  # blocks of a set


def case_of_one_set(folder):
    """The reducer as the only one of several sets."""
    blocks, name = {}, ""
    for line in REDUCER.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith((" ", "#")):
            name = line.split(":")[0]
        blocks.setdefault(name, []).append(line)
    for name in ("sweep", "assumed"):
        blocks.pop(name)
    blocks["input"] = [line for line in blocks["input"] if "member" not in line]
    blocks["gearset"] = [line for line in blocks["gearset"] if "fixed" not in line]
    lines = [line for name, block in blocks.items() if name not in OUTSIDE for line in block]
    lines += ["shafts:", "  input: [motor, only.sun]", "  output: [only.carrier, load]", "  housing: [ground, only.ring]", "sets:", "  only:"]
    lines += ["    " + line for name in OUTSIDE for line in blocks[name]]
    case = pathlib.Path(folder) / "only.yaml"
    case.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return case


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def flat(value, path=""):
    for key, inner in value.items() if isinstance(value, dict) else ():
        yield from flat(inner, f"{path}/{key}")
    if is_number(value):
        yield path, float(value)


def own_numbers(result):
    """Of a point, with the lives of its spectrum of one bin in their place; of a vibration, levels and turns of the bodies."""
    if "points" not in result:
        return {key: value for key, value in flat(result) if key in IN_MOTION}
    point = dict(result["points"][0])
    point.update({key: value for key, value in result.get("spectrum", {}).items() if key in point})
    return {key: float(value) for key, value in point.items() if is_number(value)}


def with_last(values):
    """Of several values of one path the last one."""
    return tuple({value.split("=")[0]: value for value in values}.values())


class Runs:
    """Each run once."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        for name, text in (("one.csv", ONE_BIN), ("bins.csv", BINS)):
            (self.folder / name).write_text(text, encoding="utf-8")
        self.only = case_of_one_set(folder)
        self.known = {}

    def of(self, case, values):
        key = (case, *values)
        if key not in self.known:
            done = run("run", case, "--json", *settings(values))
            assert done.returncode == 0, (key, done.stderr)
            self.known[key] = own_numbers(json.loads(done.stdout))
        return self.known[key]

    def set_of(self, case):
        """What paths of a set begin with, and its name."""
        return {self.only: ("sets.only.", "only"), SETS: ("sets.reduction.", "reduction")}.get(case, ("", ""))

    def both_of(self, name, other):
        """What `other` gives with the feature of that name at its neutral strength, and alone."""
        neutral, beside = NEUTRAL[name], FEATURE[other]
        case = SETS if other == SEVERAL else REDUCER
        shown = [self.in_case(case, (*beside.values, *beside.shared, *neutral.common), DEFECT in (name, other))]
        shown.append(self.in_case(self.only if neutral.in_set else case,
                                  (*beside.values, *beside.shared, *neutral.common, *neutral.values), DEFECT in (name, other)))
        return shown[1], shown[0]

    def in_case(self, case, values, scratched):
        prefix, name = self.set_of(case)
        own = [(prefix if value.startswith(("gearset.", "bearing.")) else "") + value for value in with_last(values)]
        if scratched:
            own += [*SHORT, *((f"defect.set={name}",) if name else ())]
        return self.of(case, own)


def differences(first, second, neutral):
    """What differs by more than is allowed."""
    found = {}
    for key in sorted(first.keys() & second.keys()):
        tolerance = neutral.moved if key in IN_MOTION else neutral.tolerance
        allowed = tolerance * max(abs(first[key]), abs(second[key]))
        if key.rpartition(".")[2] not in (*OWN, *neutral.left_out) and abs(first[key] - second[key]) > allowed:
            found[key] = (first[key], second[key])
    return found


# Every planet takes the pin of the one before it: the angles of pins, and their errors.
NEXT_ANGLES = [angle - ANGLES[3] for angle in (ANGLES[3], *(360.0 + angle for angle in ANGLES[:3]))]
NEXT = {"pin errors": "gearset.dynamics.pin_error.tangential=[0 um, 5 um, 0 um, -2 um]",
        "unequal angles": f"gearset.planet_angles=[{', '.join(f'{angle:.9f} deg' for angle in NEXT_ANGLES)}]"}


def names_of(pair):
    return " beside ".join(feature.name for feature in pair)


class NeutralFeatures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.addClassCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        cls.runs = Runs(folder.name)

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_a_feature_of_neutral_strength_leaves_the_other_as_it_is(self):
        tried = [(name.name, other.name) for pair in PAIRS for name, other in (pair, pair[::-1]) if other.name not in NEUTRAL[name.name].not_beside]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = [pool.submit(self.runs.both_of, *one) for one in tried]
        for (name, other), both in zip(tried, found):
            with self.subTest(feature=name, beside=other):
                self.assertEqual(differences(*both.result(), NEUTRAL[name]), {})

    def test_a_scratch_changes_a_short_vibration_by_more_than_is_allowed(self):
        sound, deep = (self.runs.in_case(REDUCER, values, True) for values in (("defect.race=none",), (*SCRATCH, "defect.depth=0.02 mm")))
        for key in ("/carrier_frame/rms", "/contact_load_max_N"):
            self.assertGreater(deep[key], (1.0 + 10.0 * MOVED) * sound[key])

    def test_each_pair_has_a_relation(self):
        for one, other in PAIRS:
            with self.subTest(feature=one.name, beside=other.name):
                self.assertTrue(other.name not in NEUTRAL[one.name].not_beside or one.name not in NEUTRAL[other.name].not_beside)

    def test_planets_change_their_numbers_and_nothing_else(self):
        for pair in PAIRS:
            if DEFECT in (pair[0].name, pair[1].name) or not any(feature.name in NEXT for feature in pair):
                continue
            with self.subTest(pair=names_of(pair)):
                case = SETS if any(feature.name == SEVERAL for feature in pair) else REDUCER
                values = [value for feature in pair for value in (*feature.values, *feature.shared)]
                uneven = [NEXT[feature.name] for feature in pair if feature.name in NEXT]
                here, there = self.runs.in_case(case, values, False), self.runs.in_case(case, (*values, *uneven), False)
                self.assertEqual(differences(here, there, Neutral((), SEARCHED)), {})
                if "shortest_life_planet" in here:
                    self.assertEqual(there["shortest_life_planet"], here["shortest_life_planet"] % 4 + 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
