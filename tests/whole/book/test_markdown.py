"""Markdown of code hosts becomes Markdown of Python-Markdown."""

import unittest

import support  # noqa: F401  (finds the package)
from book.markdown import change_targets, is_code, open_details, widen_lists


def widened(text):
    lines = text.split("\n")
    return widen_lists(lines, is_code(lines))


class Markdown(unittest.TestCase):
    def test_the_text_of_an_item_is_moved_to_four_spaces(self):
        self.assertEqual(widened("- one\n  more\n\n  also\n2. two\n   more"),
                         ["-   one", "    more", "", "    also", "", "2.  two", "    more"])

    def test_code_in_an_item_stays_code(self):
        self.assertEqual(widened("- one:\n\n      ls\n")[2], "        ls")

    def test_a_list_after_a_line_gets_an_empty_line(self):
        self.assertEqual(widened("Take:\n- one"), ["Take:", "", "-   one"])

    def test_an_item_after_one_of_several_paragraphs_gets_an_empty_line(self):
        self.assertEqual(widened("- one\n\n  more\n- two\n- three"),
                         ["-   one", "", "    more", "", "-   two", "-   three"])

    def test_indented_and_fenced_lines_are_code(self):
        lines = ["a", "", "    - b", "", "```", "- c", "```", "d", "    e"]
        self.assertEqual(is_code(lines),
                         [False, False, True, False, True, True, True, False, False])

    def test_targets_change_and_code_does_not(self):
        def change(target, is_picture):
            return ("P:" if is_picture else "L:") + target
        self.assertEqual(change_targets("[a](b.md), ![c](d.png) and `[e](f)`", change),
                         "[a](L:b.md), ![c](P:d.png) and `[e](f)`")
        self.assertEqual(change_targets("[see `x` there](y.md)", change), "[see `x` there](L:y.md)")

    def test_text_in_details_is_markdown(self):
        self.assertEqual(open_details("<details><summary>Why?</summary>"),
                         '<details markdown="1">\n<summary markdown="span">Why?</summary>')


if __name__ == "__main__":
    unittest.main()
