"""From what is in a scene to its effects, and to the passes that run."""

ALT = (
    "Materials, lights and the camera of the scene mirrors call for four effects, diffuse, "
    "highlights, shadows and mirrors; each brings its passes into the plan. Refraction and soft "
    "shadows are called for by nothing, and no pass of theirs runs"
)
HEIGHT = 380
SENTENCES = [
    "4 effects: diffuse, highlights, shadows, mirrors.",
    "| `mirrors` | `illum` 3 and others, with `Ks`",
    "| `highlights` | a light, `illum` 2 or more with `Ks` and `Ns` | `add_highlight` |",
]

SOURCES = ("Kd", "Ks, Ns", "2 lights", "illum 3", "Ni, d")
EFFECTS = (
    ("diffuse", ("Kd", "2 lights"), "light_surface"),
    ("highlights", ("Ks, Ns", "2 lights"), "add_highlight"),
    ("shadows", ("2 lights",), "cast_lamp_rays"),
    ("mirrors", ("illum 3",), "reflect"),
    ("refraction", (), "refract"),
)


def draw(canvas, _lesson):
    tops = {name: 62 + 62 * number for number, name in enumerate(SOURCES)}
    for x, words in ((66, "the scene has"), (262, "calls for"), (464, "runs")):
        canvas.text((x, 24), words, color="quiet")
    for name, top in tops.items():
        is_there = name != "Ni, d"
        canvas.box(
            14,
            top - 18,
            104,
            36,
            name,
            color="shape" if is_there else "quiet",
            filled=is_there,
            dashed=not is_there,
        )
    for number, (name, needs, made) in enumerate(EFFECTS):
        y = 62 + 62 * number
        is_called = bool(needs)
        for need in needs:
            canvas.arrow((120, tops[need]), (196, y + (tops[need] - y) * 0.08), color="shape")
        canvas.box(
            200,
            y - 18,
            124,
            36,
            name,
            color="ray" if is_called else "quiet",
            filled=is_called,
            dashed=not is_called,
        )
        canvas.box(
            384,
            y - 18,
            160,
            36,
            made,
            color="good" if is_called else "quiet",
            filled=is_called,
            dashed=not is_called,
        )
        if is_called:
            canvas.arrow((326, y), (381, y), color="ray")
    canvas.text((280, 354), "nothing of the last row is compiled, allocated or launched", color="quiet")
