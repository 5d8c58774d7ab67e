"""Reduces a ray that another engine gets wrong to a few triangles (docs/tree_files.md).

    ./run.sh shrink --scene model.obj --rays bad.csv --command 'engine %m %r %h'

The command is called again and again with other files: %m is an OBJ file, %t the same triangles as 9 float32 each,
%r a file of one ray (.f32), and %h where it writes the hit (.f32). `check --judge` says whether the hit is right.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

from engine import Engine
from reduce import Reduction, ShrinkError
from scene import read_rays, read_triangles, write_case


def arguments():
    parser = argparse.ArgumentParser(prog="./run.sh shrink", description="Reduces a wrong answer of another engine.")
    parser.add_argument("--scene", default="bunny", help="the scene, as in all programs")
    parser.add_argument("--rays", type=Path, required=True, help="rays that go wrong (.csv or .f32)")
    parser.add_argument("--ray-number", type=int, default=None, help="which of them; by default the first that goes wrong")
    parser.add_argument("--command", required=True, help="the engine: %%m a model, %%t its triangles, %%r a ray, %%h the file for its hit")
    parser.add_argument("--seconds", type=float, default=60.0, help="the most that one call may take (60)")
    parser.add_argument("--out", type=Path, default=Path("out/shrink"), help="the folder for what is found")
    parser.add_argument("--check", type=Path, required=True, help=argparse.SUPPRESS)
    return parser.parse_args()


def choose_ray(engine, triangles, rays, number):
    numbers = range(len(rays)) if number is None else [number]
    for each in numbers:
        if not 0 <= each < len(rays):
            raise ShrinkError(f"--ray-number {each}: there are {len(rays)} rays, counted from 0.")
        failure = engine.failure(triangles, rays[each])
        if failure:
            return each, failure
    raise ShrinkError("the engine gives a right answer to every ray that was named. Is it the command that failed?")


def shrink(given):
    given.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="raysteps_shrink_") as folder:
        triangles = read_triangles(given.check, given.scene, Path(folder))
        rays = read_rays(given.rays)
        engine = Engine(given.command, given.check, given.seconds, Path(folder))
        number, failure = choose_ray(engine, triangles, rays, given.ray_number)
        print(f"ray {number} of {given.rays}: {failure}; {len(triangles)} triangles")
        reduction = Reduction(engine, triangles, rays[number], failure, given.out / "state.json",
                              [given.scene, given.command, list(rays[number])])
        kept = reduction.run()
        last = engine.failure([triangles[i] for i in kept], rays[number])
        for path in write_case(given.out, [triangles[i] for i in kept], rays[number], engine.right, given.command):
            print(f"wrote     {path}")
    print(f"{len(kept)} of {len(triangles)} triangles are left, after {engine.calls} calls: {last}")


def main():
    try:
        shrink(arguments())
    except (ShrinkError, OSError, subprocess.SubprocessError) as error:
        print(f"shrink: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nshrink: stopped; the same command goes on from here.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
