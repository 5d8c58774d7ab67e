"""Every page in a browser: no complaint, formulas set, words linked; search, phones, dark pages."""

import functools
import gzip
import re
import struct
import unittest
import zipfile
from urllib.parse import unquote, urlparse

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from browser import SITE, BrowserTest, leave_if_missing
from support import ROOT
from book.contents import is_lesson, page_names
from book.words import GLOSSARY, words_of
from drawings.canvas import WIDTH
from drawings.catalogue import descriptions

PAGES = sorted(name.replace(".md", ".html") for name in page_names(ROOT).values())
OTHERS = ["source/shaders/structure/grid/grid.glsl.html", "api/index.html", "api/annotated.html"]
WIDE = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
# What is wider than the screen and lies in nothing that scrolls by itself: for the message.
WIDEST = """
const limit = document.documentElement.clientWidth;
return [...document.querySelectorAll('.md-content *')].filter(
  (e) => e.getBoundingClientRect().right > limit + 1).slice(0, 3).map((e) => e.outerHTML.slice(0, 150));
"""
# The links to words in a lesson, and the text in which words are to be linked.
READ = """
const article = document.querySelector('article').cloneNode(true);
[...article.querySelectorAll('details')].filter((e) => e.textContent.trim().startsWith('The symbols')).forEach((e) => e.remove());
for (const heading of article.querySelectorAll('#sources')) {
  while (heading.nextElementSibling && heading.nextElementSibling.tagName !== 'H2') heading.nextElementSibling.remove();
}
article.querySelectorAll('h1, h2, h3, h4, a:not(.word), pre, code, th, summary, .arithmatex, figure').forEach(
  (e) => e.replaceWith(' | '));
return [[...document.querySelectorAll('article a.word')].map((a) => a.hash.slice(1)), article.textContent];
"""
LOADED = """
return ['navigation', 'resource'].flatMap((kind) => performance.getEntriesByType(kind)).map((entry) => entry.name);
"""
HEAVIEST = 700_000  # bytes that a phone loads for a page when it is opened, without the walk; texts are packed
PACKED = (".html", ".js", ".css", ".json", ".svg")
WORDS = words_of((ROOT / GLOSSARY).read_text())
LESSONS = {name.replace(".md", ".html") for path, name in page_names(ROOT).items() if is_lesson(path)}


@functools.cache
def bytes_of(name):
    """How many bytes a reader loads for this file of the book; none of what only walks need."""
    file = SITE / name
    if not name or not file.is_file() or name.startswith("walks/") or file.name == "vtk.js":
        return 0
    data = file.read_bytes()
    return len(gzip.compress(data)) if file.suffix in PACKED else len(data)


def weight(addresses):
    """How many bytes these files of the book have together."""
    return sum(map(bytes_of, {unquote(urlparse(address).path).lstrip("/") for address in addresses}))


def unlinked(links, text):
    """Names of words that a text uses without a link. Those that mean other things as well are left to test_words."""
    names = {word.anchor: word.name.split(",")[0] for word in WORDS if not (word.is_code or word.has_phrases)}
    return [name for anchor, name in names.items() if anchor not in links
            and re.search(rf"(?<![\w-]){re.escape(name)}s?(?![\w-])", text, re.IGNORECASE)]


