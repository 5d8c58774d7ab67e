"""The data of the playground: the shaders as one script, and scenes as one script each.

A page that is opened from a disk may load scripts, and nothing else. So what it needs is text in a script."""

import base64
import gzip
import json
import shutil
import struct
import subprocess
import tempfile
from pathlib import Path

from conformance.suite import read_suite, read_triangles

from .exercises import chapter_file, list_script, pack_chapters, shader_exercises

PAGE = "docs/playground"
PROGRAM = "scripts/playground/playground_scene"
PROGRAMS = (PROGRAM, "scripts/course/answers/course_shaders")
SCENES = ("mirrors", "cornell_box", "tetrahedron:2")  # that lie beside the page in the repository
LARGE_SCENES = ("bunny",)  # that only the book offers, and a reader's browser loads when they are chosen
ENGINE_SHADERS = ("prelude.glsl", "leave_no_mark.glsl", "leave_line.glsl", "leave_no_corner.glsl", "probe.frag", "copy_depth.frag", "steps.frag", "observe_steps.glsl")
ENDINGS = (".glsl", ".frag", ".vert")
SUITE = "docs/conformance/suite"  # too large for the repository once more: only the book offers it
WIDTH = 120  # characters in a line of base64


def shader_files(root):
    """Text by path, as the page's reader knows it: of shaders/ from that folder, the page's own by their names."""
    folder = root / "shaders"
    files = {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8")
             for path in sorted(folder.rglob("*")) if path.suffix in ENDINGS}
    return files | {name: (root / PAGE / "engine" / name).read_text(encoding="utf-8") for name in ENGINE_SHADERS}


def packed_script(call, name, packed):
    """A script that hands these bytes to a function of the page: addShaders, addScene, addChapter or addSuite."""
    text = base64.b64encode(gzip.compress(packed, 9, mtime=0)).decode()
    lines = "\n".join(text[i:i + WIDTH] for i in range(0, len(text), WIDTH))
    return f"// Made by `python3 -B scripts/playground data`: do not edit.\nRaysteps.play.{call}({json.dumps(name)}, `{lines}`);\n"


def packed_in(script):
    """The bytes in a script that packed_script has made. Different versions of zlib pack the same bytes differently."""
    return gzip.decompress(base64.b64decode(script.split("`")[-2]))


def offers_script(names):
    """For a page that loads a scene when it is asked for."""
    return "".join(f"Raysteps.play.offerScene({json.dumps(name)}, {json.dumps('data/' + scene_file(name))});\n" for name in names)


def scene_file(name):
    return f"scene_{name.replace(':', '_')}.js"


def pack_scene(build, name):
    """What the program of the build folder writes of a scene."""
    with tempfile.TemporaryDirectory(prefix="raysteps_playground_") as folder:
        file = Path(folder) / "scene.bin"
        subprocess.run([build / PROGRAM, name, file], check=True)
        return file.read_bytes()


def write_data(root, build, folder):
    """Writes all scripts into the folder. Where a script has the same bytes packed already, it stays."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scenes.js").write_text(offers_script(SCENES))
    (folder / "exercises.js").write_text(list_script(root, shader_exercises(root)), encoding="utf-8")
    made = [("addShaders", "shaders", folder / "shaders.js", json.dumps(shader_files(root)).encode())]
    made += [("addScene", name, folder / scene_file(name), pack_scene(build, name)) for name in SCENES]
    made += [("addChapter", name, folder / chapter_file(name), packed) for name, packed in pack_chapters(root, build)]
    for call, name, file, packed in made:
        if not file.exists() or packed_in(file.read_text()) != packed:
            file.write_text(packed_script(call, name, packed))


def write_large_scenes(build, folder, say):
    """The scenes that are too large for the repository, for copy_page. They take some seconds, and are made where they are missing."""
    if not (build / PROGRAM).exists():
        say(f"playground: {build / PROGRAM} is missing, so the book offers small scenes only. Build the target playground_scene.")
        return
    folder.mkdir(parents=True, exist_ok=True)
    for name in LARGE_SCENES:
        file = folder / scene_file(name)
        if not file.exists() or file.stat().st_mtime < (build / PROGRAM).stat().st_mtime:
            say(f"playground: packing {name}")
            file.write_text(packed_script("addScene", name, pack_scene(build, name)))


def pack_suite(root):
    """The small conformance suite as engine/conformance.js reads it: a list of families, then triangles, rays and answers of each."""
    heads, blobs = [], []
    for family in read_suite(root / SUITE, [])[0]:
        triangles = [number for triangle in read_triangles(family.file("obj")) for number in triangle]
        rays, answers = family.file("f32").read_bytes(), family.file("answers").read_bytes()
        heads.append({"name": family.name, "triangles": family.triangles, "rays": family.rays, "answers": len(answers)})
        blobs += [struct.pack(f"<{len(triangles)}f", *triangles), rays, answers]
    head = json.dumps(heads).encode()
    head += b" " * (-len(head) % 4)
    return struct.pack("<I", len(head)) + head + b"".join(blobs)


def _replace_in(file, old, new):
    file.write_text(file.read_text().replace(old, new))


def copy_page(root, large, to, editor=None):
    """The page and all that it needs, with the conformance suite, the large scenes that the folder `large` has, and the editor where there is one."""
    shutil.rmtree(to, ignore_errors=True)
    shutil.copytree(root / PAGE, to)
    if editor:
        shutil.copyfile(editor, to / "codemirror.js")
        _replace_in(to / "index.html", '<script defer src="editor.js">', '<script defer src="codemirror.js"></script>\n<script defer src="editor.js">')
        _replace_in(to / "load.js", '"editor.js"', '"codemirror.js", "editor.js"')
    offers = [name for name in LARGE_SCENES if (large / scene_file(name)).exists()]
    for name in offers:
        shutil.copyfile(large / scene_file(name), to / "data" / scene_file(name))
    (to / "data" / "conformance.js").write_text(packed_script("addSuite", "conformance", pack_suite(root)))
    (to / "data" / "offers.js").write_text(offers_script(offers) + 'Raysteps.play.offerSuite("data/conformance.js");\n')
    own = '<script defer src="editor.js"></script>'
    _replace_in(to / "index.html", own, f'<script defer src="data/offers.js"></script>\n{own}')
