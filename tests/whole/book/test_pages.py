"""Pages are made from the project's own texts."""

import json
import os
import re
import tomllib
import unittest
from pathlib import Path

from support import ROOT, FolderTest
from book.contents import page_names, parts
from book.directives import carry_out, directives_in, output_file, shown_command
from book.errors import BookError
from book.figures import TABLE
from book.links import Links
from book.lists import family_name, items, section, work
from book.pages import make_page

PAGE = Path("chapters/04_a/README.md")


class Pages(FolderTest):
    def made(self, text, **settings):
        self.write(str(PAGE), text)
        names = {PAGE: "04_a.md", Path("docs/course.md"): "course.md"}
        links = Links(self.folder, self.folder / "out", names, self.folder / "made", **settings)
        return make_page(PAGE, links)

    def test_a_link_to_a_page_leads_to_the_page(self):
        self.write("docs/course.md", "")
        self.assertEqual(self.made("[c](../../docs/course.md#for-teachers)"),
                         "[c](course.md#for-teachers)")

    def test_a_link_to_a_source_leads_to_its_lines(self):
        self.write("common/a.h", "int a;\nint <b>;\n")
        self.assertEqual(self.made("[a](../../common/a.h)"), "[a](source/common/a.h.html)")
        self.assertIn('<li id="L2">int &lt;b&gt;;</li>',
                      (self.folder / "out/source/common/a.h.html").read_text())

    def test_a_source_shows_a_solution_only_to_who_asks(self):
        self.write("common/a.cpp", "int a() {\n    //# exercise 4.3: a\n    return 7;\n    //# stub: return 0;\n"
                   "    //# end\n}\n")
        self.made("[a](../../common/a.cpp)")
        page = (self.folder / "out/source/common/a.cpp.html").read_text()
        folded = re.search("<details><summary>exercise 4.3: show the solution</summary>(.*?)</details>", page).group(1)
        self.assertIn('<li id="L3">    return 7;</li>', folded)
        self.assertNotIn("return 7", page.replace(folded, ""))
        self.assertEqual([int(n) for n in re.findall('id="L(\\d+)"', page)], [1, 2, 3, 4, 5, 6])
        self.assertIn('<ol start="6"><li id="L6">}</li></ol>', page)

    def test_a_link_into_nowhere_is_an_error_with_its_line(self):
        with self.assertRaisesRegex(BookError, r"README.md:3: \.\./gone.md leads to .*gone.md"):
            self.made("a\n\n[b](../gone.md)")

    def test_a_picture_that_was_made_again_is_taken(self):
        self.write("chapters/04_a/expected.png", "old")
        self.write("made/chapters/04_a/expected.png", "new")
        self.assertEqual(self.made("![p](expected.png)"),
                         "![p](pictures/chapters_04_a_expected.png){ loading=lazy }")
        self.assertEqual((self.folder / "out/pictures/chapters_04_a_expected.png").read_text(), "new")

    def test_a_picture_keeps_its_room_until_it_is_loaded(self):
        (self.write("chapters/04_a/p.png", "")).write_bytes((ROOT / "docs/pictures/bunny.png").read_bytes())
        self.assertTrue(self.made("![p](p.png)").endswith("{ loading=lazy width=384 height=384 }"))
        self.write("chapters/04_a/s.svg", "<svg viewBox='0 0 9 7' width='560' height='340'/>")
        self.assertTrue(self.made("![s](s.svg)").endswith("{ loading=lazy width=560 height=340 }"))

    def test_a_drawing_that_moves_names_the_script_with_its_moments(self):
        self.write("chapters/04_a/drawings/d.svg", "<svg/>")
        self.write("chapters/04_a/drawings/d.py", "ALT, HEIGHT, SENTENCES = 'a', 50, []\n"
                   "MOVES = ('at {}', [1, 2, 3], 2)\n"
                   "def draw(canvas, lesson, x):\n"
                   "    canvas.line((0, 0), (9, 9))\n"
                   "    canvas.text((x * 9, 9), str(x))\n")
        script = "pictures/chapters_04_a_drawings_d.js"
        self.assertEqual(self.made("![a](drawings/d.svg)"),
                         f'![a](pictures/chapters_04_a_drawings_d.svg){{ data-moving="{script}" loading=lazy }}')
        name, _, moments = (self.folder / "out" / script).read_text().partition(" = ")
        moments = json.loads(moments.rstrip(";\n"))
        self.assertIn(script, name)
        self.assertEqual((moments["words"], moments["still"]), (["at 1", "at 2", "at 3"], 1))
        self.assertEqual(moments["svg"].count("<polyline"), 1, "what all moments have stands once")

    def test_a_drawing_that_stands_still_is_a_picture(self):
        self.write("chapters/04_a/drawings/d.svg", "<svg/>")
        self.write("chapters/04_a/drawings/d.py", "ALT, HEIGHT, SENTENCES = 'a', 50, []\n"
                   "def draw(canvas, lesson):\n    canvas.text((9, 9), 'a')\n")
        self.assertEqual(self.made("![a](drawings/d.svg)"), "![a](pictures/chapters_04_a_drawings_d.svg){ loading=lazy }")

    def test_a_function_stands_where_it_is_named(self):
        self.write("shaders/a.glsl", "int one() {\n    return 1;\n}\n")
        self.assertEqual(self.made("<!-- code: shaders/a.glsl one -->").split("\n")[2:],
                         ["```glsl", "int one() {", "    return 1;", "}", "```"])

    def test_a_function_that_is_gone_is_an_error_with_its_line(self):
        self.write("shaders/a.glsl", "int one() {\n    return 1;\n}\n")
        with self.assertRaisesRegex(BookError, r"04_a/README.md:2: shaders/a.glsl: .* two"):
            self.made("text\n<!-- code: shaders/a.glsl two -->")

    def test_what_a_program_printed_stands_where_it_is_named(self):
        self.write(str(output_file(Path("made"), "04_a --size 8")), "rays 64\n")
        self.assertIn("```text\nrays 64\n```", self.made("<!-- output: 04_a --size 8 -->"))
        with self.assertRaisesRegex(BookError, "has not been made"):
            self.made("<!-- output: 04_a --size 9 -->")

    def test_a_figure_without_a_viewer_says_so(self):
        self.write("made/walks/w.json", "{}")
        self.write("made/walks/w.png", "")
        self.write("made/walks/w.about.json",
                   json.dumps({"command": "visualizer bunny", "caption": "A <walk>"}))
        self.assertNotIn("data-viewer", self.made("<!-- walk: w -->"))
        self.assertIn('data-viewer="none"', self.made("<!-- walk: w -->", has_viewer=False))
        self.assertIn("A &lt;walk&gt;", self.made("<!-- walk: w -->"))

    def test_directives_in_code_stay(self):
        self.assertIn("<!-- code: x y -->", self.made("a\n\n    <!-- code: x y -->\n"))

    def test_an_unknown_list_is_an_error(self):
        with self.assertRaisesRegex(BookError, "no list stars"):
            self.made("<!-- list: stars -->")

    def test_only_an_exercise_in_a_shader_can_be_played(self):
        for number in ("6.5", "6.9"):  # in C++, and none
            with self.assertRaisesRegex(BookError, f"{number} is no exercise in a shader"):
                carry_out(f"<!-- play: {number} -->", Links(ROOT, self.folder, [], self.folder), None)

    def test_a_lesson_shows_the_playground_with_choices_that_it_has(self):
        with self.assertRaisesRegex(BookError, "no choice wlak"):
            carry_out("<!-- play: wlak=grid -->", Links(ROOT, self.folder, [], self.folder), None)
        made = "".join(carry_out("<!-- play: walk=grid&open=card -->", Links(ROOT, self.folder, [], self.folder), None))
        self.assertIn('data-play="#walk=grid&amp;open=card"', made)

    def test_the_lessons_have_each_exercise_in_a_shader_once(self):
        links = Links(ROOT, self.folder, [], self.folder)
        for lesson in sorted((ROOT / "chapters").glob("[0-9]*/README.md")):
            played = [words for kind, words in directives_in(lesson.read_text()) if kind == "play" and "=" not in words]
            wanted = [exercise.number for exercise in links.exercises if exercise.is_shader and exercise.chapter == lesson.parent.name]
            self.assertEqual(sorted(played), sorted(wanted))
            for number in played:
                self.assertIn(f'data-play="{number}"', "".join(carry_out(f"<!-- play: {number} -->", links, None)))


