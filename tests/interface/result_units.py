#!/usr/bin/env python3
"""The unit that the Python package gives each number of the program's JSON.

Three ways: a table by hand of what the commands print, every key that the program's sources write, read by a grammar of its own, and results that
scale with their inputs.
Needs the source folder in ORBEARING_SOURCE_DIR. Exit code 77 (skipped) where numpy is missing.
"""

import json
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

try:
    import numpy  # noqa: F401
except ImportError:
    print("skipped: numpy is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = Path(os.environ.get("ORBEARING_SOURCE_DIR", Path(__file__).resolve().parents[2])).resolve()
sys.path.insert(0, str(ROOT / "python"))

from orbearing.units import as_udunits, unit_in, units_of  # noqa: E402

BY_HAND = {
    # sweep, run
    "input_speed_rpm": "rpm", "life_h": "h", "system_life_h": "h", "life_Mrev": "megarevolution", "inner_life_Mrev": "megarevolution", "planet_load_N": "N",
    "overturning_moment_N_m": "N m", "film_inner_um": "um", "contact_pressure_max_MPa": "MPa", "cage_slip": "1", "power_loss_W": "W", "steady": "1",
    "bearing_tilt_x_mrad": "mrad", "interface_window_us": "us", "interface_energy_residual": "1", "one_way_stiffness_xx_N_per_m": "N m-1",
    "damping_xy_N_s_per_m": "N s m-1", "sets.first.life_h": "h", "sets.first.L10mrh": "h", "damage_share": "1", "share": "1", "torque_N_m": "N m",
    # lives of the standards and what they rest on
    "L10h": "h", "L10rh": "h", "L10mh": "h", "L10mrh": "h", "system_L10mh": "h", "L10_Mrev": "megarevolution", "L10r_Mrev": "megarevolution",
    "L10m_Mrev": "megarevolution", "L10mr_Mrev": "megarevolution", "inner_L10mr_Mrev": "megarevolution", "C_N": "N", "C0_N": "N", "C_u_N": "N", "P_N": "N",
    "P0_N": "N", "C_over_P": "1", "S0": "1", "static_safety": "1", "kappa": "1", "e_C": "1", "a_1": "1", "a_ISO": "1", "a_ISO_r": "1",
    "equivalent_load_N": "N", "damage_share_L10mh": "1", "damage_share_L10mrh": "1",
    # ball bearings in time, scratches, films
    "friction_torque_N_mm": "N mm", "cage_speed_rpm": "rpm", "slip_settling_s": "s", "cage_impact_max_N": "N", "contact_angle_deg": "degree", "central_film_um": "um",
    "shaft_Hz": "Hz", "rms_m_s2": "m s-2", "order": "1", "rolling_speed_m_s": "m s-1", "spin_rad_s": "rad s-1", "curvature_sum_per_mm": "mm-1",
    "elliptic_K": "1", "elliptic_E": "1",
    # modes, meshes, stiffness
    "frequency_Hz": "Hz", "growth_per_s": "s-1", "multiplicity": "1", "mean_N_per_m": "N m-1", "c_gamma_N_per_mm_um": "N mm-1 um-1", "harmonics_um": "um",
    "phase": "1", "speed_rpm": "rpm", "x_N": "N", "moment_N_m": "N m", "mean_percent": "percent", "accelerance_max_per_kg": "kg-1",
    "acceleration_m_per_s2": "m s-2", "teeth_m_per_N": "m N-1", "mass_kg": "kg", "inertia_x_kg_m2": "kg m2", "path_ms": "ms", "power_kW": "kW",
    "places_rad": "rad", "tilt_mrad": "mrad", "drop_um": "um", "x_mm": "mm", "edge_ratio": "1", "half_space_life_h": "h", "time_s": "s",
}
# Words of the end of a key that are units, as udunits writes them.
WORDS = {"N": "N", "kN": "kN", "m": "m", "mm": "mm", "um": "um", "MPa": "MPa", "W": "W", "kW": "kW", "h": "h", "s": "s", "ms": "ms", "us": "us", "K": "K",
         "rpm": "rpm", "Hz": "Hz", "Mrev": "megarevolution", "deg": "degree", "rad": "rad", "mrad": "mrad", "kg": "kg", "percent": "percent",
         "s2": "s2", "m2": "m2"}
VELOCITIES = {"m_s": "m s-1", "m_s2": "m s-2", "rad_s": "rad s-1"}  # written without a "per"
NOT_UNITS = {"elliptic_K", "bins_W_rad_per_s_share"}


def by_grammar(key):
    """N_per_mm_um -> N mm-1 um-1: what stands after "per" divides."""
    words = key.split("_")
    count = 0
    while count < len(words) and (words[-1 - count] in WORDS or words[-1 - count] == "per"):
        count += 1
    units = words[len(words) - count:]
    if units[:1] == ["min"]:
        units = units[1:]
    joined = "_".join(units)
    if joined in VELOCITIES:
        return VELOCITIES[joined]
    parts, divides = [], False
    for word in units:
        if word == "per":
            divides = True
        else:
            power = re.fullmatch(r"(\D+)(\d?)", WORDS[word])
            parts.append(f"{power[1]}-{power[2] or 1}" if divides else WORDS[word])
    return " ".join(parts) or "1"


# Powers of length, force and time in units of inputs and results; of all other words: none.
POWERS = {"m": (1, 0, 0), "N": (0, 1, 0), "Pa": (-2, 1, 0), "W": (1, 1, -1), "kg": (-1, 1, 2), "s": (0, 0, 1), "h": (0, 0, 1), "Hz": (0, 0, -1),
          "rpm": (0, 0, -1)}
PREFIXED = {"mm": "m", "um": "m", "kN": "N", "MPa": "Pa", "GPa": "Pa", "kW": "W", "ms": "s", "us": "s"}
ANY = (1.1, 1.3, 0.8)
KEEPS_GRAVITY = (1.44, 1.3, 1.2)  # [m] over [s2] stays
# Standards hold numbers in N, mm and steel; catalogues do not scale. A curve has shares of the pitch beside its values.
EMPIRICAL = re.compile(r"L10|life|Mrev|rating|capacity|C0?_N$|Cu_N|C_over_P|P_over_C|S0$|static_safety|c_th|curve")


def scale_of(unit, scales):
    """What a number with that unit is multiplied by where lengths, forces and times are."""
    above, _, below = unit.partition("/")
    factor = 1.0
    for words, sign in ((above, 1), (below.strip("()"), -1)):
        for word in filter(None, re.split(r"[. ]", words)):
            name, power = re.fullmatch(r"([A-Za-z]+|1)(-?\d*)", word).groups()
            for scale, exponent in zip(scales, POWERS.get(PREFIXED.get(name, name), (0, 0, 0))):
                factor *= scale ** (sign * exponent * int(power or 1))
    return factor


def numbers_of(found, path=()):
    """Numbers of a result, each with its path."""
    if isinstance(found, (dict, list)):
        for key, value in found.items() if isinstance(found, dict) else enumerate(found):
            if key not in ("units", "life_table"):  # which repeats lives
                yield from numbers_of(value, (*path, key))
    elif isinstance(found, (int, float)) and not isinstance(found, bool):
        yield path, found


def stated_unit(units, path):
    """That of the deepest key with one, by itself or with those above; none where no key has one."""
    keys = [key for key in path if isinstance(key, str)]
    if "force_by_tilt" in units and keys[-1] == "stiffness":  # three displacements, two tilts
        return units[("force" if path[-2] < 3 else "moment") + ("_by_place" if path[-1] < 3 else "_by_tilt")]
    for end in range(len(keys), 0, -1):
        for name in ("/".join(keys[:end]), keys[end - 1]):
            if isinstance(units.get(name), str):
                return units[name]
    return None


class Scaled(unittest.TestCase):
    """Computed with units of length, force and time scaled, each result scales as its unit says."""

    CASES = ((ANY, "modes", "lin_parker_1999"), (ANY, "mesh", "mesh_62_62"), (ANY, "mesh", "wind_stage_750kW"), (ANY, "run", "jones_218"),
             (ANY, "run", "duplex_7020"), (ANY, "stiffness", "jones_218"), (ANY, "run", "reducer_150kW"),
             (KEEPS_GRAVITY, "run", "scratch_defect", "signal.revolutions=3"))

    def answer(self, command, case, settings):
        words = [word for setting in settings for word in ("--set", setting)]
        done = subprocess.run([os.environ["ORBEARING"], command, ROOT / "cases" / case / "case.yaml", *words, "--json"],
                              capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def scaled(self, case, settings, scales):
        """The inputs of a case as settings, each multiplied as its unit says."""
        for row in self.answer("check", case, settings)["inputs"]:
            factor, value, unit = scale_of(row["unit"], scales), row["value"], row["unit"]
            if factor != 1.0 and isinstance(value, list):
                yield f"{row['path']}=[{', '.join(f'{one * factor!r} {unit}' for one in value)}]"
            elif factor != 1.0:
                yield f"{row['path']}={value * factor!r} {unit}"

    def test_scales_as_its_unit_says(self):
        if "ORBEARING" not in os.environ:
            self.skipTest("ORBEARING is not set")
        for scales, command, case, *settings in self.CASES:
            with self.subTest(f"{command} {case}"):
                here = self.answer(command, case, settings)
                there = dict(numbers_of(self.answer(command, case, [*settings, *self.scaled(case, settings, scales)])))
                self.assertGreater(self.compare(here, there, scales), 10)

    def compare(self, here, there, scales):
        """How many numbers were compared."""
        stated = [(path, stated_unit(here["units"], path), value) for path, value in numbers_of(here)]
        stated = [(path, unit, value) for path, unit, value in stated
                  if unit and "^" not in unit and "," not in unit and not any(EMPIRICAL.search(str(key)) for key in path)]
        largest = {}
        for _, unit, value in stated:
            largest[unit] = max(largest.get(unit, 0.0), abs(value))
        for path, unit, value in stated:
            expected = value * scale_of(unit, scales)
            # 1e-5: searches for fits; the others: zeros that are round-off.
            self.assertAlmostEqual(there[path], expected, delta=max(1e-5 * abs(expected), 1e-9 * largest[unit], 1e-12), msg=f"{path} [{unit}]")
        return len(stated)


class Units(unittest.TestCase):
    def test_by_hand(self):
        self.assertEqual({key: units_of(key) for key in BY_HAND}, BY_HAND)

    def test_each_end_of_a_name_is_a_unit_of_its_own(self):
        """load_kN is in kN and speed_m_s in m/s; without the line before it an end states no unit."""
        for end, unit in (("N", "N"), ("kN", "kN"), ("W", "W"), ("kW", "kW"), ("N_m", "N m"), ("N_mm", "N mm"), ("m", "m"), ("mm", "mm"), ("um", "um"),
                          ("m_s", "m s-1"), ("m_s2", "m s-2"), ("s", "s"), ("ms", "ms"), ("us", "us"), ("h", "h"), ("K", "K"), ("rad", "rad"),
                          ("mrad", "mrad"), ("rad_s", "rad s-1"), ("deg", "degree"), ("kg", "kg"), ("rpm", "rpm"), ("Hz", "Hz"), ("MPa", "MPa"),
                          ("Mrev", "megarevolution"), ("percent", "percent"), ("N_per_m", "N m-1"), ("m_per_N", "m N-1")):
            self.assertEqual((units_of(f"x_{end}"), units_of(f"x{end}") == unit), (unit, False), end)

    def test_of_every_key_that_the_program_writes(self):
        """Ends of names that are put together, as "_Mrev", count too."""
        sources = [path for folder in ("app/study", "app/results", "app/commands", "coupling/analysis", "coupling/diagnosis")
                   for path in sorted((ROOT / folder).rglob("*.[ch]pp"))]
        keys = {key for path in sources for key in re.findall(r'"([A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)+|_[A-Za-z]+)"', path.read_text(encoding="utf-8"))}
        wanted = {key: by_grammar(key) for key in sorted(keys - NOT_UNITS) if by_grammar(key) != "1"}
        self.assertGreater(len(wanted), 150)
        self.assertEqual({key: units_of(key) for key in wanted}, wanted)

    def test_of_results_are_those_that_they_state(self):
        """What a result states stands before the end of a name, and agrees with it where the end is a unit."""
        program = os.environ.get("ORBEARING")
        if not program:
            self.skipTest("ORBEARING is not set")
        for command, case in (("run", "harris_209"), ("mesh", "mesh_62_62"), ("modes", "lin_parker_1999"), ("run", "duplex_7020")):
            done = subprocess.run([program, command, ROOT / "cases" / case / "case.yaml", "--json"], capture_output=True, text=True, check=True, timeout=300)
            units = json.loads(done.stdout)["units"]
            self.assertGreater(len(units), 2)
            for name, unit in units.items():
                self.assertEqual(unit_in(units, name), as_udunits(unit))
                self.assertIn(units_of(name.split("/")[-1]), (as_udunits(unit), "1"), f"{case}: {name}")

    def test_as_udunits_writes_them(self):
        stated = {"N.m/rad": "N m rad-1", "m/s2": "m s-2", "N/(mm.um)": "N mm-1 um-1", "Mrev": "megarevolution", "deg": "degree", "1": "1", "mm-1": "mm-1"}
        self.assertEqual({unit: as_udunits(unit) for unit in stated}, stated)


if __name__ == "__main__":
    unittest.main()
