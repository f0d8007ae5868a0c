"""Results of fixed inputs compared with committed records: numbers to a relative 1e-5, texts whole.

A test opens one of tests/interface/records/*.json.xz:

    RECORDS = kept_records.Records("figures")
    self.assertEqual(RECORDS.faults("life over speed", value), [])

and ends by `kept_records.main(RECORDS)`, by which `--record` writes the file anew. Values are dicts, lists, texts, numbers and arrays of numpy.
"""

import json
import lzma
import math
import os
import re
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
FOLDER = Path(__file__).with_name("records")
DIGITS = 6
LEFT_TO_FULL = os.environ.get("ORBEARING_FULL") == "no"  # as in program.py, which calls the program
RELATIVE = 1e-5  # a change of the last digit but one; another compiler or library changes some 1e-12
OF_LARGEST = 1e-9  # of a list: below this share of its largest number all is round-off
ROUND_OFF = 1e-14  # what is zero but for it
WHOLE = 24  # numbers of a list that is kept as it is; of a longer one samples and sums are kept
NUMBER = re.compile(r"[-−+]?\d[\d,]*\.?\d*(?:e[-−+]?\d+)?")
COLOUR = re.compile(r"#(?:[0-9a-f]{2}){3,4}")
RECORDING = "--record" in sys.argv


def plain(value):
    """As it is written: dicts, lists, texts, truth values, numbers with six digits."""
    if isinstance(value, dict):
        return {str(key): plain(one) for key, one in value.items()}
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        if len(value) > WHOLE and all(isinstance(one, (int, float)) and not isinstance(one, bool) for one in value):
            return _long(value)
        return [plain(one) for one in value]
    if isinstance(value, complex):
        return [plain(value.real), plain(value.imag)]
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else str(value)
    if value is None or isinstance(value, (bool, int, str)):
        return value
    raise TypeError(f"found {type(value).__name__}; required: dict, list, text or number")


def _long(values):
    """Samples of a long list, and sums that each of its numbers changes."""
    finite = [one for one in values if math.isfinite(one)]
    at = sorted({round(i * (len(values) - 1) / (WHOLE - 1)) for i in range(WHOLE)})
    mean = sum(finite) / max(len(finite), 1)
    of_order = sum(one * (i + 1) for i, one in enumerate(values) if math.isfinite(one)) / len(values) ** 2
    rms = math.sqrt(sum(one * one for one in finite) / max(len(finite), 1))
    return {"count": len(values), "finite": len(finite), "of all": plain([min(finite, default=0.0), max(finite, default=0.0), mean, of_order, rms]),
            "samples": plain([float(values[i]) for i in at])}


def same_number(one, other, largest=0.0):
    return abs(one - other) <= max(RELATIVE * abs(other), OF_LARGEST * largest, ROUND_OFF)


def same_colour(one, other):
    """Up to a step of a colour map, 3 of 255: a value between two of its steps may be rounded either way by its last bit."""
    return all(abs(a - b) <= 3 for a, b in zip(bytes.fromhex(one[1:]), bytes.fromhex(other[1:]), strict=True))


def same_text(one, other):
    """The same words, and numbers that agree."""
    if one == other:
        return True
    if len(one) == len(other) and COLOUR.fullmatch(one) and COLOUR.fullmatch(other):
        return same_colour(one, other)
    if NUMBER.split(one) != NUMBER.split(other):
        return False
    value = lambda text: float(text.replace(",", "").replace("−", "-"))  # noqa: E731
    return all(same_number(value(a), value(b)) for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)))


def first_difference(one, other):
    """Both texts from shortly before they part."""
    at = next((i for i, (a, b) in enumerate(zip(one, other)) if a != b), min(len(one), len(other)))
    begin = max(at - 60, 0)
    return one[begin:at + 60], other[begin:at + 60]


def differences(found, kept, place, largest=0.0):
    """A line for each difference: where, found and recorded value."""
    number = lambda value: isinstance(value, (int, float)) and not isinstance(value, bool)  # noqa: E731
    if number(found) and number(kept):
        return [] if same_number(found, kept, largest) else [f"{place}: found {found}, recorded {kept}"]
    if isinstance(found, str) and isinstance(kept, str):
        if same_text(found, kept):
            return []
        here, there = first_difference(found, kept)
        return [f"{place}: found {here!r}, recorded {there!r}"]
    if isinstance(found, dict) and isinstance(kept, dict):
        if list(found) != list(kept):
            return [f"{place}: found the keys {list(found)}, recorded {list(kept)}"]
        return [line for key in kept for line in differences(found[key], kept[key], f"{place}, {key}")]
    if isinstance(found, list) and isinstance(kept, list):
        lines = [] if len(found) == len(kept) else [f"{place}: found {len(found)} entries, recorded {len(kept)}"]
        most = max((abs(one) for one in kept if number(one)), default=0.0)
        return lines + [line for i, (a, b) in enumerate(zip(found, kept)) for line in differences(a, b, f"{place}[{i}]", most)]
    return [] if found == kept and type(found) is type(kept) else [f"{place}: found {found!r}, recorded {kept!r}"]


class Records:
    """One file of records, each under a name of its own."""

    def __init__(self, name):
        self.file = FOLDER / f"{name}.json.xz"
        self.kept = json.loads(lzma.decompress(self.file.read_bytes())) if self.file.exists() and not RECORDING else {}
        self.asked = {}

    def faults(self, name, value, most=8):
        """What differs from the record, at most so many lines."""
        assert name not in self.asked, f"{name} is recorded twice"
        found = self.asked[name] = plain(value)
        if RECORDING:
            return []
        if name not in self.kept:
            return [f"{name} has no record: run this test with --record"]
        lines = differences(found, self.kept[name], name)
        return lines[:most] + ([f"... and {len(lines) - most} more"] if len(lines) > most else [])

    def write(self):
        FOLDER.mkdir(exist_ok=True)
        left = json.loads(lzma.decompress(self.file.read_bytes())) if LEFT_TO_FULL and self.file.exists() else {}
        text = json.dumps(dict(sorted((left | self.asked).items())), ensure_ascii=False, separators=(",", ":"))
        self.file.write_bytes(lzma.compress(text.encode(), preset=9 | lzma.PRESET_EXTREME))


class Recorded(unittest.TestCase):
    """A test whose results are compared with `records`."""

    records: Records

    def check(self, name, value):
        found = self.records.faults(name, value)
        self.assertEqual(found, [], "\n" + "\n".join(found))


def main(*all_records):
    """Runs the tests of the calling program; with --record writes the records that they asked for."""
    done = unittest.main(argv=[one for one in sys.argv if one != "--record"], exit=False)
    if not done.result.wasSuccessful():
        sys.exit(1)
    if RECORDING:
        for records in all_records:
            records.write()
