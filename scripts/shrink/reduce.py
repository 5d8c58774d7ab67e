"""Delta debugging (Zeller and Hildebrandt, "Simplifying and Isolating Failure-Inducing Input", 2002) of triangles."""

import hashlib
import json
import sys


class ShrinkError(Exception):
    """One sentence for the person who called."""


class Reduction:
    """The fewest triangles, by their numbers, with which the engine fails as it did: without any one of them, it
    does not. What is known is kept in a file, from which the same reduction goes on."""

    def __init__(self, engine, triangles, ray, failure, state, asked):
        self.engine, self.triangles, self.ray, self.failure = engine, triangles, ray, failure
        self.state = state
        self.key = hashlib.sha256(json.dumps([asked, len(triangles)]).encode()).hexdigest()
        self.kept = list(range(len(triangles)))
        self.parts = 2
        if state.exists():
            known = json.loads(state.read_text())
            if known.get("key") == self.key:
                self.kept, self.parts = known["kept"], known["parts"]
                print(f"goes on with {len(self.kept)} triangles, from {state}")

    def fails_with(self, numbers):
        self.show(len(numbers))
        return self.engine.failure([self.triangles[i] for i in numbers], self.ray) == self.failure

    def show(self, tried):
        if sys.stderr.isatty():
            print(f"\r\033[K{len(self.kept)} triangles are left; call {self.engine.calls}, with {tried}",
                  end="", file=sys.stderr, flush=True)

    def keep(self, numbers, parts):
        self.kept, self.parts = numbers, parts
        self.state.write_text(json.dumps({"key": self.key, "kept": numbers, "parts": parts}))

    def run(self):
        while len(self.kept) > 1:
            if not self.reduce_once():
                if self.parts >= len(self.kept):
                    break
                self.keep(self.kept, min(len(self.kept), 2 * self.parts))
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr)
        return self.kept

    def reduce_once(self):
        bounds = [len(self.kept) * i // self.parts for i in range(self.parts + 1)]
        ranges = list(zip(bounds, bounds[1:]))
        for first, last in ranges:
            if 0 < last - first < len(self.kept) and self.fails_with(self.kept[first:last]):
                self.keep(self.kept[first:last], 2)
                return True
        for first, last in ranges if self.parts > 2 else []:
            rest = self.kept[:first] + self.kept[last:]
            if len(rest) < len(self.kept) and self.fails_with(rest):
                self.keep(rest, max(self.parts - 1, 2))
                return True
        return False
