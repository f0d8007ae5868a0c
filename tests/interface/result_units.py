#!/usr/bin/env python3
"""Issue 44, Build 4(a) and item 16: the unit that the Python package gives each number of the program's JSON.

Two ways: a table by hand of what the commands print, and every key that the program's sources write, read by a grammar of its own.
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


class Units(unittest.TestCase):
    def test_by_hand(self):
        self.assertEqual({key: units_of(key) for key in BY_HAND}, BY_HAND)

    def test_of_every_key_that_the_program_writes(self):
        """Ends of names that are put together, as "_Mrev", count too."""
        sources = [path for folder in ("study", "results", "commands") for path in sorted((ROOT / "app" / folder).rglob("*.[ch]pp"))]
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
