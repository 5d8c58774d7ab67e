"""Rays of one pixel from points of a disc: they meet in the sharp plane, and are apart before and behind it."""

from drawings.places import Flat

ALT = (
    "A lens from the side: rays of one pixel start at points of a disc and meet in the sharp "
    "plane; a thing before or behind that plane is met by them at several points, and is blurred"
)
HEIGHT = 270
SENTENCES = [
    "A lens moves the ray's origin on a disc, so that all rays of a pixel meet in the sharp plane.",
]


def draw(canvas, _lesson):
    at = Flat(60, 132, 1)
    focus, end, radius = 300, 460, 62
    canvas.line(at(focus, -96), at(focus, 96), color="good", width="thick", dashed=True)
    for part in (-1, -0.5, 0, 0.5, 1):
        y = part * radius
        canvas.arrow(at(0, y), at(end, y * (1 - end / focus)), color="ray", width="thick" if part == 0 else "")
        canvas.point(at(0, y), color="ray")
    canvas.line(at(0, -radius - 8), at(0, radius + 8), color="shape", width="thick")
    canvas.point(at(focus, 0), color="good", radius=7)
    for x in (150, 420):
        reach = radius * abs(1 - x / focus)
        canvas.line(at(x, -reach), at(x, reach), color="wrong", width="thick")
        canvas.text(at(x, -radius), "blurred", "s", color="wrong", gap=12)
    canvas.text(at(0, -radius - 8), "lens", "s", color="shape")
    canvas.text(at(focus, 96), "sharp plane", "n", color="good", gap=5)
