"""Formulas of shader parts as gappa reads them, out of their text: nothing is copied by hand.

A formula is asked for by file, function and the name that it is given to:

    {shaders/triangle/watertight/shear.glsl sheared x}      precise real x = p.x - ray.shear.x * p.z;
    p_x - ray_shear_x * p_z                                 what comes of it

A name of a vector with a component (`p.x`) asks for one component of its formula; `return` asks for what the
function returns; file and name alone ask for a constant. What is rounded, and how, the proof says.
"""

import re
import struct
from fractions import Fraction

COMMENT = re.compile(r"//[^\n]*")
TOKEN = re.compile(r"""\s*(?:
    (?P<number>0x[\da-f.]+p[-+]?\d+|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)f?\b
  | (?P<name>[A-Za-z_]\w*(?:(?:\.|::)\w+|\[\w+\])*)
  | (?P<sign>[-+*/()])
)""", re.VERBOSE | re.IGNORECASE)
SAME = {"real", "real3", "axis_last"}  # calls that compute nothing: a type, and an order of the axes


class TextChanged(Exception):
    """The text of a shader is no longer one that a proof can speak of."""


def without_comments(path):
    try:
        return COMMENT.sub("", path.read_text())
    except OSError as error:
        raise TextChanged(f"{path}: {error.strerror}. Name the file's new place in the proof.") from error


def body_of(path, function):
    """What stands between the braces of a function, which begin and end at the margin."""
    found = re.findall(rf"^[A-Za-z]\w* {function}\([^{{;]*\{{\n(.*?)^\}}", without_comments(path), re.M | re.S)
    if len(found) != 1:
        raise TextChanged(f"{path} has {len(found)} functions {function}, not one. Name the right one in the proof.")
    return found[0]


def formula_text(path, function, name):
    """The right side of the one statement that gives `name` its value, and whether it is `precise`."""
    start = r"return" if name == "return" else rf"(?:\w+ )?{re.escape(name)} ="
    found = []
    for statement in re.split(r"[;{}]", body_of(path, function)):
        match = re.fullmatch(rf"(precise )?{start} (.*)", " ".join(statement.split()))
        if match:
            found.append(match.groups())
    if len(found) != 1:
        raise TextChanged(f"{path}: {function} has {len(found)} formulas of {name}, not one. Mend the proof.")
    precise, text = found[0]
    return text, bool(precise)


def dyadic(number):
    """A literal as the float that it stands for, as gappa writes it without an error: 3b-2 is 3/4."""
    value = float.fromhex(number) if number.lower().startswith("0x") else float(number)
    exact = Fraction(struct.unpack("f", struct.pack("f", value))[0])
    return f"{exact.numerator}b-{exact.denominator.bit_length() - 1}" if exact.denominator > 1 else str(exact)


def constant(path, name):
    found = re.findall(rf"^const \w+ {name} = ([-\w.]+?)f?;", without_comments(path), re.M)
    if len(found) != 1:
        raise TextChanged(f"{path} has {len(found)} constants {name}, not one. Name the right one in the proof.")
    return dyadic(found[0])


def tokens_of(text, where):
    tokens, place = [], 0
    text = text.strip()
    while place < len(text):
        match = TOKEN.match(text, place)
        comma = re.compile(r"\s*,").match(text, place)
        if not match and not comma:
            raise TextChanged(f"{where} is no longer of sums, products and quotients: {text[place:]!r}. "
                              "Mend the proof.")
        tokens.append((match.lastgroup, match.group(match.lastgroup)) if match else ("comma", ","))
        place = (match or comma).end()
    return tokens


class Translator:
    """One formula, with the names that its proof knows."""

    def __init__(self, known, component, where):
        self.known, self.component, self.where = known, component, where

    def name(self, *parts):
        """The proof's name of a number: with the component that is asked for where the proof has that."""
        plain = "_".join(re.sub(r"\[\w+\]", "", part).replace("::", "_").replace(".", "_") for part in parts)
        for name in ([f"{plain}_{self.component}"] if self.component else []) + [plain]:
            if name in self.known:
                return name
        return None

    def call(self, function, arguments):
        if function in SAME:
            return f"({self.all(arguments[0])})"
        # Any other call is a number of which the proof says what is known of it.
        first = [arguments[0][0][1]] if len(arguments[0]) == 1 else []
        named = (first and self.name(function, *first)) or self.name(function)
        return f"|{self.all(arguments[0])}|" if function == "abs" and not named else named

    def all(self, tokens):
        result, place = [], 0
        while place < len(tokens):
            kind, token = tokens[place]
            place += 1
            if kind == "number":
                result.append(dyadic(token))
            elif kind == "name":
                shown, translated = token, None
                if place < len(tokens) and tokens[place] == ("sign", "("):
                    arguments, place = self.arguments(tokens, place)
                    shown, translated = f"{token}(...)", self.call(token, arguments)
                else:
                    translated = self.name(token)
                if not translated:
                    raise TextChanged(f"{self.where} has {shown}, of which the proof knows nothing. Mend the proof.")
                result.append(translated)
            else:
                result.append(token)
        return " ".join(result)

    @staticmethod
    def arguments(tokens, place):
        """The arguments from an opening bracket on, and the place behind the closing one."""
        depth, arguments = 0, [[]]
        while True:
            token = tokens[place]
            place += 1
            depth += {"(": 1, ")": -1}.get(token[1], 0)
            if depth == 0:
                return arguments, place
            if depth == 1 and token[0] == "comma":
                arguments.append([])
            elif depth > 1 or token[1] != "(":
                arguments[-1].append(token)


def formula(root, file, function, name, known):
    where = f"{file}: {name} in {function}"
    vector, _, component = name.partition(".")
    text, is_precise = formula_text(root / file, function, vector)
    tokens = tokens_of(text, where)
    signs = {token for kind, token in tokens if kind == "sign"}
    if not is_precise and signs & set("*/") and signs & set("+-"):
        raise TextChanged(f"{where} is not `precise`, so a compiler may fuse it. Make it so.")
    return Translator(known, component, where).all(tokens)
