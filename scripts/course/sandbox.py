"""Runs a program that may crash, never end, or fill memory and disk."""

import os
import resource
import select
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path

MOST_BYTES_SHOWN = 20_000
SECONDS_BETWEEN_LOOKS = 0.1


@dataclass
class Limits:
    seconds: float = 60.0  # of the clock: other programs may hold it up
    cpu_seconds: int = 4  # of all of its threads together; 0: no limit. The project's own code takes 1.2
    memory_bytes: int = 8 << 30  # of addresses, which the software renderer reserves far more of than it uses;
    # and of memory that is used, for all of its processes together; 0: no limit
    file_bytes: int = 64 << 20  # of each file that it writes, its output included
    processes: int = 512  # of this user, where the system counts them: not those of root; 0: no limit


@dataclass
class Outcome:
    """How a run ended: `code` is the exit code, or minus the number of the signal."""

    code: int
    timed_out: bool
    output: str
    errors: str
    seconds: float


def _limit(limits):
    os.setsid()
    for kind, most in ((resource.RLIMIT_CPU, limits.cpu_seconds),
                       (resource.RLIMIT_AS, limits.memory_bytes),
                       (resource.RLIMIT_FSIZE, limits.file_bytes),
                       (resource.RLIMIT_NPROC, limits.processes),
                       (resource.RLIMIT_CORE, 0)):
        _, hard = resource.getrlimit(kind)
        if kind != resource.RLIMIT_CORE and most == 0:
            continue
        most = most if hard == resource.RLIM_INFINITY else min(most, hard)
        # At the lower limit of time a signal says so; at the upper one there is no way on.
        room = 2 if kind == resource.RLIMIT_CPU and hard == resource.RLIM_INFINITY else 0
        resource.setrlimit(kind, (most, most + room))


def _kill_all(process):
    try:
        os.killpg(process.pid, signal.SIGKILL)  # _limit made it the head of a group of its own
    except (ProcessLookupError, PermissionError):
        pass


def _family(pid):
    """The process, and all that it has started: of a sandbox's those too that have left their group."""
    waiting, found = [pid], []
    while waiting:
        found.append(waiting.pop())
        try:
            for children in list(Path(f"/proc/{found[-1]}/task").glob("*/children")):
                waiting += map(int, children.read_text().split())
        except OSError:  # it has ended meanwhile
            pass
    return found


def _used_memory(pid):
    pages = 0
    for one in _family(pid):
        try:
            pages += int(Path(f"/proc/{one}/statm").read_text().split()[1])
        except (OSError, IndexError):  # it has ended meanwhile
            pass
    return pages * resource.getpagesize()


def _wait(process, limits):
    """Until it ends or is to be ended. Whether there was no time left for it."""
    end = time.monotonic() + limits.seconds
    while True:
        try:
            process.wait(timeout=min(SECONDS_BETWEEN_LOOKS, max(0.0, end - time.monotonic())))
            return False
        except subprocess.TimeoutExpired:
            if time.monotonic() >= end:
                return True
            if limits.memory_bytes and _used_memory(process.pid) > limits.memory_bytes:
                return False


def _tail(file, most=MOST_BYTES_SHOWN):
    end = file.seek(0, os.SEEK_END)
    file.seek(max(0, end - most))
    return file.read().decode(errors="replace")


def signal_of(code):
    """The number of the signal that ended a run; 0 where none did. A shell and bubblewrap add it to 128."""
    return -code if code < 0 else max(0, code - 128)


def run(command, limits, environment=None, folder=None, most_shown=MOST_BYTES_SHOWN):
    """Output goes to files without a name, which the limits hold as well; its end is returned."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        start = time.monotonic()
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=errors,
                                   env=environment, cwd=folder, preexec_fn=lambda: _limit(limits))
        try:
            timed_out = _wait(process, limits)
        except BaseException:  # the person pressed Ctrl-C
            _kill_all(process)
            process.wait()
            raise
        _kill_all(process)  # what it left running goes too
        code = process.wait()
        timed_out = timed_out or signal_of(code) == signal.SIGXCPU
        return Outcome(code, timed_out, _tail(output, most_shown), _tail(errors),
                       time.monotonic() - start)


class Companion:
    """A program that stays, and answers each line with a line. All that it is asked shares one
    process: for code that is known, never for what was handed in. Where it crashes or is stopped,
    the next line starts it anew."""

    def __init__(self, command, limits, environment, folder):
        self._command, self._environment, self._folder = command, environment, folder
        self._limits = replace(limits, cpu_seconds=0)  # the clock's limit is of each line
        self._process = None

    def ask(self, line):
        """The Outcome of one line: its output is the reply, and empty where the program gave
        none."""
        start = time.monotonic()
        if self._process is None:
            self._errors = tempfile.TemporaryFile()
            self._process = subprocess.Popen(
                self._command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._errors,
                env=self._environment, cwd=self._folder, preexec_fn=lambda: _limit(self._limits))
        try:
            reply, timed_out = self._reply(line, start + self._limits.seconds)
        except BaseException:  # the person pressed Ctrl-C
            self.close()
            raise
        if reply:
            return Outcome(0, False, reply, "", time.monotonic() - start)
        code, errors = self.close()
        return Outcome(code, timed_out, "", errors, time.monotonic() - start)

    def _reply(self, line, deadline):
        """The line that the program writes, and whether there was no time left for it."""
        reply = b""
        try:
            self._process.stdin.write(line.encode() + b"\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            return "", False
        while not reply.endswith(b"\n"):
            left = max(0.0, deadline - time.monotonic())
            if not select.select([self._process.stdout], [], [], left)[0]:
                return "", True
            read = os.read(self._process.stdout.fileno(), 1 << 20)
            if not read:
                return "", False
            reply += read
        return reply.decode(errors="replace"), False

    def close(self):
        """Ends the program. Its exit code, and what it wrote to standard error."""
        if self._process is None:
            return 0, ""
        process, self._process = self._process, None
        with self._errors, process.stdout:
            try:
                process.stdin.close()
            except BrokenPipeError:
                pass
            _kill_all(process)
            return process.wait(), _tail(self._errors)
