"""The drawings in a browser, as wide as a phone and as a desk, light and dark: what can be measured of how they look."""

import shutil
import tempfile
import unittest
from pathlib import Path

from browser import leave_without, start_browser
from support import ROOT
from drawings.catalogue import descriptions, make
from drawings.palette import COLORS

WIDTHS = (390, 1280)
SMALLEST = 11  # of a letter, in pixels, where a drawing is 390 wide
WORDS, SHAPES = 4.5, 3.0  # contrasts that WCAG 2.1 asks for: of text, and of what else is to be seen

# Of each drawing its frame and shapes; of each text its box, its least letter, the box it belongs to, its colour.
MEASURE = """
const box = (element) => {
  const all = element.tagName !== 'text' ? [] :
    [...element.querySelectorAll('tspan')].filter((e) => e.textContent.trim());
  const rects = (all.length ? all : [element]).map((e) => e.getBoundingClientRect());
  return [Math.min(...rects.map((r) => r.left)), Math.min(...rects.map((r) => r.top)),
          Math.max(...rects.map((r) => r.right)), Math.max(...rects.map((r) => r.bottom))];
};
const seen = (elements) => [...elements].filter((element) => element.getClientRects().length > 0);
const measure = (svg, name) => ({
  name,
  frame: box(svg),
  card: getComputedStyle(svg.querySelector('.back')).fill,
  colors: [...new Map(seen(svg.querySelectorAll('[class]')).map(
    (e) => [e.getAttribute('class'), getComputedStyle(e).color]))],
  shapes: seen(svg.querySelectorAll('polyline, polygon, path, circle, rect')).map(
    (e) => [e.outerHTML.slice(0, 60), box(e)]),
  texts: seen(svg.querySelectorAll('text')).map((text) => ({
    words: text.textContent,
    box: box(text),
    within: text.parentElement.classList.contains('boxed') ? box(text.parentElement.querySelector('rect')) : null,
    color: getComputedStyle(text).color,
    size: Math.min(...[text, ...text.querySelectorAll('tspan')].map((e) => parseFloat(getComputedStyle(e).fontSize)))
          * svg.getBoundingClientRect().width / svg.viewBox.baseVal.width,
  })),
});
const measurements = [];
for (const svg of document.querySelectorAll('svg.drawing')) {
  const moments = [...svg.querySelectorAll('.moment')];
  if (moments.length > 0 && !arguments[0]) continue;
  moments.forEach((moment, i) => {
    moments.forEach((one) => one.classList.toggle('shown', one === moment));
    measurements.push(measure(svg, `${svg.parentElement.id} ${i}`));
  });
  if (moments.length === 0) measurements.push(measure(svg, svg.parentElement.id));
}
return measurements;
"""


def page(drawings):
    """All drawings in one page, as wide as it is but not over their own width; those that move once more."""
    figures = [(drawing.path.stem, drawing.file.read_text()) for drawing in drawings]
    figures += [(f"{drawing.path.stem} moving", drawing.moving_svg) for drawing in drawings if drawing.moments]
    return (
        "<!doctype html><meta charset='utf-8'><style>body { margin: 0 } figure { margin: 0; max-width: 560px }"
        "svg { display: block; width: 100%; height: auto } .moment:not(.shown) { display: none }</style>\n"
        + "".join(f"<figure id='{name}'>{svg}</figure>\n" for name, svg in figures)
    )


def is_within(inner, outer, slack=0.5):
    return (
        inner[0] >= outer[0] - slack
        and inner[1] >= outer[1] - slack
        and inner[2] <= outer[2] + slack
        and inner[3] <= outer[3] + slack
    )


def overlap(a, b):
    """By how much two boxes cover each other, along the axis on which they do so least."""
    return min(min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1]))


def luminance(color):
    """Of `rgb(36, 41, 47)`, as WCAG 2.1 has it."""
    parts = [int(part) / 255 for part in color[color.index("(") + 1 : -1].split(",")[:3]]
    parts = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]


def contrast(a, b):
    dark, light = sorted((luminance(a), luminance(b)))
    return (light + 0.05) / (dark + 0.05)


