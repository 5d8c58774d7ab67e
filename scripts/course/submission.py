"""Packing what a person hands in, and unpacking what others handed in, whatever it is."""

import lzma
import os
import tarfile
import zipfile
import zlib
from pathlib import Path, PurePosixPath

from .errors import CourseError
from .own import MOST_BYTES
from .workbook import files_of

MOST_BYTES_OF_TAR = 1 << 30
ENDINGS = (".zip", ".tar.gz", ".tar.bz2", ".tar.xz", ".tgz", ".tar")


def pack(folder, exercises, archive):
    """A zip file with the workbook's files of exercises, and nothing else. Returns their names."""
    files = [file for file in files_of(exercises) if (folder / file).is_file()]
    if not files:
        raise CourseError(f"{folder}: has no file of an exercise. Run `./course start`.")
    archive.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
        for file in files:
            packed.write(folder / file, file)
    return files


def list_submissions(folder):
    """Whatever is in it, sorted by name, but for what is hidden."""
    return [path for path in sorted(folder.iterdir()) if not path.name.startswith(".")]


def _short_name(path):
    ending = next((ending for ending in ENDINGS if path.name.lower().endswith(ending)), "")
    return path.name[:len(path.name) - len(ending)] or path.name


def name_of(path):
    """Without the ending of an archive, unless another one in the same folder has that name too. What a
    terminal or a table would take for more than a name is written as Python does."""
    short = _short_name(path)
    is_alone = all(other.name == path.name or _short_name(other) != short
                   for other in path.absolute().parent.iterdir())
    name = short if is_alone else path.name
    return name if name.isprintable() else ascii(name)


class _Finder:
    """Which file of an exercise each entry of a submission is."""

    def __init__(self, files):
        self._files, self._entries = files, {}

    def add(self, name, read):
        """An entry by its path, and the function that reads so many bytes of it."""
        path = PurePosixPath(name)
        if ".." in path.parts or path.is_absolute() or "__MACOSX" in path.parts:
            return
        for file in self._files:
            depth = self._depth(path, PurePosixPath(file))
            if depth is not None:
                self._entries.setdefault(file, []).append((depth not in (0, 1), abs(depth), str(path), read))

    @staticmethod
    def _depth(path, file):
        """How many folders the entry has above the file's path, or below 0 how many it lacks of them; None
        where it is another file."""
        depth = len(path.parts) - len(file.parts)
        common = min(len(path.parts), len(file.parts))
        return depth if path.parts[-common:] == file.parts[-common:] else None

    def write(self, target):
        """Writes each file that was found; returns remarks on those that were somewhere else."""
        remarks = []
        for file, entries in sorted(self._entries.items()):
            is_elsewhere, depth, name, read = min(entries, key=lambda entry: entry[:3])
            shown = name if name.isprintable() else ascii(name)
            if is_elsewhere:
                remarks.append(f"{file} was found as {shown}.")
            if sum(entry[:2] == (is_elsewhere, depth) for entry in entries) > 1:
                remarks.append(f"{file} is there {len(entries)} times; {shown} was taken.")
            path = target / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(read(MOST_BYTES + 1))  # one more tells that there were too many
        return remarks


def _add_zip(packed, finder):
    for entry in packed.infolist():
        is_link = (entry.external_attr >> 16) & 0o170000 == 0o120000
        if not entry.is_dir() and not is_link:
            finder.add(entry.filename, lambda most, entry=entry: packed.open(entry).read(most))


def _add_tar(packed, finder):
    unpacked = 0
    for entry in packed:
        unpacked += entry.size
        if unpacked > MOST_BYTES_OF_TAR:  # all that stands before an entry has to be unpacked to get there
            raise ValueError("more than 1 GiB is packed in it")
        if entry.isfile():
            finder.add(entry.name, lambda most, entry=entry: packed.extractfile(entry).read(most))


def _read_file(path, most):
    with open(path, "rb") as stream:
        return stream.read(most)


def _add_folder(path, finder):
    """Links are passed over, to files as to folders."""
    for top, _, names in os.walk(path):
        for source in (Path(top) / name for name in names):
            if source.is_file() and not source.is_symlink():
                finder.add(str(source.relative_to(path)), lambda most, source=source: _read_file(source, most))


def unpack(path, target, exercises):
    """Puts the files of exercises, and only those, into the folder, and returns remarks. Links and names
    that lead elsewhere are passed over. Raises CourseError where it cannot be read."""
    finder, name = _Finder(files_of(exercises)), path.name.lower()
    try:
        if path.is_dir() and not path.is_symlink():
            _add_folder(path, finder)
            return finder.write(target)
        if not path.is_file() or not name.endswith(ENDINGS):
            raise CourseError(f"{name_of(path)}: is no folder and no zip or tar file. Ask for one of those.")
        opened = zipfile.ZipFile(path) if name.endswith(".zip") else tarfile.open(path)
        with opened as packed:
            (_add_zip if name.endswith(".zip") else _add_tar)(packed, finder)
            return finder.write(target)
    except (zipfile.BadZipFile, tarfile.TarError, OSError, RuntimeError, EOFError, ValueError, MemoryError,
            NotImplementedError, zlib.error, lzma.LZMAError) as error:
        raise CourseError(f"{name_of(path)}: cannot be unpacked ({error}). Ask for it again.") from error
