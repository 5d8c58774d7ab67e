"""Submissions that crash, never end, fill the disk, or want to read and write elsewhere."""

import os
import tarfile
import time
import unittest
import zipfile

from support import COURSE, CourseTest

from course import check, command, engine, exercises, grade, sandbox, submission

CROSS = "shaders/core/vector.glsl"
MEDIAN = "common/structure/bvh/split_median.cpp"
ENDLESS_SHADER = """    real x = a.x;
    for (int i = 0; i >= 0; i = i) {
        for (int j = 0; j >= 0; j = j) {
            for (int k = 0; k >= 0; k = k) {
                x = x * real(0.5f) + a.y;
            }
        }
    }
    real y = x;
    real z = x;"""


class Sandbox(CourseTest):
    def run_shell(self, script, **limits):
        return sandbox.run(["/bin/sh", "-c", script], sandbox.Limits(**{"seconds": 10, **limits}),
                           folder=self.folder)

    def test_what_never_ends_is_stopped(self):
        outcome = self.run_shell("while :; do :; done", seconds=1)
        self.assertTrue(outcome.timed_out)
        self.assertLess(outcome.seconds, 8)

    def test_time_of_processors_is_limited_too(self):
        outcome = self.run_shell("exec python3 -c 'while True: pass'", cpu_seconds=1)
        self.assertTrue(outcome.timed_out)

    def test_a_crash_is_a_signal(self):
        self.assertEqual(self.run_shell("kill -SEGV $$").code, -11)

    def test_endless_output_ends_at_the_limit(self):
        outcome = self.run_shell("yes", file_bytes=1 << 20)
        self.assertNotEqual(outcome.code, 0)
        self.assertLessEqual(len(outcome.output), sandbox.MOST_BYTES_SHOWN)

    def test_endless_files_end_at_the_limit(self):
        self.run_shell("yes > big", file_bytes=1 << 20)
        self.assertLessEqual((self.folder / "big").stat().st_size, 1 << 20)

    def test_memory_is_limited(self):
        outcome = self.run_shell("exec python3 -c 'b\"x\" * (3 << 30)'", memory_bytes=1 << 30)
        self.assertNotEqual(outcome.code, 0)

    def test_what_it_leaves_running_goes_too(self):
        self.run_shell("(sleep 0.5; touch late) & exit 0")
        time.sleep(1)
        self.assertFalse((self.folder / "late").exists())


class Companion(CourseTest):
    """A program that stays, as the trials of the project's own code share one."""

    ANSWERS = """while read -r line; do case $line in
    crash) kill -SEGV $$ ;; hang) exec sleep 60 ;; end) echo lost >&2; exit 3 ;; *) echo $$ $line ;;
    esac; done"""

    def setUp(self):
        super().setUp()
        self.companion = sandbox.Companion(["/bin/sh", "-c", self.ANSWERS], sandbox.Limits(seconds=1),
                                           {"PATH": os.environ["PATH"]}, self.folder)
        self.addCleanup(self.companion.close)

    def test_one_process_answers_every_line(self):
        process, word = self.companion.ask("one").output.split()
        self.assertEqual(word, "one")
        self.assertEqual(self.companion.ask("two").output.split(), [process, "two"])
        self.assertEqual(self.companion.ask("x" * 100_000).output.split(), [process, "x" * 100_000])

    def test_what_ends_it_is_told_of_that_line_and_the_next_is_answered(self):
        for line, code, timed_out, errors in (("crash", -11, False, ""), ("hang", -9, True, ""),
                                              ("end", 3, False, "lost\n")):
            outcome = self.companion.ask(line)
            self.assertEqual((outcome.code, outcome.timed_out, outcome.output, outcome.errors),
                             (code, timed_out, "", errors), line)
            self.assertEqual(self.companion.ask("next").output.split()[1], "next")

    def test_the_limits_hold(self):
        companion = sandbox.Companion(["/bin/sh", "-c", "read -r line; ulimit -v"],
                                      sandbox.Limits(memory_bytes=1 << 30), None, self.folder)
        self.addCleanup(companion.close)
        self.assertIn(str(1 << 20), companion.ask("").output)


