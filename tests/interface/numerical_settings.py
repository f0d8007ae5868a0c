#!/usr/bin/env python3
"""No printed number hangs on a numerical setting: half and twice the value of each change no result by more than its printed digits.

Settings are the inputs that the schema marks as numerical. What changes by more has a row in KNOWN with its bound and its reason: a
bound is that of the method, for all cases. Each case and template of the repository runs at rest with each setting that it uses
(`check --json`), a few short ones in motion. `tools/test --full` runs all pairs; otherwise a part is drawn within SECONDS_OF_A_PART.
"""

import collections
import concurrent.futures
import dataclasses
import functools
import json
import math
import os
import random
import re
import time
import unittest

from program import CASES, LEFT_TO_FULL, REDUCER, answer, run, settings

NOTHING = 1e-9  # in the unit of a key: round-off of what is zero
DIGITS = 6  # of a number in text (app/results/record_text.cpp)
SECONDS_OF_A_PART = 8.0
SEED = int(os.environ.get("SETTINGS_SEED", time.time_ns() % 100000))
# Runs of a case, by the analyses that `check` names.
AT_REST = {"--fidelity quasi-static": (), "run of a single bearing": (), "run of a bearing with scratches": ()}
# Short runs in motion: what `check` calls them, options, settings beside.
NU204 = CASES / "reducer_nu204" / "case.yaml"
MOVING = [(case, analysis, options, ()) for case in (REDUCER, NU204)
          for analysis, options in (("--fidelity dynamic", ("--fidelity", "dynamic")), ("--fidelity co-simulated", ("--fidelity", "co-simulated")),
                                    ("run --gears", ("--gears",)))]
MOVING.append((CASES / "deep_groove_motor" / "case.yaml", "run of a ball bearing in time", (), ("simulation.duration=0.6 s",)))
SCRATCHED_PLANET = "run of a set with a scratched planet bearing"
# Analyses whose settings are those of the runs above.
ELSEWHERE = {
    "--fidelity monolithic": "settings of --fidelity dynamic",
    "--fidelity dynamic of several sets": "settings of --fidelity dynamic",
    "crown": "loads of bearings at rest",
    "carrier": "loads of bearings at rest",
    "modes": "stiffness of bearings at rest",
    "modes --speed": "stiffness of bearings at rest",
    "stiffness of a planet bearing": "stiffness of bearings at rest",
    "stiffness of a single bearing": "stiffness of bearings at rest",
    "fmu --model bearing": "a model, no result",
    "fmu --model gearset": "a model, no result",
    "run --fidelity dynamic of a bearing with scratches": "settings of a ball bearing in time and of a bearing with scratches",
    SCRATCHED_PLANET: "impacts of rollers that differ by round-off part after half a millisecond (neutral_features.py): peaks are of one motion",
}


LIVES_OF_LAMINAE = r"(L10m?r|reference_life|a_ISO_r|life_table|verdicts|over_cage_positions)"
SIGNAL = r"signal\.(revolutions|settling_revolutions|length_error)"
MOTION = r"simulation\..*|numerics\.cage_positions|bearing\.laminae|traction\.(slices|rows)"


@dataclasses.dataclass(frozen=True)
class Known:
    """Results whose path `results` matches change by up to `bound` of themselves, plus `floor` in the unit of the key."""

    setting: str  # pattern of the whole path
    results: str  # pattern of the beginning of the path
    bound: float
    reason: str
    floor: float = 0.0
    moving: bool = False  # of runs in motion
    of_case: str = ""  # pattern in the text of the cases that it is of


