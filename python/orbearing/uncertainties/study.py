"""The study: samples of the uncertain numbers of a case, their lives, and what these say."""

from __future__ import annotations

import dataclasses
import json

import numpy as np

from orbearing.errors import CaseError
from orbearing.lives import LIVES, governing_life
from orbearing.uncertainties import chaos, design, indices, scatter
from orbearing.uncertainties.inputs import UncertainInputs
from orbearing.uncertainties.lives import RPM, SPEED, Evaluate, Peaks, lives_of_worst_bearing, of_worst_bearing, refined_peaks
from orbearing.uncertainties.result import UncertaintyResult
from orbearing.uncertainties.settings import Settings
from orbearing.uncertainties.store import Store, header_of
from orbearing.units import units_in

PERCENTILES = (5, 25, 50, 75, 95)
LEAST_PREDICTIVITY = 0.5
UNFELT = 1e-12  # a total index of round-off alone
REST = "quasi-static"
MOTION = "dynamic"
# Each design has a seed of its own, so that none is a part of another.
OF_POINT, OF_CURVES, OF_INDICES, OF_INTERVALS = range(4)


class Study:
    """One case under one set of settings. `evaluate` computes operating points (`lives.Evaluate`)."""

    def __init__(self, case_record: dict, nominal_speed_rpm: float, speeds_rpm, evaluate: Evaluate, settings: Settings):
        record = case_record.get("uncertain")
        if not record or not record["inputs"]:
            raise CaseError(f"{case_record['name']}: uncertain: missing; required: a block 'uncertain:' with at least one number, "
                           "as in uncertain: {input.power: {normal: {standard_deviation: 5 kW}}}")
        self.case = case_record
        self.inputs = UncertainInputs.of_record(record)
        self.speed_rpm = nominal_speed_rpm
        self.speeds_rpm = np.array(settings.speeds_rpm or speeds_rpm, dtype=float)
        self.settings = settings
        self._evaluate = evaluate
        if SPEED in self.inputs.paths:
            raise CaseError(f"{case_record['name']}: uncertain.{SPEED}: an uncertain speed found; required: other numbers; life is "
                           "studied over speed")

    def run(self) -> UncertaintyResult:
        self.life = self._life_column()
        point = self._point_lives()
        return self._result(point, *self._curves())

    # Lives

    def _rows(self, values: np.ndarray, speed_rpm) -> np.ndarray:
        return np.column_stack([values, np.broadcast_to(np.asarray(speed_rpm, dtype=float) * RPM, len(values))])

    def _lives(self, values: np.ndarray, speed_rpm, fidelity: str = REST) -> tuple[np.ndarray, list[str]]:
        """Lives [h] at samples (samples, inputs) and speeds; NaN where a point failed."""
        lives, _, status = self._rated_lives(values, speed_rpm, fidelity)
        return lives, status

    def _rated_lives(self, values: np.ndarray, speed_rpm, fidelity: str = REST) -> tuple[np.ndarray, np.ndarray, list[str]]:
        """The same, with the factors a_1 that the lives hold."""
        columns, status = self._evaluate((*self.inputs.paths, SPEED), self._rows(values, speed_rpm), fidelity)
        life = self.settings.life or self.case["governing_life"]["key"]
        if self.settings.life:
            life = life if fidelity == REST else life.removeprefix("carrier_")  # in motion the carrier is no body
            lives = np.asarray(columns[life], dtype=float)
        else:
            lives = lives_of_worst_bearing(life, columns)
        return np.where(lives > 0.0, lives, np.nan), scatter.reliability_factors(life, columns), list(status)

    def _life_column(self) -> str:
        """The life that is studied."""
        columns, status = self._evaluate((*self.inputs.paths, SPEED), self._rows(self.inputs.nominal[None], self.speed_rpm), REST)
        known = [name for name, values in columns.items() if name.endswith(LIVES) and np.isfinite(values[0])]
        if not known:
            raise CaseError(f"{self.case['name']}: the case itself has no life at its operating point ({status[0]}); required: a case "
                           "that can be computed")
        wanted = self.settings.life or of_worst_bearing(self.case["governing_life"]["key"], known)
        if wanted not in known:
            what = f"{wanted!r} found" if self.settings.life else f"{wanted}, the governing life, has no number at the case's operating point"
            raise CaseError(f"life: {what}; one of {', '.join(known)} is required")
        return wanted

    def _number(self, path: str) -> float | None:
        return next((one["value"] for one in self.case["inputs"] if one["path"] == path), None)

    def _cube(self, count: int, of: int) -> np.ndarray:
        return design.points(self.settings.method, count, len(self.inputs), self._seed(of))

    def _seed(self, of: int) -> int:
        return 8 * self.settings.seed + of

    def _point_lives(self) -> dict:
        cube = self._cube(self.settings.samples, OF_POINT)
        values = self.inputs.values(cube)
        lives, factors, status = self._rated_lives(values, self.speed_rpm)
        frozen = design.pick_freeze(self.settings.method, self.settings.index_samples, self.inputs.groups, len(self.inputs),
                                    self._seed(OF_INDICES))
        shares = indices.by_pick_freeze(self._lives(self.inputs.values(frozen), self.speed_rpm)[0], self.inputs.group_names,
                                        self._seed(OF_INTERVALS))
        nominal, factor, _ = self._rated_lives(self.inputs.nominal[None], self.speed_rpm)
        return {"values": values, "lives": lives, "L10": lives / factors, "status": status, "nominal": nominal[0], "nominal_L10": nominal[0] / factor[0],
                "a_1": factor[0], "indices": shares, "chaos": self._expansion(cube, lives)}

    def _expansion(self, cube: np.ndarray, results: np.ndarray) -> chaos.ChaosExpansion:
        standard, marginals = self.inputs.standard(cube)
        return chaos.expansion(standard, marginals, results, self.inputs.groups, self.inputs.group_names, self._seed(OF_INTERVALS))

    def _curves(self):
        """Lives, and the same for a reliability of 90 %; row 0 is the case as it stands, then the samples."""
        cube = self._cube(self.settings.curves, OF_CURVES)
        values = np.vstack([self.inputs.nominal, self.inputs.values(cube)])
        speeds = self.speeds_rpm
        lives, factors, _ = self._rated_lives(np.repeat(values, len(speeds), axis=0), np.tile(speeds, len(values)))
        lives, factors = lives.reshape(len(values), -1), factors.reshape(len(values), -1)
        peaks = refined_peaks(speeds, lives, lambda rows, rpm: self._lives(values[rows], rpm)[0])
        return lives, lives / factors, peaks, values, cube

    # Results

    def _scatter(self, lives: np.ndarray, nominal_l10: float, l10: np.ndarray) -> dict:
        """Three bands apart: what is not known, what bearings do at given inputs, both. Bearings scatter about the life that nine tenths reach."""
        l10 = l10[np.isfinite(l10)]
        failed = np.array(PERCENTILES) / 100.0
        joint = scatter.joint_lives(l10, [*failed, 0.1], self.slope) if len(l10) else np.full(len(failed) + 1, np.nan)
        return {"of_uncertain_inputs": _summary(lives[np.isfinite(lives)]),
                "of_single_bearings_at_the_case": {"percentiles": _by_percent(scatter.single_lives(nominal_l10, failed, self.slope)),
                                                   "L10": _number(nominal_l10)},
                "of_both": {"percentiles": _by_percent(joint[:-1]), "L10": _number(joint[-1])}}

    @property
    def slope(self) -> float:
        return scatter.BALL_SLOPE if self._number("bearing.balls") is not None else scatter.ROLLER_SLOPE

    def _result(self, point, curves, curves_l10, peaks: Peaks, curve_values, cube) -> UncertaintyResult:
        peak_speed = self._expansion(cube, peaks.speed_rpm[1:])
        peak_life = self._expansion(cube, peaks.life_h[1:])
        record = {
            "case": self.case["name"],
            "life": self.life,
            "settings": self._settings_record(),
            "inputs": [{"path": one.path, "distribution": one.given, "unit": one.unit, "value": one.value * one.units_per_si,
                        "reason": one.reason} for one in self.inputs.numbers],
            "correlations": self.inputs.correlations.tolist(),
            "weibull": {"slope": self.slope, "reliability": scatter.L10_RELIABILITY, "a_1": point["a_1"]},
            "operating_point": {"speed_rpm": self.speed_rpm, "life_at_the_case_h": _number(point["nominal"]),
                                **self._scatter(point["lives"], point["nominal_L10"], point["L10"]), "chaos": point["chaos"].record(),
                                "indices": point["indices"].record(), "indices_by": "pick-freeze",
                                "failed": int(np.isnan(point["lives"]).sum())},
            "speeds": [{"speed_rpm": float(speed), "life_at_the_case_h": _number(curves[0, i]),
                        **self._scatter(curves[1:, i], curves_l10[0, i], curves_l10[1:, i]), "failed": int(np.isnan(curves[1:, i]).sum())}
                       for i, speed in enumerate(self.speeds_rpm)],
            "peak": {"speed_at_the_case_rpm": _number(peaks.speed_rpm[0]), "life_at_the_case_h": _number(peaks.life_h[0]),
                     "speed_rpm": self._peak_record(peaks.speed_rpm[1:], peak_speed),
                     "life_h": self._peak_record(peaks.life_h[1:], peak_life), "at_an_end_of_the_speeds": int(peaks.at_end[1:].sum()),
                     "failed": int(np.isnan(peaks.life_h[1:]).sum()), "refining_points": peaks.points},
            "measure_first": _measure_first({f"life at {self.speed_rpm:g} rpm": point["indices"], **_foretold("speed of the peak", peak_speed),
                                             **_foretold("life at the peak", peak_life)}),
            "motion": self._motion(point),
        }
        record = _finite(record)
        record["units"] = units_in(record)
        record["warnings"] = self._warnings(record, point)
        return UncertaintyResult(record, self.inputs, point["values"], point["lives"], self.speeds_rpm, curve_values[1:], curves,
                                 peaks)

    def _settings_record(self) -> dict:
        used = self.settings
        return {"samples": used.samples, "curves": used.curves, "index_samples": used.index_samples, "seed": used.seed,
                "method": used.method, "motion": used.motion}

    @staticmethod
    def _peak_record(results: np.ndarray, expansion: chaos.ChaosExpansion) -> dict:
        return {**_summary(results[np.isfinite(results)]), "chaos": expansion.record(), "indices": expansion.indices.record(),
                "indices_by": "chaos"}

    def _motion(self, point: dict) -> list[dict]:
        """Samples at percentiles of the life at rest, computed in motion."""
        lives = point["lives"]
        good = np.flatnonzero(np.isfinite(lives))
        if not self.settings.motion or not len(good):
            return []
        percents = np.linspace(5.0, 95.0, self.settings.motion) if self.settings.motion > 1 else np.array([50.0])
        order = good[np.argsort(lives[good], kind="stable")]
        chosen = order[np.round((len(order) - 1) * percents / 100.0).astype(int)]
        moving, status = self._lives(point["values"][chosen], self.speed_rpm, MOTION)
        return [{"percentile": float(percent), "quasi_static_h": _number(lives[row]), "dynamic_h": _number(moving[i]),
                 "ratio": _number(moving[i] / lives[row]), "status": status[i],
                 "inputs": {one.path: float(point["values"][row, k] * one.units_per_si) for k, one in enumerate(self.inputs.numbers)}}
                for i, (percent, row) in enumerate(zip(percents, chosen))]

    def _warnings(self, record: dict, point: dict) -> list[str]:
        found = [text for text in self.case.get("warnings", []) if text.startswith("uncertain.")]
        found += [f"sweep.{path}: not varied by uncertainty; the case's own value is taken" for path in self.case.get("sweep", {})
                  if path != SPEED]
        if any(row["path"] == "spectrum" for row in self.case["inputs"]):
            found.append("spectrum: has no effect on uncertainty, which samples lives at single speeds; used by run, sweep and crown")
        for row in record["operating_point"]["indices"]:
            if abs(row["total"]) < UNFELT and not any(text.startswith(f"uncertain.{row['inputs']}:") for text in found):
                found.append(f"uncertain.{row['inputs']}: no effect on {self.life} in any sample")
        reasons = sorted({text for text in point["status"] if text != "ok"})
        found += [f"{sum(one == text for one in point['status'])} of {len(point['status'])} samples have no life: {text}"
                  for text in reasons[:5]]
        ends = record["peak"]["at_an_end_of_the_speeds"]
        if ends:
            found.append(f"{ends} of {self.settings.curves} curves are longest at an end of the speeds; their peak may lie beyond")
        for name in ("speed_rpm", "life_h"):
            predictivity = record["peak"][name]["chaos"]["predictivity"]
            if predictivity is not None and predictivity < 0.9:
                found.append(f"the chaos expansion of the peak's {name.replace('_', ' in ')} foretells {predictivity:.2f} of its "
                             "variance; its indices are as rough: take more curves")
        return found


