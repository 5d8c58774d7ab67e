"""A headless browser that reads the book as it is served."""

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

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.server.shutdown()
        cls.server.server_close()

    def open(self, page, width=1200, height=900):
        """Loads a page, and waits until its figures live. What the browser complained about before
        is forgotten."""
        self.browser.set_window_size(width, height)
        self.browser.get_log("browser")
        self.browser.get(f"http://127.0.0.1:{self.server.server_port}/{page}")
        self.wait_for("return document.readyState === 'complete'")
        self.wait_for("return [...document.querySelectorAll('figure.walk:not([data-viewer])')]"
                      ".every((figure) => figure.dataset.ready)")

    def wait_for(self, script, *arguments):
        return WebDriverWait(self.browser, 30).until(
            lambda browser: browser.execute_script(script, *arguments), script)

    def complaints(self):
        return [entry["message"] for entry in self.browser.get_log("browser")
                if entry["level"] in ("SEVERE", "WARNING")]

    def keep_picture(self, name):
        """A screenshot, for a person to look at."""
        folder = STORE / "screenshots"
        folder.mkdir(exist_ok=True)
        self.browser.save_screenshot(str(folder / f"{name}.png"))
