"""A scatter plot as an SVG element: cost against faults or error, both axes logarithmic.

Labels stand in a column on the right, each with a line to its mark, so that none lies over another."""

import math
from dataclasses import dataclass
from html import escape

WIDTH, HEIGHT = 760, 430
LEFT, RIGHT, TOP, BOTTOM = 72, 500, 34, 376
LABEL_LEFT, LABEL_HEIGHT = 530, 19
LEAST_OF_ITS_VALUE = 0.2  # a range reaches down to zero; so much of it is drawn


@dataclass
class Mark:
    """A method. Where y is 0, only its upper bound is drawn: a logarithm has no place for 0."""
    label: str
    hint: str
    x: tuple  # median, lowest, highest; over 0
    y: tuple  # counted, lowest, highest; the highest over 0
    dominated: bool = False

    @property
    def is_bound(self):
        return self.y[0] <= 0

    @property
    def least(self):
        return self.y[2] if self.is_bound else max(self.y[1], LEAST_OF_ITS_VALUE * self.y[0])

    @property
    def height(self):
        return self.y[2] if self.is_bound else self.y[0]


class Axis:
    """A logarithmic axis: a little longer than the values need, and half a power of ten at least."""

    def __init__(self, lowest, highest, start, end):
        room = max(1.12, math.sqrt(max(1.0, 2.0 * lowest / highest)))
        self.lowest, self.highest = lowest / room, highest * room
        self.start, self.end = start, end

    def at(self, value):
        value = min(max(value, self.lowest), self.highest)
        share = math.log(value / self.lowest) / math.log(self.highest / self.lowest)
        return self.start + share * (self.end - self.start)

    def ticks(self):
        """1, 2 and 5 times each power of ten; of many powers only these; of less than one, more."""
        powers = math.log10(self.highest / self.lowest)
        parts = ((1,) if powers > 2.5 else (1, 2, 5) if powers > 0.8 else
                 (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8))
        first, last = math.floor(math.log10(self.lowest)), math.floor(math.log10(self.highest))
        ticks = [part * 10.0 ** power for power in range(first, last + 1) for part in parts]
        return [tick for tick in ticks if self.lowest <= tick <= self.highest]


def _line(x1, y1, x2, y2, kind):
    return f"<line x1='{x1:.1f}' y1='{y1:.1f}' x2='{x2:.1f}' y2='{y2:.1f}' class='{kind}'/>\n"


def _text(x, y, kind, text):
    return f"<text x='{x:.1f}' y='{y:.1f}' class='{kind}'>{escape(text)}</text>\n"


def _frame(x, y, x_label, y_label):
    svg = ""
    for tick in x.ticks():
        svg += _line(x.at(tick), TOP, x.at(tick), BOTTOM, "grid")
        svg += _text(x.at(tick), BOTTOM + 17, "tick middle", f"{tick:.4g}")
    for tick in y.ticks():
        svg += _line(LEFT, y.at(tick), RIGHT, y.at(tick), "grid")
        svg += _text(LEFT - 6, y.at(tick) + 4, "tick end", f"{tick:.4g}")
    svg += (f"<rect x='{LEFT}' y='{TOP}' width='{RIGHT - LEFT}' height='{BOTTOM - TOP}' "
            "class='frame'/>\n")
    svg += _text((LEFT + RIGHT) / 2, HEIGHT - 10, "middle", x_label)
    return svg + (f"<text transform='translate(16 {(TOP + BOTTOM) / 2:.1f}) rotate(-90)' "
                  f"class='middle'>{escape(y_label)}</text>\n")


def label_heights(wanted):
    """Heights as near to the wanted ones as there is room: in their order, none over another."""
    order = sorted(range(len(wanted)), key=lambda i: wanted[i])
    heights = list(wanted)
    free = TOP
    for i in order:
        heights[i] = max(free, heights[i])
        free = heights[i] + LABEL_HEIGHT
    last = BOTTOM + 10  # pushed up again from below
    for i in reversed(order):
        heights[i] = min(heights[i], last)
        last = heights[i] - LABEL_HEIGHT
    return heights


def _draw(mark, x, y, label):
    px, py = x.at(mark.x[0]), y.at(mark.height)
    kind = "dominated" if mark.dominated else "best"
    svg = f"<g class='{kind}'><title>{escape(mark.hint)}</title>\n"
    svg += (f"<polyline points='{px:.1f},{py:.1f} {LABEL_LEFT - 22},{label:.1f} "
            f"{LABEL_LEFT - 5},{label:.1f}' class='leader'/>\n")
    svg += _line(x.at(mark.x[1]), py, x.at(mark.x[2]), py, "range")
    if mark.is_bound:  # somewhere below
        svg += _line(px, py, px, min(py + 14, BOTTOM), "range")
        svg += f"<path d='M{px:.1f} {py + 5:.1f} l6 -10 h-12 z' class='mark'/>\n"
    else:
        svg += _line(px, y.at(mark.least), px, y.at(mark.y[2]), "range")
        svg += f"<circle cx='{px:.1f}' cy='{py:.1f}' r='5.5' class='mark'/>\n"
    return svg + _text(LABEL_LEFT, label + 4, "label", mark.label) + "</g>\n"


def to_svg(title, x_label, y_label, marks):
    """The plot; nothing where there is no mark."""
    if not marks:
        return ""
    x = Axis(min(m.x[1] for m in marks), max(m.x[2] for m in marks), LEFT, RIGHT)
    y = Axis(min(m.least for m in marks), max(m.y[2] for m in marks), BOTTOM, TOP)
    svg = (f"<svg viewBox='0 0 {WIDTH} {HEIGHT}' role='img' aria-label='{escape(title)}'>\n" +
           _text(LEFT, 18, "title", title) + _frame(x, y, x_label, y_label))
    labels = label_heights([y.at(mark.height) for mark in marks])
    for mark, label in zip(marks, labels):
        svg += _draw(mark, x, y, label)
    return svg + "</svg>\n"
