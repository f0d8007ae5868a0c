"""Pictures of the page for README and guide, and what the page had on it when they were made.

    python3 docs/page/pictures.py build/release/bin/orbearing

Needs Debian's python3-selenium, chromium and chromium-driver. Each picture is a JPEG whose comment lists the parts of the page; a test
(tests/interface/page_in_browser.py) fails where the page has others: then make the pictures anew, and look at them.
"""

import base64
import json
import shutil
import subprocess
import sys
import time
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
TEMPLATE = "industrial"
SECONDS = 300
LARGEST = 150_000  # bytes
QUALITY = 70
PARTS = """
const shown = (selector) => [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility()).map((one) => one.textContent.trim());
return {groups: shown("#form > .group > summary h3"), cards: shown("#cards .card > summary h3"), buttons: shown("header button")};
"""


def with_comment(jpeg, text):
    """The picture with a comment behind its first marker."""
    comment = text.encode()
    return jpeg[:2] + b"\xff\xfe" + (len(comment) + 2).to_bytes(2, "big") + comment + jpeg[2:]


def parts_in(file):
    """What the comment of a picture lists."""
    data = file.read_bytes()
    if data[2:4] != b"\xff\xfe":
        raise ValueError(f"{file}: has no comment")
    return json.loads(data[6:4 + int.from_bytes(data[4:6], "big")])


class Camera:
    """The page in a browser without a window."""

    def __init__(self, program):
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service

        self.server = subprocess.Popen([program, "open", TEMPLATE, "--no-browser"], stdout=subprocess.PIPE, text=True)
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--lang=en", "--hide-scrollbars"):
            options.add_argument(word)
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.size(1400, 900)
        self.driver.get(self.server.stdout.readline().strip())
        self.computed()

    def close(self):
        self.driver.quit()
        self.server.terminate()
        self.server.wait()

    def script(self, text, *values):
        return self.driver.execute_script(text, *values)

    def size(self, width, height, scheme="light"):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        time.sleep(1.0)  # charts are drawn anew

    def until(self, condition):
        end = time.monotonic() + SECONDS
        while not self.script(f"return Boolean({condition})"):
            if time.monotonic() > end:
                raise SystemExit(f"waited in vain: {condition}")
            time.sleep(0.2)

    def computed(self):
        self.until("document.body.classList.contains('ready') && !document.body.classList.contains('busy') && document.querySelector('#tiles .tile')")

    def write(self, old, new):
        """Another text of the case."""
        self.script("""const text = document.getElementById("yaml");
                       text.value = text.value.replace(arguments[0], arguments[1]);
                       text.dispatchEvent(new Event("input", {bubbles: true}));""", old, new)
        self.computed()

    def keep(self, name, parts, card=None):
        """The window, or a card of it."""
        settings = {"format": "jpeg", "quality": QUALITY}
        if card:
            time.sleep(1.0)
            box = self.script("const {x, y, width, height} = document.getElementById(arguments[0]).getBoundingClientRect();"
                              "return {x: x + scrollX, y: y + scrollY, width, height}", card)
            settings.update(clip={**box, "scale": 1}, captureBeyondViewport=True)
        picture = base64.b64decode(self.driver.execute_cdp_cmd("Page.captureScreenshot", settings)["data"])
        picture = with_comment(picture, json.dumps(parts))
        if len(picture) > LARGEST:
            raise SystemExit(f"{name}: {len(picture)} bytes; required: at most {LARGEST}")
        (FOLDER / name).write_bytes(picture)
        print(f"{name}: {len(picture)} bytes")


def main(program):
    camera = Camera(program)
    try:
        parts = camera.script(PARTS)
        camera.script("document.querySelector('[data-pin=A]').click()")
        camera.write("temperature: 70 degC\nlife", "temperature: 85 degC\nlife")
        camera.keep("page.jpg", parts)
        for name in ("crown", "modes"):
            camera.script("document.getElementById(arguments[0]).open = true", f"card-{name}")
        camera.script("document.querySelector('#card-crown button').click()")
        camera.until("document.querySelector('#card-crown table') && document.querySelector('#mode-choice option')")
        camera.keep("crown.jpg", parts, "card-crown")
        camera.script("""const choice = document.getElementById("mode-choice");
                         choice.value = "translational 2";
                         choice.dispatchEvent(new Event("change"));""")
        camera.keep("modes.jpg", parts, "card-modes")
        camera.size(360, 760, "dark")
        camera.script("scrollTo(0, 0)")
        camera.keep("narrow.jpg", parts)
    finally:
        camera.close()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
