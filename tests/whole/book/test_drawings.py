"""The drawings of the lessons: made again they are the same, and they say what their lesson says."""

import unittest
import xml.etree.ElementTree as xml

from support import ROOT, FolderTest
from drawings.canvas import Canvas
from drawings.catalogue import descriptions, make
from drawings.floats import cross_product, rounded, ulp
from drawings.lesson import Lesson, LessonError
from drawings.places import Flat, Solid, between
from drawings.words import numbers, spans

DRAWINGS = [make(path) for path in descriptions(ROOT)]
TABLE = "# A\n\n| scene | time |\n| --- | --- |\n| `bunny` | 651 (567-701) |\n\nMore.\n"


class Drawings(unittest.TestCase):
    def for_each(self, check):
        for drawing in DRAWINGS:
            with self.subTest(drawing=str(drawing.path.relative_to(ROOT))):
                check(drawing)

    def test_every_file_is_what_its_description_draws(self):
        self.assertGreaterEqual(len(DRAWINGS), 12)
        self.for_each(
            lambda drawing: self.assertTrue(
                drawing.file.read_bytes() == drawing.svg.encode(), "run: python3 -B scripts/drawings"
            )
        )

    def test_no_file_is_without_its_description(self):
        for folder in {path.parent for path in descriptions(ROOT)}:
            stray = {file.stem for file in folder.iterdir() if file.is_file()}
            self.assertEqual(stray, {path.stem for path in folder.glob("*.py")})

    def test_every_number_stands_in_the_lesson(self):
        self.assertGreater(sum(len(drawing.numbers) for drawing in DRAWINGS), 50)
        self.for_each(
            lambda drawing: self.assertEqual(drawing.lesson.lacking(drawing.sentences, drawing.numbers), [])
        )

    def test_every_lesson_shows_its_drawings_with_the_words_for_who_cannot_see_them(self):
        self.for_each(lambda drawing: self.assertGreater(len(drawing.alt), 60))
        self.for_each(
            lambda drawing: self.assertTrue(
                f"![{drawing.alt}](drawings/{drawing.file.name})" in drawing.lesson.text,
                "copy ALT into the lesson",
            )
        )

    def test_every_file_is_an_svg_with_a_name_and_without_scripts_and_links(self):
        def check(drawing):
            root = xml.fromstring(drawing.svg)
            self.assertEqual((root.get("role"), root.get("aria-label")), ("img", drawing.alt))
            kinds = {element.tag.split("}")[1] for element in root.iter()}
            self.assertLessEqual(
                kinds, {"svg", "style", "rect", "g", "polyline", "polygon", "path", "circle", "text", "tspan"}
            )
            self.assertLess(len(drawing.svg), 25_000)

        self.for_each(check)


class Lessons(FolderTest):
    def lesson(self, text):
        return Lesson(self.write("README.md", text))

    def test_a_sentence_is_found_over_ends_of_lines_and_marks_of_formulas(self):
        lesson = self.lesson("So $t = 2.5/4\n= 0.625$ and **that**\nis [it](b.md).")
        self.assertTrue(lesson.has("t = 2.5/4 = 0.625 and that is it."))
        self.assertFalse(lesson.has("t = 2.5/4 = 0.626"))

    def test_a_number_that_the_lesson_does_not_say_is_a_fault(self):
        lesson = self.lesson("It costs 4.85 at x = 4.")
        self.assertEqual(lesson.lacking(["It costs 4.85 at x = 4."], ["4.85", "4"]), [])
        self.assertIn("shows 4.86", lesson.lacking(["It costs 4.85 at x = 4."], ["4.86"])[0])
        self.assertIn("does not say: It costs 5", lesson.lacking(["It costs 5"], [])[0])

    def test_what_is_read_from_a_table_is_said_by_the_lesson(self):
        lesson = self.lesson(TABLE)
        self.assertEqual(lesson.row("| scene | time |", "bunny"), ["`bunny`", "651 (567-701)"])
        self.assertEqual(lesson.lacking([], ["651"]), [])
        with self.assertRaisesRegex(LessonError, "has no row knot"):
            lesson.row("| scene | time |", "knot")
        with self.assertRaisesRegex(LessonError, "has no table with the header"):
            lesson.row("| scene | space |", "bunny")


class Words(unittest.TestCase):
    def test_numbers_are_found_with_their_signs_and_indices_are_none(self):
        self.assertEqual(numbers("$t_x$ = 1.5, $2^{-23}$ and 11,700 of $e_1$"), ["1.5", "2", "-23", "11,700"])

    def test_letters_are_slanted_and_numbers_stand(self):
        self.assertEqual(
            spans("$t_x$ = 2"),
            "<tspan class='letters'>t</tspan><tspan class='letters small' dy='5'>x</tspan>"
            "<tspan dy='-5'> = 2</tspan>",
        )
        self.assertEqual(spans("$2$"), "<tspan class='upright'>2</tspan>")

    def test_words_are_safe_in_xml(self):
        canvas = Canvas(10, 'a < b & "c"')
        canvas.text((0, 0), "a < b & c")
        self.assertEqual(xml.fromstring(canvas.svg()).get("aria-label"), 'a < b & "c"')


class Places(unittest.TestCase):
    def test_a_plane_has_its_y_upwards(self):
        self.assertEqual(Flat(10, 100, 20)(1, 2), (30, 60))

    def test_space_seen_from_the_front_is_a_plane(self):
        self.assertEqual(Solid(10, 100, 20, turned=0, raised=0)(1, 2, 5), (30, 60))

    def test_a_mixture_of_points_lies_between_them(self):
        self.assertEqual(between((0, 0), (4, 8), 0.25), (1, 2))


class Floats(unittest.TestCase):
    def test_one_ulp_is_what_the_lesson_says(self):
        self.assertEqual((ulp(1), ulp(1.9), ulp(-4), ulp(16)), (2.0**-23, 2.0**-23, 2.0**-21, 2.0**-19))
        self.assertEqual(rounded(1 + ulp(1)), 1 + ulp(1))
        self.assertEqual(rounded(1 + 0.4 * ulp(1)), 1)

    def test_each_product_of_a_cross_product_is_rounded(self):
        self.assertEqual(cross_product((1, 0, 0), (0, 1, 0)), (0, 0, 1))
        third = rounded(1 / 3)
        self.assertEqual(cross_product((0, third, 0), (0, 0, third))[0], rounded(third * third))


if __name__ == "__main__":
    unittest.main()
