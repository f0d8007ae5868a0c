#!/usr/bin/env python3
"""Studies without a bearing: designs, the journal cut or damaged anywhere, resume, the same store whatever computes it."""

import contextlib
import io
import itertools
import json
import os
import pathlib
import random
import tempfile
import types
import unittest
import unittest.mock

import netCDF4
import numpy as np
import xarray

from orbearing.errors import CaseError
from orbearing.studies import journal, open_study
from orbearing.studies.design import design_of, from_content, stated_values
from orbearing.studies.executors import InProcess, Threads
from orbearing.studies.folder import DATASET, JOURNAL, finished_counts
from orbearing.studies.plan import LEAST_SECONDS, USUAL_SECONDS, Plan
from orbearing.studies.result import json_of
from orbearing.studies.run import _teller, compute
from orbearing.studies.__main__ import rows_of_table, varied
from study_fake import FakeCase, FakeEngine

GRID = {"bearing.radial_clearance": ["0 um", "0.01 mm", "66 um", "30 um"], "bearing.profile.kind": ["straight", "iso16281"]}


class Shuffled:
    """Portions of random lengths in random order, one of them given twice."""

    def __init__(self, seed, most=5):
        self._chance, self._most = random.Random(seed), most

    def run(self, engine, plan, keep):
        plan._largest = self._most
        portions = []
        while portion := plan.next(1):
            portions.append(portion)
            plan._largest = self._chance.randint(1, self._most)
        self._chance.shuffle(portions)
        for portion in portions:
            keep(engine.compute(portion.ids, portion.settings, portion.values, 1))
        keep(engine.compute(portions[0].ids, portions[0].settings, portions[0].values, 1))


def study(folder=None, executor=None, grid=GRID, resume=False, version="1", stop_after=None, case=None, life_key="life_h", **options):
    """Result and engine."""
    case = case or FakeCase()
    design = design_of(case, grid, **options)
    engine = FakeEngine([p.path for p in design.numbers()], version, stop_after)
    return compute(case, design, engine, executor or InProcess(1), life_key=life_key, output=folder, resume=resume, progress=False), engine


def contents(folder):
    return {path.relative_to(folder): (path.read_bytes(), path.stat().st_mtime_ns) for path in folder.rglob("*") if path.is_file()}


class InFolder(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)


