"""Gets vtk.js, which draws the figures that turn: once, in the version that the lock file pins. And what else is pinned there."""

import base64
import hashlib
import io
import json
import os
import subprocess
import tarfile
import tempfile
from pathlib import Path

LOCK = "docs/book/package-lock.json"
PACKAGE = "vtk.js"
BUNDLE = "package/vtk.js"
SECONDS = 120
AUTHORITIES = "/etc/ssl/certs/ca-certificates.crt"
NOT_FOUND = "book: vtk.js could not be fetched ({reason}), so figures stand still. Run this again with npm and a network."


def pinned(root, package=PACKAGE):
    """The entry of the lock file: version, integrity."""
    return json.loads((root / LOCK).read_text())["packages"][f"node_modules/{package}"]


def is_whole(archive, integrity):
    """Whether the bytes are those of the lock file: integrity is `sha512-` and the sum."""
    kind, _, wanted = integrity.partition("-")
    return base64.b64encode(hashlib.new(kind, archive).digest()).decode() == wanted


def _by_npm(package, entry):
    """npm knows where packages are, and the mirrors and proxies that a person has set."""
    environment = dict(os.environ)
    if Path(AUTHORITIES).exists():  # some builds of Node know only their own
        environment.setdefault("NODE_EXTRA_CA_CERTS", AUTHORITIES)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["npm", "pack", "--ignore-scripts", "--pack-destination", folder,
                        f"{package}@{entry['version']}"], cwd=folder, check=True, env=environment,
                       capture_output=True, stdin=subprocess.DEVNULL, timeout=SECONDS)
        return next(Path(folder).glob("*.tgz")).read_bytes()


def files_in(archive, endings=("",)):
    """The bytes of the files with such endings, by their names."""
    with tarfile.open(fileobj=io.BytesIO(archive)) as files:
        return {entry.name: files.extractfile(entry).read() for entry in files
                if entry.isfile() and entry.name.endswith(tuple(endings))}


def fetch_archive(root, package, say, not_found):
    """The package as it is pinned; None where it cannot be had, which is said."""
    entry = pinned(root, package)
    try:
        archive = _by_npm(package, entry)
    except (OSError, subprocess.SubprocessError, StopIteration) as error:
        say(not_found.format(reason=error))
        return None
    if not is_whole(archive, entry["integrity"]):
        say(not_found.format(reason=f"its sum is not that of {LOCK}"))
        return None
    return archive


def fetch_viewer(root, store, say):
    """The file of vtk.js in the folder `store`; None where it cannot be had, which is said."""
    entry = pinned(root)
    file = store / f"vtk-{entry['version']}.js"
    if file.exists():
        return file
    archive = fetch_archive(root, PACKAGE, say, NOT_FOUND)
    if archive is None:
        return None
    store.mkdir(parents=True, exist_ok=True)
    file.write_bytes(files_in(archive, [BUNDLE])[BUNDLE])
    return file
