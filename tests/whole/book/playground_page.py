"""What tests of the playground do to its pages, as a reader would."""

import atexit
import functools
import time
import unittest

from browser import STORE, start_browser
from support import ROOT
from playground.data import PAGE

ADDRESS = (ROOT / PAGE / "index.html").as_uri()
PHONE = {"width": 390, "height": 900, "deviceScaleFactor": 1, "mobile": False}

# Runs the body of an asynchronous function in the page, and gives what it returns.
RUN = """
const done = arguments[arguments.length - 1];
const given = arguments[0];
(async () => { %s })().then((value) => done({ value }), (error) => done({ error: `${error.name}: ${error.message}` }));
"""

# As the page begins where nothing is kept, but for what it has compiled.
RESET = """
const { run, go } = Raysteps.play.page;
localStorage.clear();
for (const path of Object.keys(run.edits)) run.edit(path, Raysteps.play.files[path]);
for (const panel of document.querySelectorAll("main > details[open]")) panel.open = false;
const initial = { scene: "mirrors", walk: "bvh_ordered", triangle: "watertight", view: "normals", size: 128 };
Object.assign(run.choices, initial);
for (const [name, value] of Object.entries(initial)) document.getElementById(name).value = value;
Object.assign(run.lit, { lamps: true, mirrors: true, gloss: true, all: false });
for (const name of Object.keys(run.lit)) document.getElementById(`plan-${name}`).checked = run.lit[name];
document.body.dataset.state = "asked";
Raysteps.play.page.open(run.files()[0]);
go();
"""


@functools.cache
def shared_browser():
    """One for all tests of a program: to start one takes seconds, and what it has compiled it keeps."""
    browser = start_browser()
    atexit.register(browser.quit)
    browser.set_script_timeout(280)
    return browser


class PlaygroundTest(unittest.TestCase):
    """Tests that share one browser, and what a reader does to a page."""

    def setUp(self):
        self.browser = shared_browser()
        self.browser.get_log("browser")
        self.addCleanup(self.browser.execute_script, "localStorage.clear()")

    def open(self, address=ADDRESS):
        """A page that is loaded anew."""
        self.browser.get("about:blank")
        self.browser.get(address)
        self.wait_for("picture")

    def begin(self):
        """The page as it begins, with a picture of 128 x 128 pixels: loaded only where no test before has done so."""
        is_there = self.browser.current_url == ADDRESS and self.browser.execute_script("return Raysteps.play.page?.gpu?.state === 'ready'")
        if not is_there:
            self.open()
        self.browser.execute_script(RESET)
        self.wait_for("picture")

    def run_in_page(self, body, given=None):
        """In a page that stands still."""
        answer = self.browser.execute_async_script(RUN % body, given)
        self.assertNotIn("error", answer)
        return answer["value"]

    def wait_for(self, *states, seconds=60):
        state = None
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            state = self.browser.execute_script("return document.body.dataset.state")
            if state in states:
                return state
            time.sleep(0.02)
        self.fail(f"the page is {state}, not {states}: {self.said()}")

    def wait_until(self, script, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            found = self.browser.execute_script(script)
            if found:
                return found
            time.sleep(0.02)
        return self.fail(f"this did not become true: {script}: {self.said()}")

    def said(self):
        return self.browser.execute_script("return document.getElementById('said').textContent")

    def text(self, name):
        """Of an element, shown or not."""
        return self.browser.execute_script("return document.getElementById(arguments[0]).textContent", name)

    def choose(self, name, value):
        self.browser.execute_script(
            "const select = document.getElementById(arguments[0]); select.value = arguments[1];"
            "document.body.dataset.state = 'asked'; select.dispatchEvent(new Event('change'))", name, value)

    def type_over(self, old, new):
        """As if a reader had changed these characters of the open file."""
        self.browser.execute_script(
            "const area = document.querySelector('textarea'); const [old, text] = arguments;"
            "if (!area.value.includes(old)) throw new Error(`the text has no ${old}`);"
            "area.value = area.value.replace(old, () => text); document.body.dataset.state = 'typed';"
            "area.dispatchEvent(new Event('input'))", old, new)

    def line_of(self, words):
        text = self.browser.execute_script("return document.querySelector('textarea').value")
        return 1 + text[:text.index(words)].count("\n")

    def complaints(self):
        return [entry["message"] for entry in self.browser.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]

    def keep_picture(self, name, width=1280, height=900):
        """A screenshot, for a person to look at. Nothing may be wider than the screen."""
        size = {**PHONE, "width": width, "height": height}
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        try:
            self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth"), width)
            folder = STORE / "screenshots"
            folder.mkdir(parents=True, exist_ok=True)
            self.browser.save_screenshot(str(folder / f"{name}.png"))
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
