"""A picture of 4 x 3 pixels on the view rectangle: where the ray of a pixel goes through."""

from drawings.places import Flat

ALT = (
    "A view rectangle of 4 columns and 3 rows of pixels, each with its centre; the lower left "
    "pixel is the first, and the ray of the pixel in column 2 and row 1 goes through s = 0.625, t "
    "= 0.5"
)
HEIGHT = 342
SENTENCES = [
    "In the drawing, a picture of 4 x 3 pixels, the pixel in column 2 and row 1 has s = 2.5/4 = "
    "0.625 and t = 1.5/3 = 0.5.",
    "It is (0.5, 0.5) in the first pixel, not (0, 0).",
    "each from 0 to 1, has the direction",
]

COLUMNS, ROWS = 4, 3
MOVES = ("pixel {}, counted from the lower left", range(COLUMNS * ROWS), 6)


def draw(canvas, _lesson, pixel):
    row, column = divmod(pixel, COLUMNS)
    at = Flat(96, 296, 84)
    for x in range(COLUMNS + 1):
        canvas.line(at(x, 0), at(x, ROWS), color="shape", width="thin")
    for y in range(ROWS + 1):
        canvas.line(at(0, y), at(COLUMNS, y), color="shape", width="thin")
    canvas.area(at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1), color="ray")
    canvas.line(at(0, 0), at(COLUMNS, 0), at(COLUMNS, ROWS), at(0, ROWS), color="shape", closed=True)
    s, t = (column + 0.5) / COLUMNS, (row + 0.5) / ROWS
    target = at(column + 0.5, row + 0.5)
    canvas.line(at(column + 0.5, 0), target, at(0, row + 0.5), color="ray", dashed=True, width="thin")
    for x in range(COLUMNS):
        for y in range(ROWS):
            if (x, y) != (column, row):
                canvas.point(at(x + 0.5, y + 0.5), color="shape", radius=3.5)
    canvas.point(at(0, 0), "$**ℓ**$", "sw", color="good")
    canvas.point(target, color="ray", radius=5.5)
    canvas.text(at(0.5, 0.5), "(0.5, 0.5)", "s", color="quiet", gap=4)
    canvas.axis(
        at(0, 0),
        at(COLUMNS + 0.55, 0),
        "$s$",
        [(at(column + 0.5, 0), f"$s$ = {s:g}"), (at(COLUMNS, 0), "1" if column + 1 < COLUMNS else "")],
    )
    canvas.axis(
        at(0, 0),
        at(0, ROWS + 0.35),
        "$t$",
        [(at(0, row + 0.5), f"$t$ = {t:.3g}"), (at(0, ROWS), "1")],
        side="w",
        end_side="e",
    )
    canvas.text(at(COLUMNS + 0.25, row + 0.5), f"column {column}\nrow {row}", "e", color="ray", gap=4)
    canvas.arrow(at(COLUMNS + 0.25, row + 0.5), at(column + 0.62, row + 0.5), color="ray", width="thin")
