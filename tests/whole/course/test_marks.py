"""Marks in the sources, and what is derived from them."""

import re
import shutil
import unittest

from support import ROOT, CourseTest

from course import exercises, marks
from course.errors import CourseError

SOURCE = """before
    //# exercise 1.1: add
    int sum = a + b;
    return sum;
    //# stub: return 0;
    //# end
between
    //# exercise 1.2: subtract
    return a - b;
    //# stub: return 0;
    //# end
after"""


class Marks(unittest.TestCase):
    def test_a_blank_has_the_stubs_where_the_solutions_were(self):
        self.assertEqual(marks.blank(SOURCE, "f"), """before
    //# exercise 1.1: add
    return 0;
    //# end
between
    //# exercise 1.2: subtract
    return 0;
    //# end
after""")

    def test_the_reference_stands_in_for_what_is_not_chosen(self):
        own = marks.blank(SOURCE, "f").replace("    return 0;", "    return b + a;", 1)
        own = own.replace("before", "before\nmine")
        composed = marks.compose(SOURCE, own, "f", "f", {"1.1"})
        self.assertIn("mine", composed.text)
        self.assertIn("return b + a;", composed.text)
        self.assertIn("return a - b;", composed.text)
        self.assertNotIn("return 0;", composed.text)

    def test_every_line_knows_where_it_comes_from(self):
        own = "mine\n" + marks.blank(SOURCE, "f")
        composed = marks.compose(SOURCE, own, "f", "f", {"1.1"})
        for line, (is_own, number) in zip(composed.text.split("\n"), composed.origins, strict=True):
            source = (own if is_own else SOURCE).split("\n")
            self.assertEqual(line, source[number - 1])

    def test_a_broken_mark_names_its_line(self):
        with self.assertRaisesRegex(CourseError, "f:2: `//# end` without an exercise"):
            marks.parse("a\n//# end", "f")
        with self.assertRaisesRegex(CourseError, "f: exercise 1.1 does not end"):
            marks.parse("//# exercise 1.1: a", "f")
        with self.assertRaisesRegex(CourseError, "f:2: an exercise begins before 1.1 has ended"):
            marks.parse("//# exercise 1.1: a\n//# exercise 1.2: b\n//# end", "f")
        with self.assertRaisesRegex(CourseError, "the marks of exercise 1.2 are gone"):
            marks.compose(SOURCE, SOURCE.split("between")[0], "f", "f", {"1.1"})

    def test_code_that_differs_in_spaces_is_a_stub_still(self):
        self.assertTrue(marks.is_same(["  return  0;", ""], ["return 0;"]))
        self.assertFalse(marks.is_same(["return 1;"], ["return 0;"]))


class Exercises(CourseTest):
    def test_there_are_three_to_eight_a_chapter(self):
        counts = {}
        for exercise in exercises.load():
            counts[exercise.chapter] = counts.get(exercise.chapter, 0) + 1
        self.assertEqual(list(counts), sorted(path.name for path in (ROOT / "chapters").glob("[0-9][0-9]_*")))
        self.assertGreaterEqual(len(counts), 10)
        self.assertTrue(all(3 <= count <= 8 for count in counts.values()), counts)

    def test_a_copy_of_a_chapter_says_which_numbers_are_not_its_own(self):
        shutil.copytree(ROOT / "chapters" / "05_kd_tree", self.folder / "chapters" / "11_name")
        with self.assertRaisesRegex(CourseError, "11_name/exercises.toml: 5.1 is .* none of chapter 11"):
            exercises.load(self.folder)

    def test_every_lesson_names_its_exercises(self):
        every = exercises.load()
        for chapter in {exercise.chapter for exercise in every}:
            lesson = (ROOT / "chapters" / chapter / "README.md").read_text()
            section = re.search(r"^## Exercises\n(.*?)^## ", lesson, re.MULTILINE | re.DOTALL)
            named = re.findall(r"^- (\d+\.\d+ .+)$", section[1], re.MULTILINE)
            self.assertEqual(named, [f"{exercise.number} {exercise.title}"
                                     for exercise in every
                                     if exercise.chapter == chapter], chapter)

    def test_a_workbook_with_every_solution_is_the_source_without_stubs(self):
        self.start()
        for exercise in exercises.load():
            path = self.solve(exercise.number)
        for exercise in exercises.load():
            path = self.workbook / exercise.file
            lines = (ROOT / exercise.file).read_text().split("\n")
            self.assertEqual(path.read_text().split("\n"),
                             [line for line in lines if not line.lstrip().startswith("//# stub:")])


if __name__ == "__main__":
    unittest.main()
