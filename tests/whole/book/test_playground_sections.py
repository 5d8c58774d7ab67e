"""What a reader of the playground passes on and measures: links, steps of a walk, and what the GPU can do."""

import copy
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import jsonschema
from selenium.webdriver.common.keys import Keys

from browser import STORE, leave_without
from support import ROOT
from playground_page import ADDRESS, PHONE, PlaygroundTest
from playground.data import PAGE, pack_suite, packed_script

ALL = "RAYSTEPS_LONG" in os.environ
COMPARE = STORE.parent / "chapters" / "07_compare" / "07_compare"

# The steps of some pixels against a trace of the picture, whose observer keeps a number of all places in their order.
FOLLOW = """
const { play } = Raysteps;
const { gpu } = play.page;
const scene = await play.openScene("mirrors");
const size = 64;
const rays = play.cameraRays(gpu, scene, size);
const faults = [];
let steps = 0;
const known = new Set();
for (const walk of play.walkNames()) {
  if (walk.startsWith("packet_")) continue; // its rays are stepped one by one
  const { name } = play.familyOf(scene, walk);
  if (!given.all && known.has(name)) continue;
  known.add(name);
  const trail = play.files["exhibit/trail_observer.glsl"].replace("observe_test(int triangle) {}", "observe_test(int triangle) { ++counted.z; }");
  const traced = await play.trace(gpu, scene, rays, { walk, triangle: "watertight", observer: "count", trial: false, edits: { "observer/count.glsl": trail } });
  const seen = play.readObservations(gpu, traced);
  for (const pixel of [[32, 32], [20, 25], [40, 18], [0, 0]]) {
    const ray = 4 * ((size - 1 - pixel[1]) * size + pixel[0]);
    const recorded = play.recordSteps(gpu, scene, { walk, triangle: "watertight", size, pixel });
    const visited = walk === "every_triangle" ? [] : recorded.steps.map(({ place }) => place);
    const mixed = visited.reduce((hash, place) => Math.imul(hash ^ place, 16777619) >>> 0, 2166136261);
    const tests = recorded.steps.reduce((sum, { tested }) => sum + tested.length, 0);
    const words = [...play.readHits(gpu, traced).subarray(ray, ray + 4)];
    const last = recorded.steps.at(-1)?.nearest?.words;
    steps += recorded.steps.length;
    if (visited.length !== seen[ray] || tests !== seen[ray + 2] || mixed !== seen[ray + 1]) faults.push(`${walk} ${pixel}: ${visited.length} visits, not ${seen[ray]}; ${tests} tests, not ${seen[ray + 2]}`);
    if (!recorded.ended || String(last) !== String((words[3] | 0) < 0 ? undefined : words)) faults.push(`${walk} ${pixel}: ends at ${last}, not at ${words}`);
    if (recorded.steps.some(({ file, line }) => !/observe_(visit|test)/.test(play.files[file].split("\\n")[line - 1]))) faults.push(`${walk} ${pixel}: names a line that tells nothing`);
    if (recorded.steps.some(({ box }) => !box && walk !== "every_triangle")) faults.push(`${walk} ${pixel}: a place without a box`);
  }
  play.release(gpu, traced);
}
return { faults, steps };
"""


def faults_of(file, schema):
    """What of a file is not as the schema says, and as those say that it names by their files."""
    rules = json.loads(schema.read_text())
    for name, rule in rules["properties"].items():
        if rule.get("$ref", "#")[0] != "#":
            rules["properties"][name] = json.loads((schema.parent / rule["$ref"]).read_text())
    return [f"{'/'.join(map(str, one.absolute_path))}: {one.message}"
            for one in jsonschema.Draft202012Validator(rules).iter_errors(file)]


