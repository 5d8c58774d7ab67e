"""Asks the programs course_shaders and course_builders."""

import fcntl
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

from . import bubblewrap, sandbox, together
from .errors import CourseError, MachineError
from .exercises import ROOT
from .failure import Failure, of_refusal, of_run

BUILD = ROOT / "build" / "default"
STORE = ROOT / "build" / "course"  # answers of the reference, and pictures
MOST_OF_BUILDERS = 768 << 20  # bytes of memory

SECONDS_BETWEEN_LINES = 5  # of progress, where it goes to a file
CLOCK_IN_CPP = 20  # seconds: what a right answer in C++ takes is far below
MOST_BYTES_OF_ANSWERS = 8 << 20

# Runs a program on a job. Its answers come out as the last words: in a sandbox no file outlasts it.
RUN = '"$0" "$1" "$TMPDIR/answers.json" >&2 && cat "$TMPDIR/answers.json"'


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
        default_factory=lambda: sandbox.Limits(seconds=300, cpu_seconds=120, processes=4096))
    is_enclosed: bool = False  # what was handed in is compiled and runs in the sandbox of bubblewrap
    companions: "Companions" = None  # see there; what was handed in never has any
    states: dict = field(default_factory=dict)  # of the sources, by program: see _state_of_sources

    def shaders_program(self):
        return self.build / "scripts" / "course" / "answers" / "course_shaders"

    def builders_program(self):
        return self.build / "scripts" / "course" / "answers" / "course_builders"

    def programs_for(self, exercises):
        """Those that check the exercises."""
        needed = [self.shaders_program()] if any(one.is_shader for one in exercises) else []
        return needed + ([self.builders_program()] if not all(one.is_shader for one in exercises) else [])


def _is_older(program, folders):
    if not program.exists():
        return True
    made = program.stat().st_mtime
    return any(path.stat().st_mtime > made for folder in folders
               for path in (ROOT / folder).rglob("*") if path.suffix in (".cpp", ".h", ".inc"))


def ensure_programs(engine, programs):
    """Builds those that are missing or out of date, by CMake as everything else is."""
    old = [program for program in programs if _is_older(program, ["common", "scripts/course/answers"])]
    if not old:
        return
    print("course: building what checks, which takes a minute or more the first time (see "
          "build/course/build.log)", file=sys.stderr)
    STORE.mkdir(parents=True, exist_ok=True)
    first = [] if (BUILD / "CMakeCache.txt").exists() else ["-DRAYSTEPS_TESTS=OFF", "-DRAYSTEPS_PRECOMPILED=ON"]
    targets = [program.name for program in old]
    with locked(STORE / "build.lock"), open(STORE / "build.log", "w") as log:
        for command in (["cmake", "--preset", "default", *first],
                        ["cmake", "--build", "--preset", "default", "--target", *targets]):
            if _run_with_progress(command, log) != 0:
                raise MachineError(f"`{' '.join(command)}` failed. Read build/course/build.log.")
    for program in old:  # where nothing had to be linked, the time says so too
        program.touch()


def _run_with_progress(command, log):
    """The exit code. Ninja's `[3/97]` becomes a line that is written again and again on a terminal, and now
    and then elsewhere."""
    is_terminal, last = sys.stderr.isatty(), time.monotonic()
    try:
        process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True, errors="replace")
    except FileNotFoundError as error:
        raise MachineError("cmake is missing. Run ./run.sh once: it installs what lacks.") from error
    with process:
        for line in process.stdout:
            log.write(line)
            done = re.match(r"\[(\d+)/(\d+)\]", line)
            if done and (is_terminal or time.monotonic() > last + SECONDS_BETWEEN_LINES or done[1] == done[2]):
                last = time.monotonic()
                print(f"{chr(13) if is_terminal else ''}course: {done[1]} of {done[2]} parts are built",
                      end="" if is_terminal and done[1] != done[2] else "\n", file=sys.stderr, flush=True)
    return process.returncode


@contextmanager
def locked(path):
    """One process at a time on this machine."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _shaders(chapter, overlay):
    """The folders that shaders are read from before the project's own."""
    folders = [overlay] if overlay else []
    folders += [ROOT / "chapters" / chapter / "exercises", ROOT / "scripts" / "course" / "answers" / "shaders"]
    return ":".join(str(folder) for folder in folders)


