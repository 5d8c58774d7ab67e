"""A person's workbook: a copy of each file that has exercises, with stubs in the place of solutions."""

import hashlib
import json
import shutil

from . import hunt, marks
from .errors import CourseError
from .exercises import ROOT, load

PROGRESS = "progress.json"


def files_of(exercises):
    return sorted({exercise.file for exercise in exercises})


def _blank(file, exercises, seed):
    """The project's file with the stub of each exercise in the place of its solution."""
    stubs = {exercise.number: hunt.stub_of(exercise, seed=seed) for exercise in exercises
             if exercise.file == file}
    return marks.with_code((ROOT / file).read_text(), file, stubs)


def seed_of(folder, exercises):
    """That of any hunt in it; a new one where there is none."""
    seeds = (hunt.seed_in(code_of(folder, exercise) or ()) for exercise in exercises if exercise.plants)
    return next((seed for seed in seeds if seed is not None), None) or hunt.new_seed()


def start(folder, exercises, seed):
    """Makes what is missing; never over a file that is there. The seed chooses what is hunted.
    Returns the files made."""
    made = []
    for file in files_of(exercises):
        path = folder / file
        if path.exists():
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(_blank(file, exercises, seed))
        made.append(file)
    return made


def require(folder):
    if not folder.is_dir():
        raise CourseError(f"{folder}: there is no workbook. Run `./course start`.")


def code_of(folder, exercise):
    """The person's lines of an exercise; None where they cannot be read."""
    try:
        text = marks.text_of(folder / exercise.file)
        return marks.regions(text, exercise.file)[exercise.number].code
    except (OSError, KeyError, CourseError):
        return None


def _digest(code):
    return hashlib.sha256("\n".join(code).encode()).hexdigest()


def _read_progress(folder):
    try:
        progress = json.loads((folder / PROGRESS).read_text())
        return progress if isinstance(progress, dict) else {}
    except (OSError, ValueError):
        return {}


def remember(folder, results):
    """What was found out, for `list`: it counts as long as the person's lines stay the same."""
    progress = _read_progress(folder)
    for result in results:
        code = code_of(folder, result.exercise)
        if code is not None:
            progress[result.exercise.number] = {"state": result.state, "code": _digest(code)}
    (folder / PROGRESS).write_text(json.dumps(progress, indent=1, sort_keys=True) + "\n")


def state_of(folder, exercise):
    """passed, failed ... as last checked; `not started`, `not checked` or `missing`."""
    code = code_of(folder, exercise)
    if code is None:
        return "missing"
    if marks.is_same(code, hunt.stub_of(exercise, code)):
        return "not started"
    known = _read_progress(folder).get(exercise.number)
    is_current = isinstance(known, dict) and known.get("code") == _digest(code)
    return str(known.get("state")) if is_current else "not checked"


def _free_name(path):
    """Beside the file: FILE.before_reset, FILE.before_reset_2 ...; what was kept before stays."""
    number, kept = 1, path.with_name(path.name + ".before_reset")
    while kept.exists():
        number += 1
        kept = path.with_name(f"{path.name}.before_reset_{number}")
    return kept


def reset(folder, exercise):
    """Puts the stub back. Where that changes the file, it is kept as it was beside it: returns the
    copy's path."""
    path = folder / exercise.file
    exercises = load()
    seed = seed_of(folder, exercises)
    text = _blank(exercise.file, exercises, seed)
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return None
    own = marks.text_of(path)
    try:
        others = {number: region.code for number, region in marks.regions(own, path).items()
                  if number != exercise.number}
        stub = hunt.stub_of(exercise, code_of(folder, exercise) or (), seed)
        text = (marks.with_code(own, path, {exercise.number: stub})
                if exercise.number in marks.regions(own, path)
                else marks.with_code(text, path, others))
    except CourseError:  # its marks are broken: the whole file starts anew
        pass
    if text == own:
        return None
    kept = _free_name(path)
    shutil.copyfile(path, kept)
    path.write_text(text)
    return kept
