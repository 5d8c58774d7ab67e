"""A shadow ray from a point to the lamp: from t = 0 to a little before t = 1."""

from drawings.places import Flat, between

ALT = (
    "A shadow ray from a point on the floor, at t = 0, to a lamp, at t = 1: it ends a little "
    "before the lamp, so neither a lampshade in which the lamp lies nor what stands behind the "
    "lamp counts; on the back of the floor the ray is empty"
)
HEIGHT = 292
SENTENCES = [
    "not normalised, so that $t = 0$ is the point and $t = 1$ the lamp.",
    "It ends at $1 - 2^{-16}$.",
]


def draw(canvas, _lesson):
    at = Flat(8, 250, 1)
    point, lamp = at(110, 0), at(352, 146)
    canvas.line(at(10, 0), at(330, 0), color="shape", width="thick")
    canvas.arrow(point, at(110, 74), color="quiet")
    canvas.text(at(110, 56), "$N$", "w", color="quiet", gap=6)
    end = between(point, lamp, 0.9)
    canvas.line(point, end, color="ray", width="thick")
    canvas.line((end[0] - 6, end[1] - 10), (end[0] + 6, end[1] + 10), color="ray", width="thick")
    canvas.line(end, lamp, color="ray", dashed=True)
    canvas.point(point, "$t$ = 0", "s", color="ray", radius=6)
    canvas.point(lamp, radius=8, color="good")
    canvas.text(lamp, "lamp: $t$ = 1", "nw", color="good", gap=10)
    canvas.text((end[0] + 4, end[1] + 8), "$t_{max}$ = $1 - 2^{-16}$", "se", color="ray", gap=10)
    blocker = between(point, lamp, 0.5)
    canvas.circle(blocker, 24, color="shape", filled=True)
    canvas.circle(blocker, 24, color="shape")
    canvas.text((blocker[0] - 20, blocker[1] - 20), "any hit will do", "nw", color="shape", gap=4)
    behind = between(point, lamp, 1.3)
    canvas.area(
        (behind[0] - 14, behind[1] - 22),
        (behind[0] + 20, behind[1] - 10),
        (behind[0] + 8, behind[1] + 26),
        color="quiet",
    )
    canvas.text((behind[0] + 24, behind[1]), "behind it:\nno shadow", "e", color="quiet", gap=6)
