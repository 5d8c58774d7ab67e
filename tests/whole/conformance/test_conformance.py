"""The conformance suite: its files, its judge, and what becomes of engines that are wrong."""

import hashlib
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SUITE = ROOT / "docs/conformance/suite"
BAD = Path(__file__).with_name("bad_engine.py")
OWN, HARD_CASES = os.environ["RAYSTEPS_OWN_ENGINE"], os.environ["RAYSTEPS_HARD_CASES"]

sys.path[:0] = [str(ROOT / "scripts/conformance"), str(ROOT / "scripts/shrink")]

from judge import bounds  # noqa: E402
from suite import read_rays, read_triangles  # noqa: E402

# What an engine does, how its run ends then, and how its answers are wrong.
BAD_ENGINES = {
    "right": ("done", {}),
    "leak": ("done", {"missed": 1}),
    "other": ("done", {"other triangle": 1}),
    "late": ("done", {"wrong t": 1}),
    "nan": ("done", {"wrong t": 1}),
    "weights": ("done", {"wrong u, v": 1}),
    "nowhere": ("done", {"no such triangle": 1}),
    "few": ("too few hits", {"no answer": 3}),
    "garbage": ("garbage", {"no answer": 1}),
    "exit": ("exit 3", {}),
    "silent": ("no hits", {"no answer": 500}),
    "crash": ("crash", {"no answer": 500}),
    "memory": ("exit 1", {"no answer": 500}),
    "hang": ("timeout", {"no answer": 500}),
}


class ConformanceTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="raysteps_test_conformance_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_suite(self, command, *options):
        """The exit code, what was said, and the figures."""
        figures = self.folder / "figures.json"
        run = subprocess.run(["bash", ROOT / "run.sh", "conformance", "--command", command, "--out", self.folder,
                              "--json", figures, *options], capture_output=True, text=True, timeout=200, check=False)
        self.assertIn(run.returncode, (0, 1), run.stderr)
        return run.returncode, run.stdout, json.loads(figures.read_text())

    def bad(self, how):
        return f"{sys.executable} {BAD} {how} {SUITE / 'edges.answers'} %h"

    def test_our_walks_are_right_in_every_family(self):
        for walk in ("bvh_ordered", "kd_ropes"):
            code, said, figures = self.run_suite(f"{OWN} cpp {walk} %t %r %h")
            with self.subTest(walk):
                self.assertEqual((code, figures["wrong"]), (0, 0), said)
                self.assertGreater(len(figures["families"]), 20)
                self.assertEqual({row["ended"] for row in figures["families"]}, {"done"})

    def test_a_test_that_leaks_is_caught_where_it_leaks_and_not_elsewhere(self):
        code, said, figures = self.run_suite(f"{OWN} cpp test:moeller_trumbore %t %r %h",
                                             "--families", "random,edges,corners")
        rows = {row["family"]: row for row in figures["families"]}
        self.assertEqual((code, rows["random"]["wrong"]), (1, 0), said)
        for family in ("edges", "corners"):
            self.assertGreater(rows[family]["wrong_by_kind"]["missed"], 10)
        first = rows["edges"]["first_wrong"]
        self.assertIn(f"--ray-number {first['ray']}\n", said)

    def test_every_bad_engine_gets_its_row(self):
        for how, (ended, wrong) in BAD_ENGINES.items():
            with self.subTest(how):
                code, said, figures = self.run_suite(self.bad(how), "--families", "edges",
                                                     "--seconds", "3" if how == "hang" else "60", "--memory", "1")
                row = figures["families"][0]
                self.assertEqual((row["ended"], row["wrong_by_kind"]), (ended, wrong), said)
                self.assertEqual(code, 0 if how == "right" else 1)
                if wrong and ended == "done":
                    self.assertEqual(row["first_wrong"]["ray"], 7)

    def test_a_run_that_was_stopped_goes_on(self):
        command = self.bad("right")
        _, _, figures = self.run_suite(command, "--families", "edges", "--name", "mine")
        digest = hashlib.sha256(b"".join((SUITE / f"edges.{ending}").read_bytes()
                                         for ending in ("obj", "f32", "answers"))).hexdigest()
        row = {**figures["families"][0], "seconds": 123.0}
        (self.folder / "mine.state.json").write_text(json.dumps({"key": [command, digest], "rows": [row]}))
        _, said, figures = self.run_suite(command, "--families", "edges", "--name", "mine")
        self.assertIn("goes on after 1 families", said)
        self.assertEqual(figures["families"][0]["seconds"], 123.0)
        self.assertFalse((self.folder / "mine.state.json").exists())

    def test_what_cannot_be_run_is_one_sentence(self):
        for options, sentence in ((["--families", "egdes"], "there is no such family"),
                                  (["--suite", self.folder], "there is no suite in this folder")):
            run = subprocess.run(["bash", ROOT / "run.sh", "conformance", "--command", "x", *options],
                                 capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 2)
            self.assertRegex(run.stderr, rf"^conformance: .*{sentence}.*\n$")

    def test_the_small_suite_is_what_the_program_writes(self):
        subprocess.run([HARD_CASES, "--suite", self.folder / "suite"], check=True, capture_output=True)
        for path in (self.folder / "suite").iterdir():
            with self.subTest(path.name):
                self.assertEqual(path.read_bytes(), (SUITE / path.name).read_bytes())
        self.assertLess(sum(path.stat().st_size for path in SUITE.iterdir()), 2e6)

    def test_models_and_rays_have_as_many_records_as_the_list_says(self):
        for family in json.loads((SUITE / "suite.json").read_text())["families"]:
            with self.subTest(family["name"]):
                self.assertEqual(len(read_triangles(SUITE / f"{family['name']}.obj")), family["triangles"])
                self.assertEqual(len(list(read_rays(SUITE / f"{family['name']}.f32"))), family["rays"])

    def test_rates_have_their_bounds(self):
        self.assertEqual(bounds(0, 1000), (0.0, 3000.0))
        low, high = bounds(10, 1000)  # Wilson: (0.01 + 0.00192) / 1.00384 -+ 0.00644
        self.assertAlmostEqual(low, 5443, delta=5)
        self.assertAlmostEqual(high, 18314, delta=5)

    def test_the_figures_are_what_their_schema_says(self):
        try:
            import jsonschema  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("python3-jsonschema is not installed")
        _, _, figures = self.run_suite(self.bad("leak"), "--families", "edges")
        schema = json.loads((ROOT / "scripts/conformance/conformance.schema.json").read_text())
        schema["properties"]["head"] = json.loads((ROOT / "common/program/head.schema.json").read_text())
        jsonschema.Draft202012Validator(schema).validate(figures)
        with self.assertRaises(jsonschema.ValidationError):
            jsonschema.Draft202012Validator(schema).validate({**figures, "surprise": 1})

    def test_a_report_says_whether_an_engine_has_its_fault(self):
        reports = sorted((ROOT / "docs/conformance/reports").glob("*.py"))
        self.assertGreaterEqual(len(reports), 3)
        for report in reports:
            for engine, code in ((f"{OWN} cpp bvh_ordered %t %r %h", 0), (f"{sys.executable} {BAD} none {self.wrong_for(report)} %h", 1)):
                with self.subTest(report=report.name, engine=engine):
                    run = subprocess.run([sys.executable, "-B", report, engine], capture_output=True, text=True, check=False)
                    self.assertEqual(run.returncode, code, run.stdout + run.stderr)

    def wrong_for(self, report):
        """A file of answers by which an engine misses where the report says a hit, and hits where it says a miss."""
        is_miss = "RIGHT = -1" in report.read_text()
        answers = self.folder / "one.answers"
        answers.write_bytes(struct.pack("<HHiff", 0, 1, 0, 1.0, 1.0) if is_miss else struct.pack("<HH", 1, 0))
        return answers

    def test_the_readers_of_the_readme_read_the_suite(self):
        """A stranger begins with this text."""
        text = (ROOT / "docs/conformance/README.md").read_text()
        reader = re.search(r"```python\n(# read_suite.py.*?)```", text, re.S)[1]
        shutil.copytree(SUITE, self.folder / "suite")
        (self.folder / "read_suite.py").write_text(reader)
        run = subprocess.run([sys.executable, "read_suite.py", "suite/edges"], cwd=self.folder, capture_output=True,
                             text=True, check=True)
        self.assertEqual(run.stdout, re.search(r"```\n(1520 triangles.*?)```", text, re.S)[1])


if __name__ == "__main__":
    unittest.main()
