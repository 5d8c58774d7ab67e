"""The way of a student: start, show, check, hint, reset, diff."""

import json
import unittest

from support import CourseTest, exercise_of, solution_of
from course import own

WRONG = """            real enters = crossing(ray, axis, up ? last : 0);
            real leaves = crossing(ray, axis, up ? last : 0);
            part.start = enters > part.start ? enters : part.start;
            part.end = leaves < part.end ? leaves : part.end;"""


class Student(CourseTest):
    def setUp(self):
        super().setUp()
        self.start()

    def result(self, number, expect):
        return json.loads(self.course("check", number, "--json", expect=expect))["results"][0]

    def test_start_never_writes_over_a_file(self):
        path = self.solve("2.1", "mine")
        self.assertIn("Nothing to make", self.course("start"))
        self.assertIn("mine", path.read_text())

    def test_what_is_not_started_is_no_error(self):
        self.assertEqual(self.result("2.1", 0)["state"], "not started")
        self.assertIn("2.1  not started", self.course("list", "02"))

    def test_a_missing_file_is_named_and_is_no_success(self):
        (self.workbook / "shaders/core/vector.glsl").unlink()
        self.assertEqual(self.result("2.1", 1)["state"], "missing")

    def test_marks_of_byte_order_and_other_ends_of_lines_do_not_matter(self):
        path = self.solve("2.1")
        text = path.read_text()
        for raw in (text.encode("utf-8-sig"), text.replace("\n", "\r\n").encode(), text.encode("utf-16")):
            path.write_bytes(raw)
            self.assertEqual(own.read_own(exercise_of("2.1"), self.workbook).composed.text, text)
        self.assertEqual(self.result("2.1", 0)["state"], "passed")

    def test_lines_that_were_changed_outside_the_marks_are_named(self):
        path = self.solve("2.1", "    real x = a.x;\n    real y = a.y;\n    real z = a.z;")
        lines = path.read_text().split("\n")
        place = lines.index("    return real3(x, y, z);")
        lines[place] = "    return real3(x, y, y);"
        path.write_text("\n".join(["// mine", *lines]))
        self.assertEqual(self.result("2.1", 1)["outside"], f"lines 1, {place + 2} are not the project's")

    def test_a_solution_passes_and_list_knows_as_long_as_it_stays(self):
        self.solve("2.1")
        self.assertEqual(self.result("2.1", 0)["state"], "passed")
        self.assertIn("2.1  passed", self.course("list", "02"))
        self.solve("2.1", "    real x = a.x;\n    real y = a.y;\n    real z = a.z;")
        self.assertIn("2.1  not checked", self.course("list", "02"))

    def test_the_first_wrong_checkpoint_is_told_with_ray_and_values(self):
        self.solve("4.1", WRONG)
        result = self.result("4.1", 1)
        self.assertEqual(result["checkpoint"], "slab interval")
        self.assertEqual(result["ray"]["decimal"][:6], [-1, 0.5, 0.5, 1, 0, 0])
        self.assertEqual(result["ray"]["hex"][:2], ["bf800000", "3f000000"])
        start = result["values"][0]
        self.assertEqual((start["name"], start["expected"], start["got"]), ("start", 1, 5))
        self.assertNotIn("pictures", result)
        self.assertEqual(result["no_picture"], "a checkpoint before it is wrong")

    def test_the_replay_asks_the_same_ray(self):
        self.solve("4.1", WRONG)
        words = self.result("4.1", 1)["replay"].split()
        self.assertEqual(words[:3], ["./course", "check", "4.1"])
        replayed = self.course(*words[1:], expect=1)
        self.assertIn("expected 1, got 5", replayed)

    def test_numbers_that_are_no_ray_have_their_own_names(self):
        self.solve("2.1", "    real x = a.x;\n    real y = a.y;\n    real z = a.z;")
        printed = self.course("check", "2.1", expect=1)
        self.assertIn("  a           1, 2, 3   (hex 3f800000 40000000 40400000)\n", printed)
        self.assertIn("  b           4, 5, 6 ", printed)
        self.assertNotIn("t_max", printed.replace("--ray", ""))

    def test_a_ray_of_a_picture_has_its_pixel_and_its_parts(self):
        self.solve("1.2", "    Ray ray = primary_ray(view, 0.25, 0.5);")
        printed = self.course("check", "1.2", expect=1)
        self.assertIn("column 0, row 0 from below, in a picture of 2 x 2 pixels of cornell_box",
                      printed)
        self.assertIn("  direction y expected -0.178571433, got 0  <-- wrong\n", printed)

    def test_a_wrong_exercise_does_not_block_the_next(self):
        self.solve("4.1", WRONG)
        self.solve("4.3")
        self.assertEqual(self.result("4.3", 0)["state"], "passed")

    def test_a_wrong_step_is_numbered(self):
        self.solve("4.3", "    return t.x <= t.y ? 0 : 1;")
        self.solve("4.4", solution_of("4.4").replace("cell[axis] + 1", "cell[axis] + 2"))
        self.assertEqual(self.result("4.4", 1)["step"], 1)
        self.assertEqual(self.result("4.3", 1)["checkpoint"], "axis")

    def test_an_error_of_the_compiler_names_the_line_of_the_workbook(self):
        path = self.solve("4.2", "    low = lost;")
        result = self.result("4.2", 1)
        self.assertEqual(result["state"], "does not compile")
        line = path.read_text().split("\n").index("    low = lost;") + 1
        self.assertIn(f"shaders/structure/grid/grid_cells.glsl:{line}: error: `lost'",
                      result["message"])
        self.assertNotIn("checkpoint.frag", result["message"])  # it is not the student's

    def test_lost_marks_are_named_and_reset_brings_them_back(self):
        path = self.solve("2.4", "    return true;")
        path.write_text(path.read_text().replace("//# end", ""))
        self.assertIn("does not end", self.result("2.4", 1)["message"])
        self.course("reset", "2.4")
        self.assertEqual(self.result("2.4", 0)["state"], "not started")
        self.assertIn("return true;", path.with_name("hit.glsl.before_reset").read_text())

    def test_reset_leaves_the_other_exercises_of_the_file(self):
        path = self.solve("4.1", WRONG)
        self.solve("4.2", "    low = 1;")
        self.course("reset", "4.1")
        self.assertIn("low = 1;", path.read_text())
        self.assertNotIn("up ? last : 0", path.read_text())

    def test_reset_never_writes_over_what_it_kept_before(self):
        self.solve("4.1", WRONG)
        path = self.solve("4.2", "    low = 1;")
        self.course("reset", "4.1")
        self.course("reset", "4.2")
        self.assertIn("4.2 is a stub.", self.course("reset", "4.2"))
        kept = sorted(file.name for file in path.parent.glob("*.before_reset*"))
        self.assertEqual(kept, ["grid_cells.glsl.before_reset", "grid_cells.glsl.before_reset_2"])
        self.assertIn("up ? last : 0", path.with_name(kept[0]).read_text())
        self.assertIn("low = 1;", path.with_name(kept[1]).read_text())

    def test_the_solution_is_shown_after_it_passes_or_when_one_gives_up(self):
        self.assertIn("2.1: not started. The solution", self.course("diff", "2.1", expect=2))
        self.assertIn("+    precise real x", self.course("diff", "2.1", "--give-up"))
        self.solve("2.1")
        self.course("check", "2.1")
        self.assertIn("line by line", self.course("diff", "2.1"))

    def test_hints_come_in_three_levels(self):
        self.assertEqual(self.course("hint", "4.2").count("Hint "), 1)
        self.assertEqual(self.course("hint", "4.2", "--level", 3).count("Hint "), 3)

    def test_show_names_task_file_and_source(self):
        shown = self.course("show", "4.2")
        self.assertIn("grid_cells.glsl:", shown)
        self.assertIn("Amanatides and Woo", shown)
        self.assertIn("u = P . s / det,   v = ", self.course("show", "2.2"))

    def test_show_names_headers_and_fields(self):
        shown = self.course("show", "7.2")
        self.assertIn("headers      basics/statistics.h\n", shown)
        self.assertIn("  MeasuredRange: median, lowest, highest\n", shown)
        self.assertIn("  Ray: origin, direction, t_min, t_max\n", self.course("show", "4.4"))
        self.assertIn("  BvhItem: box, triangle\n", self.course("show", "6.5"))

    def test_wrong_usage_says_what_to_take(self):
        self.assertIn("9.9 is no chapter and no exercise", self.course("check", "9.9", expect=2))
        self.assertIn("six numbers", self.course("check", "4.1", "--ray=1,2", expect=2))
        self.workbook = self.folder / "nothing"
        self.assertIn("Run `./course start`", self.course("check", "4.1", expect=2))


if __name__ == "__main__":
    unittest.main()
