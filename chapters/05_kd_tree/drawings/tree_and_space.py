"""A box that three planes cut into four leaves, and the tree that says so."""

from drawings.places import Flat

ALT = (
    "Left, a box with triangles: a first plane cuts it, a second and a third cut the parts, and "
    "four leaves A, B, C, D fill it without overlap. Right, the tree: three inner nodes, each a "
    "plane, and four leaves; the triangle that a plane cuts is listed in both its leaves"
)
HEIGHT = 290
SENTENCES = [
    "The boxes of the leaves fill the root's box without overlap, so a ray meets them one after "
    "the other.",
    "A triangle that reaches into several leaves is listed in each.",
]


def draw(canvas, _lesson):
    at = Flat(26, 240, 52)
    wide, high = 5, 4
    canvas.line(at(0, 0), at(wide, 0), at(wide, high), at(0, high), color="shape", closed=True)
    canvas.line(at(3, 0), at(3, high), color="ray", width="thick")
    canvas.line(at(0, 1.8), at(3, 1.8), color="good", width="thick")
    canvas.line(at(3, 2.6), at(wide, 2.6), color="wrong", width="thick")
    for corners, is_cut in (
        (((0.4, 0.4), (1.3, 0.6), (0.8, 1.2)), False),
        (((2.2, 0.7), (3.8, 1.0), (3.2, 1.6)), True),
        (((0.6, 2.3), (1.6, 2.5), (0.9, 3.2)), False),
        (((3.5, 3.0), (4.5, 3.1), (4.1, 3.7)), False),
    ):
        canvas.area(*(at(*corner) for corner in corners), color="ink" if is_cut else "quiet")
    for letter, place in (("A", (0.25, 1.45)), ("B", (0.25, 3.65)), ("C", (4.7, 0.35)), ("D", (4.75, 3.65))):
        canvas.text(at(*place), letter, color="shape")
    places = {"root": (430, 60), "low": (370, 140), "high": (490, 140)}
    leaves = {"A": (338, 222), "B": (402, 222), "C": (458, 222), "D": (522, 222)}
    for parent, children in (("low", "AB"), ("high", "CD")):
        canvas.line(places["root"], places[parent], color="rule")
        for child in children:
            canvas.line(places[parent], leaves[child], color="rule")
    for name, color in (("root", "ray"), ("low", "good"), ("high", "wrong")):
        canvas.point(places[name], color=color, radius=9)
    for letter, (x, y) in leaves.items():
        canvas.box(x - 15, y - 16, 30, 32, letter, color="shape", filled=True)
    canvas.text((430, 266), "the cut one: in A and C")
    canvas.text((430, 30), "the first plane", color="ray")
