"""To scale: a triangle a little behind a plane, its computed hit a little before it, and the padding."""

from drawings.places import Flat

ALT = (
    "To scale: a triangle lies just behind a plane of the grid. Its computed hit may lie 23 eM "
    "from it, and the plane's crossing be 2 eM off, together 25 eM: so the hit seems to lie in the "
    "cell before the plane. The cell grown by 32 eM reaches the triangle, and lists it"
)
HEIGHT = 300
SENTENCES = [
    "| a hit of the watertight test lies from its triangle at most | $23\\,eM$ |",
    "| together | $25\\,eM$ |",
    "| the crossing of a plane is rounded twice | $2\\,eM$ |",
    "$32\\,eM$",
]

HIT, PLANE, PADDING = 23, 2, 32


def draw(canvas, _lesson):
    at = Flat(158, 0, 7)
    plane, triangle = at(0, 0)[0], at(HIT - 5, 0)[0]
    hit = at(-5, 0)[0]
    grown = at(PADDING, 0)[0]
    canvas.area((20, 50), (plane, 50), (plane, 222), (20, 222), color="shape", outlined=False)
    canvas.area((plane, 50), (grown, 50), (grown, 222), (plane, 222), color="good", outlined=False)
    canvas.line((plane, 36), (plane, 236), color="shape", width="thick")
    canvas.line((grown, 44), (grown, 228), color="good", dashed=True)
    canvas.line((triangle - 4, 64), (triangle + 12, 206), color="ink", width="thick")
    y = 136
    canvas.arrow((20, y - 20), (triangle + 140, y + 10), color="ray")
    place = (triangle + 4, y + 2)
    canvas.point(place, hollow=True)
    canvas.point((hit, y - 12), color="ray", radius=6)
    canvas.text((hit, y - 12), "computed", "nw", color="ray", gap=6)
    canvas.text((28, 204), "the ray's cell", "e", gap=0, color="shape")
    canvas.text((triangle + 14, 196), "triangle", "e", gap=6)
    canvas.text((plane, 22), "plane", color="shape")
    canvas.measure((hit, 84), (hit + HIT * 7, 84), f"{HIT} $eM$", "n", color="ray")
    canvas.measure((plane, 256), (grown, 256), f"{PADDING} $eM$: padding", "s", color="good")
    canvas.text(
        (grown + 12, 80),
        f"it is off by\nat most\n{HIT} + {PLANE} = {HIT + PLANE} $eM$",
        "e",
        color="ray",
        gap=0,
    )
