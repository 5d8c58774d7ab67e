"""Four rays side by side, one of which is none."""

ALT = (
    "A packet of four rays, as four boxes beside each other. The second holds NaN: any answer is right there. The "
    "other three must hit what they hit alone, however the four are traced"
)
HEIGHT = 176
SENTENCES = ["any answer is right, but the rays beside it must keep theirs"]


def draw(canvas, _lesson):
    for i, (words, color) in enumerate((("a hit", "good"), ("any answer", "wrong"), ("a miss", "good"), ("a hit", "good"))):
        left = 22 + 132 * i
        canvas.box(left, 24, 120, 48, "NaN" if i == 1 else "a ray", color="wrong" if i == 1 else "ray", filled=True)
        canvas.arrow((left + 60, 78), (left + 60, 116), color="quiet")
        canvas.text((left + 60, 142), words, color=color)
