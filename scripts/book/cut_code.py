"""Cuts a function or a struct out of a file of C++ or GLSL by its name."""

import re

from .errors import BookError

# What a definition may begin with, up to its name: `GridPart part_in_grid(`, `struct Box`.
FUNCTION = r"^\s*(?!return\b|else\b|case\b|//)[\w:<>,&*\s\[\]]*[\w>&*\]][\s&*]+{name}\s*\("
RECORD = r"^\s*(?:struct|class|enum class)\s+{name}\b[^;]*$"
MARK = re.compile(r"^(\s*)//# (\w+)(?: ([\d.]+):)?")


def without_words(text):
    """The text with comments and strings blanked out, so that braces in them do not count."""
    def blank(found):
        return re.sub(r"[^\n]", " ", found.group())
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', blank, text,
                  flags=re.DOTALL)


def _end_of(code, first):
    """The line with the brace that closes the definition which begins at line `first`; None for a
    declaration, which ends before any brace opens."""
    depth, is_open = 0, False
    for number in range(first, len(code)):
        for letter in code[number]:
            if letter == ";" and not is_open and depth == 0:
                return None
            if letter in "({":
                depth += 1
                is_open = is_open or letter == "{"
            if letter in ")}":
                depth -= 1
                if letter == "}" and depth == 0:
                    return number
    return None


def _begin_of(lines, first):
    """With the comment that stands right above."""
    while first > 0 and lines[first - 1].lstrip().startswith("//"):
        first -= 1
    return first


def _without_margin(lines):
    margin = min((len(line) - len(line.lstrip()) for line in lines if line.strip()), default=0)
    return [line[margin:] for line in lines]


def exercises_in(lines):
    """Of each exercise its number and the numbers of its first and last line, from 1. One that does not end
    here goes to the last line."""
    found, begun = [], None
    for number, line in enumerate(lines, 1):
        mark = MARK.match(line)
        if mark and mark.group(2) == "exercise":
            begun = (mark.group(3), number)
        if mark and mark.group(2) == "end" and begun:
            found.append((*begun, number))
            begun = None
    return found + [(*begun, len(lines))] if begun else found


def without_solutions(lines):
    """The lines of an exercise are the student's: the book only names it there."""
    kept, begin = [], 0
    for exercise, first, last in exercises_in(lines):
        margin = MARK.match(lines[first - 1]).group(1)
        kept += [*lines[begin:first - 1], f"{margin}// exercise {exercise}"]
        begin = last
    return [line for line in [*kept, *lines[begin:]] if not MARK.match(line)]


def cut(text, name):
    """The lines of the definition of that name, with the comment above it, and the number of its
    first line; without the solutions of exercises. Of several definitions, the first."""
    lines, code = text.split("\n"), without_words(text).split("\n")
    patterns = [re.compile(form.format(name=re.escape(name))) for form in (FUNCTION, RECORD)]
    for number, line in enumerate(code):
        if any(pattern.search(line) for pattern in patterns):
            end = _end_of(code, number)
            if end is not None:
                begin = _begin_of(lines, number)
                kept = without_solutions(lines[begin:end + 1])
                return _without_margin(kept), begin + 1
    raise BookError(f"there is no function and no struct {name}. Was it given another name?")