def faults_of(drawing, width):
    """What is wrong with a drawing as it is seen, as sentences."""
    found = []
    texts = drawing["texts"]
    for number, text in enumerate(texts):
        if not is_within(text["box"], drawing["frame"]):
            found.append(f"{text['words']!r} leaves the frame")
        if text["within"] and not is_within(text["box"], text["within"]):
            found.append(f"{text['words']!r} leaves its box")
        if width == min(WIDTHS) and text["size"] < SMALLEST:
            found.append(f"{text['words']!r} is set in {text['size']:.1f} pixels")
        if contrast(text["color"], drawing["card"]) < WORDS:
            found.append(f"{text['words']!r} has a contrast of {contrast(text['color'], drawing['card']):.1f}")
        for other in texts[number + 1 :]:
            if overlap(text["box"], other["box"]) > 1:
                found.append(f"{text['words']!r} overlaps {other['words']!r}")
    found += [
        f"{words} leaves the frame"
        for words, place in drawing["shapes"]
        if not is_within(place, drawing["frame"])
    ]
    for kind, color in drawing["colors"]:
        roles = set(kind.split()) & set(COLORS)
        if roles and roles != {"rule"} and contrast(color, drawing["card"]) < SHAPES:
            found.append(f"a shape of {kind} has a contrast of {contrast(color, drawing['card']):.1f}")
    return found


class DrawingsSeen(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.drawings = [make(path) for path in descriptions(ROOT)]
        cls.folder = tempfile.mkdtemp(prefix="raysteps_test_drawings_")
        cls.browser = start_browser()
        file = Path(cls.folder) / "drawings.html"
        file.write_text(page(cls.drawings))
        cls.browser.get(file.as_uri())

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        shutil.rmtree(cls.folder)

    def seen(self, width, theme, with_moments):
        self.browser.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False},
        )
        self.browser.execute_cdp_cmd(
            "Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": theme}]}
        )
        return self.browser.execute_script(MEASURE, with_moments)

    def test_words_are_large_enough_keep_apart_and_stay_within_frame_and_box(self):
        cards = set()
        for width in WIDTHS:
            for theme in ("light", "dark"):
                with_moments = (width, theme) == (
                    WIDTHS[0],
                    "light",
                )  # what differs from the still one are places
                drawings = self.seen(width, theme, with_moments)
                self.assertEqual(
                    len(drawings), sum(1 + len(one.moments) * with_moments for one in self.drawings)
                )
                cards.update(one["card"] for one in drawings)
                for drawing in drawings:
                    with self.subTest(drawing=drawing["name"], width=width, theme=theme):
                        self.assertGreater(len(drawing["texts"]), 0)
                        self.assertEqual(faults_of(drawing, width), [])
        self.assertEqual(len(cards), 2, "one background for light, one for dark")


class Faults(unittest.TestCase):
    """The measures themselves, on drawings that have faults."""

    def drawing(self, *texts):
        return {
            "name": "a",
            "frame": [0, 0, 100, 100],
            "card": "rgb(255, 255, 255)",
            "colors": [],
            "shapes": [],
            "texts": [
                {"words": words, "box": box, "within": within, "color": color, "size": size}
                for words, box, within, color, size in texts
            ],
        }

    def test_each_fault_is_found(self):
        black, grey = "rgb(0, 0, 0)", "rgb(150, 150, 150)"
        self.assertEqual(faults_of(self.drawing(("a", [1, 1, 9, 9], None, black, 12)), 390), [])
        for text, fault in (
            (("a", [95, 1, 102, 9], None, black, 12), "leaves the frame"),
            (("a", [1, 1, 20, 9], [2, 0, 18, 10], black, 12), "leaves its box"),
            (("a", [1, 1, 9, 9], None, black, 10), "10.0 pixels"),
            (("a", [1, 1, 9, 9], None, grey, 12), "contrast of 3.0"),
        ):
            self.assertIn(fault, faults_of(self.drawing(text), 390)[0])
        two = self.drawing(("a", [1, 1, 9, 9], None, black, 12), ("b", [7, 7, 20, 20], None, black, 12))
        self.assertEqual(faults_of(two, 390), ["'a' overlaps 'b'"])
        line = self.drawing() | {"shapes": [["<line>", [50, 50, 101, 60]]]}
        self.assertEqual(faults_of(line, 390), ["<line> leaves the frame"])
        pale = self.drawing() | {
            "colors": [["thin quiet", "rgb(190, 190, 190)"], ["rule", "rgb(190, 190, 190)"]]
        }
        self.assertEqual(faults_of(pale, 390), ["a shape of thin quiet has a contrast of 1.9"])

    def test_contrast_is_that_of_the_guidelines(self):
        self.assertAlmostEqual(contrast("rgb(0, 0, 0)", "rgb(255, 255, 255)"), 21)
        self.assertAlmostEqual(contrast("rgb(118, 118, 118)", "rgb(255, 255, 255)"), 4.54, 2)


if __name__ == "__main__":
    leave_without("chromium", "chromedriver")
    unittest.main()
