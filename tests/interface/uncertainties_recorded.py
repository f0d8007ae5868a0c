#!/usr/bin/env python3
"""Studies of uncertainty are as recorded: designs, inputs, indices, expansions, peaks, whole results with page, pictures and printed words, on lives by formulas.

`--record` writes records/uncertainties.json.xz anew. Exit code 77 (skipped) where OpenTURNS, xarray, netCDF4 or matplotlib is missing.
"""

import contextlib
import io
import json
import os
import pathlib
import re
import sys
import tempfile
import types
import unittest.mock

try:
    import matplotlib  # noqa: F401
    import netCDF4  # noqa: F401
    import numpy as np
    import openturns  # noqa: F401
    import xarray  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import kept_records  # noqa: E402
import whole_drawing  # noqa: E402
from orbearing.errors import CaseError  # noqa: E402
from orbearing.uncertainties import __main__ as command, chaos, design, indices, lives, page, scatter, store  # noqa: E402
from orbearing.uncertainties import study as studies  # noqa: E402
from orbearing.uncertainties.figures import figures  # noqa: E402
from orbearing.uncertainties.inputs import UncertainInputs, UncertainNumber  # noqa: E402
from orbearing.uncertainties.settings import Settings  # noqa: E402

os.environ["COLUMNS"] = "100"  # of help texts, which break at hyphens
RECORDS = kept_records.Records("uncertainties")
NUMBERS = [UncertainNumber("input.power", "uniform", 150e3, least=100e3, most=200e3, si_unit="W", unit="kW", units_per_si=1e-3, given="{uniform: ...}", reason="a guess"),
           UncertainNumber("planet.mass", "triangular", 1.1, least=0.5, peak=0.9, most=1.5, given="{triangular: ...}"),
           UncertainNumber("bearing.radial_clearance", "normal", 12e-6, 10e-6, 2e-6, si_unit="m", unit="um", units_per_si=1e6, given="{normal: ...}"),
           UncertainNumber("lubricant.temperature", "truncated-normal", 340.0, 345.0, 8.0, least=330.0, most=360.0, si_unit="K", unit="K"),
           UncertainNumber("oil.a", "truncated-normal", 3.0, 3.0, 1.0, least=2.5), UncertainNumber("oil.b", "truncated-normal", 3.0, 3.0, 1.0, most=3.5)]
CORRELATIONS = np.eye(6)
CORRELATIONS[0, 2] = CORRELATIONS[2, 0] = 0.4
GRID = [1000.0, 3000.0, 5000.0, 7000.0, 9000.0]


def row_of(number):
    none = lambda value: None if np.isnan(value) else value  # noqa: E731
    return {"path": number.path, "distribution": number.distribution, "value": number.value, "mean": none(number.mean), "standard_deviation": none(number.standard_deviation), "from": none(number.least),
            "peak": none(number.peak), "to": none(number.most), "si_unit": number.si_unit, "unit": number.unit, "units_per_si": number.units_per_si, "given": number.given, "reason": number.reason}


def case(numbers=NUMBERS[:3], correlations=None, **more):
    wide = CORRELATIONS[:len(numbers), :len(numbers)] if correlations is None else correlations
    return {"name": "a <case>", "inputs": [{"path": "input.speed", "value": 628.0}], "governing_life": {"key": "L10mrh"}, "warnings": ["uncertain.x: said", "other"], "sweep": {"oil.temperature": [1.0], "input.speed": [2.0]},
            "uncertain": {"inputs": [row_of(one) for one in numbers], "correlations": wide.tolist()}, **more}


def evaluate(paths, values, fidelity):
    """Lives of a formula, unlike for each column; some samples fail."""
    named = dict(zip(paths, values.T))
    n = named[lives.SPEED] / lives.RPM / 6000.0
    power, mass, clearance = named["input.power"] / 150e3, named["planet.mass"], named.get("bearing.radial_clearance", 1e-5) / 1e-5
    life = 1e4 / n * np.hypot(power / n, mass * n**2) ** (-10.0 / 3.0) / (0.5 + 0.5 * clearance) * (1.0 if fidelity == "quasi-static" else 0.9)
    failed = power > 1.31
    life = np.where(failed, np.nan, life)
    factor = np.full(len(life), 1.3)
    columns = {"L10h": 0.7 * life, "L10rh": 0.8 * life, "a_ISO": factor, "L10mh": 0.64 * factor * 0.7 * life, "L10mrh": 0.64 * 0.4 * life, "life_h": life, "system_L10mrh": 0.05 * life,
               "shortest_L10mrh": np.where(power > 1.0, 0.2 * life, np.nan), "input_speed_rpm": 6000.0 * n}
    return columns, ["too much power" if one else "ok" for one in failed]


