"""One step from cell to cell, and what ends the walk at it."""

from drawings.places import Flat, between

ALT = (
    "A ray in a grid of 4 x 3 cells. In cell (1, 0) its next crossings are at t = 2 on x, 1.5 on y "
    "and 5 on z: the least says that it leaves upwards, into cell (1, 1). Below, the three ends of "
    "a walk: a hit before the crossing, the ray's own end before it, and no cell behind it"
)
HEIGHT = 470
SENTENCES = [
    "In the drawing the ray is in cell (1, 0). It crosses the next plane of x at t = 2, that of y "
    "at t = 1.5 and that of z, which lies behind the page, at t = 5.",
]

ORIGIN, DIRECTION = (0.0, 0.25, 0.5), (1.0, 0.5, 0.1)
CELLS = (4, 3, 1)
MOVES = ("step {} of the walk", range(6), 1)


def crossing(axis, plane):
    return (plane - ORIGIN[axis]) / DIRECTION[axis]


def walk(steps):
    """The cell after so many steps, the axis of each crossing, and the next crossings."""
    cell = [0, 0, 0]
    while True:
        leaves = [crossing(axis, cell[axis] + 1) for axis in range(3)]
        first = leaves.index(min(leaves))
        if steps == 0:
            return tuple(cell), leaves, first
        cell[first] += 1
        steps -= 1


def draw(canvas, _lesson, steps):
    at = Flat(36, 268, 80)
    here, leaves, first = walk(steps)
    following = tuple(i + (axis == first) for axis, i in enumerate(here))
    is_last = following[first] >= CELLS[first]

    def on_ray(t):
        return at(ORIGIN[0] + t * DIRECTION[0], ORIGIN[1] + t * DIRECTION[1])

    def cell(x, y):
        return at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)

    for x in range(5):
        canvas.line(at(x, 0), at(x, 3), color="rule")
    for y in range(4):
        canvas.line(at(0, y), at(4, y), color="rule")
    if not is_last:
        canvas.area(*cell(*following[:2]), color="ray", dashed=True)
    canvas.area(*cell(*here[:2]), color="ray", width="thick")
    canvas.line(at(here[0] + 1, -0.12), at(here[0] + 1, 3.12), color="shape", width="thick")
    canvas.line(at(-0.12, here[1] + 1), at(4.12, here[1] + 1), color="good", width="thick")
    canvas.arrow(on_ray(0), on_ray(4.4), color="ray", width="thick")
    canvas.point(on_ray(leaves[0]), "$t_x$", "se", color="shape", radius=6)
    if leaves[1] <= 4.2:
        canvas.point(on_ray(leaves[1]), "$t_y$", "nw", color="good", radius=6)
    canvas.text(at(here[0] + 0.5, here[1]), f"cell ({here[0]}, {here[1]})", "n", color="ray", gap=5)
    canvas.text((392, 60), "the next crossings", "e", gap=0, color="quiet")
    for number, (name, color) in enumerate((("x", "shape"), ("y", "good"), ("z", "quiet"))):
        canvas.text((400, 92 + 28 * number), f"$t_{name}$ = {leaves[number]:g}", "e", gap=0, color=color)
    words = "the end" if is_last else f"go {('right', 'up')[first]}"
    canvas.text((482, 92 + 28 * first), words, "e", gap=0, color=("shape", "good")[first])
    canvas.line((8, 300), (552, 300), color="rule")
    for number, words in enumerate(
        ("a hit before\nthe crossing", "$t_{max}$ before\nthe crossing", "no cell\nbehind it")
    ):
        small = Flat(62 + 184 * number, 404, 76)
        a, b = small(-0.35, 0.2), small(1.0, 0.62)
        canvas.area(small(0, 0), small(1, 0), small(1, 1), small(0, 1), color="ray", outlined=False)
        canvas.line(small(0, 0), small(1, 0), small(1, 1), small(0, 1), color="rule", closed=True)
        if number == 0:
            hit = between(a, b, 0.66)
            canvas.line((hit[0] - 8, hit[1] - 26), (hit[0] + 10, hit[1] + 30), color="shape", width="thick")
            canvas.arrow(a, hit, color="ray", width="thick")
            canvas.line(hit, between(a, b, 1.2), color="ray", dashed=True)
        elif number == 1:
            end = between(a, b, 0.72)
            canvas.line(a, end, color="ray", width="thick")
            canvas.line((end[0] + 3, end[1] - 9), (end[0] - 3, end[1] + 9), color="ray", width="thick")
        else:
            canvas.line(small(1, -0.1), small(1, 1.1), color="ink", width="thick")
            canvas.arrow(a, between(a, b, 1.25), color="ray", width="thick")
        canvas.point(b, color="good" if number < 2 else "ray", hollow=number < 2)
        canvas.text(small(0.5, 0), words, "s", gap=8)
