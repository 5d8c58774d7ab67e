"""From above: where t = 1 is on rays that end at the rectangle, and on rays of length 1."""

import math

from drawings.places import Flat

ALT = (
    "From above: rays from the eye to a flat rectangle. With directions that end at the rectangle "
    "all points with t = 1 lie on it, so t is the depth along f; with directions of length 1 they "
    "lie on an arc around the eye, so t is the distance"
)
HEIGHT = 300
SENTENCES = [
    "With unnormalised directions, then, t is no distance.",
    "In the drawing all points are at $t = 1$: on the left they have one depth, on the right one "
    "distance.",
]


def draw(canvas, _lesson):
    for left, title, is_flat in ((60, "to the rectangle", True), (330, "of length 1", False)):
        at = Flat(left + 5, 140, 150)
        ends = [(1.0, 0.62 * s) for s in (-1, -0.5, 0, 0.5, 1)]
        if not is_flat:
            canvas.line(*(at(*end) for end in (ends[0], ends[-1])), color="rule")
            ends = [(x / math.hypot(x, y), y / math.hypot(x, y)) for x, y in ends]
        widest = math.atan2(0.62, 1)
        if is_flat:
            canvas.line(at(1, -0.72), at(1, 0.72), color="shape", width="thick")
        else:
            canvas.line(
                *(at(math.cos(a * widest / 10), math.sin(a * widest / 10)) for a in range(-11, 12)),
                color="good",
                width="thick"
            )
        for end in ends:
            canvas.arrow(at(0, 0), at(*end), color="ray")
        canvas.point(at(0, 0), "eye", "w")
        canvas.text((left + 90, 24), title, title=True)
        canvas.text(at(1.06, 0), "$t$ = 1", "e", color="shape" if is_flat else "good", gap=4)
        canvas.text(
            (left + 90, 276),
            "$t$ is the depth" if is_flat else "$t$ is the distance",
            color="shape" if is_flat else "good",
        )