def study(record=None, evaluated=evaluate, speeds=GRID, **settings):
    return studies.Study(record or case(), 6000.0, speeds, evaluated, Settings(**{"samples": 64, "curves": 24, "index_samples": 32, "seed": 5, **settings}))


def refused(call):
    try:
        return call()
    except (CaseError, ValueError, KeyError) as error:
        return f"{type(error).__name__}: {error}"


def keep(canvas, target, **more):
    target.write("<svg></svg>")


@unittest.mock.patch("matplotlib.backends.backend_svg.FigureCanvasSVG.print_svg", keep)
@unittest.mock.patch("orbearing.style.panels_of", lambda figure: ())
class Uncertainties(kept_records.Recorded):
    records = RECORDS

    def test_mathematics(self):
        found = {}
        for method in design.METHODS:
            found[f"points, {method}"] = design.points(method, 8, 3, 7).ravel()
            found[f"pick and freeze, {method}"] = design.pick_freeze(method, 4, ((0, 2), (1,)), 3, 7).ravel()
        inputs = UncertainInputs(NUMBERS, CORRELATIONS)
        cube = design.points("lhs", 16, 6, 3)
        standard, marginals = inputs.standard(cube)
        found["inputs"] = [inputs.nominal, inputs.groups, inputs.group_names, len(inputs), inputs.values(cube).T.tolist(), standard.T.tolist(), [str(one.getName()) for one in marginals], list(inputs.paths)]
        found["no deviation"] = refused(lambda: UncertainNumber.of_record({**row_of(NUMBERS[2]), "standard_deviation": 0.0}).path)
        found["again"] = [vars(UncertainNumber.of_record(row_of(one))) for one in NUMBERS[:1]]
        two = UncertainInputs(NUMBERS[:2])
        cube = design.points("sobol", 64, 2, 1)
        results = np.prod(two.values(cube) ** np.array([-1.2, 0.7]), axis=1)
        results[5] = np.nan
        standard, marginals = two.standard(cube)
        expansion = chaos.expansion(standard, marginals, results, two.groups, two.group_names, 4)
        found["expansion"] = [expansion.record(), expansion.indices.record(), expansion.mean, expansion.standard_deviation, expansion.predictivity]
        found["expansion of few"] = refused(lambda: chaos.expansion(standard[:3], marginals, results[:3], two.groups, two.group_names, 4).record())
        found["expansion of one value"] = refused(lambda: chaos.expansion(standard, marginals, np.ones(64), two.groups, two.group_names, 4).record())
        frozen = two.values(design.pick_freeze("sobol", 32, two.groups, 2, 9))
        results = np.prod(frozen ** np.array([-1.2, 0.7]), axis=1)
        shares = indices.by_pick_freeze(results, two.group_names, 3)
        found["indices"] = [shares.record(), list(shares.order()), shares.remaining_deviation(), shares.variance, shares.samples]
        results[7] = np.nan
        found["indices with a failure"] = indices.by_pick_freeze(results, two.group_names, 3).record()
        found["indices of one value"] = indices.by_pick_freeze(np.ones(len(results)), two.group_names, 3).record()
        given = np.array([50.0, 100.0, 400.0])
        found["scatter"] = [scatter.single_lives(100.0, np.array([0.05, 0.1, 0.5, 0.95])), scatter.single_lives(100.0, 0.3, scatter.BALL_SLOPE), scatter.single_lives(100.0, 0.3, reliability=0.97),
                            scatter.joint_lives(given, [0.05, 0.5, 0.95]), scatter.joint_lives(given, 0.1, scatter.BALL_SLOPE), [scatter.failed_share(time, given) for time in (1.0, 60.0, 900.0)], scatter.L10_RELIABILITY]
        one = {"L10h": np.array([1e4, 2e4]), "a_ISO": np.array([1.5, 0.7]), "L10rh": np.array([3e4, 4e4])}
        one |= {"L10mh": 0.62 * one["a_ISO"] * one["L10h"], "L10mrh": np.array([1e4, np.nan])}
        sets = {f"sets.{name}.{key}": factor * values for name, factor in (("a", 1.0), ("b", 3.0)) for key, values in one.items()}
        found["reliability"] = [scatter.reliability_factors(name, columns) for name, columns in (("L10mh", one), ("L10mrh", one), ("L10h", one), ("system_L10mrh", one), ("L10mrh", {**one, **sets}), ("sets.b.L10mh", sets), ("shortest_L10mrh", one))]
        found["worst"] = [lives.of_worst_bearing("L10h", known) for known in (["L10h"], ["shortest_L10h", "L10h"], ["carrier_L10h", "shortest_L10h"])]
        found["worst by point"] = lives.lives_of_worst_bearing("L10h", {"L10h": [1.0, 2.0, 3.0], "shortest_L10h": [0.5, np.nan, 2.5], "carrier_L10h": [np.nan, np.nan, 1.5]})
        self.check("mathematics", found)

    def test_peaks(self):
        rng = np.random.default_rng(3)
        best, wide = rng.uniform(300.0, 9500.0, 12), rng.uniform(0.4, 2.0, 12)
        asked = []

        def lives_at(rows, speeds):
            asked.append([list(rows), speeds])
            found = np.exp(-((np.log(speeds / best[rows])) / wide[rows]) ** 2) * (1.0 + 0.1 * np.sin(speeds / 700.0))
            return np.where((rows == 4) & (speeds > 100.0), np.nan, found)

        grid = np.array([200.0, 500.0, 1500.0, 4000.0, 10000.0])
        curves = lives_at(np.repeat(np.arange(12), 5), np.tile(grid, 12)).reshape(12, 5)
        curves[4] = [1.0, 2.0, 3.0, 2.0, 1.0]
        curves[5, 2] = np.nan
        asked.clear()
        peaks = lives.refined_peaks(grid, curves, lives_at)
        few = [lives.refined_peaks(grid[:count], curves[:, :count], lives_at) for count in (1, 2)]
        self.check("peaks", {"speeds": peaks.speed_rpm, "lives": peaks.life_h, "ends": peaks.at_end, "points": peaks.points, "asked": asked,
                             "few": [[one.speed_rpm, one.life_h, one.at_end, one.points] for one in few]})

    def test_whole_studies(self):
        ball = case(NUMBERS[:2], inputs=[{"path": "bearing.balls", "value": 9.0}, {"path": "input.power", "value": 1.0}, {"path": "spectrum", "value": 1.0}], governing_life={"key": "L10h"}, sweep={})
        dead = lambda paths, values, fidelity: ({key: np.where(np.arange(len(values)) > 0, np.nan, column) for key, column in evaluate(paths, values, fidelity)[0].items()}, evaluate(paths, values, fidelity)[1])  # noqa: E731
        for name, settings in {"all": {"motion": 3}, "one in motion": {"motion": 1, "method": "lhs", "speeds_rpm": (2000.0, 4000.0, 6000.0, 8000.0)}, "another life": {"life": "system_L10mrh"},
                               "balls": {"record": ball}, "an idle input": {"record": case(NUMBERS[:4]), "method": "monte-carlo"}, "shortest": {"life": "shortest_L10mrh"}, "samples without a life": {"evaluated": dead, "motion": 2},
                               "at the end": {"speeds": [1000.0, 2000.0, 3000.0]}}.items():
            result = refused(lambda settings=settings: study(**settings).run())
            if isinstance(result, str):
                self.check(f"study: {name}", result)
                continue
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                refused(lambda: command.print_result(result.data))
            data = result.to_xarray()
            text = refused(lambda: page.page(result))
            drawn = refused(lambda: {key: whole_drawing.whole(one) for key, one in figures(result).items()}) if name in ("all", "balls", "one in motion") else ""
            self.check(f"study: {name}", {
                "data": result.data, "failed": result.failed, "printed": printed.getvalue().splitlines(), "repr": refused(lambda: repr(result)), "answer": refused(lambda: page.answer(result)).splitlines(), "figures": drawn,
                "page": re.sub(r"<style>.*?</style>", "", text, flags=re.S).splitlines(),
                "arrays": {str(key): [list(one.dims), one.values.ravel(), {word: str(value) for word, value in one.attrs.items()}] for key, one in data.variables.items()}})

    def test_what_is_refused(self):
        cells = [refused(lambda one=one: Settings(**one)) if "Settings" not in str(refused(lambda one=one: Settings(**one))) else "taken" for one in
                 ({"samples": 1}, {"curves": 1}, {"index_samples": 1}, {"seed": -1}, {"motion": -1}, {"jobs": -1}, {"jobs": 10**9}, {"method": "x"}, {"speeds_rpm": ()}, {"speeds_rpm": (2.0, 1.0)}, {"speeds_rpm": (0.0, 1.0)},
                  {"speeds_rpm": (1.0, 1.0)}, {"speeds_rpm": (1.0, float("inf"))}, {"speeds_rpm": (1.0, 2.0)}, {"samples": 2, "curves": 2, "index_samples": 2, "seed": 0})]
        found = {"settings": [str(one) for one in cells]}
        found["cases"] = [refused(lambda record=record, settings=settings: str(study(record, **settings).run())[:40]) for record, settings in
                          (({"name": "x"}, {}), (case(()), {}), (case([UncertainNumber(lives.SPEED, "uniform", 1.0, least=0.5, most=2.0)]), {}), (case(), {"life": "cage_slip"}), (case(governing_life={"key": "L10x"}), {}))]
        nothing = lambda paths, values, fidelity: ({"life_h": np.full(len(values), np.nan)}, ["broken"] * len(values))  # noqa: E731
        found["no life"] = refused(lambda: study(evaluated=nothing).run())
        found["speeds"] = [studies.rpm(one) for one in (628.3185307179586, 1.0)] + [studies._swept_speeds({"sweep": {lives.SPEED: [100.0, 200.0]}, "inputs": []}), studies._swept_speeds({"sweep": {}, "inputs": [{"path": lives.SPEED, "value": 300.0}]})]
        found["cells"] = [command._cell(one) for one in (None, 1234.5, -1000.0, 999.94, 0.0012345, 7, "x")]
        parser = command.parser()
        found["defaults"] = {key: str(value) for key, value in vars(parser.parse_args(["case.yaml"])).items()}
        found["help"] = re.sub(r"\s+", " ", parser.format_help())
        found["folders"] = [str(refused(lambda words=words: command._folder(parser.parse_args(["case.yaml", *words])))) for words in ([], ["--json"], ["--json", "--resume"], ["-o", ""], ["-o", "x", "--resume"])]
        core = types.SimpleNamespace(si=lambda path, text: float(text.split()[0]) * 2 * np.pi / 60)
        found["stated speeds"] = [command._speeds(core, text) for text in (None, "3000 rpm, 6000 rpm", "1 rpm")]
        shown = []
        with unittest.mock.patch.object(command.StatusLine, "is_due", True), unittest.mock.patch.object(command.StatusLine, "show", lambda self, text: shown.append(text)):
            command._Line(True)(17)
        found["line"] = shown
        self.check("refused", found)

    def test_stores(self):
        found = {}
        with tempfile.TemporaryDirectory() as place:
            home = pathlib.Path(place)
            header = store.header_of("x", "hash", {"program_version": "1"}, {"samples": 3})
            counted = []

            def counting(paths, values, fidelity):
                counted.append(len(values))
                return evaluate(paths, values, fidelity)

            paths = ("input.power", "planet.mass", lives.SPEED)
            values = np.column_stack([np.linspace(1e5, 2.1e5, 9), np.linspace(0.6, 1.4, 9), np.full(9, 600.0)])
            with unittest.mock.patch.object(store, "PORTION", 4):
                for turn, resume in ((0, False), (1, True)):
                    one = store.Store(home / "a", header, resume)
                    columns, status = one.keeping(counting)(paths, values, "quasi-static")
                    one.keeping(counting)(paths, values[:3], "dynamic" if turn else "quasi-static")
                    one.close()
                    found[f"turn {turn}"] = [{name: list(column) for name, column in columns.items()}, status, list(counted)]
            for name, other, resume in (("not resumed", header, False), ("another", {**header, "samples": 4, "case": "y", "more": 1}, True)):
                found[name] = str(refused(lambda other=other, resume=resume: store.Store(home / "a", other, resume))).replace(place, "DIR")
            (home / "b").mkdir()
            (home / "b" / "x.txt").write_text("x")
            found["other things"] = [str(refused(lambda resume=resume: store.Store(home / "b", header, resume))).replace(place, "DIR") for resume in (False, True)]
            (home / "c").write_text("x")
            found["a file"] = str(refused(lambda: store.Store(home / "c", header, False))).replace(place, "DIR")
            result = study(samples=8, curves=4, index_samples=4).run()
            with unittest.mock.patch("orbearing.uncertainties.files._pictures", lambda result: {"x.svg": b"x"}):
                result.save(home / "saved", "name: x\n")
                result.save(home / "bare")
            found["files"] = [sorted(path.name for path in (home / name).iterdir()) for name in ("saved", "bare")]
            with xarray.open_dataset(home / "saved" / "samples.nc") as data:
                found["samples"] = {str(key): [list(one.dims), one.values.ravel(), {word: str(value) for word, value in one.attrs.items()}] for key, one in data.variables.items()}
            self.assertEqual(json.loads((home / "saved" / "uncertainty.json").read_text(encoding="utf-8")), result.data)
            self.assertEqual(result.report(home / "page.html"), home / "page.html")
            found["frozen"] = refused(lambda: result.point_lives.__setitem__(0, 1.0))
        self.check("stores", found)


if __name__ == "__main__":
    kept_records.main(RECORDS)
