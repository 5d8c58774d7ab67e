"""Along a ray: where it may begin and end beside a surface."""

from drawings.places import Flat

ALT = (
    "Three rays that meet a surface, drawn as an upright line with its room as a strip. The first begins before the "
    "strip and ends behind it: it must hit. The second ends within the strip: a hit and a miss are right. The third "
    "begins behind the strip: it must miss"
)
HEIGHT = 262
SENTENCES = ["Where t_min or t_max lies within the room, a hit and a miss are right"]


def draw(canvas, _lesson):
    at = Flat(250, 208, 60, 60)
    canvas.area(at(-0.55, -0.35), at(0.55, -0.35), at(0.55, 3.2), at(-0.55, 3.2), color="good", dashed=True, width="thin")
    canvas.line(at(0, -0.35), at(0, 3.2), color="shape", width="thick")
    for y, first, last, words, color in ((2.6, -3.2, 2.0, "must hit", "good"), (1.4, -3.2, 0.25, "hit or miss", "ink"), (0.2, 1.15, 2.0, "must miss", "wrong")):
        canvas.arrow(at(first, y), at(last, y), color="ray", width="thick")
        canvas.point(at(first, y), color="ray", radius=4)
        canvas.text(at(first, y), "$t_{min}$", "n", color="ray", gap=18)
        canvas.text(at(max(last, 0.55), y), "$t_{max}$", "e", color="ray")
        canvas.text(at(3.0, y), words, "e", color=color)
