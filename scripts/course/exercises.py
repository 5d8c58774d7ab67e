"""The exercises, as the files chapters/*/exercises.toml and the marks in the sources have them."""

import struct
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

try:
    import tomllib
except ImportError as error:
    raise SystemExit("course: this needs Python 3.11 or later, which has the module tomllib.") from error

from . import marks
from .errors import CourseError

ROOT = Path(__file__).resolve().parents[2]
FARTHEST = struct.unpack("<f", b"\xff\xff\x7f\x7f")[0]  # t_max of a ray without an end

# Another order of the same operations moves a number by a few units in the last place (2^-24 of
# it), more where some of it cancels: 2^-16 leaves room for that, and no wrong sign or index.
USUAL_TOLERANCE = 2.0**-16

# A checkpoint's fields that go to the program as they are.
PASSED_ON = ("kind", "subject", "scene", "triangle", "structure", "observer", "options", "seed",
             "steps", "width", "height", "numbers", "points", "counts", "zeros", "random_rays", "families")


@dataclass
class Checkpoint:
    name: str
    question: dict
    values: list  # pairs of name and type: float, exact (a float, without a tolerance), int or bool
    tolerance: float
    known: list  # of {ray, step, expected, because}
    view: list = field(default_factory=list)  # of a scene that is no sample: its file, and options
    given: dict = field(default_factory=dict)  # names for the eight numbers, where they are no ray
    where: str = ""  # what else the question says
    observed: bool = True  # whether a shader part has to visit and test what the project's does


@dataclass
class Exercise:
    number: str
    title: str
    file: str  # of the project
    chapter: str  # the folder's name: 04_grid
    task: str
    formulas: list
    source: str
    hints: list
    checkpoints: list
    mutations: list
    plants: list = field(default_factory=list)  # of a hunt: mistakes, of which a seed chooses one
    hunted: str = "mistake"  # what they show as: a spot, a leak
    minutes: int = 20  # that it takes
    experiment: dict = field(default_factory=dict)  # {arguments, figure, tolerance}: what is measured
    replaces: str = ""  # the shader that the file stands for in a check, where that is another
    answers: list = field(default_factory=list)  # of answers.toml: as students write them
    region: marks.Region = field(repr=False, default=None)

    @property
    def is_shader(self):
        return self.file.endswith((".glsl", ".frag", ".vert"))

    @property
    def place(self):
        """Where the person's file lies when it is compiled."""
        return self.replaces or self.file


def bits(number):
    return struct.unpack("<I", struct.pack("<f", number))[0]


def from_bits(number):
    return struct.unpack("<f", struct.pack("<I", number))[0]


def ray_text(ray):
    """As --ray takes it: nine digits give a number of single precision back, bit for bit."""
    return ",".join(f"{from_bits(word):.9g}" for word in ray)


