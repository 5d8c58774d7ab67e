"""The playground in a browser, opened from the disk: the programs, the bits of its hits, and what a reader may do to it."""

import array
import base64
import json
import os
import random
import re
import struct
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

from selenium.webdriver.common.keys import Keys

from browser import STORE, leave_without
from playground_page import PHONE, RESET, PlaygroundTest
from support import ROOT
from book.serve import make_server
from playground.data import PAGE, packed_in, scene_file

PROGRAM = STORE.parent / "chapters" / "06_bvh" / "06_bvh"
SHADERS = {"shaded": STORE.parent / "chapters" / "03_shading" / "03_shading", "effects": STORE.parent / "chapters" / "09_effects" / "09_effects"}
RAYS = 16384  # for each structure; its other walks have fewer
FEWER_RAYS = 2048
SHADED_SIZE = 96
SAME = 1e-4  # of colours: highlights have powers, which each platform rounds in its own way (1.1e-5 on SwiftShader)
SCENE = "mirrors"
# Every program of the catalogue goes through the compiler; linked is each pass and each part once, since that takes longer.
COMPILE = """
const { play } = Raysteps;
const gpu = play.openGpu();
const { gl } = gpu;
const programs = play.listPrograms();
const inDouble = programs.filter(({ pass, parts }) => play.filesOf(pass, parts).some((file) => play.needsDouble(play.files[file])));
const rest = programs.filter((program) => !inDouble.includes(program));
const compiled = (given.all ? rest : []).map(({ pass, parts }) => {
  const shader = gl.createShader(gl.FRAGMENT_SHADER);
  gl.shaderSource(shader, play.readShader(pass, parts).text);
  gl.compileShader(shader);
  return { pass, parts, shader };
});
const faults = compiled.filter(({ shader }) => !gl.getShaderParameter(shader, gl.COMPILE_STATUS)).map(({ pass, parts, shader }) =>
  `${pass} ${JSON.stringify(parts)}: ${gl.getShaderInfoLog(shader)}`);
const seen = new Set();
let linked = 0;
for (const { pass, parts } of rest) {
  const names = given.slots ? Object.keys(parts) : [pass, ...Object.values(parts)];
  if (names.every((name) => seen.has(name))) continue;
  names.forEach((name) => seen.add(name));
  try { gpu.program(pass, parts); linked += 1; } catch (error) { faults.push(`${pass} ${JSON.stringify(parts)}: ${error.message}`); }
}
gl.getExtension("WEBGL_lose_context").loseContext();
return { programs: programs.length, faults, linked, inDouble: inDouble.map(({ parts }) => parts.triangle) };
"""

# The rays of the file through each walk: how many hits have other bits than those of the program. A walk has them all where it is
# the first of its structure.
COMPARE = """
const { play } = Raysteps;
const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
const numbers = new Float32Array(bytes(given.rays));
const expected = new Uint32Array(bytes(given.hits));
const { gpu } = play.page;
const scene = await play.openScene(given.scene);
const [all, few] = [numbers, numbers.subarray(0, 8 * given.fewer)].map((list) => play.listedRays(gpu, list));
const asked = {};
const differing = {};
for (const walk of play.walkNames()) {
  const { name } = play.familyOf(scene, walk);
  const count = Object.keys(asked).some((other) => play.familyOf(scene, other).name === name) ? given.fewer : numbers.length / 8;
  asked[walk] = count;
  const result = await play.trace(gpu, scene, count === given.fewer ? few : all, { walk, triangle: "watertight", trial: false });
  const words = play.readHits(gpu, result);
  play.release(gpu, result);
  differing[walk] = result.stopped ? result.stopped.sentence : 0;
  for (let i = 0; i < 4 * count && !result.stopped; i += 4) {
    differing[walk] += [0, 1, 2, 3].some((j) => words[i + j] !== expected[i + j]);
  }
}
return { asked, differing };
"""


