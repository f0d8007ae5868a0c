#!/usr/bin/env python3
"""tools/site: the documentation site builds without a warning, has its tutorials with outputs, and fetches nothing.

Documentation site. Front page and guide. What README and guide say of values and
commands is tried every day, the pages by tools/test --full: tutorials.py runs what they run every day. Skipped where Sphinx or its reader of Markdown is missing. Needs
ORBEARING and ORBEARING_SOURCE_DIR.
"""

import contextlib
import importlib.util
import json
import math
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

from program import LEFT_TO_FULL, REDUCER, package, run, settings
from virtual_environment import skip

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
# Words that a shell block of the guide begins with and that are no calls of the program.
NOT_RUN = ("tools/", "apt ", "pip ", "cmake ", "PYTHONPATH=", "build/release/bin/orbearing --help",
           "build/release/bin/orbearing open", "orbearing open")  # which serves until its page is closed
PLACEHOLDER = re.compile(r"\b(CASE|DIR|SERIES|A|B)\b")  # of a command that shows a form
BRIEF = {"uncertainty": ("--samples", "64", "--curves", "4", "--index-samples", "16")}
LONGEST_README, LONGEST_LINE = 90, 120
# Terms that a reader searches for: the site's index of words lists each for the glossary.
TERMS = ("L10h", "L10rh", "L10mh", "L10mrh", "BPFO", "BPFI", "BSF", "FTF", "K_gamma", "K_A", "kappa", "e_C", "a_ISO", "S0", "C0", "Cu",
         "load zone", "skidding", "torque", "clearance")


# Pages that are looked at in a browser, on a phone and on two screens; what a reader searches, and the page that must be among what is found.
IN_BROWSER = ("docs/index", "docs/guide/questions", "docs/guide/glossary", "docs/guide/commands", "docs/guide/case_files", "docs/guide/installation",
              "docs/guide/python", "docs/peak", "docs/iso_life", "docs/tutorials/first_case")
WIDTHS = (360, 1200, 1600)
SEARCHED = ("L10h", "BPFO", "K_gamma", "load zone", "skidding", "torque", "kappa", "clearance", "L10mrh", "a_ISO")
SECONDS = 60  # a machine that computes other things besides
# Elements that reach beyond the window and are in no box that scrolls.
CUT_OFF = """const w = document.documentElement.clientWidth;
const scrolls = (e) => e && (["auto", "scroll"].includes(getComputedStyle(e).overflowX) && e.getBoundingClientRect().right <= w + 1 || scrolls(e.parentElement));
return [...document.querySelectorAll("body *")].filter((e) => e.getBoundingClientRect().width && e.getBoundingClientRect().right > w + 1
  && !scrolls(e.parentElement)).map((e) => e.tagName + " " + e.textContent.slice(0, 40));"""


@contextlib.contextmanager
def browser():
    """Chromium without a window; the test is skipped where it or selenium is missing."""
    chromium, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if importlib.util.find_spec("selenium") is None or not (chromium and driver):
        raise unittest.SkipTest("selenium, chromium or chromium-driver is missing")
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--allow-file-access-from-files"):
        options.add_argument(word)
    with webdriver.Chrome(options=options, service=Service(driver)) as opened:
        yield opened


def stage_module():
    sys.path.insert(0, str(SOURCE / "docs" / "site"))
    return importlib.import_module("stage")


def text_of(name):
    return (SOURCE / name).read_text(encoding="utf-8")


def questions():
    """Questions of a newcomer with the page that answers each, relative to docs without suffix."""
    rows = re.findall(r"^\| \[(.*\?)\]\(#.*\) \| .* \| \[.*\]\((.*)\.md\) \|$", text_of("docs/guide/questions.md"), re.M)
    return {question: os.path.normpath(f"guide/{page}") for question, page in rows}


def clicks(links_of, first, most):
    """Pages that are reached from the first one with at most so many clicks: page -> clicks."""
    found, edge = {first: 0}, [first]
    for number in range(1, most + 1):
        edge = [page for page in dict.fromkeys(page for one in edge for page in links_of(one)) if page not in found]
        found |= dict.fromkeys(edge, number)
    return found


def indented_blocks(name):
    """Those of a document, each as its lines; a line that goes on behind a backslash is one."""
    text = re.sub(r"^```\w.*?^```$", "", text_of(name), flags=re.M | re.S).replace("\\\n", "")
    return [[line.strip() for line in block.splitlines()] for block in re.findall(r"(?:^    .*\n)+", text, re.M)]


