"""What a person's lines may include or call, and the fields of the structs that they may meet."""

import re

from . import marks
from .exercises import ROOT

INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
STRUCT = re.compile(r"^struct (\w+)[^;{]*\{\n(.*?)^\}", re.MULTILINE | re.DOTALL)
FIELD = re.compile(r"^    (?!using|static|friend|return)[\w:<>,& ]*[\w>&] (\w+(?:, \w+)*)(?: = [^;]*|\{[^;]*\})?;",
                   re.MULTILINE)
FUNCTION = re.compile(r"^(\w+) (\w+)\(([^()]*)\) \{", re.MULTILINE)  # of a shader
COMMENT = re.compile(r"//[^\n]*")


def _text(path):
    return COMMENT.sub("", path.read_text())


def _known_files(exercise):
    """Those that may declare a struct of the exercise: what its file includes, and what that does; a shader
    is put together from all parts."""
    if exercise.is_shader:
        return [str(path.relative_to(ROOT / "shaders")) for path in sorted((ROOT / "shaders").rglob("*.glsl"))]
    found, waiting = [], INCLUDE.findall((ROOT / exercise.file).read_text())
    while waiting:
        name = waiting.pop(0)
        if name not in found and (ROOT / "common" / name).is_file():
            found.append(name)
            waiting += INCLUDE.findall((ROOT / "common" / name).read_text())
    return found


def fields(body):
    """The names of a struct's fields."""
    return [field for line in FIELD.findall(body) for field in line.split(", ")]


def of(exercise):
    """{file: {struct: [field, ...]}}: the files that the exercise's own includes, and all structs that it
    names, or that are fields of those."""
    own = (ROOT / exercise.file).read_text()
    folder = ROOT / ("shaders" if exercise.is_shader else "common")
    bodies = {(name, struct): body for name in _known_files(exercise)
              for struct, body in STRUCT.findall(_text(folder / name))}
    names = [struct for _, struct in bodies]
    # Where a struct is declared more than once, each part has its own.
    bodies = {place: body for place, body in bodies.items() if names.count(place[1]) == 1}
    words = set(re.findall(r"\w+", COMMENT.sub("", own)))
    found = {name: {} for name in INCLUDE.findall(own)}
    while met := [place for place in bodies if place[1] in words]:
        for name, struct in met:
            body = bodies.pop((name, struct))
            words |= set(re.findall(r"\w+", body))
            found.setdefault(name, {})[struct] = fields(body)
    return found


def functions(exercise):
    """How the functions of other parts are called that a person's shader names, in its comments too: so
    nobody has to open those files, which may have the solutions of other exercises."""
    if not exercise.is_shader:
        return []
    text = marks.blank((ROOT / exercise.file).read_text(), exercise.file)
    named, found = set(re.findall(r"(\w+)\(", text)), {}
    for name in _known_files(exercise):
        for returned, function, parameters in FUNCTION.findall(_text(ROOT / "shaders" / name)):
            types = (returned, *(parameter.split()[0] for parameter in parameters.split(",") if parameter))
            found.setdefault(function, {})[types] = f"{returned} {function}({' '.join(parameters.split())})"
    own = {function for _, function, _ in FUNCTION.findall(text)}
    # What parts declare in more than one way depends on the part that is chosen.
    return sorted(call for function, calls in found.items() if function in named - own and len(calls) == 1
                  for call in calls.values())


def as_text(exercise):
    lines = []
    for name, structs in of(exercise).items():
        lines.append(name)
        lines += [f"  {struct}: {', '.join(names)}" for struct, names in structs.items() if names]
    if not exercise.is_shader:
        lines.append("and all of the standard library, as <algorithm>")
    return lines