KNOWN = (
    # Gears alone.
    Known("numerics.cage_positions", r"/(planet_acceleration_m_per_s2|bearing_force_N|mesh_force_N)/", 0.05,
          "natural frequencies follow the stiffness of the bearings, which converges as 1/N, as in the row of stiffness below"),
    Known(r"gearset.dynamics.observed_periods", r"/planet_acceleration_m_per_s2/[xy]_of_planets/\d+/mean", 0.0,
          "means of accelerations are zero but for the ends of the record: the change of speed over its length", floor=0.2),
    # At rest.
    Known("numerics.cage_positions", r"/stiffness/", 0.05,
          "a roller that comes into contact adds its stiffness at once: the mean over N positions converges as 1/N"),
    Known("numerics.cage_positions", r"/roller_loads/", math.inf, "the list of the positions themselves"),
    Known("numerics.cage_positions", r"/points/\d+/drag_slip", 0.0, "a cage that its land holds stands where loads by position put it", floor=0.005),
    Known("numerics.cage_positions", r"/points/\d+/rim_ovality_um", 5e-3, "a difference of two deflections"),
    Known("numerics.cage_positions", r"/", 2e-3, "rollers enter and leave the load zone within a pitch: means and maxima over 16 positions converge as 1/N^2"),
    Known("bearing.laminae", r"/lamina_loads_N/|/roller_loads/", math.inf, "of each lamina, whose number it is"),
    Known("bearing.laminae", f".*{LIVES_OF_LAMINAE}", 1.0, "the riser of the standard, where a case states it, is a formula with the number of laminae",
          of_case=r"stress_riser: standard"),
    Known("bearing.laminae", f".*({LIVES_OF_LAMINAE}|life_h|life_Mrev)", 1e-2,
          "30 laminae resolve profile and tilt: lives of straight rollers within 0.5 %, of logarithmic profiles, which are steep at their ends, within 0.6 %"),
    Known("bearing.laminae", r"/", 2e-2, "stiffness within 2 % (NU 311 under a moment)"),
    # Vibration of a scratched bearing.
    Known("signal.sampling_rate", r"/", math.inf, "the band of the instrument: levels, bands and peaks are those of a signal up to a third of its rate"),
    Known(SIGNAL, r"/resolution_Hz", math.inf, "the speed over the number of revolutions"),
    Known(SIGNAL, r"/(envelope_peaks/\d+/frequency_Hz|defect_peak_Hz)", 1e-3, "lines lie within the resolution, which is printed with them"),
    Known(SIGNAL, r"/(band_Hz|band_kurtosis)", math.inf, "the band of the largest kurtosis is chosen among bands of equal merit"),
    Known(SIGNAL, r"/acceleration/", 5e-2, "impacts are counted in a finite record"),
    Known(SIGNAL, r"/", 5e-3, "amplitudes of lines that fall between two of the spectrum"),
    # In motion: docs/motion_time.md has the scatter of means over revolutions, and what steps change.
    Known(MOTION, r"/points/\d+/shortest_life_planet", math.inf, "planets that carry alike have lives that differ by their scatter alone", moving=True),
    Known("numerics.cage_positions", r"/points/\d+/resonance_frequency_change_Hz", math.inf,
          "the printed error of a natural frequency: a roller that leaves its load at one of the positions changes it by 1/N", moving=True),
    Known(r"simulation.length_error", r"/points/\d+/roller_slip", 0.0, "idle rollers are caught a little later with longer steps", floor=0.012, moving=True),
    Known(f"traction.(rows|slices)|{MOTION}", r"/(heat_error_W|cage_slip_error)", math.inf,
          "the printed error of a mean, estimated from ten parts of one motion", moving=True),
    Known("simulation.settling_band", r"/slip_settling_s", math.inf, "the time after which the slip stays in the band", moving=True),
    Known(f"traction.(rows|slices)|{MOTION}", r"/cage_impact_max_N", math.inf, "the largest impact of one motion, whose impacts part by round-off",
          moving=True),
    Known(f"traction.(rows|slices)|{MOTION}", r"/(inner|outer)/contact_angle_deg", 0.0, "zero but for the play of the balls across the grooves, under a "
          "radial load", floor=0.01, moving=True),
    Known(MOTION, r"/points/\d+/(one_way_|interface_|steady)", math.inf, "how gears and bearings were brought together, not a result of theirs", moving=True),
    Known(MOTION, r"/points/\d+/(cage|roller|orbit)_slip", 0.0, "slip scatters by 0.2 % of the speed from revolution to revolution", floor=0.005, moving=True),
    Known(MOTION, r"/points/\d+/(power_loss|friction_moment|vibration_power)", 0.15, "losses by cause scatter with impacts in pockets", floor=0.5, moving=True),
    Known(MOTION, r"/", 0.03, "lives scatter by up to 0.85 % between revolutions, and steps change them by up to 2 %", moving=True),
    Known("gearset.dynamics..*", r"/", 1e-3, "means over mesh periods of a steady vibration"),
)


@dataclasses.dataclass(frozen=True)
class Pair:
    case: object
    options: tuple
    setting: str
    value: str
    common: tuple = ()

    @property
    def values(self):
        return (*self.common, f"{self.setting}={self.value}")

    def __str__(self):
        return f"{self.case.relative_to(CASES)} {' '.join(self.options)} {self.setting}={self.value}"


