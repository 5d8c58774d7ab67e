"""Asks the programs course_shaders and course_builders."""

import fcntl
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from . import sandbox
from .errors import CourseError, MachineError
from .exercises import ROOT

BUILD = ROOT / "build" / "default"
STORE = ROOT / "build" / "course"  # answers of the reference, and pictures


@dataclass
class Failure:
    """No answer: `kind` is compile, crash, time or machine."""

    kind: str
    message: str


@dataclass
class Answer:
    rays: list
    steps: list


@dataclass
class Engine:
    """The programs, and the limits that a person's code runs under."""

    build: Path = BUILD
    limits: sandbox.Limits = field(default_factory=sandbox.Limits)
    build_limits: sandbox.Limits = field(
        default_factory=lambda: sandbox.Limits(seconds=600, cpu_seconds=1200, processes=4096))

    def shaders_program(self):
        return self.build / "scripts" / "course" / "answers" / "course_shaders"

    def builders_program(self):
        return self.build / "scripts" / "course" / "answers" / "course_builders"


def _is_older(program, folders):
    if not program.exists():
        return True
    made = program.stat().st_mtime
    return any(path.stat().st_mtime > made for folder in folders
               for path in (ROOT / folder).rglob("*") if path.suffix in (".cpp", ".h", ".inc"))


def ensure_programs(engine):
    """Builds what is missing or out of date, by CMake as everything else is."""
    programs = [engine.shaders_program(), engine.builders_program()]
    if not any(_is_older(program, ["common", "scripts/course/answers"]) for program in programs):
        return
    print("course: building the programs that check, which takes minutes the first time (see "
          "build/course/build.log)", file=sys.stderr)
    STORE.mkdir(parents=True, exist_ok=True)
    tests = [] if (BUILD / "CMakeCache.txt").exists() else ["-DRAYSTEPS_TESTS=OFF"]
    with locked(STORE / "build.lock"), open(STORE / "build.log", "w") as log:
        for command in (["cmake", "--preset", "default", *tests],
                        ["cmake", "--build", "--preset", "default", "--target", "course_shaders",
                         "course_builders"]):
            try:
                done = subprocess.run(command, cwd=ROOT, stdout=log, stderr=log, check=False)
            except FileNotFoundError as error:
                raise MachineError("cmake is missing. Run ./run.sh once: it installs what lacks.") \
                    from error
            if done.returncode != 0:
                raise MachineError(f"`{' '.join(command)}` failed. Read build/course/build.log.")
    for program in programs:  # where nothing had to be linked, the time says so too
        program.touch()


@contextmanager
def locked(path):
    """One process at a time on this machine."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _environment(chapter, overlay, scratch):
    folders = [overlay] if overlay else []
    folders += [ROOT / "chapters" / chapter / "exercises", ROOT / "scripts" / "course" / "answers" / "shaders"]
    kept = {key: os.environ[key] for key in ("PATH", "LANG", "LD_LIBRARY_PATH") if key in os.environ}
    return {**kept, "HOME": str(scratch), "TMPDIR": str(scratch), "MESA_SHADER_CACHE_DISABLE": "true",
            "RAYSTEPS_SHADERS": ":".join(str(folder) for folder in folders)}


def _failure(outcome, limits):
    if outcome.timed_out:
        return Failure("time", f"was stopped after {outcome.seconds:.0f} s (it may take "
                               f"{limits.seconds:.0f} s, and {limits.cpu_seconds} s of processors): "
                               "does a loop never end?")
    if outcome.code < 0 or outcome.code >= 128:
        return Failure("crash", f"crashed (signal {abs(outcome.code) % 128}).")
    message = outcome.errors.strip() or f"ended with exit code {outcome.code}."
    is_shader = "does not compile" in message or "do not link" in message
    return Failure("compile" if is_shader else "machine", message)


def _read_answers(path, count):
    """What the program wrote; it ran a person's code, so nothing is taken for granted."""
    try:
        found = json.loads(path.read_text())["answers"]
        answers = [Answer(answer["rays"], answer["steps"]) for answer in found]
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return Failure("crash", "ended without an answer.")
    if len(answers) != count:
        return Failure("crash", "answered other questions than those it was asked.")
    return answers