def _environment(scratch="/tmp"):
    """Shaders are asked about few rays, so the software renderer translates them faster than it would make
    them fast."""
    kept = {key: os.environ[key] for key in ("PATH", "LANG", "LD_LIBRARY_PATH") if key in os.environ}
    return {**kept, "HOME": str(scratch), "TMPDIR": str(scratch), "GALLIVM_PERF": "nopt"}


class Companions:
    """Programs that stay and answer job after job, one for each thread that asks, with one OpenGL
    context each. Compiled shaders are kept for all of them, and for the next time."""

    def __init__(self, engine):
        self._folder = tempfile.TemporaryDirectory(prefix="raysteps_course_")
        self._engine, self._mine, self._all = engine, threading.local(), []
        self.references = {}  # what the project's own sources answer, by question
        self.programs = {}  # of C++ that was compiled ahead, by its text: the program, and its library's folder

    def ask(self, job):
        if not hasattr(self._mine, "program"):
            environment = {**_environment(self._folder.name),
                           "MESA_SHADER_CACHE_DIR": str(STORE / "compiled_shaders")}
            self._mine.program = sandbox.Companion([self._engine.shaders_program()],
                                                   self._engine.limits, environment,
                                                   self._folder.name)
            self._all.append(self._mine.program)
        return self._mine.program.ask(json.dumps(job))

    def compile(self, file, texts):
        """Compiles versions of one C++ source ahead, in one go."""
        build = self._engine.build
        compile_, link, archive, made = _build_steps(self._engine, file)
        folder = Path(self._folder.name) / "versions" / file

        def command(source, object_file):
            return ["env", "-C", build, *_with([*_for_own(compile_), "-fPIC"], o=object_file, c=source)]

        kept = [word for word in link if word.startswith("-fsanitize")]
        # A library's own functions come first: those of the standard library with their assertions too. What
        # it wants of others the program has: to look for that once more for each takes the linker most of its time.
        library = [link[0], "-shared", "-nostdlib", "-Wl,--defsym,__dso_handle=0", f"-Wl,-Bsymbolic,-soname,{together.NAME}", *kept]
        libraries = together.compile_together(command, library, texts, build / made, folder)
        programs, others = {}, _without_own(build / archive, made, folder)
        for text, own in libraries.items():
            unit = own.parents[1]
            if unit not in programs:
                programs[unit] = unit / "course_builders"
                words = [*_linked_with(link, archive, own, others, programs[unit]), "-Wl,--export-dynamic"]
                subprocess.run(words, cwd=build, check=True)
            self.programs[text] = (programs[unit], own.parent)

    def close(self):
        for program in self._all:
            program.close()
        self._folder.cleanup()


@contextmanager
def with_companions(engine):
    """The engine for trials of the project's own code: they share programs that stay."""
    companions = Companions(engine)
    try:
        yield replace(engine, companions=companions)
    finally:
        companions.close()


def _read_answers(path, count):
    try:
        return _answers_in(path.read_text(), count)
    except (OSError, ValueError):
        return _answers_in("", count)


def _answers_in(text, count):
    """What the program wrote; it ran a person's code, so nothing is taken for granted."""
    try:
        found = json.loads(text)["answers"]
        answers = [Answer(answer["rays"], answer["steps"]) for answer in found]
    except (ValueError, KeyError, TypeError, RecursionError):
        return Failure("crash", "ended without an answer.")
    if len(answers) != count:
        return Failure("crash", "answered other questions than those it was asked.")
    return answers


def ask(engine, program, chapter, questions, overlay=None):
    """A list of Answer, one a question, or a Failure. The overlay holds what a person wrote: shaders that
    come before the project's, or the program itself."""
    if engine.companions and program == engine.shaders_program():
        return _ask_companion(engine, chapter, questions, overlay)
    is_cpp = program != engine.shaders_program()
    limits = engine.limits if overlay else replace(engine.limits, cpu_seconds=0)
    if is_cpp:
        limits = replace(limits, seconds=min(limits.seconds, CLOCK_IN_CPP))
        # No renderer: what takes so much does not end.
        limits = replace(limits, memory_bytes=limits.memory_bytes and MOST_OF_BUILDERS)
    with tempfile.TemporaryDirectory(prefix="raysteps_course_") as name:
        scratch = Path(name)
        (scratch / "job.json").write_text(json.dumps({"questions": questions}))
        command = ["/bin/sh", "-c", RUN, program, scratch / "job.json"]
        environment = {**_environment(scratch), "MESA_SHADER_CACHE_DISABLE": "true",
                       "RAYSTEPS_SHADERS": _shaders(chapter, overlay)}
        if overlay and engine.is_enclosed:
            readable = [scratch, overlay] if is_cpp else [
                scratch, overlay, program, ROOT / "shaders", ROOT / "scripts/course/answers/shaders",
                ROOT / "chapters" / chapter / "exercises"]
            command, limits = _enclosed(command, limits, readable, lent=[scratch, overlay])
            environment.update(_environment())
        outcome = sandbox.run(command, limits, environment, scratch, MOST_BYTES_OF_ANSWERS)
        bubblewrap.require_start(outcome)
        if outcome.code != 0 or outcome.timed_out:
            return of_run(outcome, limits, is_cpp)
        return _answers_in(outcome.output, len(questions))


