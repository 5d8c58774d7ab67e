"""python3 -B scripts/book figures|site|serve: makes the book's figures, makes it, serves it, prints it or packs it."""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from book.contents import ROOT  # noqa: E402  (the path has to be there first)
from book.errors import DONE, WRONG_INPUT, BookError  # noqa: E402
from book.figures import make_figures  # noqa: E402
from book.paper import print_book  # noqa: E402
from book.serve import serve  # noqa: E402
from book.site import make_site, zip_site  # noqa: E402
from playground.data import write_large_scenes  # noqa: E402


def say(text):
    print(text, file=sys.stderr, flush=True)


def _parser():
    parser = argparse.ArgumentParser(prog="./run.sh book", usage="./run.sh book [--port PORT | --pdf | --zip]",
                                     description="Makes the book, and serves it on this machine (127.0.0.1).")
    # The first argument, --build, --store and --all are the build system's.
    parser.add_argument("command", choices=("figures", "site", "serve"), help=argparse.SUPPRESS)
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "default", help=argparse.SUPPRESS)
    parser.add_argument("--store", type=Path, default=ROOT / "build" / "default" / "book", help=argparse.SUPPRESS)
    parser.add_argument("--all", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--port", type=int, default=8000, help="where to serve it (8000)")
    parser.add_argument("--pdf", action="store_true", help="serve nothing: print the book into one file")
    parser.add_argument("--zip", action="store_true", help="serve nothing: pack the book and the playground into one file")
    return parser


def main(arguments):
    """The exit code: 0 done, 1 the book has a fault, 2 wrong usage, 3 the machine lacks something."""
    options = _parser().parse_args(arguments)
    store, build = options.store.resolve(), options.build.resolve()
    try:
        if options.command == "figures":
            make_figures(ROOT, build, store / "figures", say, with_slow=options.all)
            write_large_scenes(build, store / "playground", say)
        elif options.command == "site":
            say(f"book: wrote {make_site(ROOT, store, say)}/index.html")
        elif not (store / "site" / "index.html").exists():
            say("book: there is no book yet. `./run.sh book` makes it.")
            return WRONG_INPUT
        elif options.pdf:
            say(f"book: printed {print_book(ROOT, store)}")
        elif options.zip:
            say(f"book: packed {zip_site(store)}")
        else:
            serve(store / "site", options.port)
    except BookError as error:
        say(f"book: {error}")
        return error.code
    return DONE


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
