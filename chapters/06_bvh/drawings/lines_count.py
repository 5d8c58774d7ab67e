"""Lines of all directions and places that meet a box, and those of them that meet a box inside it."""

import math

from drawings.places import Flat

SPACING = 0.5
DIRECTIONS = 8
OUTER, INNER = 2.0, 1.0  # half of the sides
MIDDLE = (0.3, -0.4)  # of the inner box

ALT = (
    "A square box with a box of half its side in it, and 44 lines that meet the outer box, evenly "
    "spread over directions and places: 21 of them meet the inner box as well, about half, which "
    "is the ratio of the perimeters"
)
HEIGHT = 400
SENTENCES = [
    "Of the 44 lines in the drawing, evenly spread over directions and places, 21 meet the inner "
    "box: about half, since its perimeter is half of the outer one's.",
]


def meets(direction, offset, middle, half):
    """Is the line of points p with normal . p = offset within reach of the square's corners?"""
    normal = (-direction[1], direction[0])
    away = offset - (normal[0] * middle[0] + normal[1] * middle[1])
    return abs(away) < half * (abs(normal[0]) + abs(normal[1]))


def lines():
    """Direction and offset of those that meet the outer box."""
    for i in range(DIRECTIONS):
        angle = math.pi * (i + 0.5) / DIRECTIONS
        direction = (math.cos(angle), math.sin(angle))
        for place in range(-20, 21):
            offset = SPACING * 2 * (place + 0.5 * (i % 2) + 0.25)
            if meets(direction, offset, (0, 0), OUTER):
                yield direction, offset


def draw(canvas, _lesson):
    at = Flat(200, 200, 68)
    met = 0
    everything = list(lines())
    for wanted in (False, True):
        for direction, offset in everything:
            inner = meets(direction, offset, MIDDLE, INNER)
            if inner != wanted:
                continue
            met += inner
            foot = (-direction[1] * offset, direction[0] * offset)
            reach = math.sqrt(2.75**2 - offset**2)
            ends = [
                at(foot[0] + side * reach * direction[0], foot[1] + side * reach * direction[1])
                for side in (-1, 1)
            ]
            canvas.line(*ends, color="ray" if inner else "rule", width="" if inner else "thin")
    for middle, half, color in (((0, 0), OUTER, "shape"), (MIDDLE, INNER, "good")):
        x, y = middle
        canvas.line(
            at(x - half, y - half),
            at(x + half, y - half),
            at(x + half, y + half),
            at(x - half, y + half),
            closed=True,
            color=color,
            width="thick",
        )
    canvas.text((408, 150), f"{len(everything)} lines", "e", gap=0, color="shape")
    canvas.text((408, 176), "meet the box", "e", gap=0, color="shape")
    canvas.text((408, 220), f"{met} of them", "e", gap=0, color="ray")
    canvas.text((408, 257), "meet the one\nin it", "e", gap=0, color="ray")
