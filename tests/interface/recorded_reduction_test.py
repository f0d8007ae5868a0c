#!/usr/bin/env python3
"""What the record of an answer notices and what it leaves out (recorded_reduction.py)."""

import copy
import math
import pathlib
import subprocess
import tempfile
import unittest

from recorded_reduction import Reduction, differences, reduced_run, spread_of

ANSWER = {"points": [{"life_h": 100.0 + 7 * i, "load_N": 5000.0 - i, "status": "ok"} for i in range(12)], "stiffness": [[1e8, 2.0], [3.0, 4e5]],
          "derived": [{"path": "a", "value": 2.1e11, "unit": "Pa"}, {"path": "b", "value": 3e-6, "unit": "m"}], "peak": None, "units": {"life_h": "h"},
          "warnings": ["bearing: the load of 5000 N is above 4000 N, which is too much"], "versions": {"program": "1"}}


def record(answer, with_words=True):
    into = Reduction(with_words)
    into.add("", answer)
    return {"exit": 0, "found": into.record()}


def changed(change):
    other = copy.deepcopy(ANSWER)
    change(other)
    return other


class RecordedReduction(unittest.TestCase):
    def paths(self, change, **more):
        return [text.split(": on record")[0] for text in differences(record(ANSWER, **more), record(changed(change), **more))]

    def test_the_same_does_not_differ(self):
        self.assertEqual(self.paths(lambda answer: None), [])
        self.assertEqual(self.paths(lambda answer: answer["versions"].update(program="2")), [])

    def test_a_number(self):
        self.assertEqual(self.paths(lambda answer: answer["points"][3].update(life_h=121.01)), ["points[].life_h"])
        self.assertEqual(self.paths(lambda answer: answer["points"][3].update(life_h=121.0 * (1 + 1e-9))), [])

    def test_a_swap_and_a_shift(self):
        def swap(answer):
            first, second = answer["points"][2], answer["points"][5]
            first["life_h"], second["life_h"] = second["life_h"], first["life_h"]

        self.assertEqual(self.paths(swap), ["points[].life_h"])
        self.assertEqual(self.paths(lambda answer: answer["points"].insert(0, answer["points"].pop())), ["points[].life_h", "points[].load_N"])

    def test_small_numbers_beside_large_ones(self):
        self.assertEqual(self.paths(lambda answer: answer["stiffness"][0].__setitem__(1, 2.1)), ["stiffness[0][1]"])
        self.assertEqual(self.paths(lambda answer: answer["derived"][1].update(value=4e-6)), ["derived[]<b>.value"])

    def test_names_units_and_nothing(self):
        self.assertEqual(self.paths(lambda answer: answer["units"].update(life_h="s")), ["units.life_h (texts)"])
        self.assertEqual(self.paths(lambda answer: answer["points"][0].update(status="failed")), ["points[].status (texts)"])
        self.assertEqual(self.paths(lambda answer: answer.update(peak=math.nan)), [])
        self.assertEqual(self.paths(lambda answer: answer.update(peak=1.0)), ["peak", "peak (nothing)"])

    def test_sentences(self):
        def other_unit(answer):
            answer["warnings"][0] = answer["warnings"][0].replace("4000 N", "4000 kN")

        self.assertEqual(len(self.paths(other_unit)), 3)  # its words, and its numbers under another name
        self.assertEqual(self.paths(other_unit, with_words=False), [])
        self.assertEqual(self.paths(lambda answer: answer["warnings"].pop(), with_words=False), ["warnings (nothing)", "warnings[] (sentences)"])

    def test_what_round_off_changes_is_compared_by_that(self):
        first, second = record(ANSWER), record(changed(lambda answer: answer["points"][3].update(life_h=121.05)))
        first["spread"] = spread_of(first, [second])
        self.assertEqual(list(first["spread"]), ["points[].life_h"])
        self.assertEqual(list(differences(first, record(changed(lambda answer: answer["points"][3].update(life_h=121.2))))), [])
        self.assertEqual(len(list(differences(first, record(changed(lambda answer: answer["points"][3].update(life_h=130.0)))))), 1)

    def test_round_off_of_what_is_zero_in_a_matrix(self):
        before, now = ({"stiffness": [[1e8, small], [small, 4e5]], "alone": alone} for small, alone in ((6e-12, 3e-12), (-7e-12, 3e-12)))
        self.assertEqual(list(differences(record(before), record(now))), [])
        self.assertEqual(len(list(differences(record(before), record(now | {"alone": 4e-12})))), 1)

    def test_choices_of_a_motion_that_magnifies_round_off(self):
        def chosen(answer):
            answer["points"][0].update(steady=False)
            answer["warnings"].append("simulation.most_revolutions: 2 revolutions ended before the means were steady")

        first, other = ({"exit": 0, "found": found["found"]} for found in (record(ANSWER | {"points": [one | {"steady": True} for one in ANSWER["points"]]}),
                                                                              record(changed(chosen))))
        self.assertGreater(len(list(differences(first, other))), 1)
        first["spread"] = {f"one.{number}": 1e-3 for number in range(8)}
        self.assertEqual(list(differences(first, other)), [])
        self.assertEqual(len(list(differences(first, record(changed(lambda answer: answer["points"][0].update(life_h=500.0)))))), 1)

    def test_numbers_to_their_last_bit(self):
        one, other = Reduction(), Reduction()
        one.add_text("model", "displacement.x 1 1.b6019f76b2965p-19\n")
        other.add_text("model", "displacement.x 1 1.b6019f76b2966p-19\n")
        self.assertEqual(list(differences({"found": one.record()}, {"found": other.record()})), [])
        other.add_text("model", "displacement.x 1 1.c6019f76b2965p-19\n")
        self.assertNotEqual(list(differences({"found": one.record()}, {"found": other.record()})), [])

    def test_files_and_messages(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            (folder / "a.csv").write_text("# made up\nspeed [rpm],status\n100,ok\n200,\n", encoding="utf-8")
            done = subprocess.CompletedProcess([], 1, "", f"{folder}/case.yaml: wrong\n")
            found = reduced_run(done, folder, pathlib.Path("/nowhere"), True)
        self.assertEqual(found["messages"], ["FOLDER/case.yaml: wrong"])
        self.assertEqual(found["found"]["a.csv: speed [rpm]"][::2], [2, 300.0])
        self.assertEqual(found["found"]["a.csv: status (nothing)"], 1)


if __name__ == "__main__":
    unittest.main()
