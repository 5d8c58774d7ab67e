"""Pages of the interfaces, by Doxygen, from the comments of the code."""

import shutil
import subprocess

from .errors import BookError, MachineError


def make_interfaces(root, out, say):
    """Doxygen reads the project's folder and writes into `out`. Its warnings are counted."""
    if not shutil.which("doxygen"):
        raise MachineError("doxygen is missing. Install doxygen.")
    out.mkdir(parents=True, exist_ok=True)
    text = (root / "docs" / "book" / "Doxyfile").read_text()
    done = subprocess.run(["doxygen", "-"], input=f"{text}\nHTML_OUTPUT = {out}\n", cwd=root,
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise BookError(f"doxygen: {done.stderr.strip()[-1000:]}")
    warnings = [line for line in done.stderr.split("\n") if "warning:" in line]
    if warnings:
        say(f"book: doxygen has {len(warnings)} warnings; the first: {warnings[0]}")
