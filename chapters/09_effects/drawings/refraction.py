"""A ray from air into glass, and rays within glass up to the angle of total reflection."""

import math

from drawings.places import Flat

ALT = (
    "Left: a ray comes from air to glass at 60 degrees to the normal; 8.9 percent of its light is "
    "reflected, the rest goes on at 35.3 degrees. Right: three rays within glass; at 30 degrees "
    "most goes out, at 41.81 degrees what goes out grazes the surface, and beyond it all is "
    "reflected"
)
HEIGHT = 330
SENTENCES = [
    "In the drawing a ray meets glass at 60 degrees, from n = 1 to n' = 1.5: 8.9 % of it is "
    "reflected, and the rest goes on at 35.3 degrees. Within glass, at 30 degrees most of it "
    "leaves, and at 41.81 what leaves grazes the surface.",
]

AIR, GLASS = 1.0, 1.5
MOVES = ("{} degrees from the normal", range(10, 86, 5), 60)


def refracted(degrees, before, behind):
    """By Snell; None where the reflection is total."""
    sine = before * math.sin(math.radians(degrees)) / behind
    return math.degrees(math.asin(sine)) if sine < 1 else None


def reflected_part(degrees, before, behind):
    """By Fresnel, as shaders/light/fresnel.glsl has it."""
    inner = refracted(degrees, before, behind)
    if inner is None:
        return 1.0
    c, d = math.cos(math.radians(degrees)), math.cos(math.radians(inner))
    return 0.5 * (
        ((before * c - behind * d) / (before * c + behind * d)) ** 2
        + ((before * d - behind * c) / (before * d + behind * c)) ** 2
    )


def draw(canvas, _lesson, coming):
    left, right = Flat(140, 168, 1), Flat(424, 168, 1)

    def end(at, degrees, length, up, side):
        angle = math.radians(degrees)
        return at(side * length * math.sin(angle), (1 if up else -1) * length * math.cos(angle))

    for at, wide in ((left, 122), (right, 126)):
        canvas.area(at(-wide, 0), at(wide, 0), at(wide, -150), at(-wide, -150), color="shape", outlined=False)
        canvas.line(at(-wide, 0), at(wide, 0), color="shape", width="thick")
    canvas.line(left(0, 120), left(0, -130), color="quiet", dashed=True, width="thin")
    going = refracted(coming, AIR, GLASS)
    part = reflected_part(coming, AIR, GLASS)
    canvas.arrow(end(left, coming, 130, True, -1), left(0, 0), color="ray", width="thick")
    canvas.arrow(left(0, 0), end(left, going, 140, False, 1), color="ray", width="thick")
    canvas.arrow(left(0, 0), end(left, coming, 100, True, 1), color="good")
    canvas.text(end(left, coming / 2, 52, True, -1), f"{coming}°", color="ray")
    canvas.text(end(left, going / 2, 86, False, 1), f"{going:.1f}°", color="ray")
    canvas.text(end(left, coming, 100, True, 1), f"{100 * part:.1f} %", "n", color="good", gap=5)
    canvas.text(left(-118, 108), "$n$ = 1", "e", gap=0, color="quiet")
    canvas.text(left(-112, -136), "$n'$ = 1.5", "e", gap=0, color="shape")
    critical = math.degrees(math.asin(AIR / GLASS))
    source = (0, -132)
    for degrees, color in ((30, "ray"), (critical, "good"), (55, "wrong")):
        foot = -112 + 132 * math.tan(math.radians(degrees))
        start, meets = right(-112, source[1]), right(foot, 0)
        canvas.arrow(start, meets, color=color, width="thick")
        going = refracted(degrees, GLASS, AIR) if degrees < critical else None
        if going is not None:
            canvas.arrow(
                meets,
                (
                    meets[0] + 110 * math.sin(math.radians(going)),
                    meets[1] - 110 * math.cos(math.radians(going)),
                ),
                color=color,
            )
        elif degrees < 50:
            canvas.arrow(meets, right(foot + 74, 3), color=color)
        else:
            canvas.arrow(meets, right(foot + 46, -46 / math.tan(math.radians(degrees))), color=color)
    canvas.text(right(-20, 100), "30°: leaves", "e", gap=0, color="ray")
    canvas.text(right(16, 28), f"{critical:.2f}°: grazes", "e", gap=0, color="good")
    canvas.text(right(40, -96), "total", "c", color="wrong")
