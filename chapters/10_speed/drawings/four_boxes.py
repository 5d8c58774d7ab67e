"""A binary tree of three levels as one node of four boxes, whose planes lie side by side."""

ALT = (
    "Left, a node of a binary tree with two children and four grandchildren; right, the same as "
    "one node with four children. Its boxes lie plane by plane, the four lower planes of x side by "
    "side, so that one operation holds a ray against four of them: six operations for four boxes"
)
HEIGHT = 312
SENTENCES = [
    "A node with four children keeps its boxes plane by plane: 6 planes, each of four boxes, so 6 "
    "operations hold a ray against 4 boxes.",
]

PLANES = ("x lower", "x upper", "y lower", "y upper", "z lower", "z upper")


def draw(canvas, _lesson):
    root, children = (110, 76), ((57, 144), (165, 144))
    leaves = [(30, 214), (84, 214), (138, 214), (192, 214)]
    for number, child in enumerate(children):
        canvas.line(root, child, color="rule")
        for leaf in leaves[2 * number : 2 * number + 2]:
            canvas.line(child, leaf, color="rule")
        canvas.point(child, color="quiet", hollow=True, radius=7)
    canvas.point(root, color="shape", radius=8)
    colors = ("shape", "good", "ray", "wrong")
    for leaf, color in zip(leaves, colors):
        canvas.box(leaf[0] - 15, leaf[1] - 15, 30, 30, color=color, filled=True)
    canvas.arrow((228, 144), (272, 144), color="quiet", width="thick")
    for row, name in enumerate(PLANES):
        y = 40 + 38 * row
        canvas.text((292, y + 13), name, "e", gap=0)
        for number, color in enumerate(colors):
            canvas.box(374 + 42 * number, y, 40, 26, color=color, filled=True)
    canvas.text((456, 20), f"{len(colors)} boxes", color="quiet")
    canvas.text((430, 286), f"one node: {len(PLANES)} operations", color="quiet")
    canvas.text((110, 286), "two levels", color="quiet")
