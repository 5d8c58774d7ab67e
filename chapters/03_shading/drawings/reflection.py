"""A direction d is mirrored by taking away twice its part along the normal."""

from drawings.places import Flat

ALT = (
    "A ray with the direction d meets a mirror with the normal N. Its part along N is (N d) N: "
    "taken away once it leaves a direction within the plane, taken away twice the mirrored "
    "direction r"
)
HEIGHT = 280
SENTENCES = [
    "$$r = d - 2\\,(N \\cdot d)\\,N$$",
]

D, N = (1.7, -1.15), (0.0, 1.0)


def draw(canvas, _lesson):
    at = Flat(210, 146, 88)
    along = D[0] * N[0] + D[1] * N[1]
    within = tuple(d - along * n for d, n in zip(D, N))
    mirrored = tuple(d - 2 * along * n for d, n in zip(D, N))
    canvas.line(at(-2.2, 0), at(3.6, 0), color="shape", width="thick")
    canvas.arrow(at(0, 0), at(0, 1.2))
    canvas.text(at(0, 1.2), "$N$", "n", gap=4)
    canvas.arrow(at(-D[0], -D[1]), at(0, 0), color="ray", width="thick")
    canvas.arrow(at(0, 0), at(*D), color="ray", dashed=True)
    canvas.arrow(at(*D), at(*within), color="quiet", dashed=True)
    canvas.arrow(at(*within), at(*mirrored), color="quiet", dashed=True)
    canvas.arrow(at(0, 0), at(*mirrored), color="good", width="thick")
    for part in (-0.5, 0.5):
        canvas.text(at(D[0], part * mirrored[1]), "$-(N · d) N$", "e", color="quiet")
    canvas.text(at(-D[0] / 2, -D[1] / 2), "$d$", "sw", color="ray", gap=5)
    canvas.text(at(D[0] / 2, D[1] / 2), "$d$", "sw", color="ray", gap=5)
    canvas.text(at(mirrored[0] / 2, mirrored[1] / 2), "$r$", "nw", color="good", gap=5)
