"""A lamp with a width, a thing before it, and where on the floor all, some or none of the lamp is seen."""

from drawings.places import Flat

ALT = (
    "A lamp with a width above a thing and a floor. Where no point of the lamp is seen from the "
    "floor there is the full shadow; where some are, the soft edge; each sample asks one point of "
    "the lamp"
)
HEIGHT = 320
SENTENCES = [
    "- **A lamp with an area** is asked at one of its points by each sample.",
]

LAMP, LAMP_HEIGHT = (-1.0, 1.0), 4.0
THING, THING_HEIGHT = (-0.9, 1.1), 2.0


def draw(canvas, _lesson):
    at = Flat(280, 264, 58)

    def falls(lamp, thing):
        """Where on the floor the line from a point of the lamp past an end of the thing ends."""
        return thing + (thing - lamp) * THING_HEIGHT / (LAMP_HEIGHT - THING_HEIGHT)

    dark = falls(LAMP[0], THING[0]), falls(LAMP[1], THING[1])
    soft = falls(LAMP[1], THING[0]), falls(LAMP[0], THING[1])
    for lamp, end in ((LAMP[0], dark[0]), (LAMP[1], dark[1]), (LAMP[1], soft[0]), (LAMP[0], soft[1])):
        canvas.line(at(lamp, LAMP_HEIGHT), at(end, 0), color="rule", width="thin")
    canvas.line(at(-4.6, 0), at(4.6, 0), color="good", width="thick")
    for start, end, color in (
        (dark[0], dark[1], "ink"),
        (soft[0], dark[0], "quiet"),
        (dark[1], soft[1], "quiet"),
    ):
        canvas.line(at(start, -0.08), at(end, -0.08), color=color, width="thick")
        canvas.line(at(start, -0.14), at(end, -0.14), color=color, width="thick")
    canvas.line(at(*(LAMP[0], LAMP_HEIGHT)), at(LAMP[1], LAMP_HEIGHT), color="good", width="thick")
    canvas.line(at(THING[0], THING_HEIGHT), at(THING[1], THING_HEIGHT), color="shape", width="thick")
    place = (soft[1] + dark[1]) / 2
    for part in (0.1, 0.37, 0.63, 0.9):
        x = LAMP[0] + part * (LAMP[1] - LAMP[0])
        crossing = place + (x - place) * THING_HEIGHT / LAMP_HEIGHT
        is_seen = crossing > THING[1]
        if is_seen:
            canvas.arrow(at(place, 0), at(x, LAMP_HEIGHT), color="ray")
        else:
            canvas.arrow(at(place, 0), at(crossing, THING_HEIGHT), color="wrong", dashed=True)
        canvas.point(at(x, LAMP_HEIGHT), color="good")
    canvas.point(at(place, 0), color="ray", radius=6)
    canvas.text(at(0, LAMP_HEIGHT), "lamp", "n", color="good")
    canvas.text(at(THING[0], THING_HEIGHT), "thing", "w", color="shape")
    canvas.text(at((dark[0] + dark[1]) / 2, -0.1), "none", "s", gap=10)
    for start, end in ((soft[0], dark[0]), (dark[1], soft[1])):
        canvas.text(at((start + end) / 2, -0.1), "some", "s", color="quiet", gap=10)
    canvas.text(at(-4.1, -0.1), "all", "s", color="good", gap=10)
    canvas.text(at(-4.7, 1.1), "of the lamp is seen:", "e", gap=0, color="quiet")