class Trials(CourseTest):
    """Trials of the project's own code that crash or never end."""

    def test_each_is_told_as_its_own_and_the_others_are_not_lost(self):
        program = self.folder / "build" / "scripts" / "course" / "answers" / "course_shaders"
        program.parent.mkdir(parents=True)
        program.write_text("#!/bin/sh\nwhile read -r line; do case $line in *crash*) kill -SEGV $$ ;; "
                           "*hang*) exec sleep 60 ;; *wrong*) echo '{\"code\": 3, \"message\": "
                           "\"a.glsl does not compile.\"}' ;; "
                           "*) echo '{\"answers\": [{\"rays\": [], \"steps\": []}]}' ;; esac; done\n")
        program.chmod(0o755)
        alone = engine.Engine(build=self.folder / "build", limits=sandbox.Limits(seconds=1))
        with engine.with_companions(alone) as staying:
            kinds = [getattr(engine.ask(staying, program, "01_rays", [{"subject": subject}]), "kind",
                             "answered")
                     for subject in ("right", "crash", "right", "hang", "right", "wrong", "right")]
        self.assertEqual(kinds, ["answered", "crash", "answered", "time", "answered", "compile",
                                 "answered"])

    def test_what_was_handed_in_has_no_companion(self):
        for words in (["check", "2.1"], ["grade", "handed in"]):
            options = command._parser().parse_args([*COURSE[2:], *words])
            self.assertIsNone(command._engine(options, exercises.load()).companions)


class Archives(CourseTest):
    def setUp(self):
        super().setUp()
        self.all = exercises.load()
        self.target = self.folder / "target"
        self.target.mkdir()

    def unpacked(self, path):
        submission.unpack(path, self.target, self.all)
        return sorted(str(p.relative_to(self.target)) for p in self.target.rglob("*") if p.is_file())

    def test_only_files_of_exercises_come_out_of_a_zip(self):
        path = self.folder / "a.zip"
        with zipfile.ZipFile(path, "w") as packed:
            packed.writestr(CROSS, "cross")
            packed.writestr("../../" + CROSS, "outside")
            packed.writestr("/etc/passwd", "root")
            packed.writestr("course", "import os")
            packed.writestr("alice/" + MEDIAN, "median")
        self.assertEqual(self.unpacked(path), sorted([CROSS, MEDIAN]))
        self.assertEqual((self.target / CROSS).read_text(), "cross")

    def test_a_link_in_a_tar_is_passed_over(self):
        path = self.folder / "a.tar.gz"
        with tarfile.open(path, "w:gz") as packed:
            link = tarfile.TarInfo(CROSS)
            link.type, link.linkname = tarfile.SYMTYPE, "/etc/passwd"
            packed.addfile(link)
        self.assertEqual(self.unpacked(path), [])

    def test_a_link_in_a_folder_is_passed_over(self):
        handed_in = self.folder / "mallory"
        (handed_in / "shaders").mkdir(parents=True)
        os.symlink("/etc", handed_in / "shaders/core")
        secret = self.folder / "secret"
        secret.mkdir()
        (secret / "split_median.cpp").write_text("secret")
        (handed_in / "common/structure").mkdir(parents=True)
        os.symlink(secret, handed_in / "common/structure/bvh")
        self.assertEqual(self.unpacked(handed_in), [])

    def test_a_file_that_unpacks_to_gigabytes_is_cut_off_and_refused(self):
        path = self.folder / "a.zip"
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as packed:
            packed.writestr(CROSS, b" " * (100 << 20))
        self.unpacked(path)
        self.assertLess((self.target / CROSS).stat().st_size, 2 << 20)
        exercise = exercises.select_one(self.all, "2.1")
        result = check.check(engine.Engine(), exercise, self.target)
        self.assertIn("larger than 1 MiB", result.message)

    def test_what_is_no_archive_has_a_grade_and_a_reason(self):
        path = self.folder / "a.zip"
        path.write_bytes(b"PK\x03\x04 nothing")
        graded = grade.grade_one(engine.Engine(), path, self.all[:2])
        self.assertEqual(graded["score"], 0)
        self.assertIn("cannot be unpacked", graded["details"][0]["message"])


