"""Grades a folder of submissions: one at a time, or one command each for many machines."""

import csv
import json
import shlex
import tempfile
from pathlib import Path

from . import hunt, report, submission
from .check import PASSED, Result, check
from .errors import CourseError, MachineError
from .exercises import ROOT

UNREADABLE, UNKNOWN = "unreadable", "not graded"


def grade_one(engine, path, exercises, class_seed=None, student=None):
    """{submission, score, of, remarks, exercises: {number: state}, details}. Whatever was handed in,
    there is a grade: what cannot be read has the score 0, and says why. With the seed of a class, each
    student has to hunt what it gives; the student's name is the submission's, if no other is told."""
    name = student or submission.name_of(path)
    seed = None if class_seed is None else hunt.seed_of(name, class_seed)
    grade = {"submission": name, "score": 0, "of": len(exercises), "remarks": []}
    with tempfile.TemporaryDirectory(prefix="raysteps_grade_") as unpacked:
        folder = Path(unpacked)
        try:
            grade["remarks"] = submission.unpack(path, folder, exercises)
            results = [_check_one(engine, exercise, folder, seed) for exercise in exercises]
        except CourseError as error:
            grade["remarks"] = [str(error)]
            results = [Result(exercise, UNREADABLE, str(error)) for exercise in exercises]
    grade["score"] = sum(result.state == PASSED for result in results)
    grade["exercises"] = {result.exercise.number: result.state for result in results}
    grade["details"] = [report.as_json(result) for result in results]
    return grade


def _check_one(engine, exercise, folder, seed):
    """Whatever goes wrong with one answer is told at that answer."""
    try:
        return check(engine, exercise, folder, seed=seed)
    except MachineError as error:
        return Result(exercise, UNKNOWN, str(error))
    except Exception as error:  # not one of ours: the others' rows must come all the same
        return Result(exercise, UNKNOWN, f"{exercise.file}: cannot be checked ({error!r}).")


def cell(text):
    """What begins like a formula must not become one in a spreadsheet."""
    return "'" + text if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text


def write_csv(path, grades):
    numbers = list(grades[0]["exercises"]) if grades else []
    with open(path, "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["submission", "score", "of", *numbers, "remarks"])
        for grade in grades:
            states = [grade["exercises"].get(number, "") for number in numbers]
            table.writerow([cell(grade["submission"]), grade["score"], grade["of"], *states,
                            cell(" ".join(grade.get("remarks", [])))])


def write_json(path, grades):
    Path(path).write_text(json.dumps({"grades": grades}, indent=1) + "\n")


def write_jobs(path, folder, results, settings, more):
    """A line of shell for each submission, which any machine with this folder can run. `settings`
    are options that stand before the command, `more` those behind it."""
    lines = []
    for one in submission.list_submissions(folder):
        target = results.resolve() / (submission.name_of(one) + ".json")
        words = [ROOT / "course", *settings, "grade", "--one", one.resolve(), "--json", target]
        words += more
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
