"""A triangle with the lines of equal u and of equal v, and the way from a to the hit."""

from drawings.places import between

ALT = (
    "A triangle a, b, c that a ray from o meets: from a, half of the edge e1 and then a quarter of "
    "the edge e2 lead to the hit, so u = 0.5 and v = 0.25; u is 0 on the side a c, v on a b, and u "
    "+ v is 1 on b c"
)
HEIGHT = 340
SENTENCES = [
    "In the drawing u = 0.5 and v = 0.25: half of e_1 and a quarter of e_2 lead from a to the hit, "
    "and a itself weighs 0.25.",
    "The ray hits the triangle if no weight is negative, u \\ge 0, v \\ge 0, u + v \\le 1",
]

A, B, C = (110, 285), (480, 252), (205, 58)
U, V = 0.5, 0.25


def at(u, v):
    """The mixture of the corners."""
    return tuple((1 - u - v) * a + u * b + v * c for a, b, c in zip(A, B, C))


def draw(canvas, _lesson):
    canvas.area(A, B, C)
    for part in (0.25, 0.5, 0.75):
        canvas.line(at(part, 0), at(part, 1 - part), color="shape", width="thin")
        canvas.line(at(0, part), at(1 - part, part), color="shape", width="thin")
    hit = at(U, V)
    origin, beyond = (545, 62), between((545, 62), hit, 1.32)
    canvas.line(hit, beyond, color="ray", dashed=True)
    canvas.arrow(A, at(1, 0), color="ink")
    canvas.arrow(A, at(0, 1), color="ink")
    canvas.arrow(A, at(U, 0), color="good", width="thick")
    canvas.arrow(at(U, 0), hit, color="good", width="thick")
    canvas.arrow(origin, hit, color="ray", width="thick")
    canvas.point(origin, "$o$", "nw", color="ray")
    canvas.text(between(origin, hit, 0.4), "$d$", "nw", color="ray", gap=4)
    canvas.point(A, "$a$", "w")
    canvas.point(B, "$b$", "e")
    canvas.point(C, "$c$", "n")
    canvas.point(hit, color="ray", radius=5.5)
    canvas.text(at(U / 2, 0), f"$u e_1$, $u$ = {U:g}", "s", color="good", gap=12)
    canvas.text(at(U, V / 2), f"$v e_2$, $v$ = {V:g}", "e", color="good", gap=10)
    canvas.text(at(0.72, 0), "$v$ = 0", "s", color="shape", gap=12)
    canvas.text(at(0, 0.55), "$u$ = 0", "w", color="shape", gap=12)
    canvas.text(at(0.3, 0.7), "$u + v$ = 1", "ne", color="shape", gap=8)
    canvas.text(at(0.95, 0), "$e_1$", "s", gap=10)
    canvas.text(at(0, 0.93), "$e_2$", "w", gap=10)
