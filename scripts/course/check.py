"""Checks one exercise: checkpoint after checkpoint, up to the first that is wrong."""

import shutil
from dataclasses import dataclass, field, replace
from pathlib import Path

from . import compare, engine as engines, experiment, marks, rounds
from .errors import CourseError, MachineError
from .own import named_as_the_person_knows, overlay, place_of, read_own
from .witness import complaint

PASSED, FAILED, NOT_STARTED, MISSING = "passed", "failed", "not started", "missing"
RIGHT_HERE = "right here"  # a part with a mistake, at one ray
FINE = (PASSED, NOT_STARTED, RIGHT_HERE)
PICTURE_WAITS = "a checkpoint before it is wrong"
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
    outside: str = ""  # which lines outside the marks were changed, in words


def _is_picture(question):
    return question["kind"] == "picture"


def _asked(exercise, rays):
    """The checkpoints but for the picture, and their questions; with the given rays (as bits)
    instead of their own where there are some. What is hunted shows at the first one: to others, a ray
    may be other numbers."""
    checkpoints = [c for c in exercise.checkpoints if not _is_picture(c.question)]
    checkpoints = checkpoints[:1] if exercise.plants and rays is not None else checkpoints
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


def _asker(engine, exercise, folder):
    """A function that asks the person's code; a Failure where it does not compile."""
    program, own = _program(engine, exercise), folder / "shaders"
    if not exercise.is_shader:
        program, own = engines.build_with(engine, exercise.file, folder), folder
        if isinstance(program, engines.Failure):
            return program
    return lambda questions, by=engine: engines.ask(by, program, exercise.chapter, questions, own)


def ask_own(engine, exercise, folder, questions):
    ask = _asker(engine, exercise, folder)
    return ask if isinstance(ask, engines.Failure) else ask(questions)


def _smaller(question, rays):
    """The question about less, again and again, each with its index and step: ray by ray, or for a builder
    about more and more boxes."""
    if question["kind"] in RAY_BY_RAY:
        for index, ray in enumerate(rays):
            yield index, 1, {**question, "rays": [ray], "random_rays": 0}
    elif question["kind"] == "builder":
        least = question.get("numbers", {}).get("least", 2)
        for count in range(least, len(rays) + 1):
            numbers = {**question.get("numbers", {}), "least": count}
            yield 0, count - least + 1, {**question, "rays": rays[:count], "random_rays": 0,
                                         "numbers": numbers}


def _find_failure(engine, result, ask, checkpoints, questions, reference):
    """At which checkpoint C++ crashes or never ends, and for what it was given."""
    quick = replace(engine, limits=replace(engine.limits, cpu_seconds=1, seconds=10))
    for checkpoint, question, wanted in zip(checkpoints, questions, reference):
        if not isinstance(ask([question], quick), engines.Failure):
            continue
        result.checkpoint = checkpoint
        for index, step, less in _smaller(question, wanted.rays):
            if isinstance(ask([less], quick), engines.Failure):
                result.wrong = compare.Wrong(index, step, wanted.rays[index], [], asked=wanted.rays)
                return
        return


def _find_endless(engine, result, own):
    """Whether the shader's answer is wrong because of a loop that never ends, which the renderer left."""
    checkpoint, exercise = result.checkpoint, result.exercise
    if checkpoint.question["kind"] != "checkpoint" or not rounds.has_loop(own.composed.text):
        return
    question = {**checkpoint.question, "rays": result.wrong.asked, "random_rays": 0}
    with overlay(exercise, own, counts_rounds=True) as folder:
        answers = _asker(engine, exercise, folder)([question])
    found = None if isinstance(answers, engines.Failure) else rounds.endless(answers[0])
    if found:
        step, index, line = found
        result.state = STATES["time"]
        result.message = (f"{place_of(line, exercise, own)}: this loop never ends. It was left after "
                          f"{rounds.MOST_ROUNDS} rounds.")
        result.wrong = compare.Wrong(index, step, result.wrong.asked[index], [])


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


