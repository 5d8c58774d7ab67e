"""The shader exercises as the page of the playground checks them: a script for each chapter, and one that lists all.

The C++ program course_shaders resolves each question: the rays as bits, what the project's own sources find for them, and
the scene with the very structure that it walked. Solutions and mistakes are left out; the stubs stand in shaders/ itself."""

import base64
import json
import re
import struct
import tempfile
from pathlib import Path

from course import engine as engines
from course import marks
from course.errors import MachineError
from course.exercises import bits, load
from course.formulas import plain

SHADERS = "scripts/course/answers/shaders"
SMALLEST = "tetrahedron:0"
MOST_RAYS = 1024  # of a checkpoint: the hunt for spots has twice as many, which are 70 kB
INITIAL = re.compile(r"^uniform int (\w+) = (\d+);", re.MULTILINE)
ASKED = ("kind", "subject", "triangle", "structure", "observer", "steps", "width", "height", "points", "counts", "zeros")


def shader_exercises(root):
    """Those in shaders. The lines of a whole walk stand in a file of its own, which takes the place of the project's walk."""
    return [exercise for exercise in load(root) if exercise.is_shader]


def chapter_file(chapter):
    return f"exercises_{chapter}.js"


def _packing(question, file):
    """A question whose answer does not matter: it leaves the scene of another one in a file. One that names no scene looks at
    its rays only, so any will do."""
    if question["kind"] == "rays":
        question = {**question, "kind": "checkpoint", "subject": "closest.glsl"}
    return {"scene": SMALLEST, **question, "random_rays": 0, "steps": 1, "packed": str(file)}


class _Blob:
    """Bytes one behind the other; the same ones stand there once."""

    def __init__(self):
        self.bytes, self._places = b"", {}

    def add(self, data):
        data += b"\0" * (-len(data) % 4)
        if data not in self._places:
            self._places[data] = {"start": len(self.bytes), "bytes": len(data)}
            self.bytes += data
        return self._places[data]


def _words(rows):
    """Rows of numbers as bits, column behind column: what is alike then stands together, and packs better."""
    return b"".join(struct.pack(f"<{len(column)}I", *column) for column in zip(*rows))


def _known(entry, values):
    """A known answer, its numbers as bits: JSON has no infinity and no NaN."""
    expected = [bits(float(value)) if kind in ("float", "exact") else value
                for (_, kind), value in zip(values, entry["expected"])]
    return {"step": entry.get("step", 1), "index": entry.get("index", 0), "expected": expected, "because": entry["because"]}


def _checkpoint(checkpoint, answer, packed, blob):
    """For the page: the question, its rays, its scene, and the answers."""
    question = checkpoint.question
    made = {key: question[key] for key in ASKED if key in question}
    made |= {"name": checkpoint.name, "where": checkpoint.where, "given": checkpoint.given, "tolerance": checkpoint.tolerance,
             "values": checkpoint.values, "numbers": question.get("numbers", {}), "observed": getattr(checkpoint, "observed", False),
             "known": [_known(entry, checkpoint.values) for entry in checkpoint.known]}
    answer = engines.Answer(answer.rays[:MOST_RAYS], [step[:MOST_RAYS] if answer.rays else step for step in answer.steps])
    if question["kind"] == "rays":  # the camera is all that they need
        length = struct.unpack("<I", packed[:4])[0]
        made |= {"scene_name": question["scene"], "view": json.loads(packed[4:4 + length])["view"]}
    else:
        made["scene"] = blob.add(packed)
    return made | {"words": len(answer.steps[0][0]), "count": len(answer.steps[0]), "rays": blob.add(_words(answer.rays)),
                   "answers": [blob.add(_words(step)) for step in answer.steps]}


def _resolve(engine, exercise, blob):
    """What the program answers, for all checkpoints but pictures."""
    with tempfile.TemporaryDirectory(prefix="raysteps_playground_") as folder:
        asked = [(checkpoint, Path(folder) / str(place)) for place, checkpoint in enumerate(exercise.checkpoints)
                 if checkpoint.question["kind"] != "picture"]
        questions, packing = [], []
        for checkpoint, file in asked:
            question = dict(checkpoint.question)
            if question["kind"] == "checkpoint" and "scene" in question:
                question["packed"] = str(file)
            else:
                packing.append(_packing(question, file))
            questions.append(question)
        answers = engines.ask(engine, engine.shaders_program(), exercise.chapter, questions + packing)
        if isinstance(answers, engines.Failure):
            raise MachineError(f"the project's own sources give no answer: {answers.message}")
        return [_checkpoint(checkpoint, answer, file.read_bytes(), blob) for (checkpoint, file), answer in zip(asked, answers)]


