"""Three rulers of the same length, cut where floats lie: from 1, from 4 and from 16 on."""

from drawings.floats import ulp
from drawings.places import Flat

ALT = (
    "Three rulers of the same length: floats from 1 on lie 2^-23 apart, from 4 on four times as "
    "far, from 16 on sixteen times as far; an exact number between two of them moves by at most "
    "half an ulp when it is rounded"
)
HEIGHT = 282
SENTENCES = [
    "From 1 to 2 an ulp is 2^{-23}, from 4 to 8 it is 2^{-21}, and from 16 to 32 it is 2^{-19}: "
    "the three rulers of the drawing are equally long, 2^{-18}.",
]

LENGTH = 2.0**-18
STARTS = (1, 4, 16)


def draw(canvas, _lesson):
    for row, start in enumerate(STARTS):
        at = Flat(92, 62 + 78 * row, 380 / LENGTH)
        step = ulp(start)
        count = round(LENGTH / step)
        power = {1: "-23", 4: "-21", 16: "-19"}[start]
        canvas.line(at(0, 0), at(LENGTH, 0))
        for i in range(count + 1):
            x, y = at(i * step, 0)
            tall = 9 if start > 1 else 6
            canvas.line((x, y - tall), (x, y + tall), color="shape", width="thin" if count > 8 else "")
        canvas.text((at(0, 0)[0] - 14, at(0, 0)[1]), str(start), "w")
        x, y = at(LENGTH, 0)
        canvas.text((x + 14, y), f"$2^{{{power}}}$", "e", color="shape")
    coarse = ulp(STARTS[-1])
    exact, kept = at(0.68 * coarse, 0), at(coarse, 0)
    canvas.point(exact, color="ray", radius=5.5)
    canvas.bow(
        (exact[0] + 3, exact[1] - 8),
        ((exact[0] + kept[0]) / 2, exact[1] - 34),
        (kept[0] - 3, kept[1] - 10),
        color="ray",
    )
    canvas.text((exact[0] + 6, exact[1]), "exact", "sw", color="ray", gap=14)
    canvas.text((kept[0] - 6, kept[1]), "rounded: at most\nhalf an ulp away", "se", color="shape", gap=14)
    canvas.text((at(LENGTH, 0)[0] + 22, 24), "one ulp", "c", color="shape")
    canvas.text((60, 24), "from", "c")
    left, right = at(coarse, 0), at(2 * coarse, 0)
    canvas.measure((left[0] + 6, left[1] - 24), (right[0] - 6, right[1] - 24), "one ulp")
