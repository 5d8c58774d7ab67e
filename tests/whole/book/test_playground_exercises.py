"""The exercises of the playground in a browser: what passes, what is refused, and that a reader's text is kept."""

import os
import tempfile
import time
import unittest
from pathlib import Path

from selenium.webdriver.common.keys import Keys

from browser import STORE, leave_without, start_browser
from support import ROOT
from test_playground import RUN
from course import marks, verify
from playground.data import PAGE
from playground.exercises import shader_exercises

ADDRESS = (ROOT / PAGE / "exercises.html").as_uri()
ALL = "RAYSTEPS_LONG" in os.environ  # every mistake, and not the first of each exercise
EXERCISES = shader_exercises(ROOT)

# Each trial's lines in the place of the solution; what the page comes to.
JUDGE = """
const { play } = Raysteps;
const gpu = play.openGpu();
const found = [];
for (const { number, code } of given) {
  const exercise = await play.openExercise(number);
  const text = play.withCode(play.files[exercise.path], exercise.file, { [number]: code });
  const result = await play.judge(gpu, exercise, text);
  found.push({ state: result.state, report: play.reportOf(exercise, result) });
}
gpu.gl.getExtension("WEBGL_lose_context").loseContext();
return found;
"""


class PlaygroundExercises(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = start_browser()
        cls.browser.set_script_timeout(280)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def setUp(self):
        self.browser.get_log("browser")

    def open(self, number):
        self.browser.get("about:blank")
        self.browser.get(f"{ADDRESS}#exercise={number}")
        self.addCleanup(self.browser.execute_script, "localStorage.clear()")
        self.wait_for(f"return document.body.dataset.exercise === '{number}'")

    def wait_for(self, script, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.browser.execute_script(script):
                return
            time.sleep(0.05)
        self.fail(f"`{script}` does not come true: {self.said()}")

    def said(self):
        return self.browser.execute_script("return document.querySelector('.said')?.textContent ?? document.body.innerText")

    def run_in_page(self, body, given=None):
        answer = self.browser.execute_async_script(RUN % body, given)
        self.assertNotIn("error", answer)
        return answer["value"]

    def write(self, text):
        """As if the reader had replaced all of the text."""
        self.browser.execute_script("const area = document.querySelector('textarea'); area.value = arguments[0];"
                                    "area.dispatchEvent(new Event('input'))", text)

    def shown(self):
        return self.browser.execute_script("return document.querySelector('textarea').value")

    def press(self, name):
        self.browser.execute_script("[...document.querySelectorAll('.exercise button')].find((button) =>"
                                    "button.textContent === arguments[0]).click()", name)

    def check(self):
        self.browser.execute_script("document.querySelector('.exercise').dataset.state = ''")
        self.browser.find_element("css selector", "textarea").send_keys(Keys.CONTROL + Keys.ENTER)
        self.wait_for("return !['', 'running'].includes(document.querySelector('.exercise').dataset.state)")
        return self.said()

    def judge(self, trials):
        self.open(EXERCISES[0].number)
        return self.run_in_page(JUDGE, [{"number": exercise.number, "code": code} for exercise, code in trials])

    def test_every_solution_passes(self):
        found = self.judge([(exercise, exercise.region.code) for exercise in EXERCISES])
        self.assertEqual([each["report"] for each in found if each["state"] != "passed"], [])
        self.assertEqual(len(found), len(EXERCISES))

    def test_every_stub_and_typical_mistakes_are_refused(self):
        trials = [(exercise, exercise.region.stub) for exercise in EXERCISES]
        for exercise in EXERCISES:
            trials += [(exercise, verify.mutated(exercise, mutation)) for mutation in exercise.mutations[:None if ALL else 1]]
        found = self.judge(trials)
        self.assertEqual([f"{exercise.number}: {code}" for (exercise, code), each in zip(trials, found)
                          if each["state"] not in ("failed", "stopped")], [])

    def test_a_wrong_answer_is_told_as_course_check_tells_it(self):
        exercise = next(each for each in EXERCISES if each.number == "6.2")
        self.open("6.2")
        self.assertIn("not started", self.check())
        self.write("    node = met ? node + 1 : here.skip;")
        told = self.check()
        self.assertIn("6.2 Into a branch or past it: failed", told)
        self.assertRegex(told, r"checkpoint  n-th step: the first one that is wrong")
        self.assertRegex(told, r"origin +\S+, \S+, \S+   \(hex [0-9a-f]{8} [0-9a-f]{8} [0-9a-f]{8}\)")
        self.assertRegex(told, r"node +expected -?\d+, got -?\d+  <-- wrong")
        self.assertIn("./course check 6.2 --ray=", told)
        self.write("    node = node + 1;")
        self.assertIn("the ray does not meet the root, and there is nothing behind it", self.check())
        self.write("\n".join(exercise.region.code))
        self.assertIn("6.2 Into a branch or past it: passed", self.check())

    def test_a_typo_and_a_loop_without_an_end_are_named_at_the_readers_line(self):
        self.open("6.2")
        self.write("    float way = 2;\n    node = here.skip;")
        told = self.check()
        text = self.browser.execute_script("return Raysteps.play.workbook.text('shaders/structure/bvh/bvh_skip.glsl')")
        line = 1 + text[:text.index("float way")].count("\n")
        self.assertIn(f"shaders/structure/bvh/bvh_skip.glsl:{line}: ", told)
        self.assertIn("2.0f", told)
        self.assertEqual(self.browser.execute_script(
            "return [...document.querySelectorAll('.editor .marked')].map((e) => 1 + [...e.parentNode.children].indexOf(e))"), [1])
        self.write("    while (true) { node = 1; }")
        told = self.check()
        self.assertIn("6.2 Into a branch or past it: stopped", told)
        self.assertIn(f"shaders/structure/bvh/bvh_skip.glsl:{line}", told)

    def test_what_is_saved_is_the_file_that_course_check_reads_and_opens_again(self):
        exercise = next(each for each in EXERCISES if each.number == "4.2")
        with tempfile.TemporaryDirectory(prefix="raysteps_downloads_") as folder:
            self.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": folder})
            self.open("4.2")
            self.write("\n".join(exercise.region.code))
            self.press("Save")
            saved = Path(folder) / Path(exercise.file).name
            for _ in range(200):
                if saved.exists():
                    break
                time.sleep(0.05)
            project = (ROOT / exercise.file).read_text()
            wanted = marks.with_code(marks.blank(project, exercise.file), exercise.file, {"4.2": exercise.region.code})
            self.assertEqual(saved.read_text(), wanted)
            self.press("Reset")
            self.assertEqual(self.shown(), "\n".join(exercise.region.stub))
            self.press("Take back")
            self.assertEqual(self.shown(), "\n".join(exercise.region.code))
            self.press("Reset")
            self.browser.find_element("css selector", "input[type=file]").send_keys(str(saved))
            self.wait_for("return document.querySelector('.said').textContent.includes('is open')")
            self.assertEqual(self.shown(), "\n".join(exercise.region.code))
            other = Path(folder) / "other.glsl"
            other.write_text("nothing\n")
            self.browser.find_element("css selector", "input[type=file]").send_keys(str(other))
            self.wait_for("return document.querySelector('.said').textContent.includes('no exercise 4.1, 4.2, 4.3')")
            self.assertEqual(self.shown(), "\n".join(exercise.region.code))

    def test_a_text_is_there_after_a_reload_and_in_the_whole_file(self):
        self.open("5.1")
        self.write("    // mine\n    float no = 0.0f;")
        self.browser.refresh()
        self.wait_for("return document.body.dataset.exercise === '5.1'")
        self.assertIn("// mine", self.shown())
        self.press("Whole file")
        self.assertIn("//# exercise 5.2", self.shown())
        self.assertIn("// mine", self.shown())

    def test_a_lesson_loads_an_exercise_only_when_it_comes_near(self):
        with tempfile.TemporaryDirectory(prefix="raysteps_lesson_") as folder:
            page = Path(folder) / "lesson.html"
            page.write_text(f'<!doctype html><script defer src="{(ROOT / PAGE / "load.js").as_uri()}"></script>'
                            '<div style="height: 9000px"></div><div class="play" data-play="2.4"></div>')
            self.browser.get(page.as_uri())
            self.addCleanup(self.browser.execute_script, "localStorage.clear()")
            time.sleep(0.5)
            self.assertEqual(self.browser.execute_script("return document.scripts.length"), 1)
            self.browser.execute_script("scrollTo(0, document.body.scrollHeight)")
            self.wait_for("return document.querySelector('.play').dataset.state === 'shown'")
            self.write("    return true;")
            self.assertIn("2.4 Which of two hits wins: failed", self.check())

    def test_the_picture_says_how_many_pixels_differ_and_nothing_is_wider_than_a_phone(self):
        self.open("6.2")
        self.wait_for("return /pixels differ/.test(document.querySelector('.seen').textContent)")
        self.check()
        try:
            for width, name in ((1280, "exercise"), (390, "exercise_narrow")):
                self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                    "width": width, "height": 1500, "deviceScaleFactor": 1, "mobile": False})
                self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth"), width)
                self.keep_picture(name)
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.assertEqual([entry["message"] for entry in self.browser.get_log("browser")
                          if entry["level"] in ("SEVERE", "WARNING")], [])

    def keep_picture(self, name):
        """A screenshot, for a person to look at."""
        folder = STORE / "screenshots"
        folder.mkdir(parents=True, exist_ok=True)
        self.browser.save_screenshot(str(folder / f"{name}.png"))


if __name__ == "__main__":
    leave_without("chromium", "chromedriver")
    unittest.main(verbosity=2 if os.environ.get("VERBOSE") else 1)