class Calls:
    """Calls of the program, in the order of a page, in a folder of its own with the cases."""

    reported = False  # a report takes seconds: one a day

    def __init__(self, test):
        place = tempfile.TemporaryDirectory()
        test.addCleanup(place.cleanup)
        self.test, self.folder = test, pathlib.Path(place.name)
        (self.folder / "cases").symlink_to(SOURCE / "cases")

    def run(self, line):
        """What it prints; None where tools/test --full runs it."""
        words = shlex.split(line.split(" #")[0])
        command = words[1]
        reports = command in ("report", "demo")  # demo_command.py runs that every day
        if LEFT_TO_FULL and (command == "fmu" or reports and Calls.reported):
            return None
        Calls.reported = Calls.reported or reports
        done = subprocess.run([os.environ["ORBEARING"], *words[1:], *BRIEF.get(command, ())], cwd=self.folder, capture_output=True, text=True,
                              check=False)
        self.test.assertEqual(done.returncode, 0, f"{line}: {done.stderr}")
        return done.stdout


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
        for name in stage_module().documents():
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
        self.assertRegex(first, r"Longest life of a planet bearing of the 150 kW reducer: [0-9,]+ h .* at [0-9,]+ rpm")
        self.assertIn("docs/index.html", self.page("index.html"))

    def test_each_question_of_a_newcomer_is_two_clicks_away(self):
        """By the text of pages, without the list of contents beside it."""
        def links_of(page):
            body = self.page(f"{page}.html").split('<div class="body" role="main">')[1].split('<div class="sphinxsidebar"')[0]
            return [os.path.normpath(os.path.join(os.path.dirname(page), address)) for address in re.findall(r'href="([^"#?:]+)\.html[#"]', body)
                    if not address.startswith("../explorer")]

        there = clicks(links_of, "docs/index", 2)
        self.assertEqual({page for page in questions().values() if f"docs/{page}" not in there}, set())

    def test_search_finds_the_terms_in_the_glossary(self):
        """Words of the index are stems, in small letters."""
        text = (self.html / "searchindex.js").read_text(encoding="utf-8")
        index = json.loads(text[text.index("(") + 1:text.rindex(")")])
        glossary = index["docnames"].index("docs/guide/glossary")
        from sphinx.search.en import SearchEnglish

        stem = SearchEnglish({}).stem
        for word in (word for term in TERMS for word in term.split()):
            found = [index[part].get(stem(word.lower()), []) for part in ("terms", "titleterms")]
            self.assertTrue(any(glossary in (pages if isinstance(pages, list) else [pages]) for pages in found), word)

    def test_in_a_browser_nothing_is_cut_off(self):
        with browser() as opened:
            for width in WIDTHS:
                opened.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": width < 500})
                for name in IN_BROWSER:
                    with self.subTest(page=name, width=width):
                        opened.get((self.html / f"{name}.html").as_uri())
                        self.assertEqual(opened.execute_script(CUT_OFF), [])

    def test_in_a_browser_the_search_finds_the_terms(self):
        with browser() as opened:
            from selenium.webdriver.common.by import By
            from selenium.webdriver.support.ui import WebDriverWait

            for term in SEARCHED:
                with self.subTest(term):
                    opened.get(f"{(self.html / 'search.html').as_uri()}?q={term.replace(' ', '+')}")
                    WebDriverWait(opened, SECONDS).until(lambda page: "finished" in page.find_element(By.CSS_SELECTOR, "p.search-summary").text)
                    found = [link.get_attribute("href") for link in opened.find_elements(By.CSS_SELECTOR, "#search-results ul.search li a")]
                    self.assertTrue(any("docs/guide/glossary.html" in address for address in found), found[:5])

    def test_in_a_browser_keys_are_filtered(self):
        shown = ("const place = document.querySelector('p.key-filter');"  # the table of numerical settings comes before it
                 "return [...document.querySelectorAll('section tbody tr')].filter((e) => e.offsetParent && place.compareDocumentPosition(e) & 4)"
                 ".map((e) => e.textContent)")
        with browser() as opened:
            from selenium.webdriver.common.by import By
            from selenium.webdriver.support.ui import Select

            opened.get((self.html / "docs/guide/case_files.html").as_uri())
            every = len(opened.execute_script(shown))
            opened.find_element(By.CSS_SELECTOR, "p.key-filter input").send_keys("clearance bearing")
            found = [text for text in opened.execute_script(shown) if "bearing." in text]
            self.assertTrue(0 < len(found) < every / 4, f"{len(found)} of {every}")
            Select(opened.find_element(By.CSS_SELECTOR, "p.key-filter select")).select_by_value("duplex-pair")
            self.assertLess(len([text for text in opened.execute_script(shown) if "bearing." in text]), len(found))
            self.assertFalse(any("gearset." in text for text in opened.execute_script(shown)))

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


