"""Where a ray enters and leaves the boxes of four children, and the order that follows."""

from drawings.places import Flat

ALT = ("Four bars over an axis of t, one for the part of a ray in the box of each child. The bar of child 2 begins at 1, those of children 0 "
       "and 3 both at 2, that of child 1 at 4. The order is 2, 0, 3, 1")
HEIGHT = 262
SENTENCES = ["In the drawing a ray enters child 2 at $t$ = 1, the children 0 and 3 both at $t$ = 2, and child 1 at $t$ = 4. So the order is 2, "
             "0, 3, 1."]

PARTS = ((2, 3.4), (4, 4.8), (1, 2.6), (2, 4.4))  # entry and exit of each child


def draw(canvas, _lesson):
    at = Flat(110, 226, 82)
    order = sorted(range(4), key=lambda child: (PARTS[child][0], child))
    for child, (entry, end) in enumerate(PARTS):
        x, y = at(entry, 0)[0], 26 + 44 * child
        canvas.text((96, y + 14), f"child {child}", "w", gap=0)
        canvas.box(x, y, at(end, 0)[0] - x, 28, color="shape", filled=True)
    for first, second in zip(order, order[1:]):
        start, end = (at(PARTS[child][0], 0)[0] + 12 for child in (first, second))
        canvas.arrow((start, 40 + 44 * first), (end, 40 + 44 * second), color="ray")
    canvas.point((at(PARTS[order[0]][0], 0)[0] + 12, 40 + 44 * order[0]), color="ray")
    canvas.arrow(at(0, 0), at(5.2, 0), color="quiet")
    for t in (1, 2, 4):
        canvas.text(at(t, 0), str(t), "s", color="quiet")
    canvas.text(at(5.2, 0), "$t$", "e")
