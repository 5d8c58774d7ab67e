"""Another engine, by its command line, and what is wrong with its answer."""

import json
import os
import resource
import shlex
import signal
import subprocess

from scene import obj_of, write_floats


def call(command, files, seconds, memory=None):
    """Runs an engine with the names of these files in its command line; empty, or how it failed: `timeout`, `crash`
    (it was ended by a signal), or `exit N`. The memory is in bytes, of each process."""
    words = shlex.split(command)
    for mark, path in files.items():
        words = [word.replace(mark, str(path)) for word in words]

    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))

    # In a group of its own, so that what it started ends with it.
    with subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          start_new_session=True, preexec_fn=limit) as process:
        try:
            process.wait(timeout=seconds)
        except BaseException as error:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            if isinstance(error, subprocess.TimeoutExpired):
                return "timeout"
            raise
        if process.returncode < 0:
            return "crash"
        return f"exit {process.returncode}" if process.returncode else ""


class Engine:
    def __init__(self, command, check, seconds, folder):
        self.command = command
        self.check = check
        self.seconds = seconds
        self.model, self.packed, self.ray, self.hit = (
            folder / name for name in ("model.obj", "triangles.f32", "ray.f32", "hit.f32"))
        self.verdict = folder / "verdict.json"
        self.right = -1  # the triangle of the last right answer, among those that were given
        self.calls = 0

    def failure(self, triangles, ray):
        """`wrong`, `crash` or `timeout`; empty where the answer is right."""
        self.model.write_text(obj_of(triangles))
        write_floats(self.packed, [number for triangle in triangles for number in triangle])
        write_floats(self.ray, ray)
        self.hit.unlink(missing_ok=True)
        self.calls += 1
        files = {"%m": self.model, "%t": self.packed, "%r": self.ray, "%h": self.hit}
        ended = call(self.command, files, self.seconds)
        if ended == "timeout":
            return ended
        self.judge(exists=self.hit.exists() and self.hit.stat().st_size == 16)
        if ended == "crash" or not self.hit.exists() or self.hit.stat().st_size != 16:
            return "crash"
        return self.answer

    def judge(self, exists):
        """By our own tree, the loop over every triangle, and exact arithmetic."""
        self.answer, self.right = "", -1
        if not exists:
            self.hit.write_bytes(b"\0\0\x80\x7f" + bytes(8) + b"\xff\xff\xff\xff")  # a miss, to be told what is right
        self.verdict.unlink(missing_ok=True)
        run = subprocess.run([self.check, "--scene", self.model, "--rays", self.ray, "--judge", self.hit,
                              "--out", self.verdict.parent, "--json", self.verdict],
                             capture_output=True, text=True, check=False)
        if run.returncode not in (0, 1):
            raise subprocess.SubprocessError(f"check said: {run.stderr.strip()}")
        first = json.loads(self.verdict.read_text())["answers"]["first_wrong"]
        if first:
            self.answer, self.right = "wrong", first[0]["right_triangle"]
        if not exists:
            self.hit.unlink()
