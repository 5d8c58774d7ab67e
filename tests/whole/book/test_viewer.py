"""vtk.js is fetched once, and used only if it is the one that is pinned."""

import base64
import hashlib
import io
import json
import tarfile
import unittest
from unittest import mock

from support import ROOT, FolderTest
from book import editor_library, viewer


def archive_of(text):
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w:gz") as files:
        entry = tarfile.TarInfo(viewer.BUNDLE)
        entry.size = len(text)
        files.addfile(entry, io.BytesIO(text))
    return data.getvalue()


def sum_of(archive):
    return "sha512-" + base64.b64encode(hashlib.sha512(archive).digest()).decode()


class Viewer(FolderTest):
    def setUp(self):
        super().setUp()
        self.archive = archive_of(b"vtk")
        self.said = []
        lock = {"packages": {"node_modules/vtk.js": {
            "version": "1.2.3", "integrity": sum_of(self.archive)}}}
        self.write(viewer.LOCK, json.dumps(lock))

    def fetched(self, way):
        with mock.patch.object(viewer, "_by_npm", way):
            return viewer.fetch_viewer(self.folder, self.folder / "store", self.said.append)

    def test_the_bundle_is_taken_out_and_kept(self):
        file = self.fetched(lambda package, entry: self.archive)
        self.assertEqual(file.read_bytes(), b"vtk")
        self.assertEqual(self.fetched(None), file)
        self.assertEqual(self.said, [])

    def test_another_archive_is_refused(self):
        self.assertIsNone(self.fetched(lambda package, entry: archive_of(b"other")))
        self.assertIn("its sum is not that of", self.said[0])
        self.assertFalse((self.folder / "store").exists())

    def test_without_a_network_one_line_says_so(self):
        def fail(package, entry):
            raise OSError("no network")
        self.assertIsNone(self.fetched(fail))
        self.assertEqual(len(self.said), 1)
        self.assertIn("(no network)", self.said[0])

    def test_without_npm_one_line_says_so(self):
        with mock.patch.dict("os.environ", PATH=str(self.folder)):
            self.assertIsNone(viewer.fetch_viewer(self.folder, self.folder / "store", self.said.append))
        self.assertIn("npm", self.said[0])

    def test_the_lock_file_pins_what_the_package_file_asks_for(self):
        wanted = json.loads((ROOT / "docs/book/package.json").read_text())["dependencies"]
        self.assertEqual(wanted, {name: viewer.pinned(ROOT, name)["version"] for name in (viewer.PACKAGE, *editor_library.DIRECT)})


class EditorLibrary(FolderTest):
    """CodeMirror comes as packages of modules, and leaves as one script."""

    def package(self, name, text):
        data = io.BytesIO()
        kept = {"package.json": json.dumps({"exports": {"require": "./dist/index.cjs"}}), "dist/index.cjs": text, "mode/clike.cjs": text, "LICENSE": "MIT"}
        with tarfile.open(fileobj=data, mode="w:gz") as files:
            for path, words in kept.items():
                entry = tarfile.TarInfo(f"package/{path}")
                entry.size = len(words)
                files.addfile(entry, io.BytesIO(words.encode()))
        self.archives[name] = data.getvalue()
        return {"version": "1.0.0", "integrity": sum_of(data.getvalue())}

    def setUp(self):
        super().setUp()
        self.archives, self.said = {}, []
        entries = {name: self.package(name, f"exports.name = '{name}';") for name in (*editor_library.DIRECT, "@lezer/highlight", "inner")}
        entries["@codemirror/view"]["dependencies"] = {"inner": "^1.0.0", "@lezer/highlight": "^1.0.0"}
        self.write(viewer.LOCK, json.dumps({"packages": {f"node_modules/{name}": entry for name, entry in entries.items()}}))

    def fetched(self, way):
        with mock.patch.object(viewer, "_by_npm", way):
            return editor_library.fetch_editor(self.folder, self.folder / "store", self.said.append)

    def test_all_modules_are_in_the_script_by_the_names_that_they_require_each_other_by(self):
        file = self.fetched(lambda package, entry: self.archives[package])
        text = file.read_text()
        for name in ("inner", "@codemirror/state", "@codemirror/legacy-modes/mode/clike"):
            self.assertEqual(text.count(f'"{name}": (module, exports, require) => {{'), 1)
        self.assertEqual(self.fetched(None), file)
        self.assertEqual(self.said, [])

    def test_one_package_that_is_another_is_refused(self):
        self.assertIsNone(self.fetched(lambda package, entry: self.archives["inner"]))
        self.assertIn("so the playground's editor is a text area", self.said[0])
        self.assertFalse((self.folder / "store").exists())


if __name__ == "__main__":
    unittest.main()
