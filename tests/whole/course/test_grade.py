"""Packing, grading, and joining what many machines graded."""

import csv
import json
import shutil
import subprocess
import zipfile
import unittest

from support import HOW, CourseTest


CROSS = "shaders/core/vector.glsl"


def read_table(path):
    with open(path, newline="") as file:
        return list(csv.reader(file))


class Grade(CourseTest):
    def setUp(self):
        super().setUp()
        self.start()
        self.handed_in = self.folder / "handed in"
        self.solve("2.1")
        self.course("pack", "--student", "alice", "--out", self.handed_in)
        self.solve("2.1", "    real x = a.y;\n    real y = a.z;\n    real z = a.x;")
        self.course("pack", "--student", "bob", "--out", self.handed_in)
        (self.handed_in / "carol.zip").write_text("no archive")

    def test_whatever_lies_there_has_a_row(self):
        for name, size in (("dora.rar", 7), ("emil.7z", 0), ("fritz.cpp", 5)):
            (self.handed_in / name).write_bytes(b"x" * size)
        (self.handed_in / "alice.zip").rename(self.handed_in / "alice.ZIP")
        shutil.copyfile(self.handed_in / "alice.ZIP", self.handed_in / "bob.tar")
        (self.handed_in / "gone").symlink_to("nowhere")
        with zipfile.ZipFile(self.handed_in / "=deep\n.zip", "w") as packed:
            packed.write(self.workbook / CROSS, f"a/b/c/{CROSS}")
            packed.write(self.workbook / CROSS, "notes.txt")
        table = self.folder / "grades.csv"
        self.course("grade", self.handed_in, "--only", "2.1", "--csv", table, *HOW)
        found = {row[0]: (row[3], row[4]) for row in read_table(table)[1:]}
        self.assertEqual({name: state for name, (state, _) in found.items()},
                         {"'=deep\\n'": "failed", "alice": "passed", "bob.zip": "failed",
                          "bob.tar": "unreadable", "carol": "unreadable", "dora.rar": "unreadable",
                          "emil.7z": "unreadable", "fritz.cpp": "unreadable", "gone": "unreadable"})
        self.assertIn(f"{CROSS} was found as a/b/c/{CROSS}", found["'=deep\\n'"][1])
        self.assertIn("is no folder and no zip or tar file", found["dora.rar"][1])

    def scores(self, path):
        return {grade["submission"]: grade["score"]
                for grade in json.loads(path.read_text())["grades"]}

    def test_a_folder_is_graded_into_csv_and_json(self):
        table, found = self.folder / "grades.csv", self.folder / "grades.json"
        faults = self.folder / "faults.csv"
        self.course("grade", self.handed_in, "--only", "2.1", "--csv", table, "--json", found, "--faults",
                    faults, *HOW)
        self.assertEqual([row[:4] for row in read_table(table)],
                         [["submission", "score", "of", "2.1"], ["alice", "1", "1", "passed"],
                          ["bob", "0", "1", "failed"], ["carol", "0", "1", "unreadable"]])
        self.assertIn("carol: cannot be unpacked", read_table(table)[3][4])
        self.assertEqual(self.scores(found), {"alice": 1, "bob": 0, "carol": 0})
        self.assertEqual(read_table(faults)[1:], [["2.1", "The cross product", "components",
                                                   "x: expected -3, got 2", "1", "bob"]])

    def test_one_submission_is_written_as_gradescope_reads_it(self):
        found = self.folder / "results.json"
        self.course("grade", "--one", self.handed_in / "bob.zip", "--only", "2.1", "--gradescope", found, *HOW)
        results = json.loads(found.read_text())
        test, = results["tests"]
        self.assertEqual((results["score"], test["score"], test["max_score"], test["status"], test["number"]),
                         (0, 0, 1, "failed", "2.1"))
        self.assertIn("x: expected -3", test["output"])
        self.assertIn("--one", self.course("grade", self.handed_in, "--gradescope", found, expect=2))

    def test_the_lines_of_a_jobs_file_run_by_themselves_and_their_results_join(self):
        jobs, results = self.folder / "jobs", self.folder / "results"
        self.course("grade", self.handed_in, "--only", "2.1", "--jobs-file", jobs, "--results",
                    results, *HOW)
        lines = jobs.read_text().splitlines()
        self.assertEqual(len(lines), 3)
        for line in lines:
            subprocess.run(["/bin/sh", "-c", line], check=True, capture_output=True, cwd="/")
        joined = self.folder / "joined.json"
        self.course("grade", "--merge", *sorted(results.glob("*.json")), "--json", joined)
        self.assertEqual(self.scores(joined), {"alice": 1, "bob": 0, "carol": 0})

    def test_wrong_usage_says_what_to_name(self):
        self.assertIn("there is no such folder", self.course("grade", "nowhere", expect=2))
        self.assertIn("name a folder of submissions", self.course("grade", expect=2))
        bad = self.folder / "bad.json"
        bad.write_text("{}")
        self.assertIn("is no result", self.course("grade", "--merge", bad, expect=2))
        self.assertIn("take letters", self.course("pack", "--student", "../x", expect=2))


if __name__ == "__main__":
    unittest.main()
