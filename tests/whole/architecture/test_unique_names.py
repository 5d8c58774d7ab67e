"""No name stands for two things: each class, enumeration and function of the project is defined once.

Two types of one name in one namespace are undefined behaviour as soon as one program links both, and no
linker says so. Names in unnamed namespaces are their file's own. The preset `odr` asks the compiler the
same, of what is linked; this test asks all sources, in a second."""

import re
import sys
import unittest
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
FOLDERS = ("common", "chapters", "visualizer", "scripts", "tests")
STAND_INS = "absent"  # folders whose files take the place of others

TOKEN = re.compile(r"""
    //[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:\\\n|[^\n])*   # comments and what the preprocessor reads
  | R"(?P<mark>[^(]*)\(.*?\)(?P=mark)" | "(?:\\.|[^"\\])*" | '(?:\\.|[^'\\])*'
  | [A-Za-z_]\w* | \d[\w.']* | :: | \[\[.*?\]\] | \S
""", re.VERBOSE | re.DOTALL | re.MULTILINE)
SILENT = ("//", "/*", "[[")
KINDS = {"struct", "class", "enum", "union"}
CLOSES = {"(": ")", "<": ">", "[": "]"}


def tokens_of(text):
    for match in TOKEN.finditer(text):
        token = match.group()
        if not token.startswith(SILENT) and not token.lstrip(" \t").startswith("#"):
            yield '""' if token.startswith(('"', 'R"')) else token, text.count("\n", 0, match.start()) + 1


def split_at_commas(tokens):
    """The parts of a list of parameters, each without its default and its name."""
    parts, part, depth = [], [], 0
    for token in [*tokens, ","]:
        if token == "," and depth == 0:
            part = part[:part.index("=")] if "=" in part else part
            if len(part) > 1 and re.match(r"[A-Za-z_]\w*$", part[-1]) and part[-2] not in ("::", "const"):
                part = part[:-1]
            parts.append(" ".join(token for token in part if token != "const"))
            part = []
            continue
        depth += (token in CLOSES) - (token in CLOSES.values())
        part.append(token)
    return parts


def without_template(head):
    """The head of a definition without `template <...>`."""
    if head[:1] != ["template"]:
        return head
    depth = 0
    for i, token in enumerate(head):
        depth += (token == "<") - (token == ">")
        if token == ">" and depth == 0:
            return without_template(head[i + 1:])
    return []


def definition_in(head):
    """What the tokens before a brace define: `struct Box`, `merge(Box &, Box &)`; None where nothing."""
    head = without_template([token for token in head if token not in ("inline", "static", "constexpr")])
    if head and head[0] in KINDS and "(" not in head and "=" not in head:
        names = [token for token in head[1:head.index(":")] if token not in KINDS | {"final"}] \
            if ":" in head else [token for token in head[1:] if token not in KINDS | {"final"}]
        is_template = "<" in names  # a specialisation: another thing each time
        return "type " + " ".join(names) if names and (not is_template) else None
    if "(" in head and "=" not in head[:head.index("(")] and head[0] not in ("extern", "using"):
        start = head.index("(")
        depth = 0
        for end in range(start, len(head)):
            depth += (head[end] == "(") - (head[end] == ")")
            if depth == 0:
                break
        name = head[start - 1]
        qualified = start > 1 and head[start - 2] == "::"
        if re.match(r"[a-z_]\w*$", name) and name != "main" and not qualified and "operator" not in head:
            return f"{name}({', '.join(split_at_commas(head[start + 1:end]))})"
    return None


def definitions_in(text):
    """(qualified name, line) of each class, enumeration and free function that is defined."""
    found, spaces, head, line, inside, parens = [], [], [], 0, 0, 0
    for token, here in tokens_of(text):
        if inside or (parens and token == "{"):  # a body or a default: nothing there has a name outside
            inside += (token == "{") - (token == "}")
            continue
        parens += (token == "(") - (token == ")")
        if token == "{" and head[:1] == ["namespace"]:
            spaces.append("".join(head[1:]))
            head = []
        elif token == "{":
            name = definition_in(head)
            if name and "" not in spaces:
                found.append(("::".join(spaces) + " " + name, line))
            head, inside = [], 1
        elif token == "}":
            spaces = spaces[:-1]
            head = []
        elif token == ";" and parens == 0:
            head = []
        else:
            line = line if head else here
            head.append(token)
    return found


