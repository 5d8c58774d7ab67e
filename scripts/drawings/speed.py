"""One number that grows through the lessons: million primary rays of the bunny per second, as bars. Each lesson that earns a
number says it in a sentence, and the drawings of this and all later lessons read it there."""

import math
import re

from drawings.catalogue import ROOT
from drawings.lesson import LessonError

SAID = re.compile(r"\*\*The number of chapter (\d\d): ([\d.]+) million rays per second\*\*")
# Chapter, what its bar is called, its role in the palette.
WAYS = (
    ("02", "every triangle", "wrong"),
    ("04", "grid", "shape"),
    ("05", "kd-tree", "shape"),
    ("06", "BVH", "good"),
    ("07", "Embree", "quiet"),  # the yardstick of chapter 07: a processor's own ray tracer
)
LEAST, MOST = -3, 1  # powers of ten at both ends of the axis
LEFT, RIGHT, TOP, STEP = 196, 470, 44, 40


def up_to(chapter):
    return [way for way in WAYS if way[0] <= chapter]


def alt(chapter):
    names = ", ".join(f"{name} (chapter {number})" for number, name, _ in up_to(chapter))
    return (
        "Bars on a logarithmic axis: how many million rays of the bunny one processor core traces in a second, up to "
        f"this chapter, by {names}; the rows of later chapters are empty"
    )


def said(chapter):
    """What a lesson says that its rays make, as it is written."""
    (lesson,) = ROOT.glob(f"chapters/{chapter}_*/README.md")
    for number, words in SAID.findall(lesson.read_text(encoding="utf-8")):
        if number == chapter:
            return words
    raise LessonError(f"{lesson}: does not say: **The number of chapter {chapter}: ... million rays per second**")


HEIGHT = TOP + STEP * len(WAYS) + 56


def draw_up_to(chapter, canvas, lesson):
    def at(value):
        part = (math.log10(value) - LEAST) / (MOST - LEAST)
        return LEFT + part * (RIGHT - LEFT)

    bottom = TOP + STEP * len(WAYS)
    for power, words in ((-3, "0.001"), (-2, "0.01"), (-1, "0.1"), (0, "1"), (1, "10")):
        x = at(10.0**power)
        canvas.line((x, TOP - 8), (x, bottom), color="rule", width="thin")
        canvas.text((x, bottom), words, "s", color="quiet", gap=6)
    lesson.cells += ["0.001 0.01 0.1 1 10", *(number for number, _, _ in WAYS)]  # of the axis and of its rows
    shown = up_to(chapter)
    for row, (number, name, color) in enumerate(WAYS):
        y = TOP + STEP * row
        earned = (number, name, color) in shown
        canvas.text((14, y + 14), f"{number} {name}" if earned else number, "e", gap=0, color=color if earned else "quiet")
        if earned:
            value = said(number)
            lesson.cells.append(value)
            canvas.box(LEFT, y, at(float(value)) - LEFT, 28, color=color, filled=True)
            canvas.text((at(float(value)), y + 14), value, "e", color=color, gap=8)
    canvas.text((14, 18), "million rays per second", "e", gap=0, color="quiet")
