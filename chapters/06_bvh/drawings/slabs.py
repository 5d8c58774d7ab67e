"""Two pairs of planes as two spans of t, for a ray that crosses both and for rays along one pair."""

from drawings.places import Flat

ALT = ("Left: a ray is between the planes of x from t = 2 to 5 and between those of y from t = 1.25 to 3.75; both hold from 2 to "
       "3.75, and there it is in the box. Right: rays along x; one between the planes of y has a span of y without ends and is "
       "in the box from 2 to 5, one above them has none")
HEIGHT = 446
SENTENCES = ["In the drawing the ray is between the planes of x from t = 2 to 5 and between those of y from 1.25 to 3.75: so it is in "
             "the box from 2 to 3.75.", "It starts at t = 0, as the rays beside it do."]

LOWER, UPPER = (2.0, 1.0), (5.0, 3.0)


def span(axis, origin, direction):
    return [(plane - origin[axis]) / direction[axis] for plane in (LOWER[axis], UPPER[axis])]


def draw(canvas, _lesson):
    scale = 38
    left, right = Flat(50, 190, scale), Flat(310, 190, scale)
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
    canvas.text((160, 24), "both are crossed", title=True)
    canvas.text((424, 24), "along the planes of y", title=True)

    canvas.arrow(right(0, 1.7), right(5.8, 1.7), color="ray", width="thick")
    canvas.arrow(right(0, 3.45), right(5.8, 3.45), color="wrong", width="thick")

    def bar(at, row, ends, color, words=True):
        y = 256 + 40 * row
        a, b = ((at(t, 0)[0], y) for t in ends)
        canvas.line(a, b, color=color, width="thick")
        if words:
            canvas.text(a, f"{ends[0]:g}", "w", color=color, gap=6)
            canvas.text(b, f"{ends[1]:g}", "e", color=color, gap=6)
        return a, b

    both = (entry, leaves)
    for at, x_ends, ends in ((left, spans[0], both), (right, (LOWER[0], UPPER[0]), (LOWER[0], UPPER[0]))):
        for t in ends:
            canvas.line((at(t, 0)[0], 256), (at(t, 0)[0], 336), color="ray", dashed=True, width="thin")
        bar(at, 0, x_ends, "shape")
        a, b = bar(at, 2, ends, "ray", words=False)
        canvas.area((a[0], a[1] - 7), (b[0], a[1] - 7), (b[0], a[1] + 7), (a[0], a[1] + 7), color="ray")
        canvas.text(a, "in the box", "w", color="ray", gap=12)
        canvas.axis(at(0, -4.7), at(6, -4.7), "$t$", [(at(0, -4.7), "0")], end_side="n")
    bar(left, 1, spans[1], "good")
    canvas.text((14, 256), "$x$", "e", gap=0, color="shape")
    canvas.text((14, 296), "$y$", "e", gap=0, color="good")
    canvas.arrow((right(-0.3, 0)[0], 296), (right(6, 0)[0], 296), color="good", width="thick", both=True)
    canvas.text((right(3, 0)[0], 414), "outside: nowhere between\nthe planes of $y$", color="wrong")
