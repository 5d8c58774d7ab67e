"""A ray that Moeller-Trumbore loses between two triangles, computed in floats, and what the sheared areas say."""

import math

from drawings.floats import cross_product, difference, dot_product, product, rounded
from drawings.places import Flat, beside

ALT = (
    "Two triangles with the common edge p q, seen along a ray that meets the edge. By "
    "Moeller-Trumbore each finds u + v = 1 + 2^-23, so neither is hit, and the ray slips through. "
    "By the sheared areas the one finds E(p, q) = 2^-24, the other E(q, p) = -2^-24, and one of "
    "them is hit"
)
HEIGHT = 354
SENTENCES = [
    "A ray from 0 at a point of it, 0.4 of the way from p = (0, 1, 5) to q = (1, -2, 3): both "
    "triangles find u + v = 1 + 2^{-23}, which is over 1.",
    "In the drawing E(p, q) = 2^{-24} for the one and E(q, p) = -2^{-24} for the other: only for "
    "the other, all three signs are equal.",
]

P, Q, LEFT, RIGHT = (0.0, 1.0, 5.0), (1.0, -2.0, 3.0), (-2.0, -1.0, 4.0), (2.0, 1.0, 4.0)
PART = 0.4
ORIGIN = (0.0, 0.0, 0.0)
DIRECTION = tuple(rounded(p + PART * (q - p)) for p, q in zip(P, Q))


def moeller_trumbore(a, b, c):
    """u and v, rounded as the shader rounds them."""
    e1, e2 = difference(b, a), difference(c, a)
    p = cross_product(DIRECTION, e2)
    to_origin = difference(ORIGIN, a)
    q = cross_product(to_origin, e1)
    det = dot_product(p, e1)
    return rounded(dot_product(p, to_origin) / det), rounded(dot_product(q, DIRECTION) / det)


def sheared(corner):
    x, y, z = difference(corner, ORIGIN)
    shear = [rounded(part / DIRECTION[2]) for part in DIRECTION[:2]]
    return rounded(x - product(shear[0], z)), rounded(y - product(shear[1], z))


def area(p, q):
    """E(p, q) of two sheared corners."""
    return rounded(product(p[0], q[1]) - product(p[1], q[0]))


def power_of_two(x):
    """2^{-24} for that number, where it is a power of two or minus one."""
    power = round(math.log2(abs(x)))
    assert abs(x) == 2.0**power, x
    return f"${'-' if x < 0 else ''}2^{{{power}}}$"


def draw(canvas, _lesson):
    for corners in ((LEFT, P, Q), (RIGHT, Q, P)):
        u, v = moeller_trumbore(*corners)
        assert rounded(u + v) == 1.0 + 2.0**-23
    p, q, left, right = map(sheared, (P, Q, LEFT, RIGHT))
    assert (
        not max(area(left, p), area(p, q), area(q, left)) <= 0 < max(area(right, q), area(q, p), area(p, right))
    )

    for at, gap in ((Flat(165, 150, 56), 7), (Flat(440, 150, 56), 0)):
        for third, ends, color, side in ((left, (p, q), "shape", 1), (right, (p, q), "good", -1)):
            a, b = beside(at(*ends[0]), at(*ends[1]), -gap * side)
            c = at(*third)
            canvas.area(a, b, (c[0] - gap * side, c[1]), color=color)
        if not gap:
            canvas.line(at(*p), at(*q), width="thick")
        canvas.point(at(*p), "$p$", "n", radius=4 if not gap else 0)
        canvas.point(at(*q), "$q$", "s", radius=4 if not gap else 0)
        canvas.point(at(0, 0), color="ray", radius=6)
    canvas.text((150, 26), "each rounds by itself", title=True)
    canvas.text((425, 26), "the same two corners", title=True)
    canvas.text((150, 300), "both: $u + v$ = $1 + 2^{-23}$", color="wrong")
    canvas.text((150, 328), "the ray slips through", color="wrong")
    canvas.text((425, 300), f"$E(p, q)$ = {power_of_two(area(p, q))}: no", color="shape")
    canvas.text((425, 328), f"$E(q, p)$ = {power_of_two(area(q, p))}: hit", color="good")
