"""Embree 3.13.5, robust, hits a triangle whose corners lie on one line, beside which the ray passes: python3 embree_line.py 'engine %m %r %h'"""

import struct
import subprocess
import sys
import tempfile
from pathlib import Path

MODEL = """\
v 0 0.923828125 0.3828125
v -0.270507812 0.70703125 0.653320312
v -0.135253906 0.815429688 0.518066406
f 1 2 3
"""
RAY = (0.2767903506755829, 0.19626925885677338, -0.09948889166116714, -0.4044926166534424, 0.6252126693725586, 0.610003650188446, 0.0, 3.4028234663852886e+38)  # origin, direction, t_min, t_max
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
