"""The author's check: that the exercises are complete, and that their tests tell right from wrong."""

import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from . import hunt, marks
from .check import FAILED, PASSED, STATES, ask_own, judge
from .exercises import ROOT, load
from .own import Own, text_for_compiler
from .witness import complaint, with_code, witness_in

# A loop that never ends is caught by its time, and C++ that reads beyond its data may crash.
REJECTED = (FAILED, STATES["time"], STATES["crash"])


@dataclass
class Finding:
    """What one trial of an exercise came to: `text` says what was tried."""

    number: str
    kind: str  # complete, blank, solution, mutation, right, wrong
    text: str
    is_right: bool
    detail: str = ""


def find_unmarked(exercises):
    """Marks in the sources that no exercises.toml knows."""
    known = {exercise.number for exercise in exercises}
    found = []
    for folder in ("shaders", "common", "chapters"):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".glsl", ".frag", ".vert", ".cpp", ".txt"):
                name = str(path.relative_to(ROOT))
                found += [Finding(number, "complete", f"{name} marks it", False,
                                  "no exercises.toml has it")
                          for number in marks.regions(path.read_text(), name) if number not in known]
    return found


def is_named(exercise):
    """Whether the lesson lists the exercise, by number and title, in its section on exercises."""
    lesson = (ROOT / "chapters" / exercise.chapter / "README.md").read_text()
    section = re.search(r"^## Exercises\n(.*?)(?:^## |\Z)", lesson, re.MULTILINE | re.DOTALL)
    return bool(section) and f"\n- {exercise.number} {exercise.title}\n" in section[1] + "\n"


def is_complete(exercise):
    """What lacks, in words; empty where nothing does."""
    known = [known for checkpoint in exercise.checkpoints for known in checkpoint.known]
    lacks = []
    lacks += [] if exercise.task else ["a task"]
    lacks += [] if len(exercise.hints) == 3 and all(exercise.hints) else ["three hints"]
    lacks += [] if exercise.region.stub or exercise.plants else ["a stub"]
    is_known = known and all(entry.get("because") for entry in known)
    lacks += [] if exercise.experiment or is_known else ["a known answer"]
    lacks += [] if len(exercise.mutations) >= 2 or exercise.plants else ["two mutations"]
    lacks += [] if not exercise.plants or len(exercise.plants) >= 5 else ["five mistakes to hunt"]
    lacks += [] if exercise.source else ["a source"]
    line = f"the line `- {exercise.number} {exercise.title}` in chapters/{exercise.chapter}/README.md"
    lacks += [] if is_named(exercise) else [line]
    return ", ".join(lacks)


def mutated(exercise, mutation):
    """The lines of the solution with the mistake; None where the text does not stand there once."""
    solution = "\n".join(exercise.region.code)
    if solution.count(mutation["find"]) != 1:
        return None
    return solution.replace(mutation["find"], mutation["replace"]).split("\n")


def _try(engine, exercise, kind, text, code, expected, store=None):
    result = judge(engine, exercise, with_code(exercise, code), store=store)
    where = f" at {result.checkpoint.name}" if result.checkpoint else ""
    step = f", step {result.wrong.step}" if result.wrong else ""
    return Finding(exercise.number, kind, text, result.state in expected,
                   f"{result.state}{where}{step} {result.message}".strip())


def unused_in(code):
    """The variables of the lines that are never used: they would give a planted mistake away."""
    text = "\n".join(code)
    return [name for name in re.findall(r"[\w>&] (\w+) =[^=]", text) if len(re.findall(rf"\b{name}\b", text)) == 1]


def _hunt(engine, exercise, seed):
    """The planted mistake fails, and the author's witness shows where."""
    plant = exercise.plants[seed]
    stub = hunt.planted(exercise, seed)
    if unused := unused_in(stub):
        return Finding(exercise.number, "hunt", plant["name"], False,
                       f"`{unused[0]}` is not used any more, which gives the mistake away")
    if stub[2:] == exercise.region.code:
        return Finding(exercise.number, "hunt", plant["name"], False,
                       f"`{plant['find']}` does not stand in the part")
    code = [f"{line} {plant['witness']}" if line.endswith("// witness:") else line for line in stub]
    wrong = complaint(engine, exercise, code, ask_own)
    if wrong:
        return Finding(exercise.number, "hunt", plant["name"], False, wrong)
    if witness_in(engine, exercise, code)[0] in exercise.checkpoints[0].question["rays"]:
        return Finding(exercise.number, "hunt", plant["name"], True, "failed at its witness")
    return _try(engine, exercise, "hunt", plant["name"], code, REJECTED)


