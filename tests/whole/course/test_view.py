"""./course view opens the visualizer at the first wrong ray."""

import json
import subprocess
import unittest
from pathlib import Path

import jsonschema

from support import COURSE, ROOT, CourseTest, exercise_of, solution_of
from course import check, engine as engines, exercises, recorded, sandbox, view
from course.compare import Wrong

WRONG = """            real enters = crossing(ray, axis, up ? last : 0);
            real leaves = crossing(ray, axis, up ? last : 0);
            part.start = enters > part.start ? enters : part.start;
            part.end = leaves < part.end ? leaves : part.end;"""
RAY = exercises.ray_bits([-1, 0.5, 0.5, 1, 0, 0, 0, 4])


def result_of(number, checkpoint_name, **found):
    exercise = exercises.select_one(exercises.load(), number)
    checkpoint = next(c for c in exercise.checkpoints if c.name == checkpoint_name)
    return check.Result(exercise, check.FAILED, checkpoint=checkpoint, **found)


class Words(unittest.TestCase):
    def test_a_ray_in_a_scene_is_shown_in_it(self):
        result = result_of("6.4", "climb", wrong=Wrong(0, 1, RAY, []))
        self.assertEqual(view.wrong_ray(result),
                         ["soup:60", "--structure", "bvh_parent", "--leaf-triangles", "1",
                          "--ray=-1,0.5,0.5,1,0,0,0,4"])

    def test_a_grid_made_of_numbers_is_shown_by_its_file(self):
        words = view.wrong_ray(result_of("4.2", "first cell", wrong=Wrong(0, 1, RAY, [])))
        self.assertEqual(words[:5], ["chapters/04_grid/exercises/empty_grid.obj", "--resolution",
                                     "4", "--structure", "grid"])

    def test_a_wrong_pixel_is_shown_in_its_picture(self):
        result = result_of("4.3", "picture", pictures={"first_wrong_pixel": [33, 11]})
        self.assertEqual(view.wrong_ray(result), ["tetrahedron:2", "--structure", "grid", "--size",
                                                  "64x48", "--pixel=33,11"])

    def test_numbers_that_are_no_ray_are_not_shown(self):
        self.assertIsNone(view.wrong_ray(result_of("4.3", "axis", wrong=Wrong(0, 1, RAY, []))))
        self.assertIsNone(view.wrong_ray(result_of("2.1", "components", wrong=Wrong(0, 1, RAY, []))))

    def test_where_the_numbers_are_no_ray_the_wrong_pixel_is_shown(self):
        result = result_of("2.1", "components", wrong=Wrong(0, 1, RAY, []),
                           pictures={"first_wrong_pixel": [33, 11]})
        self.assertEqual(view.wrong_ray(result), ["tetrahedron:1", "--structure", "every_triangle",
                                                  "--size", "64x48", "--pixel=33,11"])

    def test_an_exercise_without_a_ray_in_a_scene_says_so(self):
        for number in ("7.3", "8.2", "9.1"):
            self.assertIn(f"{number} asks about no ray in a scene",
                          view.nothing_to_see(exercises.select_one(exercises.load(), number)))
        self.assertIn("There is no wrong ray or pixel",
                      view.nothing_to_see(exercises.select_one(exercises.load(), "8.1")))

    def test_every_file_that_is_to_be_shown_is_there(self):
        shown = [(e.chapter, c.view[0]) for e in exercises.load() for c in e.checkpoints if c.view]
        self.assertGreaterEqual(len(shown), 6)
        for chapter, name in shown:
            self.assertTrue((ROOT / "chapters" / chapter / "exercises" / name).is_file(), name)


SCHEMA = json.loads((ROOT / "visualizer" / "walk.schema.json").read_text())
BUILD = Path(COURSE[COURSE.index("--build") + 1]) if "--build" in COURSE else engines.BUILD