def _foretold(name: str, expansion: chaos.ChaosExpansion) -> dict[str, indices.SobolIndices]:
    """Indices by an expansion that foretells less than half of the variance advise nobody."""
    return {name: expansion.indices} if expansion.predictivity >= LEAST_PREDICTIVITY else {}


def _measure_first(results: dict[str, indices.SobolIndices]) -> list[dict]:
    """For each result, which input to measure first: that whose knowledge is expected to take away most of its variance."""
    rows = []
    for name, one in results.items():
        if one.variance == 0.0 or not len(one.names):
            continue
        best = one.order()[0]
        rows.append({"result": name, "measure": one.names[best], "variance_removed": float(one.first[best]),
                     "standard_deviation": float(np.sqrt(one.variance)),
                     "expected_standard_deviation_after": float(one.remaining_deviation()[best])})
    return rows


def _summary(values: np.ndarray) -> dict:
    if not len(values):
        return {"mean": None, "standard_deviation": None, "percentiles": _by_percent([None] * len(PERCENTILES))}
    return {"mean": float(values.mean()), "standard_deviation": float(values.std(ddof=1)) if len(values) > 1 else 0.0,
            "percentiles": _by_percent(np.percentile(values, PERCENTILES))}


def _by_percent(values) -> dict:
    return {str(percent): _number(value) for percent, value in zip(PERCENTILES, values)}