class Links(PlaygroundTest):
    def link(self):
        self.browser.find_element("id", "copy-link").click()
        self.wait_until("const { value } = document.getElementById('link'); return value && value !== globalThis.lastLink")
        return self.browser.execute_script("return globalThis.lastLink = document.getElementById('link').value")

    def link_said(self):
        return self.browser.find_element("id", "link-said").text

    def state(self):
        return self.browser.execute_script(
            "const { run, looked, file } = Raysteps.play.page; return [run.choices, run.edits, looked(), file()]")

    def test_a_link_brings_back_all_that_was_seen_and_leaves_the_readers_own_texts_alone(self):
        self.begin()
        for name, value in (("scene", "cornell_box"), ("walk", "bvh_skip"), ("view", "visits")):
            self.choose(name, value)
            self.wait_for("picture")
        self.type_over("observe_visit(node);", "observe_visit(node); // \u00fcber <b>all</b> & more")
        self.wait_for("picture")
        self.browser.execute_script("Raysteps.play.page.look(12, 40)")
        before, pixel = self.state(), self.browser.find_element("id", "pixel").text
        self.browser.execute_script("document.getElementById('card').open = true")
        link = self.link()
        self.assertLess(len(link), 6000)
        self.assertIn("open=card", link)
        self.browser.execute_script("localStorage.clear()")
        self.open()
        self.type_over("Hit nearest", "/* my own */ Hit nearest")
        self.wait_for("picture")
        own = self.state()
        self.open(link)
        self.assertEqual(self.state(), before)
        self.wait_until("return document.getElementById('pixel').textContent.startsWith('Pixel (12, 40)')")
        self.assertEqual(self.browser.find_element("id", "pixel").text, pixel)
        self.assertTrue(self.browser.execute_script("return document.getElementById('card').open"))
        self.assertIn("as its link says", self.link_said())
        self.type_over("more", "less")
        self.wait_for("picture")
        self.open(link)
        self.assertIn("less", json.dumps(self.state()))
        self.open(ADDRESS)
        self.assertEqual(self.state(), own)
        self.assertEqual(self.link_said(), "")

    def test_a_bad_link_gives_one_sentence_and_the_page_as_it_is_without_one(self):
        self.begin()
        self.choose("size", "256")
        self.wait_for("picture")
        default = self.state()
        answers = self.run_in_page("""
            const { play } = Raysteps;
            const { page } = play;
            const known = { scene: play.sceneNames(), walk: play.walkNames(), triangle: ["watertight"], view: play.viewNames(), size: [128, 256], open: ["card"] };
            const link = (edits) => play.writeLink({ choices: page.run.choices, file: page.file(), pixel: [100, 20], step: 3, edits });
            const path = page.file();
            const good = await link({ [path]: play.files[path].replace("Hit", "/* changed */ Hit") });
            const hostile = [good.slice(0, -7), good.slice(0, -1), good.slice(0, 40), good.replace("size=256", "size=128"), good.replace(/check=\\w+&/, ""),
              await link({ [path]: "x".repeat(4_000_000) }), await link({ [path]: "x".repeat(100_000) }), await link(JSON.parse('{"__proto__": "void"}')),
              await link({ [path]: 5 }), await link({ "../index.html": "" }), "#walk=<img src=x onerror=alert(1)>", "#scene=../../etc/passwd",
              "#constructor=1", "#walk=grid&walk=grid", "#pixel=256,1", "#step=-1", "#%", "#file=__proto__", "#open=card,safe", `#${"x".repeat(40000)}`];
            const told = [];
            for (const each of hostile) told.push(await play.readLink(each, known).then(() => "taken", (error) => (error instanceof play.PlayError ? error.message : `${error}`)));
            return { good, taken: await play.readLink(good, known), told };""")
        self.assertEqual(answers["taken"]["pixel"], [100, 20])
        self.assertEqual(answers["taken"]["step"], 3)
        expected = (["cut off or changed"] * 5 + ["longer than the page compiles", "none that the page compiles", "__proto__", "none that the page compiles",
                    "index.html", "the walk", "the scene", "does not know", "twice", "no pixel", "no step", "does not know", "no file", "no section", "40,001 characters"])
        self.assertEqual(len(answers["told"]), len(expected))
        for told, words in zip(answers["told"], expected):
            self.assertIn(words, told)
            self.assertRegex(told, r"^The link could not be read: .*[^.]\. This is the page as it is without one\.$")
        self.open(f"{ADDRESS}{answers['good'][:-7]}")
        self.assertIn("could not be read", self.link_said())
        self.assertEqual(self.state(), default)

    def test_texts_that_are_too_long_for_a_link_are_told(self):
        self.begin()
        self.browser.execute_script(
            "const { page } = Raysteps.play; let noise = ''; for (let i = 1; noise.length < 40000; i = i * 48271 % 0x7fffffff) noise += i.toString(36);"
            "page.run.edit(page.file(), `${page.editor.text()}// ${noise}`)")
        self.browser.find_element("id", "copy-link").click()
        self.wait_until("return document.getElementById('link-said').textContent")
        self.assertRegex(self.link_said(), r"make a link of [\d,]+ characters")


