"""What a check found, in words and as JSON."""

import math
import os

from .check import FAILED, MISSING, NOT_STARTED, PASSED
from .exercises import from_bits, ray_text
from .view import wrong_ray

NAMES = ("origin", "direction", "t_min", "t_max")


def number(value):
    """Nine digits give a number of single precision back, bit for bit."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def _for_json(value):
    """JSON has no infinity and no number that is none: those are words."""
    is_none = isinstance(value, float) and not math.isfinite(value)
    return number(value) if is_none else value


def replay(result):
    """The command that asks this ray alone; empty where there is none."""
    is_ray = result.wrong and result.checkpoint.question["kind"] == "checkpoint"
    return (f"./course check {result.exercise.number} --ray={ray_text(result.wrong.ray)}"
            if is_ray else "")


def as_json(result):
    wrong = result.wrong
    found = {"exercise": result.exercise.number, "title": result.exercise.title,
             "file": result.exercise.file, "state": result.state, "right": result.right}
    if result.message:
        found["message"] = result.message
    if result.checkpoint:
        found["checkpoint"] = result.checkpoint.name
    if wrong:
        found["step"] = wrong.step
        found["values"] = [{**value, "expected": _for_json(value["expected"]),
                           "got": _for_json(value["got"])}
                           for value in wrong.values]
        if wrong.because:
            found["known_because"] = wrong.because
        if wrong.ray:
            found["ray"] = {"decimal": [_for_json(from_bits(word)) for word in wrong.ray],
                            "hex": [f"{word:08x}" for word in wrong.ray]}
    if replay(result):
        found["replay"] = replay(result)
    if result.pictures:
        found["pictures"] = result.pictures
    return found


def _ray_lines(wrong, question):
    if question["kind"] == "builder":
        least = question.get("numbers", {}).get("least", 2)
        return [f"  boxes      the first {wrong.step + least - 1}; the last wrong answer is for these"]
    if question["kind"] == "rays":
        width = question.get("width", 64)
        return [f"  pixel      column {wrong.index % width}, row {wrong.index // width} from below"]
    words = wrong.ray
    groups = (words[0:3], words[3:6], words[6:7], words[7:8])
    lines = []
    for name, group in zip(NAMES, groups):
        decimal = ", ".join(number(from_bits(word)) for word in group)
        bits = " ".join(f"{word:08x}" for word in group)
        lines.append(f"  {name:<10} {decimal}   (hex {bits})")
    return lines


def _wrong_lines(result):
    wrong, question = result.wrong, result.checkpoint.question
    lines = [f"  checkpoint {result.checkpoint.name}: the first one that is wrong"]
    if question.get("steps", 1) > 1:
        lines.append(f"  step       {wrong.step}")
    lines += _ray_lines(wrong, question)
    for value in wrong.values:
        mark = " " if value["right"] else "  <-- wrong"
        lines.append(f"  {value['name']:<10} expected {number(value['expected'])}, "
                     f"got {number(value['got'])}{mark.rstrip()}")
    if wrong.because:
        lines.append(f"  known      {wrong.because}")
    return lines


def as_text(result):
    """A few lines; one where all is well."""
    exercise = result.exercise
    lines = [f"{exercise.number} {exercise.title}: {result.state}"]
    if result.state == MISSING:
        lines.append(f"  {exercise.file} is not in the workbook. `./course start` makes it.")
    if result.state == NOT_STARTED:
        lines.append(f"  `./course show {exercise.number}` says what is to be done.")
    if result.message:
        lines += ["  " + line for line in result.message.splitlines()]
    if result.right and result.state != PASSED:
        lines.append(f"  right      {', '.join(result.right)}")
    if result.wrong:
        lines += _wrong_lines(result)
    pictures = result.pictures
    if pictures and result.state != PASSED:
        yours, reference, compared = (os.path.relpath(pictures[name])
                                      for name in ("yours", "reference", "compared"))
        lines += [f"  pictures   {yours}", f"             {reference}",
                  f"             {compared} (both, and their difference)"]
        if "first_wrong_pixel" in pictures:
            column, row = pictures["first_wrong_pixel"]
            lines.append(f"  pixel      column {column}, row {row} from above is the first of "
                         f"{pictures['wrong_pixels']} that are wrong")
    if replay(result):
        lines.append(f"  replay     {replay(result)}")
    if wrong_ray(result):
        lines.append(f"  view       ./course view {exercise.number}")
    return "\n".join(lines)


def summary(results):
    """`3 passed, 1 failed, 2 not started`"""
    counts = {}
    for result in results:
        counts[result.state] = counts.get(result.state, 0) + 1
    order = sorted(counts, key=lambda state: (state != PASSED, state != FAILED, state))
    return ", ".join(f"{counts[state]} {state}" for state in order)
