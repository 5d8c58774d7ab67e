"""Makes the pages of the book from the project's own texts."""

import re

from .contents import is_lesson, page_names, parts, title_of
from .directives import carry_out
from .errors import BookError
from .links import Links
from .markdown import change_targets, is_code, open_details, widen_lists
from .words import GLOSSARY, link_words, with_anchors


DRAWING = re.compile(r"^!\[([^\[\]]*)\]\(((?:[\w./]+/)?drawings/\w+\.svg)\)$")


def _moving(line, path, links):
    """The line with the picture of a drawing that moves; None where there is none."""
    found = DRAWING.match(line)
    script = found and links.moving(path, found.group(2))
    if not script:
        return None
    target, _, attributes = links.target(path, path, found.group(2), True).partition("{")
    return f'![{found.group(1)}]({target}){{ data-moving="{script}"{attributes}'


def make_page(path, links):
    """The text of one page. A fault ends in BookError with FILE:LINE."""
    lines = (links.root / path).read_text().split("\n")
    if path == GLOSSARY:
        lines = with_anchors(lines)
    code = is_code(lines)
    made = []
    made_code = []
    for number, (line, is_block) in enumerate(zip(lines, code), 1):
        place = f"{path}:{number}"
        if is_block:
            made.append(line)
            made_code.append(True)
            continue
        try:
            asked_for = carry_out(line, links, path)
        except BookError as error:
            raise BookError(f"{place}: {error}") from error
        if asked_for is not None:
            made += asked_for
            made_code += [True] * len(asked_for)
            continue
        text = _moving(line, path, links) or change_targets(
            open_details(line),
            lambda target, is_picture, place=place: links.target(path, place, target, is_picture))
        made += text.split("\n")
        made_code += [False] * (len(made) - len(made_code))
    if is_lesson(path):
        made = link_words(made, made_code, links.words)
    return "\n".join(widen_lists(made, made_code))


def make_pages(root, out, made, has_viewer=True):
    """Writes all pages into the folder `out`; returns the book's order as MkDocs wants it."""
    links = Links(root, out, page_names(root), made, has_viewer)
    out.mkdir(parents=True, exist_ok=True)
    order = []
    for part, paths in parts(root):
        entries = []
        for path in paths:
            text = make_page(path, links)
            (out / links.page_names[path]).write_text(text)
            entries.append({title_of(text): links.page_names[path]})
        order.append({part: entries})
    return order
