"""Triangles in one place: copies of one, and triangles whose boxes have one centre."""

from drawings.places import Flat

ALT = (
    "Left, three triangles that are drawn a little apart but lie in one place; the second is turned round. A ray meets "
    "all three at the same t, and each of them is a right answer. Right, three triangles around each other, with the "
    "boxes around them: the boxes have one centre, so a builder that parts them by centres has nothing to part by"
)
HEIGHT = 296
SENTENCES = ["all three at the same t", "one centre"]


def draw(canvas, _lesson):
    at = Flat(70, 205, 130)
    for i, color in enumerate(("shape", "ink", "shape")):
        corners = [(0.1 * i, 0.12 * i), (0.9 + 0.1 * i, 0.12 * i), (0.35 + 0.1 * i, 1.05 + 0.12 * i)]
        canvas.area(*(at(*corner) for corner in corners), color=color, dashed=color == "ink")
    canvas.point(at(0.55, 0.5), color="ray", radius=6)
    canvas.text((150, 268), "all three at the same t", color="good", title=True)
    at = Flat(410, 128, 100)
    for size in (1.0, 0.62, 0.3):
        corner = at(-size, size)
        canvas.box(corner[0], corner[1], 200 * size, 200 * size, color="quiet", dashed=True, thickness="thin")
    for size in (1.0, 0.62, 0.3):
        canvas.area(*(at(x * size, y * size) for x, y in ((-1.0, -1.0), (1.0, -0.5), (0.1, 1.0))), color="shape")
    canvas.point(at(0.0, 0.0), color="wrong", radius=6)
    canvas.text((410, 268), "one centre", color="wrong", title=True)
