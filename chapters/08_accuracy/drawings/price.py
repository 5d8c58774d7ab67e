"""What a triangle test takes, and whether it leaks: five rows of a table of this lesson."""

ALT = (
    "Bars of the nanoseconds that five triangle tests take, each with its faults in a million rays "
    "that are aimed at vertices: Moeller-Trumbore is the fastest and has most, in the two "
    "watertight tests none was found, of which exact areas take longest, and Moeller-Trumbore in "
    "double has some all the same"
)
HEIGHT = 292
SENTENCES = []
HEADING = "| triangle test | ns per ray | edge | vertex | far | t: 99 %, worst family, ulp | slivers, worst family |"
TESTS = (
    "Moeller-Trumbore",
    "Plücker",
    "watertight, rounded",
    "watertight, exact areas",
    "Moeller-Trumbore in double",
)


def number(cell):
    return float(cell.replace(",", ""))


def draw(canvas, lesson):
    rows = [lesson.row(HEADING, test) for test in TESTS]
    most = max(number(row[1]) for row in rows)
    canvas.text((14, 22), "test, and ns per ray", "e", gap=0, color="quiet")
    canvas.text((546, 22), "faults in a million", "w", gap=0, color="quiet")
    for i, row in enumerate(rows):
        y = 44 + 50 * i
        color = "good" if row[3].startswith("<") else "wrong"
        canvas.text((14, y + 6), row[0], "e", gap=0, color=color)
        width = 330 * number(row[1]) / most
        canvas.box(14, y + 18, width, 14, color=color, filled=True)
        canvas.text((14 + width, y + 25), row[1], "e", color=color, gap=8)
        canvas.text((546, y + 18), row[3], "w", gap=0, color=color)
