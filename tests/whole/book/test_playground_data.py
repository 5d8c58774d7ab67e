"""What lies beside the page of the playground is what the programs make, byte by byte."""

import json
import os
import struct
import unittest
from pathlib import Path

from support import ROOT
from playground.data import ENDINGS, PAGE, PROGRAM, SCENES, chapter_file, offers_script, pack_scene, packed_in, scene_file
from playground.exercises import list_script, pack_chapters, shader_exercises

BUILD = Path(os.environ.get("RAYSTEPS_BOOK", ROOT / "build" / "default" / "book")).parent
DATA = ROOT / PAGE / "data"
REPAIR = "Run: cmake --build --preset default --target playground_scene course_shaders && python3 -B scripts/playground data"
LARGEST = 1_000_000  # bytes of all data together


def asked_in(packed):
    """All but the answers: another processor may round the last digit of a root in another way."""
    length = struct.unpack("<I", packed[:4])[0]
    head, blob = json.loads(packed[4:4 + length]), packed[4 + length:]
    checkpoints = [checkpoint for exercise in head["exercises"] for checkpoint in exercise["checkpoints"]]
    bytes_of = lambda place: place and blob[place["start"]:place["start"] + place["bytes"]]  # noqa: E731
    parts = [(bytes_of(checkpoint.pop("rays")), bytes_of(checkpoint.pop("scene", None)), len(checkpoint.pop("answers")))
             for checkpoint in checkpoints]
    return head, parts


class PlaygroundData(unittest.TestCase):
    def test_each_shader_of_the_page_has_the_bytes_of_its_file(self):
        made = json.loads(packed_in((DATA / "shaders.js").read_text()))
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
                kept = packed_in((DATA / scene_file(name)).read_text())
                self.assertTrue(kept == pack_scene(BUILD, name), f"{name}: {REPAIR}")

    def test_each_chapter_of_the_page_has_the_questions_and_scenes_that_the_program_resolves(self):
        self.assertEqual((DATA / "exercises.js").read_text(), list_script(ROOT, shader_exercises(ROOT)), REPAIR)
        self.assertEqual((DATA / "scenes.js").read_text(), offers_script(SCENES), REPAIR)
        for chapter, made in pack_chapters(ROOT, BUILD):
            with self.subTest(chapter=chapter):
                self.assertTrue(asked_in(packed_in((DATA / chapter_file(chapter)).read_text())) == asked_in(made), REPAIR)

    def test_no_chapter_has_a_solution_or_a_mistake(self):
        listed = (DATA / "exercises.js").read_text()
        for exercise in shader_exercises(ROOT):
            for text in [line.strip() for line in exercise.region.code if len(line) > 40 and line not in exercise.region.stub]:
                self.assertNotIn(json.dumps(text)[1:-1], listed, exercise.number)
            for plant in exercise.plants:
                self.assertNotIn(json.dumps(plant["replace"]), listed, exercise.number)
            packed = packed_in((DATA / chapter_file(exercise.chapter)).read_text())
            head = packed[4:4 + struct.unpack("<I", packed[:4])[0]].decode()
            solution = json.dumps("\n".join(exercise.region.code))[1:-1]
            self.assertNotIn(solution, head, exercise.number)
            for mutation in exercise.mutations:
                self.assertNotIn(json.dumps(mutation["name"]), head, exercise.number)

    def test_the_page_names_all_data_and_nothing_else_and_is_small(self):
        page = (ROOT / PAGE / "index.html").read_text()
        files = sorted(path.name for path in DATA.iterdir())
        chapters = {chapter_file(exercise.chapter) for exercise in shader_exercises(ROOT)}
        self.assertEqual(files, sorted(["exercises.js", "scenes.js", "shaders.js", *chapters, *map(scene_file, SCENES)]))
        for name in ("shaders.js", *map(scene_file, SCENES)):
            self.assertIn(f'src="data/{name}"', page)
        self.assertLess(sum((DATA / name).stat().st_size for name in files), LARGEST)


if __name__ == "__main__":
    unittest.main()
