"""What a teacher reads of many grades: which checkpoints a class fails, and how; and what Gradescope reads."""

import csv
import json
from pathlib import Path

from .check import FAILED, MISSING, NOT_STARTED, PASSED
from .grade import UNKNOWN, UNREADABLE, cell
from .report import number

MOST_LINES = 20  # of the table on a terminal
NO_FAULT = (PASSED, NOT_STARTED, MISSING, UNREADABLE, UNKNOWN)


def row(grade):
    remarks = "".join(f"\n  {_printable(remark)}" for remark in grade.get("remarks", []))
    return f"{grade['submission']}: {grade['score']} of {grade['of']}{remarks}"


def _difference(value):
    return f"{value['name']}: expected {number(value['expected'])}, got {number(value['got'])}"


def _how(detail):
    """In a few words: the same for those who wrote the same mistake."""
    wrong = next((value for value in detail.get("values", []) if not value["right"]), None)
    if wrong:
        return _difference(wrong)
    if detail.get("message"):
        return f"{detail['state']}: {detail['message'].splitlines()[0]}"
    pixels = detail.get("pictures", {}).get("wrong_pixels")
    return f"{pixels} wrong pixels" if pixels else detail["state"]


def faults(grades):
    """A row for each way in which exercises fail: {exercise, title, checkpoint, how, students, who}, by
    exercise, and what most of the class does first."""
    found = {}
    for grade in grades:
        for detail in grade["details"]:
            if detail["state"] not in NO_FAULT:
                checkpoint = detail.get("checkpoint", "")
                place = (detail["exercise"], detail["title"], checkpoint, _how(detail))
                found.setdefault(place, []).append(grade["submission"])
    rows = [{"exercise": exercise, "title": title, "checkpoint": checkpoint, "how": how,
             "students": len(who), "who": ", ".join(who)}
            for (exercise, title, checkpoint, how), who in found.items()]
    return sorted(rows, key=lambda one: ([int(part) for part in one["exercise"].split(".")], -one["students"],
                                         one["checkpoint"], one["how"]))


def write_faults(path, rows):
    with open(path, "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["exercise", "title", "checkpoint", "how", "students", "who"])
        for one in rows:
            table.writerow([cell(str(word)) for word in one.values()])


def faults_text(rows):
    """The most frequent ones, for a terminal."""
    often = sorted(rows, key=lambda one: -one["students"])[:MOST_LINES]
    lines = [f"{one['students']:>8}  {one['exercise']:<8}  {one['checkpoint'] or '-'}: {_printable(one['how'])[:120]}"
             for one in often]
    rest = len(rows) - len(often)
    lines += [f"and {rest} more: --faults writes all of them to a file"] if rest else []
    return "\n".join(["students  exercise  what they fail", *lines])


def _printable(text):
    return "".join(letter if letter.isprintable() else "?" for letter in text)


def _told(detail):
    """What a student reads there."""
    lines = [f"state: {detail['state']}"]
    lines += [f"right: {', '.join(detail['right'])}"] if detail["right"] else []
    lines += [f"{name}: {detail[name]}" for name in ("message", "checkpoint", "step", "outside") if name in detail]
    lines += [_difference(value) for value in detail.get("values", [])]
    lines += [f"replay: {detail['replay']}"] if "replay" in detail else []
    return "\n".join(lines)


def write_gradescope(path, grade):
    """results.json, as Gradescope documents it: a test for each exercise."""
    tests = [{"name": f"{detail['exercise']} {detail['title']}", "number": detail["exercise"],
              "score": int(detail["state"] == PASSED), "max_score": 1,
              "status": "passed" if detail["state"] == PASSED else FAILED, "output": _told(detail),
              "output_format": "text", "visibility": "visible"} for detail in grade["details"]]
    remarks = "\n".join(grade.get("remarks", []))
    Path(path).write_text(json.dumps({"score": grade["score"], "output": remarks or "Checked by ./course grade.",
                                      "output_format": "text", "tests": tests}, indent=1) + "\n")
