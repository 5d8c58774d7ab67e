"""Code is cut by its name."""

import unittest

from support import ROOT
from book.cut_code import cut
from book.errors import BookError

CODE = """#pragma once

// A box.
struct Box {
    float lower = 0.0f; // with a } in a comment
};

Box merge(const Box& a, const Box& b);

// Both
// together.
Box merge(const Box& a, const Box& b) {
    if (is_empty(a)) {
        return b;
    }
    return grown(a, "}");
}

namespace {
    int steps_of(int rounds) {
        //# exercise 4.3: the plane
        int secret = 1;
        return secret;
        //# stub: return 0;
        //# end
    }
}
"""


class CutCode(unittest.TestCase):
    def test_a_function_comes_with_the_comment_above_it(self):
        lines, first = cut(CODE, "merge")
        self.assertEqual(lines, ["// Both", "// together.",
                                 "Box merge(const Box& a, const Box& b) {", "    if (is_empty(a)) {",
                                 "        return b;", "    }", '    return grown(a, "}");', "}"])
        self.assertEqual(first, 10)

    def test_a_struct_ends_at_its_own_brace(self):
        lines, first = cut(CODE, "Box")
        self.assertEqual((lines[0], lines[-1], len(lines), first), ("// A box.", "};", 4, 3))

    def test_the_solution_of_an_exercise_is_left_out(self):
        lines, _ = cut(CODE, "steps_of")
        self.assertEqual(lines, ["int steps_of(int rounds) {", "    // exercise 4.3", "}"])

    def test_an_exercise_that_is_a_whole_function_is_left_out(self):
        lines, _ = cut("//# exercise 4.3: all\nint all() {\n    return 7;\n}\n//# stub: int all();\n//# end\n", "all")
        self.assertEqual(lines, ["// exercise 4.3"])

    def test_a_name_that_is_gone_is_an_error(self):
        for name in ("merged", "is_empty", "secret", "lower"):
            with self.assertRaisesRegex(BookError, f"no struct {name}"):
                cut(CODE, name)

    def test_a_call_is_no_definition(self):
        with self.assertRaises(BookError):
            cut("int main() {\n    return walk(3);\n}\n", "walk")

    def test_a_function_of_a_shader_is_cut_whole(self):
        lines, _ = cut((ROOT / "shaders/structure/every_triangle.glsl").read_text(), "go_on")
        self.assertTrue(lines[0].startswith("Walk go_on(Walk walk, Ray ray"))
        self.assertEqual(lines[-2:], ["    return walk;", "}"])


if __name__ == "__main__":
    unittest.main()
