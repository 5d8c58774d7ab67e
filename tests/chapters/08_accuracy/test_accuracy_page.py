"""The page of chapter 08: what scripts/accuracy_page makes of known numbers."""

import base64
import copy
import json
import re
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[3] / "scripts"
sys.path.insert(0, str(SCRIPTS))

from accuracy_page.page import rate_words, to_html  # noqa: E402
from accuracy_page.scatter import BOTTOM, LABEL_HEIGHT, TOP, Axis, Mark, label_heights, to_svg  # noqa: E402

VOID = {"meta", "img", "br"}
PNG = b"\x89PNG and more"


def rate(counted, lowest, highest):
    return {"per_million": counted, "lower_bound": lowest, "upper_bound": highest}


def method(name, cost, faults, error, dominated=False):
    return {"method": name, "nanoseconds": cost, "lowest": 0.9 * cost, "highest": 1.1 * cost,
            "dominated": dominated, "faults": faults, "error": error}


def measurement(name, family, count):
    fault = {"name": "missed", "count": count, "of": 1000, **rate(count * 1000.0, 0.0, 3000.0)}
    return {"method": name, "family": family, "timed_cases": 10, "nanoseconds": 12.5, "lowest": 12.0,
            "highest": 13.0, "faults": [fault], "measures": {"at outlines": 2.0},
            "error": {"median": 0.5, "percentile_99": 3.25, "largest": 40.0}}


REPORT = {
    "head": {"commit": "abc", "modified": True, "date": "2026-01-02T03:04:05Z", "cpu": "<fast>", "cores": 2,
             "renderer": "llvmpipe", "opengl": "4.5", "scenes": [{"scene": "a <wedge> & more"}]},
    "circumstances": {"seed": "1"},
    "scene_needs": ["The mesh is closed."],
    "advice": [{"trade_off": "triangle", "need": "default", "condition": "no fault",
                "methods": ["sure & slow", "other"]},
               {"trade_off": "triangle", "need": "preview", "condition": "few", "methods": []}],
    "trade_offs": [
        {"trade_off": "speed only", "question": "Which?", "source": "", "kind": "speed_only",
         "unit_of_cases": "ray", "unit_of_error": "", "pictures": [],
         "methods": [method("a", 1.0, rate(0.0, 0.0, 3.0), 0.0)],
         "measurements": [measurement("a", "camera", 0)]},
        {"trade_off": "triangle", "question": "Where?", "source": "Somebody, 1999.", "kind": "methods",
         "unit_of_cases": "ray", "unit_of_error": "t, in ulp",
         "pictures": [{"caption": "wrong 'pixels'", "file": "pictures/wrong.png"}],
         "methods": [method("fast", 10.0, rate(500.0, 400.0, 600.0), 4.0),
                     method("sure & slow", 20.0, rate(0.0, 0.0, 30.0), 2.0, True)],
         "measurements": [measurement("fast", "edge", 5), measurement("sure & slow", "edge", 0),
                          measurement("fast", "vertex", 0)]}]}


class Balance(HTMLParser):
    """Whether every element that is opened is closed, in order."""

    def __init__(self):
        super().__init__()
        self.open = []

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, (tag, self.open)
        self.open.pop()


