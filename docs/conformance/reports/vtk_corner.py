"""VTK 9.1, static cell locator, misses a corner that six triangles close: python3 vtk_corner.py 'engine %m %r %h'"""

import struct
import subprocess
import sys
import tempfile
from pathlib import Path

MODEL = """\
v 1.53884172 1.17557049 0.5
v 1.44167888 1.17557049 0.734572053
v 1.58778524 0.907980978 0.809017003
v 1.53884172 1.17557049 0.5
v 1.58778524 0.907980978 0.809017003
v 1.69479513 0.907980978 0.550672293
v 1.44167888 1.17557049 0.734572053
v 1.44167888 0.907980978 1.04744101
v 1.58778524 0.907980978 0.809017003
v 1.69479513 0.907980978 0.550672293
v 1.58778524 0.907980978 0.809017003
v 1.69479513 0.618034005 0.863541245
v 1.58778524 0.907980978 0.809017003
v 1.44167888 0.907980978 1.04744101
v 1.53884172 0.618034005 1.11803401
v 1.58778524 0.907980978 0.809017003
v 1.53884172 0.618034005 1.11803401
v 1.69479513 0.618034005 0.863541245
v 1.2095694e-16 0.312868923 1.97537673
v -0.312868923 1.22464685e-16 1.97537673
v 1.22464685e-16 1.22464685e-16 2
v 0.309017003 -1.97537673 -0.0489434823
v 0.312868923 -1.97537673 0
v 0 -2 0
f 1 2 3
f 4 5 6
f 7 8 9
f 10 11 12
f 13 14 15
f 16 17 18
f 19 20 21
f 22 23 24
"""
RAY = (0.841802179813385, 0.6156556010246277, -0.399026095867157, 0.7459830641746521, 0.29232537746429443, 1.208043098449707, 0.0, 3.4028234663852886e+38)  # origin, direction, t_min, t_max
RIGHT = 0  # the triangle, from 0, or -1

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
