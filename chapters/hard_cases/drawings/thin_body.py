"""Seen from the side: a flat body with a grazing ray, and the room beside its walls."""

from drawings.places import Flat

ALT = (
    "A lens seen from the side, drawn much too high. A ray from within grazes the upper face and leaves at the rim, "
    "which a test must see as a hit of one of the two faces. Along both faces, inside, runs a dashed line: origins "
    "between it and a face are too near to the wall, and the promise does not cover them"
)
HEIGHT = 262
SENTENCES = [
    "at the rim, where both faces meet",
    "too near to a wall",
]


def draw(canvas, _lesson):
    at = Flat(280, 118, 235, 190)
    face = [(-1.0, 0.0), (-0.6, 0.29), (-0.2, 0.4), (0.2, 0.4), (0.6, 0.29), (1.0, 0.0)]
    below = [(x, -y) for x, y in reversed(face)]
    canvas.area(*(at(*point) for point in face + below[1:-1]), color="shape")
    canvas.line(*(at(0.84 * x, 0.8 * y) for x, y in face + below[1:-1]), color="wrong", dashed=True, width="thin", closed=True)
    canvas.arrow(at(-0.45, 0.05), at(0.985, 0.008), color="ray", width="thick")
    canvas.point(at(-0.45, 0.05), "$o$", "w", color="ray")
    canvas.text(at(0.99, -0.03), "rim", "s", color="ray", gap=12)
    canvas.text((280, 236), "too near to a wall: outside of the dashed line", color="wrong")
