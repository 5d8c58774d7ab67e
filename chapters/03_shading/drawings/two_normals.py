"""A coarse ball from the side: the normals of its planes, and those of its look, which turn from corner to corner."""

import math

from drawings.places import between

ALT = (
    "A coarse ball from the side, five flat pieces of a circle. Each piece has one normal of its "
    "plane; the interpolated normals turn from corner to corner. Light comes from the left. On the "
    "fourth piece an interpolated normal still faces it, but the plane does not, and the piece is "
    "dark"
)
HEIGHT = 270
SENTENCES = [
    "The interpolated normal says how the surface",
]

LAMP = 163  # the direction to it, in degrees against the clock from the right
FIRST, TURN = 135, -18  # of the corners
PIECES = 5


def faces(degrees):
    return math.cos(math.radians(degrees - LAMP)) > 0


def draw(canvas, _lesson):
    middle, radius = (280, 442), 330

    def out(place, degrees, length):
        return (
            place[0] + length * math.cos(math.radians(degrees)),
            place[1] - length * math.sin(math.radians(degrees)),
        )

    canvas.line(*(out(middle, a, radius) for a in range(44, 137, 3)), color="rule", dashed=True)
    corners = [out(middle, FIRST + TURN * i, radius) for i in range(PIECES + 1)]
    planes = [FIRST + TURN * (i + 0.5) for i in range(PIECES)]
    assert [faces(plane) for plane in planes] == [True, True, True, False, False]
    assert faces(FIRST + TURN * 3.12)  # interpolated, on the first dark piece
    for number, (a, b) in enumerate(zip(corners, corners[1:])):
        is_lit = faces(planes[number])
        canvas.line(a, b, color="good" if is_lit else "ink", width="thick")
        foot = between(a, b, 0.5)
        canvas.arrow(foot, out(foot, planes[number], 64), color="good" if is_lit else "ink", width="thick")
        for part in (0.12, 0.88):
            foot = between(a, b, part)
            canvas.arrow(foot, out(foot, FIRST + TURN * (number + part), 40), color="ray")
    for corner in corners:
        canvas.point(corner)
    for place in ((14, 92), (14, 132)):
        canvas.arrow(place, out(place, LAMP, -78), color="good", dashed=True)
    canvas.text((14, 60), "light", "e", gap=0, color="good")
    canvas.text((548, 26), "thick: of the plane, where it is", "w", gap=0)
    canvas.text((548, 50), "thin: interpolated, how it looks", "w", gap=0, color="ray")
    canvas.text((between(corners[3], corners[4], 0.5)[0] - 26, 204), "dark", "c")
    canvas.text((280, 158), "lit", "c", color="good")
