"""The whole book as one PDF: its pages one after the other in one page, printed by a headless browser."""

import re
from pathlib import Path

from .browser import run_browser
from .contents import page_name, parts
from .errors import BookError

WHOLE = "whole.html"
PDF = "raysteps.pdf"
ARTICLE = re.compile(r"<article[^>]*>(.*)</article>", re.DOTALL)
FRAME = """<!doctype html>
<html lang="en" dir="ltr"><head><meta charset="utf-8"><title>Raysteps</title>
{styles}
<style>section {{ break-before: page; }} section:first-of-type {{ break-before: auto; }}</style></head>
<body data-md-color-scheme="default" data-md-color-primary="blue-grey" dir="ltr"><div class="md-typeset">
{sections}
</div><script src="assets/katex/katex.min.js"></script><script src="assets/formulas.js"></script></body></html>
"""


def section(name, page, names):
    """The text of a page as a part of the whole: its marks are its own, its links stay within the book, and its
    answers are open. Links to sources, which paper does not have, are words."""
    found = ARTICLE.search(page)
    if not found:
        raise BookError(f"{name}.html: has no article. Is the book made by mkdocs-material?")

    def linked(link):
        target, _, mark = link.group(2).partition("#")
        target = target.removesuffix(".html") if target else name
        if "://" in target:
            return link.group()
        if target not in names:
            return link.group(1)
        return f'{link.group(1)} href="#{target}--{mark}"' if mark else f'{link.group(1)} href="#{target}"'

    text = re.sub(r'(<a\b[^>]*?)\s*href="([^"]*)"', linked, found.group(1))
    text = re.sub(r'\bid="([^"]*)"', rf'id="{name}--\1"', text)
    text = text.replace("<details", "<details open").replace('loading="lazy"', "")
    text = text.replace(' data-viewer="none"', "").replace('<figure class="walk"', '<figure class="walk" data-viewer="none"')
    return f'<section id="{name}">{text}</section>'


def whole_book(root, site):
    """The pages of a made book as the text of one page."""
    names = [Path(name).stem for name in (page_name(path) for _, paths in parts(root) for path in paths)]
    styles = re.findall(r'<link rel="stylesheet"[^>]*>', (site / "index.html").read_text())
    return FRAME.format(styles="\n".join(styles), sections="\n".join(
        section(name, (site / f"{name}.html").read_text(), names) for name in names))


def print_book(root, store):
    """Where the PDF of the made book lies."""
    site, pdf = store / "site", store / PDF
    (site / WHOLE).write_text(whole_book(root, site))
    run_browser(site / WHOLE, f"--print-to-pdf={pdf}", "--no-pdf-header-footer", "--generate-pdf-document-outline",
                what="the book cannot be printed")
    return pdf
