#!/usr/bin/env python3
"""The validation guide: its statistics, its page, and the record of the last validation.

Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from dataclasses import replace

from orbearing import validation
from orbearing.validation.guide import calibration_text, counts_table, first_table, from_memory, guide, misses, percent, rows_table, statistics_table
from orbearing.validation import readme
from orbearing.validation.record import write_record
from orbearing.validation.rows import is_friction_slip_or_sharing
from program import CASES

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
RECORDED = SOURCE / "docs" / "validation" / "rows.json"

ROW = validation.Row(case="c", source="[A2000], Table 1", kind="measurement", of="slip", quantity="q", meaning="m", reading="", published=2.0,
                     ours=2.2, tolerance=0.05, scatter=0.03, band=None, verdict="missed", why="", memory=False, fitted=False)


def band(low_90, low_50, high_50, high_90):
    return {"low_90": low_90, "low_50": low_50, "high_50": high_50, "high_90": high_90, "samples": 9, "lost": 0}


class Numbers(unittest.TestCase):
    def test_bias_and_deviation_are_those_of_the_logarithm(self):
        rows = [replace(ROW, published=1.0, ours=math.exp(x), scatter=s) for x, s in ((0.1, 0.03), (0.3, None))]
        found = validation.statistics(rows)
        self.assertAlmostEqual(found.bias, 0.2)
        self.assertAlmostEqual(found.deviation, 0.1 * math.sqrt(2.0))
        self.assertAlmostEqual(found.of_measurement, 0.03)
        self.assertAlmostEqual(found.of_model, math.sqrt(0.02 - 0.03**2))

    def test_no_ratio_of_zero_or_of_nothing(self):
        for row in (replace(ROW, ours=None), replace(ROW, published=0.0), replace(ROW, ours=-1.0), replace(ROW, of="trend")):
            self.assertIsNone(row.log_ratio)
        self.assertIsNone(validation.statistics([replace(ROW, ours=None)]).bias)

    def test_values_are_distinguished_by_source_value_and_settings(self):
        rows = [ROW, replace(ROW, case="other", quantity="again"), replace(ROW, published=3.0), replace(ROW, reading="a=1, b=2"),
                replace(ROW, reading="b=2, a=1"), replace(ROW, source="[A2000], Table 2")]
        self.assertEqual(len(validation.distinct(rows)), 4)

    def test_lines_of_passing_elements_count_once_a_bearing(self):
        """The line of the median deviation, of each case and kind."""
        line = replace(ROW, of="characteristic frequency", published=100.0)
        rows = [ROW, replace(line, ours=101.0, meaning="a"), replace(line, ours=100.1, meaning="b"), replace(line, ours=93.0, meaning="c"),
                replace(line, case="other bearing", ours=100.0), replace(line, kind="program", ours=100.0)]
        kept = validation.once_a_bearing(rows)
        self.assertEqual([(row.case, row.kind, row.ours) for row in kept],
                         [("c", "measurement", 2.2), ("c", "measurement", 101.0), ("other bearing", "measurement", 100.0), ("c", "program", 100.0)])

    def test_calibration_counts_measurements_within_bands(self):
        rows = [replace(ROW, band=band(1.0, 1.9, 2.1, 3.0)), replace(ROW, band=band(1.9, 2.1, 2.2, 2.3)), replace(ROW, band=band(3, 4, 5, 6)),
                ROW, replace(ROW, band=band(1, 1, 9, 9), fitted=True), replace(ROW, band=band(1, 1, 9, 9), kind="program")]
        found = validation.calibration(rows)
        self.assertEqual((found.values, found.in_50, found.in_90), (3, 1, 2))

    def test_a_band_is_widened_by_the_scatter_of_the_measurement(self):
        """Ours 2.0, half widths 0.03 by inputs and 1.64485 x 0.02 x 2 = 0.0658 by the measurement: 0.0723 together."""
        row = replace(ROW, ours=2.0, scatter=0.02, band=band(1.97, 1.99, 2.01, 2.03))
        for published, within in ((2.072, 1), (2.073, 0), (1.928, 1), (1.927, 0)):
            found = validation.calibration([replace(row, published=published)])
            self.assertEqual((found.in_90, found.in_both_90), (0, within))

    def test_percent_of_a_logarithm(self):
        self.assertEqual(percent(math.log(1.3), True), "+30.0 %")
        self.assertEqual(percent(math.log(0.999)), "-0.10 %")


class Page(unittest.TestCase):
    def test_it_shows_misses_memory_and_pictures(self):
        rows = [ROW, replace(ROW, meaning="known", published=5.0, ours=6.0, why="thermal"), replace(ROW, meaning="remembered", published=7.0, memory=True)]
        text, pictures = guide(rows, "| [A2000] | A. Author: formula (from memory) |\n| [B] | B. Author: read |\n")
        misses = text.split("## Misses")[1].split("## ")[0]
        self.assertIn("not understood", misses)
        self.assertIn("thermal", misses)
        self.assertNotIn("remembered", misses)
        counts = text.split("## What counts")[1].split("## ")[0]
        self.assertIn("| measurement | 2 | 1 | 0 | 0 | 2 | 0 | yes |", counts)
        self.assertIn("remembered", text.split("## Remembered")[1])
        self.assertEqual(list(pictures), ["slip.png"])

    def test_references_from_memory(self):
        self.assertIn("[X1]", from_memory("| [X1] | some, cited from memory |\n| [Y2] | read |\n"))
        self.assertNotIn("[Y2]", from_memory("| [X1] | some, cited from memory |\n| [Y2] | read |\n"))

    def test_it_is_a_program(self):
        """python3 -m orbearing.validation, which tools/validation calls."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "rows.json"
            write_record([ROW, replace(ROW, published=3.0)], file)
            done = subprocess.run([sys.executable, "-m", "orbearing.validation", str(file), "-o", f"{folder}/guide"], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr, done.stdout.strip()), (0, "", f"{folder}/guide/index.md"))

    def test_it_is_written_with_its_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            page = validation.write_guide([ROW, replace(ROW, published=3.0)], folder)
            self.assertTrue((page.parent / "slip.png").stat().st_size > 5000)