class Versions(unittest.TestCase):
    """docs/site/versions.py: releases by tags of git, and the choice that pages offer."""

    def setUp(self):
        stage_module()  # makes its folder known
        self.versions = importlib.import_module("versions")
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def add(self, *names):
        for name in names:
            page = self.folder / "versions" / name / "docs" / "index.html"
            page.parent.mkdir(parents=True)
            page.write_text("")

    def listed(self, folder):
        text = (folder / "versions.js").read_text(encoding="utf-8")
        return json.loads(text.removeprefix("window.orbearingVersions = ").rstrip(";\n"))

    def test_a_single_version(self):
        self.versions.write(self.folder)
        self.assertEqual(self.listed(self.folder), [{"name": f"{self.versions.present()} (present)", "page": "docs/index.html", "here": True}])

    def test_releases_are_listed_newest_first_in_each_version(self):
        self.add("1.2.0", "1.10.0", "nightly")
        self.versions.write(self.folder)
        older = self.folder / "versions" / "1.2.0"
        self.assertEqual([one["name"] for one in self.listed(self.folder)][1:], ["1.10.0", "1.2.0"])
        self.assertEqual([one["here"] for one in self.listed(older)], [False, False, True])
        for folder in (self.folder, older):
            for one in self.listed(folder)[1:]:
                self.assertTrue((folder / one["page"]).exists(), one)

    def test_tags_without_pages_are_missing(self):
        git = ["git", "-C", str(self.folder), "-c", "user.name=test", "-c", "user.email=test@example.org"]
        for words in (["init", "-q"], ["commit", "-q", "--allow-empty", "-m", "first"], *(["tag", tag] for tag in ("v1.2.0", "v1.10.0", "v2", "nightly"))):
            subprocess.run([*git, *words], check=True)
        self.add("1.2.0")
        self.assertEqual(self.versions.missing(self.folder, self.folder), ["v1.10.0"])

    def test_in_a_browser_the_choice_leads_to_the_other_version(self):
        self.add("1.2.0")
        self.versions.write(self.folder)
        script = (SOURCE / "docs/site/static/version_switcher.js").as_uri()
        page = f'<p class="versions" data-root="../"></p><script src="../versions.js"></script><script src="{script}"></script>'
        first, other = self.folder / "docs" / "index.html", self.folder / "versions" / "1.2.0" / "docs" / "index.html"
        first.parent.mkdir()
        for file in (first, other):
            file.write_text(f"<!doctype html>{page}")
        with browser() as opened:
            from selenium.webdriver.common.by import By
            from selenium.webdriver.support.ui import Select

            opened.get(first.as_uri())
            Select(opened.find_element(By.CSS_SELECTOR, "p.versions select")).select_by_visible_text("1.2.0")
            self.assertEqual(opened.current_url, other.as_uri())
            chosen = Select(opened.find_element(By.CSS_SELECTOR, "p.versions select"))
            self.assertEqual(chosen.first_selected_option.text, "1.2.0")


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

    def test_no_page_is_made_of_parts_of_another(self):
        """The guide is the source: generated parts come from the program, its schemas and its results."""
        generated = set(stage_module().GENERATED)
        for page in sorted((SOURCE / "docs").rglob("*.md")):
            for name, arguments in re.findall(r"^<!-- generated: ([\w-]+) ?(.*?) -->$", page.read_text(encoding="utf-8"), re.M):
                self.assertIn(name, generated, page)
                self.assertNotIn(".md", arguments, page)

    def test_commands_of_the_guide_run(self):
        """The lines of indented blocks that call the program, in their order on the page; not those of blocks in another language."""
        pages = ["docs/index.md", *sorted(f"docs/guide/{page.name}" for page in (SOURCE / "docs" / "guide").glob("*.md"))]
        pages.remove("docs/guide/commands.md")  # the list of all commands, long ones too, with what each gives
        tried = 0
        for page in pages:
            with self.subTest(page):
                wanted = [line for block in indented_blocks(page) for line in block if not line.startswith(NOT_RUN)]
                calls = [line for line in wanted if line.split()[0] in ("orbearing", "build/release/bin/orbearing")]
                self.assertEqual(wanted, calls)
                place = Calls(self)
                for line in calls:
                    place.run(line)
                tried += len(calls)
        self.assertGreaterEqual(tried, 20)

    def test_commands_that_a_task_begins_with_run(self):
        """Of the pages of tasks outside of the guide: the first block that calls the program. multibody_example.py runs those of FMUs."""
        tasks = [name for name in stage_module().pages_of_first_page("Tasks") if not name.startswith(("guide/", "multibody/"))]
        self.assertGreaterEqual(len(tasks), 5)
        for name in tasks:
            with self.subTest(name):
                lines = next(block for block in indented_blocks(f"docs/{name}.md") if block[0].startswith("orbearing "))
                self.assertTrue(all(line.startswith("orbearing ") for line in lines), lines)
                self.assertIsNone(PLACEHOLDER.search(lines[0]))
                place = Calls(self)
                for line in lines:
                    if not PLACEHOLDER.search(line):
                        place.run(line)

    def test_parts_that_the_repository_shows_are_as_recorded(self):
        """A complete case and all keys are in docs/guide/case_files.md itself; docs/site/stage.py --record writes them."""
        stage, shown = stage_module(), []
        for name in stage.documents():
            text = text_of(name) if name.suffix == ".md" else ""
            if stage._END in text:
                shown.append(str(name))
                self.assertTrue(stage.recorded(text, SOURCE / name.parent) == text, f"{name} is not as recorded; run docs/site/stage.py --record")
                self.assertNotIn(stage._END, stage.filled(text, SOURCE / name.parent))
        self.assertEqual(shown, ["docs/guide/case_files.md"])
        text = text_of(shown[0])
        self.assertIn(text_of("cases/reducer_150kW/case.yaml").strip(), text)
        for key in ("bearing.radial_clearance", "bearing.clearance_class", "life.cleanliness", "sets.NAME.gearset.module"):
            self.assertIn(f"| `{key}` | ", text)

    def test_tasks_and_questions_lead_to_pages(self):
        """Each page begins with a question or a task, and each question of a newcomer has a short answer with a link."""
        stage = stage_module()
        for name in stage.pages_of_first_page("Tasks"):
            self.assertRegex(text_of(f"docs/{name}.md"), r"^# .*[:?]", name)
        parts = re.split(r"^## ", text_of("docs/guide/questions.md"), flags=re.M)
        self.assertGreaterEqual(len(parts) - 1, 10)
        for part in parts[1:]:
            title, _, answer = part.partition("\n")
            self.assertTrue(title.endswith("?"), title)
            self.assertIn("](", answer, title)
            self.assertIn(f"[{title}](#", parts[0], title)

    def test_each_question_of_a_newcomer_is_two_clicks_away(self):
        """From the first page of the site, by links within the texts; every question names its page."""
        def links_of(page):
            text = text_of(f"docs/{page}.md")
            return [os.path.normpath(os.path.join(os.path.dirname(page), address)) for address in re.findall(r"\]\(([^)#:]+)\.md(?:#[^)]*)?\)", text)
                    if (SOURCE / "docs" / os.path.dirname(page) / f"{address}.md").exists()]

        asked = questions()
        self.assertEqual(list(asked), re.findall(r"^## (.*)$", text_of("docs/guide/questions.md"), re.M))
        self.assertGreaterEqual(len(asked), 10)
        there = clicks(links_of, "index", 2)
        self.assertEqual({question: page for question, page in asked.items() if page not in there}, {})

    def test_terms_that_are_searched_are_in_the_glossary(self):
        """Each as the term or the symbol of a row; the site's own test looks them up in its index of words."""
        rows = re.findall(r"^\| (.*?) \| (.*?) \|", text_of("docs/guide/glossary.md"), re.M)
        stated = " ".join(" ".join(row) for row in rows)
        self.assertEqual([term for term in SEARCHED if term not in stated], [])

    def test_links_between_documents_lead_somewhere(self):
        """Those of the front page too, as the repository's host shows them; GitHub's own names of sections are not looked up."""
        for page in (SOURCE / "README.md", *sorted((SOURCE / "docs").rglob("*.md"))):
            text = re.sub(r"^```.*?^```$|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
            for address in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", text):
                self.assertTrue((page.parent / address).exists(), f"{page.relative_to(SOURCE)}: {address}")


class FrontPage(unittest.TestCase):
    """README.md: short, and true of this program."""

    @classmethod
    def setUpClass(cls):
        cls.text = text_of("README.md")

    def test_it_is_short(self):
        lines = self.text.splitlines()
        self.assertLessEqual(len(lines), LONGEST_README)
        for line in lines:
            self.assertLessEqual(len(line), LONGEST_LINE, line)

    def test_its_commands_run(self):
        """The first with the output that is shown, then those of the table, from top to bottom in one folder."""
        place = Calls(self)
        first, shown = re.search(r"^    (build/release/bin/orbearing .*)\n\n```text\n(.*?)^```$", self.text, re.M | re.S).groups()
        printed = iter(place.run(first).splitlines())
        for line in shown.splitlines():
            self.assertTrue(line == "..." or line in printed, f"{first} does not print, or not in this order: {line}")
        rows = re.findall(r"^\| [^|]+ \| `(orbearing [^`]+)` \| \[[^]]+\]\(docs/.*\) \|$", self.text, re.M)
        self.assertGreaterEqual(len(rows), 12)
        for line in rows:
            if not line.startswith(NOT_RUN):
                self.assertIsNone(PLACEHOLDER.search(line), line)
                place.run(line)

    def test_its_python_runs(self):
        block, = re.findall(r"^```python\n(.*?)^```$", self.text, re.M | re.S)
        self.assertLessEqual(len(block.splitlines()), 6)
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "cases").symlink_to(SOURCE / "cases")
            paths = os.pathsep.join([str(pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1] / "python"), os.environ.get("PYTHONPATH", "")])
            done = subprocess.run([sys.executable, "-c", block], cwd=folder, capture_output=True, text=True, check=False,
                                  env={**os.environ, "PYTHONPATH": paths, "MPLBACKEND": "agg"})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"^[0-9.]+ \[")

    def test_its_pictures_are_made_by_a_script(self):
        for picture in re.findall(r"!\[[^]]*\]\(([^)]+)\)", self.text):
            script = (SOURCE / picture).parent / "pictures.py"
            self.assertTrue((SOURCE / picture).exists(), picture)
            self.assertIn(f'"{pathlib.Path(picture).name}"', script.read_text(encoding="utf-8"))

    def test_counts_of_published_values_are_those_of_the_last_record(self):
        """docs/validation.txt ends with them; the worst misses are computed from the rows."""
        record = text_of("docs/validation.txt")
        for kind, name in (("measurement", "measurement"), ("program", "program"), ("worked-example", "worked example")):
            total, rest = re.search(rf"^  {kind} +([0-9]+): (.*)$", record, re.M).groups()
            counts = {word: int(number) for number, word in re.findall(r"([0-9]+) (missed|reproduced|trend)", rest)}
            found = [counts.get(word, 0) for word in ("reproduced", "trend", "missed")]
            self.assertEqual(sum(found), int(total), record)  # the numbers of a row add up
            self.assertIn(f"| {name} | {total} | {' | '.join(map(str, found))} |", self.text)

    def test_it_names_the_worst_misses(self):
        rows = json.loads(text_of("docs/validation/rows.json"))["rows"]
        for kind, case in (("measurement", "balan_2015"), ("program", "reducer_150kW"), ("worked-example", "thermal_reference_rollers")):
            missed = [row for row in rows if row["evidence"] == kind and row["verdict"] == "missed" and not row["memory"] and row["of"] != "trend"]
            worst = max(missed, key=lambda row: abs(math.log(row["ours"] / row["published"])))
            self.assertEqual(worst["case"], case, f"name the worst miss in README: {worst['meaning']}, {worst['ours']} / {worst['published']}")


if __name__ == "__main__":
    for module in ("sphinx", "myst_parser", "matplotlib", "xarray"):
        if importlib.util.find_spec(module) is None:
            skip(f"{module} is missing")
    package()
    unittest.main()
