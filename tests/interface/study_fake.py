"""A case and an engine in a few lines, whose lives are a formula: what studies are tested with where no bearing is needed."""

import hashlib
import math
import threading

import numpy as np

from orbearing.errors import CaseError
from orbearing.studies.table import Chunk

UNITS = {"um": 1e-6, "mm": 1e-3, "rpm": 2 * math.pi / 60, "degC": 1.0, "K": 1.0}
OFFSETS = {"degC": 273.15}
FIELDS = {
    "input.speed": ("quantity", "rpm", "6000 rpm"),
    "bearing.radial_clearance": ("quantity", "um", "0 um"),
    "bearing.bore": ("quantity", "mm", "25 mm"),
    "bearing.rollers": ("integer", "1", "15"),
    "lubricant.temperature": ("quantity", "degC", "80 degC"),
    "film.enabled": ("flag", "1", "false"),
    "bearing.profile.kind": ("choice", "1", "straight"),
}
COLUMNS = ("input_speed_rpm", "life_h", "L10mrh", "power_loss_W")
BAD_CLEARANCE = 66e-6  # [m] points with it fail


class FakeCase:
    """As a CoreCase, of a bearing that has one clearance."""

    def __init__(self, speeds=("1000 rpm", "2000 rpm", "3000 rpm"), name="fake", given=None):
        self.speeds, self._name = tuple(speeds), name
        self._given = {path: field[2] for path, field in FIELDS.items()} | (given or {})

    def name(self):
        return self._name

    def hash(self):
        return hashlib.sha256(repr((self.speeds, sorted(self._given.items()))).encode()).hexdigest()[:16]

    def resolved(self):
        return f"name: {self._name}\n"

    def axes(self):
        return {"input.speed": list(self.speeds)} if self.speeds else {}

    def given(self, path):
        return self._given[path]

    def inputs(self):
        return [{"path": path, "kind": kind, "unit": unit, "si_unit": "", "meaning": path.rpartition(".")[2], "given": self._given[path], "source": "assumed", "reason": "none"}
                for path, (kind, unit, _) in FIELDS.items()]

    def value(self, path):
        if path not in FIELDS:
            raise CaseError(f"{path}: found a path that this case does not have")

    def si(self, path, text):
        if isinstance(text, list):
            return [self.si(path, one) for one in text]
        number, _, unit = text.partition(" ")
        if (FIELDS[path][0] == "quantity") != bool(unit):
            raise CaseError(f"{path}: found '{text}'; required: a number with its unit")
        if path == "bearing.bore" and not 5.0 <= float(number) * UNITS[unit] / UNITS["mm"] <= 500.0:
            raise CaseError(f"{path}: found '{text}', which is out of range")
        return float(number) * UNITS.get(unit, 1.0) + OFFSETS.get(unit, 0.0)

    def without_sweep(self):
        return FakeCase((), self._name, self._given)

    def with_settings(self, settings):
        for path, text in settings:
            if text.startswith("-"):
                raise CaseError(f"--set: {path}: found '{text}'; required: a positive one")
        return FakeCase(self.speeds, self._name, self._given | dict(settings))


class FakeEngine:
    """Lives by a formula. Counts how often each point is computed; stops with KeyboardInterrupt after `stop_after` portions."""

    def __init__(self, paths, version="1", stop_after=None):
        self.paths, self.fidelity, self.stop_after = list(paths), "quasi-static", stop_after
        self.program = {"program_version": version, "instruction_set": "none"}
        self.computed = []
        self.portions = 0
        self._counting = threading.Lock()

    def compute(self, ids, settings, values, jobs):
        with self._counting:
            self.portions += 1
            self.computed += ids.tolist()
            if self.stop_after is not None and self.portions > self.stop_after:
                raise KeyboardInterrupt
        rows = np.full((len(ids), len(COLUMNS)), np.nan)
        statuses = {}
        crowned = dict(settings).get("bearing.profile.kind", "straight") != "straight"
        for place, row in enumerate(values):
            of = dict(zip(self.paths, row))
            speed, clearance = of["input.speed"] / UNITS["rpm"], of.get("bearing.radial_clearance", 0.0)
            rows[place, 0] = speed
            if math.isclose(clearance, BAD_CLEARANCE):
                statuses[place] = "no equilibrium"
                continue
            # Longest at 2000 rpm without clearance, at more with it.
            best = 2000.0 + 1000.0 * (clearance > 20e-6)
            rows[place, 1] = (2.0 if crowned else 1.0) * 1e4 / (1.0 + ((speed - best) / 1000.0) ** 2) / (1.0 + clearance / 1e-5)
            rows[place, 2] = 5e6 / speed  # longest at the lowest speed
        return Chunk(np.asarray(ids), COLUMNS, rows, statuses, 1e-4 * len(ids))