class Tables(unittest.TestCase):
    """Each column of the guide's tables holds what its head says."""

    ROWS = [replace(ROW, meaning="load", published=2.0, ours=2.2, tolerance=0.0525, scatter=0.031, band=band(1.9, 2.1, 2.3, 2.45), why="thermal", reading="a=1"),
            replace(ROW, case="d", source="[B]", kind="program", published=4.0, ours=3.9, scatter=None, verdict="reproduced")]

    def lines(self, text):
        """Cells by their head, of each line."""
        heads, _, *rows = ([cell.strip() for cell in line.strip("|").split(" | ")] for line in text.splitlines())
        return [dict(zip(heads, row)) for row in rows]

    def test_rows(self):
        first, second = self.lines(rows_table(self.ROWS))
        self.assertEqual(first, {"source": "[A2000], Table 1", "meaning": "load", "kind": "measurement", "published": "2", "ours": "2.2", "deviation": "+10.00 %",
                                 "tolerance": "5.25 %", "scatter": "3.1 %", "ours, 90 %": "1.9 to 2.45", "verdict": "missed", "case and settings": "c: a=1"})
        self.assertEqual([second[head] for head in ("kind", "published", "ours", "deviation", "scatter", "ours, 90 %", "case and settings")],
                         ["program", "4", "3.9", "-2.50 %", "", "", "d"])

    def test_statistics(self):
        found = {row["kind"]: row for row in self.lines(statistics_table({"slip": [self.ROWS[0], replace(self.ROWS[0], published=2.0, ours=2.4, source="[C]"), self.ROWS[1]]}))}
        ratios = [math.log(1.1), math.log(1.2)]
        deviation = abs(ratios[1] - ratios[0]) / math.sqrt(2.0)
        self.assertEqual(found["measurement"], {"quantity": "slip", "kind": "measurement", "values": "2", "sources": "2", "scatter of the measurement": percent(0.031),
                                                "bias": percent(sum(ratios) / 2, True), "standard deviation": percent(deviation),
                                                "left to the model": percent(math.sqrt(deviation**2 - 0.031**2)), "reproduced": "0", "trend": "0", "missed": "2",
                                                "input missing": "0"})
        self.assertEqual((found["program"]["bias"], found["program"]["missed"]), ("-2.5 %", "0"))

    def test_what_is_asked_first(self):
        """Friction, heat, slip, loads, share, stiffness and vibration, in this order."""
        rows = [replace(ROW, of="friction", ours=2.0 * math.exp(x), meaning=str(x)) for x in (0.1, 0.3)] + [replace(ROW, of="stiffness", kind="recomputed")]
        rows += [replace(ROW, of=of, meaning=of) for of in ("stiffness", "displacement", "tilt")]
        found = self.lines(first_table(rows))
        self.assertEqual([row["quantity"] for row in found], ["friction", "heat", "slip", "loads", "load sharing", "stiffness", "vibration"])
        self.assertEqual(found[0], {"quantity": "friction", "values": "2", "of them measured": "2", "sources": "1", "bias": percent(0.2, True),
                                    "standard deviation": percent(0.1 * math.sqrt(2.0)), "reproduced": "0", "trend": "0", "missed": "2", "input missing": "0",
                                    "most frequent reason of a miss": "2 of friction: not understood"})
        self.assertEqual(found[5]["values"], "3")

    def test_counts(self):
        found = {row["kind of evidence"]: row for row in self.lines(counts_table([*self.ROWS, replace(ROW, kind="closed-form", verdict="trend")]))}
        self.assertEqual(found["measurement"], {"kind of evidence": "measurement", "values": "1", "sources": "1", "reproduced": "0", "trend": "0", "missed": "1",
                                                "input missing": "0", "counts": "yes", "most frequent reason of a miss": "1 of slip: thermal"})
        for row in found.values():  # the numbers of a row add up
            self.assertEqual(int(row["values"]), sum(int(row[verdict]) for verdict in ("reproduced", "trend", "missed", "input missing")), row)
        self.assertEqual((found["closed-form"]["trend"], found["closed-form"]["counts"], found["all that count"]["values"]), ("1", "no", "2"))

    def test_misses(self):
        self.assertEqual(self.lines(misses(self.ROWS)), [{"case": "c", "source": "[A2000], Table 1", "what": "load", "kind": "measurement", "published": "2",
                                                          "ours": "2.2", "deviation": "+10.0 %", "reason": "thermal"}])

    def test_calibration(self):
        """Published 2.0 lies below the middle 50 % of ours, 2.1, widened 2.2 - sqrt(0.1^2 + (0.67449 x 0.031 x 2.2)^2) = 2.09, and within 90 %, 1.9."""
        self.assertEqual(self.lines(calibration_text(self.ROWS))[0], {
            "source": "[A2000]", "measurements with stated input uncertainty": "1", "within our 50 %": "0 (0 %)", "within our 90 %": "1 (100 %)",
            "50 %, with the measurement's scatter": "0 (0 %)", "90 %, with the measurement's scatter": "1 (100 %)"})