class Lists(unittest.TestCase):
    def test_items_of_a_section_are_joined(self):
        text = '# A\n\n## Sources\n\n- B, "C d",\n  1987.\n- E.\n\n## Tests\n\n- F\n'
        self.assertEqual(items(section(text, "Sources")), ['B, "C d", 1987.', "E."])

    def test_a_work_is_known_by_its_title(self):
        self.assertEqual(work('A. B, "On Trees!", 1990.'), work('A. Bee: "on trees", 1990: the SAH.'))

    def test_works_are_sorted_by_the_family_name_of_the_first_author(self):
        self.assertEqual(family_name('I. Wald and V. Havran, "On", 2006'), "wald")
        self.assertEqual(family_name('Wang and Wen: "Research", 2010'), "wang")

    def test_a_command_is_shown_as_it_is_typed(self):
        self.assertEqual(shown_command("04_grid --size 64"), "./run.sh 04 --size 64")
        self.assertEqual(shown_command("visualizer bunny"), "./run.sh view bunny")
        self.assertEqual(shown_command("hard_cases --case T1"), "./run.sh hard_cases --case T1")


class Contents(unittest.TestCase):
    def test_every_page_is_there_under_a_name_of_its_own(self):
        names = page_names(ROOT)
        self.assertEqual(len(set(names.values())), sum(len(paths) for _, paths in parts(ROOT)))
        self.assertGreaterEqual(len(names), 20)
        for path in names:
            self.assertTrue((ROOT / path).is_file(), path)

    def test_every_picture_of_a_page_is_made_again_by_a_command(self):
        table = tomllib.loads((ROOT / TABLE).read_text())
        made = {entry["file"] for entry in table["picture"]}
        shown = set()
        for path in page_names(ROOT):
            for target in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", (ROOT / path).read_text()):
                if "drawings/" not in target:  # test_drawings makes these again
                    shown.add(os.path.normpath(path.parent / target))
        self.assertGreaterEqual(len(shown), 10)
        self.assertEqual(shown - made, set())
        self.assertEqual(made - shown, set())

    def test_every_chapter_begins_with_a_picture_and_a_question_and_ends_with_what_was_shown(self):
        for path in page_names(ROOT):
            if path.parts[0] == "chapters":
                text = (ROOT / path).read_text()
                self.assertLess(text.index("!["), text.index("## The question"), path)
                self.assertIn("## What was shown", text, path)


if __name__ == "__main__":
    unittest.main()
