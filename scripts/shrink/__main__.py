"""Reduces a ray that another engine gets wrong, or a fault of a tree, to a few triangles (docs/tree_files.md).

    ./run.sh shrink --scene model.obj --rays bad.csv --command 'engine %m %r %h'
    ./run.sh shrink --scene model.obj --tree mine.rstree
    ./run.sh shrink --scene model.obj --tree mine.rstree --rays bad.csv

The command is called again and again with other files: %m is an OBJ file, %t the same triangles as 9 float32 each,
%r a file of one ray (.f32), and %h where it writes the hit (.f32). `check` says whether the hit is right, and what is
wrong with a tree.
"""

import argparse
import subprocess
import sys
import tempfile
from hashlib import sha256
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "trees"))

from engine import Engine
from reduce import Reduction, ShrinkError
from scene import read_rays, read_triangles, run_check, write_case, write_model_and_ray
from tree import Tree, TreeCheck


def arguments():
    parser = argparse.ArgumentParser(prog="./run.sh shrink",
                                     description="Reduces a wrong answer of another engine, or a fault of a tree.")
    parser.add_argument("--scene", default="bunny", help="the scene, as in all programs")
    parser.add_argument("--rays", type=Path, help="rays that go wrong (.csv or .f32)")
    parser.add_argument("--ray-number", type=int, default=None, help="which of them; by default the first that goes wrong")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--command", help="the engine: %%m a model, %%t its triangles, %%r a ray, %%h the file for its hit")
    what.add_argument("--tree", type=Path, help="a tree file: its first fault, or the wrong answer to a ray of --rays")
    parser.add_argument("--seconds", type=float, default=60.0, help="the most that one call of the engine may take (60)")
    parser.add_argument("--out", type=Path, default=Path("out/shrink"), help="the folder for what is found")
    parser.add_argument("--check", type=Path, required=True, help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.command and not given.rays:
        parser.error("--command is asked about rays. Name a file with --rays.")
    return given


def choose_ray(engine, triangles, rays, number):
    numbers = range(len(rays)) if number is None else [number]
    for each in numbers:
        if not 0 <= each < len(rays):
            raise ShrinkError(f"--ray-number {each}: there are {len(rays)} rays, counted from 0.")
        failure = engine.failure(triangles, rays[each])
        if failure:
            return each, failure
    raise ShrinkError("the engine gives a right answer to every ray that was named. Is it the command that failed?")


def say_written(paths):
    for path in paths:
        if path:
            print(f"wrote     {path}")


def shrink_engine(given, folder):
    triangles = read_triangles(given.check, given.scene, folder)
    rays = read_rays(given.rays)
    engine = Engine(given.command, given.check, given.seconds, folder)
    number, failure = choose_ray(engine, triangles, rays, given.ray_number)
    print(f"ray {number} of {given.rays}: {failure}; {len(triangles)} triangles", flush=True)

    def fails(numbers):
        return engine.failure([triangles[i] for i in numbers], rays[number]) == failure

    reduction = Reduction(len(triangles), fails, given.out / "state.json",
                          [given.scene, given.command, list(rays[number])], "triangles")
    left = [triangles[i] for i in reduction.run()]
    last = engine.failure(left, rays[number])
    say_written(write_case(given.out, left, rays[number], engine.right))
    print(f"{len(left)} of {len(triangles)} triangles are left, after {reduction.calls} calls: {last}")


def shrink_tree(given, folder):
    triangles = read_triangles(given.check, given.scene, folder)
    check = TreeCheck(given.check, folder)
    failure, number = check.first_failure(given.tree, given.scene, given.rays, given.ray_number)
    ray = None if number is None else read_rays(given.rays)[number]
    print(f"{given.tree}: {failure}{'' if ray is None else f', ray {number} of {given.rays}'}; "
          f"{len(triangles)} triangles", flush=True)
    plain = folder / "plain.rstree"
    run_check(given.check, "--tree", given.tree, "--scene", given.scene, "--export", plain)
    tree = Tree(plain, triangles)

    def fails(numbers):
        data, some, nodes = tree.with_parts(numbers)
        return nodes > 0 and len(some) > 0 and check.has_failure(failure, data, some, ray)

    asked = [given.scene, sha256(given.tree.read_bytes()).hexdigest(), failure, ray and list(ray)]
    reduction = Reduction(len(tree.parts), fails, given.out / "state.json", asked, "parts of the tree")
    if not fails(reduction.kept):
        raise ShrinkError("taken apart and put together again, the tree does not fail. This is a bug; please report it.")
    data, left, nodes = tree.with_parts(reduction.run())
    shrunk = given.out / "shrunk.rstree"
    shrunk.write_bytes(data)
    say_written([shrunk, *write_model_and_ray(given.out, left, ray)])
    print(f"{len(left)} of {len(triangles)} triangles are left, under {nodes} of {len(tree.boxes)} nodes, after "
          f"{reduction.calls} calls: {failure}")


def main():
    given = arguments()
    try:
        given.out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="raysteps_shrink_") as folder:
            (shrink_tree if given.tree else shrink_engine)(given, Path(folder))
    except (ShrinkError, OSError, subprocess.SubprocessError) as error:
        print(f"shrink: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nshrink: stopped; the same command goes on from here.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
