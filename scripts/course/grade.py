"""Grades a folder of submissions: one at a time, or one command each for many machines."""

import csv
import json
import shlex
import tempfile
from pathlib import Path

from . import report, submission
from .check import PASSED, Result, check
from .errors import CourseError
from .exercises import ROOT


def grade_one(engine, path, exercises):
    """{submission, score, of, exercises: {number: state}, details}. Whatever was handed in, there
    is a grade: what cannot be read has the score 0, and says why."""
    grade = {"submission": submission.name_of(path), "score": 0, "of": len(exercises)}
    with tempfile.TemporaryDirectory(prefix="raysteps_grade_") as name:
        folder = Path(name)
        try:
            submission.unpack(path, folder, exercises)
            results = [check(engine, exercise, folder) for exercise in exercises]
        except CourseError as error:
            if error.code != CourseError.code:
                raise
            results = [Result(exercise, "unreadable", str(error)) for exercise in exercises]
    grade["score"] = sum(result.state == PASSED for result in results)
    grade["exercises"] = {result.exercise.number: result.state for result in results}
    grade["details"] = [report.as_json(result) for result in results]
    return grade


def write_csv(path, grades):
    numbers = list(grades[0]["exercises"]) if grades else []
    with open(path, "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["submission", "score", "of", *numbers])
        for grade in grades:
            # A name that begins like a formula must not become one in a spreadsheet.
            name = grade["submission"]
            name = "'" + name if name[:1] in ("=", "+", "-", "@") else name
            states = [grade["exercises"].get(number, "") for number in numbers]
            table.writerow([name, grade["score"], grade["of"], *states])


def write_json(path, grades):
    Path(path).write_text(json.dumps({"grades": grades}, indent=1) + "\n")


def write_jobs(path, folder, results, wanted, settings):
    """A line of shell for each submission, which any machine with this folder can run. `settings`
    are options that stand before the command."""
    lines = []
    for one in submission.list_submissions(folder):
        target = results.resolve() / (submission.name_of(one) + ".json")
        words = [ROOT / "course", *settings, "grade", "--one", one.resolve(), "--json", target]
        words += ["--only", wanted] if wanted else []
        lines.append(f"cd {shlex.quote(str(ROOT))} && " + shlex.join(str(word) for word in words))
    results.mkdir(parents=True, exist_ok=True)
    Path(path).write_text("".join(line + "\n" for line in lines))
    return len(lines)


def merge(paths):
    """The grades of many files of --json, sorted by the submission's name."""
    grades = {}
    for path in paths:
        try:
            for grade in json.loads(Path(path).read_text())["grades"]:
                if grade["submission"] in grades:
                    raise CourseError(f"{path}: {grade['submission']} was graded before. Name each "
                                      "result once.")
                grades[grade["submission"]] = grade
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise CourseError(f"{path}: is no result of `./course grade --json` ({error}). Grade it "
                              "again.") from error
    return [grades[name] for name in sorted(grades)]
