"""The colours of all drawings, by what they are for, light and dark.

A drawing brings its own background: so it can be read on any page, whichever of the two the page has."""

# role: (light, dark). A test holds the contrast of each with the card.
COLORS = {
    "card": ("#fbfaf7", "#1d2023"),
    "ink": ("#24292f", "#e6e8ea"),  # outlines and words
    "quiet": ("#5b6470", "#a9b1ba"),  # what stands behind: measures, other words
    "rule": ("#c6cbd2", "#484e56"),  # lattices; never words
    "ray": ("#b83a00", "#ffa066"),  # a ray, and what it visits
    "shape": ("#0b5fa5", "#74bdf5"),  # what a ray meets: triangles, boxes, textures
    "good": ("#00704f", "#62d3a8"),  # right, kept, found
    "wrong": ("#a3206f", "#f292c8"),  # wrong, lost, too far
}
LIGHT, DARK = 0, 1

WORDS = '"DejaVu Sans", Verdana, sans-serif'
LETTERS = '"STIX Two Text", "Times New Roman", "DejaVu Serif", serif'

SHAPES = f"""
.drawing text {{ font: 16px {WORDS}; fill: currentColor; white-space: pre; }}
.drawing .line {{ fill: none; stroke: currentColor; stroke-width: 2; stroke-linejoin: round;
  stroke-linecap: round; }}
.drawing .thin {{ stroke-width: 1.2; }} .drawing .thick {{ stroke-width: 3.4; }}
.drawing .dashed {{ stroke-dasharray: 6 6; }} .drawing .solid {{ fill: currentColor; }}
.drawing .area {{ fill: currentColor; fill-opacity: .16; }}
.drawing .halo {{ paint-order: stroke; stroke-width: 5px; stroke-linejoin: round; }}
.drawing .title {{ font-weight: bold; }} .drawing .middle {{ text-anchor: middle; }}
.drawing .end {{ text-anchor: end; }}
.drawing .letters {{ font: italic 20px {LETTERS}; }} .drawing .upright {{ font: 20px {LETTERS}; }}
.drawing .small {{ font-size: 16px; }}
"""


def _colors(theme, within=""):
    """The rules of one theme, within what a selector names."""
    rules = "".join(f"{within}.drawing .{role} {{ color: {pair[theme]}; }}\n" for role, pair in COLORS.items())
    card = COLORS["card"][theme]
    return (
        f"{rules}{within}.drawing .back, {within}.drawing .hole {{ fill: {card}; }}\n"
        f"{within}.drawing .halo {{ stroke: {card}; }}\n"
    )


def style():
    """The style sheet that each drawing has within it: it follows what the reader prefers."""
    return (
        f"<style>{SHAPES}{_colors(LIGHT)}@media (prefers-color-scheme: dark) {{\n{_colors(DARK)}}}\n</style>\n"
    )


def page_style():
    """The style sheet of drawings that stand in a page of the book as they are: they follow the page."""
    return SHAPES + _colors(LIGHT) + _colors(DARK, '[data-md-color-scheme="slate"] ')
