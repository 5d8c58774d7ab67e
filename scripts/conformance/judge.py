"""Whether hits are among the allowed answers of a family: docs/conformance/README.md, "Right and wrong"."""

import math
import struct
from dataclasses import dataclass, field

from suite import ANYTHING_ALLOWED, MISS_ALLOWED, read_answers, read_rays

HIT_BYTES = 16
NOT_TOLD = -1.0
ROOM = 2.0**-18  # for the point of u and v, as a part of the reach
KINDS = ("missed", "other triangle", "wrong t", "wrong u, v", "no such triangle", "no answer")


@dataclass
class Verdict:
    """What is wrong with the hits of a family."""

    wrong: dict = field(default_factory=lambda: dict.fromkeys(KINDS, 0))
    first: dict | None = None  # the first wrong ray

    def total(self):
        return sum(self.wrong.values())


def is_point_of(ray, triangle, t, u, v):
    """Whether u and v name the point of the triangle that lies at t."""
    seen = [[triangle[3 * corner + axis] - ray[axis] for axis in range(3)] for corner in range(3)]
    reach = max(abs(number) for corner in seen for number in corner)
    weights = (1.0 - u - v, u, v)
    return all(abs(sum(weight * corner[axis] for weight, corner in zip(weights, seen)) - t * ray[3 + axis])
               <= ROOM * reach for axis in range(3))


def fault_of(hit, ray, triangles, flags, allowed):
    """The kind of a wrong answer; empty where it is right."""
    t, u, v, triangle = hit
    if triangle == -1:
        return "" if flags & MISS_ALLOWED else "missed"
    if not 0 <= triangle < len(triangles):
        return "no such triangle"
    if flags & ANYTHING_ALLOWED:
        return ""
    if triangle not in allowed:
        return "other triangle"
    least, most = allowed[triangle]
    if not least <= t <= most:
        return "wrong t"
    if (u, v) != (NOT_TOLD, NOT_TOLD) and not is_point_of(ray, triangles[triangle], t, u, v):
        return "wrong u, v"
    return ""


def judge(family, triangles, data):
    """The verdict on the bytes of a hit file, which may be too few."""
    verdict = Verdict()
    hits = struct.iter_unpack("<fffi", data[:len(data) // HIT_BYTES * HIT_BYTES])
    answers = read_answers(family.file("answers"))
    for number, (ray, (flags, allowed)) in enumerate(zip(read_rays(family.file("f32")), answers)):
        hit = next(hits, None)
        kind = "no answer" if hit is None else fault_of(hit, ray, triangles, flags, allowed)
        if kind:
            verdict.wrong[kind] += 1
            verdict.first = verdict.first or {
                "ray": number, "kind": kind,
                "triangle": -1 if hit is None else hit[3], "t": as_told(hit[0] if hit else math.nan),
                "miss": bool(flags & MISS_ALLOWED),
                "allowed": [{"triangle": one, "t_least": least, "t_most": most}
                            for one, (least, most) in list(allowed.items())[:8]]}
    return verdict


def as_told(number):
    """JSON has neither NaN nor infinity."""
    return number if math.isfinite(number) else str(number)


def bounds(wrong, tried):
    """Of a rate per million, with 95 %: Wilson's, or 3/n where none was wrong (one-sided)."""
    if tried == 0:
        return 0.0, 1e6
    if wrong == 0:
        return 0.0, min(1e6, 3e6 / tried)
    z, rate = 1.96, wrong / tried
    middle = (rate + z * z / (2 * tried)) / (1 + z * z / tried)
    half = z * math.sqrt(rate * (1 - rate) / tried + z * z / (4 * tried * tried)) / (1 + z * z / tried)
    return 1e6 * max(0.0, middle - half), 1e6 * min(1.0, middle + half)
