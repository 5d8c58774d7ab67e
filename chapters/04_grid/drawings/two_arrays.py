"""How the two arrays of a grid are made: count, add up, fill from the end, sort."""

ALT = (
    "Three cells and the triangles a, b, c in them: cell 0 has a, cell 1 has a and b, cell 2 has b "
    "and c. Counted they have 1, 2, 2 references; added up 1, 3, 5, where the lists end; each "
    "reference goes before the last one of its cell, and the ends move down to 0, 1, 3, where the "
    "lists start"
)
HEIGHT = 470
SENTENCES = [
    "In the drawing cells 0, 1 and 2 hold 1, 2 and 2 references. The lists end before 1, 3 and 5; "
    "each reference moves its end down by one, and when all five are in, the same three numbers "
    "are 0, 1 and 3: the starts. A fourth, 5, ends the last list.",
]

CELLS = (("a",), ("a", "b"), ("b", "c"))
TRIANGLES = "abc"
LEFT, STEP, WIDE = 212, 58, 58


def build():
    """The counts, the ends, the array after filling, and the ends then, as build_grid.cpp makes them."""
    counts = [len(cell) for cell in CELLS]
    ends = [sum(counts[: i + 1]) for i in range(len(counts))]
    moved, references = list(ends), [""] * sum(counts)
    for triangle in TRIANGLES:
        for number, cell in enumerate(CELLS):
            if triangle in cell:
                moved[number] -= 1
                references[moved[number]] = triangle
    return counts, ends, references, moved


def draw(canvas, _lesson):
    counts, ends, references, starts = build()

    def middle(place):
        return LEFT + STEP * place

    def row(y, words, color="ink"):
        canvas.text((14, y), words, "e", gap=0, color=color)

    cells_top = 26
    for number in range(3):
        left = 212 + number * 97
        canvas.box(left, cells_top, 96, 78, color="shape")
        canvas.text((left + 86, cells_top + 64), str(number), "w", gap=0, color="quiet")
    for letter, at, wide in (("a", (258, 48), 92), ("b", (356, 74), 90), ("c", (450, 46), 42)):
        x, y = at
        canvas.area((x, y + 14), (x + wide, y + 6), (x + wide * 0.5, y - 14), color="ray")
        canvas.text((x + wide * (0.36 if letter == "a" else 0.62 if letter == "b" else 0.5), y + 4), f"${letter}$", color="ray", halo=False)
    row(65, "the cells")
    for y, words, numbers in ((140, "count", counts), (190, "add up: the ends", ends)):
        row(y, words)
        for number, value in enumerate(numbers):
            canvas.box(212 + number * 97 + 28, y - 17, 40, 34, str(value), color="shape", filled=True)
    top = 300
    row(252, "fill")
    row(top + 17, "references")
    for place, letter in enumerate(references):
        canvas.box(LEFT + place * WIDE, top, WIDE, 34, letter, color="ray", filled=True)
    for number, (start, end) in enumerate(zip(starts, ends)):
        color = ("shape", "good", "wrong")[number]
        canvas.line((middle(start) + 2, top - 8), (middle(end) - 2, top - 8), color=color, width="thick")
        canvas.bow(
            (middle(end) - 6, top - 16),
            ((middle(start) + middle(end)) / 2, top - 52),
            (middle(start) + 6, top - 14),
            color=color,
        )
    row(372, "the ends, now starts")
    for number, start in enumerate([*starts, len(references)]):
        x = middle(start)
        canvas.arrow((x, 358), (x, top + 38), color="shape")
        canvas.text((x, 372), str(start), color="shape")
    row(432, "sort each list")
    lists = [sorted(references[start:end]) for start, end in zip(starts, ends)]
    for place, letter in enumerate(letter for one in lists for letter in one):
        canvas.box(LEFT + place * WIDE, 415, WIDE, 34, letter, color="good", filled=True)
