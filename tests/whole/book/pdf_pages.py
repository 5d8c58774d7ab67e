"""What stands on the pages of a PDF that Chromium has printed: its texts, in the order in which they were painted."""

import re
import zlib

PAGE = re.compile(rb"<</Type /Page\n.*?/Contents (\d+) 0 R", re.DOTALL)
FONT = re.compile(rb"/F\d+ ([\d.]+) Tf|(<[0-9A-Fa-f]+>) Tj|/X\d+ (Do)")


def _content(pdf, number):
    begin = pdf.index(b"stream", pdf.index(b"\n%d 0 obj" % number)) + len(b"stream")
    return zlib.decompress(pdf[begin:pdf.index(b"endstream", begin)].lstrip(b"\r\n"))


def pages(pdf):
    """Of each page the sizes of its letters, a number for each piece of text, and whether it has a picture."""
    found = []
    for page in PAGE.finditer(pdf):
        size, sizes, pictured = 0.0, [], False
        for mark in FONT.finditer(_content(pdf, int(page.group(1)))):
            if mark.group(1):
                size = float(mark.group(1))
            elif mark.group(2):
                sizes.append(size)
            else:
                pictured = True
        found.append((sizes, pictured))
    return found
