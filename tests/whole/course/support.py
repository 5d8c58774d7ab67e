"""What the tests of the coursework share."""

import functools
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "scripts"))

# As CTest gives it: the program with its first options, parted by semicolons. Python itself is run, not a
# script that looks for it, which may take longer than a command.
COURSE = [sys.executable, *os.environ.get("RAYSTEPS_COURSE", f"python3;{ROOT}/course").split(";")[1:]]
BUILD = Path(COURSE[COURSE.index("--build") + 1]) if "--build" in COURSE else ROOT / "build" / "default"


def _why_forbidden():
    """Why bubblewrap cannot run on this machine; empty where it can."""
    from course import bubblewrap, errors

    try:
        bubblewrap.require()
    except errors.MachineError as error:
        return str(error)
    return ""


FORBIDDEN = _why_forbidden()
HOW = ("--without-sandbox",) if FORBIDDEN else ()  # for `grade`, where the sandbox is not what is tested


@functools.lru_cache(maxsize=None)
def _all_exercises():
    from course import exercises

    return exercises.load()


def exercise_of(number):
    from course import exercises

    return exercises.select_one(_all_exercises(), number)


def solution_of(number):
    return "\n".join(exercise_of(number).region.code)


@functools.lru_cache(maxsize=None)
def _new_workbook(*options):
    """What `./course start` makes, once for all tests of a program; and what has to live as long."""
    folder = tempfile.TemporaryDirectory(prefix="raysteps_test_workbook_")
    subprocess.run([*COURSE, "--workbook", f"{folder.name}/workbook", "start", *map(str, options)],
                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True)
    return Path(folder.name) / "workbook", folder


class CourseTest(unittest.TestCase):
    """A test with a folder of its own, in which `workbook` is the workbook."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="raysteps_test_course_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.workbook = self.folder / "workbook"

    def start(self, *options):
        """A workbook of its own, as it is made."""
        shutil.copytree(_new_workbook(*options)[0], self.workbook)

    limits = ()  # options of ./course

    def course(self, *arguments, expect=0):
        """Runs ./course and returns what it printed; its exit code must be `expect`."""
        done = subprocess.run([*COURSE, *self.limits, "--workbook", self.workbook,
                               *map(str, arguments)],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, expect, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def solve(self, number, code=None):
        """Writes lines into the workbook's place of an exercise; the solution where none are given."""
        from course import marks

        exercise = exercise_of(number)
        path = self.workbook / exercise.file
        code = (solution_of(number) if code is None else code).split("\n")
        path.write_text(marks.with_code(path.read_text(), path, {number: code}))
        return path
