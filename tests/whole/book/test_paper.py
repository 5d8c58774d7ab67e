"""The book on paper: all of it in one file, whole pages, nothing cut off, and no heading alone at the foot of a page."""

import contextlib
import io
import re
import unittest
from unittest import mock

from browser import SITE, STORE, BrowserTest, leave_if_missing
from pdf_pages import pages
from support import ROOT
from book.__main__ import main
from book.contents import page_names
from book.paper import WHOLE, print_book, section, whole_book

WIDTH = 673  # of a page without its margins, 178 mm, in pixels
HEADINGS = (26.66, 20.83, 16.66)  # sizes of letters
LEAST = 10  # pieces of text on a page that is not blank
LOOK = """
const limit = document.documentElement.clientWidth;
// (The space at which words of a line are parted may hang beyond its end: so of words alone nothing is asked.)
const seen = (selector) => [...document.querySelectorAll(selector)].filter((e) => e.getClientRects().length > 0);
return {
  wide: seen('.md-typeset *').filter((e) => !e.closest('.katex') && getComputedStyle(e).display !== 'inline'
      && e.getBoundingClientRect().right > limit + 1)
    .map((e) => `${e.closest('section').id}: ${Math.round(e.getBoundingClientRect().right - limit)} px ${e.outerHTML.slice(0, 90)}`),
  cut: seen('pre, table, .md-typeset__scrollwrap, .arithmatex').filter((e) => e.scrollWidth > e.clientWidth + 2)
    .map((e) => `${e.closest('section').id}: ${e.outerHTML.slice(0, 90)}`),
  buttons: seen('button, input, canvas').length,
  closed: document.querySelectorAll('details:not([open])').length,
  walks: seen('figure.walk img').length,
  unset: [...document.querySelectorAll('.arithmatex')].filter((e) => !e.querySelector('.katex')).length,
  broken: [...document.images].filter((i) => !i.naturalWidth).map((i) => i.src),
  back: getComputedStyle(document.body).backgroundColor,
};
"""


class Sections(unittest.TestCase):
    def made(self, inner):
        return section("04_grid", f"<body><article class='md-content'>{inner}</article></body>", ["04_grid", "05_kd"])

    def test_links_stay_within_the_book_and_marks_are_a_pages_own(self):
        self.assertEqual(self.made('<h2 id="x">X</h2><a href="#x">a</a><a class="word" href="05_kd.html#y">b</a>'
                                   '<a href="05_kd.html">c</a>'),
                         '<section id="04_grid"><h2 id="04_grid--x">X</h2><a href="#04_grid--x">a</a>'
                         '<a class="word" href="#05_kd--y">b</a><a href="#05_kd">c</a></section>')

    def test_links_to_sources_are_words_and_links_to_the_web_stay(self):
        self.assertIn('<a>a</a><a href="https://a.org/b.html#c">d</a>',
                      self.made('<a href="source/a.h.html#L3">a</a><a href="https://a.org/b.html#c">d</a>'))

    def test_answers_are_open_and_pictures_are_there_at_once(self):
        self.assertIn('<details open><summary>Why?</summary>', self.made("<details><summary>Why?</summary></details>"))
        self.assertNotIn("lazy", self.made('<img src="a.png" loading="lazy">'))


class Missing(unittest.TestCase):
    def test_without_chromium_one_sentence_says_so(self):
        said = io.StringIO()
        with mock.patch.dict("os.environ", PATH="/nowhere"), contextlib.redirect_stderr(said):
            code = main(["serve", "--pdf", "--store", str(STORE)])
        self.assertEqual((code, said.getvalue()), (
            3, "book: chromium is missing, and without it the book cannot be printed. Install chromium.\n"))


class Paper(BrowserTest):
    maxDiff = None

    def test_nothing_is_cut_off_and_only_what_can_be_printed_is_there(self):
        (SITE / WHOLE).write_text(whole_book(ROOT, SITE))
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "media": "print", "features": [{"name": "prefers-color-scheme", "value": "dark"}]})
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": WIDTH, "height": 980, "deviceScaleFactor": 1, "mobile": False})
        self.open(WHOLE)
        seen = self.browser.execute_script(LOOK)
        walks = sum((ROOT / path).read_text().count("\n<!-- walk: ") for path in page_names(ROOT))
        self.assertGreaterEqual(walks, 4)
        self.assertEqual(seen, {"wide": [], "cut": [], "buttons": 0, "closed": 0, "walks": walks, "unset": 0,
                                "broken": [], "back": "rgb(255, 255, 255)"})

    def test_the_file_has_every_page_in_order_none_blank_and_no_heading_at_a_foot(self):
        names = re.findall('<section id="([^"]*)">', whole_book(ROOT, SITE))
        self.assertEqual(names, [name.removesuffix(".md") for name in page_names(ROOT).values()])
        found = pages(print_book(ROOT, STORE).read_bytes())
        self.assertGreater(len(found), 80)
        for number, (sizes, pictured) in enumerate(found, 1):
            with self.subTest(page=number):
                self.assertTrue(pictured or len(sizes) >= LEAST, f"{len(sizes)} pieces of text")
                self.assertFalse(any(abs(sizes[-1] - heading) < 0.1 for heading in HEADINGS), "a heading comes last")
        all_sizes = {round(size, 2) for sizes, _ in found for size in sizes}
        self.assertLessEqual(set(HEADINGS), all_sizes, "headings are found by these sizes")


if __name__ == "__main__":
    leave_if_missing()
    unittest.main()