class Steps(PlaygroundTest):
    def said(self):
        return self.browser.find_element("id", "steps-said").text

    def test_the_steps_of_a_walk_are_what_its_trace_observes(self):
        """Of the first walk of each structure, or of all."""
        self.begin()
        found = self.run_in_page(FOLLOW, {"all": ALL})
        self.assertEqual(found["faults"], [])
        self.assertGreater(found["steps"], 500)

    def test_a_mistake_parts_from_the_right_walk_at_its_step_and_a_link_leads_there(self):
        self.begin()
        self.browser.execute_script("document.getElementById('steps').open = true; Raysteps.play.page.look(64, 70)")
        self.wait_until("return document.getElementById('steps-said').textContent.includes('the same in every step')")
        self.type_over("node + 1 : here.skip", "node + 2 : here.skip")
        self.wait_for("picture")
        # The ray meets the root, whose near child comes next.
        self.wait_until("return document.getElementById('steps-said').textContent.includes('part')")
        self.browser.find_element("id", "steps-part").click()
        self.assertRegex(self.said(), r"^Step 2 of \d+, round 2\. Yours: (node|leaf) \d+, .*The right one: (node|leaf) \d+, .*Here the two walks part\.$")
        mine, right = re.findall(r": ((?:node|leaf) \d+)", self.said())
        self.assertNotEqual(mine, right)
        self.assertIn("structure/bvh/bvh_ordered.glsl", self.browser.find_element("id", "steps-line").text)
        self.browser.find_element("id", "steps-list").send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_LEFT)
        self.assertRegex(self.said(), r"^Step 3 of .*They part at step 2\.$")
        self.browser.execute_script("document.getElementById('steps').scrollIntoView()")
        self.keep_picture("playground_steps")
        recorded = self.browser.execute_script(
            "let saved; Raysteps.play.save = (name, text) => { saved = text; };"
            "document.getElementById('steps-save').click(); return JSON.parse(saved)")
        self.assertIn(f"step 2: {mine}, ", recorded["steps"][1]["sentence"])
        self.assertRegex(recorded["steps"][1]["sentence"], r"structure/bvh/bvh_ordered\.glsl:\d+$")
        schema = ROOT / "visualizer" / "walk.schema.json"
        if schema.exists():
            self.assertEqual(faults_of(recorded, schema), [])
        said = self.said()
        self.browser.find_element("id", "copy-link").click()
        link = self.wait_until("return document.getElementById('link').value")
        self.browser.execute_script("localStorage.clear()")
        self.open(link)
        self.wait_until("return document.getElementById('steps-said').textContent.startsWith('Step 3')")
        self.assertEqual(self.said(), said)
        self.browser.execute_script("document.getElementById('steps').scrollIntoView()")
        self.keep_picture("playground_steps_narrow", PHONE["width"])


