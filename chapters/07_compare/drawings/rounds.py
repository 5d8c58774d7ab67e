"""Rounds in turn, and what is left of them: the medians and ranges of a table of this lesson."""

from drawings.places import Flat

ALT = (
    "Above: something slows the machine for a while. One after the other, it falls on one "
    "contender alone; in turn, on a round of each. The first round is dropped. Below: the build "
    "times of two builders in five scenes, each a median with its range; the medians differ, and "
    "all ranges overlap"
)
HEIGHT = 608
SENTENCES = []
HEADING = "| scene | triangles | ours, ns per triangle | `rtcBuildBVH` | ratio | cost over a full sweep's |"
SCENES = ("bunny", "knot:10", "knot:31", "stadium:2", "soup")


def median_and_range(cell):
    """Of `651 (567-701)`."""
    median, lowest, highest = cell.replace("(", " ").replace(")", " ").replace("-", " ").split()
    return int(median), int(lowest), int(highest)


def timeline(canvas, top, contenders, dropped):
    width = 36
    for number, name in enumerate(contenders):
        left = 128 + number * (width + 6)
        color = "shape" if name == "A" else "good"
        canvas.box(
            left,
            top,
            width,
            34,
            name,
            color="quiet" if dropped(number) else color,
            filled=not dropped(number),
            dashed=dropped(number),
        )


def draw(canvas, lesson):
    slow = (128 + 6 * 42 - 3, 128 + 8 * 42 - 3)
    canvas.area((slow[0], 34), (slow[1], 34), (slow[1], 150), (slow[0], 150), color="wrong", outlined=False)
    canvas.text(((slow[0] + slow[1]) / 2, 20), "slowed", color="wrong")
    canvas.text((14, 65), "one by one", "e", gap=0)
    canvas.text((14, 121), "in turn", "e", gap=0)
    timeline(canvas, 48, "AAAAABBBBB", lambda number: False)
    timeline(canvas, 104, "ABABABABAB", lambda number: number < 2)
    canvas.text((167, 160), "dropped", color="quiet")
    canvas.text(((slow[0] + slow[1]) / 2, 166), "a round of each", color="wrong")

    rows = {scene: [median_and_range(cell) for cell in lesson.row(HEADING, scene)[2:4]] for scene in SCENES}
    numbers = [number for row in rows.values() for one in row for number in one]
    low, high = min(numbers) - 20, max(numbers) + 20
    at = Flat(150, 0, 370 / (high - low))
    canvas.line((8, 192), (552, 192), color="rule")
    canvas.text((150, 214), "ours", "e", gap=0, color="shape")
    canvas.text((214, 214), "Embree's", "e", gap=0, color="good")
    canvas.text((540, 214), "ns per triangle", "w", gap=0, color="quiet")
    for number, (scene, pair) in enumerate(rows.items()):
        y = 258 + 74 * number
        canvas.text((14, y), scene, "e", gap=0)
        overlap = max(one[1] for one in pair), min(one[2] for one in pair)
        a, b = (at(value - low, 0)[0] for value in overlap)
        canvas.area((a, y - 26), (b, y - 26), (b, y + 26), (a, y + 26), color="quiet", outlined=False)
        for (median, lowest, highest), color, offset, side in zip(pair, ("shape", "good"), (-9, 9), ("n", "s")):

            def place(value, offset=offset, y=y):
                return (at(value - low, 0)[0], y + offset)

            canvas.line(place(lowest), place(highest), color=color)
            for end in (lowest, highest):
                canvas.line((place(end)[0], y + offset - 5), (place(end)[0], y + offset + 5), color=color)
            canvas.point(place(median), str(median), side, color=color, radius=5)