def numerical_inputs():
    """Schemas of the inputs that are numerical, by their paths."""
    schema = json.loads((CASES / "case.schema.json").read_text(encoding="utf-8"))
    found = {}

    def walk(block, before):
        for name, one in block.get("properties", {}).items():
            path = f"{before}.{name}" if before else name
            if one.get("numerical"):
                found[path] = one
            if path not in ("sweep", "uncertain", "assumed"):
                walk(one, path)

    for described in schema["$defs"].values():
        walk(described, "")
    return found


NUMERICAL = numerical_inputs()


def all_cases():
    return sorted([*CASES.glob("*/case.yaml"), *CASES.glob("validation/*/case.yaml"), *CASES.glob("templates/*.yaml")])


# Below these a setting is not of the method, by its source.
LEAST = {"bearing.laminae": 30}  # ISO/TS 16281


def within_range(value, schema, least):
    return max(least, schema.get("minimum", -math.inf)) <= value <= schema.get("maximum", math.inf)


def other_values(path, given):
    """Half and twice `given`, as written; of a choice the others."""
    schema = NUMERICAL[path]
    if "enum" in schema:
        return [choice for choice in schema["enum"] if choice != given]
    number, unit = re.fullmatch(r"\s*([-+0-9.eE]+)\s*(.*)", given).groups()
    values = []
    for factor in (0.5, 2.0):
        value = factor * float(number)
        if schema.get("type") == "integer":
            value = int(value)
        if value != float(number) and (unit or within_range(value, schema, LEAST.get(path, -math.inf))):
            values.append(f"{value!r} {unit}".strip())
    return values


def without_set(path):
    return path.split(".", 2)[2] if path.startswith("sets.") else path


@functools.cache
def used_settings(case):
    """(path, given) by analysis, of all numerical inputs."""
    checked = run("check", case, "--json")
    if checked.returncode != 0:
        return {}
    used = collections.defaultdict(list)
    for row in json.loads(checked.stdout)["inputs"]:
        if without_set(row["path"]) in NUMERICAL and row["given"]:
            for analysis in row["used_by"]:
                used[analysis].append((row["path"], row["given"]))
    return used


def pairs_of(case, runs, common=()):
    used = used_settings(case)
    if SCRATCHED_PLANET in used:  # which is what `run` gives of it
        return []
    return [Pair(case, options, path, value, common) for analysis, options in runs.items() for path, given in used.get(analysis, ())
            for value in other_values(without_set(path), given)]


