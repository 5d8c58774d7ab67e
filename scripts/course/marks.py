"""Exercises are marked in the sources, so that a blank is derived and never kept by hand:

    //# exercise 2.1: the cross product
    ... the solution ...
    //# stub: real x = real(0.0f);
    //# end

A workbook's file has the first and the last line, and between them the stub's lines as code.
"""

import codecs
import difflib
import re
from dataclasses import dataclass, field

from .errors import CourseError

BEGIN = re.compile(r"^(\s*)//# exercise (\d+\.\d+): (.+)$")
STUB = re.compile(r"^\s*//# stub: (.*)$")
END = re.compile(r"^\s*//# end\s*$")


@dataclass
class Region:
    """The lines of one exercise; `first` is the number of its first line of code, counted from 1,
    and `last` that of the line which ends it."""

    number: str
    title: str
    begin: str
    end: str = ""
    first: int = 0
    last: int = 0
    code: list = field(default_factory=list)
    stub: list = field(default_factory=list)


@dataclass
class Line:
    text: str
    number: int


def text_of(path):
    """A person's file as text, in whichever of its ways an editor wrote it: UTF-8 or UTF-16, with or
    without a byte order mark, with any ends of lines."""
    raw = path.read_bytes()
    is_wide = raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    text = raw.decode("utf-16" if is_wide else "utf-8-sig", errors="replace")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def parse(text, name):
    """The file as a list of Line and Region, in order. Raises CourseError with file and line."""
    parts, region = [], None
    for number, line in enumerate(text.split("\n"), 1):
        begin, stub = BEGIN.match(line), STUB.match(line)
        if begin and region is None:
            region = Region(begin[2], begin[3], line, first=number + 1)
        elif begin:
            raise CourseError(f"{name}:{number}: an exercise begins before {region.number} has "
                              f"ended. Put the line `//# end` of {region.number} back.")
        elif END.match(line):
            if region is None:
                raise CourseError(f"{name}:{number}: `//# end` without an exercise. Put the line "
                                  "`//# exercise ...` back, or let ./course reset do it.")
            region.end, region.last = line, number
            parts.append(region)
            region = None
        elif stub and region is not None:
            indent = BEGIN.match(region.begin)[1]
            region.stub.append(indent + stub[1])
        elif region is not None:
            region.code.append(line)
        else:
            parts.append(Line(line, number))
    if region is not None:
        raise CourseError(f"{name}: exercise {region.number} does not end. Put the line `//# end` "
                          "back, or let ./course reset do it.")
    return parts


def regions(text, name):
    """The exercises of a file by their numbers. Raises CourseError where one is there twice."""
    found = {}
    for part in parse(text, name):
        if isinstance(part, Region):
            if part.number in found:
                raise CourseError(f"{name}: exercise {part.number} is there twice. Remove one.")
            found[part.number] = part
    return found


def with_code(text, name, codes):
    """The file with the code of the given exercises, and without any line of a stub."""
    lines = []
    for part in parse(text, name):
        if isinstance(part, Line):
            lines.append(part.text)
        else:
            lines += [part.begin, *codes.get(part.number, part.code), part.end]
    return "\n".join(lines)


def blank(text, name):
    """A workbook's file: the stub of each exercise stands where the solution was."""
    stubs = {number: region.stub for number, region in regions(text, name).items()}
    return with_code(text, name, stubs)


def is_same(code, other):
    """Whether two codes differ in spaces only."""
    return [" ".join(line.split()) for line in code if line.strip()] == [
        " ".join(line.split()) for line in other if line.strip()]


def _outside(text, name):
    """What is not in an exercise, line by line, without spaces; an exercise is one line."""
    return [(f"exercise {part.number}", part.last) if isinstance(part, Region)
            else (" ".join(part.text.split()), part.number) for part in parse(text, name)]


def changed_outside(reference, own, name):
    """In words, which lines outside all exercises are not the project's; empty where all are."""
    ours, theirs = _outside(reference, name), _outside(own, name)
    changed, lost = [], []
    steps = difflib.SequenceMatcher(None, [text for text, _ in ours], [text for text, _ in theirs], False)
    for kind, start, end, own_start, own_end in steps.get_opcodes():
        numbers = [number for text, number in theirs[own_start:own_end] if text]
        missing = sum(bool(text) for text, _ in ours[start:end]) - len(numbers)
        if kind != "equal" and numbers:
            changed.append(f"{numbers[0]}-{numbers[-1]}" if len(numbers) > 1 else f"{numbers[0]}")
        if kind != "equal" and missing > 0:
            after = theirs[own_start - 1][1] if own_start else 0
            lost.append(f"{missing} of the project's {'are' if missing > 1 else 'is'} missing after line {after}")
    is_one = len(changed) == 1 and "-" not in changed[0]
    words = [f"line{'' if is_one else 's'} {', '.join(changed)} {'is' if is_one else 'are'} not the project's"] \
        if changed else []
    return "; ".join(words + lost)


@dataclass
class Composed:
    """A file as the compiler gets it; origins[i] is (person's file?, line) of its line i + 1."""

    text: str
    origins: list


def compose(reference, own, reference_name, own_name, chosen):
    """The person's file, in which the reference stands for every exercise that is not chosen."""
    solutions = regions(reference, reference_name)
    theirs = regions(own, own_name)
    for number in solutions:
        if number not in theirs:
            raise CourseError(f"{own_name}: the marks of exercise {number} are gone. Put its lines "
                              f"back, or let `./course reset {number}` do it.")
    lines, origins = [], []
    for part in parse(own, own_name):
        if isinstance(part, Line):
            lines.append(part.text)
            origins.append((True, part.number))
            continue
        solution = solutions.get(part.number)
        is_own = part.number in chosen or solution is None
        source = part if is_own else solution
        lines += [part.begin, *source.code, part.end]
        origins += [(is_own, source.first - 1 + i) for i in range(len(source.code) + 1)]
        origins.append((is_own, source.last))
    return Composed("\n".join(lines), origins)
