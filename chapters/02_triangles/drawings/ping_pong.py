"""Three launches, which read one set of textures and write the other."""

ALT = (
    "Three launches one after the other: the first reads set A and writes set B, the second reads "
    "B and writes A, the third reads A and writes B; each goes on where the one before stopped, at "
    "triangle 2,048 and at 4,096"
)
HEIGHT = 250
SENTENCES = [
    "In the drawing the second goes on at triangle 2,048, the third at 4,096, and each starts with "
    "what the one before has left.",
]

ROUNDS = 2048


def draw(canvas, _lesson):
    canvas.text((16, 62), "A", "e", gap=0, color="shape")
    canvas.text((16, 192), "B", "e", gap=0, color="good")
    for number in range(4):
        x = 46 + number * 142
        for top, color, is_read in ((36, "shape", number % 2 == 0), (166, "good", number % 2 == 1)):
            canvas.box(
                x,
                top,
                68,
                52,
                "hits,\nplaces" if is_read else "",
                color=color if is_read else "rule",
                filled=is_read,
                dashed=not is_read,
            )
    for number in range(3):
        down = number % 2 == 0
        x, y = 46 + number * 142, 88 if down else 166
        canvas.arrow((x + 34, y), (x + 34 + 142 - 10, 166 - 4 if down else 88 + 4), color="ray", width="thick")
        canvas.box(x + 66, 108, 80, 40, "launch", color="ray", filled=True)
    for number in range(4):
        x = 46 + number * 142 + 34
        canvas.text(
            (x, 18 if number % 2 == 0 else 234),
            f"from {number * ROUNDS:,}" if 0 < number < 3 else ("" if number else "a miss"),
            color="quiet",
        ) if number < 3 else None
