"""Turns Markdown as code hosts read it into Markdown as Python-Markdown does."""

import re

ITEM = re.compile(r"^( {0,3})([-*]|\d+\.)( +)\S")
TARGET = re.compile(r"(!?)(\[[^\[\]]*\])\(([^()\s]+)\)")


def is_code(lines):
    """For each line, whether it belongs to a block of code: fenced, or indented by four spaces
    after an empty line and outside of a list."""
    found, fenced, indented, in_list, before = [], False, False, False, ""
    for line in lines:
        if line.lstrip().startswith("```"):
            found.append(True)
            fenced = not fenced
            continue
        if not fenced and line.strip():
            if ITEM.match(line):
                in_list = True
            elif not line.startswith(" "):
                in_list = False
            is_deep = line.startswith("    ") and not in_list
            indented = is_deep and (indented or not before.strip())
        found.append(fenced or (indented and bool(line.strip())))
        before = line
    return found


def widen_lists(lines, code):
    """The text of an item stands under the item's first word; Python-Markdown wants four spaces.
    And it wants an empty line before a list, and after an item of several paragraphs."""
    widened, width, before, in_item, is_long = [], 0, "", False, False
    for line, is_block in zip(lines, code):
        item = None if is_block else ITEM.match(line)
        if item:
            if before.strip() and (is_long or not in_item):
                widened.append("")
            is_long = False
            width = len(item.group()) - 1
            in_item = True
            widened.append(item.group(1) + item.group(2).ljust(4) + line[width:])
        elif in_item and line.startswith(" " * width):
            is_long = is_long or not before.strip()
            widened.append("    " + line[width:])
        else:
            in_item = in_item and not line.strip()
            widened.append(line)
        before = line
    return widened


def open_details(line):
    """The text between HTML's details is Markdown as well."""
    return re.sub(r"^<details><summary>(.*)</summary>$",
                  r'<details markdown="1">\n<summary markdown="span">\1</summary>', line)


def change_targets(line, change):
    """The line with the target of each link and picture changed; code stays as it is.
    `change(target, is_picture)` gives the new one; of a picture with its attributes behind it, in braces."""
    spans = []

    def hide(found):
        spans.append(found.group())
        return f"\0{len(spans) - 1}\0"

    def changed(found):
        target, brace, attributes = change(found.group(3), found.group(1) == "!").partition("{")
        return f"{found.group(1)}{found.group(2)}({target}){brace}{attributes}"

    hidden = TARGET.sub(changed, re.sub(r"(`+)[^`]+\1", hide, line))
    return re.sub(r"\0(\d+)\0", lambda found: spans[int(found.group(1))], hidden)
