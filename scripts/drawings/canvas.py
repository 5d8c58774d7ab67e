"""What a drawing is made of: lines, arrows, points with letters, boxes, triangles, axes, words."""

import math
from html import escape

from drawings.palette import style
from drawings.words import LINE_HEIGHT, SIZE, numbers, spans

WIDTH = 560
HEAD = 11  # of an arrow
POINT = 4.5  # its radius
GAP = 9  # between a point and its letter
TICK = 5

# Where words stand, seen from their point: how they are anchored, and where their middle is.
SIDES = {
    "n": ("middle", 0, -1),
    "s": ("middle", 0, 1),
    "e": ("", 1, 0),
    "w": ("end", -1, 0),
    "ne": ("", 0.7, -0.8),
    "nw": ("end", -0.7, -0.8),
    "se": ("", 0.7, 0.8),
    "sw": ("end", -0.7, 0.8),
    "c": ("middle", 0, 0),
}


def _number(value):
    """To a tenth of a unit, as short as can be, and never -0."""
    return f"{round(value, 1) + 0.0:.1f}".removesuffix(".0")


def _pair(point):
    return f"{_number(point[0])},{_number(point[1])}"


def _kinds(*words):
    return " ".join(word for word in words if word)


def _back(height):
    return f"<rect width='{WIDTH}' height='{height}' rx='8' class='back'/>\n"


