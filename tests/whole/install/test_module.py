"""The module `raysteps` of Python, on two triangles one behind the other."""

import tempfile
import unittest
from pathlib import Path

import numpy as np
import raysteps

TRIANGLES = np.array([[[0, 0, z], [1, 0, z], [0, 1, z]] for z in range(8)], np.float32)
RAYS = np.array([[0.25, 0.25, 20, 0, 0, -1, 0, 100], [5, 5, 20, 0, 0, -1, 0, 100]], np.float32)


def with_short_box(tree):
    lower, upper = tree.lower.copy(), tree.upper.copy()
    leaf = int(np.flatnonzero(tree.count)[-1])
    upper[leaf, 0] = lower[leaf, 0]
    return raysteps.Tree(lower, upper, tree.children, tree.first, tree.count, tree.order), leaf


class ModuleTest(unittest.TestCase):
    def test_arrays_come_back_from_a_tree_as_they_went_in(self):
        tree = raysteps.build(TRIANGLES)
        again = raysteps.Tree(tree.lower, tree.upper, tree.children, tree.first, tree.count, tree.order)
        for name in ("lower", "upper", "children", "first", "count", "order"):
            np.testing.assert_array_equal(getattr(again, name), getattr(tree, name))

    def test_a_ray_finds_the_nearest_triangle(self):
        t, u, v, triangle = raysteps.trace(raysteps.build(TRIANGLES), TRIANGLES, RAYS)
        self.assertEqual(triangle.tolist(), [7, -1])
        self.assertEqual((t[0], u[0], v[0]), (13.0, 0.25, 0.25))
        self.assertEqual((t.dtype, triangle.dtype), (np.float32, np.int32))

    def test_a_short_box_is_found_and_explained(self):
        self.assertEqual(raysteps.check(raysteps.build(TRIANGLES), TRIANGLES, RAYS)["fault_kinds"], [])
        tree, leaf = with_short_box(raysteps.build(TRIANGLES))
        found = raysteps.check(tree, TRIANGLES, RAYS)
        self.assertEqual(found["fault_kinds"][0]["fault"], "box does not enclose its triangle")
        triangle = int(tree.order[tree.first[leaf]])
        ray = RAYS[0].copy()
        ray[2] = triangle + 0.5
        self.assertIn(f"Node {leaf} left it out", raysteps.why(tree, TRIANGLES, ray, triangle))

    def test_hits_are_judged(self):
        right = raysteps.judge(TRIANGLES, RAYS, np.float32([13, 0]), np.int32([7, -1]))
        self.assertEqual(right["wrong"], 0)
        wrong = raysteps.judge(TRIANGLES, RAYS, np.float32([14, 0]), np.int32([6, -1]))
        self.assertEqual(wrong["first_wrong"][0]["cause"], "triangle 7 is nearer")

    def test_a_tree_is_written_and_read(self):
        tree = raysteps.build(TRIANGLES)
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "own.rstree")
            raysteps.write(tree, path, "a test")
            again, made_by = raysteps.read(path, TRIANGLES)
        self.assertEqual(made_by, "a test")
        np.testing.assert_array_equal(again.lower, tree.lower)

    def test_wrong_shapes_and_trees_end_in_a_sentence(self):
        with self.assertRaisesRegex(ValueError, r"rays: the shape \(n, 8\) is needed"):
            raysteps.trace(raysteps.build(TRIANGLES), TRIANGLES, RAYS[:, :6])
        with self.assertRaisesRegex(ValueError, "finite"):
            raysteps.build(TRIANGLES * np.float32("nan"))
        tree = raysteps.build(TRIANGLES)
        children = tree.children.copy()
        children[int(np.flatnonzero(tree.count == 0)[-1]), 0] = 0
        cycle = raysteps.Tree(tree.lower, tree.upper, children, tree.first, tree.count, tree.order)
        with self.assertRaisesRegex(raysteps.InputError, "reached twice"):
            raysteps.trace(cycle, TRIANGLES, RAYS)

    def test_shapes_and_dtypes_stand_in_the_docstrings(self):
        for name in ("build", "check", "trace", "judge", "why", "read"):
            self.assertRegex(getattr(raysteps, name).__doc__, r"float32 \(n, 3, 3\)")


if __name__ == "__main__":
    unittest.main()