def _compare_pictures(engine, result, own, ask, store):
    """The exercise's picture against the reference's. What was wrong before stays."""
    exercise = result.exercise
    checkpoint = next((c for c in exercise.checkpoints if _is_picture(c.question)), None)
    if checkpoint is None:
        return
    reference = engines.reference_picture(engine, exercise.chapter, checkpoint.question)
    store.mkdir(parents=True, exist_ok=True)
    yours = store / f"exercise_{exercise.number.replace('.', '_')}"
    made = ask([{**checkpoint.question, "picture": str(yours)}])
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


def check(engine, exercise, folder, rays=None, store=None, is_shown=False, seed=None):
    """The result for one exercise of a workbook. Pictures are compared where they have a place,
    `store`; after a wrong checkpoint only where they are to be shown. Where there is a seed, what is
    hunted has to be its mistake."""
    result = Result(exercise, PASSED)
    if not (Path(folder) / exercise.file).is_file():
        result.state = MISSING
        return result
    try:
        own = read_own(exercise, folder)
    except CourseError as error:
        result.state, result.message = FAILED, str(error)
        return result
    if exercise.plants and rays is not None:
        return _try_a_ray(engine, exercise, own, rays)
    if own.is_stub:
        result.state = NOT_STARTED
        return result
    if exercise.plants:
        return _judge_hunt(engine, exercise, own, folder, seed)
    return judge(engine, exercise, own, rays, store, is_shown)


def _try_a_ray(engine, exercise, own, rays):
    """Whether what is hunted shows with that ray."""
    result = judge(engine, exercise, own, rays)
    if result.state == PASSED:
        result.state = RIGHT_HERE
        result.message = f"no {exercise.hunted} here: with this ray your copy does what it should."
    return result


def _judge_hunt(engine, exercise, own, folder, seed):
    """The witness, then the part. Where the part is wrong is what the person is to find: a check says
    no ray and no picture."""
    code = marks.regions((Path(folder) / exercise.file).read_text(errors="replace"),
                         exercise.file)[exercise.number].code
    wrong = complaint(engine, exercise, code, ask_own, seed)
    if wrong:
        return Result(exercise, FAILED, wrong, outside=own.outside)
    result = judge(engine, exercise, own)
    if result.wrong:
        result.message = f"The witness is right; the part is wrong still, at {result.checkpoint.name}."
        result.checkpoint = result.wrong = None
    return result


def judge(engine, exercise, own, rays=None, store=None, is_shown=False):
    """The result for a file that is ready for the compiler, be it a stub or not."""
    if exercise.experiment:
        code = marks.regions(own.composed.text, exercise.file)[exercise.number].code
        wrong = experiment.complaint(engine, exercise, code)
        return Result(exercise, FAILED if wrong else PASSED, wrong)
    result = Result(exercise, PASSED, outside=own.outside)
    checkpoints, questions = _asked(exercise, rays)
    reference = engines.ask_reference(engine, _program(engine, exercise), exercise.chapter, questions)
    with overlay(exercise, own) as folder:
        ask = _asker(engine, exercise, folder)
        if isinstance(ask, engines.Failure):
            return _failed(result, ask, own)
        for asked in _rounds(engine, exercise, len(questions)):
            answers = ask(questions[asked])
            if isinstance(answers, engines.Failure):
                if not exercise.is_shader and engine.companions is None:
                    _find_failure(engine, result, ask, checkpoints, questions, reference)
                return _failed(result, answers, own)
            _compare_all(result, answers, reference[asked], checkpoints[asked], rays is None)
            if result.state != PASSED:
                break
        if result.wrong and exercise.is_shader and engine.companions is None:
            _find_endless(engine, result, own)
        has_picture = any(_is_picture(checkpoint.question) for checkpoint in exercise.checkpoints)
        if store is not None and has_picture and (result.state == PASSED or is_shown):
            _compare_pictures(engine, result, own, ask, store)
        elif store is not None and has_picture:
            result.no_picture = PICTURE_WAITS
    return result