class Canvas:
    """Collects the elements of one drawing. Colours are roles of the palette."""

    def __init__(self, height, alt):
        self.height, self.alt = height, alt
        self.elements = []
        self.numbers = []  # all that its words show

    def _add(self, element):
        self.elements.append(element)

    def line(self, *points, color="ink", dashed=False, width="", closed=False):
        kind = _kinds("line", color, width, "dashed" if dashed else "")
        name = "polygon" if closed else "polyline"
        self._add(f"<{name} points='{' '.join(map(_pair, points))}' class='{kind}'/>")

    def area(self, *points, color="shape", outlined=True, dashed=False, width=""):
        """A triangle, or any polygon: filled lightly."""
        self._add(f"<polygon points='{' '.join(map(_pair, points))}' class='area {color}'/>")
        if outlined:
            self.line(*points, color=color, closed=True, dashed=dashed, width=width)

    def _head(self, tip, angle, color):
        wings = [
            (tip[0] - HEAD * math.cos(angle + turn), tip[1] - HEAD * math.sin(angle + turn))
            for turn in (-0.38, 0.38)
        ]
        self._add(f"<polygon points='{' '.join(map(_pair, [tip, *wings]))}' class='solid {color}'/>")

    def arrow(self, *points, color="ink", dashed=False, width="", both=False):
        """From the first point to the last, with a head there."""
        before, tip = points[-2], points[-1]
        angle = math.atan2(tip[1] - before[1], tip[0] - before[0])
        end = (tip[0] - 0.8 * HEAD * math.cos(angle), tip[1] - 0.8 * HEAD * math.sin(angle))
        self.line(*points[:-1], end, color=color, dashed=dashed, width=width)
        self._head(tip, angle, color)
        if both:
            self._head(points[0], math.atan2(points[0][1] - points[1][1], points[0][0] - points[1][0]), color)

    def bow(self, a, control, b, color="ink", dashed=False, width="", head=True):
        """A bent arrow; it leans towards the control point."""
        angle = math.atan2(b[1] - control[1], b[0] - control[0])
        end = (b[0] - 0.8 * HEAD * math.cos(angle), b[1] - 0.8 * HEAD * math.sin(angle)) if head else b
        kind = _kinds("line", color, width, "dashed" if dashed else "")
        self._add(f"<path d='M{_pair(a)} Q{_pair(control)} {_pair(end)}' class='{kind}'/>")
        if head:
            self._head(b, angle, color)

    def circle(self, middle, radius, color="ink", filled=False, dashed=False, width="", hole=False):
        kind = _kinds(
            "line" if not filled else "area", color, width, "dashed" if dashed else "", "hole" if hole else ""
        )
        self._add(
            f"<circle cx='{_number(middle[0])}' cy='{_number(middle[1])}' r='{_number(radius)}' "
            f"class='{kind}'/>"
        )

    def point(self, place, letter="", side="ne", color="ink", hollow=False, radius=POINT):
        """A point, with its letter beside it."""
        kind = f"line hole {color}" if hollow else f"solid {color}"
        style_of_hole = " style='fill-opacity: 1'" if hollow else ""
        self._add(
            f"<circle cx='{_number(place[0])}' cy='{_number(place[1])}' r='{_number(radius)}' "
            f"class='{kind}'{style_of_hole}/>"
        )
        if letter:
            self.text(place, letter, side, color=color)

    def cross(self, place, color="wrong", size=6):
        x, y = place
        self.line((x - size, y - size), (x + size, y + size), color=color, width="thick")
        self.line((x - size, y + size), (x + size, y - size), color=color, width="thick")

    def text(self, place, words, side="c", color="ink", gap=GAP, title=False, halo=True):
        """Words beside a place; lines are parted by \\n. A side is a corner of the compass, or c: upon it."""
        anchor, right, down = SIDES[side]
        lines = words.split("\n")
        above = {-1: len(lines) - 1, 0: (len(lines) - 1) / 2, 1: 0}[(down > 0) - (down < 0)] * LINE_HEIGHT
        x = place[0] + right * gap
        middle = place[1] + down * (gap + SIZE * 0.42)
        kind = _kinds(color, anchor, "halo" if halo else "", "title" if title else "")
        inner = ""
        for number, line in enumerate(lines):
            y = middle + SIZE * 0.36 - above + number * LINE_HEIGHT
            inner += f"<tspan x='{_number(x)}' y='{_number(y)}'>{spans(line)}</tspan>"
            self.numbers += numbers(line)
        self._add(f"<text class='{kind}'>{inner}</text>")

    def box(self, left, top, width, height, words="", color="ink", filled=False, dashed=False, thickness=""):
        """A rectangle of the drawing, with words in its middle, which a test keeps within it."""
        around = f"x='{_number(left)}' y='{_number(top)}' width='{_number(width)}' height='{_number(height)}'"
        outside, self.elements = self.elements, []
        self._add(f"<rect {around} rx='3' class='hole'/>")
        if filled:
            self._add(f"<rect {around} rx='3' class='area {color}'/>")
        kind = _kinds("line", color, thickness, "dashed" if dashed else "")
        self._add(f"<rect {around} rx='3' class='{kind}' style='fill: none'/>")
        if words:
            self.text((left + width / 2, top + height / 2), words, color=color, halo=False)
        outside.append(("<g class='boxed'>" if words else "<g>") + "".join(self.elements) + "</g>")
        self.elements = outside

    def measure(self, a, b, words, side="n", color="quiet"):
        """A length: a line with two ends, and words at its middle."""
        along = math.dist(a, b)
        dx, dy = (b[1] - a[1]) / along * TICK, -(b[0] - a[0]) / along * TICK
        self.line(a, b, color=color, width="thin")
        for end in (a, b):
            self.line((end[0] - dx, end[1] - dy), (end[0] + dx, end[1] + dy), color=color, width="thin")
        self.text(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), words, side, color=color)

    def axis(self, a, b, words="", ticks=(), side="s", end_side="e", color="quiet"):
        """An arrow with marks: pairs of a place on it and the words there, which may be none."""
        self.arrow(a, b, color=color, width="thin")
        along = math.dist(a, b)
        dx, dy = (b[1] - a[1]) / along * TICK, -(b[0] - a[0]) / along * TICK
        for place, label in ticks:
            self.line((place[0] - dx, place[1] - dy), (place[0] + dx, place[1] + dy), color=color, width="thin")
            if label:
                self.text(place, label, side, color=color, gap=GAP)
        if words:
            self.text(b, words, end_side, color=color)

    def _framed(self, inner):
        return (
            f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {self.height}' width='{WIDTH}' "
            f"height='{self.height}' class='drawing' role='img' aria-label='{escape(self.alt, quote=True)}'>\n"
            f"{inner}\n</svg>\n"
        )

    def svg(self):
        """The drawing as the text of an SVG file."""
        return self._framed(style() + _back(self.height) + "\n".join(self.elements))

    def moving_svg(self, moments):
        """The drawing for a page of the book, with a group for each moment, of which one is shown: this one. What
        all moments have in common stands once, and below."""
        common = [element for element in self.elements if all(element in one.elements for one in moments)]
        groups = []
        for one in moments:
            kind = "moment shown" if one.elements == self.elements else "moment"
            own = "\n".join(element for element in one.elements if element not in common)
            groups.append(f"<g class='{kind}'>{own}</g>")
        return self._framed(_back(self.height) + "\n".join(common + groups))
