"""What teachers get: plans, drawings in an archive; and the page for one afternoon."""

import re
import tomllib
import unittest
import zipfile
from pathlib import Path
from unittest import mock

from support import ROOT, FolderTest
from book import drawings_zip, plans
from book.contents import AFTERNOON, page_names
from book.links import Links
from course import exercises
from drawings.catalogue import descriptions, make

PLANS = tomllib.loads((ROOT / plans.PLANS).read_text())
COMMAND = re.compile(r"`\./run\.sh (\w+)")


class Plans(FolderTest):
    def lines(self, name):
        return plans.plan(name)(Links(ROOT, self.folder / "out", page_names(ROOT), self.folder / "made"), None)

    def test_a_term_has_every_exercise_once(self):
        asked = [number for row in PLANS["term"] for number in row["exercises"]]
        self.assertEqual(sorted(asked), sorted(exercise.number for exercise in exercises.load(ROOT)))

    def test_no_plan_asks_for_an_exercise_twice_or_before_its_chapter(self):
        for name, rows in PLANS.items():
            seen = []
            for row in rows:
                pages = {page[0][:2] for page in row["read"]}
                self.assertLessEqual({f"{int(number.split('.')[0]):02}" for number in row["exercises"]}, pages, f"{name} {row['when']}")
                seen += row["exercises"]
            self.assertEqual(len(seen), len(set(seen)), name)

    def test_what_is_read_adds_up_to_whole_pages(self):
        for name, rows in PLANS.items():
            parts = {}
            for page, *part in (entry for row in rows for entry in row["read"]):
                parts[page] = parts.get(page, 0) + (part[0] if part else 1)
            self.assertEqual(set(parts.values()), {1}, f"{name}: {parts}")

    def test_every_row_shows_a_command_or_a_drawing_in_class(self):
        known = {"view", *(path.name[:2] for path in ROOT.glob("chapters/[0-9]*"))}
        for rows in PLANS.values():
            for row in rows:
                self.assertLessEqual(set(COMMAND.findall(row["show"])), known)
                self.assertTrue(COMMAND.search(row["show"]) or "hapter" in row["show"], row["show"])

    def test_every_plan_is_listed_with_its_minutes(self):
        self.assertEqual(set(PLANS), set(plans.NAMES))
        for name, rows in PLANS.items():
            text = "\n".join(self.lines(name))
            self.assertEqual(len(re.findall(r"^-   \*\*.*: \d+ minutes\. .*: \d+ minutes\.<br>$", text, re.MULTILINE)),
                             len(rows), text)
        self.assertIn("Exercises 1.1, 1.2, 1.3: 60 minutes.", "\n".join(self.lines("weekend")))

    def test_words_are_counted_without_code_tables_and_sources(self):
        text = "# One two\n\nthree four [five](six.md)\n\n    seven\n\n| eight |\n\n## Sources\n\nnine\n\n## Ten\n"
        self.assertEqual(plans.words_in(text), 6)

    def test_half_a_page_takes_half_the_time(self):
        links = mock.Mock(root=self.folder, page_names={Path("docs/a.md"): "a.md"})
        self.write("docs/a.md", "# A\n\n" + "word " * 600)
        self.assertAlmostEqual(plans._reading(links, ["a", 0.5])[1] * 2, plans._reading(links, ["a"])[1])
        self.assertIn("1/2 of [A](a.md)", plans._reading(links, ["a", 0.5])[0])


class Archive(FolderTest):
    def test_it_has_each_drawing_and_the_licence_and_says_when_there_is_no_png(self):
        with mock.patch.object(drawings_zip, "has_browser", lambda: False):
            for _ in range(2):  # made, and kept
                self.assertEqual(drawings_zip.make_archive(ROOT, self.folder / "a.zip", self.folder / "made"), (len(descriptions(ROOT)), False))
            line = drawings_zip.drawings(mock.Mock(root=ROOT, out=self.folder, made=self.folder / "made"), None)[0]
        self.assertIn("without chromium", line)
        with zipfile.ZipFile(self.folder / "a.zip") as archive:
            self.assertEqual(archive.read("LICENSE"), (ROOT / "LICENSE").read_bytes())
            self.assertEqual(archive.read("svg/06_bvh_slabs.svg"),
                             (ROOT / "chapters/06_bvh/drawings/slabs.svg").read_bytes())
            self.assertEqual(len(archive.namelist()), 1 + len(descriptions(ROOT)))

    def test_one_that_is_kept_is_taken_until_a_drawing_changes(self):
        root, kept = self.folder / "root", self.folder / "made"
        (root / "chapters/06_bvh/drawings").mkdir(parents=True)
        (root / "LICENSE").write_text("MIT")
        (root / "chapters/06_bvh/drawings/a.py").write_text("")
        made = []
        for text in ("<svg/>", "<svg/>", "<svg></svg>"):
            (root / "chapters/06_bvh/drawings/a.svg").write_text(text)
            with mock.patch.object(drawings_zip, "has_browser", lambda: True), \
                    mock.patch.object(drawings_zip, "pictures_of", lambda drawings: made.append(drawings) or dict.fromkeys(drawings, b"png")):
                self.assertEqual(drawings_zip.make_archive(root, self.folder / "a.zip", kept), (1, True))
            with zipfile.ZipFile(self.folder / "a.zip") as archive:
                self.assertEqual(archive.read("svg/06_bvh_a.svg").decode(), text)
                self.assertEqual(archive.read("png/06_bvh_a.png"), b"png")
        self.assertEqual(len(made), 2)


class Afternoon(unittest.TestCase):
    def test_each_of_five_steps_has_a_drawing_code_a_picture_and_a_command(self):
        steps = re.split(r"^## (?=\d )", (ROOT / AFTERNOON).read_text(), flags=re.MULTILINE)[1:]
        self.assertEqual(len(steps), 5)
        for step in steps:
            for part in (r"drawings/\w+\.svg\)$", r"^<!-- code: ", r"^!\[.*\.png\)$", r"^    \./run\.sh "):
                self.assertRegex(step, re.compile(part, re.MULTILINE))

    def test_its_drawings_have_the_words_of_their_descriptions(self):
        shown = re.findall(r"!\[([^\]]*)\]\(\.\./\.\./(chapters/.*\.svg)\)", (ROOT / AFTERNOON).read_text())
        self.assertEqual(len(shown), 5)
        for words, path in shown:
            self.assertEqual(words, make((ROOT / path).with_suffix(".py")).alt)


if __name__ == "__main__":
    unittest.main()
