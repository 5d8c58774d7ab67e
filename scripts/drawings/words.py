"""Words in a drawing. What stands between dollars is set as letters: `the ray leaves at $t_x$`.

    $t_{split}$  a letter with words below it     $2^{-23}$  above it     $**f**$  upright: a vector"""

import re
from html import escape

SIZE = 16  # of words, in a drawing that is 560 wide: 11.1 pixels on a phone
LINE_HEIGHT = 21
PARTS = re.compile(r"([_^])(?:\{([^}]*)\}|(\S))|\*\*([^*]+)\*\*|([^_^*]+)")
SHIFTS = {"_": 5, "^": -7}


def _letters(text):
    svg, shift = "", 0
    for mark, braced, single, upright, plain in PARTS.findall(text):
        wanted = SHIFTS.get(mark, 0)
        move = f" dy='{wanted - shift}'" if wanted != shift else ""
        shift = wanted
        words = braced or single or upright or plain
        kind = "upright" if upright or (not mark and not re.search("[A-Za-zℓφ]", words)) else "letters"
        if mark and not re.fullmatch("[a-z]", words):
            kind = "upright"
        small = " small" if mark else ""
        svg += f"<tspan class='{kind}{small}'{move}>{escape(words)}</tspan>"
    return svg, shift


def spans(text):
    """The text of one line as the inside of an SVG text element."""
    svg, shift = "", 0
    for i, part in enumerate(text.split("$")):
        if not part:
            continue
        if i % 2:
            inner, last = _letters(part)
            svg += inner if not shift else f"<tspan dy='{-shift}'>&#8203;</tspan>{inner}"
            shift = last
        else:
            move = f" dy='{-shift}'" if shift else ""
            svg += f"<tspan{move}>{escape(part)}</tspan>" if move else escape(part)
            shift = 0
    return svg


def plain(text):
    """The same words without their marks, as a reader sees them."""
    return re.sub(r"[${}_^]|\*\*", "", text)


def numbers(text):
    """The numbers in a text, as they are written: 0.625, 11,700, -23. `e_1` has none."""
    found = re.findall(r"(?<![\w.])[-\u2212]?\d[\d,]*(?:\.\d+)?", plain_numbers(text))
    return [number.replace("\u2212", "-").rstrip(",") for number in found]


def plain_numbers(text):
    """Without indices of letters, which count nothing, and with powers apart: 2^{-23} is 2 and -23."""
    text = re.sub(r"([A-Za-z*])_\{?\w+\}?", r"\1", text)
    return re.sub(r"\^\{?([^}$\s]*)\}?", r" \1 ", text).replace("$", "").replace("*", "")
