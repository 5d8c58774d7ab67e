"""A slanted triangle that a plane cuts, and the bounds of its parts with and without clipping."""

from drawings.places import Flat

ALT = (
    "A slanted triangle that a plane cuts. Without clipping each child takes the whole bounds of "
    "the triangle up to the plane; clipped, each child takes the bounds of its own part, which are "
    "much lower. What is saved is empty space"
)
HEIGHT = 250
SENTENCES = [
    "Of a triangle that the plane cuts, each child needs only the part in its own box.",
]

TRIANGLE = ((0.1, 0.15), (3.9, 2.0), (3.5, 2.35))
PLANE = 2.0


def cut(corners, plane, side):
    """The part of a polygon on one side of a plane of x (Sutherland and Hodgman)."""
    kept = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        inside_a, inside_b = side * (a[0] - plane) >= 0, side * (b[0] - plane) >= 0
        if inside_a:
            kept.append(a)
        if inside_a != inside_b:
            part = (plane - a[0]) / (b[0] - a[0])
            kept.append((plane, a[1] + part * (b[1] - a[1])))
    return kept


def bounds(points):
    return [(pick(p[0] for p in points), pick(p[1] for p in points)) for pick in (min, max)]


def draw(canvas, _lesson):
    for left, title, is_clipped in ((28, "not clipped", False), (300, "clipped", True)):
        at = Flat(left, 196, 58)
        canvas.line(at(PLANE, -0.2), at(PLANE, 2.7), color="shape", width="thick")
        for side, color in ((-1, "ray"), (1, "good")):
            part = cut(list(TRIANGLE), PLANE, side)
            lower, upper = bounds(part if is_clipped else TRIANGLE)
            if not is_clipped:
                lower = (max(lower[0], PLANE) if side > 0 else lower[0], lower[1])
                upper = (min(upper[0], PLANE) if side < 0 else upper[0], upper[1])
            canvas.area(at(*lower), at(upper[0], lower[1]), at(*upper), at(lower[0], upper[1]), color=color)
        canvas.area(*(at(*corner) for corner in TRIANGLE), color="ink")
        canvas.text((left + 116, 226), title)
        canvas.text(at(PLANE, 2.7), "plane", "n", color="shape", gap=4)
