"""An experiment: a count that is predicted, measured by a command, and explained in a sentence. The
check measures too."""

import json
import os
import re
import subprocess
import tempfile
from functools import lru_cache
from pathlib import Path

from .errors import CourseError, MachineError

FIELDS = ("predicted", "measured", "why")
LEAST_WORDS = 5  # of a sentence


def _fields(code):
    found = {}
    for line in code:
        name, colon, text = line.strip().partition(":")
        if colon and name in FIELDS:
            found[name] = text.strip()
    return found


def _number(fields, name):
    text = fields.get(name, "").replace(",", "")
    if not text:
        raise CourseError(f"`{name}:` is empty. Write a number behind it.")
    try:
        return float(text)
    except ValueError as error:
        raise CourseError(f"`{name}: {text}` is no number. Write one, without a unit.") from error


def _part_of(found, word):
    """Of an object the value of that name; of a list the element of that number, or the one that has
    `name=value`."""
    name, equals, value = word.partition("=")
    if equals:
        return next(one for one in found if one[name] == value)
    return found[int(word)] if isinstance(found, list) else found[word]


@lru_cache(maxsize=None)
def _measure(program, arguments, figure):
    if not Path(program).exists():
        raise MachineError(f"{program}: is not there, and the experiment runs it. `./run.sh "
                           f"{Path(program).name} --help` builds it.")
    environment = {key: value for key, value in os.environ.items() if key != "RAYSTEPS_SHADERS"}
    with tempfile.TemporaryDirectory(prefix="raysteps_experiment_") as folder:
        file = Path(folder) / "figures.json"
        done = subprocess.run([program, *arguments, "--out", folder, "--json", file], env=environment,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise MachineError(f"{' '.join([program, *arguments])} failed: {done.stderr.strip()}")
        found = json.loads(file.read_text())
    for word in figure.split("."):
        found = _part_of(found, word)
    return float(len(found) if isinstance(found, list) else found)


def complaint(engine, exercise, code):
    """What is wrong with the person's lines, in words; empty where nothing is. Of a prediction it is
    asked only that there is one."""
    fields = _fields(code)
    try:
        _number(fields, "predicted")
        measured = _number(fields, "measured")
    except CourseError as error:
        return str(error)
    if len(re.findall(r"\w+", fields.get("why", ""))) < LEAST_WORDS:
        return "`why:` wants one sentence: why is it that many?"
    setting = exercise.experiment
    name = setting.get("program", exercise.chapter)
    program = Path(engine.build) / "chapters" / name / name
    right = _measure(str(program), tuple(setting["arguments"]), setting["figure"])
    if abs(measured - right) > setting.get("tolerance", 0.0) * abs(right):
        return (f"`measured: {fields['measured']}` is not what is measured here. Run the command of "
                f"`./course show {exercise.number}` again.")
    return ""
