"""Words of the glossary are linked where a lesson first uses them."""

import re
import unittest

from support import ROOT
from book.contents import chapters, is_lesson
from book.markdown import is_code
from book.words import GLOSSARY, SYMBOLS, link_words, symbols_of, with_anchors, words_of

TEXT = """# Words

| word | meaning | where |
| --- | --- | --- |
| kd-tree | a *tree*, see [there](a.md) | [05](a.md) |
| leaf | an end | [05](a.md) |
| pass <!-- a pass, pass # --> | one drawing, of $n$ pixels | [01](a.md) |
| `precise` | a word of GLSL | [01](a.md) |
| primary ray | from the "camera" | [01](a.md) |
| ray | a half-line | [01](a.md) |
"""
WORDS = words_of(TEXT)


def linked(text):
    lines = text.split("\n")
    return "\n".join(link_words(lines, is_code(lines), WORDS))


def words_in(text):
    return re.findall(r"\[([^\]]*)\]\(glossary.md#([\w-]+)\)\{ \.word", linked(text))


class Words(unittest.TestCase):
    def test_a_word_is_linked_once_and_brings_its_meaning(self):
        self.assertEqual(linked("A ray. A ray."),
                         'A [ray](glossary.md#ray){ .word data-meaning="a half-line" }. A ray.')

    def test_meanings_are_words_alone(self):
        meanings = {word.name: word.meaning for word in WORDS}
        self.assertEqual(meanings["kd-tree"], "a tree, see there")
        self.assertEqual(meanings["pass"], "one drawing, of n pixels")
        self.assertEqual(meanings["primary ray"], "from the 'camera'")

    def test_the_longer_word_is_taken_first(self):
        self.assertEqual(words_in("Primary rays and rays"), [("Primary rays", "primary-ray"), ("rays", "ray")])

    def test_a_word_may_go_over_the_end_of_a_line(self):
        self.assertEqual(words_in("a primary\nray"), [("primary\nray", "primary-ray")])

    def test_plurals_are_the_same_word(self):
        self.assertEqual(words_in("two leaves"), [("leaves", "leaf")])

    def test_headings_code_formulas_links_tags_and_sources_are_left_alone(self):
        for text in ("# A ray", "`a ray`", "```\nray\n```", "a\n\n    ray\n", "$ray$", "$$\nray\n$$", "[a ray](b.md)",
                     "![a ray](b.png)", "<summary>A ray?</summary>", '<img alt="ray">', "| ray |\n| --- |",
                     "## Sources\n\n- A ray, 1968.", "array", "x-ray",
                     '<details markdown="1">\n<summary markdown="span">The symbols</summary>\n\nray\n</details>'):
            with self.subTest(text=text):
                self.assertEqual(linked(text), text)

    def test_text_behind_what_is_left_alone_is_read(self):
        self.assertEqual(words_in("## Sources\n\n- A ray.\n\n## A ray\n\nOne `ray`, $ray$ and [ray](b): a ray."),
                         [("ray", "ray")])

    def test_a_word_with_phrases_is_linked_only_in_these(self):
        self.assertEqual(words_in("They pass by. A pass and pass 7."), [("A pass", "pass")])
        self.assertEqual(words_in("They pass by pass 7."), [("pass 7", "pass")])

    def test_a_word_of_glsl_is_linked_where_it_is_code(self):
        self.assertEqual(words_in("To be precise, `precise float` and `precise`."), [("`precise`", "precise")])

    def test_a_word_is_linked_in_a_fold_only_if_it_stands_nowhere_else(self):
        fold = "<details><summary>More</summary>\n\nA ray, a leaf.\n</details>\n"
        text = linked(f"{fold}\nA ray.")
        self.assertLess(text.index("[leaf]"), text.index("</details>"))
        self.assertGreater(text.index("[ray]"), text.index("</details>"))

    def test_lines_stay_as_many(self):
        self.assertEqual(linked("a primary\nray\n\nray").count("\n"), 3)

    def test_the_glossary_has_a_place_for_each_word(self):
        made = "\n".join(with_anchors(TEXT.split("\n")))
        self.assertEqual(re.findall('<span id="([^"]*)"></span>', made), [word.anchor for word in WORDS])
        self.assertIn('| <span id="leaf"></span>leaf | an end | [05](a.md) |', made)


class Symbols(unittest.TestCase):
    def test_a_table_of_symbols_is_read(self):
        table = ("<details><summary>The symbols of this chapter</summary>\n\n| symbol | meaning | in the code |\n"
                 "| --- | --- | --- |\n| $u$, $v$; $W, H$ | weights | `hit.u` |\n| $(s, t)$ | a place, $x$ |\n"
                 "| $R = 2w\\,r$, $E(p, q)$ | a side | |\n\nMore.\n</details>")
        self.assertEqual(symbols_of(f"# A\n\n{table}\n"), ["u", "v", "W", "H", "s", "t", "R", "E"])
        self.assertEqual(symbols_of("# A\n"), [])

    def test_in_a_lesson_one_symbol_means_one_thing_and_is_used(self):
        for path in chapters(ROOT):
            text = (ROOT / path).read_text()
            symbols = symbols_of(text)
            with self.subTest(lesson=str(path)):
                self.assertEqual(len(symbols), len(set(symbols)), symbols)
                rest = SYMBOLS.sub("", text)
                self.assertEqual([symbol for symbol in symbols if symbol not in rest], [])


class Glossary(unittest.TestCase):
    words = words_of((ROOT / GLOSSARY).read_text())

    def test_it_is_in_order_and_each_word_has_a_place_of_its_own(self):
        names = [word.name.strip("`").lower() for word in self.words]
        self.assertEqual(names, sorted(names))
        self.assertGreaterEqual(len({word.anchor for word in self.words}), 55)
        self.assertEqual(len({word.anchor for word in self.words}), len(self.words))

    def test_it_has_the_words_of_opengl(self):
        anchors = {word.anchor for word in self.words}
        self.assertLessEqual({"program", "uniform", "sampler", "layout", "in", "framebuffer", "query"}, anchors)

    def test_meanings_fit_into_an_attribute(self):
        for word in self.words:
            self.assertNotRegex(word.meaning, r'["{}<>|]', word.name)
            self.assertGreater(len(word.meaning), 10, word.name)

    def test_almost_every_word_is_used_by_a_lesson(self):
        text = "".join((ROOT / path).read_text() for path in chapters(ROOT) if is_lesson(path))
        unused = [word.name for word in self.words if not word.pattern.search(text)]
        self.assertLess(len(unused), 8, unused)


if __name__ == "__main__":
    unittest.main()
