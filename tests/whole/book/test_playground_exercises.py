"""The exercises of the playground in a browser: what passes, what is refused, and that a reader's text is kept."""

import os
import tempfile
import time
import unittest
from pathlib import Path

from selenium.webdriver.common.keys import Keys

from browser import leave_without
from playground_page import PHONE, PlaygroundTest
from support import ROOT
from course import hunt, marks, verify
from playground.data import PAGE
from playground.exercises import shader_exercises

ADDRESS = (ROOT / PAGE / "exercises.html").as_uri()
HUNTS = {"3.6", "8.5"}
MOST_TRIALS = 60  # in one script, whose time in a page has an end
ALL = "RAYSTEPS_LONG" in os.environ  # every mistake, and not the first of each exercise
EXERCISES = shader_exercises(ROOT)

# Each trial's lines in the place of the solution; what the page comes to.
JUDGE = """
const { play } = Raysteps;
const gpu = globalThis.judge ??= play.openGpu();
const found = [];
for (const { number, code } of given) {
  const exercise = await play.openExercise(number);
  const text = play.withCode(play.blank(exercise.file, 0), exercise.file, { [number]: code });
  const result = await (exercise.isHunt ? play.check : play.judge)(gpu, exercise, text);
  found.push({ state: result.state, report: play.reportOf(exercise, result) });
}
return found;
"""


class PlaygroundExercises(PlaygroundTest):
    def open(self, number):
        """The exercise with its stub; the page is loaded where it does not show it already."""
        if self.browser.execute_script("return document.body.dataset.exercise") == number and self.browser.current_url.startswith(ADDRESS):
            self.press("Reset")
            return
        self.browser.get("about:blank")
        self.browser.get(f"{ADDRESS}#exercise={number}")
        self.wait_until(f"return document.body.dataset.exercise === '{number}'")

    def said(self):
        return self.browser.execute_script("return document.querySelector('.said')?.textContent ?? document.body.innerText")

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
        self.wait_until("return !['', 'running'].includes(document.querySelector('.exercise').dataset.state)")
        return self.said()

    def judge(self, trials):
        if not self.browser.current_url.startswith(ADDRESS):
            self.open(EXERCISES[0].number)
        given = [{"number": exercise.number, "code": code} for exercise, code in trials]
        return [each for i in range(0, len(given), MOST_TRIALS) for each in self.run_in_page(JUDGE, given[i:i + MOST_TRIALS])]

    def test_every_solution_passes(self):
        found = self.judge([(exercise, exercise.region.code) for exercise in EXERCISES if not exercise.plants])
        self.assertEqual([each["report"] for each in found if each["state"] != "passed"], [])
        self.assertEqual(len(found), len(EXERCISES) - len(HUNTS))

    def test_a_hunt_asks_for_a_witness_and_then_for_the_repair(self):
        """Each mistake, or the first one: as it is given, with its witness, and repaired; and a ray that shows nothing."""
        trials, wanted = [], []
        for exercise in (each for each in EXERCISES if each.number in HUNTS):
            for seed, plant in enumerate(exercise.plants[:None if ALL else 1]):
                given = hunt.planted(exercise, seed)
                place = next(i for i, line in enumerate(given) if "// witness:" in line)
                shown = [*given[:place], f"{given[place]} {plant['witness']}", *given[place + 1:]]
                blind = [*given[:place], f"{given[place]} 1e9,1e9,1e9,1,0,0", *given[place + 1:]]
                trials += [(exercise, code) for code in (given, shown, blind, [*shown[:place + 1], *exercise.region.code])]
                wanted += [("not started", ""), ("failed", "The witness is right; the part is wrong still, at "), ("failed", "the witness is none"), ("passed", "")]
        self.assertEqual(len(wanted), 8 if not ALL else 48)
        for (exercise, code), found, (state, words) in zip(trials, self.judge(trials), wanted):
            self.assertEqual(found["state"], state, "\n".join([found["report"], *code]))
            self.assertIn(words, found["report"])
            self.assertNotIn("origin", found["report"])

    def test_every_stub_and_typical_mistakes_are_refused(self):
        trials = [(exercise, exercise.region.stub) for exercise in EXERCISES if not exercise.plants]
        for exercise in EXERCISES:
            trials += [(exercise, verify.mutated(exercise, mutation)) for mutation in exercise.mutations[:None if ALL else 1]]
        found = self.judge(trials)
        self.assertEqual([f"{exercise.number}: {code}" for (exercise, code), each in zip(trials, found)
                          if each["state"] not in ("failed", "stopped")], [])

    def test_a_loop_without_an_end_is_stopped_in_every_exercise(self):
        """In every one, or in the first of each chapter."""
        chosen = [exercise for i, exercise in enumerate(EXERCISES) if not exercise.plants
                  and (ALL or i == 0 or exercise.chapter != EXERCISES[i - 1].chapter)]
        trials = []
        for exercise in chosen:
            code = exercise.region.code
            inside = 1 if code[0].endswith(") {") and not code[0].startswith(" ") else 0  # a whole function
            trials.append((exercise, [*code[:inside], "while (true) {}", *code[inside:]]))
        found = self.judge(trials)
        self.assertGreater(len(found), 7)
        self.assertEqual([each["report"] for each in found if each["state"] != "stopped"], [])

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
            self.wait_until("return document.querySelector('.said').textContent.includes('is open')")
            self.assertEqual(self.shown(), "\n".join(exercise.region.code))
            other = Path(folder) / "other.glsl"
            other.write_text("nothing\n")
            self.browser.find_element("css selector", "input[type=file]").send_keys(str(other))
            self.wait_until("return document.querySelector('.said').textContent.includes('no exercise 4.1, 4.2, 4.3')")
            self.assertEqual(self.shown(), "\n".join(exercise.region.code))

    def test_a_text_is_there_after_a_reload_and_in_the_whole_file(self):
        self.open("5.1")
        self.write("    // mine\n    float no = 0.0f;")
        self.browser.refresh()
        self.wait_until("return document.body.dataset.exercise === '5.1'")
        self.assertIn("// mine", self.shown())
        self.press("Whole file")
        self.assertIn("//# exercise 5.2", self.shown())
        self.assertIn("// mine", self.shown())

    def test_a_lesson_loads_an_exercise_only_when_it_comes_near(self):
        with tempfile.TemporaryDirectory(prefix="raysteps_lesson_") as folder:
            self.browser.get("about:blank")
            page = Path(folder) / "lesson.html"
            page.write_text(f'<!doctype html><script defer src="{(ROOT / PAGE / "load.js").as_uri()}"></script>'
                            '<div style="height: 9000px"></div><div class="play" data-play="2.4"></div>')
            self.browser.get(page.as_uri())
            time.sleep(0.5)
            self.assertEqual(self.browser.execute_script("return document.scripts.length"), 1)
            self.browser.execute_script("scrollTo(0, document.body.scrollHeight)")
            self.wait_until("return document.querySelector('.play').dataset.state === 'shown'")
            self.write("    return true;")
            self.assertIn("2.4 Which of two hits wins: failed", self.check())

    def test_the_picture_says_how_many_pixels_differ_and_nothing_is_wider_than_a_phone(self):
        self.open("6.2")
        self.wait_until("return /pixels differ/.test(document.querySelector('.seen').textContent)")
        self.check()
        self.keep_picture("exercise", height=1500)
        self.keep_picture("exercise_narrow", PHONE["width"], 1500)
        self.assertEqual(self.complaints(), [])


if __name__ == "__main__":
    leave_without("chromium", "chromedriver")
    unittest.main(verbosity=2 if os.environ.get("VERBOSE") else 1)
