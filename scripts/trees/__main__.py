"""Trees of other programs as tree files (docs/tree_files.md).

    python3 -B scripts/trees tinybvh saved.bvh mine.rstree
    python3 -B scripts/trees madmann91 serialized.bin mine.rstree
    python3 -B scripts/trees npz mine.npz mine.rstree
"""

import argparse
import sys
from pathlib import Path

import readers
from tree_file import TreeError, tree_file_bytes


def main():
    parser = argparse.ArgumentParser(prog="scripts/trees", description="Makes a tree file of what another program saved.")
    parser.add_argument("form", choices=sorted(readers.READERS), help="what the first file is")
    parser.add_argument("file", type=Path)
    parser.add_argument("tree", type=Path, help="the tree file to write")
    given = parser.parse_args()
    try:
        head, arrays = readers.READERS[given.form](given.file.read_bytes())
        given.tree.write_bytes(tree_file_bytes(head, arrays))
    except (OSError, TreeError) as error:
        print(f"{given.file}: {error}", file=sys.stderr)
        return 2
    print(f"wrote     {given.tree}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
