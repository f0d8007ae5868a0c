#!/usr/bin/env python3
"""`orbearing table` and orbearing.Table: errors of random queries, what is computed or refused, resumed and damaged tables."""

import copy
import pathlib
import pickle
import shutil
import tempfile
import unittest

import numpy as np

from program import LEFT_TO_FULL, REDUCER, SETS, answer, package

orbearing = package()

RPM = np.pi / 30
OVER = ["--over", "input.speed=2000 rpm..8000 rpm", "--over", "input.power=80 kW..240 kW"]
BOUND = 0.02
MIDDLE = {"speed": "4000 rpm", "power": 150e3}


def checksum(text):
    """FNV-1a, as include/orbearing/files.hpp has it."""
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = ((value ^ byte) * 0x100000001B3) % 2**64
    return f"{value:016x}"


class TableCommand(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.place = pathlib.Path(place.name)
        cls.folder = cls.place / "table"
        cls.made = answer("table", REDUCER, options=[*OVER, "--bound", BOUND, "--result=life_h", "--result=inner_load_max_N", "-o", cls.folder])
        cls.table = orbearing.Table(cls.folder)
        cls.case = orbearing.load(REDUCER)

    def computed(self, speed, power):
        columns, numbers, status = self.case.evaluate(list(self.table.inputs), np.column_stack([speed, power]))
        self.assertEqual(set(status), {"ok"})
        return {name: numbers[:, columns.index(name)] for name in self.table.results}

    def edited(self, name, change):
        """A copy of the table with another text and the check sum that belongs to it."""
        text = (self.folder / "table.json").read_text()
        content = change(text[: text.rindex(',"line_checksum"')] + "}")
        file = self.place / name
        file.write_text(f'{content[:-1]},"line_checksum":"{checksum(content)}"}}\n')
        return file

    def test_states_its_errors(self):
        self.assertEqual(self.made["within_bound_volume"], 1)
        self.assertEqual(self.made["failed_points"], 0)
        for result in self.made["results"]:
            self.assertLessEqual(result["largest_error"], BOUND)
            self.assertGreaterEqual(result["within_stated_share"], 0.99)

    def test_errors_of_random_queries(self):
        draw = np.random.default_rng(7)
        speed, power = draw.uniform(2000, 8000, 300) * RPM, draw.uniform(80e3, 240e3, 300)
        for name, values in self.computed(speed, power).items():
            found = self.table.answer(name, speed=speed, power=power)
            self.assertFalse(found.computed.any())
            error = np.abs(found.value - values)
            self.assertLessEqual(np.max(error / values), BOUND)
            self.assertLessEqual(np.max(found.error / values), 1.1 * BOUND)  # 1.1: over the value of the table
            self.assertGreaterEqual(np.mean(error <= found.error), 0.99)

    def test_forms_of_a_query(self):
        one = self.table.life_h(**MIDDLE)
        self.assertEqual(one.value.shape, ())
        grid = self.table.life_h(input_speed=np.full((2, 1), 4000 * RPM), power=["150 kW", "160 kW", "170 kW"])
        self.assertEqual(grid.value.shape, (2, 3))
        self.assertAlmostEqual(grid.value[1, 0] / one.value, 1, places=9)
        own = self.table.life_h(power=150e3)  # 6000 rpm is the case's
        self.assertEqual(own.value, self.table.life_h(speed=6000 * RPM, power=150e3).value)
        with self.assertRaisesRegex(orbearing.CaseError, "clearance: found no input"):
            self.table.life_h(clearance=0)
        with self.assertRaisesRegex(AttributeError, "no result cage_slip"):
            self.table.cage_slip()

    def test_it_can_be_copied_and_pickled(self):
        expected = self.table.life_h(**MIDDLE).value
        for again in (pickle.loads(pickle.dumps(self.table)), copy.deepcopy(self.table)):
            self.assertEqual((again.life_h(**MIDDLE).value, again.inputs), (expected, self.table.inputs))

    def test_outside_and_above_the_bound_the_program_computes(self):
        outside = self.table.life_h(speed=["4000 rpm", "9000 rpm"], power=150e3)
        self.assertEqual(outside.computed.tolist(), [False, True])
        self.assertEqual(outside.value[1], self.computed([9000 * RPM], [150e3])["life_h"][0])
        rough = self.table.life_h(**MIDDLE, bound=1e-9)
        self.assertTrue(rough.computed)
        self.assertLess(rough.error / rough.value, 1e-6)
        for query, reason in (({"speed": "9000 rpm"}, "found input.speed = 9000 rpm; required: 2000 rpm to 8000 rpm"),
                              ({"bound": 1e-9}, "found a stated error of")):
            with self.assertRaisesRegex(orbearing.CaseError, reason):
                self.table.life_h(**{**MIDDLE, **query}, compute=False)
        failed = self.table.life_h(speed="4000 rpm", power=1e12)
        self.assertTrue(np.isnan(failed.value) and failed.failures[0])

    def test_interrupted_and_resumed_on_other_threads(self):
        whole = (self.folder / "table.json").read_bytes()
        again = self.place / "again"
        shutil.copytree(self.folder, again)
        (again / "table.json").unlink()
        lines = (again / "manifest.jsonl").read_bytes().splitlines(keepends=True)
        (again / "manifest.jsonl").write_bytes(b"".join(lines[: len(lines) // 2]))
        options = [*OVER, "--bound", BOUND, "--result=life_h", "--result=inner_load_max_N", "-o", again, "--resume", "--jobs=1"]
        resumed = answer("table", REDUCER, options=options)
        self.assertEqual(resumed, self.made)
        self.assertEqual((again / "table.json").read_bytes(), whole)

    def test_damaged_and_of_another_version(self):
        damaged = self.place / "damaged.json"
        damaged.write_text((self.folder / "table.json").read_text().replace("0", "1", 1))
        with self.assertRaisesRegex(orbearing.CaseError, "found no undamaged table"):
            orbearing.Table(damaged)
        self.assertEqual(orbearing.Table(self.edited("same.json", lambda text: text)).life_h(**MIDDLE).value, self.table.life_h(**MIDDLE).value)
        former = orbearing.Table(self.edited("former.json", lambda text: text.replace('"program_version":"', '"program_version":"0.0.')))
        self.assertEqual(former.life_h(**MIDDLE).value, self.table.life_h(**MIDDLE).value)
        with self.assertRaisesRegex(orbearing.CaseError, "found a table of version 0.0."):
            former.life_h(speed="9000 rpm")

    def test_of_one_of_several_sets(self):
        name = "sets.reduction.life_h"
        made = answer("table", SETS, options=["--over", "input.power=100 kW..150 kW", "--points=80", f"--result={name}", "-o", self.place / "sets"])
        self.assertLessEqual(made["results"][0]["largest_error"], 0.01)
        found = orbearing.Table(self.place / "sets").answer(name, power="120 kW")
        columns, numbers, _ = orbearing.load(SETS).evaluate(["input.power"], [[120e3]])
        self.assertAlmostEqual(found.value / numbers[0, columns.index(name)], 1, delta=0.01)
        self.assertFalse(found.computed)

    @unittest.skipIf(LEFT_TO_FULL, "runs in motion")
    def test_in_motion(self):
        folder = self.place / "moving"
        made = answer("table", REDUCER, options=["--over", "input.power=140 kW..160 kW", "--fidelity=dynamic", "--points=14", "--bound=0.05", "-o", folder])
        self.assertLessEqual(made["points"], 14)
        self.assertGreaterEqual(made["scatter"], 3e-3)
        self.assertEqual(len(list((folder / "points").glob("*.nc"))), made["points"])
        found = orbearing.Table(folder).life_h(power="150 kW", bound=1.0)
        self.assertFalse(found.computed)
        self.assertGreaterEqual(found.error, 2.9e-3 * found.value)


if __name__ == "__main__":
    unittest.main()
