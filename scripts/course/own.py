"""A person's file for one exercise, made ready for the compiler."""

import contextlib
import re
import tempfile
from dataclasses import dataclass
from pathlib import Path

from . import hunt, marks, rounds
from .errors import CourseError
from .exercises import ROOT

MOST_BYTES = 1 << 20
INCLUDE = re.compile(r"^\s*#\s*include\s*(.*?)\s*$", re.MULTILINE)


def _refuse_foreign_includes(exercise, own, reference, name):
    """A file may include what the project's own does; in C++, the standard library as well."""
    allowed = set(INCLUDE.findall(reference))
    for target in INCLUDE.findall(own):
        is_standard = not exercise.is_shader and re.fullmatch(r"<\w+>", target)
        if target not in allowed and not is_standard:
            raise CourseError(f"{name}: `#include {target}` is not in the project's file. Remove it.")
    if re.search(r"^\s*%:|\?\?=|\\\s*\n\s*#|#\s*embed|__has_include|_Pragma|\bincbin\b", own, re.MULTILINE):
        raise CourseError(f"{name}: it reads other files or changes how the compiler reads this one. "
                          "Remove that.")


@dataclass
class Own:
    """A person's file for one exercise, ready for the compiler."""

    composed: marks.Composed
    is_stub: bool
    name: str
    outside: str = ""  # which lines outside the marks were changed, in words


def read_own(exercise, folder, chosen=None):
    """The file of the exercise in a workbook. Raises CourseError where its marks are broken."""
    path = Path(folder) / exercise.file
    name = str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else exercise.file
    if path.is_symlink() or path.stat().st_size > MOST_BYTES:
        raise CourseError(f"{name}: is a link, or larger than 1 MiB. Hand in the file itself.")
    own = marks.text_of(path)
    reference = (ROOT / exercise.file).read_text()
    composed = marks.compose(reference, own, exercise.file, name, chosen or {exercise.number})
    code = marks.regions(own, name)[exercise.number].code
    _refuse_foreign_includes(exercise, own, reference, name)
    return Own(composed, marks.is_same(code, hunt.stub_of(exercise, code)), name,
               marks.changed_outside(reference, own, name))


def text_for_compiler(exercise, own):
    """C++ can say itself which line of which file it comes from."""
    if exercise.is_shader:
        return own.composed.text
    lines, last = [], None
    for line, (is_own, number) in zip(own.composed.text.split("\n"), own.composed.origins):
        if last != (is_own, number - 1):
            lines.append(f'#line {number} "{own.name if is_own else exercise.file}"')
        lines.append(line)
        last = (is_own, number)
    return "\n".join(lines)


def place_of(line, exercise, own):
    """`FILE:LINE` as the person knows it, of a line that the compiler was given."""
    is_own, number = own.composed.origins[line - 1]
    return f"{own.name if is_own else exercise.file}:{number}"


def named_as_the_person_knows(message, exercise, own):
    """`triangle/pluecker.glsl:12:` becomes the line of the person's file."""
    short = exercise.place.removeprefix("shaders/")

    def name(match):
        line = int(match[1])
        if not 1 <= line <= len(own.composed.origins):
            return match[0]
        return place_of(line, exercise, own) + ":"

    message = re.sub(r"^The shader \S+ does not compile\. Fix the line that is named:",
                     "Fix the line that is named, or the one before it:", message)
    return re.sub(rf"(?<![\w/]){re.escape(short)}:(\d+):", name, message)


@contextlib.contextmanager
def overlay(exercise, own, counts_rounds=False):
    with tempfile.TemporaryDirectory(prefix="raysteps_overlay_") as name:
        path = Path(name) / exercise.place
        path.parent.mkdir(parents=True)
        if counts_rounds:
            rounds.write_counted(own.composed.text, path, Path(name) / "shaders")
        else:
            path.write_text(text_for_compiler(exercise, own))
        yield Path(name)
