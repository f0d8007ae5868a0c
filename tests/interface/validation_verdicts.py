#!/usr/bin/env python3
"""What `orbearing validate` finds: verdicts as recorded, and inputs without effect.

Verdicts of all cases: tools/test --full; else of all but the slow ones.
Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import tempfile
import unittest

from orbearing import validation
from program import CASES, answer, run

RECORDED = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"]) / "docs" / "validation" / "rows.json"
FULL = os.environ.get("ORBEARING_FULL") == "yes"

# Signals in time and a bearing with its temperatures, a second to thirty each.
SLOW = {"cwru_6203", "cwru_6205", "fault_factors_case_western", "fault_factors_za2115", "femto_6804", "hit_6205", "mfpt_nice",
        "nasa_35mm", "planet_scratch", "scratch_defect"}


class Verdicts(unittest.TestCase):
    def test_an_input_without_effect_is_warned_of(self):
        found = answer("validate", CASES / "ball_6305_iso16281", "lubricant.pressure_viscosity=30 GPa-1")
        self.assertTrue(any(text.startswith("ball_6305_iso16281: lubricant.pressure_viscosity: 30 GPa-1 has no effect") for text in found["warnings"]), found["warnings"])

    def test_inputs_of_the_curve_of_life_are_not_warned_of(self):
        """modes does not use them, the other row does."""
        row = "  - {source: '[A2000]', kind: program, of: life, meaning: m, value: 1, tolerance: 0.1, quantity: %s}\n"
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            (place / "case.yaml").write_text((CASES / "reducer_150kW" / "case.yaml").read_text(encoding="utf-8"), encoding="utf-8")
            modes = row % "'modes:/modes/3/frequency_Hz'"
            for rows, found in ((modes, True), (modes + row % "peak_life_h", False)):
                (place / "expected.yaml").write_text("published:\n" + rows, encoding="utf-8")
                warnings = answer("validate", place / "case.yaml", "life.cleanliness=high", "life.reliability=0.99")["warnings"]
                self.assertEqual(any("life.reliability: 0.99 has no effect" in text for text in warnings), found, warnings)

    def test_verdicts_are_those_recorded(self):
        before = validation.read([RECORDED])
        names = sorted({row.case for row in before} - (set() if FULL else SLOW))
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for name in names:
                case = next(path for path in (CASES / name, CASES / "validation" / name) if path.is_dir())
                done = run("validate", case, "--json")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(json.loads(done.stdout)["warnings"], [], "a stated input has no effect: the number may be of another machine")
                files.append(pathlib.Path(folder) / f"{name}.json")
                files[-1].write_text(done.stdout, encoding="utf-8")
            self.assertEqual(validation.changed_verdicts([row for row in before if row.case in names], validation.read(files)), [])


if __name__ == "__main__":
    unittest.main()
