"""A ray around a corner of cells: which references it passes over, and one that it tests twice."""

from drawings.places import Flat

ALT = (
    "Four cells and a ray that comes through three of them, first lower left, then lower right, "
    "then upper right. Triangle a lies in all three and is tested once, for in the second and "
    "third cell the neighbour behind the face of entry lists it. Triangle b lies in the first and "
    "the third cell but not in the second, and is tested twice"
)
HEIGHT = 330
SENTENCES = [
    "It overlooks a triangle that is listed in a cell, not in the next, but again in the one after.",
]

TRIANGLES = {
    "a": ((0.35, 0.12), (1.75, 0.5), (1.9, 1.45)),
    "b": ((0.3, 0.7), (1.45, 1.6), (0.45, 1.75)),
    "c": ((1.55, 1.62), (1.9, 1.6), (1.8, 1.9)),
}
WAY = ((0, 0), (1, 0), (1, 1))
COLORS = {"a": "shape", "b": "good", "c": "quiet"}


def clipped(corners, axis, plane, side):
    """The part of a polygon on one side of a plane."""
    kept = []
    for p, q in zip(corners, corners[1:] + corners[:1]):
        inside_p, inside_q = side * (p[axis] - plane) > 0, side * (q[axis] - plane) > 0
        if inside_p:
            kept.append(p)
        if inside_p != inside_q:
            part = (plane - p[axis]) / (q[axis] - p[axis])
            kept.append(tuple(a + part * (b - a) for a, b in zip(p, q)))
    return kept


def is_listed(corners, cell):
    part = list(corners)
    for axis in range(2):
        part = clipped(clipped(part, axis, cell[axis], 1), axis, cell[axis] + 1, -1)
    return len(part) > 2


def draw(canvas, _lesson):
    at = Flat(34, 300, 136)
    for x in range(3):
        canvas.line(at(x, 0), at(x, 2), color="rule")
        canvas.line(at(0, x), at(2, x), color="rule")
    for name, corners in TRIANGLES.items():
        canvas.area(*(at(*corner) for corner in corners), color=COLORS[name])
    for name, place in (("a", (1.66, 0.82)), ("b", (0.62, 1.42)), ("c", (1.75, 1.71))):
        canvas.text(at(*place), f"${name}$", color=COLORS[name], halo=False)
    slope, start = 0.56, 0.2
    canvas.line(at(1, 0), at(1, 1), at(2, 1), color="ray", width="thick")
    canvas.arrow(at(-0.15, start - 0.15 * slope), at(2.08, start + 2.08 * slope), color="ray", width="thick")
    seen, before = set(), None
    for number, cell in enumerate(WAY):
        y = 254 - 84 * number if number < 2 else 62
        canvas.text((336, y), ("first cell", "second", "third")[number], "e", gap=0, color="ray")
        row = 0
        for name, corners in TRIANGLES.items():
            if not is_listed(corners, cell):
                continue
            skipped = before is not None and is_listed(corners, before)
            words = "passed over" if skipped else ("tested again" if name in seen else "tested")
            canvas.text(
                (430, y + 25 * row),
                f"${name}$  {words}",
                "e",
                gap=0,
                color="wrong" if words == "tested again" else COLORS[name],
            )
            seen.add(name)
            row += 1
        before = cell
