"""The playground in a browser, opened from the disk: the programs, the bits of its hits, and what a reader may do to it."""

import array
import base64
import json
import os
import random
import struct
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

from selenium.webdriver.common.keys import Keys

from browser import STORE, leave_without, start_browser
from support import ROOT
from book.serve import make_server
from playground.data import PAGE, packed_in, scene_file

PROGRAM = STORE.parent / "chapters" / "06_bvh" / "06_bvh"
RAYS = 16384
SCENE = "mirrors"
ADDRESS = (ROOT / PAGE / "index.html").as_uri()

# Runs the body of an asynchronous function in the page, and gives what it returns.
RUN = """
const done = arguments[arguments.length - 1];
const given = arguments[0];
(async () => { %s })().then((value) => done({ value }), (error) => done({ error: `${error.name}: ${error.message}` }));
"""

# Every program of the catalogue goes through the compiler; linked is each pass and each part once, since that takes longer.
COMPILE = """
const { play } = Raysteps;
const gpu = play.openGpu();
const { gl } = gpu;
const programs = play.listPrograms();
const inDouble = programs.filter(({ pass, parts }) => play.filesOf(pass, parts).some((file) => play.needsDouble(play.files[file])));
const rest = programs.filter((program) => !inDouble.includes(program));
const compiled = rest.map(({ pass, parts }) => {
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
  const names = [pass, ...Object.values(parts)];
  if (names.every((name) => seen.has(name))) continue;
  names.forEach((name) => seen.add(name));
  try { gpu.program(pass, parts); linked += 1; } catch (error) { faults.push(`${pass} ${JSON.stringify(parts)}: ${error.message}`); }
}
gl.getExtension("WEBGL_lose_context").loseContext();
return { programs: programs.length, faults, linked, inDouble: inDouble.map(({ parts }) => parts.triangle) };
"""

