"""A node with five triangles, and what each plane along x costs by the surface-area heuristic."""

from drawings.places import Flat

ALT = (
    "Above, five triangles in a node that is 10 wide, 6 high and 2 deep; below, the cost of a "
    "plane for each place along x. It is straight between the ends of triangles and jumps there. "
    "The least, 4.85, is at x = 4, where the fourth triangle ends; a leaf would cost 7.5, the "
    "middle 5.24"
)
HEIGHT = 516
SENTENCES = [
    "The drawing has a node of 10 x 6 x 2, from x = 0 to 10, with five triangles. A leaf would "
    "cost 1.5 \\cdot 5 = 7.5, the plane in the middle, x = 5, costs 5.24, and the least is 4.85 at "
    "x = 4",
]

SIZE = (10.0, 6.0, 2.0)
TRIANGLES = (
    ((1, 1), (2, 1.4), (1.4, 2.6)),
    ((1.5, 3.2), (3, 3.6), (2, 5)),
    ((2, 2), (3.5, 1.2), (3.2, 2.8)),
    ((2.5, 4.6), (4, 4), (3.6, 5.4)),
    ((7, 1.6), (9, 3.4), (7.6, 4.4)),
)
STEP, TEST, EMPTY_BONUS = 1.0, 1.5, 0.2
MOVES = ("the plane at x = {}", [i / 4 for i in range(2, 39)], 4)


def cost(x, triangles):
    """As common/structure/kd_tree/kd_plane.cpp has it."""
    below = sum(min(corner[0] for corner in one) < x for one in triangles)
    above = sum(max(corner[0] for corner in one) > x for one in triangles)
    cross_section, around = SIZE[1] * SIZE[2], SIZE[1] + SIZE[2]
    tests = ((cross_section + around * x) * below + (cross_section + around * (SIZE[0] - x)) * above) / (
        cross_section + around * SIZE[0]
    )
    whole = STEP + TEST * tests
    return (1 - EMPTY_BONUS) * whole if 0 in (below, above) else whole


def draw(canvas, _lesson, plane):
    node, plot = Flat(64, 200, 44, 27), Flat(64, 478, 44, 26)
    events = sorted({end for one in TRIANGLES for end in (min(c[0] for c in one), max(c[0] for c in one))})
    costs = {x: cost(x, TRIANGLES) for x in events}
    best = min(costs, key=costs.get)
    for x in events:
        canvas.line(node(x, SIZE[1]), plot(x, 0), color="rule", dashed=True, width="thin")
    canvas.line(node(0, 0), node(10, 0), node(10, 6), node(0, 6), closed=True)
    for one in TRIANGLES:
        canvas.area(*(node(*corner) for corner in one))
    ends = [0.0, *events, SIZE[0]]
    hair = 1e-9
    for start, end in zip(ends, ends[1:]):
        canvas.line(
            plot(start, cost(start + hair, TRIANGLES)), plot(end, cost(end - hair, TRIANGLES)), color="shape"
        )
    leaf = TEST * len(TRIANGLES)
    canvas.line(plot(0, leaf), plot(10, leaf), color="wrong", dashed=True)
    canvas.text(plot(7.2, leaf + 0.7), f"a leaf: {leaf:g}", "n", color="wrong", gap=5)
    is_best = plane == best
    color = "good" if is_best else "ray"
    canvas.line(node(plane, 6.25), plot(plane, 0), color=color, width="thick")
    for x in events:
        canvas.point(plot(x, costs[x]), color="shape")
    canvas.point(plot(plane, cost(plane, TRIANGLES)), color=color, radius=6)
    canvas.text(
        plot(plane, cost(plane, TRIANGLES) - 0.6),
        f"{cost(plane, TRIANGLES):.2f}",
        "sw" if plane > 2 else "se",
        color=color,
    )
    canvas.text(node(plane, 6.25), f"$x$ = {plane:g}", "n", color=color, gap=4)
    middle = SIZE[0] / 2
    if is_best:
        canvas.point(plot(middle, cost(middle, TRIANGLES)), f"{cost(middle, TRIANGLES):.2f}", "n", hollow=True)
    canvas.axis(plot(0, 0), plot(10.5, 0), "$x$", [(plot(x, 0), f"{x}") for x in (0, 5, 10)])
    canvas.axis(plot(0, 0), plot(0, 8.9), "cost", end_side="n")