def ray_bits(ray):
    """Six numbers are a ray without an end, eight have t_min and t_max too."""
    if len(ray) not in (6, 8):
        raise CourseError(f"a ray has six numbers, or eight with t_min and t_max, and not {len(ray)}.")
    try:
        return [bits(float(number)) for number in [*ray, *([0.0, FARTHEST][len(ray) // 8 * 2:])]]
    except (ValueError, OverflowError) as error:
        raise CourseError(f"a ray consists of numbers of single precision: {error}.") from error


def _checkpoint(table, place):
    question = {key: table[key] for key in PASSED_ON if key in table}
    if question.get("scene", "").endswith(".obj"):
        question["scene"] = str(ROOT / question["scene"])
    question["rays"] = [ray_bits(ray) for ray in table.get("rays", [])]
    known = table.get("known", [])
    rays = [ray_bits(entry["ray"]) for entry in known if "ray" in entry]
    question["rays"] = rays + question["rays"]  # a known ray is asked like any other
    for index, entry in enumerate(entry for entry in known if "ray" in entry):
        entry["index"] = index
    values = [tuple(value.split()) for value in table.get("values", [])]
    for value in values:
        if len(value) != 2 or value[1] not in ("float", "exact", "int", "bool"):
            raise CourseError(f"{place}: the value `{' '.join(value)}` is no name with float, exact, "
                              "int or bool. Write it so.")
    given = table.get("given", {})
    if any(number not in range(8) for numbers in given.values() for number in numbers):
        raise CourseError(f"{place}: `given` names numbers of a ray, which are 0 to 7. Write it so.")
    return Checkpoint(table["name"], question, values, table.get("tolerance", USUAL_TOLERANCE), known,
                      table.get("view", []), given, table.get("where", ""),
                      table.get("observed", "observer" not in table))


def _exercise(table, chapter, place):
    checkpoints = [_checkpoint(entry, place) for entry in table.get("checkpoint", [])]
    return Exercise(table["number"], table["title"], table["file"], chapter, table["task"].strip(),
                    table.get("formulas", []), table.get("source", ""), table["hints"],
                    checkpoints, table.get("mutation", []), table.get("plant", []),
                    table.get("hunted", "mistake"), table.get("minutes", 20), table.get("experiment", {}),
                    table.get("replaces", ""))


def _answers(path, place):
    """By exercise: what students wrote who knew only the task and the lesson, each right or wrong,
    with the reason."""
    by_number = {}
    if path.exists():
        try:
            for answer in tomllib.loads(path.read_text())["answer"]:
                if answer["kind"] not in ("right", "wrong") or not answer["why"]:
                    raise CourseError(f"{place}: the answer `{answer['name']}` is neither right nor "
                                      "wrong, or does not say why. Write it so.")
                by_number.setdefault(answer["exercise"], []).append(answer)
        except (KeyError, tomllib.TOMLDecodeError) as error:
            raise CourseError(f"{place}: {error} is missing or wrong. Write it as in the other "
                              "chapters.") from error
    return by_number


def _files(root, which):
    """Those of all chapters, or the one of that chapter's or exercise's chapter."""
    number = (which or "").split(".")[0]
    own = sorted((root / "chapters").glob(f"{int(number):02}_*/exercises.toml")) if number.isdecimal() else []
    return own or sorted((root / "chapters").glob("[0-9][0-9]_*/exercises.toml"))


def load(root=ROOT, with_answers=False, which=None):
    """All exercises in the order of their numbers, with their regions in the sources; with what students
    wrote where that is asked for. Those of one chapter take a tenth of the time: `which` is its number, or
    that of an exercise; where there is no such chapter, all are there."""
    exercises, texts = [], {}
    for path in _files(root, which):
        place = path.relative_to(root)
        try:
            tables = tomllib.loads(path.read_text())["exercise"]
            found = [_exercise(table, path.parent.name, place) for table in tables]
        except (KeyError, tomllib.TOMLDecodeError) as error:
            raise CourseError(f"{place}: {error} is missing or wrong. Write it as in the other "
                              "chapters.") from error
        answers_place = place.with_name("answers.toml")
        answers = _answers(root / answers_place, answers_place) if with_answers else {}
        unknown = set(answers) - {exercise.number for exercise in found}
        if unknown:
            raise CourseError(f"{answers_place}: {min(unknown)} is no exercise of "
                              f"{place}. Put its number right.")
        chapter, counts = int(path.parent.name[:2]), Counter(exercise.number for exercise in found)
        for number, count in counts.items():
            if count > 1 or int(number.split(".")[0]) != chapter:
                raise CourseError(f"{place}: {number} is there twice, or is none of chapter {chapter}. "
                                  f"Number them {chapter}.1, {chapter}.2, and so on.")
        for exercise in found:
            exercise.answers = answers.get(exercise.number, [])
            if exercise.file not in texts:
                texts[exercise.file] = (root / exercise.file).read_text()
            marked = marks.regions(texts[exercise.file], exercise.file)
            if exercise.number not in marked:
                raise CourseError(f"{place}: exercise {exercise.number} has no mark in "
                                  f"{exercise.file}. Put `//# exercise {exercise.number}: ...` there.")
            exercise.region = marked[exercise.number]
        exercises += found
    return sorted(exercises, key=lambda exercise: [int(part) for part in exercise.number.split(".")])


def select(exercises, wanted):
    """`04` or `4` names a chapter, `4.2` an exercise, nothing all of them."""
    if not wanted:
        return exercises
    chosen = [e for e in exercises if e.number == wanted
              or (wanted.isdigit() and int(e.number.split(".")[0]) == int(wanted))]
    if not chosen:
        numbers = ", ".join(e.number for e in exercises)
        raise CourseError(f"{wanted} is no chapter and no exercise. Take one of {numbers}.")
    return chosen


def select_one(exercises, wanted):
    chosen = [e for e in exercises if e.number == wanted]
    if not chosen:
        raise CourseError(f"{wanted} is no exercise. `./course list` shows their numbers.")
    return chosen[0]
