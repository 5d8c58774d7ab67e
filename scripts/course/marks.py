"""Exercises are marked in the sources, so that a blank is derived and never kept by hand:

    //# exercise 2.1: the cross product
    ... the solution ...
    //# stub: real x = real(0.0f);
    //# end

A workbook's file has the first and the last line, and between them the stub's lines as code.
"""

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
