#!/usr/bin/env python3
"""Studies are as recorded: designs, tables, files, pictures, pages, words of the command and what is refused, of a case whose lives are a formula.

`--record` writes records/studies.json.xz anew. Exit code 77 (skipped) where xarray, netCDF4, matplotlib or SciPy is missing.
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
    import netCDF4
    import numpy as np
    import scipy  # noqa: F401
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
from orbearing.studies import __main__ as command, dataset, folder, pictures, plan, run, table  # noqa: E402
from orbearing.studies.design import SPEED, case_axes, design_of, from_content, stated_values  # noqa: E402
from orbearing.studies.executors import InProcess  # noqa: E402
from orbearing.studies.result import json_of, open_study  # noqa: E402
from study_fake import FakeCase, FakeEngine  # noqa: E402

os.environ["COLUMNS"] = "100"  # of help texts, which break at hyphens
RECORDS = kept_records.Records("studies")
CLEARANCES = ["0 um", "10 um", "0.03 mm", "66 um"]
KINDS = ["straight", "iso16281"]
GRIDS = {
    "grid": ({"bearing.radial_clearance": CLEARANCES, "bearing.profile.kind": KINDS}, {}),
    "steps": ({"bearing.radial_clearance": {"from": "0 um", "to": "40 um", "step": "8 um"}, "lubricant.temperature": ["60 degC", "353.15 K"]}, {}),
    "counts": ({"bearing.bore": {"from": "20 mm", "to": "30 mm", "count": 4}, "film.enabled": [True, False]}, {}),
    "pairs of numbers": ({"bearing.radial_clearance": (np.array([5.0, 2.5]), "um"), "bearing.rollers": [13, 15.0]}, {}),
    "own speeds": ({"input.speed": ["3000 rpm", "100 rad/s"], "bearing.rollers": ["14", "15"]}, {}),
    "rows": ({"film.enabled": ["false", "true"]}, {"paired": [{"bearing.rollers": 14, "bearing.bore": "25 mm"}, {"bearing.rollers": 16, "bearing.bore": "22 mm"}, {"bearing.rollers": 18, "bearing.bore": "21000 um"}]}),
    "sobol": ({"bearing.radial_clearance": {"from": "0 um", "to": "40 um"}, "bearing.profile.kind": KINDS}, {"sampler": "sobol", "samples": 8, "seed": 3}),
    "lhs": ({"bearing.radial_clearance": {"from": "0.005 mm", "to": "0.04 mm"}, "bearing.rollers": [12, 14, 16]}, {"sampler": "lhs", "samples": 5}),
    "samples of speed": ({"input.speed": {"from": "1000 rpm", "to": "3000 rpm"}, "bearing.rollers": [14, 15]}, {"sampler": "lhs", "samples": 6, "seed": 2}),
    "no axis": ({"bearing.profile.kind": KINDS, "input.speed": ["2000 rpm"]}, {}),
    "many values": ({"bearing.radial_clearance": {"from": "0 um", "to": "20 um", "count": 9}}, {}),
    "many choices": ({"bearing.profile.kind": [f"kind {i}" for i in range(9)], "bearing.rollers": [14]}, {}),
    "many curves": ({"bearing.radial_clearance": {"from": "0 um", "to": "40 um"}}, {"sampler": "lhs", "samples": 70}),
    "nothing": ({}, {}),
}
ALL_OF = ("grid", "steps", "rows", "samples of speed", "no axis", "many values", "many choices", "many curves", "nothing")
VALUES = ("[a, b]", "[1 um,  2 um ]", "['a, b', \"c\"]", "{from: 1, to: 3, step: 1}", "{from: '1 um', to: 3 um, count: 4}", "[[1, 2], {a: b}]", "[]", "[1,]", "{from 1}", "{a: 1, a: 2}", "x", "", "[", "(1)")


def study(name, life_key="life_h", output=None, executor=None):
    vary, options = GRIDS[name]
    core = FakeCase() if name != "no axis" else FakeCase(())
    design = design_of(core, vary, **options)
    engine = FakeEngine([p.path for p in design.numbers()])
    return run.compute(core, design, engine, executor or InProcess(1), life_key=life_key, output=output, progress=False, warnings=["a <warning>"])


def refused(call, *words, **more):
    try:
        return call(*words, **more)
    except (CaseError, ValueError) as error:
        return f"{type(error).__name__}: {error}"


def keep(canvas, target, **more):
    target.write(f"<svg>{json.dumps(kept_records.plain(whole_drawing.whole(canvas.figure)), ensure_ascii=False)}</svg>")


def of_dataset(found):
    return {"sizes": {str(name): size for name, size in found.sizes.items()}, "attributes": {key: value for key, value in found.attrs.items()},
            "variables": {str(name): [list(one.dims), one.values.tolist(), {key: str(value) for key, value in one.attrs.items()}] for name, one in found.variables.items()}}


class Studies(kept_records.Recorded):
    records = RECORDS

    def test_designs(self):
        found = {}
        for name, (vary, options) in GRIDS.items():
            core = FakeCase() if name != "no axis" else FakeCase(())
            design = design_of(core, vary, **options)
            again = from_content(json.loads(json.dumps(design.content())))
            self.assertEqual(again.content(), design.content())
            ids = np.arange(design.points)
            found[name] = {"content": design.content(), "summary": design.summary(), "points": [design.points, design.variants, design.over_speed, list(design.shape)], "values": design.values(ids)[:12].ravel(),
                           "groups": [[list(map(list, settings)), list(members)] for settings, members in design.groups()], "settings": [list(map(list, design.settings(i, every=True))) for i in range(min(design.points, 6))],
                           "names": [dataset.name_of(p) for p in design.parameters], "rpm": [dataset.in_rpm(p) for p in design.parameters if p.path == SPEED], "axes": case_axes(core),
                           "tried": [list(map(list, settings)) for settings in run._settings_of_each_value(design)]}
        self.check("designs", found)

    def test_what_is_refused(self):
        one = {"bearing.radial_clearance": ["0 um"]}
        ranges = [{"from": "0 um", "to": "5 um", "step": "2 um"}, {"from": "0 um", "to": "5 mm", "count": 3}, {"from": "0 um", "to": "5 um"}, {"from": "0 um", "to": "5 um", "step": "-1 um"}, {"from": "5 um", "to": "0 um", "step": "1 um"},
                  {"from": "0 um", "to": "5 um", "step": "1 mm"}, {"from": "0 um", "to": "5 um", "count": 1}, {"from": "0 um", "to": "5 um", "count": "x"}, {"from": "a", "to": "5 um", "count": 3}, {"from": "0 um", "to": "1e999 um", "count": 3},
                  {"from": "0 um", "to": "5 um", "step": "1e-9 um"}, {"from": "0 um", "to": "5 um", "count": 20_000_000}, {}]
        cases = [(dict.fromkeys(["bearing.radial_clearance"], value), {}) for value in (*ranges, [], "0 um", 5, [5], ["0 um", "0 um"], ["5 um", "0.005 mm"], ["-3 um"], ["1 lb"])]
        cases += [({"bearing.clearance": ["0 um"]}, {}), (one, {"sampler": "random"}), (one, {"samples": 3}), (one, {"sampler": "lhs"}), (one, {"sampler": "lhs", "samples": 0}), (one, {"sampler": "sobol", "samples": 100}),
                  ({}, {"sampler": "lhs", "samples": 3}), (one, {"paired": [{"bearing.radial_clearance": "1 um"}]}), ({}, {"paired": [{"bearing.rollers": 14}, {"film.enabled": True}]}), ({}, {"paired": [{}]}),
                  ({"bearing.rollers": {"from": 13, "to": 15}}, {"sampler": "lhs", "samples": 3}), ({"bearing.radial_clearance": {"from": "3 um", "to": "2 um"}}, {"sampler": "lhs", "samples": 3}),
                  ({"bearing.radial_clearance": {"from": "3 um", "to": "2 mm"}}, {"sampler": "lhs", "samples": 3}), ({"bearing.radial_clearance": {"from": "3 um", "count": 2}}, {"sampler": "lhs", "samples": 3}),
                  ({"bearing.radial_clearance": {"from": "0 um", "to": "4000 um", "count": 4000}, "bearing.bore": {"from": "5 mm", "to": "50 mm", "count": 4000}}, {})]
        self.check("refused", [str(refused(design_of, FakeCase(), vary, **options)) for vary, options in cases])
        self.check("values", {text: refused(stated_values, text) for text in VALUES})
        once = {"bearing.radial_clearance": ["0 um", "5 um"]}
        settings = [{"points": "some"}, {"samples": 0}, {"seed": -1}, {"jobs": 10**9}, {"output": ""}, {"resume": True}, {"points": "all"}, {"seed": 1.5}]
        self.check("settings", [str(refused(run.study, FakeCase(), once, **one)) for one in settings])
        self.check("peaks without a speed", str(refused(run.study, FakeCase(()), {"input.speed": {"from": "1 rpm", "to": "2 rpm"}}, sampler="lhs", samples=2, points="peak", output="x")))

    @unittest.mock.patch("matplotlib.backends.backend_svg.FigureCanvasSVG.print_svg", keep)
    @unittest.mock.patch("orbearing.style.panels_of", lambda figure: ())
    def test_results(self):
        for name in ALL_OF:
            result = study(name, "L10mrh" if name in ("steps", "no axis") else "life_h")
            text = re.sub(r"<style>.*?</style>", "", pictures.page_of(result), flags=re.S)
            figures = [json.loads(one) for one in re.findall(r"<svg[^>]*>(\{.*?\})</svg>", text, re.S)]
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                command.print_variants(result)
            self.check(f"result: {name}", {
                "page": re.sub(r"\{.*?\}</svg>", "</svg>", text, flags=re.S).splitlines(), "figures": figures, "dataset": of_dataset(result.to_xarray()), "json": json.loads(json_of(result)), "repr": repr(result),
                "numbers": [result.points, result.missing, result.failed, result.life_key, list(result.parameters), result.warnings, result.failures()], "printed": printed.getvalue().splitlines(), "html": len(result._repr_html_()) > 100})

    def test_results_without_a_life(self):
        result = study("grid", "L10mh")
        self.check("no life", [pictures.headline(result), result.variants()[:2], list(result.to_xarray().variables)])
        with unittest.mock.patch("orbearing.studies.pictures.MOST_ROWS", 3), unittest.mock.patch("orbearing.studies.__main__.MOST_ROWS", 3):
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                command.print_variants(study("grid"))
            self.check("few rows", [pictures._variants_table(study("grid")).splitlines(), printed.getvalue().splitlines()])
        self.check("axes", whole_drawing.whole(study("steps").plot().figure))

    def test_folders(self):
        found = {}
        with tempfile.TemporaryDirectory() as place:
            home = pathlib.Path(place)
            result = study("grid", output=home / "a")
            opened = open_study(home / "a")
            found["header"] = {key: value for key, value in opened.header.items() if key != "case_hash"}
            found["dataset"] = of_dataset(opened.to_xarray())
            found["files"] = sorted(path.name for path in (home / "a").iterdir())
            with netCDF4.Dataset(home / "a" / folder.DATASET) as data:
                found["stored"] = {name: [list(one.dimensions), str(one.dtype), {key: str(one.getncattr(key)) for key in one.ncattrs()}] for name, one in data.variables.items()}
            found["counts"] = list(folder.finished_counts(home / "a"))
            core, design = FakeCase(), design_of(FakeCase(), GRIDS["grid"][0])
            header = folder.header_of("fake", core.hash(), {"program_version": "1", "instruction_set": "none"}, "quasi-static", "life_h", design)
            others = design_of(FakeCase(), {"bearing.radial_clearance": ["0 um", "1 um"], "film.enabled": [True]}).summary()
            found["differences"] = [folder.differences(header, {**header, **others}), folder.differences({**header, "case": "b", "fidelity": "dynamic", "seed": 3, "case_hash": "x", "life_key": "y", "program_version": "2", "instruction_set": "z"}, {**header, "case_hash": "w"}),
                                    folder.differences(header, header)]
            for name, prepare in {"other things": lambda path: (path.mkdir(), (path / "x.txt").write_text("x")), "a file": lambda path: path.write_text("x"), "another study": lambda path: study("many values", output=path)}.items():
                target = home / name.replace(" ", "_")
                prepare(target)
                for resume in (False, True):
                    try:
                        run.compute(core, design, FakeEngine([p.path for p in design.numbers()]), InProcess(1), life_key="life_h", output=target, resume=resume, progress=False)
                        found[f"{name}, {resume}"] = "taken"
                    except CaseError as error:
                        found[f"{name}, {resume}"] = re.sub(r"'[0-9a-f]{16}'", "'HASH'", str(error).replace(place, "DIR"))
            found["finished"] = str(refused(run.compute, core, design, FakeEngine([p.path for p in design.numbers()]), InProcess(1), life_key="life_h", output=home / "a", progress=False)).replace(place, "DIR")
            engine = FakeEngine([p.path for p in design.numbers()])
            told = []
            again = run.compute(core, design, engine, InProcess(1), life_key="life_h", output=home / "a", resume=True, warnings=["a <warning>"], progress=lambda done, points: told.append([done, points]))
            found["again"] = [len(engine.computed), again.missing, told]
            self.assertEqual(json_of(again), json_of(result))
            stopped = FakeEngine([p.path for p in design.numbers()], stop_after=2)
            with contextlib.suppress(KeyboardInterrupt):
                run.compute(core, design, stopped, InProcess(1), life_key="life_h", output=home / "c", progress=False)
            found["stopped"] = [list(folder.finished_counts(home / "c")), json.loads(json_of(open_study(home / "c")))["missing_points"], repr(open_study(home / "c"))]
            found["names"] = [folder.point_file_name(one) for one in (0, 12, 123456)]
            found["no folder"] = str(refused(open_study, home / "none")).replace(place, "DIR")
            torn = (home / "a" / folder.JOURNAL).read_bytes()
            for cut in (5, 100, len(torn) - 7):
                (home / f"cut{cut}").mkdir()
                (home / f"cut{cut}" / folder.JOURNAL).write_bytes(torn[:cut])
                found[f"cut {cut > 100}{cut == 5}"] = re.sub(r"\d{3,}", "N", str(refused(lambda path: repr(open_study(path)), home / f"cut{cut}")).replace(place, "DIR").replace(f"cut{cut}", "CUT"))
        self.check("folders", found)

    def test_portions(self):
        found = {}
        for name, missing, at_first, lanes, pace in (("grid", None, 1, 2, 0.01), ("steps", [0, 3, 5, 8, 13, 21], 4, 1, 3.0), ("many curves", None, 3, 4, 0.2), ("nothing", [1], 0, 9, 1e-9)):
            vary, options = GRIDS[name]
            design = design_of(FakeCase(), vary, **options)
            one = plan.Plan(design, np.arange(design.points) if missing is None else np.array(missing), at_first)
            rows = []
            while portion := one.next(lanes):
                rows.append([list(portion.ids), list(map(list, portion.settings)), portion.values.ravel(), one.left])
                one.learn(len(portion.ids), pace * len(portion.ids) * (1 + 0.1 * len(rows)))
            found[name] = rows
        whole = table.ResultTable(6)
        chunk = table.Chunk(np.array([1, 4, 5]), ("a", "b"), np.array([[1.0, 2.0], [3.0, np.nan], [5.0, 6.0]]), {1: "bad", 2: "worse"}, 0.5)
        added = [whole.add(chunk), whole.add(table.Chunk(np.array([4, 0, 5]), ("a", "b"), np.array([[9.0, 9.0], [7.0, 8.0], [9.0, 9.0]]), {0: "x", 1: "late"})), whole.add(chunk)]
        found["table"] = [[None if one is None else [list(one.ids), one.rows.ravel(), {str(key): value for key, value in one.statuses.items()}] for one in added], list(whole.status), list(whole.missing()), whole.failed,
                          whole.column("b"), whole.column("c"), str(refused(whole.add, table.Chunk(np.array([2]), ("a",), np.array([[1.0]]))))]
        record = table.encode(chunk)
        again = table.decode(record)
        found["coded"] = [record.head, list(again.ids), again.rows.ravel(), list(again.columns), {str(key): value for key, value in again.statuses.items()}, table.encode(added[0] and table.Chunk(np.array([2]), ("a",), np.array([[1.0]]))).head]
        self.check("portions", found)

    def test_words_of_the_command(self):
        found = {"addresses": [refused(lambda text: command._address(text), text) if re.fullmatch(r"(?:[a-z]+://)?[\w.\[\]:%-]+:([0-9]{1,5})", text) and 0 < int(text.rpartition(":")[2]) < 65536 else "refused"
                               for text in ("host:8786", "tcp://host:1", "tls://[::1]:65535", "host", "host:0", "host:65536", "a b:1")],
                 "clocks": [command._clock(one) for one in (0.4, 59.6, 61, 3599, 3600, 36061)], "cells": [command._cell(one) for one in (None, 1.23456789, 3, "x", True)],
                 "varied": [str(refused(command.varied, options)) for options in (["a.b=[1 um, 2 um]", "c={from: 1, to: 3, step: 1}"], ["a.b=1 um", "c", "d=[1,]", "e=[1]", "e=[2]", "=[1]"])]}
        options = ([], ["-o", "x"], ["--json"], ["-o", ""], ["--json", "--resume", "--points", "all"], ["-o", "x", "--scheduler", "h:1", "--jobs", "2"], ["-o", "x", "--samples", "3", "--seed", "4"], ["-o", "x", "--sampler", "lhs", "--samples", "3", "--seed", "0"])
        found["checked"] = [str(refused(lambda words: command._checked(command.parser().parse_args(["case.yaml", *words])), words)) for words in options]
        found["defaults"] = {key: str(value) for key, value in vars(command.parser().parse_args(["case.yaml"])).items()}
        found["help"] = re.sub(r"\s+", " ", command.parser().format_help())
        tables = {"plain": "bearing.rollers, bearing.bore (mm)\n14, 5.5\n\n15, 5.24\n", "twice": "bearing.rollers, bearing.rollers\n1, 2\n", "short": "bearing.rollers, film.enabled\n14\n15, true\n16,\n1,2,3\n", "empty": "", "head": "bearing.rollers\n",
                  "no paths": "secret; other\n1;2\n", "one path": "bearing.rollers;x\n1;2\n", "decimal": "bearing.bore (mm), bearing.rollers\n5,5,14\n6,25,15\n", "quoted": 'bearing.profile.kind, film.enabled\n"a, ""b""", "true"\n" c ",x\n', "mark": "\ufeffbearing.rollers\n3\n"}
        with tempfile.TemporaryDirectory() as place:
            file = pathlib.Path(place, "rows.csv")
            for name, text in tables.items():
                file.write_text(text, encoding="utf-8")
                found[f"table, {name}"] = [str(one).replace(place, "DIR") for one in (lambda got: got if isinstance(got, list) else [got])(refused(command.rows_of_table, file))]
            for name, content in (("utf-16", "\ufeffa".encode("utf-16")), ("latin", b"bearing.rollers\n3\n\xe4\n")):
                file.write_bytes(content)
                found[f"table, {name}"] = str(refused(command.rows_of_table, file)).replace(place, "DIR")
            found["table, none"] = str(refused(command.rows_of_table, pathlib.Path(place, "none.csv"))).replace(place, "DIR")
        shown = []
        with unittest.mock.patch("time.monotonic", side_effect=[float(10 * i) for i in range(40)]), unittest.mock.patch.object(command.StatusLine, "is_due", True), \
                unittest.mock.patch.object(command.StatusLine, "show", lambda self, text: shown.append(text)):
            line = command._Line(True)
            for done in (2, 2, 5, 10):
                line(done, 10)
        found["line"] = shown
        self.check("words", found)

    def test_the_command(self):
        """All of it beside a case and an engine that are made up."""
        found = {}
        core = FakeCase()
        with tempfile.TemporaryDirectory() as place:
            for name, words in {"json": ["--json"], "files": ["-o", "OUT"], "quiet": ["-o", "OUT2", "--quiet"], "samples": ["--json", "--sampler", "sobol", "--samples", "4", "--jobs", "3"]}.items():
                asked = []

                def fake(core, values, **options):
                    asked.append({key: str(value) for key, value in options.items() if key not in ("progress",)} | {"vary": values})
                    return study("grid")

                printed, said = io.StringIO(), io.StringIO()
                words = [place + "/" + one if one.startswith("OUT") else one for one in words]
                core_module = types.SimpleNamespace(load=lambda case, settings: asked.append([case, settings]) or core)
                with unittest.mock.patch.dict(sys.modules, {"orbearing._core": core_module}), unittest.mock.patch("orbearing._core", core_module, create=True), unittest.mock.patch("orbearing.studies.run.study", fake), \
                        contextlib.redirect_stdout(printed), contextlib.redirect_stderr(said):
                    code = command.run(command.parser().parse_args(["case.yaml", "--vary", "bearing.rollers=[14, 15]", "--set", "a.b=3", *words]))
                found[name] = [code, json.loads(json.dumps(asked).replace(place, "DIR")), printed.getvalue().replace(place, "DIR").replace(os.sep, "/").splitlines(), said.getvalue().splitlines()]
        self.check("command", found)


if __name__ == "__main__":
    kept_records.main(RECORDS)
