#!/usr/bin/env python3
"""The page in Debian's Chromium, with the engine that `orbearing open` serves.

A template is opened; clearance, speed and oil are changed; two mistakes are shown at their fields and mended; a sweep is run, stopped and continued; two
variants are pinned and compared; the rollers are played and moved; a result is exported. Every number equals that of the command line, no request leaves
the loopback address, and the console of the browser stays empty.

Exit code 77 (skipped) where selenium or Chromium is missing. Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import csv
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from program import CASES, LEFT_TO_FULL, run

sys.path.insert(0, str(CASES.parent / "docs" / "page"))
import pictures  # noqa: E402

try:
    from selenium import webdriver
    from selenium.common.exceptions import StaleElementReferenceException
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select, WebDriverWait
except ImportError:
    print("skipped: python3-selenium is missing")
    sys.exit(77)
CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
if not (CHROMIUM and DRIVER):
    print("skipped: chromium or chromium-driver is missing")
    sys.exit(77)

SECONDS = 300  # a machine that computes other things besides
ROUND_OFF = 5e-12  # functions of the C library round differently in a browser; lives go with high powers of loads
SEARCHED = 1e-6  # roots and best values of an iteration that ends at a tolerance
LEAST_PACE = 0.1  # revolutions of the cage a second, shown while they are computed
LIVES = ("life_h", "L10h", "L10rh", "L10mh", "L10mrh")
WIDTHS = (360, 1000, 1600)
LISTED = (360, 800, 1600)
TOUCHED = 44  # px, of what is pressed by a finger
NARROW = 860  # px, below which a page is for a finger
REQUIRED = "requirements: {life: 100000 h, life_key: L10mrh, S0: 1.5, kappa: 1, contact_pressure_max: 1500 MPa}\n"
# A sweep of few speeds in motion, so that it can be stopped between them.
MOVING = """# A reducer that is swept in motion
name: reducer of the page
source: tests
model: planetary-drivetrain
input: {power: 150 kW, speed: 9000 rpm}   # the operating point
sweep:
  input.speed: [8000 rpm, 9000 rpm, 10000 rpm]
gearset:
  planets: 4
  teeth: {sun: 37, planet: 22, ring: 79}
  module: 3 mm
  profile_shift: {sun: 0.2618, ring: 0.4146}
  face_width: 28 mm
bearing:
  type: cylindrical-roller
  per_planet: 2
  rollers: 15          # in each bearing
  roller_diameter: 5.24 mm
  roller_length: 5.7 mm
  pitch_diameter: 35.64 mm
  radial_clearance: 10 um
  bore: 25 mm
  outside_diameter: 47 mm
  width: 11.9 mm
  cage: {inner_diameter: 33.44 mm, outer_diameter: 38.54 mm, width: 9 mm, density: 1310 kg/m3, guide_land_diameter: 38.88 mm}
lubricant: {viscosity: 0.01 Pa.s, pressure_viscosity: 1.5e-8 Pa-1}
assumed:
  bearing.radial_clearance: a close fit
"""
# WCAG 2: contrast of texts with their background, of large ones 3.
CONTRAST = """
const parse = (text) => (text.match(/[\\d.]+/g) ?? []).map(Number);
const part = (value) => (value /= 255) <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
const light = ([r, g, b]) => 0.2126 * part(r) + 0.7152 * part(g) + 0.0722 * part(b);
const behind = (element) => {
  for (let one = element; one; one = one.parentElement) {
    const [r, g, b, a = 1] = parse(getComputedStyle(one).backgroundColor);
    if (a > 0.99) return [r, g, b];
  }
  return [255, 255, 255];
};
const poor = [];
for (const element of document.querySelectorAll("body *")) {
  const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim()) || ["INPUT", "SELECT", "TEXTAREA"].includes(element.tagName);
  if (!own || !element.checkVisibility({opacityProperty: true, visibilityProperty: true}) || element.closest("[disabled], script, style, noscript")) continue;
  const style = getComputedStyle(element), colour = parse(element instanceof SVGElement ? style.fill : style.color);
  const [one, other] = [light(colour), light(behind(element))].sort((a, b) => b - a), ratio = (one + 0.05) / (other + 0.05);
  const large = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.66 && style.fontWeight >= 700);
  if (ratio < (large ? 3 : 4.5)) poor.push(`${element.tagName} ${element.className.baseVal ?? element.className} "${element.textContent.trim().slice(0, 30)}": ${ratio.toFixed(2)}`);
}
return [...new Set(poor)];
"""
UNNAMED = """
const named = (element) => element.labels?.length || element.getAttribute("aria-label") || element.getAttribute("aria-labelledby") || (element.tagName === "BUTTON" && element.textContent.trim());
const ids = [...document.querySelectorAll("[id]")].map((one) => one.id), twice = ids.filter((id, i) => ids.indexOf(id) !== i);
return [...[...document.querySelectorAll("input, select, textarea, button")].filter((one) => !named(one)).map((one) => one.outerHTML.slice(0, 120)), ...twice.map((id) => `id ${id} twice`)];
"""


# Elements outside of the window or of their drawing, with too many digits, or too small for a finger.
OUTSIDE = """
const width = document.documentElement.clientWidth, found = [];
for (const one of document.querySelectorAll("#tiles *, #results *, #inputs *")) {
  if (!one.checkVisibility() || one.closest(".scroll, textarea, .shape, .gears") || one.children.length && !one.matches(".tile")) continue;
  const box = one.getBoundingClientRect();
  if (box.width && (box.left < -1 || box.right > width + 1)) found.push(`${one.tagName} ${one.textContent.trim().slice(0, 40)}: ${Math.round(box.left)} to ${Math.round(box.right)}`);
}
for (const text of document.querySelectorAll("svg text")) {
  if (!text.checkVisibility()) continue;
  const box = text.getBoundingClientRect(), room = text.closest("svg").getBoundingClientRect();
  if (box.left < room.left - 1 || box.right > room.right + 1 || box.top < room.top - 1 || box.bottom > room.bottom + 1) found.push(`cut: ${text.textContent}`);
}
for (const one of document.querySelectorAll("main *, header *"))
  if (one.checkVisibility() && !one.closest("#yaml") && [...one.childNodes].some((node) => node.nodeType === 3 && /[1-9]\\d*\\.\\d{7}|\\b0\\.0*[1-9]\\d{6}/.test(node.data))) found.push(`digits: ${one.textContent.slice(0, 60)}`);
for (const one of document.querySelectorAll("input:not([type=range], [type=file], [type=checkbox])"))
  if (one.checkVisibility() && /[1-9]\\d*\\.\\d{7}|\\b0\\.0*[1-9]\\d{6}/.test(one.value)) found.push(`digits: ${one.id} ${one.value}`);
