"""The files of the suite (docs/conformance/README.md), and rays, triangles and answers in them."""

import array
import hashlib
import json
import struct
import sys
from dataclasses import dataclass
from pathlib import Path

MISS_ALLOWED, ANYTHING_ALLOWED = 1, 2
SUITE_FILES = ("obj", "f32", "answers")


class SuiteError(Exception):
    """One sentence for the person who called."""


@dataclass
class Family:
    """One family: its words, and where its files are."""

    folder: Path
    name: str
    tests: str
    fails: str
    inside: bool
    rays: int
    triangles: int

    def file(self, ending):
        return self.folder / f"{self.name}.{ending}"


def read_suite(folder, names):
    """The families of a suite, all or those of the names; and what tells this suite from any other."""
    try:
        families = json.loads((folder / "suite.json").read_text())["families"]
    except (OSError, ValueError, KeyError) as error:
        raise SuiteError(f"{folder}: there is no suite in this folder ({error}). Name one with --suite.") from error
    known = [family["name"] for family in families]
    for name in names:
        if name not in known:
            raise SuiteError(f"--families {name}: there is no such family. The families: {', '.join(known)}.")
    fields = ("name", "tests", "fails", "inside", "rays", "triangles")
    chosen = [Family(folder, **{field: family[field] for field in fields})
              for family in families if not names or family["name"] in names]
    sums = hashlib.sha256()
    for family in chosen:
        for ending in SUITE_FILES:
            sums.update(family.file(ending).read_bytes())
    return chosen, sums.hexdigest()


def read_triangles(path):
    """Of an OBJ file with triangles only: nine numbers each, which are floats."""
    points, triangles = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0] == "v":
            points.append(array.array("f", map(float, words[1:4])).tolist())
        elif words and words[0] == "f":
            triangles.append([number for word in words[1:4] for number in points[int(word) - 1]])
    return triangles


def write_triangles(path, triangles):
    numbers = array.array("f", [number for triangle in triangles for number in triangle])
    if sys.byteorder == "big":
        numbers.byteswap()
    path.write_bytes(numbers.tobytes())


def read_rays(path):
    """Eight numbers each: origin, direction, t_min, t_max."""
    return struct.iter_unpack("<8f", path.read_bytes())


def read_answers(path):
    """For each ray what is allowed: flags, and a dictionary of (t_least, t_most) by triangles."""
    data, place = path.read_bytes(), 0
    while place < len(data):
        flags, count = struct.unpack_from("<HH", data, place)
        numbers = struct.unpack_from("<" + "iff" * count, data, place + 4)
        yield flags, {numbers[i]: numbers[i + 1:i + 3] for i in range(0, 3 * count, 3)}
        place += 4 + 12 * count
