"""The triangle around the origin, and the three triangles that its edges make with it."""

from drawings.places import Flat, between

ALT = (
    "The plane after the shear: the triangle p, q, r surrounds the origin, so the three areas E(p, "
    "q), E(q, r) and E(r, p) that its edges cut off with the origin have one sign; beside it a "
    "triangle that does not, where one area has the other sign"
)
HEIGHT = 290
SENTENCES = [
    "The origin is inside if all three",
]


def area(p, q):
    return p[0] * q[1] - p[1] * q[0]


def draw(canvas, _lesson):
    for left, shift, title in ((150, 0.0, "inside"), (392, 1.25, "outside")):
        at = Flat(left, 150, 58)
        corners = {"p": (-1.4 + shift, -0.9), "q": (1.2 + shift, -1.1), "r": (-0.1 + shift, 1.5)}
        names = list(corners)
        for name, following in zip(names, names[1:] + names[:1]):
            a, b = corners[name], corners[following]
            color = "good" if area(a, b) > 0 else "wrong"
            canvas.area(at(*a), at(*b), at(0, 0), color=color, outlined=False)
            middle = between(between(a, b, 0.5), (0, 0), 0.36)
            canvas.text(at(*middle), "+" if area(a, b) > 0 else "\u2212", color=color, title=True)
        for name in names:
            canvas.line(at(0, 0), at(*corners[name]), color="quiet", dashed=True, width="thin")
        canvas.line(*(at(*corner) for corner in corners.values()), closed=True)
        for name, side in (("p", "sw"), ("q", "se"), ("r", "n")):
            canvas.text(at(*corners[name]), f"${name}$", side, gap=5)
        canvas.point(at(0, 0), color="ray", radius=6)
        canvas.text(
            (left + (0 if not shift else 40), 272), title, color="good" if not shift else "wrong", title=True
        )
