"""Every page in a browser: no complaint, formulas set, search, narrow screens."""

import unittest

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from browser import SITE, BrowserTest, leave_if_missing
from support import ROOT
from book.contents import page_names

PAGES = sorted(name.replace(".md", ".html") for name in page_names(ROOT).values())
OTHERS = ["source/shaders/structure/grid/grid.glsl.html", "api/index.html", "api/annotated.html"]
WIDE = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
# What is wider than the screen and lies in nothing that scrolls by itself: for the message.
WIDEST = """
const limit = document.documentElement.clientWidth;
return [...document.querySelectorAll('.md-content *')].filter(
  (e) => e.getBoundingClientRect().right > limit + 1).slice(0, 3).map((e) => e.outerHTML.slice(0, 150));
"""


class Browser(BrowserTest):
    def test_pages_load_without_complaints_and_set_their_formulas(self):
        for page in PAGES + OTHERS:
            with self.subTest(page=page):
                self.open(page)
                self.assertEqual(self.complaints(), [])
                self.assertEqual(self.browser.execute_script(
                    "return [...document.querySelectorAll('.arithmatex')].filter("
                    "(e) => !e.querySelector('.katex')).length"), 0)
                broken = self.browser.execute_script(
                    "return [...document.images].filter((i) => !i.naturalWidth).map((i) => i.src)")
                self.assertEqual(broken, [])

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
        self.assertIn("Mailboxes", found)
        self.keep_picture("search")

    def test_narrow_screens_do_not_scroll_sideways(self):
        for page in PAGES:
            with self.subTest(page=page):
                self.open(page, width=375, height=800)
                # A window may be wider than asked for; its inside is what counts.
                self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                    "width": 375, "height": 800, "deviceScaleFactor": 1, "mobile": False})
                too_wide = self.browser.execute_script(WIDE)
                self.assertLessEqual(too_wide, 0, self.browser.execute_script(WIDEST))
                if page == "04_grid.html":
                    self.keep_picture("narrow")
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def test_drawings_have_the_colours_of_the_page_and_the_whole_width_of_a_phone(self):
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": "dark"}]})
        self.open("02_triangles.html", width=390, height=800)
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": False})
        seen = self.browser.execute_script("""
            const isDark = document.body.dataset.mdColorScheme === 'slate';
            return [...document.querySelectorAll('article img[src$=".svg"]')].map((img) => [
              img.alt.length > 60, getComputedStyle(img).colorScheme === (isDark ? 'dark' : 'light'),
              img.getBoundingClientRect().left, img.getBoundingClientRect().right]);""")
        self.assertGreaterEqual(len(seen), 3)
        self.open("06_bvh.html", width=390, height=800)
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": False})
        self.browser.execute_script("document.querySelector('[data-moving]').scrollIntoView()")
        moving = self.wait_for("""
            const svg = document.querySelector('figure.moving svg');
            if (!svg) return null;
            const box = svg.getBoundingClientRect();
            return [svg.getAttribute('aria-label').length > 60, true, box.left, box.right];""")
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
        for has_words, follows_page, left, right in [*seen, moving]:
            self.assertTrue(has_words and follows_page)
            self.assertAlmostEqual(left, 0, delta=1)
            self.assertAlmostEqual(right, 390, delta=1)

    def test_a_drawing_moves_by_keys_and_by_a_pointer_and_stands_still_before(self):
        self.open("05_kd_tree.html")
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


if __name__ == "__main__":
    leave_if_missing()
    unittest.main()
