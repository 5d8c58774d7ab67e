"""Gets CodeMirror, the editor of the playground: once, in the versions that the lock file pins, as one script.

Its packages have modules of Node's old kind, functions that are given `require`: they become one object of functions, so
that a page from the disk can load them."""

import hashlib
import json

from .viewer import LOCK, fetch_archive, files_in

ASKED = {"state": "@codemirror/state", "view": "@codemirror/view", "commands": "@codemirror/commands",
         "language": "@codemirror/language", "highlight": "@lezer/highlight", "mode": "@codemirror/legacy-modes/mode/clike"}
MODES = "@codemirror/legacy-modes"
DIRECT = ("@codemirror/state", "@codemirror/view", "@codemirror/commands", "@codemirror/language", MODES)
NOT_FOUND = "book: CodeMirror could not be fetched ({reason}), so the playground's editor is a text area. Run this again with npm and a network."
HEAD = """// CodeMirror and what it needs, each under the MIT licence below, one module behind the other: `./run.sh book` makes this.
/*
{licences}
*/
(() => {{
const modules = {{
{modules}
}};
const loaded = {{}};
const require = (name) => {{
  if (!loaded[name]) {{
    loaded[name] = {{ exports: {{}} }};
    modules[name](loaded[name], loaded[name].exports, require);
  }}
  return loaded[name].exports;
}};
const play = (globalThis.Raysteps ??= {{}}).play ??= {{}};
play.codeMirror = {{ {asked} }};
}})();
"""


def _packages(root):
    """All but the viewer's: what the editor asks for and what those ask for, by their names in the lock file."""
    entries = json.loads((root / LOCK).read_text())["packages"]
    found, wanted = {}, list(DIRECT)
    while wanted:
        name = wanted.pop()
        if name not in found:
            found[name] = entries[f"node_modules/{name}"]
            wanted += found[name].get("dependencies", {})
    return found


def _module(name, files):
    """The name that others require it by, and its text."""
    if name == MODES:
        return f"{MODES}/mode/clike", files["package/mode/clike.cjs"]
    about = json.loads(files["package/package.json"])
    entry = about.get("exports", {})
    entry = entry.get(".", entry) if isinstance(entry, dict) else entry
    path = (entry.get("require") if isinstance(entry, dict) else None) or about["main"]
    path = path.get("default") if isinstance(path, dict) else path
    return name, files[f"package/{path.removeprefix('./')}"]


def fetch_editor(root, store, say):
    """The script in the folder `store`; None where it cannot be had, which is said."""
    packages = _packages(root)
    version = hashlib.sha256(json.dumps(packages, sort_keys=True).encode()).hexdigest()[:12]
    file = store / f"codemirror-{version}.js"
    if file.exists():
        return file
    modules, licences = [], []
    for name, entry in sorted(packages.items()):
        archive = fetch_archive(root, name, say, NOT_FOUND)
        if archive is None:
            return None
        files = {path: text.decode() for path, text in files_in(archive, (".cjs", ".js", "package.json", "LICENSE")).items()}
        known, text = _module(name, files)
        modules.append(f"{json.dumps(known)}: (module, exports, require) => {{\n{text}\n}},")
        licences.append(f"{name} {entry['version']}\n{files['package/LICENSE'].strip()}\n".replace("*/", "* /"))
    asked = ", ".join(f"{short}: require({json.dumps(name)})" for short, name in ASKED.items())
    store.mkdir(parents=True, exist_ok=True)
    file.write_text(HEAD.format(licences="\n".join(licences), modules="\n".join(modules), asked=asked), encoding="utf-8")
    return file
