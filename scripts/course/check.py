"""Checks one exercise: checkpoint after checkpoint, up to the first that is wrong."""

import shutil
from dataclasses import dataclass, field
from pathlib import Path

from . import compare, engine as engines
from .errors import CourseError, MachineError
from .own import named_as_the_person_knows, overlay, read_own

PASSED, FAILED, NOT_STARTED, MISSING = "passed", "failed", "not started", "missing"
RAY_BY_RAY = ("checkpoint", "function")  # what asks each ray, or its eight numbers, by itself
STATES = {"compile": "does not compile", "crash": "crashed", "time": "stopped", "machine": "failed"}

@dataclass
class Result:
    """What a check found. `wrong` is there where a checkpoint was wrong, `message` where none could
    be asked."""

    exercise: object
    state: str
    message: str = ""
    checkpoint: object = None
    wrong: compare.Wrong = None
    right: list = field(default_factory=list)  # the names of the checkpoints before
    pictures: dict = field(default_factory=dict)
    no_picture: str = ""  # why there is none


def _is_picture(question):
    return question["kind"] == "picture"


def _asked(exercise, rays):
    """The checkpoints but for the picture, and their questions; with the given rays (as bits)
    instead of their own where there are some."""
    checkpoints = [c for c in exercise.checkpoints if not _is_picture(c.question)]
    questions = [dict(checkpoint.question) for checkpoint in checkpoints]
    for question in questions if rays is not None else []:
        if question["kind"] in RAY_BY_RAY:
            question.update(rays=rays, random_rays=0)
    return checkpoints, questions


def _rounds(engine, exercise, count):
    """All at once; one checkpoint after the other where a program stays, up to the first that is
    wrong: the shaders of those behind it need not be compiled."""
    if engine.companions and exercise.is_shader:
        return [slice(index, index + 1) for index in range(count)]
    return [slice(0, count)]


def _program(engine, exercise):
    return engine.shaders_program() if exercise.is_shader else engine.builders_program()


def _ask_own(engine, exercise, folder, questions):
    if exercise.is_shader:
        return engines.ask(engine, _program(engine, exercise), exercise.chapter, questions,
                           folder / "shaders")
    program = engines.build_with(engine, exercise.file, folder)
    if isinstance(program, engines.Failure):
        return program
    return engines.ask(engine, program, exercise.chapter, questions)


def _failed(result, failure, own):
    result.state = STATES[failure.kind]
    result.message = named_as_the_person_knows(failure.message, result.exercise, own)
    return result


def _compare_all(result, answers, reference, checkpoints, is_usual):
    for answer, wanted, checkpoint in zip(answers, reference, checkpoints):
        if not compare.is_shaped_like(answer, wanted):
            result.state, result.message = STATES["crash"], "gave an answer of another form."
            return
        wrong = compare.first_unknown(answer, checkpoint) if is_usual else None
        wrong = wrong or compare.first_wrong(answer, wanted, checkpoint)
        if wrong:
            result.state, result.checkpoint, result.wrong = FAILED, checkpoint, wrong
            return
        result.right.append(checkpoint.name)


def _compare_pictures(engine, result, own, folder, store):
    """The exercise's picture against the reference's. What was wrong before stays."""
    exercise = result.exercise
    checkpoint = next((c for c in exercise.checkpoints if _is_picture(c.question)), None)
    if checkpoint is None:
        return
    reference = engines.reference_picture(engine, exercise.chapter, checkpoint.question)
    store.mkdir(parents=True, exist_ok=True)
    yours = store / f"exercise_{exercise.number.replace('.', '_')}"
    made = _ask_own(engine, exercise, folder, [{**checkpoint.question, "picture": str(yours)}])
    if isinstance(made, engines.Failure):
        if result.state == PASSED:
            _failed(result, made, own)
        else:
            result.no_picture = named_as_the_person_knows(made.message, exercise, own)
        return
    question = {"kind": "difference", "subject": "", "picture": str(yours), "reference": str(reference)}
    found = engines.ask(engine, engine.shaders_program(), exercise.chapter, [question])
    if isinstance(found, engines.Failure):
        raise MachineError(f"the pictures cannot be compared: {found.message}")
    column, row, pixels = found[0].steps[0][0][:3]
    shutil.copyfile(f"{reference}.png", f"{yours}_reference.png")
    result.pictures = {"yours": f"{yours}.png", "reference": f"{yours}_reference.png",
                       "compared": f"{yours}.compared.png", "wrong_pixels": pixels}
    if pixels:
        result.pictures["first_wrong_pixel"] = [column, row]
    if result.state == PASSED and pixels:
        result.state, result.checkpoint = FAILED, checkpoint
    elif result.state == PASSED:
        result.right.append(checkpoint.name)


def check(engine, exercise, folder, rays=None, store=None):
    """The result for one exercise of a workbook. Pictures are compared where they have a place,
    `store`."""
    result = Result(exercise, PASSED)
    if not (Path(folder) / exercise.file).is_file():
        result.state = MISSING
        return result
    try:
        own = read_own(exercise, folder)
    except CourseError as error:
        result.state, result.message = FAILED, str(error)
        return result
    if own.is_stub:
        result.state = NOT_STARTED
        return result
    return judge(engine, exercise, own, rays, store)


def judge(engine, exercise, own, rays=None, store=None):
    """The result for a file that is ready for the compiler, be it a stub or not."""
    result = Result(exercise, PASSED)
    checkpoints, questions = _asked(exercise, rays)
    reference = engines.ask_reference(engine, _program(engine, exercise), exercise.chapter, questions)
    with overlay(exercise, own) as folder:
        for asked in _rounds(engine, exercise, len(questions)):
            answers = _ask_own(engine, exercise, folder, questions[asked])
            if isinstance(answers, engines.Failure):
                return _failed(result, answers, own)
            _compare_all(result, answers, reference[asked], checkpoints[asked], rays is None)
            if result.state != PASSED:
                break
        if store is not None and exercise.is_shader:
            _compare_pictures(engine, result, own, folder, store)
    return result