class Designs(unittest.TestCase):
    def test_a_grid_is_numbered_as_an_array_the_speed_fastest(self):
        design = design_of(FakeCase(), GRID)
        self.assertEqual(design.dimensions, (("bearing.radial_clearance", 4), ("bearing.profile.kind", 2), ("input.speed", 3)))
        expected = list(itertools.product(GRID["bearing.radial_clearance"], GRID["bearing.profile.kind"], ("1000 rpm", "2000 rpm", "3000 rpm")))
        self.assertEqual([tuple(text for _, text in design.settings(number, every=True)) for number in range(design.points)], expected)

    def test_coordinates_are_in_the_customary_unit(self):
        clearance = design_of(FakeCase(), GRID).parameters[0]
        self.assertEqual((clearance.unit, clearance.values.tolist()), ("um", [0.0, 10.0, 66.0, 30.0]))
        warm = design_of(FakeCase(), {"lubricant.temperature": ["353.15 K", "300 K"]}).parameters[0]
        np.testing.assert_allclose(warm.values, [80.0, 26.85], rtol=1e-12)
        bore = design_of(FakeCase(), {"bearing.bore": ["25000 um", "30 mm"]}).parameters[0]
        self.assertEqual((bore.unit, bore.values.tolist()), ("mm", [25.0, 30.0]), "1 mm is out of range")

    def test_values_in_every_form(self):
        def texts(stated):
            return design_of(FakeCase(), {"bearing.radial_clearance": stated}).parameters[0].texts

        self.assertEqual(texts({"from": "0 um", "to": "30 um", "step": "10 um"}), ("0 um", "10 um", "20 um", "30 um"))
        self.assertEqual(texts({"from": "0 um", "to": "1 um", "count": 3}), ("0 um", "0.5 um", "1 um"))
        self.assertEqual(texts((np.array([0.0, 2.5]), "um")), ("0 um", "2.5 um"))
        self.assertEqual(stated_values("[1 um, [2, 3], 'a']"), ["1 um", "[2, 3]", "a"])

    def test_rows_of_a_table_go_together_beside_a_grid(self):
        rows = [{"bearing.rollers": 14, "bearing.profile.kind": "straight"}, {"bearing.rollers": 15, "bearing.profile.kind": "iso16281"}]
        design = design_of(FakeCase(), {"bearing.radial_clearance": ["0 um", "10 um"]}, paired=rows)
        self.assertEqual(design.dimensions, (("row", 2), ("bearing.radial_clearance", 2), ("input.speed", 3)))
        together = {(dict(design.settings(n, True))["bearing.rollers"], dict(design.settings(n, True))["bearing.profile.kind"]) for n in range(design.points)}
        self.assertEqual(together, {("14", "straight"), ("15", "iso16281")})

    def test_samples(self):
        ranges = {"bearing.radial_clearance": {"from": "0 um", "to": "40 um"}, "film.enabled": [True, False]}
        lhs = design_of(FakeCase(), ranges, sampler="lhs", samples=50, seed=3)
        self.assertEqual(lhs.dimensions, (("sample", 50), ("input.speed", 3)))
        # A Latin hypercube has one value in each of so many equal parts, and as many of each choice.
        self.assertEqual(sorted((lhs.parameters[0].values / 40 * 50).astype(int)), list(range(50)))
        self.assertEqual(lhs.parameters[1].texts.count("true"), 25)
        self.assertEqual(design_of(FakeCase(), ranges, sampler="lhs", samples=50, seed=3).summary(), lhs.summary())
        self.assertNotEqual(design_of(FakeCase(), ranges, sampler="lhs", samples=50, seed=4).summary()["parameters"], lhs.summary()["parameters"])
        # One of 2^m Sobol points is in each of 2^m equal parts of each axis.
        sobol = design_of(FakeCase(), ranges, sampler="sobol", samples=64, seed=3)
        self.assertEqual(sorted((sobol.parameters[0].values / 40 * 64).astype(int)), list(range(64)))

    def test_a_stated_speed_replaces_the_cases(self):
        design = design_of(FakeCase(), {"input.speed": ["500 rpm"], "bearing.rollers": [14, 15]})
        self.assertEqual(design.dimensions, (("bearing.rollers", 2), ("input.speed", 1)))
        alone = design_of(FakeCase(speeds=()), {"bearing.rollers": [14, 15]})
        self.assertEqual(alone.parameters[-1].texts, ("6000 rpm",))

    def test_its_content_is_all_of_it(self):
        design = design_of(FakeCase(), GRID)
        again = from_content(json.loads(json.dumps(design.content())))
        self.assertEqual((again.summary(), again.dimensions), (design.summary(), design.dimensions))
        np.testing.assert_array_equal(again.values(np.arange(24)), design.values(np.arange(24)))

    def test_what_cannot_be_is_refused(self):
        one = {"bearing.radial_clearance": ["0 um"]}
        for vary, options, part in (
                ({"bearing.clearance": ["0 um"]}, {}, "does not have"), ({"bearing.radial_clearance": []}, {}, "empty list"),
                ({"bearing.radial_clearance": ["0 um", "0 um"]}, {}, "is listed twice"), ({"bearing.radial_clearance": "0 um"}, {}, "a list of values"),
                ({"bearing.radial_clearance": [5]}, {}, "unit"), ({"bearing.rollers": ["-3"]}, {}, "bearing.rollers: found '-3'"),
                ({"bearing.radial_clearance": {"from": "0 um", "to": "5 um", "step": "2 um"}}, {}, "does not end"),
                ({"bearing.radial_clearance": {"from": "0 um", "to": "5 mm", "count": 3}}, {}, "one unit"),
                ({"bearing.radial_clearance": {"from": "0 um", "to": "5 um"}}, {}, "step"), (one, {"sampler": "random"}, "grid, sobol or lhs"),
                (one, {"samples": 3}, "samples"), (one, {"sampler": "lhs"}, "samples"), (one, {"sampler": "sobol", "samples": 100}, "64 or 128"),
                ({}, {"sampler": "lhs", "samples": 3}, "at least one"), (one, {"paired": [{"bearing.radial_clearance": "1 um"}]}, "one of both"),
                ({}, {"paired": [{"bearing.rollers": 14}, {"film.enabled": True}]}, "row 2"),
                ({"bearing.rollers": {"from": 13, "to": 15}}, {"sampler": "lhs", "samples": 3}, "whole number")):
            with self.subTest(vary=vary, **options), self.assertRaises(CaseError) as caught:
                design_of(FakeCase(), vary, **options)
            self.assertIn(part, str(caught.exception))

    def test_options_of_the_command_line(self):
        self.assertEqual(varied(["a.b=[1 um, 2 um]", "c={from: 1, to: 3, step: 1}"]), {"a.b": ["1 um", "2 um"], "c": {"from": "1", "to": "3", "step": "1"}})
        with self.assertRaises(CaseError) as caught:
            varied(["a.b=1 um", "c", "d=[1,]", "e=[1]", "e=[2]"])
        self.assertEqual(len(caught.exception.messages), 4)
        with tempfile.TemporaryDirectory() as place:
            table = pathlib.Path(place) / "rows.csv"
            table.write_text("bearing.rollers, bearing.roller_diameter (mm)\n14, 5.5\n15, 5.24\n")
            self.assertEqual(rows_of_table(table)[1], {"bearing.rollers": "15", "bearing.roller_diameter": "5.24 mm"})
            table.write_text("bearing.rollers, bearing.rollers\n14, 5.5\n")
            with self.assertRaises(CaseError):
                rows_of_table(table)
            table.write_text("bearing.rollers, film.enabled\n14\n15, true\n16,\n")
            with self.assertRaises(CaseError) as caught:
                rows_of_table(table)
            self.assertEqual(len(caught.exception.messages), 2)


