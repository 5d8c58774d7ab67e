"""Four rays side by side: each round is one for all of them, until the last one is through."""

ALT = (
    "Four rays side by side in the lanes of a vector, with 3, 7, 2 and 4 tests. A round is one for "
    "all of them, so the cell takes 7 rounds, and 12 of the 28 places are idle"
)
HEIGHT = 250
SENTENCES = [
    "In the drawing four rays have 3, 7, 2 and 4 tests to make: side by side they take 7 rounds, "
    "and 12 of the 28 places are idle.",
]

TESTS = (3, 7, 2, 4)


def draw(canvas, _lesson):
    rounds = max(TESTS)
    idle = sum(rounds - tests for tests in TESTS)
    for row, tests in enumerate(TESTS):
        y = 44 + 40 * row
        canvas.text((20, y + 15), "ray", "e", gap=0, color="quiet")
        canvas.text((492, y + 15), f"{tests} tests", "e", gap=0, color="ray")
        for number in range(rounds):
            is_busy = number < tests
            canvas.box(
                66 + 60 * number,
                y,
                52,
                30,
                color="ray" if is_busy else "rule",
                filled=is_busy,
                dashed=not is_busy,
            )
    canvas.text((66 + 60 * rounds / 2 - 4, 22), f"{rounds} rounds", color="quiet")
    canvas.text((66 + 60 * rounds / 2 - 4, 226), f"idle: {idle} of {rounds * len(TESTS)}", color="quiet")
