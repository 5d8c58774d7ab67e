"""Compiles many versions of one C++ source as one translation unit: its headers are read once, which
is most of what a version costs by itself. Each version is a shared library, so the program that calls it
is linked once for all of them. For the project's own trials (see verify.py), never for what was handed
in: versions that share a compiler's memory must trust each other."""

import re
import subprocess
from pathlib import Path

from .exercises import ROOT

MOST_VERSIONS = 24  # in one unit: a compiler's memory has an end
NAME = "libown.so"  # of each version's library, in a folder of its own

INCLUDE = re.compile(r"^\s*#\s*include\s*([<\"])(.*?)[>\"].*$", re.MULTILINE)


def _symbols(object_file):
    """Of the functions that other files may call: what the linker calls them, by their C++ names."""
    def listed(*options):
        found = subprocess.run(["nm", "-p", "--defined-only", *options, object_file],
                               capture_output=True, text=True, check=True)
        return [line.split(" ", 2)[1:] for line in found.stdout.splitlines()]

    return {name: symbol for (kind, symbol), (_, name) in zip(listed(), listed("-C")) if kind == "T"}


def _names(symbols):
    """Those of the functions, without namespace and parameters."""
    found = (re.fullmatch(r"raysteps::(\w+)\(.*", name) for name in symbols)
    return sorted({match[1] for match in found if match})


def _declarations(text, names):
    """How the project's headers that the text includes declare the functions."""
    headers = [ROOT / "common" / target for quote, target in INCLUDE.findall(text) if quote == '"']
    pattern = re.compile(rf"^[\w:<>,&*\[\] ]+[ &*](?:{'|'.join(names)})\([^;]*?\);", re.MULTILINE)
    return "\n".join(match[0] for header in headers if header.exists()
                     for match in pattern.finditer(header.read_text()))


def _version(text, names, number):
    """The text in a namespace of its own. Its functions have names of their own too: by those of
    their arguments, C++ would find the header's functions beside them."""
    body = re.sub(r"^#line .*$", "", INCLUDE.sub("", text), flags=re.MULTILINE)
    body = f"namespace raysteps {{\n{_declarations(text, names)}\n}}\n{body}"
    body = re.sub(rf"(?<![.:>])\b({'|'.join(names)})\b", rf"\1_{number}", body)
    return body.replace("namespace raysteps {", f"namespace raysteps::version_{number} {{")


def _compile_unit(command, link, texts, names, own, folder):
    """A library for each text, by the text; none where the unit does not compile."""
    first = [line for text in texts for line in (match[0] for match in INCLUDE.finditer(text))]
    unit, made = folder / "unit.cpp", folder / "unit.o"
    unit.write_text("\n".join([*dict.fromkeys(first), *(
        _version(text, names, number) for number, text in enumerate(texts))]))
    if subprocess.run(command(unit, made), capture_output=True, check=False).returncode != 0:
        return {}
    symbols, libraries = _symbols(made), {}
    for number, text in enumerate(texts):
        named = []
        for name, symbol in symbols.items():
            if name.startswith(f"raysteps::version_{number}::"):
                known = re.sub(rf"(\w+)_{number}\(", r"\1(", name.replace(f"version_{number}::", "", 1), count=1)
                named += [f"-Wl,--defsym,{own[known]}={symbol}"] if known in own else []
        libraries[text] = folder / f"version_{number}" / NAME
        libraries[text].parent.mkdir()
        subprocess.run([*link, made, *named, "-o", libraries[text]], check=True)
    return libraries


def compile_together(command, link, texts, own_object, folder):
    """Libraries by their texts, in the folder; a text that is missing has to be compiled by itself.
    `command` gives the words that compile a file into an object, `link` are those that make a library
    of it; own_object is the project's. All of one unit want the same functions of a program."""
    own = _symbols(own_object)
    names = _names(own)
    libraries, texts = {}, list(dict.fromkeys(texts))
    for first in range(0, len(texts), MOST_VERSIONS):
        place = Path(folder) / str(first)
        place.mkdir(parents=True, exist_ok=True)
        libraries.update(_compile_unit(command, link, texts[first:first + MOST_VERSIONS], names, own, place))
    return libraries
