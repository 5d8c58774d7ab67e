"""python3 -B scripts/playground data: makes docs/playground/data anew, after a change of a shader, a scene, a builder or an exercise."""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from playground.data import PAGE, PROGRAMS, write_data  # noqa: E402  (the path has to be there first)

ROOT = Path(__file__).resolve().parents[2]


def main(arguments):
    parser = argparse.ArgumentParser(prog="playground", description="The data of the playground.")
    parser.add_argument("command", choices=("data",))
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "default", help="the build folder that has the programs")
    options = parser.parse_args(arguments)
    for program in PROGRAMS:
        if not (options.build / program).exists():
            print(f"playground: {options.build / program} is missing. Build the target {Path(program).name}.", file=sys.stderr)
            return 2
    write_data(ROOT, options.build.resolve(), ROOT / PAGE / "data")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
