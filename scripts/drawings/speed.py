"""One number that grows through the lessons: million primary rays of the bunny per second, as bars.

Each lesson that earns a number says it in a sentence; the drawings of this and of all later lessons read it there."""

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
    ("10", "four rays at once", "good"),
)
TICKS = ("0.001", "0.01", "0.1", "1", "10")
LEFT, RIGHT, TOP, STEP, BAR = 196, 470, 44, 40, 28
HEIGHT = TOP + STEP * len(WAYS) + 56


def up_to(chapter):
    return [way for way in WAYS if way[0] <= chapter]


def alt(chapter):
    names = ", ".join(f"{name} (chapter {number})" for number, name, _ in up_to(chapter))
    return (
        "Bars on a logarithmic axis: how many million rays of the bunny one processor core traces in a second, "
        f"up to this chapter, by {names}; the rows of later chapters are empty"
    )


def said(chapter):
    """What a lesson says that its rays make, as it is written."""
    (lesson,) = ROOT.glob(f"chapters/{chapter}_*/README.md")
    for number, words in SAID.findall(lesson.read_text(encoding="utf-8")):
        if number == chapter:
            return words
    raise LessonError(
        f"{lesson}: does not say: **The number of chapter {chapter}: ... million rays per second**"
    )


def draw_up_to(chapter, canvas, lesson):
    least, most = (math.log10(float(tick)) for tick in (TICKS[0], TICKS[-1]))

    def at(words):
        return LEFT + (math.log10(float(words)) - least) / (most - least) * (RIGHT - LEFT)

    lesson.cells += [*TICKS, *(number for number, _, _ in WAYS)]  # what the axis and the rows are called
    bottom = TOP + STEP * len(WAYS)
    for tick in TICKS:
        canvas.line((at(tick), TOP - 8), (at(tick), bottom), color="rule", width="thin")
        canvas.text((at(tick), bottom), tick, "s", color="quiet", gap=6)
    canvas.text((14, 18), "million rays per second", "e", gap=0, color="quiet")
    for row, (number, name, color) in enumerate(WAYS):
        y = TOP + STEP * row
        if number > chapter:
            canvas.text((14, y + BAR / 2), number, "e", gap=0, color="quiet")
            continue
        value = said(number)
        lesson.cells.append(value)
        canvas.text((14, y + BAR / 2), f"{number} {name}", "e", gap=0, color=color)
        canvas.box(LEFT, y, at(value) - LEFT, BAR, color=color, filled=True)
        canvas.text((at(value), y + BAR / 2), value, "e", color=color, gap=8)
