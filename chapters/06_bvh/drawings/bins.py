"""Twelve boxes in eight bins along an axis, and what the seven cuts between bins cost."""

from drawings.places import Flat

ALT = (
    "Twelve boxes, each in one of eight bins by its centre, and the cost of the seven cuts between "
    "bins as bars. The least, 10.8, parts them into eight and four; a leaf would cost 18"
)
HEIGHT = 440
SENTENCES = [
    "The drawing has twelve boxes in eight bins. A leaf of them would cost 1.5 \\cdot 12 = 18; the "
    "best of the seven cuts costs 10.8 and parts them into 8 and 4.",
]

# Lower and upper corner; all are 1 deep.
BOXES = (
    ((0.2, 0.5), (1.0, 1.2)),
    ((0.4, 1.8), (1.3, 2.6)),
    ((0.9, 0.8), (1.7, 1.6)),
    ((1.2, 2.0), (2.2, 2.9)),
    ((1.6, 0.3), (2.4, 1.0)),
    ((1.9, 1.3), (2.7, 2.0)),
    ((2.3, 2.1), (3.2, 2.7)),
    ((2.6, 0.6), (3.3, 1.4)),
    ((6.1, 0.4), (6.9, 1.1)),
    ((6.4, 1.6), (7.2, 2.3)),
    ((6.9, 0.9), (7.7, 1.5)),
    ((4.5, 1.2), (5.2, 1.9)),
)
BINS, DEPTH = 8, 1.0
STEP, TEST = 3.0, 1.5  # C_t and C_i


def middle(box):
    return (box[0][0] + box[1][0]) / 2


def half_surface(boxes):
    wide, high = (max(box[1][axis] for box in boxes) - min(box[0][axis] for box in boxes) for axis in range(2))
    return wide * high + (wide + high) * DEPTH


def costs():
    """The bins of the boxes; and of each cut how many lie before it, and its cost."""
    first, last = min(map(middle, BOXES)), max(map(middle, BOXES))
    bins = [min(int((middle(box) - first) / (last - first) * BINS), BINS - 1) for box in BOXES]
    found = []
    for cut in range(1, BINS):
        sides = [[box for box, place in zip(BOXES, bins) if (place >= cut) == upper] for upper in (False, True)]
        tests = sum(half_surface(side) * len(side) for side in sides) / half_surface(BOXES)
        found.append((len(sides[0]), STEP + TEST * tests))
    return first, last, bins, found


def draw(canvas, _lesson):
    first, last, bins, cuts = costs()
    at, plot = Flat(30, 208, 62), Flat(30, 396, 62, 7.2)
    best = min(range(len(cuts)), key=lambda i: cuts[i][1])
    for number in range(BINS + 1):
        x = first + (last - first) * number / BINS
        canvas.line(at(x, 0.1), at(x, 3.1), color="rule", dashed=True, width="thin")
    for box, place in zip(BOXES, bins):
        color = "shape" if place <= best else "good"
        (x0, y0), (x1, y1) = box
        canvas.area(at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1), color=color)
        canvas.point(at(middle(box), (y0 + y1) / 2), color=color, radius=3.5)
    for number, (_, cost) in enumerate(cuts):
        x = first + (last - first) * (number + 1) / BINS
        a, b = plot(x, 0), plot(x, cost)
        is_best = number == best
        canvas.area(
            (a[0] - 15, a[1]),
            (a[0] + 15, a[1]),
            (a[0] + 15, b[1]),
            (a[0] - 15, b[1]),
            color="ray" if is_best else "quiet",
        )
        if is_best:
            canvas.text(b, f"{cost:.1f}", "n", color="ray", gap=4)
    x = at(first + (last - first) * (best + 1) / BINS, 0)[0]
    canvas.line((x, at(0, 3.2)[1]), (x, 232), color="ray", width="thick")
    leaf = TEST * len(BOXES)
    canvas.line(plot(0.2, leaf), plot(8, leaf), color="wrong", dashed=True)
    canvas.text(plot(6.6, leaf), f"a leaf: {leaf:g}", "n", color="wrong", gap=5)
    canvas.line(plot(0.2, 0), plot(8, 0), color="quiet")
    canvas.text(plot(4.2, 0), "cost of the cuts between bins", "s", color="quiet", gap=8)
    assert cuts[best][0] == 8 and f"{cuts[best][1]:.1f}" == "10.8", cuts
