"""The same list of rays in rows and in blocks, and the rays that eight lanes take."""

ALT = ("A list of rays in a texture. Left, row by row: the lanes of one block of 4 x 2 texels take four rays from the beginning of the list, and "
       "four from a place far behind. Right, along a curve of the shape of a Z: the same lanes take the first eight rays of the list")
HEIGHT = 300
SENTENCES = ["In rows of 1,024 the lanes of a block of 4 x 2 texels take the rays 0 to 3 and the rays 1,024 to 1,027.",
             "In blocks they take the rays 0 to 7, and the curve goes on so to ray 63."]

SIDE = 25


def place(ray):
    column = (ray & 1) | (ray >> 1 & 2) | (ray >> 2 & 4)
    row = (ray >> 1 & 1) | (ray >> 2 & 2) | (ray >> 3 & 4)
    return column, row


def draw(canvas, _lesson):
    bottom = 258
    for left, name in ((70, "in rows"), (318, "in blocks")):
        canvas.text((left + 4 * SIDE, 24), name, title=True)
        for number in range(9):
            canvas.line((left + SIDE * number, bottom - 8 * SIDE), (left + SIDE * number, bottom), color="rule")
            canvas.line((left, bottom - SIDE * number), (left + 8 * SIDE, bottom - SIDE * number), color="rule")
        for lane in range(8):
            canvas.box(left + SIDE * (lane % 4), bottom - SIDE * (lane // 4 + 1), SIDE, SIDE, color="ray", filled=True)

    def center(left, column, row):
        return (left + SIDE * (column + 0.5), bottom - SIDE * (row + 0.5))

    for row in range(8):
        canvas.arrow(center(70, 0, row), center(70, 7.4, row), color="shape")
    canvas.line(*(center(318, *place(ray)) for ray in range(64)), color="shape")
    canvas.text((62, bottom - SIDE / 2), "0", "w", gap=0, color="quiet")
    canvas.text((62, bottom - 3 * SIDE / 2), "1,024", "w", gap=0, color="quiet")
    canvas.text((310, bottom - SIDE / 2), "0", "w", gap=0, color="quiet")
    canvas.text((318 + 8 * SIDE + 8, bottom - 7.5 * SIDE), "63", "e", gap=0, color="quiet")
    canvas.text((170, 284), "a block of 4 x 2 lanes", color="ray")
    canvas.text((418, 284), "the same lanes", color="ray")