# The lit picture of the page against the program's, number by number.
SHADED = """
const { play } = Raysteps;
const expected = new Uint32Array(Uint8Array.from(atob(given.expected), (letter) => letter.charCodeAt(0)).buffer);
const { gpu } = play.page;
const size = Math.sqrt(expected.length / 3);
const scene = await play.openScene(given.scene);
const rays = play.cameraRays(gpu, scene, size);
const tracing = { walk: "bvh_ordered", triangle: "watertight" };
const traced = await play.trace(gpu, scene, rays, { ...tracing, trial: false });
const { linear } = await play.shade(gpu, scene, rays, traced, { ...tracing, plan: play.planOf(given.view, scene) });
const words = new Uint32Array(linear.buffer);
const colors = new Float32Array(expected.buffer);
let differing = 0;
let most = 0;
for (let pixel = 0; pixel < size * size; ++pixel) {
  differing += [0, 1, 2].some((i) => words[4 * pixel + i] !== expected[3 * pixel + i]);
  most = Math.max(most, ...[0, 1, 2].map((i) => Math.abs(linear[4 * pixel + i] - colors[3 * pixel + i])));
}
return { differing, most, lit: linear.some((value) => value > 0.5) };
"""

# What the page plans for a scene, in the words of `09_effects --explain`.
PLAN = """
const { play } = Raysteps;
const { effects, passes } = play.planOf("effects", await play.openScene(given.scene), given.all);
const partsOf = ({ parts }) => Object.keys(parts).filter((slot) => slot !== "real").sort().map((slot) => parts[slot]).join(", ");
return { effects: effects.filter(({ isOn }) => isOn).map(({ name }) => name), passes: passes.map((pass) => pass.name + (partsOf(pass) && ` with ${partsOf(pass)}`)) };
"""


def corners_of(name):
    """The corners of a scene's triangles, three numbers each, as the page has them."""
    packed = packed_in((ROOT / PAGE / "data" / scene_file(name)).read_text())
    length = struct.unpack("<I", packed[:4])[0]
    entry = next(each for each in json.loads(packed[4:4 + length])["arrays"] if each["name"] == "triangle_corners")
    numbers = array.array("f", packed[4 + length + entry["start"]:][:entry["bytes"]])
    return list(zip(numbers[::3], numbers[1::3], numbers[2::3]))


