"""The text that a drawing belongs to: the numbers of the one are the numbers of the other."""

import re

from drawings.words import numbers


class LessonError(Exception):
    """A drawing and its lesson do not agree. The text says where, and what to do."""


def _flat(text):
    """As one line, without the marks of Markdown and of formulas."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"\\(mathbf|boldsymbol|mathrm|,)\s*", "", text)
    return re.sub(r"\s+", " ", re.sub(r"[$`*{}\\]", "", text)).strip()


class Lesson:
    def __init__(self, path):
        self.path = path
        self.text = path.read_text(encoding="utf-8")
        self.cells = []  # of the rows that a drawing was made from

    def has(self, sentence):
        return _flat(sentence) in _flat(self.text)

    def row(self, heading, first):
        """The cells of the row that begins with `first`, in the table whose header is `heading`: the drawing may
        show their numbers."""
        lines = self.text.split("\n")
        if heading not in lines:
            raise LessonError(f"{self.path}: has no table with the header {heading!r}. Look at the drawing.")
        for line in lines[lines.index(heading) + 2 :]:
            if not line.startswith("|"):
                break
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if cells[0].strip("`") == first:
                self.cells += cells
                return cells
        raise LessonError(f"{self.path}: the table {heading!r} has no row {first}. Look at the drawing.")

    def lacking(self, sentences, shown):
        """What is wrong between a drawing and its lesson: sentences, one for each fault."""
        faults = [f"does not say: {sentence}" for sentence in sentences if not self.has(sentence)]
        said = {number for sentence in [*sentences, *self.cells] for number in numbers(_flat(sentence))}
        faults += [
            f"its drawing shows {number}, which stands in none of the sentences that it names"
            for number in sorted(set(shown) - said)
        ]
        return faults
