"""Holds answers against those of the reference, and against what is known."""

import math
from dataclasses import dataclass, field, replace

from .exercises import bits, from_bits

CHOICES = {"float": from_bits, "exact": from_bits, "bool": bool,
           "int": lambda found: found - (1 << 32) if found >= 1 << 31 else found}

# Of the numbers of an answer, eight are the checkpoint's own; of a shader part, its observer has
# the others (scripts/course/answers/shaders/observer_in_order.glsl).
NUMBERS, FIRST_OBSERVED = 12, 8
OBSERVED = [("visits", "int"), ("tests", "int"), ("order", "int")]


@dataclass
class Wrong:
    """The first wrong answer of a checkpoint: which ray, which step, and each of its values."""

    index: int
    step: int
    ray: list  # eight numbers as bits
    values: list  # of {name, expected, got, right}
    because: str = ""  # of a known answer
    asked: list = field(default_factory=list)  # all rays of the checkpoint; for a builder, boxes


def _is_right(expected, got, kind, tolerance):
    if kind not in ("float", "exact"):
        return expected == got
    if math.isnan(expected) or math.isnan(got):
        return math.isnan(expected) and math.isnan(got)
    if kind == "exact" or math.isinf(expected) or math.isinf(got):
        return expected == got
    return abs(expected - got) <= tolerance * max(1.0, abs(expected), abs(got))


def values_of(found, kinds):
    return [CHOICES[kind](number) for (_, kind), number in zip(kinds, found)]


def judged(expected, got, checkpoint):
    return [{"name": name, "expected": a, "got": b,
             "right": _is_right(a, b, kind, checkpoint.tolerance)}
            for (name, kind), a, b in zip(checkpoint.values, expected, got) if name]


def _observed_too(checkpoint):
    """The checkpoint, with what a shader part's observer says of each ray among its values."""
    if checkpoint.question["kind"] != "checkpoint" or not checkpoint.observed:
        return checkpoint
    unnamed = [("", "int")] * (FIRST_OBSERVED - len(checkpoint.values))
    return replace(checkpoint, values=[*checkpoint.values, *unnamed, *OBSERVED])


def is_shaped_like(answer, reference):
    """The same rays, and as many numbers: an answer comes from a program that ran foreign code."""
    try:
        return answer.rays == reference.rays and len(answer.steps) == len(reference.steps) and all(
            len(one) == len(other) and all(
                len(found) == NUMBERS and all(type(n) is int and 0 <= n < 1 << 32 for n in found)
                for found in one)
            for one, other in zip(answer.steps, reference.steps))
    except TypeError:
        return False


def first_wrong(answer, reference, checkpoint):
    """The earliest step at which any ray is wrong, and of those the first ray; None if all is
    right."""
    checkpoint = _observed_too(checkpoint)
    for step, (found, wanted) in enumerate(zip(answer.steps, reference.steps), 1):
        for index, (one, other) in enumerate(zip(found, wanted)):
            if one == other:
                continue  # to the bit
            values = judged(values_of(other, checkpoint.values), values_of(one, checkpoint.values),
                            checkpoint)
            if not all(value["right"] for value in values):
                ray = reference.rays[index] if reference.rays else []
                shown = [value for value in values
                         if (value["name"], "int") not in OBSERVED or not value["right"]]
                return Wrong(index, step, ray, shown, asked=reference.rays)
    return None


def first_unknown(answer, checkpoint):
    """The first known answer that is not given; None if all are."""
    for known in checkpoint.known:
        step, index = known.get("step", 1), known.get("index", 0)
        got = values_of(answer.steps[step - 1][index], checkpoint.values)
        expected = [from_bits(bits(float(value))) if kind in ("float", "exact") else value
                    for (_, kind), value in zip(checkpoint.values, known["expected"])]
        values = judged(expected, got, checkpoint)
        if len(expected) != len(checkpoint.values) or not all(value["right"] for value in values):
            ray = answer.rays[index] if answer.rays else []
            return Wrong(index, step, ray, values, known["because"], answer.rays)
    return None
