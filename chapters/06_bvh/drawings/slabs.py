"""Two pairs of planes as two spans of t, for a ray that crosses both and for rays along one pair."""

from drawings.places import Flat

ALT = ("Left: a ray is between the planes of x from t = 2 to 5 and between those of y from t = 1.25 to 3.75; both hold from 2 to "
       "3.75, and there it is in the box. Right: rays along x; one between the planes of y has a span of y without ends and is "
       "in the box from 2 to 5, one above them has none")
HEIGHT = 470
SENTENCES = ["In the drawing the ray is between the planes of x from t = 2 to 5 and between those of y from 1.25 to 3.75: so it is in "
             "the box from 2 to 3.75.", "It starts at t = 0, as the rays beside it do."]

LOWER, UPPER = (2.0, 1.0), (5.0, 3.0)


def span(axis, origin, direction):
    return [(plane - origin[axis]) / direction[axis] for plane in (LOWER[axis], UPPER[axis])]


def draw(canvas, _lesson):
    scale = 40
    left, right = Flat(40, 196, scale), Flat(322, 196, scale)
    for at in (left, right):
        for x in (LOWER[0], UPPER[0]):
            canvas.line(at(x, -0.2), at(x, 3.9), color="shape", dashed=True, width="thin")
        for y in (LOWER[1], UPPER[1]):
            canvas.line(at(-0.2, y), at(5.8, y), color="good", dashed=True, width="thin")
        canvas.area(at(*LOWER), at(UPPER[0], LOWER[1]), at(*UPPER), at(LOWER[0], UPPER[1]), color="quiet")

    direction = (1.0, 0.8)
    spans = [span(axis, (0.0, 0.0), direction) for axis in range(2)]
    entry, leaves = max(one[0] for one in spans), min(one[1] for one in spans)
    canvas.arrow(left(0, 0), left(4.9, 4.9 * 0.8), color="ray", width="thick")
    for axis, color in enumerate(("shape", "good")):
        for t in spans[axis]:
            canvas.point(left(t, t * 0.8), color=color, radius=6)
    canvas.text((150, 24), "both are crossed", title=True)
    canvas.text((432, 24), "along the planes of y", title=True)

    canvas.arrow(right(0, 1.7), right(5.8, 1.7), color="ray", width="thick")
    canvas.arrow(right(0, 3.45), right(5.8, 3.45), color="wrong", width="thick")

    def bar(at, row, start, end, color, words):
        y = 262 + 42 * row
        a, b = (at(start, 0)[0], y), (at(end, 0)[0], y)
        canvas.line(a, b, color=color, width="thick")
        return a, b, y, words

    for row, (axis, color) in enumerate((("x", "shape"), ("y", "good"))):
        start, end = spans[row]
        a, b, y, _ = bar(left, row, start, end, color, "")
        canvas.text(a, f"{start:g}", "w", color=color, gap=6)
        canvas.text(b, f"{end:g}", "e", color=color, gap=6)
        canvas.text((16, y), f"${axis}$", "e", gap=0, color=color)
    a, b, y, _ = bar(left, 2, entry, leaves, "ray", "")
    canvas.area((a[0], y - 7), (b[0], y - 7), (b[0], y + 7), (a[0], y + 7), color="ray")
    canvas.text((b[0], y), "in the box", "e", color="ray", gap=12)

    start, end = span(0, (0.0, 1.7), (1.0, 0.0)) if False else (LOWER[0], UPPER[0])
    a, b, y, _ = bar(right, 0, start, end, "shape", "")
    canvas.text(a, f"{start:g}", "w", color="shape", gap=6)
    canvas.text(b, f"{end:g}", "e", color="shape", gap=6)
    canvas.arrow(right(-0.25, 0)[:1] + (304,), right(6, 0)[:1] + (304,), color="good", width="thick", both=True)
    a, b, y, _ = bar(right, 2, start, end, "ray", "")
    canvas.area((a[0], y - 7), (b[0], y - 7), (b[0], y + 7), (a[0], y + 7), color="ray")
    canvas.text(a, "in it", "w", color="ray", gap=12)
    canvas.text((432, 388), "beside the box: its $y$ has no span", color="wrong")
    for at in (left, right):
        canvas.axis(at(0, -5.6), at(6, -5.6), "$t$", [(at(0, -5.6), "0")], end_side="n")
