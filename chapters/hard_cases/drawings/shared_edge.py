"""Seen along the ray: two triangles that round their common edge apart, and two that ask it once."""

from drawings.places import Flat

ALT = (
    "Two times two triangles with a common edge, seen along a ray that is a point on it. Left, each triangle has "
    "computed the edge for itself, a little away from where the other has it, and the ray passes through the gap "
    "between the two. Right, both judge the edge by the same number, so there is no gap, and one of them is hit"
)
HEIGHT = 292
SENTENCES = [
    "each triangle for itself, and rounds it to another place than its neighbour",
    "the same number for both",
]


def draw(canvas, _lesson):
    for left, gap, words, color in ((145, 0.17, "each for itself: a gap", "wrong"), (415, 0.0, "the same number: no gap", "good")):
        at = Flat(left, 128, 100)
        low, high = (-0.35, -0.95), (0.35, 0.95)
        for side in (-1, 1):
            ends = [(x + side * gap / 2, y) for x, y in (low, high)]
            corners = [at(*point) for point in (*ends, (side * 1.15, -side * 0.25))]
            canvas.area(*corners, color="shape", outlined=False)
            canvas.line(*corners, color="quiet", width="thin", closed=True)
            canvas.line(at(*ends[0]), at(*ends[1]), color=color, width="thick")
        canvas.point(at(0.0, 0.0), color="ray", radius=6)
        canvas.text((left, 266), words, color=color, title=True)
