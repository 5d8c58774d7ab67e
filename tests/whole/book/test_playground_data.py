"""What lies beside the page of the playground is what the programs make, byte by byte."""

import json
import os
import unittest
from pathlib import Path

from support import ROOT
from playground.data import ENDINGS, PAGE, PROGRAM, SCENES, pack_scene, packed_scene, scene_file

BUILD = Path(os.environ.get("RAYSTEPS_BOOK", ROOT / "build" / "default" / "book")).parent
DATA = ROOT / PAGE / "data"
REPAIR = "Run: cmake --build --preset default --target playground_scene && python3 -B scripts/playground data"
LARGEST = 1_000_000  # bytes of all data together


class PlaygroundData(unittest.TestCase):
    def test_each_shader_of_the_page_has_the_bytes_of_its_file(self):
        script = (DATA / "shaders.js").read_text(encoding="utf-8")
        made = json.loads(script[script.index("({") + 1:script.rindex(")")])
        parts = {path for path in made if "/" in path}
        self.assertEqual(parts, {path.relative_to(ROOT / "shaders").as_posix()
                                 for path in (ROOT / "shaders").rglob("*") if path.suffix in ENDINGS}, REPAIR)
        for path, text in made.items():
            file = ROOT / "shaders" / path if path in parts else ROOT / PAGE / "engine" / path
            self.assertEqual(text.encode(), file.read_bytes(), f"{path}: {REPAIR}")

    def test_each_scene_of_the_page_has_the_bytes_that_the_program_writes(self):
        self.assertTrue((BUILD / PROGRAM).exists(), REPAIR)
        for name in SCENES:
            with self.subTest(scene=name):
                kept = packed_scene((DATA / scene_file(name)).read_text())
                self.assertTrue(kept == pack_scene(BUILD, name), f"{name}: {REPAIR}")

    def test_the_page_names_all_data_and_nothing_else_and_is_small(self):
        page = (ROOT / PAGE / "index.html").read_text()
        files = sorted(path.name for path in DATA.iterdir())
        self.assertEqual(files, sorted(["shaders.js", *map(scene_file, SCENES)]))
        for name in files:
            self.assertIn(f'src="data/{name}"', page)
        self.assertLess(sum((DATA / name).stat().st_size for name in files), LARGEST)


if __name__ == "__main__":
    unittest.main()
