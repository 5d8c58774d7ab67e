"""Two pairs of planes as two spans of t, for a ray that crosses both and for rays along one pair."""

from drawings.places import Flat

ALT = (
    "Left: a ray is between the planes of x from t = 2 to 5 and between those of y from t = 1.25 "
    "to 3.75; both hold from 2 to 3.75, and there it is in the box. Right: rays along x; one "
    "between the planes of y has a span of y without ends and is in the box from 2 to 5, one above "
    "them has none"
)
HEIGHT = 446
SENTENCES = [
    "In the drawing the ray is between the planes of x from t = 2 to 5 and between those of y from "
    "1.25 to 3.75: so it is in the box from 2 to 3.75.",
    "It starts at t = 0, as the rays beside it do.",
]

LOWER, UPPER = (2.0, 1.0), (5.0, 3.0)


MOVES = ("the direction (1, {})", [i / 20 for i in range(0, 27)], 0.8)
FARTHEST = 5.9  # that is drawn


def span(axis, direction):
    """From the first plane's t to the last one's; of an axis along which the ray does not go, nothing."""
    return [plane / direction[axis] for plane in (LOWER[axis], UPPER[axis])] if direction[axis] else []


def draw(canvas, _lesson, slope):
    scale = 38
    left, right = Flat(50, 190, scale), Flat(310, 190, scale)
    for at in (left, right):
        for x in (LOWER[0], UPPER[0]):
            canvas.line(at(x, -0.2), at(x, 3.9), color="shape", dashed=True, width="thin")
        for y in (LOWER[1], UPPER[1]):
            canvas.line(at(-0.2, y), at(5.8, y), color="good", dashed=True, width="thin")
        canvas.area(at(*LOWER), at(UPPER[0], LOWER[1]), at(*UPPER), at(LOWER[0], UPPER[1]), color="quiet")

    spans = [span(axis, (1.0, slope)) for axis in range(2)]
    reach = min(5.6, 4.0 / slope) if slope else 5.6
    canvas.arrow(left(0, 0), left(reach, reach * slope), color="ray", width="thick")
    for axis, color in enumerate(("shape", "good")):
        for t in spans[axis]:
            if t <= reach:
                canvas.point(left(t, t * slope), color=color, radius=6)
    canvas.text((160, 20), "both are crossed" if slope else "one is not crossed", title=True)
    canvas.text((424, 20), "along the planes of y", title=True)
    canvas.arrow(right(0, 1.7), right(5.8, 1.7), color="ray", width="thick")
    canvas.arrow(right(0, 3.45), right(5.8, 3.45), color="wrong", width="thick")

    def bar(at, row, ends, color, words=True):
        y = 256 + 40 * row
        a, b = ((at(min(t, FARTHEST), 0)[0], y) for t in ends)
        if ends[0] > FARTHEST:
            return
        canvas.line(a, b, color=color, width="thick")
        if words:
            canvas.text(a, f"{ends[0]:.3g}", "w", color=color, gap=6)
            if ends[1] < FARTHEST - 0.4:
                canvas.text(b, f"{ends[1]:.3g}", "e", color=color, gap=6)

    def in_the_box(at, ends):
        for t in ends:
            canvas.line((at(t, 0)[0], 256), (at(t, 0)[0], 336), color="ray", dashed=True, width="thin")
        a, b = ((at(t, 0)[0], 336) for t in ends)
        canvas.area((a[0], a[1] - 7), (b[0], a[1] - 7), (b[0], a[1] + 7), (a[0], a[1] + 7), color="ray")
        canvas.text(a, "in the box", "w", color="ray", gap=12)

    bar(left, 0, spans[0], "shape")
    if spans[1]:
        bar(left, 1, spans[1], "good")
        both = (max(spans[0][0], spans[1][0]), min(spans[0][1], spans[1][1]))
    if spans[1] and both[0] <= both[1]:
        in_the_box(left, both)
    else:
        canvas.text(left(3, -3.85), "beside the box", color="wrong")
    bar(right, 0, (LOWER[0], UPPER[0]), "shape")
    in_the_box(right, (LOWER[0], UPPER[0]))
    for at in (left, right):
        canvas.axis(at(0, -4.7), at(6, -4.7), "$t$", [(at(0, -4.7), "0")], end_side="n")
    canvas.text((14, 256), "$x$", "e", gap=0, color="shape")
    canvas.text((14, 296), "$y$", "e", gap=0, color="good")
    canvas.arrow((right(-0.3, 0)[0], 296), (right(6, 0)[0], 296), color="good", width="thick", both=True)
    canvas.text((right(3, 0)[0], 414), "outside: nowhere between\nthe planes of $y$", color="wrong")
