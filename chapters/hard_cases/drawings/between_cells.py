"""Seen from the side: a ray in the very plane between two cells, where a triangle lies too."""

from drawings.places import Flat

ALT = (
    "Two cells of a structure, one above the other, and a ray that runs exactly in the plane between them, from the "
    "left to a triangle that stands across that plane. The time at which the ray meets the plane is zero divided by "
    "zero. Who takes it for a number looks into one cell or into none; the ray must look into both"
)
HEIGHT = 250
SENTENCES = ["The plane's t is 0/0"]


def draw(canvas, _lesson):
    at = Flat(70, 112, 100, 80)
    for low in (0.0, -1.0):
        canvas.box(at(0, 0)[0], at(0, low + 1)[1], 420, 80, color="shape", filled=True)
    canvas.text(at(0.15, 0.72), "upper cell", "e", gap=0, color="shape")
    canvas.text(at(0.15, -0.72), "lower cell", "e", gap=0, color="shape")
    canvas.line(at(3.2, 0.55), at(3.5, -0.6), color="good", width="thick")
    canvas.arrow(at(-0.45, 0.0), at(3.33, 0.0), color="ray", width="thick")
    canvas.point(at(-0.45, 0.0), "$o$", "n", color="ray")
    canvas.text((280, 226), "the plane's t is 0/0", color="wrong", title=True)
