"""A walk by parent pointers: down to the near child, across to the far one, up."""

from drawings.places import before

ALT = (
    "A tree of seven nodes and a ray from the right, so the right child is the near one. The walk "
    "goes down to the near child, from a near child that is done across to the far one, and from a "
    "far child up: root, right, D, C, up, left, B, A, up, up"
)
HEIGHT = 300
SENTENCES = [
    "When a node is done, look at its parent: if this was the near child, go to the far one, else "
    "up.",
]

PLACES = {
    "root": (280, 62),
    "left": (150, 152),
    "right": (410, 152),
    "A": (80, 242),
    "B": (220, 242),
    "C": (340, 242),
    "D": (480, 242),
}
WAY = (
    ("root", "right", "down"),
    ("right", "D", "down"),
    ("D", "C", "across"),
    ("C", "right", "up"),
    ("right", "left", "across"),
    ("left", "B", "down"),
    ("B", "A", "across"),
    ("A", "left", "up"),
    ("left", "root", "up"),
)
COLORS = {"down": "ray", "across": "good", "up": "quiet"}


def draw(canvas, _lesson):
    parents = {"left": "root", "right": "root", "A": "left", "B": "left", "C": "right", "D": "right"}
    for child, parent in parents.items():
        canvas.line(PLACES[parent], PLACES[child], color="rule")
    for start, end, kind in WAY:
        a, b = PLACES[start], PLACES[end]
        if kind == "across":
            shift = 34 if start in "BD" else 30
            canvas.bow(
                (a[0] - shift, a[1] + 4),
                ((a[0] + b[0]) / 2, a[1] + 22),
                (b[0] + shift, b[1] + 4),
                color=COLORS[kind],
                width="thick",
            )
        else:
            side = 10 if kind == "down" else -12
            canvas.arrow(
                (before(b, a, 28)[0] + side, before(b, a, 28)[1]),
                (before(a, b, 28)[0] + side, before(a, b, 28)[1]),
                color=COLORS[kind],
                width="thick",
                dashed=kind == "up",
            )
    for name, (x, y) in PLACES.items():
        wide = 30 if len(name) == 1 else 56
        canvas.box(
            x - wide / 2, y - 15, wide, 30, name, color="shape" if len(name) > 1 else "good", filled=True
        )
    canvas.arrow((548, 40), (470, 40), color="ray", width="thick")
    canvas.text((509, 20), "ray", color="ray")
    for number, (kind, words) in enumerate(
        (("down", "down: near"), ("across", "across: far"), ("up", "up: done"))
    ):
        canvas.text((14, 24 + 24 * number), words, "e", gap=0, color=COLORS[kind])