class Portions(unittest.TestCase):
    def test_each_point_once_and_of_the_wanted_length(self):
        design = design_of(FakeCase(), {"bearing.radial_clearance": {"from": "0 um", "to": "40 um"}}, sampler="lhs", samples=4000)
        plan = Plan(design, np.arange(0, design.points, 2))
        pace, lengths, seen = 2e-3, [], []
        while portion := plan.next(4):
            seen += portion.ids.tolist()
            lengths.append(pace * len(portion.ids))
            plan.learn(len(portion.ids), lengths[-1])
        self.assertEqual(sorted(seen), list(range(0, design.points, 2)))
        self.assertLess(lengths[0], 0.01, "the first portion is short: its result comes soon")
        settled = lengths[5:-1]
        self.assertTrue(all(0.99 * LEAST_SECONDS <= one <= 1.01 * USUAL_SECONDS for one in settled), settled)

    def test_points_of_a_portion_share_all_that_is_no_number(self):
        design = design_of(FakeCase(), {"bearing.radial_clearance": ["0 um", "5 um"], "bearing.profile.kind": ["straight", "iso16281"]})
        plan = Plan(design, np.arange(design.points), 100)
        while portion := plan.next(1):
            for number in portion.ids:
                self.assertEqual(design.settings(int(number)), portion.settings)


