"""The three answers of one step down: only the second child, both, or only the first."""

from drawings.places import Flat, between

ALT = (
    "A ray in a node that a plane cuts, in three cases. The plane lies before t: only the second "
    "child. It lies between t and the exit: the first child now, the second one later, and the "
    "exit becomes t of the plane. It lies behind the exit: only the first child"
)
HEIGHT = 240
SENTENCES = [
    "**If $t_{split} \\le t$, go to the second child.**",
    "If $t_{split}$ is before `exit`, the second child comes later",
]


def draw(canvas, _lesson):
    for number, (split, words) in enumerate(((0.2, "second"), (0.55, "first,\nthen second"), (0.86, "first"))):
        at = Flat(20 + 184 * number, 150, 150)
        wide, high = 1.0, 0.72
        plane = split * wide
        start, end = (0.3, 0.2), (0.78, 0.5)
        first = number > 0
        for left, right, is_taken in ((0, plane, first), (plane, wide, number < 2)):
            if is_taken:
                canvas.area(
                    at(left, 0),
                    at(right, 0),
                    at(right, high),
                    at(left, high),
                    color="ray" if not (number == 1 and left) else "good",
                    outlined=False,
                )
        canvas.line(at(0, 0), at(wide, 0), at(wide, high), at(0, high), color="shape", closed=True)
        canvas.line(at(plane, -0.05), at(plane, high + 0.05), color="shape", width="thick")
        canvas.line(at(start[0] - 0.26, start[1] - 0.1625), at(*start), color="ray", dashed=True)
        canvas.arrow(at(*start), at(*end), color="ray", width="thick")
        canvas.line(at(*end), at(end[0] + 0.2, end[1] + 0.125), color="ray", dashed=True)
        canvas.point(at(*start), "$t$", "s", color="ray", radius=6)
        canvas.text(at(*end), "exit", "s", color="ray", gap=12)
        part = (plane - start[0]) / (end[0] - start[0])
        canvas.point(between(at(*start), at(*end), part), color="shape", radius=6)
        canvas.text(at(plane, high + 0.05), "$t_{split}$", "n", color="shape", gap=4)
        canvas.text(at(0.5, 0), words, "s", color="ink", gap=12)
