"""The conformance suite, run over any ray tracer (docs/conformance/README.md).

    ./run.sh conformance --command 'engine %m %r %h'

The command is called once a family: %m is an OBJ file, %t the same triangles as 9 float32 each, %r a file of rays
(.f32), and %h where it writes the hits (.f32). Python is all that this needs.
"""

import argparse
import hashlib
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

for folder in ("shrink", "trees"):
    sys.path.append(str(Path(__file__).resolve().parents[1] / folder))

from engine import call  # noqa: E402  (the path has to be there first)
from judge import HIT_BYTES, judge  # noqa: E402
from report import HEADING, ROOT, compare, first_in_words, head, replay, row_of, to_html, to_line  # noqa: E402
from suite import SuiteError, read_suite, read_triangles, write_triangles  # noqa: E402

SMALL = ROOT / "docs/conformance/suite"
DONE, FOUND, WRONG_INPUT = 0, 1, 2


def arguments():
    parser = argparse.ArgumentParser(prog="./run.sh conformance",
                                     description="Hard cases with exact answers, for any ray tracer. It prints a line for "
                                     "each family: rays, wrong answers, their rate per million, seconds.",
                                     epilog="docs/conformance/README.md says what is in the files, and what is right. For "
                                     "example: ./run.sh conformance --command 'my_engine %t %r %h' --families edges,corners")
    parser.add_argument("--command", help="the engine: %%m a model, %%t its triangles, %%r rays, %%h the file for hits")
    parser.add_argument("--name", default="engine", help="what to call it")
    parser.add_argument("--suite", type=Path, default=SMALL, help="the folder of the suite; docs/conformance/suite")
    parser.add_argument("--rays", type=int, default=0, help="make a suite of so many rays a family first, and take that")
    parser.add_argument("--families", default="", help="only these, as in edges,corners")
    parser.add_argument("--seconds", type=float, default=60.0, help="the most that one family may take (60)")
    parser.add_argument("--memory", type=float, default=8.0, help="the most memory that it may take, in GiB (8)")
    parser.add_argument("--out", type=Path, default=Path("out/conformance"), help="the folder for what is found")
    parser.add_argument("--json", type=Path, help="a file for the figures")
    parser.add_argument("--table", type=Path, nargs="+", help="files of --json, or cards of readers' GPUs that the playground saved: a table, and nothing is run")
    parser.add_argument("--generator", type=Path, help=argparse.SUPPRESS)
    return parser.parse_args()


def make_suite(given):
    """The same bytes everywhere."""
    folder = given.out / f"suite_{given.rays}"
    if not (folder / "suite.json").exists():
        print(f"making {given.rays} rays a family in {folder}", file=sys.stderr)
        subprocess.run([given.generator, "--suite", folder, "--rays", str(given.rays)], check=True,
                       stdout=subprocess.DEVNULL)
    return folder


def ended_how(ended, data, family):
    """`done`, or what is wrong with the run itself."""
    if ended:
        return ended
    if data is None:
        return "no hits"
    if len(data) % HIT_BYTES:
        return "garbage"
    if len(data) != HIT_BYTES * family.rays:
        return "too few hits" if len(data) < HIT_BYTES * family.rays else "too many hits"
    return "done"


def run_family(given, family, folder):
    triangles = read_triangles(family.file("obj"))
    packed, hits = folder / "triangles.f32", folder / "hits.f32"
    write_triangles(packed, triangles)
    hits.unlink(missing_ok=True)
    files = {"%m": family.file("obj"), "%t": packed, "%r": family.file("f32"), "%h": hits}
    started = time.monotonic()
    ended = call(given.command, files, given.seconds, int(given.memory * 2**30))
    seconds = time.monotonic() - started
    data = hits.read_bytes() if hits.is_file() else None
    return row_of(family, ended_how(ended, data, family), seconds, judge(family, triangles, data or b""))


def run_all(given):
    """The rows; those of an earlier run that was stopped are taken as they are."""
    families, digest = read_suite(given.suite, [name for name in given.families.split(",") if name])
    given.out.mkdir(parents=True, exist_ok=True)
    state = given.out / f"{given.name}.state.json"
    key = [given.command, digest]
    known = json.loads(state.read_text()) if state.exists() else {}
    rows = known["rows"] if known.get("key") == key else []
    if rows:
        print(f"goes on after {len(rows)} families, from {state}")
    print(HEADING)
    for row in rows:
        print(to_line(row))
    with tempfile.TemporaryDirectory(prefix="raysteps_conformance_") as folder:
        for family in families[len(rows):]:
            rows.append(run_family(given, family, Path(folder)))
            state.write_text(json.dumps({"key": key, "rows": rows}))
            print(to_line(rows[-1]), flush=True)
    state.unlink(missing_ok=True)
    return families, rows


def report(given, families, rows):
    by_name = {family.name: family for family in families}
    for row in rows:
        if row["first_wrong"]:
            print(f"\n{row['family']}: {first_in_words(row['first_wrong'])}")
            print(f"    {replay(by_name[row['family']], row['first_wrong'])}")
    figures = {"head": head(), "engine": given.name, "command": given.command, "suite": str(given.suite),
               "tried": sum(row["tried"] for row in rows), "wrong": sum(row["wrong"] for row in rows),
               "families": rows}
    page = given.out / f"{given.name}.html"
    page.write_text(to_html(figures, families))
    print(f"\nwrote     {page}")
    if given.json:
        given.json.write_text(json.dumps(figures, indent=2, allow_nan=False) + "\n")
        print(f"wrote     {given.json}")
    right = sum(row["wrong"] == 0 and row["ended"] == "done" for row in rows)
    print(f"{given.name}: {right} of {len(rows)} families without a fault; {figures['wrong']} of {figures['tried']} "
          "answers are wrong")
    return DONE if right == len(rows) else FOUND


def main():
    given = arguments()
    try:
        if given.table:
            print(compare(given.table))
            return DONE
        if not given.command:
            raise SuiteError("name the engine: --command 'engine %m %r %h'. docs/conformance/adapters has examples.")
        if given.rays:
            given.suite = make_suite(given)
        return report(given, *run_all(given))
    except (SuiteError, OSError, subprocess.SubprocessError) as error:
        print(f"conformance: {error}", file=sys.stderr)
        return WRONG_INPUT
    except KeyboardInterrupt:
        print("\nconformance: stopped; the same command goes on from here.", file=sys.stderr)
        return FOUND


if __name__ == "__main__":
    sys.exit(main())
