"""The programs that check, and the answers of the project's own sources, which are kept."""

import contextlib
import io
import tempfile
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from unittest import mock

from support import COURSE, ROOT  # noqa: F401 (the path of the package too)

from course import engine as engines
from course import exercises, sandbox

BUILD = Path(COURSE[COURSE.index("--build") + 1]) if "--build" in COURSE else engines.BUILD
ASKED_AT_ONCE = 6


class Reference(unittest.TestCase):
    def test_many_may_ask_the_same_for_the_first_time(self):
        # Without a limit of memory: sanitizers reserve terabytes of addresses.
        engine = engines.Engine(build=BUILD, limits=sandbox.Limits(memory_bytes=0))
        exercise = exercises.select_one(exercises.load(), "6.1")
        questions = [checkpoint.question for checkpoint in exercise.checkpoints]
        all_have_an_answer = threading.Barrier(ASKED_AT_ONCE)
        ask = engines.ask

        def ask_and_wait(*arguments):
            answers = ask(*arguments)
            all_have_an_answer.wait(timeout=60)
            return answers

        with tempfile.TemporaryDirectory(prefix="raysteps_test_store_") as name, \
                mock.patch.object(engines, "STORE", Path(name)), \
                mock.patch.object(engines, "ask", ask_and_wait), \
                ThreadPoolExecutor(ASKED_AT_ONCE) as pool:
            found = list(pool.map(
                lambda _: engines.ask_reference(engine, program(engine, exercise),
                                                exercise.chapter, questions),
                range(ASKED_AT_ONCE)))
            kept = list((Path(name) / "reference").iterdir())
        self.assertEqual(len(kept), 1)
        self.assertTrue(all(answers == found[0] for answers in found))


class Build(unittest.TestCase):
    def test_only_what_the_exercises_need_is_built(self):
        engine, every = engines.Engine(build=BUILD), exercises.load()
        for numbers, names in ((["2.1"], ["course_shaders"]), (["6.5"], ["course_builders"]),
                               (["2.1", "6.5"], ["course_shaders", "course_builders"])):
            chosen = [exercises.select_one(every, number) for number in numbers]
            self.assertEqual([program.name for program in engine.programs_for(chosen)], names)

    def test_its_progress_is_said_and_its_output_kept(self):
        log, said = io.StringIO(), io.StringIO()
        with contextlib.redirect_stderr(said):
            code = engines._run_with_progress(["/bin/sh", "-c", "echo '[1/2] a'; echo '[2/2] b'; exit 3"], log)
        self.assertEqual((code, log.getvalue()), (3, "[1/2] a\n[2/2] b\n"))
        self.assertEqual(said.getvalue(), "course: 2 of 2 parts are built\n")


class Damaged(unittest.TestCase):
    def test_kept_answers_that_were_damaged_are_made_again(self):
        engine = engines.Engine(build=BUILD, limits=sandbox.Limits(memory_bytes=0))
        exercise = exercises.select_one(exercises.load(), "6.5")
        asked = (engine, engine.builders_program(), exercise.chapter,
                 [checkpoint.question for checkpoint in exercise.checkpoints])
        with tempfile.TemporaryDirectory(prefix="raysteps_test_store_") as name, \
                mock.patch.object(engines, "STORE", Path(name)):
            right = engines.ask_reference(*asked)
            for text in ("", "{}", "{\"answers\": []}"):
                kept, = (Path(name) / "reference").iterdir()
                kept.write_text(text)
                self.assertEqual(engines.ask_reference(*asked), right)


def program(engine, exercise):
    return engine.builders_program() if exercise.file.endswith(".cpp") else engine.shaders_program()


if __name__ == "__main__":
    unittest.main()