def make_rays(corners, count, seed):
    """Half of them go to corners and points of edges, where hits are hard to decide, some along an axis, the rest anywhere."""
    choose = random.Random(seed)
    largest = max(abs(x) for corner in corners for x in corner)
    numbers = array.array("f")
    for i in range(count):
        origin = [choose.uniform(-1.5, 1.5) * largest for _ in range(3)]
        triangle = 3 * choose.randrange(len(corners) // 3)
        a, b = (corners[triangle + corner] for corner in choose.sample(range(3), 2))
        share = (0.0, choose.random())[i % 2]
        target = [p + share * (q - p) for p, q in zip(a, b)]
        if i % 4 >= 2:
            target = [choose.uniform(-1.0, 1.0) * largest for _ in range(3)]
        if i % 16 == 15:
            origin[:2] = target[:2]
        numbers.extend([*origin, *(t - o for t, o in zip(target, origin)), 0.0, 1e30])
    return numbers.tobytes()


def hits_of_the_program(rays):
    """What the C++ program answers."""
    with tempfile.TemporaryDirectory(prefix="raysteps_playground_") as folder:
        asked, answered = Path(folder) / "rays.f32", Path(folder) / "hits.f32"
        asked.write_bytes(rays)
        subprocess.run([PROGRAM, "--scene", SCENE, "--rays", asked, "--hits", answered], check=True, stdout=subprocess.DEVNULL)
        return answered.read_bytes()


def planned_by_the_program(scene, choice):
    """The effects and the passes that `09_effects --explain` names."""
    with tempfile.TemporaryDirectory(prefix="raysteps_playground_") as folder:
        said = subprocess.run([SHADERS["effects"], "--scene", scene, "--size", "8", "--explain", *choice, "--out", folder],
                              check=True, capture_output=True, text=True).stdout
    return {"effects": re.findall(r"^effect +(\w+):", said, re.MULTILINE), "passes": re.findall(r"^pass +(.+)$", said, re.MULTILINE)}


def expected_picture(view):
    """What the C++ program shades: three floats a pixel, the bottom row first."""
    with tempfile.TemporaryDirectory(prefix="raysteps_playground_") as folder:
        subprocess.run([SHADERS[view], "--scene", SCENE, "--size", str(SHADED_SIZE), "--structure", "bvh_ordered", "--out", folder],
                       check=True, stdout=subprocess.DEVNULL)
        file = next(Path(folder).rglob("*.pfm")).read_bytes()
    return base64.b64encode(file[-12 * SHADED_SIZE * SHADED_SIZE:]).decode()


class Playground(PlaygroundTest):
    def test_every_program_without_double_compiles(self):
        self.begin()
        found = self.run_in_page(COMPILE, {"all": True, "slots": False})
        self.assertEqual(found["faults"], [])
        self.assertEqual(set(found["inDouble"]), {"triangle/watertight_fallback.glsl"})
        self.assertGreater(found["programs"] - len(found["inDouble"]), 400)
        self.assertGreater(found["linked"], 60)

    def test_every_walk_gives_the_bits_of_the_program(self):
        rays = make_rays(corners_of(SCENE), RAYS, 1)
        hits = hits_of_the_program(rays)
        meet = sum(triangle >= 0 for *_, triangle in struct.iter_unpack("<fffi", hits))
        self.assertGreater(meet, RAYS // 2)
        self.begin()
        found = self.run_in_page(COMPARE, {"scene": SCENE, "rays": base64.b64encode(rays).decode(), "fewer": FEWER_RAYS,
                                           "hits": base64.b64encode(hits).decode()})
        self.assertGreater(len(found["differing"]), 14)
        self.assertEqual(found["differing"], dict.fromkeys(found["differing"], 0))
        self.assertEqual(sum(count == RAYS for count in found["asked"].values()), 6)

    def test_a_page_from_the_disk_shows_a_picture_asks_nobody_and_keeps_what_is_changed(self):
        self.open()
        self.assertIn("This is the project's own text", self.said())
        colors = self.browser.execute_script(
            "const canvas = document.getElementById('mine'); const { data } = canvas.getContext('2d').getImageData("
            "0, 0, canvas.width, canvas.height); return new Set(new Uint32Array(data.buffer)).size")
        self.assertGreater(colors, 500)
        loaded = self.browser.execute_script("return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([name for name in loaded if not name.startswith("file://")], [])
        self.choose("view", "visits")
        self.wait_for("picture")
        self.type_over("node + 1 : here.skip", "node + 2 : here.skip")
        self.wait_for("picture")
        self.assertRegex(self.said(), r"[\d,]+ of 65,536 pixels differ from the project's, first at \(\d+, \d+\)")
        self.browser.find_element("id", "mine").click()
        self.assertRegex(self.text("pixel"), r"Yours: .*visits.*Right: .*visits")
        self.keep_picture("playground")
        self.keep_picture("playground_narrow", PHONE["width"])
        self.open()
        self.assertIn("differ from the project's", self.said())
        self.browser.execute_script("document.body.dataset.state = 'asked'; document.getElementById('reset').click()")
        self.wait_for("picture")
        self.assertIn("This is the project's own text", self.said())
        self.assertEqual(self.complaints(), [])

    def test_a_page_from_a_server_may_ask_nobody(self):
        server = make_server(ROOT / PAGE, 0)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            own = f"http://127.0.0.1:{server.server_port}/"
            self.open(f"{own}#size=128&scene=tetrahedron:2")
            self.assertEqual(self.complaints(), [])
            loaded = self.browser.execute_script("return performance.getEntriesByType('resource').map((entry) => entry.name)")
            self.assertGreater(len(loaded), 10)
            self.assertEqual([name for name in loaded if not name.startswith(own)], [])
            refused = self.run_in_page("""
                const refused = [];
                addEventListener("securitypolicyviolation", (event) => refused.push(event.effectiveDirective));
                await fetch("index.html").catch(() => {});
                new Image().src = "http://127.0.0.1:1/picture.png";
                document.head.append(Object.assign(document.createElement("script"), { src: "http://127.0.0.1:1/script.js" }));
                for (let i = 0; i < 100 && new Set(refused).size < 3; ++i) await new Promise((resolve) => setTimeout(resolve, 20));
                return refused;""")
            self.assertEqual(set(refused), {"connect-src", "img-src", "script-src-elem"})
        finally:
            server.shutdown()
            server.server_close()

    def test_a_typo_is_told_in_words_at_its_line_and_the_last_good_picture_stays(self):
        self.begin()
        self.type_over("int left = rounds;", "int left = rounds;\n    float way = 2;")
        self.wait_for("errors")
        line = self.line_of("float way")
        self.assertIn(f"structure/bvh/bvh_ordered.glsl:{line}: WebGL has no implicit conversion", self.said())
        self.assertIn("2.0f", self.said())
        self.assertEqual(self.browser.execute_script(
            "return [...document.querySelectorAll('#editor .marked')].map((e) => 1 + [...e.parentNode.children].indexOf(e))"), [line])
        self.assertLess(float(self.browser.execute_script("return getComputedStyle(document.querySelector('.figures')).opacity")), 0.6)
        self.type_over("float way = 2;", "float way = 2.0f;")
        self.wait_for("picture")
        self.assertIn("the same bits", self.said())

    def test_what_has_no_end_is_stopped_and_its_line_named(self):
        self.begin()
        for endless in ("while (true) {}", "for (;;) {}", "for (int i = 0; i >= 0; i = 0) { ++n; }"):
            with self.subTest(endless=endless):
                self.type_over("Hit nearest = walk.nearest;", f"Hit nearest = walk.nearest;\n    int n = 0; {endless}")
                self.wait_for("picture")
                self.assertRegex(self.said(), r"A loop without an end was stopped in [\d,]+ pixels, first at \(\d+, \d+\)")
                self.assertIn(f"structure/bvh/bvh_ordered.glsl:{self.line_of(endless)}:", self.said())
                self.type_over(f"\n    int n = 0; {endless}", "")
                self.wait_for("picture")
                self.assertIn("This is the project's own text", self.said())
        with self.subTest("a walk"):
            self.type_over("node = met && !is_bvh_leaf(here) ? node + 1 : here.skip;", "node = node;")
            self.wait_for("picture")
            self.assertRegex(self.said(), r"Walks without an end were stopped in [\d,]+ pixels, first at \(\d+, \d+\)")
        with self.subTest("a packet"):
            self.choose("walk", "packet_bvh4")
            self.wait_for("picture")
            self.browser.execute_script("Raysteps.play.page.open('structure/bvh/packet_bvh4.glsl')")
            self.type_over("PacketWalk walk_packet(Ray rays[4], real near_enough, int rounds) {",
                           "PacketWalk walk_packet(Ray rays[4], real near_enough, int rounds) {\n    while (true) {}")
            self.wait_for("picture")
            self.assertIn(f"structure/bvh/packet_bvh4.glsl:{self.line_of('while (true)')}:", self.said())
        with self.subTest("light"):
            self.browser.execute_script(RESET)
            self.wait_for("picture")
            self.choose("view", "shaded")
            self.wait_for("picture")
            self.browser.execute_script("Raysteps.play.page.open('light/lambert.glsl')")
            self.type_over("bool faces_light(Surface surface, real3 light_position) {", "bool faces_light(Surface surface, real3 light_position) {\n    while (true) {}")
            self.wait_for("picture")
            self.assertIn(f"ran out at light/lambert.glsl:{self.line_of('while (true)')}.", self.said())

    def test_a_long_run_stops_when_it_is_told(self):
        self.begin()
        self.choose("size", "256")
        self.choose("walk", "every_triangle")
        self.wait_for("running")
        self.browser.find_element("id", "stop").click()
        self.wait_for("stopped", seconds=5)
        self.assertIn("Stopped", self.said())

    def test_texts_that_are_too_long_are_refused_in_words(self):
        self.begin()
        refused = self.run_in_page("""
            const { play } = Raysteps;
            const bomb = Array.from({ length: 30 }, (_, i) => `#define m${i + 1} m${i} + m${i}`).join("\\n");
            const nested = `#define twice(x) ((x) + (x))\\nfloat a = ${"twice(".repeat(40)}1.0f${")".repeat(40)};`;
            return ["x".repeat(70000), `#define m0 1\\n${bomb}\\nint a = m30;`, nested,
              "#define square(x) ((x) * (x))\\nfloat a = square(2.0f);", ...Object.values(play.files)].map(play.refuse);""")
        self.assertIn("70,000 characters", refused[0])
        self.assertIn("macros", refused[1])
        self.assertIn("macros", refused[2])
        self.assertEqual([each for each in refused[3:] if each], [])
        self.type_over("Hit nearest", "/*" + "x" * 70000 + "*/ Hit nearest")
        self.wait_for("errors")
        self.assertIn("Shorten it", self.said())

    def test_the_wavefront_of_chapter_03_has_the_bits_of_the_program(self):
        self.begin()
        self.choose("view", "shaded")
        self.wait_for("picture")
        found = self.run_in_page(SHADED, {"expected": expected_picture("shaded"), "scene": SCENE, "view": "shaded"})
        self.assertEqual(found, {"differing": 0, "most": 0, "lit": True})

    def test_effects_come_and_go_with_what_calls_for_them(self):
        self.begin()
        self.choose("view", "effects")
        self.wait_for("picture")
        self.browser.execute_script("document.getElementById('plan').open = true")
        self.assertRegex(self.text("plan-said"), "light_surface, add_highlight, select_unmirrored, reflect, select_faint")
        self.keep_picture("playground_plan")
        found = self.run_in_page(SHADED, {"expected": expected_picture("effects"), "scene": SCENE, "view": "effects"})
        self.assertLess(found["most"], SAME)
        self.assertTrue(found["lit"])
        for box, passes in (("gloss", "add_highlight"), ("mirrors", "reflect")):
            self.tick(f"plan-{box}")
            self.assertNotIn(passes, self.text("plan-said") + self.text("plan-rows"))
            self.tick(f"plan-{box}")
            self.assertIn(passes, self.text("plan-said"))
        self.tick("plan-mirrors")
        self.tick("plan-all")
        self.assertIn("reflect", self.text("plan-said"))
        self.assertIn("0 of 16,384 pixels differ", self.text("plan-said"))
        self.tick("plan-all")
        self.tick("plan-lamps")
        self.assertEqual(re.findall(r"light_surface|add_highlight|cast_lamp_rays|reflect", self.text("plan-rows")), [])

    def test_a_plan_has_the_effects_and_the_passes_of_the_programs(self):
        self.begin()
        for scene, choice in ((SCENE, ()), ("cornell_box", ()), ("tetrahedron:2", ()), ("tetrahedron:2", ("--effects", "+diffuse,+highlights,+shadows,+mirrors"))):
            with self.subTest(scene=scene, choice=choice):
                wanted = planned_by_the_program(scene, choice)
                self.assertGreater(len(wanted["passes"]), 5)
                self.assertEqual(self.run_in_page(PLAN, {"scene": scene, "all": bool(choice)}), wanted)

    def test_rays_that_no_test_may_lose_leak_through_one_and_not_through_another(self):
        self.begin()
        self.choose("triangle", "moeller_trumbore")
        self.wait_for("picture")
        self.browser.execute_script("document.getElementById('leaks').open = true")
        told = self.wait_until("return /moeller_trumbore: [1-9].* rays got out/.exec(document.getElementById('leaks-said').textContent)?.[0]")
        self.keep_picture("playground_leaks")
        self.assertRegex(told, r"[\d,]+ of 16,384 rays got out")
        self.choose("triangle", "watertight")
        self.wait_until("return document.getElementById('leaks-said').textContent.startsWith('watertight: 0 of 16,384')")

    def tick(self, box):
        self.browser.execute_script("document.body.dataset.state = 'asked'; document.getElementById(arguments[0]).click()", box)
        self.wait_for("picture")

    def test_a_lost_context_is_rebuilt_once_without_running_the_text(self):
        self.begin()
        self.browser.execute_script("globalThis.loser = Raysteps.play.page.gpu.gl.getExtension('WEBGL_lose_context'); loser.loseContext()")
        self.wait_for("lost")
        self.assertIn("Your text is kept", self.said())
        self.browser.execute_script("loser.restoreContext()")
        self.wait_for("restored")
        time.sleep(0.5)
        self.assertEqual(self.browser.execute_script("return document.body.dataset.state"), "restored")
        self.browser.find_element("css selector", "textarea").send_keys(Keys.CONTROL + Keys.ENTER)
        self.wait_for("picture")
        self.browser.execute_script("Raysteps.play.page.gpu.gl.getExtension('WEBGL_lose_context').loseContext()")
        self.wait_for("gone")
        self.assertIn("reload the page", self.said())
        self.assertIn("go_on", self.browser.execute_script("return document.querySelector('textarea').value"))


if __name__ == "__main__":
    leave_without("chromium", "chromedriver")
    if not PROGRAM.exists():
        raise SystemExit(f"{PROGRAM} is missing. Build the target 06_bvh.")
    unittest.main(verbosity=2 if os.environ.get("VERBOSE") else 1)