def ask(engine, program, chapter, questions, overlay=None):
    """A list of Answer, one a question, or a Failure."""
    with tempfile.TemporaryDirectory(prefix="raysteps_course_") as name:
        scratch = Path(name)
        (scratch / "job.json").write_text(json.dumps({"questions": questions}))
        outcome = sandbox.run([program, scratch / "job.json", scratch / "answers.json"],
                              engine.limits, _environment(chapter, overlay, scratch), scratch)
        if outcome.code != 0 or outcome.timed_out:
            return _failure(outcome, engine.limits)
        return _read_answers(scratch / "answers.json", len(questions))


def _state_of_sources(program):
    """Changes where the program or any shader of the project does."""
    digest = hashlib.sha256(f"{program.stat().st_mtime_ns}".encode())
    for folder in ("shaders", "common/course_shaders/shaders", "chapters"):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".glsl", ".frag", ".vert"):
                digest.update(str(path).encode() + path.read_bytes())
    return digest.hexdigest()


def ask_reference(engine, program, chapter, questions):
    """The answers of the project's own sources, kept until those change."""
    key = json.dumps(questions, sort_keys=True) + chapter + _state_of_sources(program)
    kept = STORE / "reference" / (hashlib.sha256(key.encode()).hexdigest() + ".json")
    if not kept.exists():
        answers = ask(engine, program, chapter, questions)
        if isinstance(answers, Failure):
            raise MachineError(f"the project's own sources give no answer: {answers.message}")
        kept.parent.mkdir(parents=True, exist_ok=True)
        # Two threads may ask the same for the first time: each writes a file of its own.
        with tempfile.NamedTemporaryFile("w", dir=kept.parent, delete=False) as partial:
            json.dump({"answers": [vars(answer) for answer in answers]}, partial)
        Path(partial.name).rename(kept)
    answers = _read_answers(kept, len(questions))
    if isinstance(answers, Failure):
        kept.unlink()
        raise MachineError(f"{kept}: the file was damaged, and is removed. Run this again.")
    return answers


def reference_picture(engine, chapter, question):
    """The picture by the project's own sources, kept until those change: its path without ending."""
    key = json.dumps(question, sort_keys=True) + chapter + _state_of_sources(engine.shaders_program())
    kept = STORE / "reference" / hashlib.sha256(key.encode()).hexdigest()
    if not kept.with_suffix(".pfm").exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="raysteps_picture_", dir=STORE) as name:
            made = ask(engine, engine.shaders_program(), chapter,
                       [{**question, "picture": f"{name}/picture"}])
            if isinstance(made, Failure):
                raise MachineError(f"the project's own sources give no picture: {made.message}")
            for ending in (".png", ".pfm"):  # the last one says that all is there
                Path(f"{name}/picture{ending}").rename(kept.with_suffix(ending))
    return kept


def build_with(engine, overlay):
    """course_builders with the sources of the overlay, by CMake in a build folder of its own.

    Hold the lock of STORE / "workbook.lock" until it has been run. Returns its path or a Failure.
    """
    folder = STORE / "workbook"
    sources = STORE / "workbook_sources"
    sources.mkdir(parents=True, exist_ok=True)
    wanted = {path.relative_to(overlay) for path in overlay.rglob("*.cpp")}
    for path in sources.rglob("*.cpp"):
        if path.relative_to(sources) not in wanted:
            path.unlink()
    for path in wanted:  # what has not changed is not compiled again
        (sources / path).parent.mkdir(parents=True, exist_ok=True)
        if not (sources / path).exists() or (sources / path).read_bytes() != (overlay / path).read_bytes():
            shutil.copyfile(overlay / path, sources / path)
    if not (folder / "CMakeCache.txt").exists():
        print("course: building the project's C++ with yours, which takes minutes the first time",
              file=sys.stderr)
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    for command in (["cmake", "-S", ROOT, "-B", folder, *generator, "-DCMAKE_BUILD_TYPE=Release",
                     "-DRAYSTEPS_TESTS=OFF", "-DRAYSTEPS_WINDOW=OFF", f"-DRAYSTEPS_WORKBOOK={sources}"],
                    ["cmake", "--build", folder, "--target", "course_builders"]):
        outcome = sandbox.run(command, engine.build_limits)
        if outcome.timed_out:
            return Failure("time", "took too long to compile.")
        if outcome.code != 0:
            return Failure("compile", _compiler_messages(outcome.output + outcome.errors))
    return folder / "scripts" / "course" / "answers" / "course_builders"


def _compiler_messages(text):
    """The errors, and not the commands that led to them."""
    lines = [line for line in text.splitlines()
             if re.search(r"(error|undefined reference|CMake Error)", line)]
    return "\n".join(lines[:12]) or text[-2000:]
