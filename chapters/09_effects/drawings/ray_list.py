"""A tree of rays at glass, level by level, and the list that each level is."""

ALT = (
    "A camera ray meets glass and parts in two, and each of these parts again. Beside the tree the "
    "list of each bounce: one ray, then two, then four less one that is too faint; each ray keeps "
    "the number of its pixel"
)
HEIGHT = 360
SENTENCES = [
    "each keeps the number of its pixel",
    "two textures of rays, the refracted and the reflected ones, are read back, those that live "
    "are written one behind the other",
]


def draw(canvas, _lesson):
    nodes = {
        "": (130, 50),
        "t": (76, 160),
        "r": (196, 160),
        "tt": (44, 270),
        "tr": (104, 270),
        "rt": (170, 270),
        "rr": (232, 270),
    }
    faint = "rr"
    for path, (x, y) in nodes.items():
        if path:
            parent = nodes[path[:-1]]
            is_faint = path == faint
            color = "quiet" if is_faint else ("ray" if path[-1] == "t" else "good")
            canvas.arrow(
                (parent[0], parent[1] + 8),
                (x, y - 9),
                color=color,
                width="thick" if not is_faint else "",
                dashed=is_faint,
            )
    for path, place in nodes.items():
        if path != faint:
            canvas.point(place, color="shape", radius=7)
    canvas.cross(nodes[faint], color="quiet")
    canvas.text((nodes[faint][0], nodes[faint][1] + 8), "faint", "s", color="quiet")
    canvas.text((96, 100), "refracted", "w", color="ray", gap=4)
    canvas.text((166, 100), "reflected", "e", color="good", gap=4)
    for level, y in ((0, 50), (1, 160), (2, 270)):
        own = [path for path in nodes if len(path) == level and path != faint]
        for number, path in enumerate(own):
            color = "shape" if not path else ("ray" if path[-1] == "t" else "good")
            canvas.box(316 + 74 * number, y - 18, 74, 36, "pixel", color=color, filled=True)
    for y in (84, 194):
        canvas.arrow((353, y), (353, y + 48), color="quiet", width="thick")
    canvas.text((366, 108), "the next list", "e", gap=0, color="quiet")
    canvas.text((366, 218), "no gaps", "e", gap=0, color="quiet")
    canvas.text((280, 336), "each level is one list, and each ray knows its pixel", color="quiet")
