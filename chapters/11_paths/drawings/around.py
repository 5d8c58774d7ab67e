"""A point of a floor: light arrives from all directions, each counted by its cosine, and leaves to the eye."""

import math

from drawings.places import Flat

ALT = (
    "A point of a matte floor under a half ball of directions. From a lamp, from a wall and from the sky "
    "radiance arrives, each counted by the cosine of its angle; the sum over all directions leaves to the eye"
)
HEIGHT = 330
SENTENCES = [
    "from each direction the radiance there, times the cosine of its angle",
]

FAR, NEAR = 3.4, 2.1  # where light comes from; what counts of it under the normal
ARRIVING = (("lamp", 38, "good"), ("sky", 68, "shape"), ("wall", 158, "wrong"))
EYE = 118


def toward(degrees, far):
    return far * math.cos(math.radians(degrees)), far * math.sin(math.radians(degrees))


def draw(canvas, _lesson):
    at = Flat(280, 270, 62)
    half = [at(*toward(step, NEAR)) for step in range(0, 181, 4)]
    canvas.area(*half, color="rule", outlined=False)
    canvas.line(*half, color="rule", dashed=True)
    canvas.line(at(-4.2, 0), at(4.2, 0), width="thick")
    canvas.arrow(at(0, 0), at(0, 2.7), color="quiet", dashed=True)
    canvas.text(at(0, 2.7), "normal", "n", color="quiet")
    for words, degrees, color in ARRIVING:
        start = toward(degrees, FAR)
        canvas.arrow(at(*start), at(*toward(degrees, 0.12)), color=color)
        canvas.text(at(*start), words, "e" if degrees < 90 else "w", color=color)
        # What is left of a length after the cosine: its shadow on the normal, drawn along the ray.
        counted = NEAR * math.sin(math.radians(degrees))
        canvas.line(at(0, 0), at(*toward(degrees, counted)), color=color, width="thick")
    canvas.arrow(at(0, 0), at(*toward(EYE, FAR)), color="ray", width="thick")
    canvas.text(at(*toward(EYE, FAR)), "to the eye", "n", color="ray")
    canvas.point(at(0, 0), radius=6)
    canvas.text(at(-2.4, 0), "thick: what the cosine leaves", "s", color="quiet")
    canvas.text(at(2.6, 0), "matte floor", "s")
