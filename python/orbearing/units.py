"""Units of results: as they state them, else by the ends of their names."""

from __future__ import annotations

import re
from typing import Any, Mapping

# Ends of names -> units as udunits and pint read them; the longest end counts.
_UNITS = {
    "_N_s_per_m": "N s m-1", "_N_per_m": "N m-1", "_N_per_mm_um": "N mm-1 um-1", "_N_per_mm": "N mm-1", "_N_m": "N m", "_N_mm": "N mm",
    "_m_per_N": "m N-1", "_per_s": "s-1",
    "_m_s2": "m s-2", "_m_per_s2": "m s-2", "_kg_m2": "kg m2", "_per_kg": "kg-1", "_per_mm": "mm-1", "_percent": "percent",
    "_rpm": "rpm", "_Mrev": "megarevolution", "_mrad": "mrad", "_MPa": "MPa", "_Hz": "Hz", "_um": "um", "_mm": "mm", "_us": "us", "_ms": "ms",
    "_deg": "degree", "_N": "N", "_kN": "kN", "_W": "W", "_kW": "kW", "_h": "h", "_s": "s", "_m_s": "m s-1", "_rad_s": "rad s-1", "_K": "K", "_m": "m",
    "_rad": "rad", "_kg": "kg",
}
# Lives by the names of the standards, of one bearing, a race, a set or the system; and what only looks like a unit: an elliptic integral.
_LIFE = re.compile(r"(^|\.|^system_|^inner_|^outer_)L10(r|m|mr)?h$")
_NO_UNIT = re.compile(r"(^|\.)elliptic_[KE]$")
# Numbers whose names have no unit and are no ratios.
PLAIN = "1"


def units_of(name: str) -> str:
    """The unit that a name's end states; "1" where it states none."""
    if _LIFE.search(name):
        return "h"
    fitting = [end for end in _UNITS if name.endswith(end) and not _NO_UNIT.search(name)]
    return _UNITS[max(fitting, key=len)] if fitting else PLAIN


def units_in(content: Any) -> dict[str, str]:
    """{name: unit} of all names within a JSON object whose ends state a unit: its `units`."""
    found = {}
    if isinstance(content, Mapping):
        found = {name: unit for name in content if (unit := units_of(name)) != PLAIN}
        content = list(content.values())
    if isinstance(content, (list, tuple)):
        for row in content:
            found |= units_in(row)
    return found


_NAMES = {"Mrev": "megarevolution", "deg": "degree"}


def as_udunits(unit: str) -> str:
    """A unit of the program's JSON as udunits and pint read it: "N.m/rad" is "N m rad-1"."""
    if "^" in unit:  # broken powers, which udunits does not know
        return unit
    above, _, below = unit.partition("/")
    words = [_NAMES.get(word, word) for word in above.split(".")]
    for word in filter(None, below.strip("()").split(".")):
        powers = re.fullmatch(r"(\D+)(\d?)", word)
        words.append(f"{powers[1]}-{powers[2] or 1}" if powers else word)
    return " ".join(words)


def unit_in(units: Mapping[str, Any], name: str) -> str:
    """The unit that a result states of a name among its `units`, else that of the name's end."""
    stated = units.get(name)
    return as_udunits(stated) if isinstance(stated, str) else units_of(name)
