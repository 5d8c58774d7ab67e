"""A knot in a stadium: cells of one size, nearly all empty, and one that holds half of the knot."""

import math

ALT = (
    "A large stadium cut into equal cells; a tiny dense knot lies in two of them. One cell lists "
    "34,406 of the 67,688 triangles, nearly all others list none"
)
HEIGHT = 310
SENTENCES = [
    "One cell lists 34,406 of the 67,688 triangles, about half of the knot.",
]


def draw(canvas, _lesson):
    left, top, size, columns, rows = 22, 54, 38, 8, 6
    for x in range(columns + 1):
        canvas.line((left + x * size, top), (left + x * size, top + rows * size), color="rule")
    for y in range(rows + 1):
        canvas.line((left, top + y * size), (left + columns * size, top + y * size), color="rule")
    canvas.line(
        (left + 6, top + 70),
        (left + 6, top + rows * size - 6),
        (left + columns * size - 6, top + rows * size - 6),
        (left + columns * size - 6, top + 70),
        color="shape",
        width="thick",
    )
    x, y = left + 4 * size, top + 4.5 * size

    def knot(middle, radius, turns, color, width):
        points = [
            (
                middle[0] + radius * (math.cos(2 * a) * (1 + 0.5 * math.cos(3 * a))) / 1.5,
                middle[1] + radius * (math.sin(2 * a) * (1 + 0.5 * math.cos(3 * a))) / 1.5,
            )
            for a in (2 * math.pi * i / turns for i in range(turns))
        ]
        canvas.line(*points, color=color, closed=True, width=width)

    canvas.area(
        (x - size, y - size / 2), (x, y - size / 2), (x, y + size / 2), (x - size, y + size / 2), color="ray"
    )
    knot((x, y), 12, 60, "ray", "thin")
    middle, radius = (462, 178), 78
    canvas.line(
        (x + 4, y - 12), (middle[0] - 40, middle[1] - radius * 0.86), color="quiet", dashed=True, width="thin"
    )
    canvas.line(
        (x + 4, y + 12), (middle[0] - 40, middle[1] + radius * 0.86), color="quiet", dashed=True, width="thin"
    )
    canvas.circle(middle, radius, color="quiet", hole=True)
    canvas.area(
        (middle[0], middle[1] - radius + 8),
        (middle[0] - 50, middle[1] - 48),
        (middle[0] - 70, middle[1]),
        (middle[0] - 50, middle[1] + 48),
        (middle[0], middle[1] + radius - 8),
        color="ray",
        outlined=False,
    )
    knot(middle, 60, 90, "ray", "")
    canvas.line((middle[0], middle[1] - radius), (middle[0], middle[1] + radius), color="rule")
    canvas.text((462, 56), "this cell: 34,406", color="ray")
    canvas.text((462, 284), "in all: 67,688", color="quiet")
    canvas.text((left, 32), "nearly all others: none", "e", gap=0, color="quiet")
