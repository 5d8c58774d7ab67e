"""The formulas of the exercises for a terminal, which cannot set TeX."""

import re

WORDS = {r"\times": "x", r"\cdot": ".", r"\ge": ">=", r"\le": "<=", r"\in": "in", r"\pm": "+-",
         r"\to": "->", r"\epsilon": "epsilon", r"\max": "max", r"\min": "min", r"\arg": "arg ",
         r"\det": "det", r"\log": "log", r"\lfloor": "floor(", r"\rfloor": ")", r"\quad": "  ",
         r"\,": "", r"\ ": " "}


def plain(formula):
    r"""`$a \cdot b_{max}$` becomes `a . b_max`. Raises KeyError for a word of TeX it does not know."""
    text = re.sub(r"(\\[a-zA-Z]+|\\[, ])", lambda found: WORDS[found[1]], formula.replace("$", ""))
    text = re.sub(r"_\{(\w+)\}", r"_\1", text)
    text = re.sub(r"\^\{([^{}]*/[^{}]*)\}", r"^(\1)", text).replace("{", "").replace("}", "")
    return re.sub(r"(?<=\() +| +(?=\))", "", text).strip()
