"""The passes of one bounce, each in a row, and the textures that it reads and writes, each in a column."""

ALT = (
    "The passes of one bounce as rows and the textures as columns: trace reads rays A and writes "
    "hits; add_surroundings and add_light add to the color; both retire passes write the mask; "
    "cast_shadow_rays and a second trace make shadow rays and shadow hits; reflect reads rays and "
    "weights A and writes B, and the next bounce reads B and writes A"
)
HEIGHT = 476
SENTENCES = [
    "Reflect reads one set of rays and weights and writes the other",
]

TEXTURES = {"A": 208, "B": 252, "hits": 302, "shadow rays": 358, "shadow hits": 412, "color": 468, "mask": 524}
# The pass, what it reads, what it writes, what it adds to (common/render/whitted_renderer.cpp).
PASSES = (
    ("trace", ["A"], ["hits"], []),
    ("add_surroundings", ["A", "hits"], [], ["color"]),
    ("retire misses", ["hits"], ["mask"], []),
    ("cast_shadow_rays", ["A", "hits"], ["shadow rays"], []),
    ("trace", ["shadow rays"], ["shadow hits"], []),
    ("add_light", ["A", "hits", "shadow hits"], [], ["color"]),
    ("retire unmirrored", ["hits"], ["mask"], []),
    ("reflect", ["A", "hits"], ["B"], []),
)
TOP, ROW, LAMPS = 104, 38, 24


def draw(canvas, _lesson):
    bottom = TOP + ROW * (len(PASSES) - 1) + LAMPS + 18
    for name, x in TEXTURES.items():
        canvas.line((x, TOP - 22), (x, bottom), color="rule")
        canvas.text((x, TOP - 38), name.split(" ")[-1], color="shape")
    canvas.text(((TEXTURES["A"] + TEXTURES["B"]) / 2, TOP - 70), "rays and\nweights", color="shape")
    canvas.text(((TEXTURES["shadow rays"] + TEXTURES["shadow hits"]) / 2, TOP - 60), "shadow", color="shape")
    for number, (name, reads, writes, adds) in enumerate(PASSES):
        y = TOP + ROW * number + (LAMPS if number > 2 else 0)
        canvas.text((14, y), name, "e", gap=0)
        to = TEXTURES[(writes or adds)[0]]
        first = min(TEXTURES[texture] for texture in reads)
        last = max(TEXTURES[texture] for texture in reads)
        if to > last:
            canvas.arrow((first, y), (to - 8, y), color="ray")
        else:
            canvas.line((first, y), (last, y), color="ray")
        for texture in reads:
            canvas.point((TEXTURES[texture], y), color="ray", hollow=True, radius=6)
        for texture in writes:
            canvas.point((TEXTURES[texture], y), color="ray", radius=8)
        for texture in adds:
            canvas.circle((TEXTURES[texture], y), 9, color="good", hole=True)
            canvas.line((TEXTURES[texture] - 5, y), (TEXTURES[texture] + 5, y), color="good")
            canvas.line((TEXTURES[texture], y - 5), (TEXTURES[texture], y + 5), color="good")
    lamps = TOP + ROW * 2.85
    canvas.text((14, lamps), "for each lamp", "e", gap=0, color="quiet")
    canvas.line((4, lamps), (4, TOP + ROW * 5.3 + LAMPS), color="quiet")
    y = bottom + 34
    canvas.text((14, y), "next bounce: A and B change places", "e", gap=0, color="quiet")
    canvas.point((352, y), "reads", "e", color="ray", hollow=True, radius=6)
    canvas.point((424, y), "writes", "e", color="ray", radius=8)
    canvas.circle((504, y), 9, color="good", hole=True)
    canvas.line((499, y), (509, y), color="good")
    canvas.line((504, y - 5), (504, y + 5), color="good")
    canvas.text((508, y), "adds", "e", color="good")
