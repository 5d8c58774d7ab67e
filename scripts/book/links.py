"""Where a link of a page leads in the book: to another page, to a picture, or to a source file,
which the book shows as a page of its own kind."""

import functools
import html
import os
import re
import shutil
import struct
from pathlib import Path

from course import exercises

from .cut_code import exercises_in
from .errors import BookError
from .moving import moving_script
from .words import GLOSSARY, words_of

PICTURES = (".png", ".svg", ".jpg")
SOURCE_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title>
<meta name="viewport" content="width=device-width">
<style>
:root {{ color-scheme: light dark; --aimed-at: #ffec99; }}
:root.default {{ color-scheme: light; }}
:root.slate {{ color-scheme: dark; --aimed-at: #5c4d00; }}
@media (prefers-color-scheme: dark) {{ :root:not(.default) {{ --aimed-at: #5c4d00; }} }}
body {{ font: 15px sans-serif; margin: 1em; }}
ol {{ font: 13px monospace; white-space: pre; overflow-x: auto; padding-left: 4em; margin: 0; }}
li::marker {{ color: #888; }}
li:target {{ background: var(--aimed-at); }}
summary {{ margin: 0.5em 0 0.5em 3em; cursor: pointer; }}
</style>
<script>
// The switch of the book's pages holds here too.
const key = Object.keys(localStorage).find((name) => name.endsWith(".__palette"));
if (key && localStorage.getItem("raysteps.scheme is chosen")) document.documentElement.className = JSON.parse(localStorage[key]).color.scheme;
</script></head><body><h1>{title}</h1>
{body}
</body></html>
"""


def lines_of(text):
    """Lines with their numbers. Those of an exercise are folded: the reader has to ask for the solution."""
    pieces, begin = [], 1
    lines = text.rstrip("\n").split("\n")

    def listed(first, last):
        return f'<ol start="{first}">' + "".join(
            f'<li id="L{number}">{html.escape(lines[number - 1])}</li>'
            for number in range(first, last + 1)) + "</ol>"

    for exercise, first, last in exercises_in(lines):
        pieces += [listed(begin, first - 1),
                   f"<details><summary>exercise {exercise}: show the solution</summary>",
                   listed(first, last), "</details>"]
        begin = last + 1
    return "".join([*pieces, listed(begin, len(lines))])


def size_of(file):
    """The width and height of a PNG or SVG, as attributes."""
    data = file.read_bytes()[:400]
    if data.startswith(b"\x89PNG"):
        width, height = struct.unpack(">II", data[16:24])
        return f" width={width} height={height}"
    found = re.search(rb"<svg[^>]* width='(\d+)' height='(\d+)'", data)
    return f" width={int(found[1])} height={int(found[2])}" if found else ""


class Links:
    """Knows the pages, and copies what they point to into the folder of the book."""

    def __init__(self, root, out, page_names, made, has_viewer=True):
        self.root, self.out, self.page_names, self.made = root, out, page_names, made
        self.has_viewer = has_viewer  # else figures stand still, and say so
        glossary = root / GLOSSARY
        self.words = words_of(glossary.read_text()) if glossary.exists() else []
        self.written = set()

    @functools.cached_property
    def exercises(self):
        """All of the coursework, in their order: read once for all pages."""
        return exercises.load(self.root)

    def target(self, page, place, target, is_picture):
        """The link for `target`, which stands in the file `page`; `place` is FILE:LINE."""
        if "://" in target or target.startswith(("#", "mailto:", "../api/", "api/")):
            return target
        path_text, _, anchor = target.partition("#")
        path = Path(os.path.normpath(self.root / page.parent / path_text)).relative_to(self.root)
        mark = f"#{anchor}" if anchor else ""
        if not (self.root / path).exists():
            raise BookError(f"{place}: {target} leads to {path}, which is not there. Fix the link.")
        if path in self.page_names:
            return self.page_names[path] + mark
        folder_page = path / "README.md"
        if folder_page in self.page_names:
            return self.page_names[folder_page] + mark
        if path == Path("README.md") or path == Path("."):
            return "index.md"
        if path.parent == Path("docs/playground") and path.suffix == ".html":
            return f"playground/{path.name}{mark}"
        if is_picture:
            return self.picture(path)
        if path.suffix in PICTURES:
            return self.picture(path).partition("{")[0]
        return self.source(path) + mark

    def picture(self, path):
        """A picture of the book's own making is taken before the one that lies in the project. It is loaded when the
        reader comes near it, and its room is kept."""
        name = "pictures/" + "_".join(path.parts)
        made = self.made / path
        file = made if made.exists() else self.root / path
        self.copy(file, name)
        return f"{name}{{ loading=lazy{size_of(file)} }}"

    def moving(self, page, target):
        """The script with the moments of the drawing `target` of a page; nothing where it stands still."""
        description = (self.root / page.parent / target).with_suffix(".py")
        if description.parent.name != "drawings" or not description.is_file():
            return ""
        name = f"pictures/{'_'.join(description.relative_to(self.root).with_suffix('.js').parts)}"
        script = moving_script(description, name)
        if script:
            (self.out / name).parent.mkdir(parents=True, exist_ok=True)
            (self.out / name).write_text(script)
        return name if script else ""

    def source(self, path):
        """A file as lines with numbers; a folder as a list of its files."""
        name = f"source/{'/'.join(path.parts)}.html"
        if name not in self.written:
            self.written.add(name)
            place = self.root / path
            body = self._files(path) if place.is_dir() else lines_of(place.read_text(errors="replace"))
            to = self.out / name
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_text(SOURCE_PAGE.format(title=html.escape(str(path)), body=body))
        return name

    def _files(self, path):
        entries = []
        for entry in sorted((self.root / path).iterdir()):
            if entry.is_file() and not entry.suffix == ".png":
                self.source(path / entry.name)
                entries.append(f'<li><a href="{path.name}/{entry.name}.html">'
                               f"{html.escape(entry.name)}</a></li>")
        return "<ul>" + "".join(entries) + "</ul>"

    def copy(self, path, name):
        if name not in self.written:
            self.written.add(name)
            (self.out / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, self.out / name)
