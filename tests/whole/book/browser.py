"""A headless browser that reads the book as it is served."""

import contextlib
import os
import shutil
import sys
import threading
import unittest
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.ui import WebDriverWait

from support import ROOT
from book.serve import make_server

STORE = Path(os.environ.get("RAYSTEPS_BOOK", ROOT / "build" / "default" / "book"))
SITE = STORE / "site"
NOT_RUN = 77  # CTest takes it for skipped
BETWEEN_LOOKS = 0.02  # seconds
SWITCHES = ("--headless=new", "--disable-dev-shm-usage", "--ignore-gpu-blocklist", "--hide-scrollbars")
SWIFTSHADER = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")


def leave_without(*programs):
    """Ends the program where one of these is missing."""
    for program in programs:
        if not shutil.which(program):
            print(f"book: not tested in a browser, because {program} is missing.")
            sys.exit(NOT_RUN)


def leave_if_missing():
    """Ends the program where there is no book or no browser."""
    if not SITE.exists():
        print("book: not tested in a browser, because the book is missing.")
        sys.exit(NOT_RUN)
    leave_without("chromium", "chromedriver")


def start_browser(renderer=SWIFTSHADER):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for switch in (*SWITCHES, *renderer):
        options.add_argument(switch)
    if os.getuid() == 0:
        options.add_argument("--no-sandbox")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


class BrowserTest(unittest.TestCase):
    """Tests that share one browser and one server on a free port of this machine."""

    @classmethod
    def setUpClass(cls):
        cls.server = make_server(SITE, 0)
        cls.thread = threading.Thread(target=cls.server.serve_forever, daemon=True)
        cls.thread.start()
        cls.browser = start_browser()
        cls.browser.set_window_size(1200, 900)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.server.shutdown()
        cls.server.server_close()

    @contextlib.contextmanager
    def phone(self, width=375):
        """Pages are so wide meanwhile. (A window may be wider than it is asked to be.)"""
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 800, "deviceScaleFactor": 1, "mobile": False})
        try:
            yield
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def open(self, page):
        """Loads a page. What the browser complained about before is forgotten."""
        self.browser.get_log("browser")
        self.browser.get(f"http://127.0.0.1:{self.server.server_port}/{page}")
        self.wait_for("return document.readyState === 'complete'")

    def without_playgrounds(self):
        """Those of the page: they would load when they come near, which takes seconds, and have tests of their own."""
        self.browser.execute_script("document.querySelectorAll('[data-play]').forEach((place) => place.remove())")

    def wait_for(self, script, *arguments):
        return WebDriverWait(self.browser, 30, BETWEEN_LOOKS).until(
            lambda browser: browser.execute_script(script, *arguments), script)

    def complaints(self):
        return [entry["message"] for entry in self.browser.get_log("browser")
                if entry["level"] in ("SEVERE", "WARNING")]

    def keep_picture(self, name):
        """A screenshot, for a person to look at."""
        folder = STORE / "screenshots"
        folder.mkdir(exist_ok=True)
        self.browser.save_screenshot(str(folder / f"{name}.png"))
