#!/usr/bin/env python3
"""Compares two checkouts bit for bit: every picture in out/, and the hits of every structure and triangle test.

    scripts/same_bits.py OLD [NEW]     both built by ./run.sh; NEW is this checkout

Run it before and after a change that could affect a hit. Exit code 0: all that both have is the same.
"""
import random
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

SCENES = ("bunny", "soup:2000", "needles:300", "stadium:2", "cornell_box", "glass_box")
RAYS = 20000  # per scene; a fifth of them runs along an axis
PLOTS = re.compile(r"growth_|_resolution|proof")  # of measured times, which differ from run to run


def program(checkout):
    return checkout / "build" / "default" / "chapters" / "02_triangles" / "02_triangles"


def walks(checkout):
    return sorted(path.stem for path in (checkout / "shaders" / "structure").rglob("*.glsl")
                  if re.search(r"^Walk go_on\(", path.read_text(), re.MULTILINE))


def triangle_tests(checkout):
    return sorted(path.stem for path in (checkout / "shaders" / "triangle").glob("*.glsl"))


def write_rays(path, seed):
    numbers = random.Random(seed)
    with open(path, "wb") as file:
        for i in range(RAYS):
            origin = [numbers.uniform(-3, 3) for _ in range(3)]
            direction = [-x + numbers.uniform(-1, 1) for x in origin]
            if i % 5 == 0:
                axis = numbers.randrange(3)
                direction = [direction[k] if k == axis else 0.0 for k in range(3)]
            file.write(struct.pack("<8f", *origin, *direction, 0.0, 3.4028234663852886e38))


def trace(checkout, folder, scene, options):
    hits = folder / "hits.f32"
    subprocess.run([program(checkout), "--scene", scene, "--rays", folder / "rays.f32", "--hits", hits, *options],
                   check=True, capture_output=True, cwd=folder)
    return hits.read_bytes()


def compare_hits(old, new):
    different = traced = 0
    structures = [name for name in walks(new) if name in walks(old)]
    tests = [name for name in triangle_tests(new) if name in triangle_tests(old)]
    kinds = [["--structure", name] for name in structures] + \
            [["--structure", "bvh_skip", "--triangle", name] for name in tests]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for seed, scene in enumerate(SCENES):
            write_rays(folder / "rays.f32", seed)
            for options in kinds:
                traced += 1
                if trace(old, folder, scene, options) != trace(new, folder, scene, options):
                    different += 1
                    print(f"different hits: {scene} {' '.join(options)}")
    print(f"hits: {len(structures)} structures, {len(tests)} triangle tests, {len(SCENES)} scenes, "
          f"{RAYS} rays each: {different} of {traced} files differ")
    return different


def compare_pictures(old, new):
    different = same = plots = 0
    only_old = []
    for path in sorted((old / "out").rglob("*.p[fn][mg]")):
        other = new / "out" / path.relative_to(old / "out")
        if PLOTS.search(path.name):
            plots += 1
        elif not other.exists():
            only_old.append(str(path.relative_to(old)))
        elif path.read_bytes() != other.read_bytes():
            different += 1
            print(f"different: {path.relative_to(old)}")
        else:
            same += 1
    print(f"pictures: {same} the same, {different} differ, {len(only_old)} only in the old one "
          f"({', '.join(only_old) or 'none'}); {plots} plots of measured times are not compared")
    return different


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    old = Path(sys.argv[1]).resolve()
    new = Path(sys.argv[2]).resolve() if len(sys.argv) == 3 else Path(__file__).resolve().parents[1]
    for checkout in (old, new):
        if not program(checkout).exists():
            sys.exit(f"{checkout}: has no {program(checkout).relative_to(checkout)}. Run ./run.sh there first.")
    sys.exit(1 if compare_pictures(old, new) + compare_hits(old, new) else 0)


if __name__ == "__main__":
    main()