def _number(value):
    return None if value is None or not np.isfinite(value) else float(value)


def _finite(record):
    """The same with null for what is no number, as JSON knows none."""
    if isinstance(record, dict):
        return {key: _finite(value) for key, value in record.items()}
    if isinstance(record, list):
        return [_finite(value) for value in record]
    return None if isinstance(record, float) and not np.isfinite(record) else record


def open_store(folder, core, settings: Settings, resume: bool) -> Store:
    """The folder that keeps the lives of a study. Raises CaseError where it holds another study, or another program writes there."""
    from orbearing.studies.engine import program

    checked_record(core)  # before there is a folder
    stated = {key: value for key, value in dataclasses.asdict(settings).items() if key != "jobs"}
    stated["speeds_rpm"] = list(settings.speeds_rpm) if settings.speeds_rpm else None
    stated["life"] = settings.life or governing_life(core)["key"]
    return Store(folder, header_of(core.name(), core.hash(), program(), stated), resume)


def checked_record(core) -> dict:
    """What `check` says of a case whose lives can be sampled. Raises CaseError for another, and for uncertain inputs without effect."""
    from orbearing import _core  # the mathematics needs none of it

    record = json.loads(_core.compute(core, "check", {})[0])
    record["sweep"] = {path: [core.si(path, text) for text in texts] for path, texts in core.axes().items()}
    if record["model"] != "planetary-drivetrain" or _speed_of(record) is None:
        raise CaseError(f"{core.file()}: model: {record['model']} found; required: a planetary-drivetrain with a speed, whose lives are "
                       "sampled")
    without = core.without_effect([one["path"] for one in record.get("uncertain", {}).get("inputs", [])], REST)
    if without:
        raise CaseError(list(without.values()))
    return record


def of_case(core, settings: Settings, progress=None, store: Store | None = None) -> UncertaintyResult:
    """The study of a case as the program holds it (`orbearing._core.CoreCase`); with a store it keeps the lives there."""
    from orbearing import _core

    record = checked_record(core)

    def evaluate(paths, values, fidelity):
        columns, table, status = _core.evaluate(core, list(paths), np.ascontiguousarray(values), fidelity, settings.jobs, progress,
                                                without_effect=True)
        return dict(zip(columns, np.asarray(table).T)), status

    return Study(record, rpm(_speed_of(record)), _swept_speeds(record), store.keeping(evaluate) if store else evaluate, settings).run()


def _speed_of(record: dict) -> float | None:
    return next((one["value"] for one in record["inputs"] if one["path"] == SPEED), None)


def _swept_speeds(record: dict) -> list[float]:
    """Speeds [rpm] that the case sweeps; its own where it sweeps none."""
    swept = record["sweep"].get(SPEED) or [one["value"] for one in record["inputs"] if one["path"] == SPEED]
    return [rpm(speed) for speed in swept]


def rpm(speed: float) -> float:
    """As people write it: 6000 and not 5999.999999999999."""
    return float(f"{speed / RPM:.12g}")
