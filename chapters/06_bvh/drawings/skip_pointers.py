"""A tree of seven nodes in the order of a walk, where each skips to, and the order of an octant from the other side."""

ALT = ("A tree: node 0 has the nodes 1 and 4, node 1 the leaves A and B, node 4 the leaves C and D. In memory they lie in the "
       "order 0, 1, A, B, 4, C, D; a box that is met leads to the next place, one that is missed along a bow behind its branch. "
       "For rays from the right the same nodes lie in the order 0, 4, D, C, 1, B, A")
HEIGHT = 520
SENTENCES = ["The drawing has a tree of four leaves. For rays that go to the right it is stored as 0, 1, A, B, 4, C, D. A ray that "
             "misses the box of node 1 goes on at node 4, and one that misses that of node 4 is at the end."]

PLACES = {"0": (280, 56), "1": (150, 126), "4": (410, 126), "A": (80, 196), "B": (220, 196), "C": (340, 196), "D": (480, 196)}
CHILDREN = {"0": ("1", "4"), "1": ("A", "B"), "4": ("C", "D")}
WIDTH, LEFT, STEP = 50, 46, 66


def order(node, first):
    """The nodes as they lie in memory, where the child number `first` comes first."""
    children = CHILDREN.get(node, ())
    found = [node]
    for child in (children if first == 0 else children[::-1]):
        found += order(child, first)
    return found


def size(node):
    return 1 + sum(map(size, CHILDREN.get(node, ())))


def strip(canvas, top, stored, bows):
    for number, node in enumerate(stored):
        x = LEFT + number * STEP
        is_leaf = node not in CHILDREN
        canvas.box(x, top, WIDTH, 34, node, color="good" if is_leaf else "shape", filled=True)
        if not is_leaf:
            canvas.arrow((x + WIDTH, top + 17), (x + STEP - 1, top + 17), color="ray")
    end = (LEFT + len(stored) * STEP + 4, top + 17)
    canvas.text((end[0], end[1]), "end", "e", gap=0, color="quiet")
    for number, node in enumerate(stored):
        to = number + size(node)
        a = (LEFT + number * STEP + WIDTH / 2, top + 36)
        b = (LEFT + to * STEP + (WIDTH / 2 if to < len(stored) else 18), top + (38 if to < len(stored) else 30))
        if size(node) > 1:
            canvas.bow(a, ((a[0] + b[0]) / 2, top + 36 + bows * (to - number) * 15), b, color="wrong", dashed=True)
        elif to < len(stored):
            canvas.bow((a[0] + 8, a[1]), ((a[0] + b[0]) / 2 + 4, top + 58), (b[0] - 8, b[1]), color="wrong", dashed=True)


def draw(canvas, _lesson):
    for node, children in CHILDREN.items():
        for child in children:
            canvas.line(PLACES[node], PLACES[child], color="rule")
    for node, (x, y) in PLACES.items():
        is_leaf = node not in CHILDREN
        canvas.box(x - 22, y - 16, 44, 32, node, color="good" if is_leaf else "shape", filled=True)
    canvas.arrow((20, 30), (92, 30), color="ray", width="thick")
    canvas.arrow((540, 30), (468, 30), color="quiet", width="thick")

    canvas.arrow((20, 252), (60, 252), color="ray", width="thick")
    canvas.text((70, 252), "rays to the right: node, near branch, far branch", "e", gap=0, color="ray")
    strip(canvas, 276, order("0", 0), 1)
    canvas.arrow((60, 412), (20, 412), color="quiet", width="thick")
    canvas.text((70, 412), "rays to the left: another octant, another order", "e", gap=0, color="quiet")
    strip(canvas, 436, order("0", 1), 1)
    canvas.arrow((330, 30), (366, 30), color="ray") if False else None
