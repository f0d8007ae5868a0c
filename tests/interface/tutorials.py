#!/usr/bin/env python3
"""docs/tutorials: every block of every tutorial runs, and what the text says of its outputs holds.

Tutorials as notebooks that run in the tests. Skipped where matplotlib is missing, single tutorials where a
module that they name is. Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import importlib.util
import json
import os
import pathlib
import sys
import tempfile
import unittest

from program import package
from virtual_environment import skip

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
FOLDER = SOURCE / "docs" / "tutorials"
sys.path.insert(0, str(SOURCE / "docs" / "site"))


class Tutorials(unittest.TestCase):
    def run_tutorial(self, name):
        missing = tutorial.missing_modules(FOLDER / name)
        if missing:
            self.skipTest(f"{name} needs {', '.join(missing)}")
        done = tutorial.run(FOLDER / name)
        print(f"{name}: {done.seconds:.1f} s", flush=True)
        self.assertTrue(any(part.output.figures for part in done.parts), "a tutorial draws something")
        self.assertTrue(any(part.kind == "check" for part in done.parts), "what the text says is checked")

    def test_each_has_a_test(self):
        names = {file.stem for file in FOLDER.glob("*.md")} - {"index"}
        self.assertEqual(names, {name.removeprefix("test_runs_") for name in dir(self) if name.startswith("test_runs_")})

    def test_runs_first_case(self):
        self.run_tutorial("first_case.md")

    def test_runs_own_gearbox(self):
        self.run_tutorial("own_gearbox.md")

    def test_runs_crown_for_a_spectrum(self):
        self.run_tutorial("crown_for_a_spectrum.md")

    def test_runs_study_on_four_workers(self):
        self.run_tutorial("study_on_four_workers.md")

    def test_runs_bearing_in_a_multibody_model(self):
        self.run_tutorial("bearing_in_a_multibody_model.md")

    def test_runs_peak_under_uncertainty(self):
        self.run_tutorial("peak_under_uncertainty.md")


class Runner(unittest.TestCase):
    """What runs them."""

    def run_text(self, text):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder, "page.md")
            page.write_text(text, encoding="utf-8")
            return tutorial.run(page), folder

    def test_blocks_share_a_session_and_show_print_value_and_figure(self):
        done, _ = self.run_text(
            "# T\n\n```python\na = 2\nprint('said')\na + 1\n```\n\ntext\n\n```python\nfrom matplotlib import pyplot\n"
            "pyplot.plot([a, 3])\n```\n\n<!-- check\nassert a == 2\n-->\n")
        first, second = (part.output for part in done.parts if part.kind == "code")
        self.assertEqual((first.printed, first.text, first.figures), ("said\n", "3", []))
        self.assertEqual((len(second.figures), second.figures[0][:4]), (1, b"\x89PNG"))
        with tempfile.TemporaryDirectory() as folder:
            page = done.markdown(pathlib.Path(folder))
            self.assertIn("said", page)
            self.assertNotIn("assert", page)
            self.assertTrue((pathlib.Path(folder) / "page_1.png").exists())
        cells = json.loads(done.notebook())["cells"]
        self.assertEqual([cell["cell_type"] for cell in cells], ["markdown", "code", "markdown", "code"])

    def test_a_block_or_a_check_that_fails_is_reported_with_its_line(self):
        for text in ("# T\n\n```python\n1 / 0\n```\n", "# T\n\n<!-- check\nassert False\n-->\n"):
            with self.assertRaisesRegex(tutorial.TutorialError, r"page\.md: the block at line 4 failed"):
                self.run_text(text)

    def test_missing_modules_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder, "page.md")
            page.write_text("<!-- needs numpy, no_such_module -->\n\n# T\n", encoding="utf-8")
            self.assertEqual(tutorial.missing_modules(page), ["no_such_module"])


if __name__ == "__main__":
    for module in ("matplotlib", "xarray"):
        if importlib.util.find_spec(module) is None:
            skip(f"{module} is missing")
    package()
    import tutorial

    unittest.main()
