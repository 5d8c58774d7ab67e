"""Packing, grading, and joining what many machines graded."""

import csv
import json
import subprocess
import unittest

from support import CourseTest


class Grade(CourseTest):
    def setUp(self):
        super().setUp()
        self.course("start")
        self.handed_in = self.folder / "handed in"
        self.solve("2.1")
        self.course("pack", "--student", "alice", "--out", self.handed_in)
        self.solve("2.1", "    real x = a.y;\n    real y = a.z;\n    real z = a.x;")
        self.course("pack", "--student", "bob", "--out", self.handed_in)
        (self.handed_in / "carol.zip").write_text("no archive")

    def scores(self, path):
        return {grade["submission"]: grade["score"]
                for grade in json.loads(path.read_text())["grades"]}

    def test_a_folder_is_graded_into_csv_and_json(self):
        table, found = self.folder / "grades.csv", self.folder / "grades.json"
        self.course("grade", self.handed_in, "--only", "2.1", "--csv", table, "--json", found)
        with open(table, newline="") as file:
            self.assertEqual(list(csv.reader(file)), [["submission", "score", "of", "2.1"],
                                                      ["alice", "1", "1", "passed"],
                                                      ["bob", "0", "1", "failed"],
                                                      ["carol", "0", "1", "unreadable"]])
        self.assertEqual(self.scores(found), {"alice": 1, "bob": 0, "carol": 0})

    def test_the_lines_of_a_jobs_file_run_by_themselves_and_their_results_join(self):
        jobs, results = self.folder / "jobs", self.folder / "results"
        self.course("grade", self.handed_in, "--only", "2.1", "--jobs-file", jobs, "--results",
                    results)
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
