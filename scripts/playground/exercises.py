"""The shader exercises as the page of the playground checks them: a script for each chapter, and one that lists all.

The C++ program course_shaders resolves each question: the rays as bits, what the project's own sources find for them, and
the scene with the very structure that it walked. Solutions and mistakes are left out; the stubs stand in shaders/ itself."""

import json
import re
import struct
import tempfile
from pathlib import Path

from course import engine as engines
from course.errors import MachineError
from course.exercises import bits, load
from course.formulas import plain

SHADERS = "scripts/course/answers/shaders"
SMALLEST = "tetrahedron:0"
INITIAL = re.compile(r"^uniform int (\w+) = (\d+);", re.MULTILINE)
ASKED = ("kind", "subject", "triangle", "structure", "steps", "width", "height", "points", "counts", "zeros")


def shader_exercises(root):
    """Those whose lines stand in a shader of the project, with a stub in their place."""
    return [exercise for exercise in load(root) if exercise.file.startswith("shaders/") and exercise.region.stub]


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
    if question["kind"] == "rays":  # the camera is all that they need
        length = struct.unpack("<I", packed[:4])[0]
        made |= {"scene_name": question["scene"], "view": json.loads(packed[4:4 + length])["view"]}
    else:
        made["scene"] = blob.add(packed)
    return made | {"words": len(answer.steps[0][0]), "count": len(answer.steps[0]), "rays": blob.add(_words(answer.rays)),
                   "answers": [blob.add(_words(step)) for step in answer.steps]}


def _resolve(engine, chapter, exercises, blob):
    """What the program answers, for all checkpoints but pictures."""
    with tempfile.TemporaryDirectory(prefix="raysteps_playground_") as folder:
        asked = [(exercise, checkpoint, Path(folder) / f"{exercise.number}_{place}") for exercise in exercises
                 for place, checkpoint in enumerate(exercise.checkpoints) if checkpoint.question["kind"] != "picture"]
        questions, packing = [], []
        for _, checkpoint, file in asked:
            question = dict(checkpoint.question)
            if question["kind"] == "checkpoint" and "scene" in question:
                question["packed"] = str(file)
            else:
                packing.append(_packing(question, file))
            questions.append(question)
        answers = engines.ask(engine, engine.shaders_program(), chapter, questions + packing)
        if isinstance(answers, engines.Failure):
            raise MachineError(f"the project's own sources give no answer: {answers.message}")
        made = {exercise.number: [] for exercise in exercises}
        for (exercise, checkpoint, file), answer in zip(asked, answers):
            made[exercise.number].append(_checkpoint(checkpoint, answer, file.read_bytes(), blob))
        return made


def _shaders(root, chapter):
    """What checkpoints are made of. WebGL has no initial values of uniforms: they are numbers beside the text."""
    files, numbers = {}, {}
    for folder in (SHADERS, f"chapters/{chapter}/exercises"):
        for path in sorted((root / folder).iterdir()):
            if path.suffix in (".glsl", ".frag"):
                text = path.read_text(encoding="utf-8")
                numbers |= {name: int(value) for name, value in INITIAL.findall(text)}
                files[path.name] = INITIAL.sub(r"uniform int \1;", text)
    return files, numbers


def _picture(exercise):
    """A picture that goes through the exercise's function, as choices of the page."""
    questions = [checkpoint.question for checkpoint in exercise.checkpoints]
    asked = next((question for question in questions if question["kind"] == "picture"), questions[0])
    walk = asked.get("structure", "every_triangle")
    return {"walk": walk, "triangle": asked.get("triangle", "watertight"), "view": "normals",
            "scene": "tetrahedron:2" if walk == "every_triangle" else "mirrors"}


def pack_chapter(root, engine, chapter, exercises):
    """The bytes of a chapter: the length of the JSON head, the head, and the arrays that it names."""
    blob = _Blob()
    resolved = _resolve(engine, chapter, exercises, blob)
    files, numbers = _shaders(root, chapter)
    head = {"files": files, "numbers": numbers, "exercises": [
        {"number": exercise.number, "title": exercise.title, "file": exercise.file, "chapter": chapter, "task": exercise.task,
         "formulas": [plain(formula) for formula in exercise.formulas], "hints": exercise.hints, "source": exercise.source,
         "picture": _picture(exercise), "checkpoints": resolved[exercise.number]} for exercise in exercises]}
    text = json.dumps(head, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<I", len(text)) + text + blob.bytes


def list_script(exercises):
    """Number, title, file and chapter of each."""
    lines = ",\n".join(json.dumps([e.number, e.title, e.file, e.chapter]) for e in exercises)
    return f"// Made by `python3 -B scripts/playground data`: do not edit.\nRaysteps.play.addExercises([\n{lines}\n]);\n"


def pack_chapters(root, build):
    """Pairs of a chapter and its bytes."""
    exercises = shader_exercises(root)
    with engines.with_companions(engines.Engine(build=build)) as engine:
        for chapter in sorted({exercise.chapter for exercise in exercises}):
            yield chapter, pack_chapter(root, engine, chapter, [e for e in exercises if e.chapter == chapter])
