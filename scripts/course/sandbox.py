"""Runs a program that may crash, never end, or fill memory and disk."""

import os
import resource
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass

MOST_BYTES_SHOWN = 20_000


@dataclass
class Limits:
    seconds: float = 60.0  # of the clock
    cpu_seconds: int = 60  # of all of its threads together
    memory_bytes: int = 8 << 30  # of addresses: the software renderer reserves far more than it uses; 0: no limit
    file_bytes: int = 64 << 20  # of each file that it writes, its output included
    processes: int = 512  # of this user; the system does not count those of root


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
        if kind == resource.RLIMIT_AS and most == 0:
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


def _tail(file):
    end = file.seek(0, os.SEEK_END)
    file.seek(max(0, end - MOST_BYTES_SHOWN))
    return file.read().decode(errors="replace")


def run(command, limits, environment=None, folder=None):
    """Output goes to files without a name, which the limits hold as well."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        start = time.monotonic()
        timed_out = False
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=errors,
                                   env=environment, cwd=folder, preexec_fn=lambda: _limit(limits))
        try:
            process.wait(timeout=limits.seconds)
        except subprocess.TimeoutExpired:
            timed_out = True
        except BaseException:  # the person pressed Ctrl-C
            _kill_all(process)
            process.wait()
            raise
        _kill_all(process)  # what it left running goes too
        code = process.wait()
        timed_out = timed_out or code == -signal.SIGXCPU
        return Outcome(code, timed_out, _tail(output), _tail(errors), time.monotonic() - start)
