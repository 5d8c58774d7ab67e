"""python3 -B scripts/gallery: writes models that are made by code, to out/gallery."""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from gallery.models import MODELS  # noqa: E402  (the path has to be there first)


def main(arguments):
    """The exit code: 0 done, 2 where a file cannot be written."""
    parser = argparse.ArgumentParser(prog="gallery", description="The models of the gallery that are made by code.")
    parser.add_argument("--out", type=Path, default=Path("out") / "gallery", help="the folder; out/gallery")
    folder = parser.parse_args(arguments).out
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for make in MODELS:
            for name, data in make().items():
                (folder / name).write_bytes(data)
                print(f"wrote     {folder / name}")
    except OSError as error:
        print(f"{error.filename}: {error.strerror}. Name another folder with --out.", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