class Stores(InFolder):
    def test_the_same_bytes_whatever_computes_it(self):
        study(self.place / "a", Shuffled(0))
        for name, executor in {"b": InProcess(1), "c": Threads(1), "d": Threads(3), "e": Shuffled(7), "f": Shuffled(8)}.items():
            _, engine = study(self.place / name, executor)
            self.assertEqual((self.place / name / DATASET).read_bytes(), (self.place / "a" / DATASET).read_bytes(), name)
            self.assertEqual(finished_counts(self.place / name).tolist(), [1] * 24, "a point given twice is kept once")

    def test_what_it_holds(self):
        result, _ = study(self.place / "a")
        with xarray.open_dataset(self.place / "a" / DATASET) as stored:
            stored.load()
        self.assertTrue(stored.identical(result.to_xarray()))
        self.assertTrue(stored.identical(open_study(self.place / "a").to_xarray()))
        self.assertEqual(stored.life_h.dims, ("bearing.radial_clearance", "bearing.profile.kind", "input_speed_rpm"))
        self.assertEqual((stored["bearing.radial_clearance"].attrs["units"], stored["input_speed_rpm"].attrs["units"], stored.life_h.attrs["units"]), ("um", "rpm", "h"))
        self.assertNotIn("power_loss_W", stored, "a column without a number is left out")
        crowned = stored.sel({"bearing.radial_clearance": 30.0, "bearing.profile.kind": "iso16281"})
        np.testing.assert_allclose(crowned.life_h, 2e4 / np.array([5.0, 2.0, 1.0]) / 4.0, rtol=1e-12)
        self.assertEqual((float(crowned.peak_speed_rpm), float(crowned.peak_life_h)), (3000.0, float(crowned.life_h[-1])))
        self.assertEqual(int(crowned.peak_point), 23)
        with netCDF4.Dataset(self.place / "a" / DATASET) as file:
            self.assertEqual(file.Conventions, "CF-1.10")
            self.assertEqual(file["life_h"].units, "h")

    def test_points_that_fail_say_why_and_have_no_peak(self):
        result, _ = study()
        bad = result.to_xarray().sel({"bearing.radial_clearance": 66.0})
        self.assertEqual(set(bad.status.values.ravel()), {"no equilibrium"})
        self.assertTrue(np.isnan(bad.life_h).all() and np.isnan(bad.peak_life_h).all() and np.isnan(bad.peak_speed_rpm).all())
        self.assertEqual((result.failed, result.missing, result.failures()), (6, 0, {"no equilibrium": 6}))
        records = result.variants()
        self.assertEqual(records[4], {"bearing.radial_clearance": 66.0, "bearing.profile.kind": "straight", "peak_speed_rpm": None, "peak_life_h": None, "failed_points": 3})
        self.assertEqual(records[0]["peak_life_h"], 1e4)

    def test_peaks_go_by_the_governing_life(self):
        """5e6/n h at n rpm is longest at the lowest speed, where life_h is shortest."""
        for folder in (None, self.place / "rated"):
            result, _ = study(folder, life_key="L10mrh")
            found = result.to_xarray() if folder is None else open_study(folder).to_xarray()
            self.assertEqual((result.life_key, found.life_key), ("L10mrh", "L10mrh"))
            best = found.sel({"bearing.radial_clearance": 30.0, "bearing.profile.kind": "straight"})
            self.assertEqual((float(best.peak_speed_rpm), float(best.peak_life_h), int(best.peak_point)), (1000.0, 5000.0, 18))
            self.assertEqual(found.peak_life_h.attrs["long_name"], "longest L10mrh over the grid of speeds")
            self.assertEqual(found.L10mrh.attrs, {"units": "h", "long_name": "modified reference rating life of ISO 16281 of one bearing, life.reliability"})
            self.assertEqual(found.life_h.attrs["long_name"], "Lundberg-Palmgren life of one bearing, 90 % reliability")
        self.assertEqual(json.loads(json_of(result))["life_key"], "L10mrh")
        self.assertEqual([axes.get_ylabel() for axes in result.plot().figure.axes], ["L10mrh of one bearing (h)"])
        self.assertIn("longest L10mrh is 5,000 h", result.report(self.place / "page.html").read_text(encoding="utf-8"))
        alone, _ = study(grid={"input.speed": {"from": "1000 rpm", "to": "3000 rpm"}, "bearing.rollers": [14, 15]}, sampler="lhs", samples=16, life_key="L10mrh")
        self.assertEqual(list(alone.variants()[0]), ["input.speed", "bearing.rollers", "L10mrh", "failed_points"])

    def test_pictures_and_page(self):
        result, _ = study(self.place / "a")
        self.assertEqual(len(result.plot().lines), 8)
        page = result.report(self.place / "page.html").read_bytes()
        self.assertTrue(b"<svg" in page and b"no equilibrium" in page)
        again, _ = study(self.place / "b", Threads(2))
        self.assertTrue(again.report(self.place / "page2.html").read_bytes() == page, "the same results give the same bytes")
        many, _ = study(grid={"bearing.radial_clearance": {"from": "0 um", "to": "40 um"}}, sampler="lhs", samples=100)
        self.assertEqual(len(many.plot().lines), 1, "of very many curves the median and bands")
        alone, _ = study(grid={"input.speed": {"from": "1000 rpm", "to": "3000 rpm"}, "bearing.rollers": [14, 15]}, sampler="lhs", samples=16)
        self.assertNotIn("peak_life_h", alone.to_xarray(), "where the speed is a sample's value no variant has a curve")
        self.assertTrue(alone.plot().lines)


