"""Hunts: a mistake that the seed of a workbook chooses, a witness, and the repaired part."""

import json
import unittest

from support import HOW, CourseTest, exercise_of, solution_of
from course import errors, hunt, marks, verify, witness, workbook

WITNESS = "pixel 9,46"  # of the mistake of seed 1: the origin goes the other way


class Seeds(unittest.TestCase):
    def test_a_seed_chooses_one_of_at_least_five_mistakes(self):
        for number in ("3.6", "7.5", "8.5", "9.7"):
            exercise = exercise_of(number)
            planted = {"\n".join(hunt.planted(exercise, seed)[2:])
                       for seed in range(2 * len(exercise.plants))}
            self.assertGreaterEqual(len(planted), 5, number)
            self.assertNotIn(solution_of(number), planted)

    def test_the_seed_that_stands_in_the_lines_counts(self):
        exercise = exercise_of("3.6")
        code = hunt.planted(exercise, 8)
        self.assertEqual(hunt.seed_in(code), 8)
        self.assertEqual(hunt.stub_of(exercise, code, seed=3), code)
        self.assertEqual(hunt.stub_of(exercise_of("3.1"), seed=3), exercise_of("3.1").region.stub)

    def test_a_teachers_seed_gives_each_student_another_one(self):
        students = [f"student_{number}" for number in range(100)]
        seeds = [hunt.seed_of(student, 2026) for student in students]
        self.assertEqual(seeds, [hunt.seed_of(student, 2026) for student in students])
        self.assertNotEqual(seeds, [hunt.seed_of(student, 2027) for student in students])
        self.assertTrue(all(1000 <= seed <= 9999 for seed in seeds))
        for plants in (6, 7):
            self.assertEqual({seed % plants for seed in seeds}, set(range(plants)))

    def test_the_seed_of_another_student_is_no_witness(self):
        lines = hunt.planted(exercise_of("7.5"), 1234)
        said = witness.complaint(None, exercise_of("7.5"), lines, None, given_seed=4321)
        self.assertIn("`// seed 1234` is not this student's, whose seed is 4321", said)
        said = witness.complaint(None, exercise_of("7.5"), lines, None, given_seed=1234)
        self.assertIn("`// witness:` is empty", said)

    def test_no_planted_mistake_leaves_a_variable_unused(self):
        self.assertEqual(verify.unused_in(["real far = 1.0f;", "real near = far;", "return far;"]), ["near"])
        for number in ("3.6", "7.5", "8.5", "9.7"):
            exercise = exercise_of(number)
            for seed in range(len(exercise.plants)):
                self.assertEqual(verify.unused_in(hunt.planted(exercise, seed)), [], (number, seed))

    def test_where_there_is_no_picture_a_pixel_is_none(self):
        with self.assertRaisesRegex(errors.CourseError, "7.5 has no scene, and so no pixel"):
            witness.place_in(None, exercise_of("7.5"), "pixel 3,4", "--ray pixel 3,4")


class Hunt(CourseTest):
    def setUp(self):
        super().setUp()
        self.start("--seed", 1)
        self.exercise = exercise_of("3.6")

    def write(self, witness, code, seed=1):
        path = self.workbook / self.exercise.file
        lines = [f"// seed {seed}", f"// witness: {witness}", *code]
        path.write_text(marks.with_code(path.read_text(), path, {"3.6": lines}))

    def result(self, expect):
        return json.loads(self.course("check", "3.6", "--json", expect=expect))["results"][0]

    def test_a_workbook_has_the_mistake_of_its_seed_and_it_is_not_started(self):
        text = (self.workbook / self.exercise.file).read_text()
        self.assertIn("// seed 1\n// witness:\n", text)
        self.assertIn(self.exercise.plants[1]["replace"], text)
        self.assertEqual(self.result(0)["state"], "not started")
        self.assertIn("is a stub.", self.course("reset", "3.6"))

    def test_the_repaired_part_needs_a_witness(self):
        right = self.exercise.region.code
        self.write("", right)
        self.assertIn("`// witness:` is empty", self.result(1)["message"])
        self.write("pixel 99,0", right)
        self.assertIn("not in a picture of 64 x 48", self.result(1)["message"])
        self.write("0,0,0,x", right)
        self.assertIn("cannot be read", self.result(1)["message"])
        self.write("278,273,-800,0,0,-1", right)  # away from the scene
        self.assertIn("the witness is none", self.result(1)["message"])

    def test_a_witness_does_not_pass_without_the_repair_and_no_ray_is_told(self):
        self.write(WITNESS, hunt.planted(self.exercise, 1)[2:])
        result = self.result(1)
        self.assertIn("wrong still, at spots", result["message"])
        self.assertNotIn("ray", result)
        self.assertNotIn("replay", result)

    def test_both_pass(self):
        self.write(WITNESS, self.exercise.region.code)
        self.assertEqual(self.result(0)["state"], "passed")

    def test_a_ray_of_ones_own_is_tried_or_that_of_a_pixel(self):
        self.write("", hunt.planted(self.exercise, 1)[2:])
        printed = self.course("check", "3.6", "--ray=278,273,-800,0,-0.3,1", expect=1)
        self.assertIn("by          expected 18, got 0  <-- wrong", printed)
        self.assertIn("  <-- wrong", self.course("check", "3.6", "--ray", WITNESS, expect=1))

    def test_a_ray_that_is_no_spot_is_asked_nothing_else(self):
        self.write("", hunt.planted(self.exercise, 1)[2:])
        printed = self.course("check", "3.6", "--ray=278,273,-800,0,0,-1")
        self.assertIn("right here\n  no spot here: ", printed)

    def test_a_workbook_keeps_its_seed_and_a_student_has_one(self):
        self.course("start", "--student", "bob", expect=2)
        path = self.workbook / self.exercise.file
        path.unlink()
        self.course("start")
        self.assertIn("// seed 1\n", path.read_text())
        self.workbook = self.folder / "bob"
        self.course("start", "--student", "bob", "--seed", 2026)
        seed = hunt.seed_of("bob", 2026)
        self.assertEqual(workbook.seed_of(self.workbook, [self.exercise]), seed)
        self.write("", self.exercise.region.code, seed)
        for name, expected in (("bob", "`// witness:` is empty"), ("alice", "is not this student's")):
            found = self.folder / "grades.json"
            self.course("grade", "--one", self.workbook, "--student", name, "--seed", 2026, "--only", "3.6",
                        "--json", found, *HOW)
            detail, = json.loads(found.read_text())["grades"][0]["details"]
            self.assertIn(expected, detail["message"])


if __name__ == "__main__":
    unittest.main()
