"""Proves the bounds of docs/numerics.md:  python3 -B tests/whole/proofs [--show NAME] [--division 5]"""

import argparse
import sys

from prover import Bounds, NotProved, TextChanged, is_installed


def main():
    parser = argparse.ArgumentParser(prog="proofs", description="Proves the bounds of docs/numerics.md with gappa.")
    parser.add_argument("--show", metavar="NAME", choices=sorted(Bounds().proofs),
                        help="print what gappa reads of a proof")
    parser.add_argument("--division", metavar="E", type=int, default=1,
                        help="by how many e a division may err (1: it is rounded to nearest)")
    options = parser.parse_args()
    if not is_installed():
        print("proofs: gappa is not installed. Run `apt-get install gappa`.", file=sys.stderr)
        return 3
    bounds = Bounds(division=options.division)
    if options.show:
        print(bounds.text(options.show).strip())
        return 0
    status = 0
    print(f"{'proof':15} {'promised':>17} {'by gappa':>9}  of what")
    for name, proof in bounds.proofs.items():
        found = "-"
        try:
            found = f"{float(bounds[name]):.3f}"
            bounds.check(name)
        except (NotProved, TextChanged) as error:
            print(f"proofs: {error}", file=sys.stderr)
            status = 1
        print(f"{name:15} {str(proof):>17} {found:>9}  {proof.title}")
    return status


if __name__ == "__main__":
    sys.exit(main())
