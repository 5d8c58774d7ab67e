"""Bullet 3.24 hits a triangle beside which the ray passes: python3 bullet_beside.py 'engine %m %r %h'"""

import struct
import subprocess
import sys
import tempfile
from pathlib import Path

MODEL = """\
v 0.683771253 0.53749001 0.451272696
v 0.50895679 0.420888573 0.230193853
v 0.519086719 0.276551962 0.756557465
f 1 2 3
"""
RAY = (0.6012402176856995, 0.40671026706695557, 0.7221921682357788, 0.0, 0.0, -1.0, 0.0, 3.4028234663852886e+38)  # origin, direction, t_min, t_max
RIGHT = -1  # the triangle, from 0, or -1

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
