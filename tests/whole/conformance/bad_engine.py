"""An engine that is wrong on purpose: bad_engine.py HOW FAMILY.answers %h"""

import os
import struct
import sys
import time
from pathlib import Path


def right_hits(path):
    """The first answer that is allowed, of each ray; u and v are not told."""
    data, place = Path(path).read_bytes(), 0
    while place < len(data):
        flags, count = struct.unpack_from("<HH", data, place)
        if count:
            triangle, least, most = struct.unpack_from("<iff", data, place + 4)
            yield [least if most > 1e38 else (least + most) / 2, -1.0, -1.0, triangle]
        else:
            yield [3e38, -1.0, -1.0, -1]
        place += 4 + 12 * count


how, answers, out = sys.argv[1:]
hits = list(right_hits(answers))
if how == "crash":
    os.abort()
elif how == "hang":
    time.sleep(60)
elif how == "memory":
    hits = bytearray(1 << 40)
elif how == "leak":
    hits[7] = [3e38, 0.0, 0.0, -1]
elif how == "other":
    hits[7][3] += 100
elif how == "late":
    hits[7][0] *= 1.001
elif how == "nan":
    hits[7][0] = float("nan")
elif how == "weights":
    hits[7][1:3] = [0.9, 0.9]
elif how == "nowhere":
    hits[7][3] = 1000000
elif how == "few":
    hits = hits[:-3]
data = b"".join(struct.pack("<fffi", *hit) for hit in hits)
if how == "garbage":
    data = data[:-5]
if how != "silent":
    Path(out).write_bytes(data)
sys.exit(3 if how == "exit" else 0)
