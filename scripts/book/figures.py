"""Runs the programs that make the book's pictures, printed outputs and walks (figures.toml)."""

import json
import shlex
import shutil
import subprocess
import tempfile
import tomllib
from pathlib import Path

from .contents import page_names
from .directives import directives_in, output_file, program_and_arguments
from .errors import BookError

TABLE = "docs/book/figures.toml"
SECONDS = 1800  # that one program may take


def program_path(build, name):
    folder = "" if name == "visualizer" else "chapters/"
    return build / folder / name / name


def _newest(root):
    return max(path.stat().st_mtime for path in (root / "shaders").rglob("*") if path.is_file())


def _run(build, root, command, more=()):
    """What the program prints."""
    name, arguments = program_and_arguments(command)
    program = program_path(build, name)
    if not program.exists():
        raise BookError(f"{program}: is not there. Build the target book_figures.")
    words = [str(program), *shlex.split(arguments), *map(str, more)]
    try:
        done = subprocess.run(words, cwd=root, capture_output=True, text=True, timeout=SECONDS,
                              stdin=subprocess.DEVNULL, check=False)
    except subprocess.TimeoutExpired as error:
        raise BookError(f"`{command}` took more than {SECONDS} seconds. Take less of it.") from error
    if done.returncode != 0:
        raise BookError(f"`{command}` ended with exit code {done.returncode}: "
                        f"{done.stderr.strip()[-500:]}")
    return done.stdout


def _picture(build, root, made, entry):
    with tempfile.TemporaryDirectory() as folder:
        where = ([entry["option"], f"{folder}/{entry['made']}"] if "option" in entry
                 else ["--out", folder])
        _run(build, root, entry["command"], where)
        if not (Path(folder) / entry["made"]).is_file():
            raise BookError(f"{TABLE}: `{entry['command']}` makes no {entry['made']}. Name what it "
                            "makes.")
        to = made / entry["file"]
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(Path(folder) / entry["made"], to)


def _walk(build, root, made, entry):
    to = made / "walks" / f"{entry['name']}.json"
    to.parent.mkdir(parents=True, exist_ok=True)
    _run(build, root, entry["command"], ["--export", to, "--screenshot", to.with_suffix(".png")])
    about = {"command": entry["command"], "caption": entry["caption"]}
    (to.parent / f"{entry['name']}.about.json").write_text(json.dumps(about))


def without_folders(text, root):
    """What is printed must not depend on where the project lies."""
    return text.replace(f"{root}/", "")


def _output(build, root, made, command):
    with tempfile.TemporaryDirectory() as folder:
        more = [] if command.startswith("hard_cases") else ["--out", folder]
        printed = _run(build, root, command, more)
        printed = "\n".join(line for line in printed.split("\n") if folder not in line)
    to = output_file(made, command)
    to.parent.mkdir(parents=True, exist_ok=True)
    to.write_text(without_folders(printed, root))


def _tasks(root, made, with_slow):
    """Each with its name, the file that it makes, its command, and the function that makes it."""
    table = tomllib.loads((root / TABLE).read_text())
    for entry in table.get("picture", []):
        if entry.get("slow") and not with_slow:
            continue
        yield entry["file"], made / entry["file"], entry["command"], _picture, entry
    for entry in table.get("walk", []):
        yield (f"walk {entry['name']}", made / "walks" / f"{entry['name']}.about.json",
               entry["command"], _walk, entry)
    for path in page_names(root):
        for kind, words in directives_in((root / path).read_text()):
            if kind == "output":
                yield f"output of {words}", output_file(made, words), words, _output, words


def _commands(made):
    """By which command each figure was made."""
    file = made / "commands.json"
    return json.loads(file.read_text()) if file.exists() else {}


def make_figures(root, build, made, say, with_slow=False):
    """Makes what is older than its program or the shaders, and what another command made."""
    changed = _newest(root)
    known = _commands(made)
    for name, file, command, make, entry in _tasks(root, made, with_slow):
        program = program_path(build, program_and_arguments(command)[0])
        newest = max(changed, program.stat().st_mtime if program.exists() else 0)
        if file.exists() and file.stat().st_mtime > newest and known.get(name) == command:
            continue
        say(f"book: {name}")
        make(build, root, made, entry)
        known[name] = command
        (made / "commands.json").write_text(json.dumps(known, indent=1))