class Recorded(unittest.TestCase):
    def test_a_record_is_read_as_it_was_written(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "rows.json"
            rows = [ROW, replace(ROW, meaning="other", band=band(1, 2, 3, 4))]
            write_record(rows, file)
            self.assertEqual(validation.read([file]), rows)

    def test_a_change_names_its_row(self):
        changes = validation.changed_verdicts([ROW], [replace(ROW, verdict="reproduced"), replace(ROW, meaning="new")])
        self.assertEqual(len(changes), 2)
        self.assertIn("[A2000], Table 1, q (m): was missed, is reproduced", changes[0])
        self.assertIn("was no such row, is missed", changes[1])

    def test_names_of_cases_are_unlike(self):
        names = [path.parent.name for pattern in ("*/case.yaml", "validation/*/case.yaml") for path in CASES.glob(pattern)]
        self.assertEqual(len(names), len(set(names)))

    def test_sources_are_many_and_some_of_them_measured(self):
        """Each bracketed key is an entry of REFERENCES.md."""
        counted = [row for row in validation.distinct(validation.read([RECORDED])) if row.counts]
        references = (SOURCE / "REFERENCES.md").read_text(encoding="utf-8")
        measured = [row for row in counted if row.kind == "measurement"]
        sources, rigs = ({row.key for row in rows} for rows in (counted, measured))
        self.assertEqual([key for key in sources if f"| {key} |" not in references], [])
        self.assertGreaterEqual(len(counted), 300)
        self.assertGreaterEqual(len(sources), 20)
        self.assertGreaterEqual(len(measured), 40)
        self.assertGreaterEqual(len(rigs), 6)

    def test_measurements_of_friction_heat_slip_and_sharing_are_many(self):
        """Each miss says which part of the model decides, or that none of those that were tried does."""
        rows = [row for row in validation.distinct(validation.read([RECORDED])) if row.counts and is_friction_slip_or_sharing(row)]
        self.assertGreaterEqual(len(rows), 45)
        self.assertGreaterEqual(len({row.key for row in rows}), 8)
        self.assertEqual([row.name for row in rows if row.verdict == "missed" and not row.why], [])

    def test_the_table_of_the_readme_has_the_recorded_numbers(self):
        """tools/validation --record writes them."""
        text = (SOURCE / "README.md").read_text(encoding="utf-8")
        self.assertEqual(text, readme.updated(text, validation.read([RECORDED])))

    def test_numbers_of_the_readme(self):
        rows = [ROW, replace(ROW, meaning="b", published=3.0, verdict="reproduced", of="friction"), replace(ROW, published=1.0, of="trend", verdict="trend"),
                replace(ROW, published=9.0, of="natural frequency", verdict="reproduced"), replace(ROW, published=1.0, of="trend", quantity="modes:/m", source="[B2000]"),
                replace(ROW, published=7.0, memory=True), replace(ROW, published=5.0, kind="program"), replace(ROW, published=5.0, kind="closed-form")]
        self.assertEqual(readme.numbers(rows), {"measurement": [5, 2, 1, 2], "of these: friction, heat, slip, sharing": [3, 1, 1, 1],
                                                "program": [1, 0, 0, 1], "worked example": [0, 0, 0, 0]})
        table = "".join(f"| {name} | 1 | 2 | 3 | 4 | words |\n" for name in readme.LINES)
        self.assertIn("| program | 1 | 0 | 0 | 1 | words |", readme.updated(table, rows))
        with self.assertRaisesRegex(ValueError, "begins with measurement"):
            readme.updated("no table", rows)

    def test_every_case_with_published_values_is_recorded(self):
        """Rows of expected.yaml are those of the record: a value that was added has been compared."""
        import yaml

        recorded = {}
        for row in validation.read([RECORDED]):
            recorded.setdefault(row.case, []).append((row.source, row.quantity, row.meaning, row.published))
        for pattern in ("*/expected.yaml", "validation/*/expected.yaml"):
            for file in sorted(CASES.glob(pattern)):
                stated = yaml.safe_load(file.read_text(encoding="utf-8"))["published"] or []
                name = yaml.safe_load((file.parent / "case.yaml").read_text(encoding="utf-8"))["name"]
                self.assertEqual(sorted((r["source"], r["quantity"], r["meaning"], number(r["value"])) for r in stated),
                                 sorted((s, q, m, number(v)) for s, q, m, v in recorded.get(name, [])), name)


def number(value):
    return "" if value is None else f"{float(value):.9g}"


if __name__ == "__main__":
    unittest.main()
