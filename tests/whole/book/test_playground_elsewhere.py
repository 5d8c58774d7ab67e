"""The playground in other browsers and by other renderers: one program for each slot, one exercise of each chapter. With RAYSTEPS_LONG,
all."""

import os
import shutil
import time
import unittest

from browser import leave_without, start_browser
from marionette import Firefox
from playground_page import ADDRESS, RUN
from test_playground import COMPILE
from test_playground_exercises import ADDRESS as EXERCISES_ADDRESS
from test_playground_exercises import ALL, EXERCISES, JUDGE

ON_MESA = ("--use-gl=angle", "--use-angle=gl-egl")


class Elsewhere:
    """What each of them has to do. As a page from the disk."""

    @classmethod
    def setUpClass(cls):
        cls.browser = cls.start()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def open(self, address, script):
        self.browser.get(address)
        end = time.monotonic() + 60
        while not self.browser.execute_script(script):
            self.assertLess(time.monotonic(), end, self.browser.execute_script("return document.body.innerText"))
            time.sleep(0.05)

    def run_in_page(self, body, given=None):
        answer = self.browser.execute_async_script(RUN % body, given)
        self.assertNotIn("error", answer)
        return answer["value"]

    def test_programs_and_a_picture(self):
        self.open(f"{ADDRESS}#size=128", "return document.body.dataset.state === 'picture'")
        self.assertIn("This is the project's own text", self.browser.execute_script("return document.getElementById('said').textContent"))
        self.assertRegex(self.browser.execute_script("return Raysteps.play.page.gpu.name"), self.renderer)
        found = self.run_in_page(COMPILE, {"all": ALL, "slots": not ALL})
        self.assertEqual(found["faults"], [])
        self.assertGreaterEqual(found["linked"], 60 if ALL else 8)

    def test_exercises(self):
        self.open(f"{EXERCISES_ADDRESS}#exercise=1.1", "return document.body.dataset.exercise === '1.1'")
        chosen, chapters = [], set()
        for exercise in EXERCISES:
            if not exercise.plants and (ALL or exercise.chapter not in chapters):
                chosen.append(exercise)
                chapters.add(exercise.chapter)
        found = self.run_in_page(JUDGE, [{"number": exercise.number, "code": code} for exercise in chosen
                                         for code in (exercise.region.code, exercise.region.stub)])
        self.assertEqual([each["report"] for each in found[::2] if each["state"] != "passed"], [])
        self.assertEqual([each["report"] for each in found[1::2] if each["state"] not in ("failed", "stopped")], [])


@unittest.skipUnless(shutil.which("chromium") and shutil.which("chromedriver"), "chromium is missing")
class OnMesa(Elsewhere, unittest.TestCase):
    renderer = "Mesa|llvmpipe"

    @staticmethod
    def start():
        browser = start_browser(ON_MESA)
        browser.set_script_timeout(280)
        return browser


@unittest.skipUnless(shutil.which("firefox-esr") and shutil.which("xvfb-run"), "firefox-esr or xvfb is missing")
class InFirefox(Elsewhere, unittest.TestCase):
    renderer = "llvmpipe|Mesa|Generic"

    @staticmethod
    def start():
        return Firefox()


if __name__ == "__main__":
    if not shutil.which("firefox-esr"):
        leave_without("chromium", "chromedriver")
    unittest.main(verbosity=2 if os.environ.get("VERBOSE") else 1)
