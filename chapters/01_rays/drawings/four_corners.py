"""The rasterizer's way: four rays at the corners, two triangles, and what lies in between."""

from drawings.places import Flat

ALT = (
    "A rectangle with a ray at each corner, drawn as two triangles with a diagonal between them: "
    "the rasterizer mixes the corners' values at each pixel's centre, in each triangle from three "
    "of them"
)
HEIGHT = 290
SENTENCES = [
    "So the paper computes the rays only in the four corners.",
    "with s and t 0 or 1",
]


def draw(canvas, _lesson):
    at = Flat(130, 236, 58)
    wide, high = 5, 3
    canvas.area(at(0, 0), at(wide, 0), at(wide, high), color="shape", outlined=False)
    canvas.area(at(0, 0), at(wide, high), at(0, high), color="good", outlined=False)
    for x in range(wide):
        for y in range(high):
            canvas.point(at(x + 0.5, y + 0.5), color="quiet", radius=2.5)
    canvas.line(at(0, 0), at(wide, 0), at(wide, high), at(0, high), closed=True)
    canvas.line(at(0, 0), at(wide, high), color="ink")
    for x, y in ((0, 0), (wide, 0), (wide, high), (0, high)):
        place = at(x, y)
        outwards = (28 if x else -28, -18 if y else 18)
        canvas.arrow(place, (place[0] + outwards[0], place[1] + outwards[1]), color="ray", width="thick")
        canvas.point(place, color="ray", radius=6)
        canvas.text(
            (place[0] + outwards[0], place[1] + outwards[1]),
            f"$s$ = {x // wide}\n$t$ = {y // high}",
            "e" if x else "w",
            color="ray",
            gap=8,
        )
    target = at(3.5, 1.5)
    for corner in ((0, 0), (wide, 0), (wide, high)):
        canvas.line(target, at(*corner), color="ray", dashed=True, width="thin")
    canvas.point(target, color="ray", radius=6)