class Programs(CourseTest):
    """Each grade is asked for by the command, so that it is seen to survive."""

    def setUp(self):
        super().setUp()
        self.start()

    def state(self, number, code):
        self.solve(number, code)
        printed = self.course("check", number, expect=1)
        return printed.split("\n")[0].split(": ")[-1], printed

    def test_endless_loops_in_a_shader_end(self):
        state, printed = self.state("2.1", ENDLESS_SHADER)
        self.assertEqual(state, "stopped", printed)
        line = (self.workbook / CROSS).read_text().split("\n").index("            for (int k = 0; k >= 0; k = k) {")
        self.assertEqual(printed.split("\n")[1], f"  {CROSS}:{line + 1}: this loop never ends. It was left "
                                                 "after 50000 rounds.")
        self.assertNotIn("expected", printed)

    def test_a_shader_cannot_include_other_files(self):
        _, printed = self.state("2.1", '#include "/etc/passwd"')
        self.assertIn("is not in the project's file", printed)
        self.assertNotIn("root:", printed)

    def test_a_builder_that_never_ends_is_stopped(self):
        self.limits = ("--seconds", "1")
        state, printed = self.state("6.5", "    volatile bool on = true;\n    while (on) {\n    }\n"
                                           "    return BvhCut{0, range.items.size() / 2};")
        self.assertEqual(state, "stopped")
        self.assertIn("it may take 1 s, and 1 s of processors", printed)

    def test_a_builder_that_crashes_is_told_with_what_it_was_given(self):
        state, printed = self.state("6.5", "    if (range.items.size() > 2) {\n        __builtin_trap();\n"
                                           "    }\n    return {};")
        self.assertEqual(state, "crashed")
        self.assertRegex(printed.split("\n")[1], r"^  It came where no code is \(SIG(ILL|TRAP)\)")
        self.assertIn("checkpoint  boxes in a row: crashed here\n  box 1       from (0, 0, 0) to (1, 1, 1)\n",
                      printed)
        self.assertIn("  box 3  ", printed)
        self.assertNotIn("  box 4  ", printed)
        self.assertIn("replay      ./course check 6.5\n", printed)

    def test_a_function_that_crashes_is_told_with_its_numbers_and_the_replay_crashes_too(self):
        _, printed = self.state("7.1", "    std::vector<int> list(3);\n"
                                       "    return {double(list.at(values.size())), 0.0, 0.0};")
        self.assertIn("It threw an exception that nobody caught: vector::_M_range_check", printed)
        self.assertIn(": crashed here\n", printed)
        replay = printed.split("replay")[1].split()
        self.assertIn("nobody caught", self.course(*replay[1:], expect=1))

    def test_what_ended_it_is_told_in_words(self):
        ends = (("std::string text(1000, 'x');\n    while (range.items.size()) std::puts(text.c_str());",
                 "It printed too much (SIGXFSZ)"), ("std::abort();", "It gave up (SIGABRT)"))
        if "--memory" not in COURSE:  # AddressSanitizer ends it otherwise
            ends += (("std::vector<double> list(range.items.size() << 40U);",
                      "It asked for more memory than the 768 MiB that it may have (std::bad_alloc)"),)
        for code, words in ends:
            path = self.solve("6.5", f"    {code}\n    return {{}};")
            text = path.read_text()
            path.write_text("#include <cstdio>\n#include <cstdlib>\n#include <string>\n" + text)
            printed = self.course("check", "6.5", expect=1)
            self.assertIn(words, printed)
            self.assertIn("outside     lines 1-3 are not the project's", printed)
            path.write_text(text)

    def test_a_builder_that_ends_the_program_has_given_no_answer(self):
        state, _ = self.state("6.5", "    if (range.items.size() > 1) {\n        __builtin_exit(0);\n"
                                     "    }\n    return {};")
        self.assertEqual(state, "crashed")

    def test_an_error_in_a_builder_names_the_line_of_the_workbook(self):
        path = self.solve("6.5", "    return lost;")
        line = path.read_text().split("\n").index("    return lost;") + 1
        state, printed = self.state("6.5", "    return lost;")
        self.assertEqual(state, "does not compile")
        self.assertIn(f"split_median.cpp:{line}:", printed)

    def test_the_solution_of_a_builder_passes_afterwards(self):
        self.solve("6.5")
        self.assertIn("6.5 Half of the triangles on each side: passed", self.course("check", "6.5"))


if __name__ == "__main__":
    unittest.main()
