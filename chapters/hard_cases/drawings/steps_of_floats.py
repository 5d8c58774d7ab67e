"""A ball at zero and the same ball far from zero, where its corners lie on the lattice of the floats."""

import math

from drawings.places import Flat

ALT = (
    "The same ball of sixteen corners twice. Left it lies at zero, and its corners are where they should be. Right it "
    "lies at a million, where floats are one sixteenth apart, drawn as a lattice: every corner has moved to a point of "
    "the lattice, and the ball has other faces"
)
HEIGHT = 292
SENTENCES = ["At 0 floats are as close as one likes. At 1,000,000 floats are 1/16 apart"]
STEP = 0.25


def draw(canvas, _lesson):
    ring = [(math.cos(i * math.pi / 8 + 0.2), math.sin(i * math.pi / 8 + 0.2)) for i in range(16)]
    at = Flat(140, 128, 100)
    canvas.area(*(at(*corner) for corner in ring), color="shape")
    for corner in ring:
        canvas.point(at(*corner), color="shape", radius=3.5)
    canvas.text((140, 266), "at 0", title=True)
    at = Flat(415, 128, 100)
    lines = [i * STEP for i in range(-4, 5)]
    for place in lines:
        canvas.line(at(place, -1.1), at(place, 1.1), color="rule", width="thin")
        canvas.line(at(-1.1, place), at(1.1, place), color="rule", width="thin")
    snapped = [tuple(STEP * round(coordinate / STEP) for coordinate in corner) for corner in ring]
    canvas.area(*(at(*corner) for corner in snapped), color="wrong")
    for corner in snapped:
        canvas.point(at(*corner), color="wrong", radius=3.5)
    canvas.text((415, 266), "at 1,000,000", title=True)
