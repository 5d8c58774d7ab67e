"""Four lanes in a loop: a while makes a round in which nobody does anything."""

ALT = ("Four rays side by side in a loop, with 3, 1, 2 and 3 tests. With while the loop makes four rounds, and in the last one no lane is at "
       "work; with if and do-while it makes three")
HEIGHT = 236
SENTENCES = ["In the drawing four rays have 3, 1, 2 and 3 tests to make. With `while` the loop makes 4 rounds, the last one for nobody; "
             "with `if` and `do ... while` it makes 3."]

TESTS = (3, 1, 2, 3)


def draw(canvas, _lesson):
    for left, name, rounds in ((30, "while", max(TESTS) + 1), (320, "if, do ... while", max(TESTS))):
        canvas.text((left + 26 * rounds, 24), name, title=True)
        for row, tests in enumerate(TESTS):
            for number in range(rounds):
                is_busy = number < tests
                is_lost = number >= max(TESTS)
                canvas.box(left + 52 * number, 42 + 36 * row, 44, 26, color="wrong" if is_lost else "ray" if is_busy else "rule",
                           filled=is_busy or is_lost, dashed=not is_busy)
        canvas.text((left + 26 * rounds, 212), f"{rounds} rounds", color="quiet")
