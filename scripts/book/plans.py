"""Plans for a course, from docs/book/plans.toml: an item for each sitting, with the minutes that reading and writing take."""

import re
import tomllib
from fractions import Fraction

from .contents import title_of
from .errors import BookError

PLANS = "docs/book/plans.toml"
WORDS_A_MINUTE = 60  # of a text with formulas and drawings, read with a pencil in hand
ROUNDED_TO = 5


def words_in(text):
    """How many words of a page are read: without code, tables and sources."""
    text = re.sub(r"^## (?:Sources|Tests)\n.*?(?=^## |\Z)", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"```.*?```|^(?: {4}|\|)[^\n]*$|<!--.*?-->|!\[[^\]]*\]|\([^()\s]*\)", " ", text,
                  flags=re.MULTILINE | re.DOTALL)
    return len(re.findall(r"\w+", text))


def _rounded(minutes):
    return ROUNDED_TO * max(1, round(minutes / ROUNDED_TO))


def _file(links, name):
    for path in links.page_names:
        if name in (path.stem, path.parent.name):
            return path
    raise BookError(f"{PLANS}: there is no page {name}. Name a chapter's folder or a file of docs.")


def _reading(links, entry):
    """A link to a page, and the minutes that its reading takes."""
    path = _file(links, entry[0])
    text = (links.root / path).read_text()
    part = entry[1] if len(entry) > 1 else 1
    words = f"{Fraction(part).limit_denominator(9)} of " if part != 1 else ""
    return (f"{words}[{title_of(text)}]({links.page_names[path]})", part * words_in(text) / WORDS_A_MINUTE)


def plan(name):
    """The list of that plan, an item for each sitting or week."""
    def lines(links, _page):
        made = []
        minutes = {exercise.number: exercise.minutes for exercise in links.exercises}
        for row in tomllib.loads((links.root / PLANS).read_text())[name]:
            pages = [_reading(links, entry) for entry in row["read"]]
            reading = _rounded(sum(minutes for _, minutes in pages))
            writing = sum(minutes[number] for number in row["exercises"])
            made += [f"-   **{row['when']}.** Read {', '.join(link for link, _ in pages)}: {reading} minutes. Exercises "
                     f"{', '.join(row['exercises'])}: {writing} minutes.<br>",
                     f"    *In class:* {row['show']}.<br>",
                     f"    *Afterwards* students can {row['afterwards']}."]
        return made
    return lines


NAMES = ("weekend", "four_weeks", "term")
LISTS = {f"plan_{name}": plan(name) for name in NAMES}
