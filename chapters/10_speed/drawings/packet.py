"""Four neighbouring rays as one packet, and one look at each node for all of them."""

from drawings.places import Flat

ALT = (
    "Left, four neighbouring pixels whose rays go nearly the same way through a box. Right, one by "
    "one each ray fetches the same node, four times; as a packet of 2 x 2 the node is fetched "
    "once, and four rays are held against it"
)
HEIGHT = 300
SENTENCES = [
    "A packet of 2 x 2 rays fetches a node once where four rays fetch it 4 times, so the drawing "
    "has 1 fetch in place of 4.",
]


def draw(canvas, _lesson):
    at = Flat(24, 190, 1)
    pixels = [(0, 0), (46, 14), (0, 50), (46, 64)]
    for x, y in pixels:
        canvas.area(at(x, y), at(x + 46, y + 14), at(x + 46, y + 64), at(x, y + 50), color="shape")
    canvas.area(at(150, -40), at(216, -14), at(216, 128), at(150, 102), color="quiet")
    for x, y in pixels:
        start = (x + 23, y + 32)
        canvas.arrow(at(*start), at(start[0] * 0.86 + 206, start[1] * 1.16 - 4), color="ray")
        canvas.point(at(*start), color="ray")
    canvas.text((116, 262), "neighbours", color="quiet")
    canvas.text((344, 30), "one by one", title=True)
    canvas.text((480, 30), "a packet", title=True)
    for left, fetches in ((300, 4), (436, 1)):
        for number in range(4):
            canvas.box(left, 60 + 46 * number, 30, 34, color="ray", filled=True)
            y = 77 + 46 * number
            target = (left + 52, y) if fetches == 4 else (left + 52, 77 + 46 * 1.5)
            canvas.arrow(target, (left + 33, y), color="good")
        for number in range(fetches):
            y = 77 + 46 * (number if fetches == 4 else 1.5)
            canvas.box(left + 52, y - 17, 58, 34, "node", color="good", filled=True)
        canvas.text((left + 55, 262), f"{fetches} fetches" if fetches > 1 else f"{fetches} fetch", color="good")
