"""The eye, the rectangle before it, and the ray through a point of the rectangle."""

from drawings.places import Solid, between

ALT = (
    "The view rectangle in space: from the eye the unit vectors f, r and u; at distance 1 along f "
    "a rectangle with the half sides w and h; the vector l to its lower left corner, its lower "
    "side 2w r, and the ray d through the point (s, t)"
)
HEIGHT = 362
SENTENCES = [
    "Hang the window, a rectangle, before the eye, perpendicular to f, at distance 1.",
    "The program keeps whole sides: `view.right` is $2w\\,\\mathbf r$ and `view.up` is "
    "$2h\\,\\mathbf u$.",
]

W, H = 0.6, 0.45  # half of the sides
S, T = 0.75, 0.75  # any point of it


def draw(canvas, _lesson):
    space = Solid(85, 204, 278, turned=59, raised=15)

    def on(x, y, z=1.0):  # to the right, up, forward
        return space(x, y, -z)

    eye, middle = on(0, 0, 0), on(0, 0)
    corners = [on(-W, -H), on(W, -H), on(W, H), on(-W, H)]
    target = on((2 * S - 1) * W, (2 * T - 1) * H)
    foot = on((2 * S - 1) * W, -H)
    canvas.area(*corners, color="shape")
    for corner in corners[1:]:
        canvas.line(eye, corner, color="rule", width="thin")
    canvas.line(eye, middle, color="quiet", dashed=True, width="thin")
    canvas.line(foot, target, color="shape", dashed=True, width="thin")
    canvas.line(on(-W, (2 * T - 1) * H), target, color="shape", dashed=True, width="thin")
    canvas.arrow(eye, corners[0], color="good")
    canvas.text(between(eye, corners[0], 0.62), "$**ℓ**$", "s", color="good")
    canvas.arrow(eye, on((2 * S - 1) * W * 1.3, (2 * T - 1) * H * 1.3, 1.3), color="ray", width="thick")
    for tip, letter, side in (
        (on(0, 0, 0.45), "$**f**$", "s"),
        (on(0.45, 0, 0), "$**r**$", "s"),
        (on(0, 0.45, 0), "$**u**$", "n"),
    ):
        canvas.arrow(eye, tip)
        canvas.text(tip, letter, side)
    canvas.point(eye, "eye", "w")
    canvas.point(target, "$(s, t)$", "nw", color="ray")
    canvas.text(foot, "$s$", "s", color="shape", gap=4)
    canvas.text(on(-W, (2 * T - 1) * H), "$t$", "w", color="shape", gap=5)
    canvas.point(middle, color="quiet")
    canvas.measure(on(0, H * 1.1), on(W, H * 1.1), "$w$")
    canvas.measure(on(W * 1.15, 0), on(W * 1.15, H), "$h$", "e")
    below = H * 1.17
    canvas.measure(on(-W, -below), on(W, -below), "$2w$ $**r**$", "sw")