# The rays of the file through each walk: how many hits have other bits than those of the program.
COMPARE = """
const { play } = Raysteps;
const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
const numbers = new Float32Array(bytes(given.rays));
const expected = new Uint32Array(bytes(given.hits));
const gpu = globalThis.testGpu ??= play.openGpu();
const scene = await play.openScene(given.scene);
const rays = play.listedRays(gpu, numbers);
const differing = {};
for (const walk of play.walkNames()) {
  const result = await play.trace(gpu, scene, rays, { walk, triangle: "watertight", trial: false });
  const words = play.readHits(gpu, result);
  play.release(gpu, result);
  differing[walk] = result.stopped ? result.stopped.sentence : 0;
  for (let i = 0; i < expected.length && !result.stopped; i += 4) {
    differing[walk] += [0, 1, 2, 3].some((j) => words[i + j] !== expected[i + j]);
  }
}
return differing;
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


class PlaygroundTest(unittest.TestCase):
    """Tests that share one browser, and what a reader does to the page."""

    @classmethod
    def setUpClass(cls):
        cls.browser = start_browser()
        cls.browser.set_script_timeout(200)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def setUp(self):
        self.browser.get_log("browser")
        self.addCleanup(self.browser.execute_script, "localStorage.clear()")

    def open(self, address=ADDRESS):
        self.browser.get(address)
        self.wait_for("picture")

    def run_in_page(self, body, given=None):
        """In a page of the playground that stands still."""
        if not self.browser.current_url.startswith(("file:", "http:")):
            self.open()
        answer = self.browser.execute_async_script(RUN % body, given or {})
        self.assertNotIn("error", answer)
        return answer["value"]

    def wait_for(self, *states, seconds=60):
        state = None
        for _ in range(seconds * 20):
            state = self.browser.execute_script("return document.body.dataset.state")
            if state in states:
                return state
            time.sleep(0.05)
        self.fail(f"the page is {state}, not {states}: {self.said()}")

    def wait_until(self, script, seconds=60):
        for _ in range(seconds * 20):
            found = self.browser.execute_script(script)
            if found:
                return found
            time.sleep(0.05)
        return self.fail(f"this did not become true: {script}")

    def said(self):
        return self.browser.find_element("id", "said").text

    def choose(self, name, value):
        self.browser.execute_script(
            "const select = document.getElementById(arguments[0]); select.value = arguments[1];"
            "document.body.dataset.state = 'asked'; select.dispatchEvent(new Event('change'))", name, value)

    def type_over(self, old, new):
        """As if a reader had changed these characters of the open file."""
        self.browser.execute_script(
            "const area = document.querySelector('textarea'); const [old, text] = arguments;"
            "if (!area.value.includes(old)) throw new Error(`the text has no ${old}`);"
            "area.value = area.value.replace(old, () => text); document.body.dataset.state = 'typed';"
            "area.dispatchEvent(new Event('input'))", old, new)

    def line_of(self, words):
        text = self.browser.execute_script("return document.querySelector('textarea').value")
        return 1 + text[:text.index(words)].count("\n")

    def complaints(self):
        return [entry["message"] for entry in self.browser.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]

    def keep_picture(self, name):
        """A screenshot, for a person to look at."""
        folder = STORE / "screenshots"
        folder.mkdir(parents=True, exist_ok=True)
        self.browser.save_screenshot(str(folder / f"{name}.png"))


class Playground(PlaygroundTest):
    def test_every_program_without_double_compiles(self):
        found = self.run_in_page(COMPILE)
        self.assertEqual(found["faults"], [])
        self.assertEqual(set(found["inDouble"]), {"triangle/watertight_fallback.glsl"})
        self.assertGreater(found["programs"] - len(found["inDouble"]), 400)
        self.assertGreater(found["linked"], 60)

    def test_every_walk_gives_the_bits_of_the_program(self):
        rays = make_rays(corners_of(SCENE), RAYS, 1)
        hits = hits_of_the_program(rays)
        meet = sum(triangle >= 0 for *_, triangle in struct.iter_unpack("<fffi", hits))
        self.assertGreater(meet, RAYS // 2)
        differing = self.run_in_page(COMPARE, {"scene": SCENE, "rays": base64.b64encode(rays).decode(),
                                               "hits": base64.b64encode(hits).decode()})
        self.assertGreater(len(differing), 14)
        self.assertEqual(differing, dict.fromkeys(differing, 0))

    def test_a_page_from_the_disk_shows_a_picture_and_asks_nothing_of_anybody(self):
        self.open()
        self.assertIn("This is the project's own text", self.said())
        colors = self.browser.execute_script(
            "const canvas = document.getElementById('mine'); const { data } = canvas.getContext('2d').getImageData("
            "0, 0, canvas.width, canvas.height); return new Set(new Uint32Array(data.buffer)).size")
        self.assertGreater(colors, 500)
        loaded = self.browser.execute_script("return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([name for name in loaded if not name.startswith("file://")], [])
        self.assertEqual(self.complaints(), [])

    def test_a_page_from_a_server_may_ask_nobody(self):
        server = make_server(ROOT / PAGE, 0)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            own = f"http://127.0.0.1:{server.server_port}/"
            self.open(own)
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
                await new Promise((resolve) => setTimeout(resolve, 300));
                return refused;""")
            self.assertEqual(set(refused), {"connect-src", "img-src", "script-src-elem"})
        finally:
            server.shutdown()
            server.server_close()

    def test_an_edited_line_shows_what_it_changes_and_is_there_after_a_reload(self):
        self.open()
        self.choose("view", "visits")
        self.wait_for("picture")
        self.type_over("node + 1 : here.skip", "node + 2 : here.skip")
        self.wait_for("picture")
        self.assertRegex(self.said(), r"[\d,]+ of 65,536 pixels differ from the project's, first at \(\d+, \d+\)")
        self.browser.find_element("id", "mine").click()
        self.assertRegex(self.browser.find_element("id", "pixel").text, r"Yours: .*visits.*Right: .*visits")
        self.browser.set_window_size(1280, 900)
        self.keep_picture("playground")
        self.open()
        self.assertIn("differ from the project's", self.said())
        self.browser.find_element("id", "reset").click()
        self.browser.execute_script("document.body.dataset.state = 'asked'")
        self.wait_for("picture")
        self.assertIn("This is the project's own text", self.said())

    def test_a_typo_is_told_in_words_at_its_line_and_the_last_good_picture_stays(self):
        self.open()
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

    def test_a_loop_without_an_end_is_stopped_and_its_line_named(self):
        self.open()
        for endless in ("while (true) {}", "for (;;) {}", "for (int i = 0; i >= 0; i = 0) { ++n; }"):
            with self.subTest(endless=endless):
                self.type_over("Hit nearest = walk.nearest;", f"Hit nearest = walk.nearest;\n    int n = 0; {endless}")
                self.wait_for("picture")
                self.assertRegex(self.said(), r"A loop without an end was stopped in [\d,]+ pixels, first at \(\d+, \d+\)")
                self.assertIn(f"structure/bvh/bvh_ordered.glsl:{self.line_of(endless)}:", self.said())
                self.type_over(f"\n    int n = 0; {endless}", "")
                self.wait_for("picture")
                self.assertIn("This is the project's own text", self.said())

    def test_a_loop_without_an_end_in_packets_is_stopped_and_its_line_named(self):
        self.open()
        self.choose("walk", "packet_bvh4")
        self.wait_for("picture")
        self.browser.execute_script(
            "const select = document.getElementById('file'); select.value = 'structure/bvh/packet_bvh4.glsl';"
            "select.dispatchEvent(new Event('change'))")
        self.type_over("PacketWalk walk_packet(Ray rays[4], real near_enough, int rounds) {",
                       "PacketWalk walk_packet(Ray rays[4], real near_enough, int rounds) {\n    while (true) {}")
        self.wait_for("picture")
        self.assertIn(f"structure/bvh/packet_bvh4.glsl:{self.line_of('while (true)')}:", self.said())

    def test_a_walk_that_comes_to_no_end_is_stopped(self):
        self.open()
        self.type_over("node = met && !is_bvh_leaf(here) ? node + 1 : here.skip;", "node = node;")
        self.wait_for("picture")
        self.assertRegex(self.said(), r"Walks without an end were stopped in [\d,]+ pixels, first at \(\d+, \d+\)")

    def test_a_long_run_stops_when_it_is_told(self):
        self.open()
        self.choose("scene", "mirrors")
        self.wait_for("picture")
        self.choose("walk", "every_triangle")
        self.wait_for("running")
        self.browser.find_element("id", "stop").click()
        self.wait_for("stopped", seconds=5)
        self.assertIn("Stopped", self.said())

    def test_texts_that_are_too_long_are_refused_in_words(self):
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
        self.open()
        self.type_over("Hit nearest", "/*" + "x" * 70000 + "*/ Hit nearest")
        self.wait_for("errors")
        self.assertIn("Shorten it", self.said())

    def test_a_lost_context_is_rebuilt_once_without_running_the_text(self):
        self.open()
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

    def test_on_a_phone_nothing_is_wider_than_the_screen(self):
        self.open()
        self.type_over("node + 1 : here.skip", "node + 2 : here.skip")
        self.wait_for("picture")
        try:
            self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                "width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": False})
            self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth"), 390)
            self.keep_picture("playground_narrow")
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


if __name__ == "__main__":
    leave_without("chromium", "chromedriver")
    if not PROGRAM.exists():
        raise SystemExit(f"{PROGRAM} is missing. Build the target 06_bvh.")
    unittest.main(verbosity=2 if os.environ.get("VERBOSE") else 1)
