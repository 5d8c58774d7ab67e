"""To scale: where a computed hit point may lie, what the next ray's test may see, and how far the origin moves."""

from drawings.places import Flat

ALT = (
    "Left: a hit point that rounding put 21 eM behind its triangle; the ray that leaves it meets "
    "that triangle at once, which is acne. Right, to scale: within 52 eM of the point the test may "
    "see the surface; an origin moved by 64 eM along the normal is outside of that ball"
)
HEIGHT = 430
SENTENCES = [
    "$\\sqrt3 \\cdot 12\\,eM < 21\\,eM$",
    "$31\\,eM$ along the normal. Together that is $52\\,eM$.",
    "moves by $64\\,eM$ along the normal of the triangle's plane",
    "so $64 - 52 = 12$ of them are to spare",
]

POINT, TEST = 21, 31
BALL = POINT + TEST
MOVES = ("moved by {} eM", range(8, 81, 4), 64)


def draw(canvas, _lesson, moved):
    scale = 2.35
    left, right = Flat(132, 214, scale), Flat(376, 214, scale)
    for at, near, far in ((left, -46, 34), (right, -56, 60)):
        canvas.area(
            at(near, POINT), at(far, POINT), at(far, -POINT), at(near, -POINT), color="quiet", outlined=False
        )
        canvas.line(at(near, 0), at(far, 0), color="shape", width="thick")
        canvas.line(at(0, 0), at(0, -POINT), color="quiet", dashed=True, width="thin")

    computed = left(0, -POINT)
    canvas.line(left(-32, 58), left(0, 0), color="ray", dashed=True)
    own = left(POINT * 0.62, 0)
    canvas.arrow(computed, own, color="ray", width="thick")
    canvas.cross(own)
    canvas.point(left(0, 0), hollow=True)
    canvas.point(computed, color="ray")
    canvas.text((120, 340), "the next ray hits\nits own triangle", color="wrong")
    canvas.text(computed, "computed", "s", color="ray")
    canvas.measure(left(-24, 0), left(-24, -POINT), f"{POINT} $eM$", "w")
    canvas.text((110, 28), "acne", title=True)

    computed = right(0, -POINT)
    start = right(0, moved - POINT)
    canvas.circle(computed, BALL * scale, color="wrong", dashed=True)
    color = "good" if moved > BALL else "wrong"
    canvas.arrow(computed, start, color=color, width="thick")
    canvas.arrow(start, right(36, moved - POINT + 36 * 0.62), color="ray", width="thick")
    canvas.point(right(0, 0), hollow=True)
    canvas.point(computed, color="ray")
    canvas.point(start, "new origin", "w", color=color)
    canvas.text(computed, "computed", "e", color="ray", gap=10)
    canvas.measure(right(-20, -POINT), right(-20, -POINT - BALL + 4.5), f"{BALL} $eM$", "e", color="wrong")
    canvas.measure(right(47, -POINT), right(47, moved - POINT), f"{moved} $eM$", "e", color=color)
    canvas.text((368, 28), "moved off the surface", title=True)
    canvas.text(right(0, -POINT - BALL), "here the test may see the surface", "s", color="wrong")
