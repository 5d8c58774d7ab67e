"""From the side: a floor that is listed in the ray's cell and hit far behind it, and a ball in between."""

from drawings.places import Flat

ALT = (
    "A ray low above a floor, in a row of five cells seen from the side. The floor is listed in "
    "the first cell, but the ray meets it only in the last; a ball stands in between, and the ray "
    "meets it first. A walk that ends at the first report of a hit shows the floor through the ball"
)
HEIGHT = 276
SENTENCES = [
    "a ray comes into a cell low above the floor, the floor is listed there and hit far behind, "
    "and the walk ends",
]

START, SLOPE, FLOOR = 0.78, -0.135, 0.16
BALL, RADIUS = (2.75, 0.46), 0.3


def draw(canvas, _lesson):
    at = Flat(36, 176, 96)

    def on_ray(x):
        return at(x, START + SLOPE * x)

    meets = (FLOOR - START) / SLOPE
    # Where the ray meets the ball: a quadratic equation in x.
    a, b = 1 + SLOPE**2, -BALL[0] + SLOPE * (START - BALL[1])
    c = BALL[0] ** 2 + (START - BALL[1]) ** 2 - RADIUS**2
    in_front = (-b - (b * b - a * c) ** 0.5) / a
    canvas.area(at(0, 0), at(1, 0), at(1, 1), at(0, 1), color="ray", outlined=False)
    for x in range(6):
        canvas.line(at(x, 0), at(x, 1), color="rule")
    for y in (0, 1):
        canvas.line(at(0, y), at(5, y), color="rule")
    canvas.line(at(0, FLOOR), at(5, FLOOR), color="shape", width="thick")
    canvas.circle(at(*BALL), RADIUS * 96, color="good", filled=True)
    canvas.circle(at(*BALL), RADIUS * 96, color="good")
    canvas.line(on_ray(-0.3), on_ray(in_front), color="ray", width="thick")
    canvas.arrow(on_ray(in_front), on_ray(meets), color="ray", dashed=True)
    canvas.point(on_ray(in_front), color="good", radius=6)
    canvas.point(on_ray(meets), color="wrong", radius=6)
    canvas.point(on_ray(1), hollow=True)
    canvas.text(at(0.5, 1), "the ray's cell\nlists the floor", "n", gap=8)
    canvas.text(at(2.75, 1), "the nearest hit:\nlisted here", "n", color="good", gap=8)
    canvas.text(at(4.5, 1), "the floor's\nhit", "n", color="wrong", gap=8)
    canvas.text(at(1, 0), "the ray leaves its cell", "s", color="ray", gap=30)
    canvas.line((at(1, 0)[0], at(1, 0)[1] + 30), on_ray(1), color="ray", width="thin", dashed=True)
    canvas.text((540, 248), "a hit beyond that is kept, and the walk goes on", "w", gap=0, color="wrong")