def duplicates_in(files):
    """`raysteps type Box: a.h:3, b.h:5` for what several of the files, texts by their paths, define.

    Two definitions in one file are alternatives of its #if: the compiler would not take both."""
    places = defaultdict(dict)
    for path, text in files.items():
        for name, line in definitions_in(text):
            places[name].setdefault(path, line)
    return sorted(f"{name}: " + ", ".join(f"{path}:{line}" for path, line in where.items())
                  for name, where in places.items() if len(where) > 1)


def sources():
    files = {}
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".h", ".cpp") and STAND_INS not in path.parts:
                files[str(path.relative_to(ROOT))] = path.read_text(encoding="utf-8")
    return files


class UniqueNames(unittest.TestCase):
    def test_each_name_of_the_project_is_defined_once(self):
        files = sources()
        self.assertGreater(len(files), 100)
        self.assertGreater(sum(len(definitions_in(text)) for text in files.values()), 500)
        self.assertEqual(duplicates_in(files), [])


class Scan(unittest.TestCase):
    def test_two_types_of_one_name_are_found(self):
        found = duplicates_in({"a.h": "namespace raysteps {\nstruct Findings { int a; };\n}",
                               "b.h": "namespace raysteps {\nclass Findings final : A { };\n}"})
        self.assertEqual(found, ["raysteps type Findings: a.h:2, b.h:2"])
        found = duplicates_in({"a.h": "namespace raysteps { enum class Verdict { a, b }; }",
                               "b.h": "namespace raysteps { enum Verdict : int { c }; }"})
        self.assertEqual(len(found), 1)

    def test_namespaces_part_names_and_unnamed_ones_hide_them(self):
        self.assertEqual(duplicates_in({
            "a.cpp": "namespace raysteps { namespace { struct Entry { }; } }",
            "b.cpp": "namespace raysteps { namespace { struct Entry { }; } struct Entry { }; }",
            "c.cpp": "namespace raysteps::mirror { struct Entry { }; }",
            "d.cpp": "namespace raysteps { struct Other { struct Entry { }; }; }"}), [])

    def test_declarations_comments_and_words_in_quotes_define_nothing(self):
        text = ('namespace raysteps {\n// struct Box { };\n/* struct Box { }; */\n#define A struct Box { }\n'
                'struct Box;\nconst char* t = "struct Box { };";\nauto r = R"(struct Box { )";\n}')
        self.assertEqual(definitions_in(text), [])

    def test_overloads_are_two_functions_and_names_of_parameters_make_none(self):
        text = "namespace raysteps {{ int sum(int {0}, const Box& b = {{}}) {{ return 0; }} }}"
        self.assertEqual(len(duplicates_in({"a.cpp": text.format("a"), "b.cpp": text.format("c")})), 1)
        other = "namespace raysteps { int sum(float a, const Box& b) { return 0; } }"
        self.assertEqual(duplicates_in({"a.cpp": text.format("a"), "b.cpp": other}), [])

    def test_members_of_classes_are_no_functions_of_a_namespace(self):
        text = "namespace raysteps { void Box::grow(int by) { } Box::Box(int a) : a_{a} { } }"
        self.assertEqual(duplicates_in({"a.cpp": text, "b.cpp": text}), [])

    def test_after_a_function_the_next_name_is_read(self):
        text = "namespace a { template <class T, int n> T f(std::vector<T> x) { if (x) { } } struct B { }; }"
        self.assertEqual([name for name, _ in definitions_in(text)],
                         ["a f(std :: vector < T >)", "a type B"])

    def test_a_default_in_braces_is_no_body(self):
        text = "namespace a { void f(std::vector<int> x = {1, 2}); struct B { }; }"
        self.assertEqual([name for name, _ in definitions_in(text)], ["a type B"])


if __name__ == "__main__":
    if sys.argv[1:] == ["list"]:
        sys.exit("\n".join(duplicates_in(sources())))
    unittest.main()
