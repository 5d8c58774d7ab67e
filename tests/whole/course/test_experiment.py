"""Experiments: a prediction, a measurement and a sentence; the check measures too."""

import json
import unittest

from support import CourseTest
from course import exercises, experiment


class Experiment(CourseTest):
    def setUp(self):
        super().setUp()
        self.start()

    def result(self, *lines, expect):
        self.solve("2.7", "\n".join(lines))
        return json.loads(self.course("check", "2.7", "--json", expect=expect))["results"][0]

    def test_what_was_measured_has_to_be_what_is_measured(self):
        why = "why: every ray tests every triangle."
        self.assertEqual(self.result("predicted: 1000", "measured: 262,144", why, expect=0)["state"],
                         "passed")
        self.assertIn("is not what is measured",
                      self.result("predicted: 262144", "measured: 262145", why, expect=1)["message"])

    def test_what_lacks_is_named(self):
        self.assertIn("`predicted:` is empty",
                      self.result("measured: 1", "why: so", expect=1)["message"])
        self.assertIn("`measured: many` is no number",
                      self.result("predicted: 1", "measured: many", expect=1)["message"])
        self.assertIn("wants one sentence",
                      self.result("predicted: 1", "measured: 262144", "why: so", expect=1)["message"])

    def test_each_chapter_has_one(self):
        chapters = [exercise.chapter for exercise in exercises.load() if exercise.experiment]
        self.assertEqual(chapters, sorted({exercise.chapter for exercise in exercises.load()}))


class Figures(unittest.TestCase):
    def test_an_element_of_a_list_is_named_by_its_number_or_by_a_value(self):
        self.assertEqual(experiment._part_of([1, 2], "1"), 2)
        self.assertEqual(experiment._part_of([{"a": "x"}, {"a": "y", "b": 1}], "a=y")["b"], 1)


if __name__ == "__main__":
    unittest.main()
