"""Cells visited, triangles tested and time, each against the resolution, all logarithmic."""

import math

from drawings.places import Flat

ALT = (
    "Against the cells along the longest side, from 8 to 256, with logarithmic axes: the cells "
    "that a ray visits rise in a straight line, the triangles that it tests fall, and the time has "
    "a flat valley between 32 and 96"
)
HEIGHT = 400
SENTENCES = [
    "It is flat: from 32 to 96 cells one hardly notices the choice",
]
HEADING = "| `--resolution` | 8 | 16 | 32 | 64 | 96 | 128 | 256 |"
ROWS = (
    ("cells visited a ray", "visits", "shape"),
    ("triangles tested a ray", "tests", "wrong"),
    ("time", "time", "ray"),
)


def draw(canvas, lesson):
    sizes = [int(cell) for cell in HEADING.replace("`--resolution`", "").split("|") if cell.strip()]
    lesson.cells += map(str, sizes)
    at = Flat(52 - 3 * 82, 332, 82, 34)

    def on(size, value):
        return at(math.log2(size), math.log2(value))

    canvas.area(on(32, 1), on(96, 1), on(96, 460), on(32, 460), color="quiet", outlined=False)
    for size in sizes:
        canvas.line(on(size, 1), on(size, 460), color="rule", width="thin")
        if size != 96:
            canvas.text(on(size, 1), str(size), "s", color="quiet", gap=8)
    canvas.line(on(8, 1), on(256, 1), color="quiet")
    for heading, name, color in ROWS:
        values = [float(cell) for cell in lesson.row(HEADING, heading)[1:]]
        points = [on(size, value) for size, value in zip(sizes, values)]
        canvas.line(*points, color=color, width="thick")
        for point in points:
            canvas.point(point, color=color)
        canvas.text(points[-1], name, "e" if name != "tests" else "se", color=color)
    canvas.text((262, 378), "cells along the longest side", color="quiet")
