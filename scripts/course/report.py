"""What a check found, in words and as JSON."""

import math
import os

from .check import FAILED, MISSING, NOT_STARTED, PASSED, PICTURE_WAITS, RAY_BY_RAY
from .exercises import from_bits, ray_text
from .view import wrong_ray

RAY = {"origin": (0, 1, 2), "direction": (3, 4, 5), "t_min": (6,), "t_max": (7,)}
MOST_BOXES = 4  # more are not printed

# The rays of a picture come as two texels each (shaders/core/texels.glsl).
TEXELS = {1: ("origin x", "origin y", "origin z", "t_min"),
          2: ("direction x", "direction y", "direction z", "t_max")}


def number(value):
    """Nine digits give a number of single precision back, bit for bit."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def _for_json(value):
    """JSON has no infinity and no NaN: those are words."""
    is_none = isinstance(value, float) and not math.isfinite(value)
    return number(value) if is_none else value


def replay(result):
    """The command that asks this ray alone; empty where there is none."""
    if not result.wrong:
        return ""
    again = f"./course check {result.exercise.number}"
    if result.checkpoint.question["kind"] in RAY_BY_RAY:
        return f"{again} --ray={ray_text(result.wrong.ray)}"
    return again if result.state != FAILED else ""


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
    if result.no_picture:
        found["no_picture"] = result.no_picture
    if result.outside:
        found["outside"] = result.outside
    return found


def _line(name, text):
    return f"  {name:<11} {text}"


def _box_lines(wrong, question):
    """The boxes that a builder was given: each, where they are few."""
    boxes = wrong.asked[:question.get("numbers", {}).get("least", 2) + wrong.step - 1]
    if len(boxes) > MOST_BOXES:
        return [_line("boxes", f"the first {len(boxes)} of {len(wrong.asked)} made at random")]
    corners = [[", ".join(number(from_bits(word)) for word in words)
                for words in (box[0:3], box[3:6])] for box in boxes]
    return [_line(f"box {place}", f"from ({lower}) to ({upper})")
            for place, (lower, upper) in enumerate(corners, 1)]


def _asked_lines(wrong, checkpoint):
    """What was asked: a ray, or what its numbers stand for; a pixel; or boxes."""
    question = checkpoint.question
    if question["kind"] == "builder":
        return _box_lines(wrong, question)
    if question["kind"] == "rays":
        width, height = question.get("width", 64), question.get("height", 48)
        return [_line("ray", f"of column {wrong.index % width}, row {wrong.index // width} from "
                             f"below, in a picture of {width} x {height} pixels of {question['scene']}")]
    lines = [_line("step", wrong.step)] if question.get("steps", 1) > 1 else []
    for name, places in (checkpoint.given or RAY).items():
        words = [wrong.ray[place] for place in places]
        decimal = ", ".join(number(from_bits(word)) for word in words)
        bits = " ".join(f"{word:08x}" for word in words)
        lines.append(_line(name, f"{decimal}   (hex {bits})"))
    return lines


def _checkpoint_line(result):
    what = "the first one that is wrong" if result.state == FAILED else f"{result.state} here"
    return _line("checkpoint", f"{result.checkpoint.name}: {what}")


def _wrong_lines(result):
    wrong, checkpoint = result.wrong, result.checkpoint
    lines = [_checkpoint_line(result), *_asked_lines(wrong, checkpoint)]
    if checkpoint.where:
        lines.append(_line("where", checkpoint.where))
    names = [value["name"] for value in wrong.values]
    if checkpoint.question["kind"] == "rays" and wrong.values:
        names = TEXELS[wrong.step]
    for name, value in zip(names, wrong.values):
        mark = "" if value["right"] else "  <-- wrong"
        lines.append(_line(name, f"expected {number(value['expected'])}, "
                                 f"got {number(value['got'])}{mark}"))
    if wrong.because:
        lines.append(_line("known", wrong.because))
    return lines


def _picture_lines(pictures):
    yours, reference, compared = (os.path.relpath(pictures[name])
                                  for name in ("yours", "reference", "compared"))
    if "first_wrong_pixel" not in pictures:
        return [_line("picture", f"{yours} is right in every pixel")]
    column, row = pictures["first_wrong_pixel"]
    return [_line("pictures", yours), _line("", reference),
            _line("", f"{compared} (both, and their difference)"),
            _line("pixel", f"column {column}, row {row} from above is the first of "
                           f"{pictures['wrong_pixels']} that are wrong in the picture")]


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
        lines.append(_line("right", ", ".join(result.right)))
    if result.wrong:
        lines += _wrong_lines(result)
    elif result.checkpoint and result.state != FAILED:
        lines.append(_checkpoint_line(result))
    if result.outside and result.state not in (PASSED, NOT_STARTED):
        lines.append(_line("outside", f"{result.outside}. Put them back, unless they are functions of "
                                      "your own."))
    if result.pictures and result.state != PASSED:
        lines += _picture_lines(result.pictures)
    if result.no_picture:
        lines.append(_line("picture", f"none: {result.no_picture.splitlines()[0]}"))
    if replay(result):
        lines.append(_line("replay", replay(result)))
    if wrong_ray(result) or result.no_picture == PICTURE_WAITS:
        lines.append(_line("view", f"./course view {exercise.number}"))
    return "\n".join(lines)


def summary(results):
    """`3 passed, 1 failed, 2 not started`"""
    counts = {}
    for result in results:
        counts[result.state] = counts.get(result.state, 0) + 1
    order = sorted(counts, key=lambda state: (state != PASSED, state != FAILED, state))
    return ", ".join(f"{counts[state]} {state}" for state in order)
