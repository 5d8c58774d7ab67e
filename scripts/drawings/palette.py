"""The colours of all drawings, by what they are for, light and dark.

A drawing brings its own background: so it can be read on any page, whichever of the two the page has."""

# role: (light, dark). A test holds the contrast of each with the card.
COLORS = {
    "card": ("#fbfaf7", "#1d2023"),
    "ink": ("#24292f", "#e6e8ea"),    # outlines and words
    "quiet": ("#5b6470", "#a9b1ba"),  # what stands behind: measures, other words
    "rule": ("#c6cbd2", "#484e56"),   # lattices; never words
    "ray": ("#b83a00", "#ffa066"),    # a ray, and what it visits
    "shape": ("#0b5fa5", "#74bdf5"),  # what a ray meets: triangles, boxes, textures
    "good": ("#00704f", "#62d3a8"),   # right, kept, found
    "wrong": ("#a3206f", "#f292c8"),  # wrong, lost, too far
}
LIGHT, DARK = 0, 1

WORDS = '"DejaVu Sans", Verdana, sans-serif'
LETTERS = '"STIX Two Text", "Times New Roman", "DejaVu Serif", serif'

SHAPES = f"""
.line {{ fill: none; stroke: currentColor; stroke-width: 2; stroke-linejoin: round; stroke-linecap: round; }}
.thin {{ stroke-width: 1.2; }} .thick {{ stroke-width: 3.4; }} .dashed {{ stroke-dasharray: 6 6; }}
.area {{ fill: currentColor; fill-opacity: .16; }} .solid {{ fill: currentColor; }}
.drawing text {{ font: 16px {WORDS}; fill: currentColor; white-space: pre; }}
.halo {{ paint-order: stroke; stroke-width: 5px; stroke-linejoin: round; }}
.drawing .title {{ font-weight: bold; }} .middle {{ text-anchor: middle; }} .end {{ text-anchor: end; }}
.letters {{ font: italic 20px {LETTERS}; }} .upright {{ font: 20px {LETTERS}; }} .small {{ font-size: 16px; }}
"""


def _colors(theme):
    rules = "".join(f".{role} {{ color: {pair[theme]}; }} " for role, pair in COLORS.items())
    return (f"{rules}.back {{ fill: {COLORS['card'][theme]}; }} "
            f".halo {{ stroke: {COLORS['card'][theme]}; }} .hole {{ fill: {COLORS['card'][theme]}; }}")


def style():
    """The style sheet that each drawing has within it."""
    return (f"<style>{SHAPES}{_colors(LIGHT)}\n"
            f"@media (prefers-color-scheme: dark) {{ {_colors(DARK)} }}\n</style>\n")
