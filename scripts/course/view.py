"""Opens the visualizer at the first wrong ray of an exercise."""

import os
import shlex
import subprocess
from pathlib import Path

from .errors import CourseError, MachineError
from .exercises import ROOT, ray_text


def _words(checkpoint, chapter):
    """What the visualizer is told of a checkpoint's scene and structure; None where its rays go
    through none, and are other numbers."""
    question = checkpoint.question
    if checkpoint.view:
        scene, *options = checkpoint.view
        words = [f"chapters/{chapter}/exercises/{scene}", *options]
    elif "scene" in question:
        words = [question["scene"]]
    else:
        return None
    words += ["--structure", question.get("structure", "every_triangle")]
    for name, value in question.get("options", {}).items():
        words += [f"--{name}", str(value)]
    return words


def wrong_ray(result):
    """The visualizer's words for what a check found: the first wrong ray, or the first wrong pixel
    of the picture; None where there is neither."""
    checkpoint = result.checkpoint
    if checkpoint is None:
        return None
    words = _words(checkpoint, result.exercise.chapter)
    if words is None:
        return None
    if checkpoint.question["kind"] == "checkpoint" and result.wrong:
        return [*words, f"--ray={ray_text(result.wrong.ray)}"]
    pixel = result.pictures.get("first_wrong_pixel")
    if checkpoint.question["kind"] == "picture" and pixel:
        width, height = (checkpoint.question.get(*side) for side in (("width", 64), ("height", 48)))
        return [*words, "--size", f"{width}x{height}", f"--pixel={pixel[0]},{pixel[1]}"]
    return None


def given_ray(exercise, ray):
    """The visualizer's words for a ray of one's own, in the first checkpoint that has a scene."""
    for checkpoint in exercise.checkpoints:
        words = _words(checkpoint, exercise.chapter)
        if words is not None and checkpoint.question["kind"] == "checkpoint":
            return [*words, f"--ray={ray_text(ray)}"]
    raise CourseError(f"{exercise.number} asks about no ray in a scene, so there is nothing to be "
                      f"seen. `./course check {exercise.number}` says which numbers are wrong.")


def open_visualizer(engine, words, screenshot):
    """Shows it in a window, or writes a picture; the visualizer's exit code."""
    program = Path(engine.build) / "visualizer" / "visualizer"
    if not program.exists():
        raise MachineError(f"{program}: is not there. `./run.sh view --help` installs what it needs "
                           "and builds it.")
    if screenshot:
        words = [*words, "--screenshot", os.path.abspath(screenshot)]
    print(shlex.join([os.path.relpath(program, ROOT), *words]), flush=True)
    return subprocess.run([str(program), *words], cwd=ROOT, check=False).returncode
