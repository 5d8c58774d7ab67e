"""Seen from the side: each height z is pushed aside until the ray stands upright."""

from drawings.places import Flat

ALT = (
    "Seen from the side, in x and z: the ray leans; the shear pushes each corner aside in "
    "proportion to its height z, and then the ray is the z axis; a corner that two triangles share "
    "moves once"
)
HEIGHT = 300
SENTENCES = [
    "Move the ray's origin to 0 and shear space so that the ray becomes the z axis.",
]

LEAN = 0.38  # d_x / d_z
CORNERS = {"p": (0.45, 3.4), "q": (2.15, 2.3)}  # x and z
OTHERS = ((-0.55, 2.0), (3.3, 3.9))


def draw(canvas, _lesson):
    before, after = Flat(80, 262, 52), Flat(375, 262, 52)
    for at, lean, title in ((before, 0.0, "before"), (after, LEAN, "sheared")):
        for height in (1, 2, 3, 4):
            canvas.line(
                at(-0.9 if lean == 0 else -1.6, height),
                at(3.4 if lean == 0 else 2.7, height),
                color="rule",
                width="thin",
            )

        def moved(corner, lean=lean, at=at):
            return at(corner[0] - lean * corner[1], corner[1])

        p, q = moved(CORNERS["p"]), moved(CORNERS["q"])
        left, right = moved(OTHERS[0]), moved(OTHERS[1])
        canvas.area(p, q, left, color="shape")
        canvas.area(p, q, right, color="good")
        top = at(LEAN * 4.35 - lean * 4.35, 4.35)
        if lean == 0:
            canvas.axis(at(0, 0), at(0, 4.3), "$z$", end_side="w")
        canvas.axis(at(0, 0), at(2.2, 0), "$x$", end_side="e")
        canvas.arrow(at(0, 0), top, color="ray", width="thick")
        if lean == 0:
            for name, corner in CORNERS.items():
                canvas.arrow(
                    moved(corner),
                    (moved(corner)[0] - LEAN * corner[1] * 52, moved(corner)[1]),
                    color="quiet",
                    dashed=True,
                )
        canvas.point(p, "$p$", "n" if lean else "ne")
        canvas.point(q, "$q$", "se")
        canvas.point(at(0, 0), "$o$" if lean == 0 else "$0$", "w", color="ray")
        canvas.text(at(0.9, 0), title, "s", gap=12, color="quiet")
