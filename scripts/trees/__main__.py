"""Trees of other programs as tree files, and these as arrays of NumPy (docs/tree_files.md).

    python3 -B scripts/trees tinybvh saved.bvh mine.rstree
    python3 -B scripts/trees madmann91 serialized.bin mine.rstree
    python3 -B scripts/trees npz mine.npz mine.rstree
    python3 -B scripts/trees to_npz mine.rstree mine.npz
"""

import argparse
import sys
from pathlib import Path

import npz
import readers
from tree_file import TreeError, read_tree_file, tree_file_bytes

FORMS = {
    "tinybvh": lambda data: tree_file_bytes(*readers.read_tinybvh(data)),
    "madmann91": lambda data: tree_file_bytes(*readers.read_madmann91(data)),
    "npz": lambda data: tree_file_bytes(*npz.read_npz(data)),
    "to_npz": lambda data: npz.npz_bytes(*read_tree_file(data)),
}


def main():
    parser = argparse.ArgumentParser(prog="scripts/trees", description="Makes a tree file of what another program saved.")
    parser.add_argument("form", choices=sorted(FORMS), help="what the first file is; to_npz makes an archive of a tree file")
    parser.add_argument("file", type=Path)
    parser.add_argument("made", type=Path, help="the file to write")
    given = parser.parse_args()
    try:
        given.made.write_bytes(FORMS[given.form](given.file.read_bytes()))
    except (OSError, TreeError) as error:
        print(f"{given.file}: {error}", file=sys.stderr)
        return 2
    print(f"wrote     {given.made}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
