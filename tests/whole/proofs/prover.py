"""Fills the proofs of this folder with the shaders' formulas and hands them to gappa.

A proof says in a line `#: at most 6 e M: what` what docs/numerics.md promises, e being 2^-24, and asks gappa for the
bounds of one or several expressions. In braces stand formulas of the shaders (shader_text.py) and, as the name of
another proof alone, the bound that gappa found there. Hypotheses in [[ ... or ... ]] are cases: gappa asks for no
bounds under an `or`, so it is asked about each case by itself.
"""

import re
import shutil
import subprocess
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from shader_text import TextChanged, constant, formula

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[2]
E = Fraction(1, 2**24)

# docs/numerics.md leaves out the terms in e^2. A bound may be worse than its promise by so much of it, and what follows
# from the bound is proved with all of it.
SECOND_ORDER = Fraction(1, 2**16)

PROMISE = re.compile(r"^#: at (most|least) (\S+) e (\w+): (.+)$", re.M)
COMMENT = re.compile(r"#[^\n]*")
CASES = re.compile(r"\[\[(.*?)\]\]", re.S)
BRACES = re.compile(r"\{((?:[\w./]+)(?: [\w.]+){0,2})\}")
QUOTIENT = re.compile(r"^(\w+) rnd= ([^;/]+) / (\w+);", re.M)
NUMBER = r"(-?\d+(?:b-?\d+)?)(?: \{[^}]*\})?"
RESULT = re.compile(rf"^  .* in \[{NUMBER}, {NUMBER}\]$", re.M)

# What gappa warns of, but for variables without bounds and expressions with two names: most of all, a hint whose
# sides are not the same.
FAULT = re.compile(r"Warning: (?!renaming identifier |\w+ is a variable without definition)")


class NotProved(Exception):
    """Gappa finds no proof, or a bound that is worse than what is promised."""


@dataclass
class Proof:
    text: str
    kind: str  # whether the promise is the "most" or the "least" that it may be
    promise: Fraction  # in units of e
    unit: str
    title: str

    def __str__(self):
        return f"at {self.kind} {float(self.promise):g} e {self.unit}"


def proof_of(path):
    text = path.read_text()
    kind, number, unit, title = PROMISE.search(text).groups()
    return Proof(text, kind, Fraction(number), unit, title)


def is_installed():
    return shutil.which("gappa") is not None


def exact(number):
    """A number that gappa printed."""
    significand, _, exponent = number.partition("b")
    return Fraction(int(significand)) * Fraction(2) ** int(exponent or 0)


def rounded_up(number):
    return f"{-(-(number * 2**64).numerator // (number * 2**64).denominator)}b-64"


def cases_of(text):
    found = CASES.search(text)
    return [CASES.sub(lambda _: case, text) for case in re.split(r"\bor\b", found[1])] if found else [text]


def with_rough_quotients(text, error):
    """Quotients are not rounded: each is a number of its own, and wrong by up to `error` e."""
    known = "".join(f"|{name} -/ ({name}_above / {below})| <= {error}b-24 /\\\n"
                    for name, _, below in QUOTIENT.findall(text))
    definitions, brace, rest = QUOTIENT.sub(r"\1_above rnd= \2;", text).partition("{")
    return definitions + brace + known + rest


class Bounds(dict):
    """The bounds that gappa finds, in units of e, by the names of the proofs; each is found when it is asked for.

    The formulas come from the tree below `root`. Division errs by up to `division` e: 1 is to round to nearest.
    """

    def __init__(self, root=ROOT, division=1):
        super().__init__()
        self.root, self.division = root, division
        self.proofs = {path.stem: proof_of(path) for path in sorted(FOLDER.glob("*.g"))}

    def text(self, name):
        """What gappa reads of a proof."""
        text = COMMENT.sub("", self.proofs[name].text)
        names = set(re.findall(r"[A-Za-z_]\w*", BRACES.sub("", text)))

        def fill(match):
            asked = match.group(1).split()
            if len(asked) == 1:
                return rounded_up(self[asked[0]] * E)
            if len(asked) == 2:
                return constant(self.root / asked[0], asked[1])
            return formula(self.root, *asked, names)

        text = BRACES.sub(fill, text)
        return with_rough_quotients(text, self.division) if self.division != 1 else text

    def __missing__(self, name):
        ends = []
        for text in cases_of(self.text(name)):
            run = subprocess.run(["gappa"], input=text, capture_output=True, text=True, timeout=60, check=False)
            said = run.stdout + run.stderr
            found = RESULT.findall(said)
            if run.returncode != 0 or not found or FAULT.search(said):
                raise NotProved(f"{name}.g: gappa finds no proof:\n{said.rstrip()}")
            ends += [(exact(low), exact(high)) for low, high in found]
        least = self.proofs[name].kind == "least"
        self[name] = (min(low for low, _ in ends) if least else max(max(-low, high) for low, high in ends)) / E
        return self[name]

    def check(self, name):
        """The bound. Throws NotProved where it is worse than the promise."""
        proof, found = self.proofs[name], self[name]
        worse = proof.promise - found if proof.kind == "least" else found - proof.promise
        if worse > abs(proof.promise) * SECOND_ORDER:
            raise NotProved(f"{name}.g: gappa proves {float(found):.4f} e {proof.unit}, and {proof} is promised.")
        return found


__all__ = ["Bounds", "NotProved", "ROOT", "TextChanged", "is_installed"]
