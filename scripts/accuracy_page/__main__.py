"""python3 -B scripts/accuracy_page out/08_accuracy/accuracy.json: makes accuracy.html beside it."""

import argparse
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from accuracy_page.page import to_html  # noqa: E402  (the path has to be there first)

DONE, WRONG_INPUT = 0, 2


def _parser():
    parser = argparse.ArgumentParser(
        prog="accuracy_page", description="The page of chapter 08, made of its numbers and pictures.")
    parser.add_argument("numbers", type=Path, help="accuracy.json, with its pictures beside it")
    parser.add_argument("--page", type=Path, help="the page to write; accuracy.html beside the numbers")
    return parser


def main(arguments):
    """The exit code: 0 done, 2 wrong usage or input."""
    options = _parser().parse_args(arguments)
    page = options.page or options.numbers.with_suffix(".html")
    try:
        report = json.loads(options.numbers.read_text(encoding="utf-8"))
        page.write_text(to_html(report, options.numbers.parent), encoding="utf-8")
    except OSError as error:
        print(f"{error.filename}: {error.strerror}.", file=sys.stderr)
        return WRONG_INPUT
    except (KeyError, TypeError, ValueError) as error:
        print(f"{options.numbers}: is not what ./run.sh 08 writes ({error!r}). Run it again.",
              file=sys.stderr)
        return WRONG_INPUT
    return DONE


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
