"""A ray through a small tree, and how restart, backtrack and ropes come from leaf A to leaf B."""

from drawings.places import Flat, before

ALT = (
    "Above, a box cut into five leaves that a ray crosses in the order A, B, C, D, E. Below, three "
    "times its tree with the way from leaf A to leaf B: restart goes down from the root over 4 "
    "nodes, backtrack climbs one and goes down again, 3 nodes, a rope leads there at once, 1 node"
)
HEIGHT = 538
SENTENCES = [
    "From A to B in the drawing restart visits 4 nodes, backtrack 3 (up to the node above, which "
    "it looks at again to go down), and a rope leads to 1.",
]

# A node is a leaf's letter, or (axis, split, lower, upper).
TREE = (0, 4.0, (1, 2.0, (0, 2.0, "A", "B"), "C"), (0, 6.0, "D", "E"))
SIZE = (8.0, 4.0)
ORIGIN, DIRECTION = (0.0, 1.1), (1.0, 0.3)


def nodes(node=TREE, path="", lower=(0.0, 0.0), upper=SIZE):
    """Each node's path from the root (l and u), itself and its box."""
    yield path, node, lower, upper
    if not isinstance(node, str):
        axis, split = node[:2]
        cut_upper, cut_lower = list(upper), list(lower)
        cut_upper[axis] = cut_lower[axis] = split
        yield from nodes(node[2], path + "l", lower, tuple(cut_upper))
        yield from nodes(node[3], path + "u", tuple(cut_lower), upper)


def exit_of(box_upper):
    """The ray ascends along both axes."""
    return min((upper - o) / d for upper, o, d in zip(box_upper, ORIGIN, DIRECTION))


def leaf_at(t, start=""):
    """The path of the leaf that holds the ray just after t, and the nodes visited on the way down."""
    found = {path: node for path, node, _, _ in nodes()}
    path, visits = start, [start]
    while not isinstance(found[path], str):
        axis, split = found[path][:2]
        path += "u" if (split - ORIGIN[axis]) / DIRECTION[axis] <= t else "l"
        visits.append(path)
    return path, visits


def ways():
    """The nodes that each walk visits on the way from the first leaf to the next."""
    exits = {path: exit_of(upper) for path, _, _, upper in nodes()}
    here, _ = leaf_at(0.0)
    t = exits[here]
    restart = leaf_at(t)[1]
    up, climbed = here, []
    while exits[up] <= t:
        up = up[:-1]
        climbed.append(up)
    return here, restart, climbed + leaf_at(t, up)[1], [restart[-1]]


def draw(canvas, _lesson):
    at = Flat(100, 190, 45)
    for _, node, lower, upper in nodes():
        if not isinstance(node, str):
            axis, split = node[:2]
            a, b = list(lower), list(upper)
            a[axis] = b[axis] = split
            canvas.line(at(*a), at(*b), color="shape")
    canvas.line(at(0, 0), at(8, 0), at(8, 4), at(0, 4), color="shape", closed=True)
    for _, node, lower, upper in nodes():
        if isinstance(node, str):
            canvas.text(at(lower[0] + 0.3, upper[1] - 0.4), node, color="shape")
    on_ray = [at(ORIGIN[0] + t * DIRECTION[0], ORIGIN[1] + t * DIRECTION[1]) for t in (-0.6, 8.9)]
    canvas.arrow(*on_ray, color="ray", width="thick")

    here, restart, backtrack, rope = ways()
    names = (
        (f"restart: {len(restart)} nodes", restart),
        (f"backtrack: {len(backtrack)} nodes", backtrack),
        (f"rope: {len(rope)} node", rope),
    )
    places = {
        "": (5.4, 3),
        "l": (3.2, 2),
        "u": (7.4, 2),
        "ll": (1.9, 1),
        "lu": (4.4, 1),
        "ul": (6.6, 1),
        "uu": (8.2, 1),
        "lll": (1.0, 0),
        "llu": (2.9, 0),
    }
    letters = {path: node if isinstance(node, str) else "" for path, node, _, _ in nodes()}
    for number, (title, way) in enumerate(names):
        tree = Flat(2 + 180 * number, 478, 21, 66)
        place = {path: tree(*spot) for path, spot in places.items()}
        for path in places:
            if path:
                canvas.line(place[path[:-1]], place[path], color="rule")
        if number == 0:
            for a, b in zip(way, way[1:]):
                canvas.arrow(place[a], before(place[a], place[b], 15), color="ray", width="thick")
        elif number == 1:
            up, down = way[0], way[-1]
            canvas.arrow(place[here], before(place[here], place[up], 15), color="ray", width="thick")
            canvas.arrow(place[up], before(place[up], place[down], 15), color="ray", width="thick")
        else:
            a, b = place[here], place[way[-1]]
            canvas.bow(
                (a[0] + 6, a[1] + 12),
                ((a[0] + b[0]) / 2, a[1] + 44),
                (b[0] - 5, b[1] + 13),
                color="ray",
                width="thick",
            )
        for path, letter in letters.items():
            if letter:
                x, y = place[path]
                color = "ray" if path in (here, restart[-1]) else "shape"
                canvas.box(x - 11, y - 13, 22, 26, letter, color=color, filled=True)
            else:
                canvas.point(place[path], color="ray" if path in way else "shape", radius=6)
        canvas.text((tree(4.6, 0)[0], 236), title, color="ray")
