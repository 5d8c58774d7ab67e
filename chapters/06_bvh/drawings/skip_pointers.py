"""A tree of seven nodes in the order of a walk, where each skips to, and the order for rays from the other side."""

ALT = (
    "A tree: node 0 has the nodes 1 and 4, node 1 the leaves A and B, node 4 the leaves C and D. "
    "In memory they lie in the order 0, 1, A, B, 4, C, D; a box that is met leads to the next "
    "place, one that is missed along a bow behind its branch. For rays from the right the same "
    "nodes lie in the order 0, 4, D, C, 1, B, A"
)
HEIGHT = 566
SENTENCES = [
    "The drawing has a tree of four leaves. For rays that go to the right it is stored as 0, 1, A, "
    "B, 4, C, D. A ray that misses the box of node 1 goes on at node 4, and one that misses that "
    "of node 4 is at the end.",
]

PLACES = {
    "0": (280, 56),
    "1": (150, 126),
    "4": (410, 126),
    "A": (80, 196),
    "B": (220, 196),
    "C": (340, 196),
    "D": (480, 196),
}
CHILDREN = {"0": ("1", "4"), "1": ("A", "B"), "4": ("C", "D")}
WIDTH, LEFT, STEP = 50, 46, 66


def order(node, first):
    """The nodes as they lie in memory, where the child number `first` comes first."""
    children = CHILDREN.get(node, ())
    found = [node]
    for child in children if first == 0 else children[::-1]:
        found += order(child, first)
    return found


def size(node):
    return 1 + sum(map(size, CHILDREN.get(node, ())))


def strip(canvas, top, stored):
    for number, node in enumerate(stored):
        x, to = LEFT + number * STEP, number + size(node)
        canvas.box(x, top, WIDTH, 34, node, color="shape" if node in CHILDREN else "good", filled=True)
        canvas.arrow((x + WIDTH, top + 17), (x + STEP - 1, top + 17), color="ray")
        if node in CHILDREN:
            at_end = to == len(stored)
            a, b = (x + WIDTH / 2, top + 36), (
                LEFT + to * STEP + (18 if at_end else WIDTH / 2),
                top + (30 if at_end else 37),
            )
            canvas.bow(a, ((a[0] + b[0]) / 2, top + 36 + (to - number) * 15), b, color="wrong", dashed=True)
    canvas.text((LEFT + len(stored) * STEP + 4, top + 17), "end", "e", gap=0, color="quiet")


def draw(canvas, _lesson):
    for node, children in CHILDREN.items():
        for child in children:
            canvas.line(PLACES[node], PLACES[child], color="rule")
    for node, (x, y) in PLACES.items():
        is_leaf = node not in CHILDREN
        canvas.box(x - 22, y - 16, 44, 32, node, color="good" if is_leaf else "shape", filled=True)
    for top, first, color, ends, words in (
        (276, 0, "ray", (20, 60), "rays to the right: near branch first"),
        (436, 1, "quiet", (60, 20), "rays to the left: another octant, another order"),
    ):
        canvas.arrow((ends[0], top - 24), (ends[1], top - 24), color=color, width="thick")
        canvas.text((70, top - 24), words, "e", gap=0, color=color)
        strip(canvas, top, order("0", first))
    canvas.arrow((60, 542), (96, 542), color="ray")
    canvas.text((96, 542), "met, or a leaf", "e", color="ray")
    canvas.line((290, 542), (326, 542), color="wrong", dashed=True)
    canvas.text((326, 542), "missed: skip", "e", color="wrong")