def numbers(value, path=""):
    """Results by path, those of lists by their index."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key not in ("assumptions", "units", "versions", "options", "steps", "run"):
                yield from numbers(inner, f"{path}/{key}")
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            yield from numbers(inner, f"{path}/{i}")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path, float(value)


def digits_of(value):
    """Half a unit of the last printed digit, twice: both numbers are rounded."""
    return 10.0 ** (math.floor(math.log10(abs(value))) - DIGITS + 1) if value else 0.0


def allowed(pair, path, value):
    """By how much a result may change, and the row that says so, if any."""
    setting, moving = pair.setting, "--fidelity" in pair.options or bool(pair.common)
    for known in KNOWN:
        if (known.moving == moving and re.fullmatch(known.setting, without_set(setting)) and re.match(known.results, path)
                and re.search(known.of_case, pair.case.read_text(encoding="utf-8"))):
            return math.inf if known.bound == math.inf else known.bound * abs(value) + known.floor, known
    return digits_of(value), None


def size_of(values, path):
    """The largest number of the same list or sum, beside which the others are zero or not."""
    if path.startswith("/heat_W/"):
        return abs(values["/heat_W/total"])
    return max((abs(value) for other, value in values.items() if re.sub(r"/\d+", "/", other) == re.sub(r"/\d+", "/", path)), default=0.0)


PUSHED = "co-simulation: the exchange"  # how the warning of lives that are too short by the exchange begins


class Runs:
    """Results of runs, each computed once. `pushed` has the residuals of those whose exchange the program warns of."""

    def __init__(self):
        self.known, self.pushed = {}, {}

    def of(self, case, options, values=()):
        key = (case, options, values)
        if key not in self.known:
            done = run("run", case, "--json", *options, *settings(values))
            answered = json.loads(done.stdout) if done.returncode == 0 else None
            self.known[key] = dict(numbers(answered)) if answered else {"": math.nan}
            if answered and any(warning.startswith(PUSHED) for warning in answered.get("warnings", ())):
                self.pushed[key] = max(point["interface_energy_residual"] for point in answered["points"])
        return self.known[key]

    def is_warned_of(self, pair):
        """Whether the setting makes an exchange worse that the program then warns of."""
        residual, base = (self.pushed.get((pair.case, pair.options, values)) for values in (pair.values, pair.common))
        return residual is not None and (base is None or residual > 1.3 * base)

    def changes(self, pair):
        """(path, change, allowed, known) of all results of a pair that change by more than a printed digit."""
        base, other = self.of(pair.case, pair.options, pair.common), self.of(pair.case, pair.options, pair.values)
        if self.is_warned_of(pair):
            return []
        found = []
        for path, value in base.items():
            if path not in other:
                continue
            largest = size_of(base, path) if re.search(r"/\d+|^/heat_W/", path) else abs(value)
            change = abs(other[path] - value)
            if not change <= max(digits_of(largest), NOTHING):
                found.append((path, change, *allowed(pair, path, largest), largest))
        return found


    def faults(self, pair):
        """What changes by more than it may, worst first."""
        found = [(change / may if may else math.inf, path, change, may) for path, change, may, _, _ in self.changes(pair) if not change <= may]
        return [f"{pair}: {path} changes by {change:.3g}; at most {may:.3g}" for _, path, change, may in sorted(found, reverse=True)]


class Settings(unittest.TestCase):
    """Half and twice each setting, in every case and template that uses it."""

    @classmethod
    def setUpClass(cls):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(used_settings, all_cases()))

    def check(self, pairs, seconds=math.inf):
        runs, end = Runs(), time.monotonic() + seconds

        def faults_of(pair):
            return runs.faults(pair)[:3] if time.monotonic() < end else None

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = [faults for faults in pool.map(faults_of, pairs) if faults is not None]
        faults = [fault for some in found for fault in some]
        left_out = sum(runs.is_warned_of(pair) for pair in pairs)
        print(f"{len(found)} of {len(pairs)} pairs of a case and a value of a setting, {len(faults)} faults; {left_out} whose exchange is warned of")
        self.assertFalse(faults, "\n".join(faults))

    def test_at_rest(self):
        pairs = [pair for case in all_cases() for pair in pairs_of(case, AT_REST)]
        if LEFT_TO_FULL:
            print(f"SETTINGS_SEED={SEED}")
            random.Random(SEED).shuffle(pairs)
        self.check(pairs, SECONDS_OF_A_PART if LEFT_TO_FULL else math.inf)

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_in_motion(self):
        self.check([pair for case, analysis, options, common in MOVING for pair in pairs_of(case, {analysis: options}, common)])

    def test_an_exchange_that_pushes_bearings_is_warned_of(self):
        """Forces that are held over a window make the life of the reducer a tenth of what it is."""
        lives = {}
        for order in (0, 1):
            done = run("run", REDUCER, "--json", "--fidelity", "co-simulated", *settings(
                (f"simulation.exchange.extrapolation={order}", "input.speed=9000 rpm", "simulation.most_revolutions=3",
                 "simulation.observed_revolutions=1")))
            answer_of = json.loads(done.stdout)
            warned = [warning for warning in answer_of["warnings"] if warning.startswith(PUSHED)]
            lives[order] = answer_of["points"][0]["life_h"]
            self.assertEqual(len(warned), 1 - order, answer_of["warnings"])
        self.assertLess(lives[0], 0.2 * lives[1])

    def test_a_coarse_setting_is_found(self):
        """One position of the cage instead of sixteen."""
        coarse = Pair(CASES / "templates" / "industrial.yaml", (), "numerics.cage_positions", "1")
        self.assertTrue(any("/L10rh" in fault for fault in Runs().faults(coarse)))

    def test_each_setting_is_used_by_a_case(self):
        """None of the marked inputs escapes because no case uses it."""
        used = {without_set(path) for case in all_cases() for rows in used_settings(case).values() for path, _ in rows}
        self.assertTrue(NUMERICAL, "the schema marks no input as numerical")
        self.assertEqual(set(NUMERICAL) - used, set())
        analyses = {analysis for case in all_cases() for analysis in used_settings(case)}
        self.assertEqual(analyses - {*AT_REST, *ELSEWHERE, *(row[1] for row in MOVING)}, set())


if __name__ == "__main__":
    unittest.main()