class Without(PlaygroundTest):
    def open_without(self, script):
        """A page in which this was taken away before it began."""
        added = self.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": script})
        try:
            self.browser.get("about:blank")
            self.browser.get(ADDRESS)
            self.wait_for("without")
        finally:
            self.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)

    def test_a_browser_that_lacks_something_is_told_what_and_shows_a_picture_and_the_texts(self):
        for script, words in (
                ("const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (kind, ...more) "
                 "{ return kind === 'webgl2' ? null : get.call(this, kind, ...more); }", "has no WebGL2"),
                ("const get = WebGL2RenderingContext.prototype.getExtension; WebGL2RenderingContext.prototype.getExtension = function (name) "
                 "{ return name === 'EXT_color_buffer_float' ? null : get.call(this, name); }", "cannot draw into textures of floats"),
                ("const give = WebGL2RenderingContext.prototype.shaderSource; WebGL2RenderingContext.prototype.shaderSource = function (shader, text) "
                 "{ give.call(this, shader, text.replace('bits.low = bits.low - 1;', 'bits.low = bits.low - 1 & 0xffff;')); }", "keeps only 16 bits")):
            with self.subTest(words):
                self.open_without(script)
                self.wait_until("return Raysteps.play.page")
                self.assertIn(words, self.said())
                self.assertTrue(self.browser.execute_script(
                    "const still = document.getElementById('still'); return still.complete && still.naturalWidth === 256 && still.offsetWidth > 100"))
                self.assertIn("go_on", self.browser.execute_script("return document.querySelector('textarea').value"))
                self.browser.execute_script("document.getElementById('steps').open = true; document.getElementById('card-measure').click()")
                self.wait_until("return document.getElementById('steps-said').textContent")
                self.assertIn("no graphics context", self.browser.find_element("id", "card-said").get_attribute("textContent"))
                self.assertEqual(self.complaints(), [])


class HardCases(PlaygroundTest):
    def test_the_page_judges_the_suite_as_its_judge_does(self):
        """By a triangle test that leaks at edges, and by hits that are wrong on purpose."""
        self.begin()
        found = self.run_in_page("""
            const { play } = Raysteps;
            const { trace, readHits } = play;
            await play.openSuite().catch(() => {});
            play.addSuite("conformance", given);
            const of = (options) => play.runSuite(play.page.gpu, options);
            const leaking = await of({ triangle: "moeller_trumbore", families: ["edges", "random"] });
            const spoiled = {};
            const bits = (number) => new Uint32Array(new Float32Array([number]).buffer)[0];
            for (const [kind, change] of Object.entries({
              "missed": (words) => { words[4 * 7 + 3] = -1; }, "no such triangle": (words) => { words[4 * 7 + 3] = 1520; },
              "other triangle": (words) => { words[4 * 7 + 3] += 100; }, "wrong t": (words) => { words[4 * 7] = bits(NaN); },
              "wrong u, v": (words) => { words[4 * 7 + 1] = words[4 * 7 + 2] = bits(0.9); } })) {
              play.readHits = (gpu, result) => { const words = readHits(gpu, result); change(words); return words; };
              spoiled[kind] = (await of({ families: ["edges"] }))[0];
            }
            play.readHits = readHits;
            return { leaking, spoiled };""", packed_script("addSuite", "conformance", pack_suite(ROOT)).split("`")[-2])
        edges, random = sorted(found["leaking"], key=lambda row: row["family"])
        self.assertEqual((edges["tried"], random["wrong"], edges["first"]["kind"]), (500, 0, "missed"))
        self.assertGreater(edges["wrong"], 10)
        for kind, row in found["spoiled"].items():
            self.assertEqual((row["wrong"], row["first"]), (1, {"ray": 7, "kind": kind}))


