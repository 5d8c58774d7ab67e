"""The headless browser, which prints the book and makes pictures of its drawings."""

import os
import shutil
import subprocess
import tempfile

from .errors import BookError, MachineError

SECONDS = 300
PROGRAM = "chromium"


def has_browser():
    return shutil.which(PROGRAM) is not None


def run_browser(page, *switches, what):
    """Loads the file `page`, and returns what the browser prints. `what` says for what it is needed."""
    if not has_browser():
        raise MachineError(f"{PROGRAM} is missing, and without it {what}. Install {PROGRAM}.")
    with tempfile.TemporaryDirectory(prefix="raysteps_browser_") as folder:
        command = [PROGRAM, "--headless=new", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
                   f"--user-data-dir={folder}", "--virtual-time-budget=60000", *switches, page.as_uri()]
        if os.getuid() == 0:
            command.insert(1, "--no-sandbox")
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS,
                                  stdin=subprocess.DEVNULL, check=False)
        except subprocess.TimeoutExpired as error:
            raise BookError(f"{PROGRAM} took more than {SECONDS} seconds. Run it when less is running.") from error
    if done.returncode != 0:
        raise BookError(f"{PROGRAM} ended with exit code {done.returncode}: {done.stderr.strip()[-500:]}")
    return done.stdout
