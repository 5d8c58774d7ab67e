"""One direction from a point to a lamp, found by a bounce or by a ray to the lamp, and what each counts."""

from drawings.places import Flat

ALT = (
    "A point has two ways to the same point of a lamp: a bounce with the density 0.3 and a ray to the lamp "
    "with the density 0.9. By their shares they count 0.25 and 0.75, together 1"
)
HEIGHT = 300
SENTENCES = [
    "Where a bounce has the density 0.3 and a ray to the lamp 0.9, they count 0.25 and 0.75.",
    "the weights of the same direction sum to one",
]

BOUNCE, LAMP = 0.3, 0.9


def draw(canvas, _lesson):
    at = Flat(150, 240, 60)
    canvas.line(at(-2, 0), at(2, 0), width="thick")
    canvas.line(at(-0.9, 3.4), at(0.9, 3.4), color="good", width="thick")
    canvas.text(at(0, 3.4), "lamp", "n", color="good")
    canvas.bow(at(0, 0), at(-1.2, 1.7), at(-0.06, 3.34), color="ray")
    canvas.bow(at(0, 0), at(1.2, 1.7), at(0.06, 3.34), color="shape")
    canvas.point(at(0, 0), radius=6)
    canvas.text(at(-0.62, 1.7), f"$p$ = {BOUNCE:g}\nbounce", "w", color="ray")
    canvas.text(at(0.62, 1.7), f"$q$ = {LAMP:g}\nto the lamp", "e", color="shape")
    whole = BOUNCE + LAMP
    left, top, width, height = 330, 108, 200, 44
    part = width * BOUNCE / whole
    canvas.box(left, top, part, height, f"{BOUNCE / whole:g}", color="ray", filled=True)
    canvas.box(left + part, top, width - part, height, f"{LAMP / whole:g}", color="shape", filled=True)
    canvas.text((left + width / 2, top), "what each way counts", "n")
    canvas.text((left + width / 2, top + height), "the weights sum to one", "s", color="quiet")