class GpuCards(PlaygroundTest):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(prefix="raysteps_gpu_cards_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def table_of(self):
        return subprocess.run([COMPARE, "--gpu-cards", self.folder], capture_output=True, text=True, check=False)

    def test_what_the_page_measured_is_valid_by_its_schema_and_a_line_of_the_table(self):
        self.begin()
        self.addCleanup(self.open)  # what is replaced below goes with the page
        self.choose("scene", "tetrahedron:2")
        self.wait_for("picture")
        self.browser.execute_script(  # of few walks, with few rays: those of packets take seconds to be compiled
            "const { play } = Raysteps; const { measureGpu } = play; const walks = ['every_triangle', 'bvh_ordered'];"
            "play.measureGpu = (gpu, scene, options) => measureGpu(gpu, scene, { ...options, rounds: 2, size: 64, walks });"
            "const { runSuite } = play; play.addSuite('conformance', arguments[0]);"
            "play.runSuite = (gpu, options) => runSuite(gpu, { ...options, families: ['edges', 'nothing', 'no_rays'] });"
            "document.getElementById('card').open = true; document.getElementById('card-measure').click()",
            packed_script("addSuite", "conformance", pack_suite(ROOT)).split("`")[-2])
        self.wait_until("return !document.getElementById('card-save').disabled", seconds=150)
        self.assertRegex(self.browser.find_element("id", "card-said").text, r"^2 rounds in tetrahedron:2, by the .* This GPU rounds as the lessons do\. "
                         r"Of 1,[0-9]{3} hard cases 0 are wrong\.$")
        card = self.browser.execute_script(
            "let saved; Raysteps.play.save = (name, text) => { saved = text; }; document.getElementById('card-save').click(); return JSON.parse(saved)")
        self.assertEqual(faults_of(card, ROOT / PAGE / "gpu_card.schema.json"), [])
        walks = {walk["contender"]: walk for walk in card["walks"]}
        self.assertEqual(walks["every_triangle"]["tests_per_ray"], card["head"]["scenes"][0]["triangles"])
        for walk in walks.values():
            self.assertLessEqual(walk["lowest"], walk["million_rays_per_second"])
            self.assertLessEqual(walk["million_rays_per_second"], walk["highest"])
        self.browser.execute_script("document.getElementById('card').scrollIntoView()")
        self.keep_picture("playground_gpu")
        (self.folder / "mine.json").write_text(json.dumps(card))
        found = self.table_of()
        self.assertEqual((found.returncode, found.stderr), (0, ""))
        rows = [line.split() for line in found.stdout.splitlines() if line.split()[1:2] == ["mine.json"]]
        self.assertEqual({row[0] for row in rows}, set(walks))
        for row in rows:
            self.assertEqual(row[2], f"{walks[row[0]]['million_rays_per_second']:.2f}")
        self.assertIn(card["head"]["renderer"], found.stdout)
        self.assertIn(f"; hard cases 0 of {card['conformance']['tried']} wrong", found.stdout)
        table = subprocess.run(["bash", ROOT / "run.sh", "conformance", "--table", self.folder / "mine.json"], capture_output=True, text=True, check=True)
        self.assertIn("| edges | 0 |", table.stdout)

        def put(name, change):
            changed = copy.deepcopy(card)
            change(changed)
            (self.folder / name).write_text(json.dumps(changed))

        put("other.json", lambda one: one["head"].update(schema="compare.schema.json"))
        put("minus.json", lambda one: one["walks"][0].update(lowest=-1))
        put("less.json", lambda one: one.pop("rounding"))
        put("steers.json", lambda one: one["head"].update(renderer="a\x1b[2Jb"))
        (self.folder / "garbage.json").write_text("{")
        found = self.table_of()
        self.assertEqual(found.returncode, 2)
        self.assertIn("mine.json", found.stdout)
        self.assertIn("a [2Jb", found.stdout)
        self.assertEqual(len(found.stderr.splitlines()), 4)
        for name in ("other.json", "minus.json", "less.json", "garbage.json"):
            self.assertEqual(found.stderr.count(name), 1, found.stderr)
        for file in self.folder.iterdir():
            file.unlink()
        self.assertIn("no file *.json", self.table_of().stderr)


if __name__ == "__main__":
    leave_without("chromium", "chromedriver")
    if not COMPARE.exists():
        raise SystemExit(f"{COMPARE} is missing. Build the target 07_compare.")
    unittest.main(verbosity=2 if os.environ.get("VERBOSE") else 1)
