"""The sandbox in which `grade` compiles and runs what was handed in: bubblewrap shows a program the system's
compilers and libraries, and of all other files only those that it is lent."""

import os
import re
import shutil
import subprocess
from pathlib import Path

from .errors import MachineError
from .exercises import ROOT

MOST_FILES_OPEN = 256
MOST_BYTES_IN_TMP = 64 << 20

# Seen from outside, root's sandboxes belong to an account of those that systemd lends to services: no file
# and no password is theirs, and the system counts their processes, which it does not for root.
LENT_ACCOUNTS = range(61184, 65520)
NOBODY = 65534

INSTEAD = ("Grade on a machine of its own that holds nothing else, and say so with --without-sandbox")


def _is_root():
    return os.geteuid() == 0


def account():
    return LENT_ACCOUNTS[os.getpid() % len(LENT_ACCOUNTS)] if _is_root() else NOBODY


def lend(folder):
    """Gives a folder and all in it to the account that the sandbox runs under."""
    for path in [folder, *folder.rglob("*")] if _is_root() else []:
        os.chown(path, account(), account(), follow_symlinks=False)


def _system():
    """Where compilers and libraries are. Links of / stay links, as /lib is one on Debian."""
    words = ["--ro-bind", "/usr", "/usr"]
    for name in ("/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"):
        if os.path.islink(name):
            words += ["--symlink", os.readlink(name), name]
        elif os.path.isdir(name):
            words += ["--ro-bind", name, name]
    words += ["--perms", "0755", "--dir", "/etc"]
    for name in ("/etc/alternatives", "/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d"):
        words += ["--ro-bind-try", name, name]
    return words


def around(command, processes, readable=(), hidden=(), writable=(), folder="/tmp"):
    """The command with bubblewrap before it. `hidden` are files below readable folders, which are empty
    there; /tmp is memory. No network, no other processes; all that it leaves running ends with it."""
    words = ["bwrap", "--die-with-parent", "--new-session", "--unshare-ipc", "--unshare-pid", "--unshare-net",
             "--unshare-uts", "--unshare-cgroup-try"]
    if not _is_root():
        words += ["--unshare-user", "--uid", NOBODY, "--gid", NOBODY, "--cap-drop", "ALL"]
    words += [*_system(), "--proc", "/proc", "--dev", "/dev", "--remount-ro", "/dev"]
    words += ["--size", MOST_BYTES_IN_TMP, "--perms", "1777", "--tmpfs", "/tmp"]
    if ROOT.is_relative_to("/usr"):
        words += ["--tmpfs", ROOT]
    for option, paths in (("--ro-bind", readable), ("--bind", writable)):
        for path in map(Path, paths):
            for parent in reversed(path.parents[:-1]):  # else only their owner may pass through them
                words += ["--perms", "0755", "--dir", parent]
            words += [option, path, path]
    for path in hidden:
        words += ["--ro-bind", "/dev/null", path]
    words += ["--remount-ro", "/", "--chdir", folder]
    if _is_root():
        words += ["setpriv", "--reuid", account(), "--regid", account(), "--clear-groups", "--no-new-privs",
                  "--inh-caps=-all", "--bounding-set=-all"]
    words += ["prlimit", f"--nproc={processes}", f"--nofile={MOST_FILES_OPEN}", "--", *command]
    return [str(word) for word in words]


def require_start(outcome):
    """Raises MachineError where a sandbox did not come to its program: that is no fault of what was handed in."""
    if outcome.code in (1, 126, 127) and re.match(r"(bwrap|setpriv|prlimit): ", outcome.errors):
        raise MachineError(f"the sandbox did not start ({outcome.errors.strip()[:300]}). Try it again.")


def require():
    """Raises MachineError where there is no bubblewrap, or where the system forbids it."""
    if shutil.which("bwrap") is None:
        raise MachineError("bubblewrap is missing, which keeps what students wrote away from this machine. "
                           f"Install it (apt-get install bubblewrap). {INSTEAD}.")
    shown = ROOT / "common" / "basics" / "ray.h"  # as the compiler will see it
    tried = subprocess.run(around(["test", "-r", shown], 16, [shown.parent]), capture_output=True, text=True,
                           stdin=subprocess.DEVNULL, check=False)
    if tried.returncode == 0:
        return
    why = tried.stderr.strip() or f"{shown} cannot be read in it by account {account()}"
    raise MachineError(f"this system lets bubblewrap make no sandbox ({why}). A container has to allow "
                       "namespaces (docker run --privileged); Ubuntu 24.04 does after `sysctl "
                       f"kernel.apparmor_restrict_unprivileged_userns=0`. {INSTEAD}.")
