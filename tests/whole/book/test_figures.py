"""The figures in the page turn and step."""

import sys
import unittest

from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin

from browser import NOT_RUN, SITE, BrowserTest, leave_if_missing

# How many pixels of a picture have nearly that colour. The browser itself decodes the picture.
COUNT = """
const [data, color, done] = arguments;
const image = new Image();
image.onload = () => {
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  const pixels = context.getImageData(0, 0, image.width, image.height).data;
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    count += color.every((part, k) => Math.abs(pixels[i + k] - part) < 12) ? 1 : 0;
  }
  done(count);
};
image.src = 'data:image/png;base64,' + data;
"""
STEP_COLOR = [230, 158, 0]
STRUCTURE_COLOR = [106, 76, 147]
STAND_STILL = """
let before = -1;
const look = () => { if (scrollY === before) arguments[0](); else { before = scrollY; setTimeout(look, 200); } };
look();
"""
FIGURES = {"04_grid.html": "cell", "05_kd_tree.html": "node", "06_bvh.html": "node"}


class Figures(BrowserTest):
    def open_figure(self, page):
        self.open(page)
        self.without_playgrounds()
        figure = self.browser.find_element("css selector", "figure.walk")
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", figure)
        self.wait_for("return arguments[0].dataset.ready", figure)
        return figure

    def canvas(self):
        return self.browser.find_element("css selector", ".walk-canvas")

    def sentence(self):
        return self.browser.find_element("css selector", ".walk-sentence").text

    def button(self, words):
        return next(button for button in self.browser.find_elements("css selector", ".walk-buttons button")
                    if button.text == words)

    def picture(self):
        """What the canvas shows. It can be read only right after it was drawn."""
        return self.browser.execute_script(
            "const figure = document.querySelector('figure.walk'); figure.scene.redraw();"
            "return figure.querySelector('canvas').toDataURL().split(',')[1]")

    def count(self, color):
        return self.browser.execute_async_script(COUNT, self.picture(), color)

    def test_each_figure_opens_with_the_whole_structure_and_goes_to_its_first_step(self):
        for page, word in FIGURES.items():
            with self.subTest(page=page):
                self.open_figure(page)
                self.assertTrue(self.sentence().startswith("The whole structure"), self.sentence())
                whole = self.count(STRUCTURE_COLOR)
                self.assertGreater(whole, 1000)
                self.assertEqual(self.count(STEP_COLOR), 0)
                self.keep_picture(f"whole_{page.removesuffix('.html')}")
                self.button("Next").click()
                self.assertLess(self.count(STRUCTURE_COLOR), 0.7 * whole)
                self.assertTrue(self.sentence().startswith(f"step 1: {word}"), self.sentence())
                # The edges of a box, four pixels wide and together some hundred long.
                self.assertGreater(self.count(STEP_COLOR), 400)
                self.keep_picture(f"figure_{page.removesuffix('.html')}")
                self.assertEqual(self.complaints(), [])

    def test_buttons_step(self):
        self.open_figure("04_grid.html")
        before, first = self.picture(), self.sentence()
        self.button("Next").click()
        self.assertTrue(self.sentence().startswith("step 1: "))
        self.assertNotEqual(self.picture(), before)
        self.button("Previous").click()
        self.assertEqual(self.sentence(), first)
        self.assertEqual(self.picture(), before)
        self.button("Previous").click()
        self.assertEqual(self.sentence(), first)

    def test_a_walk_plays_and_pauses(self):
        self.open_figure("04_grid.html")
        self.button("Play").click()
        self.wait_for("return document.querySelector('.walk-sentence').textContent.startsWith('step 2: ')")
        self.button("Pause").click()
        self.assertTrue(self.button("Play"))
        place = "return Number(document.querySelector('.walk-buttons input').value)"
        before = self.browser.execute_script(place)
        self.browser.execute_async_script("setTimeout(arguments[0], 1200)")
        self.assertEqual(self.browser.execute_script(place), before)

    def drag_a_finger(self, element, right, down):
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", element)
        self.browser.execute_async_script(STAND_STILL)
        x, y = self.browser.execute_script(
            "const b = arguments[0].getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]", element)
        top = self.browser.execute_script("return scrollY")
        for kind, parts in (("touchStart", [0]), ("touchMove", [i / 10 for i in range(1, 11)]), ("touchEnd", [None])):
            for part in parts:
                points = [] if part is None else [{"x": x + right * part, "y": y + down * part}]
                self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        return self.browser.execute_script("return scrollY") - top

    def test_a_finger_scrolls_the_page_and_turns_by_the_handle(self):
        self.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": True})
        try:
            self.open_figure("05_kd_tree.html")
            before = self.picture()
            self.assertGreater(self.drag_a_finger(self.canvas(), 0, -150), 50)
            self.assertEqual(self.picture(), before)
            handle = self.browser.find_element("css selector", ".walk-turn")
            self.assertEqual(self.drag_a_finger(handle, -100, -60), 0)
            self.assertNotEqual(self.picture(), before)
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
            self.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})

    def test_a_figure_takes_the_colours_of_the_page(self):
        self.open_figure("06_bvh.html")
        self.assertEqual(self.count([29, 32, 35]), 0)
        self.browser.execute_script("document.body.dataset.mdColorScheme = 'slate'")
        self.assertGreater(self.count([29, 32, 35]), 50_000)

    def test_keys_step(self):
        self.open_figure("06_bvh.html")
        self.canvas().click()
        ActionChains(self.browser).send_keys("n", Keys.ARROW_RIGHT, "n", "p").perform()
        self.assertTrue(self.sentence().startswith("step 2: "), self.sentence())
        ActionChains(self.browser).send_keys(Keys.END).perform()
        self.assertIn("the end", self.sentence())
        self.keep_picture("figure_last_step")
        ActionChains(self.browser).send_keys(Keys.HOME).perform()
        self.assertTrue(self.sentence().startswith("The whole structure"))

    def test_the_mouse_turns_and_the_step_stays(self):
        self.open_figure("05_kd_tree.html")
        self.button("Next").click()
        before, sentence = self.picture(), self.sentence()
        ActionChains(self.browser).move_to_element(self.canvas()).click_and_hold().move_by_offset(
            120, 40).release().perform()
        self.assertNotEqual(self.picture(), before)
        self.assertGreater(self.count(STEP_COLOR), 200)
        self.assertEqual(self.sentence(), sentence)
        self.keep_picture("figure_turned")

    def test_the_wheel_zooms_only_after_a_click(self):
        self.open_figure("04_grid.html")
        before = self.picture()
        wheel = ScrollOrigin.from_element(self.canvas())
        ActionChains(self.browser).scroll_from_origin(wheel, 0, 30).perform()
        self.assertEqual(self.picture(), before)
        self.canvas().click()
        ActionChains(self.browser).scroll_from_origin(wheel, 0, 30).perform()
        self.wait_for("const figure = document.querySelector('figure.walk'); figure.scene.redraw();"
                      "return figure.querySelector('canvas').toDataURL().split(',')[1]"
                      " !== arguments[0]", before)

    def test_without_webgl_the_picture_stays(self):
        self.browser.execute_cdp_cmd("Page.enable", {})
        script = self.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {
            "source": "HTMLCanvasElement.prototype.getContext = () => null;"})
        try:
            self.browser.get(f"http://127.0.0.1:{self.server.server_port}/04_grid.html")
            self.browser.execute_script("document.querySelector('figure.walk').scrollIntoView({behavior: 'instant'})")
            self.wait_for("return document.querySelector('figure.walk .walk-note')")
            self.assertIn("no WebGL", self.browser.find_element(
                "css selector", "figure.walk .walk-note").text)
            self.browser.execute_script("document.querySelector('figure.walk img').scrollIntoView()")
            self.wait_for("return document.querySelector('figure.walk img').naturalWidth > 0")
        finally:
            self.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)


if __name__ == "__main__":
    leave_if_missing()
    if not (SITE / "assets" / "vtk.js").exists():
        print("book: figures are not tested, because vtk.js could not be fetched.")
        sys.exit(NOT_RUN)
    unittest.main()
