"""What a reader of the playground passes on and measures: links, steps of a walk, and what the GPU can do."""

import json
import os
import unittest

from browser import leave_without
from test_playground import ADDRESS, PlaygroundTest


class Links(PlaygroundTest):
    def link(self):
        self.browser.find_element("id", "copy-link").click()
        self.wait_until("const { value } = document.getElementById('link'); return value && value !== globalThis.lastLink")
        return self.browser.execute_script("return globalThis.lastLink = document.getElementById('link').value")

    def follow(self, link):
        """In a page that was not there before: an address that differs in its hash alone would be told to reload itself."""
        self.browser.get("about:blank")
        self.open(link)

    def link_said(self):
        return self.browser.find_element("id", "link-said").text

    def state(self):
        return self.browser.execute_script(
            "const { run, looked, file } = Raysteps.play.page; return [run.choices, run.edits, looked(), file()]")

    def test_a_link_brings_back_all_that_was_seen_and_leaves_the_readers_own_texts_alone(self):
        self.open()
        for name, value in (("scene", "knot:1"), ("walk", "bvh_skip"), ("view", "visits"), ("size", "128")):
            self.choose(name, value)
            self.wait_for("picture")
        self.type_over("observe_visit(node);", "observe_visit(node); // \u00fcber <b>all</b> & more")
        self.wait_for("picture")
        self.browser.execute_script("Raysteps.play.page.look(12, 40)")
        before, pixel = self.state(), self.browser.find_element("id", "pixel").text
        link = self.link()
        self.assertLess(len(link), 6000)
        self.browser.execute_script("localStorage.clear()")
        self.open()
        self.type_over("Hit nearest", "/* my own */ Hit nearest")
        self.wait_for("picture")
        own = self.state()
        self.follow(link)
        self.assertEqual(self.state(), before)
        self.wait_until("return document.getElementById('pixel').textContent.startsWith('Pixel (12, 40)')")
        self.assertEqual(self.browser.find_element("id", "pixel").text, pixel)
        self.assertIn("as its link says", self.link_said())
        self.type_over("more", "less")
        self.wait_for("picture")
        self.follow(link)
        self.assertIn("less", json.dumps(self.state()))
        self.follow(ADDRESS)
        self.assertEqual(self.state(), own)
        self.assertEqual(self.link_said(), "")

    def test_a_bad_link_gives_one_sentence_and_the_page_as_it_is_without_one(self):
        self.open()
        default = self.state()
        answers = self.run_in_page("""
            const { play } = Raysteps;
            const { page } = play;
            const known = { scene: play.sceneNames(), walk: play.walkNames(), triangle: ["watertight"], view: play.viewNames(), size: [128, 256] };
            const link = (edits) => play.writeLink({ choices: page.run.choices, file: page.file(), pixel: [100, 20], step: 3, edits });
            const path = page.file();
            const good = await link({ [path]: play.files[path].replace("Hit", "/* changed */ Hit") });
            const hostile = [good.slice(0, -7), good.slice(0, -1), good.slice(0, 40), good.replace("size=256", "size=128"), good.replace(/check=\\w+&/, ""),
              await link({ [path]: "x".repeat(4_000_000) }), await link({ [path]: "x".repeat(100_000) }), await link(JSON.parse('{"__proto__": "void"}')),
              await link({ [path]: 5 }), await link({ "../index.html": "" }), "#walk=<img src=x onerror=alert(1)>", "#scene=../../etc/passwd",
              "#constructor=1", "#walk=grid&walk=grid", "#pixel=256,1", "#step=-1", "#%", "#file=__proto__", `#${"x".repeat(40000)}`];
            const told = [];
            for (const each of hostile) told.push(await play.readLink(each, known).then(() => "taken", (error) => (error instanceof play.PlayError ? error.message : `${error}`)));
            return { good, taken: await play.readLink(good, known), told };""")
        self.assertEqual(answers["taken"]["pixel"], [100, 20])
        self.assertEqual(answers["taken"]["step"], 3)
        expected = (["cut off or changed"] * 5 + ["longer than the page compiles", "none that the page compiles", "__proto__", "none that the page compiles",
                    "index.html", "the walk", "the scene", "does not know", "twice", "no pixel", "no step", "does not know", "no file", "40,001 characters"])
        self.assertEqual(len(answers["told"]), len(expected))
        for told, words in zip(answers["told"], expected):
            self.assertIn(words, told)
            self.assertRegex(told, r"^The link could not be read: .*[^.]\. This is the page as it is without one\.$")
        for link in (answers["good"][1:-7], "walk=<img src=x onerror=alert(1)>"):
            self.follow(f"{ADDRESS}#{link}")
            self.assertIn("could not be read", self.link_said())
            self.assertEqual(self.state(), default)

    def test_texts_that_are_too_long_for_a_link_are_told(self):
        self.open()
        self.browser.execute_script(
            "const { page } = Raysteps.play; let noise = ''; for (let i = 1; noise.length < 40000; i = i * 48271 % 0x7fffffff) noise += i.toString(36);"
            "page.run.edit(page.file(), `${page.editor.text()}// ${noise}`)")
        self.browser.find_element("id", "copy-link").click()
        self.wait_until("return document.getElementById('link-said').textContent")
        self.assertRegex(self.link_said(), r"make a link of [\d,]+ characters")


if __name__ == "__main__":
    leave_without("chromium", "chromedriver")
    unittest.main(verbosity=2 if os.environ.get("VERBOSE") else 1)
