"""python3 -B scripts/drawings [NAME...]: makes the drawings of the lessons, or those of these names."""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from drawings.catalogue import ROOT, descriptions, make  # noqa: E402  (the path has to be there first)
from drawings.lesson import LessonError  # noqa: E402

DONE, FAULT, WRONG_INPUT = 0, 1, 2


def _parser():
    parser = argparse.ArgumentParser(prog="drawings", description="The drawings of the lessons, as SVG.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="a drawing, such as one_ulp; all of them")
    return parser


def main(arguments):
    """The exit code: 0 done, 1 a drawing does not agree with its lesson, 2 wrong usage."""
    names = _parser().parse_args(arguments).names
    known = {path.stem: path for path in descriptions()}
    unknown = [name for name in names if name not in known]
    if unknown:
        print(f"drawings: there is no {unknown[0]}. Take one of {', '.join(sorted(known))}.", file=sys.stderr)
        return WRONG_INPUT
    result = DONE
    for name in names or sorted(known):
        try:
            drawing = make(known[name])
        except LessonError as error:
            print(f"drawings: {name}: {error}", file=sys.stderr)
            return FAULT
        drawing.file.write_text(drawing.svg, encoding="utf-8")
        for fault in drawing.lesson.lacking(drawing.sentences, drawing.numbers):
            print(f"drawings: {drawing.lesson.path.relative_to(ROOT)}: {fault}", file=sys.stderr)
            result = FAULT
    return result


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