class Page(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        (self.folder / "pictures").mkdir()
        (self.folder / "pictures/wrong.png").write_bytes(PNG)
        self.html = to_html(REPORT, self.folder)

    def test_every_element_is_closed(self):
        balance = Balance()
        balance.feed(self.html)
        self.assertEqual(balance.open, [])

    def test_texts_are_escaped(self):
        self.assertIn("a &lt;wedge&gt; &amp; more", self.html)
        self.assertNotIn("<wedge>", self.html)
        self.assertNotRegex(self.html, r"&(?!amp;|lt;|gt;|quot;|#)")

    def test_it_needs_no_other_file(self):
        self.assertNotIn("http", self.html)
        self.assertNotIn("<script", self.html)
        self.assertEqual(re.findall(r"src='(?!data:)", self.html), [])
        self.assertIn(f"src='data:image/png;base64,{base64.b64encode(PNG).decode()}'", self.html)

    def test_what_changes_only_the_speed_comes_last_and_has_no_plot(self):
        self.assertLess(self.html.index("<h2 id='triangle'>"), self.html.index("<h2 id='speed-only'>"))
        self.assertEqual(self.html.count("<svg"), 2)  # faults and error of the triangle

    def test_every_measurement_has_a_row_and_families_have_a_heading(self):
        self.assertEqual(self.html.count("12 to 13</td>"), 4)
        self.assertEqual(self.html.count("<tr class='family'>"), 3)
        self.assertIn("<td class='bad'>5000 (0 to 3000)</td><td>5 of 1000</td>", self.html)
        self.assertIn("<td class='good'>0 (&lt;3000)</td><td>0 of 1000</td>", self.html)
        self.assertIn("<td>0.5</td><td>3.25</td><td>40</td>", self.html)
        self.assertIn("at outlines 2", self.html)

    def test_advice_names_the_methods_or_says_that_there_is_none(self):
        self.assertIn("sure &amp; slow; other", self.html)
        self.assertIn("<em>none of these</em>", self.html)

    def test_a_report_without_anything_is_a_page(self):
        empty = {**REPORT, "advice": [], "trade_offs": []}
        self.assertIn("The mesh is closed.", to_html(empty, self.folder))

    def test_a_plot_whose_methods_are_all_alike_is_left_out(self):
        alike = copy.deepcopy(REPORT)
        for one in alike["trade_offs"][1]["methods"]:
            one["faults"] = rate(0.0, 0.0, 30.0)
            one["error"] = 1.0
        self.assertNotIn("<svg", to_html(alike, self.folder))


class Rates(unittest.TestCase):
    def test_no_fault_has_its_upper_bound_rounded_up(self):
        self.assertEqual(rate_words(rate(0.0, 0.0, 183.1)), "0 (<184)")
        self.assertEqual(rate_words(rate(101637.4, 101045.0, 102231.6)), "101637 (101045 to 102232)")


class Plot(unittest.TestCase):
    def test_a_mark_and_a_label_for_each_method(self):
        svg = to_svg("a < b", "x", "y", [Mark("first & best", "hint", (1, 1, 1), (10, 9, 11)),
                                         Mark("bound", "", (2, 2, 2), (0, 0, 5), dominated=True)])
        self.assertIn("a &lt; b", svg)
        self.assertIn("first &amp; best", svg)
        self.assertEqual(svg.count("<circle"), 1)
        self.assertEqual(svg.count("<path"), 1)  # an upper bound
        self.assertEqual(svg.count("<g class='dominated'>"), 1)
        self.assertNotIn("nan", svg)
        self.assertEqual(to_svg("", "x", "y", []), "")

    def test_greater_is_farther_along_an_axis_and_its_ends_are_kept(self):
        axis = Axis(10, 1000, 0, 100)
        places = [axis.at(value) for value in (1, 10, 100, 1000, 1e6)]
        self.assertEqual(places, sorted(places))
        self.assertAlmostEqual(axis.at(100), 50)
        self.assertEqual((places[0], places[-1]), (0, 100))
        self.assertEqual([round(tick) for tick in axis.ticks()],
                         [10, 20, 50, 100, 200, 500, 1000])
        self.assertTrue(Axis(5, 5, 0, 1).ticks())  # of one value alone

    def test_no_label_lies_over_another(self):
        heights = label_heights([100.0, 101.0, 99.0, BOTTOM, BOTTOM, TOP])
        for a, b in zip(sorted(heights), sorted(heights)[1:]):
            self.assertGreaterEqual(b - a, LABEL_HEIGHT - 1e-9)
        self.assertLess(heights[2], heights[0])
        self.assertLess(heights[0], heights[1])


class Program(unittest.TestCase):
    def run_on(self, path):
        return subprocess.run([sys.executable, "-B", SCRIPTS / "accuracy_page", path],
                              capture_output=True, text=True, check=False)

    def test_it_writes_the_page_beside_the_numbers(self):
        with tempfile.TemporaryDirectory() as scratch:
            numbers = Path(scratch) / "accuracy.json"
            numbers.write_text(json.dumps({**REPORT, "trade_offs": REPORT["trade_offs"][:1]}))
            self.assertEqual(self.run_on(numbers).returncode, 0)
            self.assertIn("<h1>", (Path(scratch) / "accuracy.html").read_text())

    def test_what_is_no_report_is_refused_in_a_sentence(self):
        with tempfile.TemporaryDirectory() as scratch:
            numbers = Path(scratch) / "accuracy.json"
            missing = self.run_on(numbers)
            self.assertEqual(missing.returncode, 2)
            self.assertIn("accuracy.json: No such file", missing.stderr)
            for text in ("{}", "[]", "nonsense"):
                numbers.write_text(text)
                refused = self.run_on(numbers)
                self.assertEqual(refused.returncode, 2)
                self.assertIn("is not what ./run.sh 08 writes", refused.stderr)
                self.assertNotIn("Traceback", refused.stderr)


if __name__ == "__main__":
    unittest.main()
