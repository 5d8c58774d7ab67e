"""A short stack that is full: the oldest entry is forgotten, and found again by a restart."""

ALT = (
    "A stack of eight entries that is full. A new entry comes on top, and the oldest at the bottom "
    "is forgotten. Later, when the stack is empty though the ray goes on, the walk goes down again "
    "from the last node that held the whole rest of the ray"
)
HEIGHT = 330
SENTENCES = [
    "A stack of eight. When it is full, it forgets its *oldest* entry; when it is empty although "
    "the ray goes on, restart.",
]


def draw(canvas, _lesson):
    left, top = 70, 60
    for number in range(8):
        canvas.box(
            left,
            top + 30 * number,
            120,
            28,
            "newest" if number == 0 else ("oldest" if number == 7 else ""),
            color="ray" if number == 0 else "shape",
            filled=True,
        )
    canvas.arrow((130, 12), (130, top - 6), color="ray", width="thick")
    canvas.text((142, 26), "the far child", "e", color="ray", gap=4)
    canvas.arrow((194, top + 30 * 7 + 14), (252, top + 30 * 7 + 14), color="wrong", dashed=True, width="thick")
    canvas.text((258, top + 30 * 7 + 14), "forgotten", "e", color="wrong", gap=4)
    root, held, near, leaf = (420, 50), (372, 104), (330, 158), (300, 210)
    for a, b in ((root, held), (held, near), (near, leaf)):
        canvas.line(a, b, color="rule")
    for a, b in ((root, (468, 104)), (held, (420, 158)), (near, (370, 210))):
        canvas.line(a, b, color="rule")
        canvas.point(b, color="wrong" if a is held else "quiet", radius=6)
    canvas.point(root, color="shape", radius=7)
    canvas.point(near, color="shape", radius=7)
    canvas.point(leaf, color="ray", radius=7)
    canvas.point(held, color="good", radius=9)
    canvas.arrow((held[0] + 10, held[1] + 11), (411, 147), color="good", width="thick")
    canvas.text((held[0] - 10, held[1] - 6), "holds the rest", "w", color="good", gap=4)
    canvas.text((430, 162), "found again", "e", color="wrong", gap=4)