def _trials(engine, exercise, store):
    region = exercise.region
    yield lambda: _try(engine, exercise, "solution", "the solution passes", region.code, (PASSED,),
                       store)
    for seed, plant in enumerate(exercise.plants):
        yield lambda seed=seed: _hunt(engine, exercise, seed)
    if not exercise.plants:
        yield lambda: _try(engine, exercise, "blank", "the blank fails", region.stub, (FAILED,))
    for mutation in exercise.mutations:
        code = mutated(exercise, mutation)
        if code is None:
            yield lambda mutation=mutation: Finding(
                exercise.number, "mutation", mutation["name"], False,
                f"`{mutation['find']}` does not stand in the solution exactly once")
        else:
            yield lambda mutation=mutation, code=code: _try(
                engine, exercise, "mutation", mutation["name"], code, REJECTED)
    for answer in exercise.answers:
        expected = (PASSED,) if answer["kind"] == "right" else REJECTED
        yield lambda answer=answer, expected=expected: _try(
            engine, exercise, answer["kind"], answer["name"], _code_of(answer),
            expected, store if answer["kind"] == "right" else None)


def _neighbour_files(exercise, exercises):
    """The other exercises of its file, each with the file in which this one is blank."""
    text = (ROOT / exercise.file).read_text()
    own = marks.with_code(text, exercise.file, {exercise.number: hunt.stub_of(exercise)})
    for other in exercises:
        if other.file == exercise.file and other.number != exercise.number:
            composed = marks.compose(text, own, exercise.file, exercise.file, {other.number})
            yield other, Own(composed, False, exercise.file)


def _compile_ahead(engine, chosen, exercises):
    """All versions of each C++ source that will be tried."""
    texts = {}
    for exercise in chosen:
        if exercise.file.endswith(".cpp"):
            codes = [exercise.region.code, exercise.region.stub,
                     *(mutated(exercise, mutation) for mutation in exercise.mutations),
                     *(hunt.planted(exercise, seed) for seed in range(len(exercise.plants))),
                     *(_code_of(answer) for answer in exercise.answers)]
            files = [with_code(exercise, code) for code in codes if code is not None]
            files += [own for other, own in _neighbour_files(exercise, exercises) if not _is_solution(other, own)]
            texts.setdefault(exercise.file, []).extend(
                text_for_compiler(exercise, own) for own in files)
    for file, versions in texts.items():
        engine.companions.compile(file, versions)


def _code_of(answer):
    return answer["code"].strip("\n").split("\n")


def _neighbours(engine, exercise, exercises):
    """With this exercise blank and all others solved, the others of its file still pass. Where that is the
    very text of their solution, they pass as it does."""
    for other, own in _neighbour_files(exercise, exercises):
        state = PASSED if _is_solution(other, own) else judge(engine, other, own).state
        yield Finding(exercise.number, "neighbour", f"its blank does not fail {other.number}",
                      state == PASSED, state)


def _is_solution(exercise, own):
    return own.composed.text == with_code(exercise, exercise.region.code).composed.text


def verify(engine, chosen, store, workers, say):
    """All findings for the chosen exercises; `say` is called with each as it comes."""
    exercises = load()
    findings = find_unmarked(exercises)
    for exercise in chosen:
        lacks = is_complete(exercise)
        findings.append(Finding(exercise.number, "complete",
                                "has task, stub, hints, source, known answers and mutations",
                                not lacks, f"lacks {lacks}" if lacks else ""))
    for finding in findings:
        say(finding)
    _compile_ahead(engine, chosen, exercises)
    trials = [trial for exercise in chosen for trial in _trials(engine, exercise, store)]
    trials += [lambda exercise=exercise: list(_neighbours(engine, exercise, exercises))
               for exercise in chosen]
    with ThreadPoolExecutor(workers) as pool:
        for found in pool.map(lambda trial: trial(), trials):
            for finding in found if isinstance(found, list) else [found]:
                findings.append(finding)
                say(finding)
    return findings