def _enclosed(command, limits, readable, lent, **others):
    """The command in the sandbox, and the limits outside of it: that of processes holds inside."""
    for folder in lent:
        bubblewrap.lend(folder)
    return (bubblewrap.around(command, limits.processes, readable, **others), replace(limits, processes=0))


def _ask_companion(engine, chapter, questions, overlay):
    outcome = engine.companions.ask({"shaders": _shaders(chapter, overlay), "questions": questions})
    if outcome.code != 0 or outcome.timed_out:
        return of_run(outcome, engine.limits)
    found = json.loads(outcome.output or "{}")
    return of_refusal(found["message"]) if "message" in found else _answers_in(outcome.output, len(questions))


def _state_of_sources(engine, program):
    """Changes where the program or any shader of the project does. To read them all takes longer than most
    answers, so it is done once in a run."""
    if program not in engine.states:
        engine.states[program] = _read_state(program)
    return engine.states[program]


def _read_state(program):
    digest = hashlib.sha256(f"{program.stat().st_mtime_ns}".encode())
    for folder in ("shaders", "scripts/course/answers/shaders", "chapters"):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".glsl", ".frag", ".vert"):
                digest.update(str(path).encode() + path.read_bytes())
    return digest.hexdigest()


def ask_reference(engine, program, chapter, questions):
    """The answers of the project's own sources, kept until those change."""
    asked = json.dumps(questions, sort_keys=True) + chapter
    known = engine.companions.references if engine.companions else {}
    if (program, asked) not in known:
        known[program, asked] = _reference(engine, program, chapter, questions, asked)
    return known[program, asked]


def _reference(engine, program, chapter, questions, asked):
    key = asked + _state_of_sources(engine, program)
    kept = STORE / "reference" / (hashlib.sha256(key.encode()).hexdigest() + ".json")
    answers = _read_answers(kept, len(questions))
    if isinstance(answers, Failure):  # is not there, or damaged
        answers = ask(engine, program, chapter, questions)
        if isinstance(answers, Failure):
            raise MachineError(f"the project's own sources give no answer: {answers.message}")
        kept.parent.mkdir(parents=True, exist_ok=True)
        # Two threads may ask the same for the first time: each writes a file of its own.
        with tempfile.NamedTemporaryFile("w", dir=kept.parent, delete=False) as partial:
            json.dump({"answers": [vars(answer) for answer in answers]}, partial)
        Path(partial.name).rename(kept)
    return answers


def reference_picture(engine, chapter, question):
    """The picture by the project's own sources, kept until those change: its path without ending."""
    key = json.dumps(question, sort_keys=True) + chapter + _state_of_sources(engine, engine.shaders_program())
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


def _build_steps(engine, file):
    """The commands that compile the file and link course_builders, as Ninja has them, and where the
    file's object goes: into an archive, which is a word of the second command."""
    cache = (engine.build / "CMakeCache.txt").read_text()
    ninja = re.search(r"^CMAKE_MAKE_PROGRAM:\w+=(.*ninja.*)$", cache, re.MULTILINE)
    if ninja is None:
        raise MachineError(f"{engine.build}: was not made for Ninja. Configure it with a preset.")
    listed = subprocess.run([ninja[1], "-C", engine.build, "-t", "commands", "course_builders"],
                            capture_output=True, text=True, check=False)
    commands = [_without_launcher(shlex.split(line), cache) for line in listed.stdout.splitlines()]
    compile_ = next((words for words in commands if str(ROOT / file) in words), None)
    if listed.returncode != 0 or compile_ is None:
        raise MachineError(f"{engine.build}: course_builders is not built from {file} there. Build it "
                           f"again. {listed.stderr}".strip())
    made = compile_[compile_.index("-o") + 1]
    archive = next(word for words in commands if made in words and words is not compile_
                   for word in words if word.endswith(".a"))
    link = commands[-1]
    return compile_, link[:link.index("&&")], archive, made