return found;
"""
SMALL = """
return [...document.querySelectorAll("button, .button, select, input:not([type=range], [type=file], [type=checkbox]), summary, nav a")].filter((one) => one.checkVisibility() && !one.closest(".skip"))
  .map((one) => [one.getBoundingClientRect(), one]).filter(([box]) => box.height < arguments[0] - 0.5).map(([box, one]) => `${one.tagName} ${one.id} ${one.textContent.trim().slice(0, 20)}: ${Math.round(box.height)} px`);
"""
# Words of tables that are broken within, at neither a dot nor an underscore, and figures with more than five digits.
BROKEN = """
const found = [];
for (const cell of document.querySelectorAll("#results table :is(th, .figure)")) {
  if (!cell.checkVisibility()) continue;
  const digits = cell.textContent.split(" ")[0].replace(/^[0.]+|[^\\d]/g, "").replace(/0+$/, "");
  if (cell.matches(".variants .figure") && digits.length > 5) found.push(`digits: ${cell.textContent}`);
  for (const node of [...cell.childNodes].flatMap((one) => one.nodeType === 3 ? [one] : [...one.childNodes].filter((inner) => inner.nodeType === 3)))
    for (const word of node.data.matchAll(/[^\\s._(),-]+/g)) {
      const range = document.createRange();
      range.setStart(node, word.index);
      range.setEnd(node, word.index + word[0].length);
      if (new Set([...range.getClientRects()].map((box) => Math.round(box.top))).size > 1) found.push(`broken: ${word[0]} of ${cell.textContent}`);
    }
}
return found;
"""
# From the beginning of a label to its field, and from the label's last letter to it.
LABELS = """
return [...document.querySelectorAll("#form .row")].filter((row) => row.checkVisibility()).map((row) => {
  const label = row.querySelector("label"), field = row.querySelector(".value > :first-child").getBoundingClientRect(), range = document.createRange();
  range.selectNodeContents(label);
  const text = range.getBoundingClientRect();
  return [row.dataset.key, field.top > text.bottom - 2 ? 0 : field.left - text.left];
});
"""


class Server:
    """`orbearing open` without a browser."""

    def __init__(self, *words, folder=None, browser=None):
        """`browser`: a folder of programs that come first, among them xdg-open."""
        env = {**os.environ, "PATH": f"{browser}:{os.environ['PATH']}"} if browser else None
        words = [*map(str, words), *([] if browser else ["--no-browser"])]
        self.process = subprocess.Popen([os.environ["ORBEARING"], "open", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=folder, env=env)
        self.address = self.process.stdout.readline().strip()

    def stop(self):
        self.process.terminate()
        self.process.communicate(timeout=SECONDS)


def origin_of(address):
    return re.match(r"http://127\.0\.0\.1:\d+/", address)[0]


def browser(downloads):
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1600,1000", "--lang=en",
                 "--disable-background-networking", "--disable-component-update", "--no-first-run"):
        options.add_argument(word)
    options.add_experimental_option("prefs", {"download.default_directory": str(downloads), "download.prompt_for_download": False})
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


class PageSteps:
    """The steps with either engine: `address` is that of the page, with nothing opened."""

    address = ""
    origins = []  # of further servers of a test
    revolutions = 150  # of a sweep in motion: some seconds a point, in which a browser sees it move
    allowed = allowed_in_motion = 0.0  # relative difference from the numbers of the command line: none
    requests = set()
    console = []

    @classmethod
    def begin(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        cls.driver = browser(cls.folder)
        cls.addClassCleanup(cls.driver.quit)

    def setUp(self):
        self.width(1600)
        self.scheme("light")
        self.driver.get(self.address)
        self.until(lambda: self.script("return document.body.classList.contains('ready')"), "the page is ready")

    def tearDown(self):
        """What the browser asked for and said, of every test."""
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                type(self).requests.add(message["params"]["request"]["url"])
        type(self).console += [line["message"] for line in self.driver.get_log("browser") if not self.is_expected(line["message"])]

    @staticmethod
    def is_expected(line):
        """A refused case is an answer of the program, which Chromium notes as a request that failed."""
        return re.search(r"/request .*status of 422|/units .*status of 422", line) is not None

    def script(self, text, *values):
        return self.driver.execute_script(text, *values)

    def until(self, condition, what):
        """Asked again while the page draws anew: an element that was replaced between finding and reading it is not an answer."""
        wait = WebDriverWait(self.driver, SECONDS, poll_frequency=0.1, ignored_exceptions=[StaleElementReferenceException])
        wait.until(lambda _: condition(), f"waited in vain until {what}")

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def width(self, pixels):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": pixels, "height": 900, "deviceScaleFactor": 1, "mobile": False})

    def scheme(self, name):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": name}]})

    def press(self, key):
        """A key, wherever the focus is."""
        webdriver.ActionChains(self.driver).send_keys(key).perform()

    def computed(self):
        self.until(lambda: self.script("return !document.body.classList.contains('busy')"), "the results are there")

    def open_template(self, name):
        self.find(f"[data-template={name}]").click()
        self.until(lambda: self.find("#tiles").is_displayed(), "lives are shown")
        self.computed()

    def write(self, text):
        """The whole text of the case, in the view of the text."""
        if not self.find("#yaml").is_displayed():
            self.find("#to-text").click()
        self.script("arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('input', {bubbles: true}))", self.find("#yaml"), text)
        self.computed()

    def open_text(self, text):
        self.open_template("wind-stage")
        self.write(text)

    @property
    def text(self):
        return self.script("return document.getElementById('yaml').value")

    def enter(self, key, value):
        """A value of the form, by the keyboard."""
        self.script("arguments[0].click()", self.show_row(key).find_element(By.CSS_SELECTOR, "label"))
        field = self.find(f"[id='in-{key}']")
        if field.tag_name == "select":
            Select(field).select_by_value(value)
        else:
            field.send_keys(Keys.CONTROL, "a")
            field.send_keys(value, Keys.TAB)
        self.computed()

    def show_row(self, key):
        """The row of an input, found by its name where it is not shown."""
        row = self.find(f"[data-key='{key}']")
        if not row.is_displayed():
            search = self.find("#search")
            search.clear()
            search.send_keys(key)
        return row

    def program(self, command, *words, text=None):
        """What the command line prints for the case as it is in the page."""
        file = self.folder / "as_in_the_page.yaml"
        file.write_text(self.text if text is None else text)
        return run(command, file, "--json", *words)

    def answer(self, command, *words):
        done = self.program(command, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def assert_same(self, shown, expected, what=None, allowed=None):
        """A number that is shown, or several, beside those of the command line."""
        allowed = self.allowed if allowed is None else allowed
        if isinstance(expected, (list, tuple)):
            self.assertEqual(len(shown), len(expected), what)
            for one, other in zip(shown, expected):
                self.assert_same(one, other, what, allowed)
        elif allowed and isinstance(expected, float):
            self.assertLessEqual(abs(shown - expected), allowed * abs(expected), what)
            if allowed <= ROUND_OFF:
                self.assertEqual(f"{shown:.6g}", f"{expected:.6g}", what)  # the digits that the command line shows
        else:
            self.assertEqual(shown, expected, what)

    def cursor(self):
        return float(self.find("#cursor-value .figure").get_attribute("data-value"))

    def assert_numbers_of_the_command_line(self):
        """Tiles and the table of all results, at the cursor."""
        result = self.answer("run", "--set", f"input.speed={self.cursor()!r} rpm")
        point = result["points"][0]
        tiles = {tile.get_attribute("data-key"): tile.find_element(By.CSS_SELECTOR, ".figure").get_attribute("data-value") for tile in self.all("#tiles .tile")}
        self.assertTrue(set(LIVES) <= set(tiles))
        for key, value in tiles.items():
            self.assert_same(float(value) if value else None, self.judged(result, key), key)
        self.script("document.getElementById('card-point').open = true")
        self.until(lambda: self.all("#card-point td[data-key=L10h]"), "all results are shown")
        cells = self.script("return [...document.querySelectorAll('#card-point .tall td[data-key]')].map((cell) => [cell.dataset.key, cell.querySelector('.figure')?.dataset.value ?? cell.textContent])")
        self.assertGreater(len(cells), 30)
        for key, value in cells:
            self.assert_same(float(value) if isinstance(point[key], (int, float)) else value, point[key], key)

    @staticmethod
    def judged(result, key):
        """What a tile shows: the value of the verdict; of the governing life without one that of the bearing with the shortest."""
        point, verdict = result["points"][0], next((one for one in result.get("verdicts", []) if one["key"] == key and one["value"] is not None), None)
        if verdict:
            return verdict["value"]
        if key == (result.get("life_key") or result["peak"]["life_key"]):
            return next(value for value in (point.get(f"carrier_{key}"), point.get(f"shortest_{key}"), point[key]) if value is not None)
        return point[key]

    def test_a_template_is_opened(self):
        self.assertEqual({one.get_attribute("data-template") for one in self.all("#templates button")},
                         {"wind-stage", "e-drive", "industrial", "roller-bearing", "ball-bearing", "duplex", "defect"})
        self.open_template("industrial")
        self.assertEqual(self.text, (CASES / "templates" / "industrial.yaml").read_text())
        self.assert_pictures_show_this_page()
        self.assert_numbers_of_the_command_line()

    def assert_pictures_show_this_page(self):
        """Item 7: pictures in README and guide have the parts that the page has now; docs/page/pictures.py makes them."""
        here = self.script(pictures.PARTS)
        for file in sorted(pictures.FOLDER.glob("*.jpg")):
            self.assertEqual(pictures.parts_in(file), here, f"{file.name} shows another page: make the pictures anew by docs/page/pictures.py")
            self.assertLess(file.stat().st_size, pictures.LARGEST)

    def test_every_template_computes(self):
        for name in ("wind-stage", "e-drive", "roller-bearing", "ball-bearing", "duplex"):
            with self.subTest(name):
                self.find("#to-start").click() if not self.find("#start").is_displayed() else None
                self.find(f"[data-template={name}]").click()
                self.computed()
                self.assertFalse(self.all("#errors .error"))
                self.assertTrue(any(card.is_displayed() for card in self.all("#card-life, #card-result")))
                governing = self.answer("check").get("governing_life")
                if governing:
                    tile = self.all("#tiles .tile")[0]
                    self.assertEqual((tile.get_attribute("data-key"), "chief" in tile.get_attribute("class")), (governing["key"], True))

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_clearance_speed_and_oil_are_changed(self):
        self.open_template("wind-stage")
        before = self.find("#tiles [data-key=L10mrh] .figure").get_attribute("data-value")
        self.enter("bearing.radial_clearance", "90")
        self.enter("input.speed", "18")
        self.enter("lubricant.temperature", "70")
        self.enter("lubricant.grade", "ISO VG 460")
        self.assertIn("radial_clearance: 90 um   # of the running bearing", self.text)
        self.assertIn("speed: 18 rpm", self.text)
        self.assertIn("{grade: ISO VG 460, temperature: 70 degC}", self.text)
        self.assertEqual([line for line in self.text.splitlines() if line.startswith("#")],
                         [line for line in (CASES / "templates" / "wind-stage.yaml").read_text().splitlines() if line.startswith("#")])
        self.assert_numbers_of_the_command_line()
        self.assertNotEqual(before, self.find("#tiles [data-key=L10mrh] .figure").get_attribute("data-value"))

    def test_a_unit_converts_its_value(self):
        self.open_template("wind-stage")
        row = self.show_row("bearing.radial_clearance")
        Select(row.find_element(By.CSS_SELECTOR, ".unit")).select_by_value("mm")
        self.until(lambda: self.find("[id='in-bearing.radial_clearance']").get_attribute("value") == "0.07", "the value is converted")
        self.assertIn("radial_clearance: 0.07 mm", self.text)

    def press_chip(self, selector):
        """A real press of the mouse: the row opens or closes under it."""
        chip = self.find(selector)
        self.script("arguments[0].scrollIntoView({block: 'center'})", chip)
        webdriver.ActionChains(self.driver).move_to_element(chip).click().perform()
        self.computed()

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_power_or_torque_and_the_catalogue(self):
        self.open_text(MOVING)
        self.press_chip("[data-instead='input.torque']")
        torque = float(re.search(r"^input: \{speed: 9000 rpm, torque: (\S+) N\.m\}", self.text, re.M)[1])
        self.assertAlmostEqual(torque * 9000 * 3.141592653589793 / 30 / 150e3, 1.0, places=11)
        self.assert_numbers_of_the_command_line()
        self.press_chip("[data-instead='input.torque_curve']")
        self.assertEqual(re.findall(r"\[(\d+) rpm, [\d.]+ N\.m\]", self.text), ["8000", "9000", "10000"])
        self.assert_numbers_of_the_command_line()
        self.write(MOVING.replace("  rollers: 15          # in each bearing\n  roller_diameter: 5.24 mm\n  roller_length: 5.7 mm\n  pitch_diameter: 35.64 mm\n", "  designation: NU 2051\n")
                   .replace("  bore: 25 mm\n  outside_diameter: 47 mm\n  width: 11.9 mm\n  cage: {inner_diameter: 33.44 mm, outer_diameter: 38.54 mm, width: 9 mm, density: 1310 kg/m3, guide_land_diameter: 38.88 mm}\n", ""))
        offered = [one.get_attribute("data-take") for one in self.all(".row.bad [data-take]")]
        self.assertEqual(offered, re.search(r"nearest: ([^.]*)", self.program("check").stderr)[1].split(", "))
        self.press_chip(f"[data-take='{offered[0]}']")
        self.assertIn(f"designation: {offered[0]}\n", self.text)
        self.assertNotIn("is not in the catalogue", "".join(row.text for row in self.all(".row.bad")))

    def test_two_mistakes_are_shown_at_their_fields_and_mended(self):
        self.open_template("wind-stage")
        self.enter("bearing.rollers", "2")
        self.enter("bearing.radial_clearance", "5000")
        wrong = self.all(".row.bad")
        self.assertEqual([row.get_attribute("data-key") for row in wrong], ["bearing.rollers", "bearing.radial_clearance"])
        told = self.program("check").stderr.splitlines()
        for row in wrong:
            key, text = row.get_attribute("data-key"), row.find_element(By.CSS_SELECTOR, ".error").text
            self.assertTrue(any(line.endswith(f" {key}: {text}") for line in told), f"{key}: {text} is not among {told}")
            self.assertEqual(row.find_element(By.CSS_SELECTOR, "input").get_attribute("aria-invalid"), "true")
        self.assertEqual(self.find("#mend span").text, "2 errors: the results are those of the last valid case")
        self.find("#mend button").click()  # stays in sight where the form is scrolled
        self.assertEqual(self.driver.switch_to.active_element.get_attribute("name"), "bearing.rollers")
        self.enter("bearing.rollers", "16")
        self.enter("bearing.radial_clearance", "70,5")  # a decimal comma is no unit: the number is mended where it stands
        self.assertTrue(self.all(".row.bad"))
        self.enter("bearing.radial_clearance", "70")
        self.assertEqual([row.text for row in self.all(".row.bad, #errors .error")], [])
        self.assertFalse(self.find("#mend").is_displayed())
        self.assert_numbers_of_the_command_line()

    def test_tab_goes_from_a_value_to_the_next_and_an_emptied_field_is_taken_out(self):
        self.open_template("wind-stage")
        self.assertIn("laminae:", self.text)
        self.script("arguments[0].focus()", self.find("[id='in-bearing.laminae']"))
        self.press(Keys.TAB)
        self.assertNotIn("reset", self.driver.switch_to.active_element.get_attribute("class"))
        self.enter("bearing.laminae", Keys.DELETE)
        self.assertNotIn("laminae:", self.text)

    def test_text_and_form_are_one(self):
        self.open_text(MOVING)
        self.assertEqual(self.find("[id='in-bearing.rollers']").get_attribute("value"), "15")
        self.write(MOVING.replace("rollers: 15", "rollers: 14"))
        self.assertEqual(self.find("[id='in-bearing.rollers']").get_attribute("value"), "14")
        self.enter("bearing.rollers", "13")
        self.assertEqual(self.text, MOVING.replace("rollers: 15", "rollers: 13"))
        self.enter("bearing.radial_clearance", "12")
        self.assertIn("radial_clearance: 12 um", self.text)
        self.assertNotIn("a close fit", self.text)  # the reason was that of the former value
        self.write("name: x\n  foo: [a")
        self.assertIn("Line 2", self.find("#errors").text)

    def test_texts_of_a_case_are_never_markup(self):
        self.open_text(MOVING.replace("reducer of the page", '"<img src=x onerror=alert(1)><b>name</b>"'))
        self.assertIn("<b>name</b>", self.find("#case-name").text)
        self.assertFalse(self.all("main img, header b"))

    def test_inputs_that_a_fidelity_does_not_use_are_marked(self):
        self.open_text(MOVING)
        row = self.find("[data-key='bearing.cage.guide_land_diameter']")
        self.assertEqual([one.text for one in row.find_elements(By.CSS_SELECTOR, ".unused-note")], ["Not used by quasi-static"])
        Select(self.find("#fidelity")).select_by_value("dynamic")
        self.assertFalse(row.find_elements(By.CSS_SELECTOR, ".unused-note"))

    def test_the_cursor_links_curves_drawings_and_numbers(self):
        self.open_text(MOVING)
        slider = self.find("#cursor")
        slider.send_keys(Keys.HOME)
        self.computed()
        self.assertEqual(self.cursor(), 8000.0)
        for card in ("life", "loads"):
            self.assertEqual(float(self.find(f"#card-{card} .cursor line").get_attribute("data-x")), 8000.0)
        self.assert_numbers_of_the_command_line()
        loads = self.answer("run", "--set", "input.speed=8000 rpm")["roller_loads"][0]
        first = self.find("#card-bearing .bar.inner[data-element='1']")
        self.assert_same(float(first.get_attribute("data-load")), loads["inner_load_N"][0])

    def test_the_life_curve_is_that_of_a_sweep(self):
        self.open_text(MOVING)
        self.script("document.getElementById('card-more').open = true")
        speeds = [float(x) for x in self.export("#take-csv", "input_speed_rpm")]
        self.assertEqual((speeds[0], speeds[-1]), (8000.0, 10000.0))
        points = self.answer("sweep", "--grid-only", "--set", "sweep={input.speed: [%s]}" % ", ".join(f"{speed!r} rpm" for speed in speeds))["points"]
        with (self.folder / "wind-stage.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(points))
        for row, point in zip(rows, points):
            for key, value in point.items():
                self.assertEqual(row[key], "" if value is None else row[key])
                if isinstance(value, float):
                    self.assert_same(float(row[key]), value, key)

    def taken(self, name):
        """A downloaded file. The browser reserves its name by an empty file, which the whole one replaces."""
        file = self.folder / name
        self.until(lambda: file.exists() and file.stat().st_size > 0, f"{name} is there")
        return file

    def export(self, button, column):
        """Column of the CSV file that a button of the dialog saves."""
        self.find("#to-take").click()
        (self.folder / "wind-stage.csv").unlink(missing_ok=True)
        self.find(button).click()
        file = self.taken("wind-stage.csv")
        self.find("#take .close").click()
        with file.open() as text:
            return [row[column] for row in csv.DictReader(text)]

    def test_a_sweep_is_run_stopped_and_continued(self):
        self.open_text(f"{MOVING}simulation: {{observed_revolutions: {self.revolutions}}}\n")
        Select(self.find("#fidelity")).select_by_value("dynamic")
        card = self.find("#card-motion")
        start, stop, proceed = card.find_elements(By.CSS_SELECTOR, ".player button")
        start.click()
        told = lambda: card.find_element(By.CSS_SELECTOR, ".told").text  # noqa: E731
        self.assert_drawn_while_computed(card)
        self.until(lambda: re.search("[12] of 3 points", told()), "a point is done")
        stop.click()
        self.until(lambda: "Stopped" in told(), "the sweep has stopped")
        kept = int(re.search(r"Stopped: (\d)", told())[1])
        self.assertTrue(1 <= kept < 3, told())
        self.assertIn("revolutions of the cage", card.find_element(By.CSS_SELECTOR, ".live").text)
        stopped = told()
        self.assert_the_run_fits_at_every_width(card)
        self.enter("input.power", "151")
        self.assertEqual((told(), proceed.is_enabled()), (f"{stopped} Of another case: input.power 150 kW there, 151 kW here.", False))
        self.assertFalse(any(one.is_displayed() for one in self.all("#card-motion .live, #card-motion circle[data-x]")))
        self.enter("input.power", "150")
        self.assertEqual((told(), proceed.is_enabled()), (stopped, True))
        self.assertTrue(card.find_element(By.CSS_SELECTOR, ".live").is_displayed())
        proceed.click()
        self.until(lambda: "Done: 3 points" in told(), "the sweep is done")
        drawn = {float(circle.get_attribute("data-x")): float(circle.get_attribute("data-y")) for circle in self.all("#card-motion [data-series=cage_slip] circle")}
        self.assertEqual(len(drawn), 3)
        again = sorted(drawn)[:1 if LEFT_TO_FULL else 3]
        few = "sweep.input.speed=[" + ", ".join(f"{speed!r} rpm" for speed in again) + "]"
        expected = {point["input_speed_rpm"]: point["cage_slip"] for point in self.answer("sweep", "--set", few, "--grid-only", "--fidelity", "dynamic")["points"]}
        self.assertEqual(sorted(expected), again)
        for speed, slip in expected.items():
            self.assert_same(drawn[speed], slip, f"cage slip at {speed} rpm", self.allowed_in_motion)

    def assert_the_run_fits_at_every_width(self, card):
        for pixels in LISTED:
            self.width(pixels)
            self.assertEqual(self.script(OUTSIDE), [], pixels)
            for one in card.find_elements(By.CSS_SELECTOR, ".player button"):
                self.assertTrue(one.is_displayed() and (pixels > NARROW or one.size["height"] >= TOUCHED), pixels)

    def assert_drawn_while_computed(self, card):
        """Rollers and cage of a bearing in motion move while it is computed, beside the pace of the computation."""
        live = lambda selector: card.find_element(By.CSS_SELECTOR, f".live {selector}")  # noqa: E731
        self.until(lambda: live("svg").is_displayed(), "the bearing in motion is drawn")
        place = lambda: live(".element.first").get_attribute("transform")  # noqa: E731
        first, cage = place(), live(".cage").get_attribute("transform")
        self.until(lambda: place() != first and live(".cage").get_attribute("transform") != cage, "rollers and cage move")
        self.until(lambda: self.script("return [...document.querySelectorAll('.live .bar.inner')].some((bar) => Number(bar.dataset.load) > 0)"), "loads are drawn")
        data = lambda name: float(card.find_element(By.CSS_SELECTOR, ".live").get_attribute(f"data-{name}") or 0.0)  # noqa: E731
        # Between two motions of a point there is no pace for a moment: text and pace are read together.
        line = r"^At [\d\u202f]+ rpm: .* s of motion, .* revolutions of the cage, slip .* %\. Computed at .* revolutions a second, .* times real time\. \d+ % of (?:this run|run \d+ of at most \d+) done\. At most .* s to go in this run\.$"
        seen = []

        def has_pace():
            told = live(".told").text
            if re.search(line, told) and data("pace") >= LEAST_PACE:
                seen.append(told)
            return seen

        self.until(has_pace, "the pace is shown")
        print(f"engine {self.script('return document.body.dataset.engine')}: {seen[0]}")

    def test_two_variants_are_pinned_and_compared(self):
        self.open_text(MOVING)
        self.find("[data-pin=A]").click()
        first = self.answer("run")["points"][0]
        self.enter("bearing.radial_clearance", "30")
        self.find("[data-pin=B]").click()
        second = self.answer("run")["points"][0]
        self.enter("bearing.radial_clearance", "10")
        inputs = [[cell.text for cell in row.find_elements(By.CSS_SELECTOR, "th, td")] for row in self.all(".inputs-differ tr")]
        self.assertEqual(inputs, [["bearing.radial_clearance", "10 um", "10 um", "30 um"]])
        shown = {row.find_element(By.CSS_SELECTOR, "th").text: [float(one.get_attribute("data-value")) for one in row.find_elements(By.CSS_SELECTOR, ".figure")] for row in self.all(".results-differ tr")}
        self.assert_same(shown["L10rh"], [first["L10rh"], first["L10rh"], second["L10rh"]])
        self.assertEqual({key.get_attribute("data-series") for key in self.all("#card-life .curve[data-series^='life_h']")}, {"life_h", "life_h A", "life_h B"})

    def test_a_variant_by_an_input_that_another_replaces_is_refused(self):
        """A clearance beside a clearance class: both variants would have the same results."""
        classed = (CASES / "reducer_nu204" / "case.yaml").read_text(encoding="utf-8")
        self.open_text(classed)
        self.find("[data-pin=A]").click()
        self.write(classed.replace("  clearance_class: CN\n", "  clearance_class: CN\n  radial_clearance: 10 um\n"))
        self.find("[data-pin=B]").click()
        refusal = self.find("#card-variants [role=alert]").text
        self.assertTrue(refusal.startswith("Not pinned as B: no input differs from A. bearing.radial_clearance: 10 um has no effect: it counts only where "
                                           "bearing.clearance_class is not given"), refusal)
        self.assertEqual([len(self.all(f"[data-take={name}]")) for name in "AB"], [1, 0])
        self.write(classed.replace("clearance_class: CN", "clearance_class: C3"))
        self.find("[data-pin=B]").click()
        self.assertEqual((len(self.all("[data-take=B]")), self.all("#card-variants [role=alert]")), (1, []))

    def test_the_rollers_are_played_and_moved(self):
        self.open_text(MOVING)
        place = lambda: self.find("#card-bearing .element.first").get_attribute("transform")  # noqa: E731
        still = place()
        play = self.find("#card-bearing .play")
        play.click()
        self.until(lambda: place() != still, "the rollers move")
        play.click()
        stopped = place()
        time.sleep(0.3)
        self.assertEqual(place(), stopped)
        slider = self.find("#card-bearing .player input[type=range]")
        slider.send_keys(Keys.END)
        end = place()
        slider.send_keys(Keys.ARROW_LEFT)
        self.assertNotEqual(place(), end)
        cage, outer = self.script("return [...document.querySelectorAll('#card-bearing .told .figure')].map((one) => Number(one.dataset.value)).slice(0, 2)")
        planet = next(one["value"] for one in self.answer("check")["derived"] if one["path"] == "operation.planet_speed")
        self.assertAlmostEqual(outer / planet, 1.0, places=12)
        self.assertAlmostEqual(cage / outer, (1 + 5.24 / 35.64) / 2, places=12)  # at pure rolling about a stationary pin

    def open_card(self, name):
        """Opened, and in the middle of the window: the bar with the cursor stands over what is at its top."""
        self.script("const card = document.getElementById(arguments[0]); card.open = true; card.scrollIntoView({block: 'center'})", f"card-{name}")
        return self.find(f"#card-{name}")

    def numbers(self, card):
        return [float(one.get_attribute("data-value")) for one in card.find_elements(By.CSS_SELECTOR, ".figure") if one.get_attribute("data-value")]

    def test_bins_of_a_spectrum_beside_their_damage(self):
        bins = "spectrum: [{power: 150 kW, speed: 9000 rpm, share: 0.25}, {power: 90 kW, speed: 8000 rpm, share: 0.75}]\n"
        self.open_text(MOVING.replace("gearset:\n", f"{bins}gearset:\n", 1))
        expected = self.answer("sweep", "--grid-only")["spectrum"]
        shown = self.numbers(self.open_card("spectrum"))
        self.assert_same(shown[-1], expected["life_h"])
        for i, one in enumerate(expected["bins"]):
            self.assert_same(shown[6 * i:6 * i + 6], [one["power_kW"], one["torque_N_m"], one["speed_rpm"], 100 * one["share"], 100 * one["damage_share"], one["life_h"]])

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_crown_modes_mesh_and_assumptions(self):
        self.open_text(MOVING)
        card = self.open_card("crown")
        card.find_element(By.CSS_SELECTOR, "button").click()
        self.until(lambda: card.find_elements(By.CSS_SELECTOR, "table"), "the crown is computed")
        best = self.answer("crown", "--set", "input.speed=9000 rpm")["recommended"]
        self.assert_same(self.numbers(card)[:4], [best["drop_um"], best["least_drop_um"], best["most_drop_um"], best["half_space_life_h"]], allowed=self.allowed and SEARCHED)
        take = card.find_element(By.XPATH, ".//button[contains(., 'Put this drop')]")
        self.script("arguments[0].scrollIntoView({block: 'center'})", take)
        take.click()
        self.computed()
        self.assertIn("  profile:\n    kind: iso16281\n    drop: ", self.text)
        self.assertEqual("laminae:" in self.text, "laminae:" in MOVING)  # lives by ISO/TS 16281 have laminae of their own
        self.assertFalse(self.all(".row.bad, #errors .error"))
        self.write(MOVING)
        self.open_card("modes")
        self.until(lambda: self.all("#card-modes circle[data-y]"), "the modes are computed")
        shown = {float(one.get_attribute("data-y")) for one in self.all("#card-modes circle[data-x='9000']")}
        modes = [mode for mode in self.answer("modes", "--speed", "9000 rpm")["modes"] if mode["frequency_Hz"] > 0]
        self.assert_same(sorted(shown), sorted({mode["frequency_Hz"] for mode in modes}), allowed=self.allowed and SEARCHED)
        self.assert_shape_of(modes)
        card = self.open_card("mesh")
        self.until(lambda: card.find_elements(By.CSS_SELECTOR, "table"), "the meshes are computed")
        first = self.answer("mesh")["meshes"][0]
        self.assert_same(self.numbers(card)[:4], [first[key] for key in ("contact_ratio", "mean_N_per_m", "min_N_per_m", "max_N_per_m")], allowed=self.allowed and SEARCHED)
        card = self.open_card("assumptions")
        card.find_element(By.CSS_SELECTOR, "button").click()
        self.until(lambda: "Life changes" in card.text, "effects are computed")
        effects = {one["path"]: one["elasticity"] for one in self.answer("sensitivities", "--set", "input.speed=9000 rpm")["inputs"]}
        assumed = [one["path"] for one in self.answer("check")["inputs"] if one["standing"] != "given"]
        largest = max(assumed, key=lambda path: abs(effects.get(path) or 0.0))
        self.assertEqual(card.find_element(By.CSS_SELECTOR, "tbody th").text, largest)

    def assert_shape_of(self, modes):
        """The drawing of the second mode that is chosen: members where `modes --json` has them, to the scale that it states."""
        self.until(lambda: self.all("#mode-choice option"), "the modes at the cursor are listed")
        Select(self.find("#mode-choice")).select_by_index(1)
        mode = modes[0] if modes[0]["multiplicity"] > 1 else modes[1]
        self.assert_same(self.numbers(self.find("#card-modes .halves"))[0], mode["frequency_Hz"], allowed=self.allowed and SEARCHED)
        distance = next(one["value"] for one in self.answer("check")["derived"] if one["path"] == "gearset.centre_distance")
        place = lambda name: [float(one) for one in re.match(r"translate\((\S+) (\S+)\)", self.find(f"#card-modes {name}").get_attribute("transform")).groups()]  # noqa: E731
        for name, row, rest in ((".sun-moved", 0, 0.0), (".ring-moved", 1, 0.0), (".planet-moved", 3, distance)):
            x, y = place(name)
            self.assertAlmostEqual(-y, rest + 0.22 * distance * mode["shape"][row][0], delta=1e-3)
            self.assertAlmostEqual(-x, 0.22 * distance * mode["shape"][row][1], delta=1e-3)

    def test_what_is_taken_away(self):
        self.open_text(MOVING)
        self.find("#to-take").click()
        self.find("#take-case").click()
        file = self.taken("wind-stage.yaml")
        self.assertEqual(file.read_text(), MOVING)
        self.assertEqual(self.find("#take-command").get_attribute("value"), "orbearing sweep wind-stage.yaml -o results")
        self.assertIn("case.sweep(fidelity=\"quasi-static\")", self.find("#take-python").get_attribute("value"))
        self.find("#take-json").click()
        file = self.taken("wind-stage.json")
        taken, expected = json.loads(file.read_text())["points"], self.answer("run", "--set", "input.speed=9000.0 rpm")["points"]
        self.assertEqual([[*point] for point in taken], [[*point] for point in expected])
        self.assert_same([*taken[0].values()], [*expected[0].values()])

    def test_the_keyboard_alone(self):
        first = self.find("#templates button")
        self.script("document.activeElement.blur()")
        for _ in range(12):
            self.press(Keys.TAB)
            if self.driver.switch_to.active_element == first:
                break
        self.assertEqual(self.driver.switch_to.active_element, first)
        first.send_keys(Keys.ENTER)
        self.until(lambda: self.find("#tiles").is_displayed(), "lives are shown")
        self.computed()
        reached = set()
        for _ in range(60):
            self.press(Keys.TAB)
            reached.add(self.script("return document.activeElement.id || document.activeElement.className || document.activeElement.tagName"))
        self.assertTrue({"play"} <= reached, sorted(reached))
        self.until(lambda: self.find("#cursor").is_displayed(), "the cursor over speed")
        self.find("#cursor").send_keys(Keys.ARROW_RIGHT)
        self.computed()
        self.assert_numbers_of_the_command_line()

    def test_the_list_at_three_widths(self):
        """The verdict first and before the inputs; a wrong unit, a mistake by another field; nothing cut, far away or too small for a finger."""
        for pixels in LISTED:
            with self.subTest(width=pixels):
                self.width(pixels)
                self.driver.get(self.address)
                self.until(lambda: self.script("return document.body.classList.contains('ready')"), "the page is ready")
                self.open_template("e-drive")
                self.write(re.sub(r"requirements:.*\n", REQUIRED, self.text))
                self.find("#to-text").click()
                self.assert_verdicts_are_seen()
                self.assertEqual(self.script(OUTSIDE), [])
                self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), pixels)
                if pixels <= NARROW:
                    self.assertEqual(self.script(SMALL, TOUCHED), [])
                    order = self.script("return ['tiles', 'inputs', 'cards'].map((id) => document.getElementById(id).getBoundingClientRect().top)")
                    self.assertEqual(order, sorted(order))
                    self.assertLess(self.script("return document.querySelector('.tile.chief').getBoundingClientRect().bottom + scrollY"), 900)
                self.assertLess(self.script("return document.getElementById('card-pressure').getBoundingClientRect().height"), 120)  # there is nothing to draw
                self.find("#search").send_keys("power")
                self.assert_a_wrong_unit_does_not_stay()
                self.assert_variants_are_readable(pixels)
                self.find("#search").clear()
                self.find("#search").send_keys("bearing")
                self.assertTrue(all(gap <= 260 for _, gap in self.script(LABELS)), self.script(LABELS))
                self.assert_a_mistake_is_at_the_changed_field()
                if pixels <= NARROW:
                    self.assertEqual(self.script(SMALL, TOUCHED), [])

    def assert_verdicts_are_seen(self):
        """Each requirement that fails, in words and colour, with all cards closed."""
        self.script("for (const card of document.querySelectorAll('.card')) card.open = false")
        result = self.answer("run", "--set", f"input.speed={self.cursor()!r} rpm")
        tiles = self.all("#tiles .tile")
        key = result.get("life_key") or result["peak"]["life_key"]
        self.assertEqual((tiles[0].get_attribute("data-key"), "chief" in tiles[0].get_attribute("class")), (key, True))
        self.assertTrue(tiles[0].text.startswith("Governing life"))
        shown = {tile.get_attribute("data-key"): tile for tile in tiles}
        failed = [one for one in result["verdicts"] if one["passed"] is False]
        self.assertTrue(failed)
        for one in result["verdicts"]:
            tile = shown[one["key"]]
            words = {True: "passed", False: "failed", None: "not judged"}[one["passed"]]
            self.assertTrue(tile.is_displayed())
            self.assertIn(words, tile.text)
            self.assert_same(float(tile.find_element(By.CSS_SELECTOR, ".figure").get_attribute("data-value")), one["value"], one["key"])
            if one["passed"] is False:
                red = self.script("return getComputedStyle(document.documentElement).getPropertyValue('--bad')")
                self.assertEqual(tile.find_element(By.CSS_SELECTOR, ".figure").value_of_css_property("color"), "rgba({}, {}, {}, 1)".format(*(int(red.strip()[i:i + 2], 16) for i in (1, 3, 5))))
        self.script("for (const card of document.querySelectorAll('#card-life, #card-loads, #card-bearing, #card-gears, #card-roller-loads, #card-pressure, #card-motion')) card.open = true")

    def assert_a_wrong_unit_does_not_stay(self):
        before = self.text
        self.enter("input.power", "170 Nm")
        row = self.show_row("input.power")
        self.assertIn("bad", row.get_attribute("class"))
        self.assertIn("unit", row.find_element(By.CSS_SELECTOR, ".error").text)
        self.enter("input.power", "160")
        self.assertEqual(self.text, before)
        self.assertFalse(self.all(".row.bad"))

    def assert_variants_are_readable(self, pixels):
        self.script("document.querySelector('[data-pin=A]').click(); document.getElementById('card-assumptions').open = true")
        self.enter("bearing.fit.inner_interference", "6.123456789")
        self.until(lambda: self.all(".inputs-differ td"), "the variants differ")
        self.assertEqual(self.script(BROKEN), [], pixels)
        self.assertEqual([one for one in self.script(OUTSIDE) if "in-bearing.fit.inner_interference" not in one], [])  # the field has what was typed
        self.enter("bearing.fit.inner_interference", "5")

    def assert_a_mistake_is_at_the_changed_field(self):
        self.enter("bearing.designation", "NU 2307")
        wrong = {row.get_attribute("data-key"): row.find_element(By.CSS_SELECTOR, ".error").text for row in self.all(".row.bad")}
        told = [line.partition(": ")[2] for line in self.program("check").stderr.splitlines()]
        self.assertEqual(list(wrong), ["bearing.designation"])
        self.assertIn(wrong["bearing.designation"], told)
        self.enter("bearing.designation", "NU 204")
        self.assertFalse(self.all(".row.bad"))

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_a_bearing_without_rings_and_what_cannot_be_chosen(self):
        self.open_text((CASES / "reducer_needles" / "case.yaml").read_text())
        self.assertIn("rings: none", self.text)
        self.assertEqual([len(self.all(f"#card-bearing svg .{name}")) for name in ("ring", "raceway", "pin")], [0, 1, 1])
        for pixels in LISTED:
            self.width(pixels)
            for word, key in (("grease", "life.lubrication"), ("pairing", "bearing.rows.arrangement"), ("spherical", "bearing.designation")):
                search = self.find("#search")
                search.clear()
                search.send_keys(word)
                self.assertTrue(self.find(f"[data-key='{key}']").is_displayed(), word)
            self.script("arguments[0].focus()", self.find("[id='in-bearing.designation']"))
            self.assertIn("tapered roller bearings and spherical roller bearings cannot be chosen",
                          self.find("[data-key='bearing.designation'] .meaning").text)

    def test_several_sets(self):
        """Tiles and drawings are of the set with the shortest life; a set without a bearing has none to draw; no field of a single set is empty."""
        self.open_text((CASES / "three_sets_150kW" / "case.yaml").read_text())
        limiting = self.answer("run", "--set", f"input.speed={self.cursor()!r} rpm")["points"][0]["limiting_set"]
        inputs = {one["path"] for one in self.answer("check")["inputs"]}
        self.assertIn(f"set {limiting}", self.all("#tiles .tile")[0].text)
        sets = {card: Select(self.find(f"#card-{card} select[aria-label='planetary set']")) for card in ("bearing", "gears")}
        with_bearing = [name for name in ("reduction", "coupling", "transmission") if f"sets.{name}.bearing.rollers" in inputs]
        self.assertEqual([one.get_attribute("value") for one in sets["bearing"].options], with_bearing)
        self.assertEqual([one.first_selected_option.get_attribute("value") for one in sets.values()], [limiting] * 2)
        self.assertEqual(self.all("#form .row.missing"), [])
        self.write((CASES / "lin_parker_1999" / "case.yaml").read_text())  # by masses and stiffnesses, without teeth
        self.assertEqual(self.all("#form .row.missing"), [])

    def test_contrast_names_and_width(self):
        self.open_template("industrial")
        self.find("[data-pin=A]").click()
        self.enter("bearing.per_planet", "99")
        self.assertTrue(self.all(".row.bad"))
        self.script("for (const card of document.querySelectorAll('.card')) card.open = true")
        for scheme in ("light", "dark"):
            self.scheme(scheme)
            self.assertEqual(self.script(CONTRAST), [], scheme)
        self.enter("bearing.per_planet", "2")
        self.assertEqual(self.script(UNNAMED), [])
        for pixels in WIDTHS:
            self.width(pixels)
            self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), pixels)
            self.assertTrue(self.find("#tiles").is_displayed())
        self.find("#to-text").click()
        for pixels in WIDTHS:
            self.width(pixels)
            self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), pixels, "with the text beside the form")
        for scheme in ("light", "dark"):
            self.scheme(scheme)
            self.assertEqual(self.script(CONTRAST), [], scheme)

    @classmethod
    def judge_traffic(cls):
        """After all tests of an engine: what was asked for and said."""
        outside = [url for url in cls.requests if not url.startswith((origin_of(cls.address), *cls.origins, "data:", "blob:", "about:", "file:"))]
        assert not outside, f"requests left the loopback address: {outside}"
        assert cls.requests, "the browser's log of requests is empty"
        assert not cls.console, f"the console of the browser says: {cls.console}"


class EngineA(PageSteps, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        server = Server()
        cls.addClassCleanup(server.stop)
        if not server.address.startswith("http"):
            raise unittest.SkipTest(f"orbearing open: {server.process.stderr.read().strip()}")
        cls.address = server.address
        cls.begin()

    @unittest.skipUnless(importlib.util.find_spec("weasyprint"), "WeasyPrint is missing")
    def test_the_assessors_page_is_taken_away_as_pdf(self):
        self.open_template("roller-bearing")
        self.find("#to-take").click()
        self.find("#take-pdf").click()
        file = self.taken("roller-bearing.pdf")
        self.assertEqual(file.read_bytes()[:5], b"%PDF-")
        self.find("#take .close").click()

    @unittest.skipIf(LEFT_TO_FULL, "two reports: tools/test --full, or by hand")
    def test_a_report_covers_the_operating_point_or_all_speeds(self):
        """Verdicts are those of what the report covers: the point at the cursor, or the worst of the speeds."""
        self.open_text(MOVING + "requirements: {life: 1000000000 h, life_key: L10h}\n")
        self.find("#to-take").click()
        pages = {}
        for scope in ("point", "speeds"):
            Select(self.find("#take-scope")).select_by_value(scope)
            self.find("#take-report").click()
            file = self.taken("wind-stage.html")
            pages[scope] = file.read_text()
            file.unlink()
        self.find("#take .close").click()
        self.assertEqual([bool(re.search(r"\d+ of \d+ points fail", text)) for text in pages.values()], [False, True])
        self.assertTrue(all("1 failed" in text for text in pages.values()))

    @classmethod
    def tearDownClass(cls):
        cls.judge_traffic()

    def test_a_browser_is_led_by_a_file_of_its_owner(self):
        """The file that the browser is started with leads to the page, which goes on by its cookie: no secret stays in the address."""
        place = self.folder / "led"
        place.mkdir()
        program = place / "xdg-open"
        program.write_text(f'#!/bin/sh\ncp "$1" {place}/open.tmp; mv {place}/open.tmp {place}/open.html\n')
        program.chmod(0o755)
        server = Server("industrial", browser=place)
        self.addCleanup(server.stop)
        self.origins.append(origin_of(server.address))
        self.until((place / "open.html").exists, "the browser is started")
        for go in (lambda: self.driver.get((place / "open.html").as_uri()), self.driver.refresh, lambda: self.driver.get(server.address)):
            go()
            self.until(lambda: self.all("#tiles .tile") and not self.all("body.busy"), "results are there")
            self.assertRegex(self.driver.current_url, re.escape(origin_of(server.address)) + "page-[0-9a-f]{32}/$")
        self.driver.get("about:blank")  # before the program ends

    def test_a_folder_of_results_is_continued(self):
        """Item 6: an unfinished sweep is listed at the start, shown, and gone on with in its folder; a crown folder is shown."""
        place = self.folder / "work"
        place.mkdir()
        (place / "case.yaml").write_text(MOVING)
        whole = json.loads(run("sweep", place / "case.yaml", "-o", place / "half", "--grid-only", "--json").stdout)
        crown = json.loads(run("crown", place / "case.yaml", "-o", place / "crown", "--drops", "0 um, 4 um, 8 um", "--tilts", "0 mrad", "--starts", 1, "--json").stdout)
        manifest = place / "half" / "manifest.jsonl"
        manifest.write_text("".join(manifest.read_text().splitlines(keepends=True)[:-1]))
        server = Server(folder=place)
        self.addCleanup(server.stop)
        self.origins.append(origin_of(server.address))
        self.driver.get(server.address)
        self.until(lambda: self.all("[data-folder=half]"), "the folders are listed")
        self.assertIn("quasi-static, 2 of 3 points", self.find("[data-folder=half]").text)
        self.find("[data-folder=half]").click()
        card = self.find("#card-motion")
        told = lambda: card.find_element(By.CSS_SELECTOR, ".told").text  # noqa: E731
        self.until(lambda: "2 of 3 points" in told(), "the folder is shown")
        self.computed()
        card.find_elements(By.CSS_SELECTOR, ".player button")[2].click()
        self.until(lambda: "Done: 3 points" in told(), "the sweep is done")
        with (place / "half" / "sweep.csv").open() as file:
            self.assertEqual([float(row["life_h"]) for row in csv.DictReader(file)], [point["life_h"] for point in whole["points"]])
        self.find("#to-start").click()
        self.until(lambda: "3 of 3 points" in self.find("[data-folder=half]").text, "the folder has all points")
        self.until(lambda: self.all("[data-folder=crown]"), "the crown is listed")
        self.find("[data-folder=crown]").click()
        self.until(lambda: self.all("#card-crown table"), "the crown is shown")
        self.assertEqual(self.numbers(self.find("#card-crown"))[0], (crown.get("recommended") or crown["optimum"])["drop_um"])


if __name__ == "__main__":
    unittest.main()
