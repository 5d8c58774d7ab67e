"""Links the words of the glossary: each at its first use in a lesson, with its meaning for a tooltip.

The glossary's first column has the word; what follows a comma is another form of it. Where a word means other things
as well, a comment names the phrases in which it means this, with # for any number: `slip <!-- *slip*, slip # -->`. A word in backticks is
one of GLSL, and is linked where it stands as code by itself."""

import re
from dataclasses import dataclass
from pathlib import Path

GLOSSARY = Path("docs/book/glossary.md")
PAGE = "glossary.md"
ROW = re.compile(r"^\| (.+?) \| (.+?) \| .+ \|$")
PHRASES = re.compile(r"<!-- (.+?) -->")
# Where no word is linked: headings, rows that head a table, summaries, tags, formulas, code, links and pictures.
BARRED = re.compile(
    r"^#[^\n]*$|^\|[^\n]*\n(?=\|[ -|:]*---)|<summary[^>]*>.*?</summary>|<[^<>]+>|\$\$.+?\$\$|\$[^$]+\$|(?P<ticks>`+).+?(?P=ticks)"
    r"|!?\[[^\[\]]*\]\([^()]*\)(?:\{[^{}]*\})?", re.MULTILINE | re.DOTALL)
UNREAD = re.compile(r"^## Sources\n.*?(?=^## |\Z)|<details[^>]*>\s*<summary[^>]*>The symbols.*?</details>",
                    re.MULTILINE | re.DOTALL)
FOLD = re.compile(r"<details.*?</details>", re.DOTALL)
SYMBOLS = re.compile(r"<summary>The symbols[^<]*</summary>\n\n(.*?)\n(?:\n|</details>)", re.DOTALL)


@dataclass
class Word:
    name: str  # as the glossary has it
    anchor: str
    meaning: str
    pattern: re.Pattern
    is_code: bool
    has_phrases: bool  # only in these it means what the glossary says


def _plural(form):
    if form.endswith("leaf"):
        return f"{form}|{form[:-1]}ves"
    if form.endswith(("s", "x", "sh", "ch")):
        return f"{form}(?:es)?"
    return f"{form[:-1]}(?:y|ies)" if re.search("[^aeiou]y$", form) else f"{form}s?"


def _pattern(forms, is_code, is_exact):
    found = []
    for form in sorted(forms, key=len, reverse=True):
        spaced = r"\s+".join(map(re.escape, form.split())).replace(r"\#", r"\d+")
        found.append(f"`{spaced}`" if is_code else spaced if is_exact else _plural(spaced))
    start, end = ("", "") if is_code else (r"(?<![\w`-])", r"(?![\w`-])")
    case = re.IGNORECASE if not any(form.isupper() for form in forms) else re.NOFLAG
    return re.compile(f"{start}(?:{'|'.join(found)}){end}", case)


def plain(meaning):
    """What a tooltip can show: words alone."""
    return re.sub(r"\[([^\]]*)\]\([^)]*\)|[$`*{}]", r"\1", meaning).replace('"', "'")


def words_of(text):
    """The words of a glossary's text, in its order."""
    found = []
    for row in filter(None, map(ROW.match, text.split("\n")[1:])):
        cell, meaning = row.groups()
        if cell in ("word", "---"):
            continue
        phrases = PHRASES.search(cell)
        name = re.sub(r"<!--.*?-->|\(.*?\)", "", cell).strip()
        forms = [form.strip(" `") for form in (phrases.group(1) if phrases else name).split(",")]
        is_code = name.startswith("`")
        anchor = re.sub(r"\W+", "-", name.split(",")[0].strip("`")).lower()
        found.append(Word(name, anchor, plain(meaning), _pattern(forms, is_code, phrases), is_code, bool(phrases)))
    return found


def _blank(found):
    return re.sub(r"[^\n]", "\0", found.group())


def _barred(text):
    """The text with all that must not be linked blanked out; what is code by itself stays."""
    return BARRED.sub(lambda found: found.group() if re.fullmatch(r"`\w+`", found.group()) else _blank(found),
                      UNREAD.sub(_blank, text))


def link_words(lines, code, words):
    """The lines with each word linked once: where it is first read, or else in a fold. `code` says of each line
    whether it is one of code."""
    text = "\n".join(lines)
    without_code = "\n".join("\0" * len(line) if is_code else line for line, is_code in zip(lines, code))
    all_text, open_text = _barred(without_code), _barred(FOLD.sub(_blank, without_code))
    found = []
    for word in sorted(words, key=lambda word: -len(word.name)):
        first = word.pattern.search(open_text) or word.pattern.search(all_text)
        if first:
            begin, end = first.span()
            found.append((begin, end, word))
            all_text, open_text = (one[:begin] + "\0" * (end - begin) + one[end:] for one in (all_text, open_text))
    for begin, end, word in sorted(found, key=lambda one: one[0], reverse=True):
        link = f'[{text[begin:end]}]({PAGE}#{word.anchor}){{ .word data-meaning="{word.meaning}" }}'
        text = text[:begin] + link + text[end:]
    return text.split("\n")


def symbols_of(text):
    """The symbols in a lesson's table, in their order: of `$W, H$` both, of `$R = 2w$` what stands before the sign,
    of `$E(p, q)$` the letter."""
    table = SYMBOLS.search(text)
    cells = [row.strip("|").split(" | ")[0] for row in table.group(1).split("\n")[2:]] if table else []
    return [symbol.strip() for cell in cells for formula in re.findall(r"\$([^$]+)\$", cell)
            for symbol in re.sub(r"(\w)\([^()]*\)", r"\1", formula.split("=")[0]).strip(" ()").split(",")]


def with_anchors(lines):
    """The glossary's own lines, with a place to link to in each row."""
    anchors = iter(words_of("\n".join(lines)))
    made = []
    for line in lines:
        row = ROW.match(line)
        if row and row.group(1) not in ("word", "---"):
            line = f'| <span id="{next(anchors).anchor}"></span>{line[2:]}'
        made.append(line)
    return made
