"""What is handed in of a hunt beside the repaired part: a ray, or numbers, and the step at which the
mistake first shows. The check runs it on both texts."""

import re

from . import compare, engine as engines, marks
from .errors import CourseError
from .exercises import ROOT, ray_bits
from .hunt import planted, seed_in
from .own import Own, overlay
from .view import question_of_pixels, ray_of_pixel, size_of

WITNESS = re.compile(r"^\s*// witness:\s*(?P<place>.*?)\s*$")
PLACE = re.compile(r"(?P<pixel>pixel\s+)?(?P<numbers>.*?)(?:,?\s*\bstep\s+(?P<step>\d+))?\s*")


def place_in(engine, exercise, text, name):
    """The ray as bits, and the step, of words such as `0,0,5,0,0,-1 step 2` or `pixel 33,11`. Raises
    CourseError, which names where they stand, if they are none."""
    found = PLACE.fullmatch(text)
    step = int(found["step"] or 1)
    try:
        if not found["pixel"]:
            return ray_bits([float(word) for word in found["numbers"].split(",")]), step
        pixel = [int(word) for word in found["numbers"].split(",")]
    except ValueError as error:
        raise CourseError(f"{name} cannot be read: {error}. Write six numbers, or eight, with commas "
                          "between them.") from error
    question = question_of_pixels(exercise)
    if question is None:
        raise CourseError(f"{name}: {exercise.number} has no scene, and so no pixel. Write a ray: the task "
                          "says how.")
    width, height = size_of(question)
    if len(pixel) != 2 or not (0 <= pixel[0] < width and 0 <= pixel[1] < height):
        raise CourseError(f"{name} names a pixel that is not in a picture of {width} x {height}. Write its "
                          "column and row, as in `pixel 33,11`.")
    return ray_of_pixel(engine, exercise, question, pixel), step


def witness_in(engine, exercise, code):
    """The ray as bits, and the step. Raises CourseError where the line says neither."""
    found = next((match for match in map(WITNESS.match, code) if match), None)
    if found is None:
        raise CourseError("the line `// witness:` is gone. Put it back below `//# exercise`.")
    if not found["place"]:
        raise CourseError("the line `// witness:` is empty. Write a ray or a pixel there where the part "
                          "goes wrong: the task says how.")
    return place_in(engine, exercise, found["place"], "the line `// witness:`")


def with_code(exercise, code):
    """The project's file with other lines in the place of the exercise's."""
    text = (ROOT / exercise.file).read_text()
    own = marks.with_code(text, exercise.file, {exercise.number: code})
    composed = marks.compose(text, own, exercise.file, exercise.file, {exercise.number})
    return Own(composed, False, exercise.file)


def complaint(engine, exercise, code, ask_own, given_seed=None):
    """What is wrong with the witness, in words; empty where it is right. `ask_own` asks a folder's
    text. The seed has to be the one that was given to the student, where one was."""
    seed = seed_in(code)
    if seed is None:
        return "the line `// seed ...` is gone. Put it back, or let ./course reset do it."
    if given_seed not in (None, seed):
        return (f"the line `// seed {seed}` is not this student's, whose seed is {given_seed}: what was hunted "
                "is another mistake.")
    try:
        ray, step = witness_in(engine, exercise, code)
    except CourseError as error:
        return str(error)
    checkpoint = exercise.checkpoints[0]
    steps = checkpoint.question.get("steps", 1)
    if step > steps:
        return f"the witness names step {step}, and there are {steps}."
    question = {**checkpoint.question, "rays": [ray], "random_rays": 0}
    program = engine.shaders_program() if exercise.is_shader else engine.builders_program()
    right = engines.ask_reference(engine, program, exercise.chapter, [question])
    with overlay(exercise, with_code(exercise, planted(exercise, seed))) as folder:
        answers = ask_own(engine, exercise, folder, [question])
    if isinstance(answers, engines.Failure):
        return f"the witness could not be tried: {answers.message}"
    wrong = compare.first_wrong(answers[0], right[0], checkpoint)
    if wrong is None:
        return "the witness is none: with this ray your part does what it should even before it is repaired. Try another."
    if wrong.step != step:
        return f"the witness is near: that goes wrong first at another step than {step}."
    return ""
