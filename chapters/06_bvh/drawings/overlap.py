"""Space cut in two, and triangles sorted into two groups."""

from drawings.places import Flat

ALT = (
    "The same five triangles twice. Left, a plane cuts space, and the triangle that it cuts is "
    "listed on both sides. Right, the triangles are sorted into two groups with a box around each: "
    "each is listed once, and the boxes overlap"
)
HEIGHT = 280
SENTENCES = [
    "What if we sort the *triangles* instead, each into one group, and put a box around every "
    "group? Then the boxes overlap.",
]

TRIANGLES = (
    ((0.3, 0.4), (1.1, 0.7), (0.5, 1.3)),
    ((0.7, 1.8), (1.5, 2.1), (0.9, 2.7)),
    ((1.3, 1.1), (2.6, 1.5), (1.9, 2.0)),
    ((2.2, 0.3), (3.2, 0.6), (2.9, 1.2)),
    ((2.7, 1.9), (3.5, 2.0), (3.3, 2.7)),
)
PLANE = 2.0


def draw(canvas, _lesson):
    for left, title, is_tree in ((26, "space is cut", False), (306, "triangles are sorted", True)):
        at = Flat(left, 224, 60)
        groups = ([], [])
        for one in TRIANGLES:
            groups[sum(x for x, _ in one) / 3 > PLANE].append(one)
        for side, color in enumerate(("ray", "good")):
            points = [point for one in groups[side] for point in one]
            lower = [min(p[axis] for p in points) for axis in range(2)]
            upper = [max(p[axis] for p in points) for axis in range(2)]
            if not is_tree:
                lower, upper = [(0.1, PLANE)[side], 0.1], [(PLANE, 3.75)[side], 3.0]
            canvas.area(at(*lower), at(upper[0], lower[1]), at(*upper), at(lower[0], upper[1]), color=color)
            for one in groups[side]:
                is_cut = not is_tree and min(x for x, _ in one) < PLANE < max(x for x, _ in one)
                canvas.area(*(at(*corner) for corner in one), color="wrong" if is_cut else color)
        canvas.text((left + 116, 252), title)
    canvas.text((142, 22), "listed twice", color="wrong")