class RecordedSteps(CourseTest):
    """A student's walk, as the GPU makes it in launches of one round."""

    def walk(self, number, old, new, checkpoint_name):
        self.start()
        self.solve(number, solution_of(number).replace(old, new))
        exercise = exercise_of(number)
        checkpoint = next(c for c in exercise.checkpoints if c.name == checkpoint_name)
        engine = engines.Engine(build=BUILD, limits=sandbox.Limits(memory_bytes=0))
        return recorded.student_walk(engine, exercise, checkpoint, checkpoint.question["rays"][0],
                                     self.workbook, "scene")

    def test_a_walk_is_a_file_that_the_schema_knows(self):
        walk = self.walk("2.6", "is_nearer(hit, walk.nearest)", "is_hit(hit)", "nearest hit")
        jsonschema.validate(walk, SCHEMA)
        self.assertEqual([step["place"] for step in walk["steps"]], list(range(12)))
        self.assertEqual([step["round"] for step in walk["steps"]], list(range(1, 13)))
        self.assertTrue(walk["ended"])

    def test_a_walk_that_is_right_is_no_other_walk(self):
        self.assertIsNone(self.walk("2.6", "", "", "nearest hit"))

    def test_places_tests_and_hits_are_those_of_the_student(self):
        walk = self.walk("6.7", "tested.last ? no_bvh_triangle : walk.place.y + 1", "no_bvh_triangle",
                         "nearest hit")
        jsonschema.validate(walk, SCHEMA)
        self.assertEqual(walk["steps"][0]["place"], 0)
        self.assertEqual(walk["structure"], "bvh_skip:leaf-triangles=2")
        self.assertTrue(all(len(step["tested"]) <= 1 for step in walk["steps"]))

    def test_a_walk_without_an_end_is_cut(self):
        walk = self.walk("6.7", "walk.place.x + 1 : node.skip", "walk.place.x : node.skip", "nearest hit")
        self.assertFalse(walk["ended"])


class View(CourseTest):
    def view(self, *arguments):
        """What it printed; not tested where the visualizer was built without VTK."""
        done = subprocess.run([*COURSE, "--workbook", self.workbook, "view", *arguments],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if done.returncode == 3:
            self.skipTest(done.stderr)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_the_first_wrong_ray_is_drawn(self):
        self.start()
        self.solve("4.1", WRONG)
        self.assertIn("view        ./course view 4.1", self.course("check", "4.1", expect=1))
        picture = self.folder / "wrong.png"
        printed = self.view("4.1", "--screenshot", str(picture))
        self.assertIn("empty_grid.obj --resolution 4 --structure grid --steps build/course/walks/"
                      "exercise_4_1.json", printed)
        self.assertIn("First stands your walk", printed)
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")

    def test_a_walk_that_is_written_can_be_read_again(self):
        program = BUILD / "visualizer" / "visualizer"
        if not program.exists():
            self.skipTest("the visualizer is not built")
        file = self.folder / "walk.json"
        written = subprocess.run([program, "soup:60", "--structure", "bvh_skip", "--ray=0,0,9,0,0,-1",
                                  "--screenshot", self.folder / "a.png", "--export", file],
                                 capture_output=True, text=True, check=False)
        if written.returncode == 3:
            self.skipTest(written.stderr)
        self.assertEqual(written.returncode, 0, written.stderr)
        jsonschema.validate(json.loads(file.read_text()), SCHEMA)
        read = subprocess.run([program, "--steps", file, "--screenshot", self.folder / "b.png"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(read.returncode, 0, read.stderr)

    def test_a_ray_of_ones_own_needs_no_workbook(self):
        picture = self.folder / "own.png"
        self.view("5.3", "--ray=0,0,9,0,0,-1", "--screenshot", str(picture))
        self.assertGreater(picture.stat().st_size, 1000)

    def test_without_a_wrong_ray_it_says_so(self):
        self.start()
        self.assertIn("There is no wrong ray", self.view("4.1"))
        self.assertIn("asks about no ray", self.course("view", "1.1", "--ray=0,0,9,0,0,-1", expect=2))


if __name__ == "__main__":
    unittest.main()
