"""Seen from the side: a triangle, its room, and the part of a ray that lies within."""

from drawings.places import Flat

ALT = (
    "A triangle seen from the side, as a line from a to b, and around it its room, as wide as 32 roundings of "
    "the reach. One ray goes through the triangle, another passes right beside its end b; of both the part "
    "from t_least to t_most lies within the room, and the triangle may be named there"
)
HEIGHT = 290
SENTENCES = [
    "The room is 32 roundings of the reach wide",
]

A, B = (-1.7, -1.25), (1.5, 0.95)
ROOM = 0.42


def draw(canvas, _lesson):
    at = Flat(285, 150, 72)
    hull = [
        (A[0] - ROOM, A[1] + ROOM),
        (A[0] - ROOM, A[1] - ROOM),
        (A[0] + ROOM, A[1] - ROOM),
        (B[0] + ROOM, B[1] - ROOM),
        (B[0] + ROOM, B[1] + ROOM),
        (B[0] - ROOM, B[1] + ROOM),
    ]
    canvas.area(*(at(*corner) for corner in hull), color="good", dashed=True)
    canvas.line(at(*A), at(*B), color="shape", width="thick")
    canvas.point(at(*A), "$a$", "s", color="shape")
    canvas.point(at(*B), "$b$", "s", color="shape")
    slope = (B[1] - A[1]) / (B[0] - A[0])
    for height, name in ((-0.35, "middle"), (1.2, "beside")):
        canvas.line(at(-3.4, height), at(3.3, height), color="ray", width="thin")
        first = B[0] - ROOM - (B[1] + ROOM - height) / slope
        last = min(B[0] + ROOM, A[0] + ROOM + (height - A[1] + ROOM) / slope)
        canvas.arrow(at(first, height), at(last, height), color="ray", width="thick", both=True)
        canvas.text(at(first, height), "$t_{least}$", "nw", color="ray", gap=4)
        canvas.text(at(last, height), "$t_{most}$", "se" if name == "middle" else "ne", color="ray", gap=4)
    canvas.measure(at(A[0] - ROOM, A[1] - ROOM - 0.12), at(A[0], A[1] - ROOM - 0.12), "32", "s")