def _without_launcher(words, cache):
    """The command from its compiler on: one such as ccache wants a folder that a sandbox does not have."""
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.MULTILINE)
    return words[words.index(compiler[1]):] if compiler[1] in words else words


def _headers(engine, words):
    """What the compiler has to see: the folders of headers, but those of the build file by file, since
    there are the project's objects as well."""
    folders = {Path(word[2:]) for word in words if word.startswith("-I")}
    folders |= {Path(words[i + 1]) for i, word in enumerate(words) if word == "-isystem"}
    compiler = Path(words[0]).resolve()
    seen = [] if compiler.is_relative_to("/usr") else [compiler.parents[1]]
    for folder in sorted(folders):
        if folder.is_relative_to(engine.build):
            seen += [path for path in folder.rglob("*") if path.suffix in (".h", ".hpp", ".inc")]
        elif folder.is_dir() and not folder.is_relative_to("/usr"):
            seen.append(folder)
    return seen


def _without_own(archive, made, folder):
    """A copy of the archive without one object: a name that a person's file leaves out is missed, and not
    found there."""
    others = folder / "others.a"
    shutil.copyfile(archive, others)
    subprocess.run(["ar", "d", others, Path(made).name], check=True)
    return others


def _linked_with(link, archive, own, others, program):
    """The command that links the program with a person's object in the place of the project's, which must
    be found nowhere: an archive may stand there more than once."""
    words = [str(others) if word == archive else word for word in link]
    words.insert(link.index(archive), str(own))
    return _with(words, o=program)


def _with(words, **replaced):
    """The command with other words behind its options."""
    words = list(words)
    for option, word in replaced.items():
        words[words.index(f"-{option}") + 1] = str(word)
    return words


def _for_own(words):
    """The command for a person's text: what is read beyond a vector's end, or before it was written,
    shall not be right by luck."""
    words = list(words)
    if "-MD" in words:  # the list of headers is the project's own
        first = words.index("-MD")
        del words[first:first + 5]
    if "-Winvalid-pch" in words:  # headers that were read ahead, for other options
        first = words.index("-Winvalid-pch")
        del words[first:first + 3]
    return [*words, "-O1", "-D_GLIBCXX_ASSERTIONS", "-ftrivial-auto-var-init=pattern"]


def build_with(engine, file, overlay):
    """course_builders with this one source of the overlay: only that is compiled, and takes the
    place of its namesake among the project's objects. Returns the program's path or a Failure."""
    own, program = overlay / "own.o", overlay / "course_builders"
    ahead = engine.companions.programs.get((overlay / file).read_text()) if engine.companions else None
    if ahead:
        return _called_with(*ahead, program)
    compile_, link, archive, made = _build_steps(engine, file)
    link = _linked_with(link, archive, own, _without_own(engine.build / archive, made, overlay), program)
    for command in (_with(_for_own(compile_), o=own, c=overlay / file), link):
        limits = engine.build_limits
        if engine.is_enclosed:
            seen = [engine.build] if command is link else _headers(engine, command)
            command, limits = _enclosed(command, limits, seen, lent=[overlay], writable=[overlay],
                                        hidden=[] if command is link else [ROOT / file],
                                        folder=engine.build if command is link else overlay)
        outcome = sandbox.run(command, limits, _environment() if engine.is_enclosed else None, engine.build)
        bubblewrap.require_start(outcome)
        if outcome.timed_out:
            return Failure("time", "It took too long to compile.")
        if outcome.code != 0:
            return Failure("compile", _compiler_messages(outcome.output + outcome.errors))
    return program


def _called_with(program, folder, script):
    """A script that calls the program with the library of that folder."""
    script.write_text(f'#!/bin/sh\nLD_LIBRARY_PATH={shlex.quote(str(folder))}:$LD_LIBRARY_PATH '
                      f'exec {shlex.quote(str(program))} "$@"\n')
    script.chmod(0o755)
    return script


def _compiler_messages(text):
    """The errors, and not the commands that led to them."""
    lines = [line for line in text.splitlines()
             if re.search(r"(error|undefined reference)", line)]
    return "\n".join(lines[:12]) or text[-2000:]
