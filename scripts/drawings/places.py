"""From the numbers of a lesson to places in a drawing, whose y goes down."""

import math
from dataclasses import dataclass


@dataclass
class Flat:
    """A plane seen from the front: (x, y) of the lesson, y upwards."""

    left: float  # where x = 0 and y = 0 lie in the drawing
    bottom: float
    scale: float  # of one unit
    scale_y: float = 0.0

    def __call__(self, x, y):
        return (self.left + x * self.scale, self.bottom - y * (self.scale_y or self.scale))


@dataclass
class Solid:
    """Space seen from far away: (x, y, z) of the lesson, y upwards. Degrees; at 0 and 0 one looks along -z."""

    left: float
    bottom: float
    scale: float
    turned: float = 30.0  # to the right of z
    raised: float = 20.0  # above the horizon

    def __call__(self, x, y, z):
        turn, rise = math.radians(self.turned), math.radians(self.raised)
        across = x * math.cos(turn) - z * math.sin(turn)
        nearer = x * math.sin(turn) + z * math.cos(turn)
        up = y * math.cos(rise) - nearer * math.sin(rise)
        return (self.left + across * self.scale, self.bottom - up * self.scale)


def between(a, b, part):
    """The point that lies this part of the way from a to b."""
    return tuple(p + part * (q - p) for p, q in zip(a, b))


def beside(a, b, distance):
    """The segment moved to its left by a distance, as seen in the drawing on the way from a to b."""
    along = math.dist(a, b)
    dx, dy = (b[1] - a[1]) / along * distance, -(b[0] - a[0]) / along * distance
    return (a[0] + dx, a[1] + dy), (b[0] + dx, b[1] + dy)


def before(a, b, distance):
    """The point on the way from a to b that lies this far before b: where an arrow ends that points to a box."""
    return between(b, a, distance / math.dist(a, b))
