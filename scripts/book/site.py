"""The book as a site: pages, formulas, figures and the interfaces of the code, by MkDocs."""

import json
import shutil
import subprocess
import zipfile
from pathlib import Path

from drawings.palette import page_style
from playground.data import copy_page

from .editor_library import fetch_editor
from .errors import BookError, MachineError
from .interfaces import make_interfaces
from .pages import make_pages
from .viewer import fetch_viewer

KATEX = Path("/usr/share/javascript/katex")
KATEX_FILES = ("katex.min.js", "katex.min.css")
THEME = "docs/book/page/theme"
OWN_FILES = ("formulas.js", "page.js", "moving.js", "walk.js", "walk_scene.js", "book.css")


def _palette(preferred, scheme, icon, switch):
    """The colours for who prefers this, and the switch to the others."""
    return {"media": f"(prefers-color-scheme: {preferred})", "scheme": scheme,
            "primary": "blue grey", "accent": "deep orange",
            "toggle": {"icon": f"material/{icon}", "name": switch}}


def settings(pages, site, order, theme):
    """What MkDocs is told. JSON is YAML too."""
    return {
        "site_name": "Raysteps",
        "docs_dir": str(pages),
        "site_dir": str(site),
        "use_directory_urls": False,
        "nav": order,
        "theme": {"name": "material", "custom_dir": str(theme), "font": False, "language": "en",
                  "features": ["navigation.sections", "navigation.top"],
                  "palette": [_palette("light", "default", "weather-night", "Dark pages"),
                              _palette("dark", "slate", "weather-sunny", "Light pages")]},
        "plugins": ["search"],
        "extra": {"generator": False},
        "extra_css": ["assets/katex/katex.min.css", "assets/drawings.css", "assets/book.css"],
        "extra_javascript": ["assets/katex/katex.min.js", "assets/formulas.js",
                             "assets/page.js", "assets/moving.js", "assets/walk_scene.js", "assets/walk.js", "playground/load.js"],
        "markdown_extensions": ["tables", "md_in_html", "attr_list", "pymdownx.superfences",
                                {"pymdownx.arithmatex": {"generic": True}},
                                {"pymdownx.highlight": {"anchor_linenums": False}},
                                {"toc": {"permalink": False}}],
    }


def _copy_assets(root, pages, viewer):
    assets = pages / "assets"
    if not (KATEX / KATEX_FILES[0]).exists():
        raise MachineError(f"{KATEX}: is not there. Install libjs-katex, which sets the formulas.")
    shutil.copytree(KATEX / "fonts", assets / "katex" / "fonts")
    for name in KATEX_FILES:
        shutil.copyfile(KATEX / name, assets / "katex" / name)
    for name in OWN_FILES:
        shutil.copyfile(root / "docs" / "book" / "page" / name, assets / name)
    (assets / "drawings.css").write_text(page_style())
    if viewer:
        shutil.copyfile(viewer, assets / "vtk.js")


def _run_mkdocs(file):
    """MkDocs is strict: a link into nowhere is an error."""
    if not shutil.which("mkdocs"):
        raise MachineError("mkdocs is missing. Install mkdocs-material.")
    done = subprocess.run(["mkdocs", "build", "--quiet", "--strict", "--config-file", str(file)],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise BookError(f"mkdocs: {(done.stdout + done.stderr).strip()[-2000:]}")


def make_site(root, store, say):
    """Builds the book into `store`/site. `store` also keeps what was made and fetched before."""
    pages, site = store / "pages", store / "site"
    shutil.rmtree(pages, ignore_errors=True)
    viewer = fetch_viewer(root, store / "viewer", say)
    order = make_pages(root, pages, store / "figures", viewer is not None)
    _copy_assets(root, pages, viewer)
    copy_page(root, store / "playground", pages / "playground", fetch_editor(root, store / "viewer", say))
    make_interfaces(root, pages / "api", say)
    file = store / "mkdocs.yml"
    file.write_text(json.dumps(settings(pages, site, order, root / THEME), indent=1))
    _run_mkdocs(file)
    # Pages that are not of MkDocs' making name no icon, and browsers then ask for this one.
    shutil.copyfile(site / "assets" / "images" / "favicon.png", site / "favicon.ico")
    return site


def zip_site(store):
    """Packs the site into one file, in a folder: for the server of a school, or a stick."""
    file = store / "raysteps_book.zip"
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted((store / "site").rglob("*")):
            if path.is_file():
                archive.write(path, Path("raysteps_book") / path.relative_to(store / "site"))
    return file
