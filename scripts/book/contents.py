"""Which files are pages of the book, and in which order."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
AFTERNOON = Path("docs/book/afternoon.md")


def chapters(root):
    return sorted(path.relative_to(root) for path in root.glob("chapters/[0-9][0-9]_*/README.md"))


def parts(root):
    """Pairs of a part's name and the paths of its pages."""
    return [
        ("Begin", [Path("docs/book/preface.md"), Path("docs/book/set_up.md"), AFTERNOON]),
        ("Chapters", [*chapters(root), Path("chapters/hard_cases/README.md")]),
        ("Tools", [Path("visualizer/README.md"), Path("docs/course.md"),
                   Path("docs/scene_files.md"), Path("docs/ray_files.md"),
                   Path("docs/tree_files.md"), Path("docs/figures.md")]),
        ("Teachers", [Path("docs/book/teaching.md"), Path("docs/book/add_an_exercise.md"),
                      Path("docs/book/add_a_structure.md")]),
        ("Look up", [Path("docs/book/glossary.md"), Path("docs/book/sources.md"),
                     Path("docs/numerics.md"), Path("docs/architecture.md"),
                     Path("docs/style.md"), Path("docs/book/interfaces.md")]),
    ]


def is_lesson(path):
    """Whether a page is read from its begin to its end, so that its words are explained."""
    return path.parts[0] == "chapters" or path == AFTERNOON


def page_name(path):
    """The file of a page in the book. All lie in one folder, so that links are plain names."""
    if path == Path("docs/book/preface.md"):
        return "index.md"
    if path.name == "README.md":
        return f"{path.parent.name}.md"
    return path.name


def page_names(root):
    """The page of each file that is one."""
    return {path: page_name(path) for _, paths in parts(root) for path in paths}


def title_of(text):
    """The first heading."""
    for line in text.split("\n"):
        if line.startswith("# "):
            return line[2:].strip()
    return "Without a title"
