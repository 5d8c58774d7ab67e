"""Time per ray against the number of triangles, both logarithmic: the slope of each line is k."""

import math

from drawings.places import Flat

ALT = (
    "Time per primary ray against the number of triangles, from a thousand to five million, with "
    "two logarithmic axes. The points of each family lie nearly on a line, whose slope is k: 0.39 "
    "for the grid, 0.21 for the kd-tree, 0.17 for the BVH, 0.12 for Embree"
)
HEIGHT = 400
SENTENCES = [
    "So from a thousand to five million triangles k = 0.39 for the grid, 0.21 (short stack) to "
    "0.24 for the kd-tree, 0.17 (ordered) to 0.26 (skip) for the BVH, 0.12 for Embree.",
    "Both axes of the drawing are logarithmic, with lines at 10^3, 10^4, 10^5 and 10^6 triangles, "
    "and at 0.1, 1 and 10 microseconds per ray.",
]
HEADING = "| triangles | grid | kd-tree, short stack | BVH, ordered | Embree, single |"
SIZES = ("1,282", "4,162", "10,642", "68,962", "593,842", "5,317,762")
FAMILIES = (("grid", "wrong"), ("kd-tree", "shape"), ("BVH", "ray"), ("Embree", "good"))


def slope(points):
    """By least squares, and where the line passes x = 0."""
    n = len(points)
    x, y = (sum(point[i] for point in points) / n for i in range(2))
    k = sum((p - x) * (q - y) for p, q in points) / sum((p - x) ** 2 for p, _ in points)
    return k, y - k * x


def draw(canvas, lesson):
    rows = [lesson.row(HEADING, size) for size in SIZES]
    at = Flat(70 - 3 * 96, 208, 96)  # one power of ten along each axis is equally long
    left, right = 3.0, 6.85

    def on(x, y):
        return at(x, y)

    for power in (3, 4, 5, 6):
        canvas.line(on(power, -1.35), on(power, 1.5), color="rule", width="thin")
        canvas.text(on(power, -1.35), f"$10^{power}$", "s", color="quiet", gap=6)
    for power, words in ((-1, "0.1"), (0, "1"), (1, "10")):
        canvas.line(on(left, power), on(right, power), color="rule", width="thin")
        canvas.text(on(left, power), words, "w", color="quiet", gap=8)
    for column, (name, color) in enumerate(FAMILIES, 1):
        points = [(math.log10(int(row[0].replace(",", ""))), -math.log10(float(row[column]))) for row in rows]
        k, start = slope(points)
        canvas.line(on(left, start + k * left), on(right, start + k * right), color=color)
        for point in points:
            canvas.point(on(*point), color=color)
        canvas.text(on(right, start + k * right), f"{name}: {k:.2f}", "e", color=color, gap=6)
    canvas.text(on(4.9, -1.35), "triangles", "s", color="quiet", gap=28)
    canvas.text(on(left, 1.5), "µs per ray", "e", color="quiet", gap=8)
    canvas.text((552, 50), "slope $k$", "w", gap=0)