class Browser(BrowserTest):
    def test_pages_load_without_complaints_with_formulas_and_linked_words_and_fit_a_phone(self):
        """Each is loaded once, on a phone, and widened then."""
        checked = 0
        for page in PAGES + OTHERS:
            with self.subTest(page=page), self.phone():
                self.open(page)
                if page in PAGES:
                    loaded = self.browser.execute_script(LOADED)
                    self.assertGreater(weight(loaded), 100_000)
                    self.assertLess(weight(loaded), HEAVIEST)
                    too_wide = self.browser.execute_script(WIDE)
                    self.assertLessEqual(too_wide, 0, self.browser.execute_script(WIDEST))
                if page == "04_grid.html":
                    self.keep_picture("narrow")
            with self.subTest(page=page):
                self.assertEqual(self.browser.execute_script(
                    "return [...document.querySelectorAll('.arithmatex')].filter("
                    "(e) => !e.querySelector('.katex')).length"), 0)
                self.browser.execute_script("[...document.images].forEach((i) => { i.loading = 'eager'; })")
                self.wait_for("return [...document.images].every((i) => i.complete)")
                broken = self.browser.execute_script(
                    "return [...document.images].filter((i) => !i.naturalWidth).map((i) => i.src)")
                self.assertEqual(broken, [])
                if page in LESSONS:
                    links, text = self.browser.execute_script(READ)
                    checked += len(links)
                    self.assertEqual(len(links), len(set(links)), links)
                    self.assertEqual(unlinked(links, text), [])
                self.assertEqual(self.complaints(), [])
        self.assertGreater(checked, 100)

    def test_a_word_shows_its_meaning_and_leads_to_the_glossary(self):
        self.open("02_triangles.html")
        word = self.browser.find_element("css selector", "a.word[href$='#barycentric-coordinates']")
        shown = "return getComputedStyle(arguments[0], '::after').display"
        self.assertEqual(self.browser.execute_script(shown, word), "none")
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", word)
        ActionChains(self.browser).move_to_element(word).perform()
        self.assertEqual(self.browser.execute_script(shown, word), "block")
        self.keep_picture("word")
        self.assertIn("weights", word.get_attribute("data-meaning"))
        word.click()
        self.wait_for("return location.hash === '#barycentric-coordinates' && document.querySelector(':target')")

    def test_pages_are_dark_where_the_system_wishes_it_until_the_reader_turns_the_switch(self):
        scheme = "return document.body.dataset.mdColorScheme"
        wish = {"features": [{"name": "prefers-color-scheme", "value": "dark"}]}
        try:
            self.open("01_rays.html")
            self.assertEqual(self.browser.execute_script(scheme), "default")
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", wish)
            self.open("04_grid.html")
            self.assertEqual(self.browser.execute_script(scheme), "slate")
            self.keep_picture("dark")
            self.open("source/shaders/structure/grid/grid.glsl.html")
            self.assertIn("rgb(255, 255, 255)", self.browser.execute_script("return getComputedStyle(document.body).color"))
            self.open("04_grid.html")
            self.browser.find_element("css selector", "[data-md-component=palette] label:not([hidden])").click()
            self.assertEqual(self.browser.execute_script(scheme), "default")
            self.open("05_kd_tree.html")
            self.assertEqual(self.browser.execute_script(scheme), "default")
            self.open("source/shaders/structure/grid/grid.glsl.html")
            self.assertEqual(self.browser.execute_script("return getComputedStyle(document.body).color"), "rgb(0, 0, 0)")
        finally:
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
            self.browser.execute_script("localStorage.clear()")

    def test_a_source_shows_a_solution_when_it_is_asked_for(self):
        self.open("source/shaders/structure/grid/grid.glsl.html")
        seen = "return document.querySelector('details li').checkVisibility()"
        self.assertFalse(self.browser.execute_script(seen))
        summary = self.browser.find_element("css selector", "details summary")
        self.assertEqual(summary.text, "exercise 4.4: show the solution")
        summary.click()
        self.assertTrue(self.browser.execute_script(seen))

    def test_drawings_are_offered_as_svg_and_png(self):
        self.open("teaching.html")
        link = self.browser.find_element("css selector", "article a[href='drawings.zip']")
        with zipfile.ZipFile(SITE / link.get_attribute("href").rsplit("/", 1)[1]) as archive:
            pictures = [name for name in archive.namelist() if name.endswith(".png")]
            self.assertEqual(len(pictures), len(descriptions(ROOT)))
            for name in pictures:
                data = archive.read(name)
                self.assertEqual(struct.unpack(">I", data[16:20])[0], 2 * WIDTH)
                self.assertGreater(len(data), 5_000, f"{name} is empty")

    def test_formulas_are_there(self):
        self.open("02_triangles.html")
        self.assertGreater(len(self.browser.find_elements("css selector", ".katex")), 20)
        self.assertNotIn("$", self.browser.find_element("css selector", "article p").text)

    def test_nothing_is_asked_of_another_machine(self):
        self.open("index.html")
        asked = self.browser.execute_script(
            "return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertGreater(len(asked), 5)
        self.assertEqual([name for name in asked if "//127.0.0.1:" not in name
                          and not name.startswith(("data:", "blob:"))], [])

    def test_search_finds_a_word(self):
        self.open("index.html")
        self.browser.execute_script("document.querySelector('#__search').click()")
        self.wait_for("return document.querySelector('[data-md-component=search-query]')"
                      ".getBoundingClientRect().width > 0")
        self.browser.find_element("css selector", "[data-md-component=search-query]").send_keys(
            "mailbox")
        found = self.wait_for("const all = [...document.querySelectorAll('.md-search-result__item')];"
                              "return all.length > 0 && all.map((item) => item.textContent).join()")
        self.assertIn("Must a triangle in two cells be tested twice?", found)
        self.keep_picture("search")

    def test_drawings_have_the_colours_of_the_page_and_the_whole_width_of_a_phone(self):
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": "dark"}]})
        with self.phone(390):
            self.open("02_triangles.html")
            seen = self.browser.execute_script("""
                const isDark = document.body.dataset.mdColorScheme === 'slate';
                return [...document.querySelectorAll('article img[src$=".svg"]')].map((img) => [
                  img.alt.length > 60, getComputedStyle(img).colorScheme === (isDark ? 'dark' : 'light'),
                  img.getBoundingClientRect().left, img.getBoundingClientRect().right]);""")
            self.assertGreaterEqual(len(seen), 3)
            self.open("06_bvh.html")
            self.without_playgrounds()
            self.browser.execute_script("document.querySelector('[data-moving]').scrollIntoView()")
            moving = self.wait_for("""
                const svg = document.querySelector('figure.moving svg');
                if (!svg) return null;
                const box = svg.getBoundingClientRect();
                return [svg.getAttribute('aria-label').length > 60, true, box.left, box.right];""")
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
        for has_words, follows_page, left, right in [*seen, moving]:
            self.assertTrue(has_words and follows_page)
            self.assertAlmostEqual(left, 0, delta=1)
            self.assertAlmostEqual(right, 390, delta=1)

    def test_a_drawing_moves_by_keys_and_by_a_pointer_and_stands_still_before(self):
        self.open("05_kd_tree.html")
        self.without_playgrounds()
        picture = self.browser.find_element("css selector", "[data-moving]")
        self.browser.execute_script("arguments[0].scrollIntoView()", picture)
        self.wait_for("return document.querySelector('figure.moving input')")
        said = "return document.querySelector('figure.moving output').textContent"
        shown = "return [...document.querySelectorAll('figure.moving .moment.shown')].map((e) => e.textContent).join()"
        self.assertEqual(self.browser.execute_script(said), "the plane at x = 4")
        self.assertIn("4.85", self.browser.execute_script(shown))
        self.browser.find_element("css selector", "figure.moving input").send_keys(Keys.ARROW_RIGHT)
        self.assertEqual(self.browser.execute_script(said), "the plane at x = 4.25")
        self.assertNotIn("4.85", self.browser.execute_script(shown))
        drawing = self.browser.find_element("css selector", "figure.moving svg")
        ActionChains(self.browser).move_to_element_with_offset(drawing, 200, 0).click_and_hold().move_by_offset(
            20, 0).release().perform()
        self.assertGreater(float(self.browser.execute_script(said).split()[-1]), 8)
        self.assertEqual(self.complaints(), [])
        self.keep_picture("moving")

    def test_answers_open(self):
        self.open("01_rays.html")
        self.browser.execute_script("document.querySelector('details summary').click()")
        self.assertTrue(self.browser.execute_script(
            "return document.querySelector('details').open "
            "&& document.querySelector('details p').offsetHeight > 0"))

    def test_the_playground_has_the_editor_that_was_fetched_and_is_small(self):
        self.open("playground/exercises.html#exercise=6.2")
        self.wait_for("return document.body.dataset.exercise === '6.2'")
        is_fetched = (SITE / "playground" / "codemirror.js").exists()
        self.assertEqual(self.browser.execute_script("return Boolean(document.querySelector('.editor').shadowRoot)"), is_fetched)
        self.browser.execute_script("Raysteps.play.page.editor.goTo(1)")
        keys = ActionChains(self.browser)
        keys.send_keys(Keys.HOME, "// mine ", Keys.TAB).perform()
        self.wait_for("return Raysteps.play.workbook.text('shaders/structure/bvh/bvh_skip.glsl').includes('// mine ')")
        self.assertFalse(self.browser.execute_script("return document.querySelector('.editor').contains(document.activeElement)"))
        loaded = [name for name in self.browser.execute_script(LOADED) if "/data/exercises_" not in name and "/data/scene_" not in name]
        self.assertTrue(any(name.endswith("/data/shaders.js") for name in loaded))
        self.assertLess(weight(loaded), 600_000)
        self.assertEqual(self.complaints(), [])
        self.browser.execute_script("localStorage.clear()")


if __name__ == "__main__":
    leave_if_missing()
    unittest.main()
