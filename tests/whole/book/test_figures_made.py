"""Figures are made by their programs, and only when they are out of date."""

import os
import unittest

from support import FolderTest
from book import contents, figures
from book.directives import output_file
from book.errors import BookError

PROGRAM = """#!/bin/sh
echo "scene $1"
echo "wrote $PWD/out/a.png"
while [ "$1" != --out ]; do shift; done
echo run >> "$RAN"
echo picture > "$2/a.png"
"""
TABLE = """[[picture]]
file = "docs/a.png"
command = "04_a --size 8"
made = "{made}"
"""


class Figures(FolderTest):
    def setUp(self):
        super().setUp()
        self.ran = self.folder / "ran"
        os.environ["RAN"] = str(self.ran)
        self.program = self.write("build/chapters/04_a/04_a", PROGRAM)
        self.program.chmod(0o755)
        self.write("shaders/a.glsl", "")
        self.write("chapters/04_a/README.md", "<!-- output: 04_a --size 16 -->\n")
        self.write(figures.TABLE, TABLE.format(made="a.png"))
        for _, paths in contents.parts(self.folder):
            for path in paths:
                if not (self.folder / path).exists():
                    self.write(str(path), "")
        for path in [self.program, self.folder / "shaders/a.glsl"]:
            os.utime(path, (1000, 1000))
        self.said = []

    def make(self):
        figures.make_figures(self.folder, self.folder / "build", self.folder / "made",
                             self.said.append)
        return self.ran.read_text().count("run")

    def test_a_picture_and_an_output_are_made_once(self):
        self.assertEqual(self.make(), 2)
        self.assertEqual((self.folder / "made/docs/a.png").read_text(), "picture\n")
        printed = output_file(self.folder / "made", "04_a --size 16").read_text()
        self.assertEqual(printed, "scene --size\nwrote out/a.png\n")
        self.assertEqual(self.make(), 2)

    def test_a_newer_program_or_shader_or_another_command_makes_them_again(self):
        self.make()
        os.utime(self.folder / "shaders/a.glsl", (4e9, 4e9))
        self.assertEqual(self.make(), 4)
        os.utime(self.folder / "shaders/a.glsl", (1000, 1000))
        self.assertEqual(self.make(), 4)
        self.write(figures.TABLE, TABLE.format(made="a.png").replace("--size 8", "--size 9"))
        self.assertEqual(self.make(), 5)

    def test_a_program_that_fails_or_makes_something_else_is_named(self):
        self.write(figures.TABLE, TABLE.format(made="b.png"))
        with self.assertRaisesRegex(BookError, "makes no b.png"):
            self.make()
        self.program.write_text("#!/bin/sh\necho no light >&2\nexit 3\n")
        with self.assertRaisesRegex(BookError, "04_a --size 8.* exit code 3: no light"):
            self.make()


if __name__ == "__main__":
    unittest.main()
