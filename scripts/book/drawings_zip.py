"""Every drawing as SVG and PNG in one archive, with its licence."""

import base64
import hashlib
import re
import shutil
import tempfile
import zipfile
from pathlib import Path

from drawings.canvas import WIDTH
from drawings.catalogue import descriptions

from .browser import has_browser, run_browser
from .errors import BookError

ARCHIVE = "drawings.zip"
SCALE = 2  # a PNG is 1,120 pixels wide
DAY = (1980, 1, 1, 0, 0, 0)  # of all files: so the same drawings make the same archive
# When all SVGs are loaded, draws each upon a canvas, and leaves the PNG in the page as text.
PAGE = """<!doctype html><meta charset="utf-8"><meta name="color-scheme" content="light"><body>{images}<script>
addEventListener("load", () => {{
  const lines = [...document.images].map((image) => {{
    const canvas = document.createElement("canvas");
    canvas.width = {scale} * image.naturalWidth;
    canvas.height = {scale} * image.naturalHeight;
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return `PNG ${{image.alt}} ${{canvas.toDataURL("image/png").split(",")[1]}} GNP`;
  }});
  document.body.textContent = lines.join(" ");
}});
</script></body>
"""


def pictures_of(drawings):
    """The PNG of each SVG, by its name. Takes one start of the browser."""
    with tempfile.TemporaryDirectory(prefix="raysteps_drawings_") as folder:
        page = Path(folder) / "drawings.html"
        images = "".join(
            f'<img alt="{name}" src="data:image/svg+xml;base64,{base64.b64encode(svg.encode()).decode()}">'
            for name, svg in drawings.items())
        page.write_text(PAGE.format(images=images, scale=SCALE))
        printed = run_browser(page, "--dump-dom", what="drawings have no PNG")
    found = dict(re.findall(r"PNG (\w+) ([\w+/=]+) GNP", printed))
    if set(found) != set(drawings):
        raise BookError(f"the browser made {len(found)} of {len(drawings)} drawings as PNG. Make the book again.")
    return {name: base64.b64decode(picture) for name, picture in found.items()}


def make_archive(root, file, kept):
    """Writes the archive, and returns how many drawings it has, and whether as PNG too: that takes a browser, and
    longer than all pages of the book, so the folder `kept` has it until a drawing changes."""
    drawings = {f"{path.parent.parent.name}_{path.stem}": path.with_suffix(".svg").read_text(encoding="utf-8")
                for path in descriptions(root)}
    entries = {"LICENSE": (root / "LICENSE").read_bytes()}
    entries |= {f"svg/{name}.svg": text.encode() for name, text in drawings.items()}
    has_png = bool(drawings) and has_browser()
    before = kept / f"drawings_{_digest(has_png, entries)}.zip"
    if not before.exists():
        pictures = pictures_of(drawings) if has_png else {}
        _write(before, entries | {f"png/{name}.png": picture for name, picture in pictures.items()})
    file.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(before, file)
    return len(drawings), has_png


def _digest(has_png, entries):
    """Of all that an archive is made of."""
    return hashlib.sha256(repr((has_png, PAGE, SCALE, DAY, sorted(entries.items()))).encode()).hexdigest()[:16]


def _write(file, entries):
    file.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in sorted(entries.items()):
            archive.writestr(zipfile.ZipInfo(name, DAY), data, zipfile.ZIP_DEFLATED)


def drawings(links, _page):
    """The sentence that offers the archive."""
    count, has_png = make_archive(links.root, links.out / ARCHIVE, links.made)
    kinds = (f"as SVG and as PNG of {SCALE * WIDTH:,} pixels" if has_png
             else "as SVG (this book was made without chromium, which makes the PNG)")
    return [f"[{ARCHIVE}]({ARCHIVE}) has all {count} drawings of this book, {kinds}, with their licence, MIT: use them in "
            "your own slides."]


LISTS = {"drawings": drawings}
