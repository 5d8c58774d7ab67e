"""Files of --json: each is what its schema says, key by key, and under the one head of all."""

import copy
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import jsonschema

ROOT = Path(__file__).resolve().parents[3]
CHAPTERS = Path(os.environ["RAYSTEPS_CHAPTERS"])
SMALL = ["--scene", "compact:4", "--size", "16"]

# Every program, in every way that writes figures.
RUNS = {
    "generations": ("01_rays", SMALL),
    "trace": ("02_triangles", SMALL),
    "exhibit": ("02_triangles", ["--scene", "compact:4", "--exhibit"]),
    "shading": ("03_shading", SMALL),
    "walks": ("04_grid", [*SMALL, "--measure"]),
    "resolutions": ("04_grid", [*SMALL, "--plot"]),
    "trace of 06": ("06_bvh", [*SMALL, "--split", "median"]),
    "walks of 06": ("06_bvh", [*SMALL, "--measure"]),
    "compare": ("07_compare", [*SMALL, "--rounds", "1", "--growth", "1", "--structure", "bvh_ordered,kd_ropes:depth=5"]),
    "builds": ("07_compare", ["--builds", "--scenes", "compact:4", "--rounds", "1"]),
    "accuracy": ("08_accuracy", [*SMALL, "--trade-offs", "triangle", "--rounds", "1"]),
    "effects": ("09_effects", SMALL),
    "proof": ("09_effects", ["--prove", "--scenes", "compact:4,glass_box", "--rounds", "1", "--size", "16"]),
    "climb": ("10_speed", [*SMALL, "--rounds", "1"]),
    "paths": ("11_paths", ["--scene", "cornell_box", "--size", "16", "--samples", "32"]),
    "check": ("check", ["--scene", "compact:4", "--tree", "FOLDER/own.rstree", "--rays", "FOLDER/rays.csv"]),
    "hard_cases": ("hard_cases", ["--case", "T1", "--rays", "100", "--by", "cpp"]),
}


def schema_files():
    return {path.name: path for folder in ("common", "chapters")
            for path in (ROOT / folder).rglob("*.schema.json")}


def load_schema(path):
    """A schema with those in it that it names by their files."""
    definitions = {}

    def put_in(node, folder):
        if isinstance(node, list):
            return [put_in(one, folder) for one in node]
        if not isinstance(node, dict):
            return node
        target = node.get("$ref", "#")
        if target.startswith("#"):
            return {name: put_in(value, folder) for name, value in node.items()}
        file = folder / target
        other = put_in(json.loads(file.read_text()), file.parent)
        definitions.update(other.pop("$defs", {}))
        return other

    schema = put_in(json.loads(path.read_text()), path.parent)
    schema["$defs"] = {**schema.get("$defs", {}), **definitions}
    return schema


def complaints(file, schema):
    return [f"{'/'.join(map(str, one.absolute_path))}: {one.message}"
            for one in jsonschema.Draft202012Validator(schema).iter_errors(file)]


def head_of_tree(folder, structure):
    """The head of the tree file that check writes of that structure."""
    path = folder / f"{structure}.rstree"
    subprocess.run([CHAPTERS / "check" / "check", "--scene", "compact:4", "--structure", structure, "--export", path],
                   capture_output=True, check=True, timeout=120)
    data = path.read_bytes()
    return json.loads(data[24:24 + int.from_bytes(data[16:24], "little")])


def nodes(tree, path=()):
    """Every object in it, with its place."""
    if isinstance(tree, dict):
        yield path, tree
    for name, value in (tree.items() if isinstance(tree, dict) else
                        enumerate(tree) if isinstance(tree, list) else ()):
        yield from nodes(value, (*path, name))


def at(tree, path):
    for name in path:
        tree = tree[name]
    return tree


class FilesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="raysteps_test_figures_")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.files = {}
        cls.heads = {}
        for structure in ("bvh_ordered", "kd_ropes", "grid", "bvh4"):
            cls.heads[structure] = head_of_tree(Path(cls.folder.name), structure)
        (Path(cls.folder.name) / "own.rstree").write_bytes((Path(cls.folder.name) / "bvh_ordered.rstree").read_bytes())
        (Path(cls.folder.name) / "rays.csv").write_text(
            "origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,t_min,t_max\n0,0,9,0,0,-1,0,inf\n")
        for name, (program, options) in RUNS.items():
            path = Path(cls.folder.name) / f"{name}.json"
            run = subprocess.run(
                [CHAPTERS / program / program, *(word.replace("FOLDER", cls.folder.name) for word in options), "--out", cls.folder.name, "--json", path],
                capture_output=True, text=True, timeout=120, check=False)
            if run.returncode != 0:
                raise AssertionError(f"{program} {options}: {run.stderr}")
            cls.files[name] = json.loads(path.read_text())

    def schema_of(self, name):
        return load_schema(schema_files()[self.files[name]["head"]["schema"]])

    def test_every_file_is_valid_by_the_schema_that_it_names(self):
        for name, file in self.files.items():
            with self.subTest(name):
                self.assertEqual(file["head"]["schema"], name.split()[0] + ".schema.json")
                self.assertEqual(complaints(file, self.schema_of(name)), [])

    def test_every_schema_of_a_file_has_a_file_here(self):
        parts = {"head.schema.json", "scene_costs.schema.json"}
        self.assertEqual({file["head"]["schema"] for file in self.files.values()},
                         set(schema_files()) - parts)

    def test_a_key_that_a_schema_lacks_is_found_wherever_a_program_writes_it(self):
        for name, file in self.files.items():
            schema = self.schema_of(name)
            kinds = {tuple("*" if isinstance(step, int) else step for step in path): path
                     for path, _ in nodes(file)}
            for path in kinds.values():
                more = copy.deepcopy(file)
                at(more, path)["surprise"] = []
                with self.subTest(name, path=path):
                    self.assertNotEqual(complaints(more, schema), [])

    def test_a_head_tells_machine_and_scene_and_builders(self):
        head = self.files["trace of 06"]["head"]
        self.assertEqual(head["builders"]["bvh_ordered"]["split"], "median")
        self.assertIn("leaf-triangles", head["builders"]["bvh_ordered"])
        self.assertEqual([scene["scene"] for scene in head["scenes"]], ["compact:4"])
        self.assertEqual(head["cores"], len(os.sched_getaffinity(0)))
        self.assertTrue(head["renderer"])
        self.assertIsNone(self.files["hard_cases"]["head"]["renderer"])  # no context was made
        hashes = {scene["hash"] for file in self.files.values() for scene in file["head"]["scenes"]
                  if scene["scene"] == "compact:4"}
        self.assertEqual(len(hashes), 1)

    def test_the_head_of_every_tree_file_is_what_its_schema_says(self):
        schema = json.loads((ROOT / "docs" / "tree_file.schema.json").read_text())
        for structure, head in self.heads.items():
            with self.subTest(structure):
                self.assertEqual(complaints(head, schema), [])
                lacking = copy.deepcopy(head)
                del lacking["arrays"]["order"]
                self.assertNotEqual(complaints(lacking, schema), [])
                self.assertNotEqual(complaints({**head, "surprise": 1}, schema), [])

    def test_two_files_tell_the_same_of_the_same(self):
        walks = {"walks of 06": self.files["walks of 06"]["scenes"][0],
                 "compare": self.files["compare"]["scenes"][0]}
        keys = [set(scene["kinds"][0]["walks"][0]) - {"to_embree"} for scene in walks.values()]
        self.assertEqual(*keys)


class SchemasTest(unittest.TestCase):
    def test_every_object_says_which_keys_it_may_have(self):
        for name, path in schema_files().items():
            for place, node in nodes(json.loads(path.read_text())):
                if node.get("type") == "object":
                    with self.subTest(name, place=place):
                        self.assertIn("additionalProperties", node)
                        self.assertEqual("properties" in node, node["additionalProperties"] is False)

    def test_a_name_is_of_one_type_wherever_it_stands(self):
        # Of these, another reader needs another thing.
        apart = {"faults", "error", "median"}
        types = {}
        for name, path in schema_files().items():
            for _, node in nodes(json.loads(path.read_text())):
                for key, value in node.get("properties", {}).items():
                    kind = value.get("type", "integer" if "const" in value else
                                     "string" if "enum" in value else "object")
                    if key not in apart:
                        types.setdefault(key, {}).setdefault(json.dumps(kind), []).append(name)
        self.assertEqual({key: found for key, found in types.items() if len(found) > 1}, {})


class CommitTest(unittest.TestCase):
    """cmake/write_commit.cmake, which runs at each build."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="raysteps_test_commit_")
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "tree"
        (self.root / "common").mkdir(parents=True)
        (self.root / "common" / "a.h").write_text("a")

    def git(self, *words):
        return subprocess.run(
            ["git", "-c", "user.name=a", "-c", "user.email=a@b", "-C", self.root, *words],
            capture_output=True, text=True, check=True).stdout.strip()

    def written(self, root):
        file = self.root.parent / "commit.inc"
        subprocess.run([os.environ["RAYSTEPS_CMAKE"], "-D", f"ROOT={root}", "-D", f"FILE={file}", "-P",
                        ROOT / "cmake" / "write_commit.cmake"], check=True, capture_output=True)
        return file.read_text()

    def test_a_tree_outside_of_git_has_no_commit(self):
        self.assertIn('"unknown"', self.written(self.root))

    def test_a_clean_tree_and_a_changed_one_are_told_apart(self):
        self.git("init", "-q")
        self.git("add", ".")
        self.git("commit", "-q", "-m", "a")
        clean = self.written(self.root)
        self.assertIn(self.git("rev-parse", "HEAD"), clean)
        self.assertIn("= false", clean)
        (self.root / "notes.txt").write_text("no part of a program")
        self.assertIn("= false", self.written(self.root))
        (self.root / "common" / "new.h").write_text("b")
        self.assertIn("= true", self.written(self.root))

    def test_a_folder_of_another_repository_has_no_commit(self):
        self.git("init", "-q")
        self.git("add", ".")
        self.git("commit", "-q", "-m", "a")
        self.assertIn('"unknown"', self.written(self.root / "common"))


if __name__ == "__main__":
    unittest.main()