class Progress(unittest.TestCase):
    def test_a_bar_has_the_points_that_are_done(self):
        class Bar:
            def __init__(self, total, **_):
                self.total, self.n, self.closed = total, 0, False

            def update(self, more):
                self.n += more

            def close(self):
                self.closed = True

        made = []
        fake = types.SimpleNamespace(tqdm=lambda **how: made.append(Bar(**how)) or made[-1])
        with unittest.mock.patch.dict("sys.modules", {"tqdm": types.SimpleNamespace(auto=fake), "tqdm.auto": fake}):
            tell = _teller(True, 24)
        for done in (3, 10, 24):
            self.assertFalse(made[0].closed)
            tell(done, 24)
            self.assertEqual(made[0].n, done)
        self.assertEqual((made[0].total, made[0].closed), (24, True))


class Interrupted(InFolder):
    """The journal cut at any byte is what a kill at any moment leaves."""

    def setUp(self):
        super().setUp()
        study(self.place / "whole", Shuffled(1, most=8))
        self.whole = (self.place / "whole" / DATASET).read_bytes()
        self.journal = (self.place / "whole" / JOURNAL).read_bytes()

    def resumed(self, data):
        """A folder with this journal, gone on with: engine, and how many points it had."""
        folder = self.place / "cut"
        folder.mkdir(exist_ok=True)
        for old in folder.iterdir():
            old.unlink()
        (folder / JOURNAL).write_bytes(data)
        kept = sum(record.head["points"] for record in journal.read(folder / JOURNAL).records[1:])
        _, engine = study(folder, resume=True)
        return folder, engine, kept

    def test_cut_anywhere(self):
        places = random.Random(5).sample(range(len(self.journal)), 60) + list(range(len(self.journal) - 20, len(self.journal) + 1))
        keeping = 0
        for length in places:
            with self.subTest(length=length):
                folder, engine, kept = self.resumed(self.journal[:length])
                self.assertEqual(len(engine.computed), 24 - kept, "what was finished is not computed again")
                self.assertEqual(finished_counts(folder).tolist(), [1] * 24)
                self.assertEqual((folder / DATASET).read_bytes(), self.whole)
                keeping += 0 < kept < 24
        self.assertGreater(keeping, 20)

    def test_damaged_anywhere(self):
        # A byte changed is found: the record is left out and computed again, or the folder is refused.
        found = 0
        for place in random.Random(6).sample(range(len(self.journal)), 80):
            with self.subTest(place=place):
                data = bytearray(self.journal)
                data[place] ^= 0x15
                try:
                    with contextlib.redirect_stderr(io.StringIO()) as said:
                        folder, _, kept = self.resumed(bytes(data))
                except CaseError:
                    continue
                found += "damaged record; its points are computed again" in said.getvalue()
                self.assertLess(kept, 24)
                self.assertEqual((folder / DATASET).read_bytes(), self.whole)
        self.assertGreater(found, 5)

    def test_a_damaged_last_record_is_a_torn_one(self):
        """All others are damaged ones, by the byte at which they begin; what follows them is read."""
        heads = [{"number": number} for number in range(3)]
        records = [journal.encoded(journal.Record(head, b"payload " * (4 + head["number"]))) for head in heads]
        file = self.place / "three"
        begins = [sum(map(len, records[:number])) for number in range(3)]
        for number, expected in ((0, ([1, 2], [begins[0]], sum(map(len, records)))), (1, ([0, 2], [begins[1]], sum(map(len, records)))),
                                 (2, ([0, 1], [], begins[2]))):
            with self.subTest(record=number):
                data = bytearray(b"".join(records))
                data[begins[number] + len(records[number]) - 5] ^= 0x15  # in its payload
                file.write_bytes(bytes(data))
                found = journal.read(file)
                self.assertEqual(([one.head["number"] for one in found.records], found.damaged, found.sound_bytes), expected)

    def test_interrupted_and_gone_on_with(self):
        folder = self.place / "stopped"
        with self.assertRaises(KeyboardInterrupt):
            study(folder, stop_after=2)
        part = open_study(folder)
        self.assertTrue(0 < part.missing < 24)
        with xarray.open_dataset(folder / DATASET) as stored:
            self.assertEqual(int((stored.status == "not computed").sum()), part.missing)
        _, engine = study(folder, resume=True)
        self.assertEqual(len(engine.computed), part.missing)
        self.assertEqual((folder / DATASET).read_bytes(), self.whole)
        _, engine = study(folder, resume=True)
        self.assertEqual(engine.computed, [], "a finished study is read")

    def test_refused_and_untouched(self):
        folder = self.place / "whole"
        before = contents(folder)
        for changed, part in (({"case": FakeCase(name="other")}, "case 'fake' was found"), ({"case": FakeCase(given={"bearing.rollers": "14"})}, "hash"),
                              ({"version": "2"}, "program version"), ({"grid": {**GRID, "bearing.radial_clearance": ["0 um", "0.01 mm", "66 um", "31 um"]}}, "radial_clearance"),
                              ({"grid": {"bearing.rollers": [14]}}, "number of points"), ({"life_key": "L10mrh"}, "governing life 'life_h' was found; 'L10mrh' is required"),
                              ({"resume": False}, "--resume to continue")):
            with self.subTest(part), self.assertRaises(CaseError) as caught:
                study(folder, **{"resume": True, **changed})
            self.assertIn(part, str(caught.exception))
            self.assertEqual(contents(folder), before)

    def test_a_folder_of_other_things_is_refused(self):
        for name in ("manifest.jsonl", "notes.txt"):
            folder = self.place / name.partition(".")[0]
            folder.mkdir()
            (folder / name).write_text("{}\n")
            for resume in (False, True):
                with self.assertRaises(CaseError):
                    study(folder, resume=resume)
            self.assertEqual([path.name for path in folder.iterdir()], [name])
        (self.place / "file").write_text("")
        with self.assertRaises(CaseError):
            study(self.place / "file")

    def test_one_writer(self):
        with self.assertRaises(CaseError) as caught:
            held = journal.Journal(self.place / "whole" / JOURNAL)
            self.addCleanup(held.close)
            study(self.place / "whole", resume=True)
        self.assertIn("another run is writing here", str(caught.exception))

    def test_a_disk_that_takes_no_more(self):
        folder = self.place / "full"
        real, room = os.write, len(self.journal) - 200

        def write(file, data):
            nonlocal room
            if room <= 0:
                raise OSError(28, "No space left on device")
            written = real(file, bytes(data)[:min(room, 100)])
            room -= written
            return written

        os.write = write
        try:
            with self.assertRaises(OSError):
                study(folder, Shuffled(1, most=8))
        finally:
            os.write = real
        found = journal.read(folder / JOURNAL)
        self.assertEqual((found.damaged, found.sound_bytes), ([], (folder / JOURNAL).stat().st_size), "what was not written whole is taken back")
        self.assertTrue(0 < open_study(folder).missing < 24)
        study(folder, resume=True)
        self.assertEqual((folder / DATASET).read_bytes(), self.whole)


if __name__ == "__main__":
    unittest.main(verbosity=2)
