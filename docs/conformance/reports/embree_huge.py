"""Embree 3.13.5, robust, misses an edge of two triangles at coordinates of 1e15: python3 embree_huge.py 'engine %m %r %h'"""

import struct
import subprocess
import sys
import tempfile
from pathlib import Path

MODEL = """\
v -8.09016951e+14 -4.9999996e+14 3.09016958e+14
v -6.88190931e+14 -4.25325377e+14 5.87785266e+14
v -8.64187752e+14 -2.3885563e+14 4.42862668e+14
v -6.88190931e+14 -4.25325377e+14 5.87785266e+14
v -7.16566841e+14 -1.47620895e+14 6.81718281e+14
v -8.64187752e+14 -2.3885563e+14 4.42862668e+14
f 1 2 3
f 4 5 6
"""
RAY = (176259569025024.0, 346045884137472.0, -399908532125696.0, -1039951839887360.0, -585426456805376.0, 843179188289536.0, 0.0, 3.4028234663852886e+38)  # origin, direction, t_min, t_max
RIGHT = 1  # the triangle, from 0, or -1

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
