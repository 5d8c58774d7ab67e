"""The same lamp, facing a point and turned away from it: how many directions lead to it."""

import math

from drawings.places import Flat

ALT = (
    "A lamp of area 1 at the distance 2, once facing the point and once turned by 60 degrees: the directions "
    "that lead to it fill 0.25 and 0.125 of the unit ball's surface"
)
HEIGHT = 320
SENTENCES = [
    "For an area of 1 at the distance 2 that is 0.25, and when the lamp is turned by 60 degrees, 0.125.",
]

AREA, DISTANCE = 1.0, 2.0


def draw(canvas, _lesson):
    for left, turned in ((140, 0), (420, 60)):
        at = Flat(left, 260, 88)
        cosine = math.cos(math.radians(turned))
        filled = AREA * cosine / DISTANCE**2
        along = 0.5 * AREA * cosine, 0.5 * AREA * math.sin(math.radians(turned))
        ends = [(-along[0], DISTANCE - along[1]), (along[0], DISTANCE + along[1])]
        arc = [(math.sin(math.radians(step)), math.cos(math.radians(step))) for step in range(-90, 91, 5)]
        canvas.line(*(at(*place) for place in arc), color="rule")
        angles = [math.atan2(x, y) for x, y in ends]
        parts = [angles[0] + (angles[1] - angles[0]) * step / 12 for step in range(13)]
        for x, y in ends:
            canvas.line(at(0, 0), at(x, y), color="quiet", dashed=True, width="thin")
        canvas.line(*(at(math.sin(part), math.cos(part)) for part in parts), color="ray", width="thick")
        canvas.line(*(at(*end) for end in ends), color="good", width="thick")
        canvas.line(at(-1.3, 0), at(1.3, 0))
        canvas.point(at(0, 0))
        canvas.text(at(0.42, 1.12), f"{filled:g}", "e", color="ray")
        words = "faces the point" if turned == 0 else f"turned by {turned}°"
        canvas.text(at(0, DISTANCE + 0.5), words, "n", color="good")
    at = Flat(140, 260, 88)
    canvas.measure(at(-1.05, 0), at(-1.05, DISTANCE), f"{DISTANCE:g}", "w")
