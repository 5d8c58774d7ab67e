"""A slit between one long edge and two short ones, and the triangle without area that closes it."""

from drawings.places import Flat

ALT = (
    "Below, two triangles meet at the middle m of an edge from a to b; above, one triangle has the whole edge. "
    "Rounding has moved m a little down, so a slit has opened between them, drawn far too wide. A ray goes through "
    "the slit and is stopped by the third triangle a, m, b, which had no area before"
)
HEIGHT = 300
SENTENCES = [
    "Rounding moves the middle m a little off the edge from a to b",
    "the triangle a, m, b closes it",
]


def draw(canvas, _lesson):
    at = Flat(280, 150, 105)
    a, b, m = (-2.0, 0.0), (2.0, 0.0), (0.0, -0.3)
    top, left, right = (0.2, 1.15), (-1.1, -1.2), (1.2, -1.15)
    for corners in ((a, b, top), (a, left, m), (m, right, b), (m, left, right)):
        canvas.area(*(at(*corner) for corner in corners), color="shape", outlined=False)
        canvas.line(*(at(*corner) for corner in corners), color="quiet", width="thin", closed=True)
    canvas.area(at(*a), at(*m), at(*b), color="good", width="thick")
    canvas.point(at(*a), "$a$", "w")
    canvas.point(at(*b), "$b$", "e")
    canvas.point(at(*m), "$m$", "s")
    canvas.point(at(0.55, -0.1), color="ray", radius=6)
