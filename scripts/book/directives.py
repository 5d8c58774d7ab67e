"""What a page asks for in a comment, which code hosts do not show:

    <!-- code: shaders/structure/grid/grid_cells.glsl first_axis -->  that function's text
    <!-- output: 04_grid --scene bunny --measure -->              what that command prints
    <!-- walk: grid -->                                           a figure to turn and step
    <!-- list: exercises -->                                      exercises, or sources
    <!-- play: 6.2 -->                                            that exercise, to be written and checked in the page
    <!-- play: scene=mirrors&view=shaded&open=plan -->            the playground, as a link with that hash has it
"""

import hashlib
import html
import json
import re

from .cut_code import cut
from .errors import BookError
from .lists import LISTS

DIRECTIVE = re.compile(r"^<!-- (code|output|walk|list|play): (.+?) -->\s*$")
LANGUAGES = {".glsl": "glsl", ".frag": "glsl", ".vert": "glsl", ".inc": "cpp", ".h": "cpp",
             ".cpp": "cpp"}


def output_file(made, command):
    """Where the output of a command is kept."""
    return made / "outputs" / f"{hashlib.sha256(command.encode()).hexdigest()[:16]}.txt"


def program_and_arguments(command):
    program, _, arguments = command.partition(" ")
    return program, arguments


def shown_command(command):
    """As a reader types it."""
    program, arguments = program_and_arguments(command)
    if program == "visualizer":
        return f"./run.sh view {arguments}".strip()
    return f"./run.sh {program.partition('_')[0] if program[0].isdigit() else program} {arguments}".strip()


def _code(words, links, _page):
    path_text, _, name = words.partition(" ")
    path = links.root / path_text
    if not path.is_file() or not name:
        raise BookError(f"{path_text} is no file of the project. Write: code: FILE NAME.")
    try:
        lines, first = cut(path.read_text(), name)
    except BookError as error:
        raise BookError(f"{path_text}: {error}") from error
    link = links.source(path.relative_to(links.root))
    return [f"*[{path_text}]({link}#L{first}), from line {first}:*", "",
            f"```{LANGUAGES.get(path.suffix, 'text')}", *lines, "```"]


def _output(command, links, _page):
    path = output_file(links.made, command)
    if not path.is_file():
        raise BookError(f"the output of `{command}` has not been made. Build the target "
                        "book_figures.")
    return [f"`{shown_command(command)}` prints", "", "```text",
            *path.read_text().rstrip("\n").split("\n"), "```"]


def _walk(name, links, _page):
    scene = links.made / "walks" / f"{name}.json"
    if not scene.is_file():
        raise BookError(f"the walk {name} has not been made. Build the target book_figures.")
    about = json.loads((links.made / "walks" / f"{name}.about.json").read_text())
    links.copy(scene, f"walks/{name}.json")
    links.copy(scene.with_suffix(".png"), f"walks/{name}.png")
    caption = html.escape(about["caption"])
    command = html.escape(shown_command(about["command"]))
    viewer = "" if links.has_viewer else ' data-viewer="none"'
    return [f'<figure class="walk" data-walk="walks/{name}.json"{viewer}>',
            f'<img src="walks/{name}.png" alt="{caption}" loading="lazy">',
            f"<figcaption>{caption} In a window: <code>{command}</code></figcaption>",
            "</figure>"]


def _list(name, links, page):
    if name not in LISTS:
        raise BookError(f"there is no list {name}. Take one of {', '.join(LISTS)}.")
    return LISTS[name](links, page)


CHOICES = {"scene", "walk", "triangle", "view", "size", "file", "open"}


def _play(number, links, _page):
    if "=" in number:
        unknown = {choice.split("=")[0] for choice in number.split("&")} - CHOICES
        if unknown:
            raise BookError(f"the playground has no choice {min(unknown)}. Take one of {', '.join(sorted(CHOICES))}.")
        link = html.escape(f"#{number}")
        return [f'<div class="play" data-play="{link}">', f'<p><a href="playground/index.html{link}">Open it in the playground</a></p>', "</div>"]
    exercise = next((each for each in links.exercises if each.is_shader and each.number == number), None)
    if exercise is None:
        raise BookError(f"{number} is no exercise in a shader. Name one of exercises.toml.")
    return [f'<div class="play" data-play="{number}">',
            f'<p><a href="playground/exercises.html#exercise={number}">{number} {html.escape(exercise.title)}: write it in the '
            "playground</a></p>", "</div>"]


KINDS = {"code": _code, "output": _output, "walk": _walk, "list": _list, "play": _play}


def directives_in(text):
    """Pairs of kind and words, as they come."""
    return [found.groups() for found in map(DIRECTIVE.match, text.split("\n")) if found]


def carry_out(line, links, page):
    """The lines that stand for the directive in this line; None where it holds none."""
    found = DIRECTIVE.match(line)
    return KINDS[found.group(1)](found.group(2), links, page) if found else None
