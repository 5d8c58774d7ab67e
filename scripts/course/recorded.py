"""A student's walk as the shader makes it, round by round: a file of recorded steps, as
visualizer/walk.schema.json says."""

import json
import math

from . import engine as engines
from .errors import CourseError
from .exercises import from_bits
from .own import overlay, read_own

VISIT = 1  # what a shader observes: scripts/course/answers/shaders/record.glsl
SIGN = 1 << 31


def _number(bits):
    """JSON has neither NaN nor infinity."""
    value = from_bits(bits)
    if math.isfinite(value):
        return value
    return "nan" if math.isnan(value) else "infinity" if value > 0 else "-infinity"


def _signed(bits):
    return bits - 2 * SIGN if bits >= SIGN else bits


def _hit(texel):
    triangle = _signed(texel[3])
    if triangle < 0:
        return None
    return {**{name: _number(bits) for name, bits in zip("tuv", texel)}, "triangle": triangle}


def _steps(events, hits):
    """A place that the walk visits with the tests made there; without visits, each test is a step."""
    steps, visits = [], False
    for event, hit in zip(events, hits):
        kind, number, round_ = event[:3]
        if not kind:
            break
        number = _signed(number)
        visits = visits or kind == VISIT
        if kind == VISIT or not visits:
            steps.append({"place": number, "round": round_, "tested": []})
        if kind != VISIT:
            steps[-1]["tested"].append(number)
        steps[-1]["nearest"] = _hit(hit)
    return steps


def _question(checkpoint, ray):
    """The walk of that ray in the checkpoint's scene, or in that of a picture."""
    asked = {key: value for key, value in checkpoint.question.items()
             if key in ("scene", "triangle", "structure", "options", "points", "counts", "zeros")}
    return {**asked, "kind": "walk", "subject": "nearest", "rays": [ray]}


def _walk(answer, question, scene):
    events, hits, _ = answer.steps
    ray = question["rays"][0]
    structure = question.get("structure", "every_triangle")
    structure += "".join(f":{name}={value}" for name, value in question.get("options", {}).items())
    return {"schema": "walk.schema.json", "schema_version": 1, "name": "yours", "scene": scene,
            "structure": structure,
            "ray": {"origin": [_number(word) for word in ray[0:3]],
                    "direction": [_number(word) for word in ray[3:6]],
                    "t_min": _number(ray[6]), "t_max": _number(ray[7])},
            "question": "nearest", "steps": _steps(events, hits), "ended": bool(events[-1][3]),
            "hit": _hit(hits[-1])}


def student_walk(engine, exercise, checkpoint, ray, folder, scene):
    """What the person's lines do with the ray; None where that is what the project's own lines do, or
    where there is no walk to be recorded."""
    question = _question(checkpoint, ray)
    if not exercise.is_shader or question.get("structure", "").startswith("packet_"):
        return None
    try:
        own = read_own(exercise, folder)
    except (CourseError, OSError):
        return None
    program = engine.shaders_program()
    with overlay(exercise, own) as place:
        answers = engines.ask(engine, program, exercise.chapter, [question], place / "shaders")
    if isinstance(answers, engines.Failure) or len(answers[0].steps) != 3:
        return None
    walk = _walk(answers[0], question, scene)
    reference = engines.ask_reference(engine, program, exercise.chapter, [question])
    return None if walk == _walk(reference[0], question, scene) else walk


def write(walk, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(walk) + "\n")
    return path
