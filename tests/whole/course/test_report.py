"""What a check prints, and what the exercises give it to print."""

import unittest

from support import ROOT  # noqa: F401  (it makes the modules of the course known)
from course import check, exercises, formulas, report, view
from course.compare import Wrong


def result_of(number, **found):
    return check.Result(exercises.select_one(exercises.load(), number), check.FAILED, **found)


class Formulas(unittest.TestCase):
    def test_a_known_formula(self):
        self.assertEqual(formulas.plain(r"$a \cdot b_{max} \ge 2^{-16},\quad x^{1 / k}$"),
                         "a . b_max >= 2^-16,   x^(1 / k)")

    def test_every_formula_can_be_read_on_a_terminal(self):
        for exercise in exercises.load():
            for formula in exercise.formulas:
                self.assertNotRegex(formulas.plain(formula), r"[\\${}]|[^\x20-\x7e]")

    def test_an_unknown_word_is_an_error(self):
        self.assertRaises(KeyError, formulas.plain, r"$\unheard$")


class Questions(unittest.TestCase):
    def test_what_is_no_ray_in_a_scene_is_explained(self):
        for exercise in exercises.load():
            for checkpoint in exercise.checkpoints:
                asks_numbers = checkpoint.question["kind"] in check.RAY_BY_RAY
                if asks_numbers and view.words_of(checkpoint, exercise.chapter) is None:
                    self.assertTrue(checkpoint.given or checkpoint.where,
                                    f"{exercise.number} {checkpoint.name}")

    def test_a_name_for_a_number_that_a_ray_does_not_have_is_refused(self):
        table = {"name": "a", "kind": "checkpoint", "given": {"light": [7, 8]}}
        with self.assertRaisesRegex(exercises.CourseError, "0 to 7"):
            exercises._checkpoint(table, "here")


class Functions(unittest.TestCase):
    def test_the_numbers_of_a_function_have_their_names_and_can_be_asked_again(self):
        exercise = exercises.select_one(exercises.load(), "7.3")
        ray = exercises.ray_bits([1000, 5, 2000, 10, 4000, 20, 8000, 40])
        printed = report.as_text(check.Result(exercise, check.FAILED,
                                              checkpoint=exercise.checkpoints[0],
                                              wrong=Wrong(0, 1, ray, [])))
        self.assertIn("  triangles   1000, 2000, 4000, 8000 ", printed)
        self.assertIn("  cost        5, 10, 20, 40 ", printed)
        self.assertIn("./course check 7.3 --ray=1000,5,2000,10,4000,20,8000,40", printed)


class Boxes(unittest.TestCase):
    def printed(self, number, name, step, boxes):
        exercise = exercises.select_one(exercises.load(), number)
        checkpoint = next(c for c in exercise.checkpoints if c.name == name)
        wrong = Wrong(0, step, boxes[0], [], asked=boxes)
        return report.as_text(check.Result(exercise, check.FAILED, checkpoint=checkpoint, wrong=wrong))

    def test_few_boxes_are_printed(self):
        boxes = [exercises.ray_bits([-9, 0, 0, 9, 1, 1]), exercises.ray_bits([-9, 3, 0, 9, 4, 1])]
        printed = self.printed("6.5", "long boxes side by side", 1, boxes)
        self.assertIn("  box 1       from (-9, 0, 0) to (9, 1, 1)\n"
                      "  box 2       from (-9, 3, 0) to (9, 4, 1)\n", printed)
        self.assertNotIn("box 3", printed)

    def test_of_many_boxes_their_number_is_said(self):
        boxes = [exercises.ray_bits([0, 0, 0, 1, 1, 1])] * 40
        self.assertIn("the first 9 of 40 made at random",
                      self.printed("6.5", "more and more boxes", 8, boxes))


class Pictures(unittest.TestCase):
    paths = {"yours": "a.png", "reference": "b.png", "compared": "c.png", "wrong_pixels": 0}

    def test_a_picture_without_a_wrong_pixel_is_said_to_be_right(self):
        printed = report.as_text(result_of("3.3", pictures=self.paths))
        self.assertIn("a.png is right in every pixel", printed)
        self.assertNotIn("c.png", printed)

    def test_a_wrong_pixel_is_named(self):
        printed = report.as_text(result_of("3.3", pictures={**self.paths, "wrong_pixels": 5,
                                                            "first_wrong_pixel": [3, 4]}))
        self.assertIn("column 3, row 4 from above is the first of 5", printed)
        self.assertIn("view        ./course view 3.3", printed)

    def test_why_there_is_no_picture_is_said(self):
        result = result_of("5.2", no_picture="was stopped after 60 s: does a loop never end?")
        self.assertIn("picture     none: was stopped after 60 s", report.as_text(result))
        self.assertIn("was stopped", report.as_json(result)["no_picture"])


if __name__ == "__main__":
    unittest.main()
