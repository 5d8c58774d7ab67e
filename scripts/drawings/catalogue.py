"""The drawings of the project: each is a description NAME.py in a folder `drawings`, and NAME.svg beside it.

A description has ALT, what the drawing shows in words; HEIGHT, of 560 wide; SENTENCES of the text beside
it that its numbers stand in; and draw(canvas, lesson). One that moves in the book has MOVES as well: what moves,
in words with {} for its value, the values, and which of them the still drawing has; and draw takes a value."""

import importlib.util
from dataclasses import dataclass
from pathlib import Path

from drawings.canvas import Canvas
from drawings.lesson import Lesson

ROOT = Path(__file__).resolve().parents[2]
FOLDER = "chapters/*/drawings"


@dataclass
class Drawing:
    path: Path  # of the description
    lesson: Lesson
    alt: str
    sentences: list
    svg: str
    numbers: list
    moving_svg: str  # empty where nothing moves
    moments: list  # the words of each

    @property
    def file(self):
        return self.path.with_suffix(".svg")


def descriptions(root=ROOT):
    return sorted(root.glob(f"{FOLDER}/*.py"))


def make(path):
    """Draws what the description says."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    description = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(description)
    lesson = Lesson(path.parent.parent / "README.md")

    def drawn(*value):
        canvas = Canvas(description.HEIGHT, description.ALT)
        description.draw(canvas, lesson, *value)
        return canvas

    words, values, still = getattr(description, "MOVES", ("", [], None))
    canvas = drawn(still) if values else drawn()
    moving = canvas.moving_svg([drawn(value) for value in values]) if values else ""
    return Drawing(
        path,
        lesson,
        description.ALT,
        description.SENTENCES,
        canvas.svg(),
        canvas.numbers,
        moving,
        [words.format(f"{value:g}") for value in values],
    )