def _shaders(root, chapter, exercises):
    """What checkpoints are made of. WebGL has no initial values of uniforms: they are numbers beside the text."""
    files, numbers = {}, {}
    written = {root / exercise.file for exercise in exercises}
    for folder in (SHADERS, f"chapters/{chapter}/exercises"):
        for path in sorted((root / folder).iterdir()):
            if path.suffix in (".glsl", ".frag") and path not in written:
                text = path.read_text(encoding="utf-8")
                numbers |= {name: int(value) for name, value in INITIAL.findall(text)}
                files[path.name] = INITIAL.sub(r"uniform int \1;", text)
    return files, numbers


def _picture(exercise):
    """A picture that goes through the exercise's function, as choices of the page."""
    questions = [checkpoint.question for checkpoint in exercise.checkpoints]
    asked = next((question for question in questions if question["kind"] == "picture"), questions[0])
    if asked["subject"] == "whitted":
        return {"walk": "bvh_ordered", "triangle": "watertight", "view": "shaded",
                "scene": "cornell_box" if asked["scene"] == "cornell_box" else "mirrors"}
    if exercise.file == "shaders/light/highlight.glsl":
        return {"walk": "bvh_ordered", "triangle": "watertight", "view": "effects", "scene": "mirrors"}
    walk = asked.get("structure", "every_triangle")
    return {"walk": walk, "triangle": asked.get("triangle", "watertight"), "view": "normals",
            "scene": "tetrahedron:2" if walk == "every_triangle" else "mirrors"}


def pack_chapter(root, engine, chapter, exercises):
    """The bytes of a chapter: the length of the JSON head, the head, and the arrays that it names."""
    blob = _Blob()
    files, numbers = _shaders(root, chapter, exercises)
    head = {"files": files, "numbers": numbers, "exercises": [
        {"number": exercise.number, "title": exercise.title, "file": exercise.file, "chapter": chapter, "task": exercise.task,
         "formulas": [plain(formula) for formula in exercise.formulas], "hints": exercise.hints, "source": exercise.source,
         "picture": _picture(exercise), "checkpoints": _resolve(engine, exercise, blob)} for exercise in exercises]}
    text = json.dumps(head, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<I", len(text)) + text + blob.bytes


def _unsolved(text, name):
    """A file of an exercise as it is, but for the solution."""
    return marks.with_code(text, name, {number: [f"//# stub: {line}" for line in region.stub]
                                        for number, region in marks.regions(text, name).items()})


def list_script(root, exercises):
    """Number, title, file, chapter of each, and where its file lies when it is compiled; the files that are not in shaders/; and the
    mistakes of which a hunt has one, so that nobody reads them unawares."""
    lines = ",\n".join(json.dumps([e.number, e.title, e.file, e.chapter, e.place.removeprefix("shaders/")]) for e in exercises)
    files = {e.file: _unsolved((root / e.file).read_text(), e.file) for e in exercises if not e.file.startswith("shaders/")}
    texts = ",\n".join(f"{json.dumps(file)}: {json.dumps(text)}" for file, text in files.items())
    plants = {e.number: [[plant["find"], plant["replace"]] for plant in e.plants] for e in exercises if e.plants}
    packed = base64.b64encode(json.dumps(plants).encode()).decode()
    return ("// Made by `python3 -B scripts/playground data`: do not edit.\n"
            f"Raysteps.play.addExercises([\n{lines}\n], {{\n{texts}\n}}, \"{packed}\");\n")


def pack_chapters(root, build):
    """Pairs of a chapter and its bytes."""
    exercises = shader_exercises(root)
    with engines.with_companions(engines.Engine(build=build)) as engine:
        for chapter in sorted({exercise.chapter for exercise in exercises}):
            yield chapter, pack_chapter(root, engine, chapter, [e for e in exercises if e.chapter == chapter])
