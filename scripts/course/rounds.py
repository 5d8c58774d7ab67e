"""Counts the rounds of a shader's loops: a software renderer leaves a loop that never ends without a word
(llvmpipe after 65535 rounds), and then the answer is only wrong."""

import re

from .exercises import ROOT

MOST_ROUNDS = 50_000  # of all loops of one ray together
ENDLESS = 0xE7D1E55  # then the answer is this, the line of the loop, and this twice

COUNTER = f"""int course_rounds = 0;
int course_line = 0;
bool course_goes_on(int line) {{
    course_line = ++course_rounds == {MOST_ROUNDS} ? line : course_line;
    return course_rounds < {MOST_ROUNDS};
}}
"""
LOOP = re.compile(r"\b(for|while)\s*\(")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def _end_of(text, start):
    """Where the parenthesis that is open at `start` closes; None where it does not."""
    depth = 1
    for place in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place
    return None


def _condition(text, kind, start, end):
    """From where to where the condition goes, in `(...)` of a loop; None where it has no such form."""
    if kind == "while":
        return start, end
    parts = [place for place in range(start, end) if text[place] == ";"]
    return (parts[0] + 1, parts[1]) if len(parts) == 2 else None


def counted(text):
    """The text with a counter in the condition of each loop."""
    bare = COMMENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    for loop in reversed(list(LOOP.finditer(bare))):
        end = _end_of(bare, loop.end())
        place = _condition(bare, loop[1], loop.end(), end) if end else None
        if place:
            start, end = place
            condition = f" && ({text[start:end]}\n)" if bare[start:end].strip() else ""
            line = bare.count("\n", 0, loop.start()) + 1
            text = f"{text[:start]} course_goes_on({line}){condition}{text[end:]}"
    return COUNTER + text


def has_loop(text):
    return LOOP.search(COMMENT.sub("", text)) is not None


def write_counted(text, path, shaders):
    """The shader with counters, and the passes of checkpoints that tell of them."""
    path.write_text(counted(text))
    for name in ("checkpoint.frag", "packet_checkpoint.frag"):
        told = (ROOT / "scripts/course/answers/shaders" / name).read_text()
        asked = "answer = checkpoint(ray, step_number);"
        assert told.count(asked) == 1
        (shaders / name).write_text(told.replace(asked, f"""{asked}
    if (course_rounds >= {MOST_ROUNDS}) {{
        answer = uvec4({ENDLESS}u, uint(course_line), {ENDLESS}u, {ENDLESS}u);
    }}"""))


def endless(answer):
    """Step, index and line of the first answer that says a loop does not end; None where none does."""
    for step, found in enumerate(answer.steps, 1):
        for index, numbers in enumerate(found):
            first, line, *rest = numbers[:4]
            if [first, *rest] == [ENDLESS] * 3:
                return step, index, line
    return None
