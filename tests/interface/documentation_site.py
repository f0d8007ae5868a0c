#!/usr/bin/env python3
"""tools/site: the documentation site builds without a warning, has its tutorials with outputs, and fetches nothing.

Issue 18, Build 7: documentation site. What the guide says of values and commands is tried every day, the pages by
tools/test --full: tutorials.py runs what they run every day. Skipped where Sphinx or its reader of Markdown is missing. Needs
ORBEARING and ORBEARING_SOURCE_DIR.
"""

import importlib.util
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

from program import LEFT_TO_FULL, REDUCER, package, run, settings
from virtual_environment import skip

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
# Words that a shell block of the guide begins with and that are no calls of the program.
NOT_RUN = ("tools/", "pip ", "cmake ", "PYTHONPATH=", "build/release/bin/orbearing --help",
           "build/release/bin/orbearing open")  # which serves until its page is closed


def build(folder):
    return subprocess.run([SOURCE / "tools" / "site", "--no-build"], capture_output=True, text=True, check=False,
                          env={**os.environ, "ORBEARING_SITE": str(folder)})


@unittest.skipIf(LEFT_TO_FULL, "a minute for all pages: tools/test --full, or by hand")
class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        cls.built = build(cls.folder)
        cls.html = cls.folder / "html"

    def page(self, name):
        return (self.html / name).read_text(encoding="utf-8")

    def test_it_builds_without_a_warning(self):
        self.assertEqual((self.built.returncode, self.built.stderr), (0, ""))

    def test_every_document_of_the_repository_is_a_page(self):
        sys.path.insert(0, str(SOURCE / "docs" / "site"))
        stage = importlib.import_module("stage")
        for name in stage.documents():
            if name.suffix == ".md":
                self.assertTrue((self.html / name).with_suffix(".html").exists(), name)

    def test_nothing_is_fetched(self):
        loads = re.compile(r"<(?:script|img|link)[^>]*?(?:src|href)=\"(?:https?:)?//[^\"]*\"|@import url\(\"?(?:https?:)?//|url\(\"?https?://")
        for page in (*self.html.rglob("*.html"), *self.html.rglob("*.css")):
            self.assertIsNone(loads.search(page.read_text(encoding="utf-8")), page)

    def test_links_within_the_site_lead_somewhere(self):
        for page in self.html.rglob("*.html"):
            for address in re.findall(r'(?:href|src)="([^"#?:]+)["#?]', page.read_text(encoding="utf-8")):
                self.assertTrue((page.parent / address).resolve().exists(), f"{page.relative_to(self.html)}: {address}")

    def test_the_first_page_shows_the_peak_and_leads_on(self):
        first = self.page("docs/index.html")
        self.assertIn("life_peak.png", first)
        self.assertRegex(first, r"lives longest, [0-9,]+ h, at [0-9,]+ rpm")
        self.assertIn("docs/index.html", self.page("index.html"))

    def test_every_command_and_key_has_its_place(self):
        commands = self.page("docs/guide/commands.html")
        for name in ("check", "sweep", "crown", "fmu", "report"):
            self.assertIn(f"Usage: orbearing {name} ", commands)
        keys = self.page("docs/guide/case_files.html")
        for path in ("bearing.cage.pocket_clearance", "gearset.teeth.sun", "lubricant.grade"):
            self.assertIn(path, keys)

    def test_every_public_name_of_the_package_is_described(self):
        page = self.page("docs/guide/python.html")
        orbearing = importlib.import_module("orbearing")
        there = [name for name in orbearing.__all__ if name != "__version__" and importlib.util.find_spec(f"orbearing.{orbearing._PARTS[name]}")]
        self.assertGreater(len(there), 8)
        for name in there:
            self.assertRegex(page, rf'id="orbearing\.(?:\w+\.)*{name}"')
            value = getattr(orbearing, name)
            ours = [one for one in getattr(value, "__mro__", ()) if one.__module__.startswith("orbearing.")]
            for member in {member for one in ours for member in vars(one) if not member.startswith("_")}:
                self.assertRegex(page, rf'id="orbearing\.(?:\w+\.)+{member}"', f"{name}.{member}")

    def test_documents_and_sources_that_a_text_names_are_links(self):
        page = self.page("cases/reducer_150kW/README.html")
        self.assertRegex(page, r'href="../../docs/elastic_rim.html"><code[^>]*><span class="pre">docs/elastic_rim.md')
        self.assertIn('href="../../REFERENCES.html#Gai2025"', page)
        self.assertIn('id="Gai2025"', self.page("REFERENCES.html"))

    def test_notebooks_hold_code_and_outputs(self):
        notebooks = {file.name: json.loads(file.read_text(encoding="utf-8")) for file in self.html.rglob("*.ipynb")}
        self.assertIn("first_case.ipynb", notebooks)
        for name, notebook in notebooks.items():
            self.assertEqual(notebook["nbformat"], 4)
            kinds = [output["output_type"] for cell in notebook["cells"] if cell["cell_type"] == "code" for output in cell["outputs"]]
            self.assertIn("display_data", kinds, name)
            self.assertNotIn("assert ", json.dumps(notebook), "checks are not shown")


class Guide(unittest.TestCase):
    """What its pages say of the program holds."""

    def test_values_that_the_guide_names_are_taken(self):
        """Those of a line together."""
        page = (SOURCE / "docs" / "guide" / "fidelity.md").read_text(encoding="utf-8")
        lines = [re.findall(r"`([a-z]+\.[a-z_.]+): ([^`]+)`", line) for line in page.splitlines()]
        self.assertGreater(sum(map(bool, lines)), 3)
        for stated in filter(None, lines):
            done = run("check", REDUCER, "--quiet", *settings(f"{path}={value}" for path, value in stated))
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_commands_of_the_guide_run(self):
        """The lines of indented blocks that call the program, in their order on the page; not those of blocks in another language."""
        pages = [SOURCE / "docs" / "index.md", *sorted((SOURCE / "docs" / "guide").glob("*.md"))]
        pages = [page for page in pages if page.name != "commands.md"]  # the list of all commands, long ones too, with what each gives
        texts = [re.sub(r"^```\w.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S) for page in pages]
        lines = [line.strip() for text in texts for line in text.splitlines() if line.startswith("    ")]
        wanted = [line.split("#")[0].strip() for line in lines if not line.startswith(NOT_RUN)]
        calls = [shlex.split(line) for line in wanted if line.split()[:1] in (["orbearing"], ["build/release/bin/orbearing"])]
        self.assertEqual(len(wanted), len(calls), wanted)
        self.assertGreaterEqual(len(calls), 2)
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "cases").symlink_to(SOURCE / "cases")
            for call in calls:
                done = subprocess.run([os.environ["ORBEARING"], *call[1:]], cwd=folder, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, f"{call}: {done.stderr}")


if __name__ == "__main__":
    for module in ("sphinx", "myst_parser", "matplotlib", "xarray"):
        if importlib.util.find_spec(module) is None:
            skip(f"{module} is missing")
    package()
    unittest.main()
