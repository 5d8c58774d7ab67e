"""Opens the visualizer at the first wrong ray of an exercise."""

import os
import shlex
import subprocess
from pathlib import Path

from . import engine as engines, recorded
from .errors import CourseError, MachineError
from .exercises import ROOT, ray_text


def words_of(checkpoint, chapter):
    """What the visualizer is told of a checkpoint's scene and structure; None where its rays go
    through none, and are other numbers."""
    question = checkpoint.question
    if "points" in question and not checkpoint.view:
        return None  # a structure that the visualizer would build otherwise
    if checkpoint.view:
        scene, *options = checkpoint.view
        words = [f"chapters/{chapter}/exercises/{scene}", *options]
    elif "scene" in question:
        scene = Path(question["scene"])
        words = [str(scene.relative_to(ROOT) if scene.is_relative_to(ROOT) else scene)]
    else:
        return None
    words += ["--structure", question.get("structure", "every_triangle")]
    for name, value in question.get("options", {}).items():
        words += [f"--{name}", str(value)]
    return words


def wrong_ray(result):
    """The visualizer's words for what a check found: the first wrong ray of a scene, else the first
    wrong pixel of the picture; None where there is neither."""
    exercise, checkpoint = result.exercise, result.checkpoint
    if result.wrong and checkpoint.question["kind"] == "checkpoint":
        words = words_of(checkpoint, exercise.chapter)
        if words is not None:
            return [*words, f"--ray={ray_text(result.wrong.ray)}"]
    pixel = result.pictures.get("first_wrong_pixel")
    if not pixel:
        return None
    picture = next(c for c in exercise.checkpoints if c.question["kind"] == "picture")
    width, height = size_of(picture.question)
    return [*words_of(picture, exercise.chapter), "--size", f"{width}x{height}",
            f"--pixel={pixel[0]},{pixel[1]}"]


def size_of(question):
    return question.get("width", 64), question.get("height", 48)


def question_of_pixels(exercise):
    """In whose scene a pixel lies: that of the picture, else the first one; None where there is none."""
    questions = [checkpoint.question for checkpoint in exercise.checkpoints if "scene" in checkpoint.question]
    return next((one for one in questions if one["kind"] == "picture"), questions[0] if questions else None)


def ray_of_pixel(engine, exercise, question, pixel):
    """The ray of a pixel of the scene's picture, counted from the top left, as bits."""
    width, height = size_of(question)
    asked = {"kind": "rays", "subject": "direct", "scene": question["scene"], "width": width,
             "height": height}
    rays = engines.ask_reference(engine, engine.shaders_program(), exercise.chapter, [asked])[0]
    (*origin, t_min), (*direction, t_max) = (
        texels[(height - 1 - pixel[1]) * width + pixel[0]][:4] for texels in rays.steps)
    return [*origin, *direction, t_min, t_max]


def both_walks(engine, exercise, checkpoint, ray, folder):
    """The visualizer's words for the person's walk beside the right one; None where they are the
    same, or there is none."""
    words = words_of(checkpoint, exercise.chapter)
    walk = recorded.student_walk(engine, exercise, checkpoint, ray, folder, words[0])
    if walk is None:
        return None
    name = f"exercise_{exercise.number.replace('.', '_')}.json"
    path = recorded.write(walk, engines.STORE / "walks" / name)
    return [*words, "--steps", os.path.relpath(path, ROOT)]


def both_wrong_walks(engine, result, folder):
    """The same for what wrong_ray shows."""
    exercise, checkpoint = result.exercise, result.checkpoint
    if result.wrong and checkpoint.question["kind"] == "checkpoint" and words_of(
            checkpoint, exercise.chapter) is not None:
        return both_walks(engine, exercise, checkpoint, result.wrong.ray, folder)
    picture = next(c for c in exercise.checkpoints if c.question["kind"] == "picture")
    ray = ray_of_pixel(engine, exercise, picture.question, result.pictures["first_wrong_pixel"])
    return both_walks(engine, exercise, picture, ray, folder)


def checkpoint_of_rays(exercise):
    """The first one whose rays go through a scene; None where none do."""
    return next((checkpoint for checkpoint in exercise.checkpoints
                 if checkpoint.question["kind"] == "checkpoint"
                 and words_of(checkpoint, exercise.chapter) is not None), None)


def _never_shows(exercise):
    return (f"{exercise.number} asks about no ray in a scene, so there is nothing to be seen. "
            f"`./course check {exercise.number}` says which numbers are wrong.")


def nothing_to_see(exercise):
    """What is said where nothing is wrong that could be shown."""
    has_picture = any(c.question["kind"] == "picture" for c in exercise.checkpoints)
    if checkpoint_of_rays(exercise) is None and not has_picture:
        return _never_shows(exercise)
    own = " --ray shows one of your own." if checkpoint_of_rays(exercise) else ""
    return f"There is no wrong ray or pixel to look at.{own}"


def given_ray(exercise, ray):
    """The visualizer's words for a ray of one's own, in the first checkpoint that has a scene."""
    checkpoint = checkpoint_of_rays(exercise)
    if checkpoint is None:
        raise CourseError(_never_shows(exercise))
    return [*words_of(checkpoint, exercise.chapter), f"--ray={ray_text(ray)}"]


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
