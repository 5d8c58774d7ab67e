"""Lists in the book that are collected from the project, so that nothing is written twice."""

import re

from . import drawings_zip, plans
from .contents import chapters, title_of


def exercises(links, _page):
    """Every exercise: a row each, by chapter."""
    lines = ["| exercise | what is to be written | in | points |", "| --- | --- | --- | --- |"]
    points = 0
    for exercise in links.exercises:
        language = "words" if exercise.experiment else "GLSL" if exercise.is_shader else "C++"
        lines.append(f"| {exercise.number} | {exercise.title} | {language} | 1 |")
        points += 1
    return [*lines, f"| | | together | {points} |"]


def section(text, heading):
    """The lines below a heading of the second level, up to the next one."""
    found = re.search(rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", text,
                      flags=re.MULTILINE | re.DOTALL)
    return found.group(1).strip("\n").split("\n") if found else []


def items(lines):
    """Items of a list, each as one line."""
    found = []
    for line in lines:
        if line.startswith("- "):
            found.append(line[2:].strip())
        elif line.startswith("  ") and found:
            found[-1] += " " + line.strip()
    return found


def work(item):
    """What tells one work from another: its title, in small letters."""
    title = re.search(r'"([^"]+)"', item)
    return re.sub(r"\W+", " ", title.group(1) if title else item).strip().lower()


def family_name(item):
    """Of the first author, by which works are sorted."""
    first = re.split(r",| and |:", item)[0].split()
    return (first[-1] if first else "").lower()


def sources(links, _page):
    """Every work that a chapter names, once, with the chapters that name it."""
    found = {}
    for path in [*chapters(links.root), links.root / "chapters/hard_cases/README.md"]:
        text = (links.root / path).read_text()
        page = links.page_names[(links.root / path).relative_to(links.root)]
        for item in items(section(text, "Sources")):
            entry = found.setdefault(work(item), {"text": item, "pages": {}})
            entry["text"] = max(entry["text"], item, key=len)
            entry["pages"][page] = title_of(text)
    lines = []
    for key in sorted(found, key=lambda key: (family_name(found[key]["text"]), key)):
        entry = found[key]
        named = ", ".join(f"[{title}]({page})" for page, title in entry["pages"].items())
        lines.append(f"-   {entry['text'].rstrip('.')}. ({named})")
    return lines


LISTS = {"exercises": exercises, "sources": sources, **plans.LISTS, **drawings_zip.LISTS}
