"""Another engine, by its command line, and what is wrong with its answer."""

import json
import os
import shlex
import signal
import subprocess

from scene import obj_of, write_ray


class Engine:
    def __init__(self, command, check, seconds, folder):
        self.command = command
        self.check = check
        self.seconds = seconds
        self.model, self.ray, self.hit = (folder / name for name in ("model.obj", "ray.f32", "hit.f32"))
        self.verdict = folder / "verdict.json"
        self.right = -1  # the triangle of the last right answer, among those that were given
        self.calls = 0

    def failure(self, triangles, ray):
        """`wrong`, `crash` or `timeout`; empty where the answer is right."""
        self.model.write_text(obj_of(triangles))
        write_ray(self.ray, ray)
        self.hit.unlink(missing_ok=True)
        self.calls += 1
        ended = self.call()
        if ended == "timeout":
            return ended
        self.judge(exists=self.hit.exists() and self.hit.stat().st_size == 16)
        if ended == "crash" or not self.hit.exists() or self.hit.stat().st_size != 16:
            return "crash"
        return self.answer

    def call(self):
        words = [word.replace("%m", str(self.model)).replace("%r", str(self.ray)).replace("%h", str(self.hit))
                 for word in shlex.split(self.command)]
        # In a group of its own, so that what it started ends with it.
        with subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              start_new_session=True) as process:
            try:
                process.wait(timeout=self.seconds)
            except BaseException as error:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                if isinstance(error, subprocess.TimeoutExpired):
                    return "timeout"
                raise
            return "crash" if process.returncode < 0 else ""

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
