"""Triangles and rays as lists of floats, and the files that a reduced case is written to."""

import array
import csv
import json
import struct
import subprocess
from pathlib import Path

COLUMNS = ["origin_x", "origin_y", "origin_z", "direction_x", "direction_y", "direction_z", "t_min", "t_max"]


def read_triangles(check, scene, folder):
    """Nine floats each, as the scene has them."""
    path = folder / "scene.rstree"
    subprocess.run([check, "--scene", scene, "--export", path, "--triangles-inside"], check=True, stdout=subprocess.DEVNULL)
    data = path.read_bytes()
    size = int.from_bytes(data[16:24], "little")
    described = json.loads(data[24:24 + size])["arrays"]["corners"]
    start = (24 + size + 15) // 16 * 16 + described["at"]
    return list(struct.iter_unpack("<9f", data[start:start + 36 * described["count"]]))


def read_rays(path):
    if path.suffix == ".csv":
        with path.open(newline="") as file:
            return [tuple(float(row[name]) for name in COLUMNS) for row in csv.DictReader(file)]
    return list(struct.iter_unpack("<8f", path.read_bytes()))


def obj_of(triangles):
    """Nine digits give back the same float."""
    lines = []
    for corners in triangles:
        for i in range(0, 9, 3):
            lines.append("v %.9g %.9g %.9g\n" % corners[i:i + 3])
    lines += ["f %d %d %d\n" % (i, i + 1, i + 2) for i in range(1, 3 * len(triangles), 3)]
    return "".join(lines)


def write_floats(path, numbers):
    with path.open("wb") as file:
        array.array("f", numbers).tofile(file)


TEST = '''"""{triangles} triangles and a ray that an engine got wrong: python3 test_case.py 'engine %m %r %h'"""

import struct
import subprocess
import sys
import tempfile
from pathlib import Path

MODEL = """\\
{model}"""
RAY = {ray!r}  # origin, direction, t_min, t_max
RIGHT = {right!r}  # the triangle, from 0, or -1

with tempfile.TemporaryDirectory() as folder:
    model, packed, ray, hit = (Path(folder) / name for name in ("model.obj", "triangles.f32", "ray.f32", "hit.f32"))
    model.write_text(MODEL)
    points = [float(word) for line in MODEL.splitlines() if line[:2] == "v " for word in line.split()[1:]]
    packed.write_bytes(struct.pack("<%df" % len(points), *points))
    ray.write_bytes(struct.pack("<8f", *RAY))
    command = sys.argv[1]
    for mark, path in (("%m", model), ("%t", packed), ("%r", ray), ("%h", hit)):
        command = command.replace(mark, str(path))
    subprocess.run(command, shell=True, check=True)
    found = struct.unpack("<fffi", hit.read_bytes())
print("found triangle", found[3], "at", found[0], "- right is", RIGHT)
sys.exit(found[3] != RIGHT)
'''


def write_case(folder, triangles, ray, right, command):
    """An OBJ file, a ray file and a test that needs nothing else; their paths."""
    model, rays, test = folder / "shrunk.obj", folder / "shrunk.csv", folder / "test_case.py"
    model.write_text(obj_of(triangles))
    rays.write_text(",".join(COLUMNS) + "\n" + ",".join("%.9g" % number for number in ray) + "\n")
    test.write_text(TEST.format(triangles=len(triangles), model=obj_of(triangles), ray=tuple(ray), right=right))
    return [model, rays, test]
