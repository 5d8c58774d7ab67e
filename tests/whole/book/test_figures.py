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
FIGURES = {"04_grid.html": "cell", "05_kd_tree.html": "node", "06_bvh.html": "node"}


class Figures(BrowserTest):
    def open_figure(self, page):
        self.open(page)
        figure = self.browser.find_element("css selector", "figure.walk")
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", figure)
        return figure

    def canvas(self):
        return self.browser.find_element("css selector", ".walk-canvas")

    def sentence(self):
        return self.browser.find_element("css selector", ".walk-sentence").text

    def picture(self):
        """What the canvas shows. It can be read only right after it was drawn."""
        return self.browser.execute_script(
            "const figure = document.querySelector('figure.walk'); figure.scene.redraw();"
            "return figure.querySelector('canvas').toDataURL().split(',')[1]")

    def count(self, color):
        return self.browser.execute_async_script(COUNT, self.picture(), color)

    def test_each_figure_shows_its_first_step(self):
        for page, word in FIGURES.items():
            with self.subTest(page=page):
                self.open_figure(page)
                self.assertTrue(self.sentence().startswith(f"step 1: {word}"), self.sentence())
                # The edges of a box, four pixels wide and together some hundred long.
                self.assertGreater(self.count(STEP_COLOR), 400)
                self.keep_picture(f"figure_{page.removesuffix('.html')}")
                self.assertEqual(self.complaints(), [])

    def test_buttons_step(self):
        figure = self.open_figure("04_grid.html")
        before, first = self.picture(), self.sentence()
        previous, following = figure.find_elements("css selector", "button")
        following.click()
        self.assertTrue(self.sentence().startswith("step 2: "))
        self.assertNotEqual(self.picture(), before)
        previous.click()
        self.assertEqual(self.sentence(), first)
        self.assertEqual(self.picture(), before)
        previous.click()
        self.assertEqual(self.sentence(), first)

    def test_keys_step(self):
        self.open_figure("06_bvh.html")
        self.canvas().click()
        ActionChains(self.browser).send_keys("n", Keys.ARROW_RIGHT, "n", "p").perform()
        self.assertTrue(self.sentence().startswith("step 3: "), self.sentence())
        ActionChains(self.browser).send_keys(Keys.END).perform()
        self.assertIn("the end", self.sentence())
        self.keep_picture("figure_last_step")
        ActionChains(self.browser).send_keys(Keys.HOME).perform()
        self.assertTrue(self.sentence().startswith("step 1: "))

    def test_the_mouse_turns_and_the_step_stays(self):
        self.open_figure("05_kd_tree.html")
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
            self.wait_for("return document.querySelector('figure.walk .walk-note')")
            self.assertIn("no WebGL", self.browser.find_element(
                "css selector", "figure.walk .walk-note").text)
            self.assertGreater(self.browser.execute_script(
                "return document.querySelector('figure.walk img').naturalWidth"), 0)
        finally:
            self.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)


if __name__ == "__main__":
    leave_if_missing()
    if not (SITE / "assets" / "vtk.js").exists():
        print("book: figures are not tested, because vtk.js could not be fetched.")
        sys.exit(NOT_RUN)
    unittest.main()
