"""The answers of the project's own sources, which are kept."""

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


def program(engine, exercise):
    return engine.builders_program() if exercise.file.endswith(".cpp") else engine.shaders_program()


if __name__ == "__main__":
    unittest.main()
