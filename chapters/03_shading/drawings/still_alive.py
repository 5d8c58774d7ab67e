"""How many paths live before each bounce: bars whose areas are the rays that are traced."""

ALT = (
    "Bars of the paths that live: 65,536 camera rays, 25,761 after the first bounce, 3,762 after "
    "the second, and hardly any after that"
)
HEIGHT = 220
SENTENCES = [
    "`./run.sh 03 --size 256x256` follows 65,536 camera rays in the scene `mirrors`.",
    "The second bounce concerns 3,762 of 65,536 paths.",
]
HEADING = "| `--max-bounces` | shadow rays | mirror rays |"


def draw(canvas, lesson):
    traced = [int(lesson.row(HEADING, bounces)[2].replace(",", "")) for bounces in ("0", "1", "2", "3")]
    living = [65536] + [after - so_far for so_far, after in zip(traced, traced[1:])]
    for number, count in enumerate(living):
        y = 24 + 46 * number
        wide = max(350 * count / living[0], 1.5)
        canvas.text((14, y + 15), ("camera", "bounce 1", "bounce 2", "bounce 3")[number], "e", gap=0)
        canvas.box(110, y, wide, 30, color="ray" if number else "shape", filled=True)
        if number < 3:
            canvas.text((110 + wide, y + 15), f"{count:,}", "e", color="ray" if number else "shape")
