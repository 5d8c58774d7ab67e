"""Seen along the ray: a corner that is closed all around, and one at the border of a surface."""

import math

from drawings.places import Flat

ALT = (
    "Two times triangles around a corner, seen along a ray that is a point beside the corner, with its room as a "
    "circle. Left, six triangles close the corner: edges within cancel out, the border runs around the ray and "
    "stays away from its room, so the ray must hit. Right, three triangles: the border goes through the room, "
    "and the ray may hit or miss"
)
HEIGHT = 300
SENTENCES = [
    "the border runs around the ray",
    "the border goes through the room",
]


def draw(canvas, _lesson):
    for left, count, title, color in ((150, 6, "must hit", "good"), (410, 3, "may hit or miss", "wrong")):
        at = Flat(left, 140, 100)
        rim = [(math.cos(0.3 + i * math.pi / 3), math.sin(0.3 + i * math.pi / 3)) for i in range(count + 1)]
        for a, b in zip(rim, rim[1:]):
            canvas.area(at(0, 0), at(*a), at(*b), color="shape", outlined=False)
        closed = count == 6
        for i, corner in enumerate(rim[: 6 if closed else 4]):
            inner = closed or 0 < i < count
            canvas.line(at(0, 0), at(*corner), color="quiet" if inner else color, dashed=inner,
                        width="thin" if inner else "thick")
        canvas.arrow(*(at(*corner) for corner in rim), color=color, width="thick")
        canvas.circle(at(0.07, 0.09), 30, color="ray", dashed=True)
        canvas.point(at(0.07, 0.09), color="ray", radius=6)
        canvas.text((left, 276), title, color=color, title=True)
