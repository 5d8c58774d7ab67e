"""Packing what a person hands in, and unpacking what others handed in, whatever it is."""

import os
import tarfile
import zipfile
from pathlib import Path

from .errors import CourseError
from .own import MOST_BYTES
from .workbook import files_of

TAR_ENDINGS = (".tar", ".tar.gz", ".tgz")


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
    """Each folder, .zip and .tar(.gz) in it, sorted by name."""
    found = [path for path in sorted(folder.iterdir()) if not path.name.startswith(".") and (
        path.is_dir() and not path.is_symlink() or path.name.endswith((".zip", *TAR_ENDINGS)))]
    names = [name_of(path) for path in found]
    for name in names:
        if names.count(name) > 1:
            raise CourseError(f"{folder}: {name} has handed in twice. Keep one of the two.")
    return found


def name_of(path):
    name = path.name
    for ending in (".zip", ".tar.gz", ".tgz", ".tar"):
        name = name.removesuffix(ending)
    return name


def _wanted_name(name, files):
    """Which file of an exercise an entry is: the same path, or below one folder of any name."""
    parts = Path(name).parts
    if ".." in parts or Path(name).is_absolute():
        return None
    for candidate in ("/".join(parts), "/".join(parts[1:])):
        if candidate in files:
            return candidate
    return None


def _put(target, name, read):
    """At most MOST_BYTES, and one byte more to tell that there were too many."""
    path = target / name
    if path.exists():
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(read(MOST_BYTES + 1))


def _from_zip(path, target, files):
    with zipfile.ZipFile(path) as packed:
        for entry in packed.infolist():
            name = _wanted_name(entry.filename, files)
            is_link = (entry.external_attr >> 16) & 0o170000 == 0o120000
            if name and not entry.is_dir() and not is_link:
                with packed.open(entry) as stream:
                    _put(target, name, stream.read)


def _from_tar(path, target, files):
    with tarfile.open(path) as packed:
        for entry in packed:
            name = _wanted_name(entry.name, files)
            if name and entry.isfile():
                _put(target, name, packed.extractfile(entry).read)


def _from_folder(path, target, files):
    for top in (path, *sorted(child for child in path.iterdir()
                              if child.is_dir() and not child.is_symlink())):
        for name in files:
            source = top / name
            is_inside = os.path.realpath(source) == str(Path(os.path.realpath(top)) / name)
            if source.is_file() and is_inside:  # no link on the way to it
                with open(source, "rb") as stream:
                    _put(target, name, stream.read)


def unpack(path, target, exercises):
    """Puts the files of exercises, and only those, into the folder. Links and names that lead
    elsewhere are passed over. Raises CourseError where the archive cannot be read."""
    files = set(files_of(exercises))
    try:
        if path.is_dir():
            _from_folder(path, target, files)
        elif path.name.endswith(".zip"):
            _from_zip(path, target, files)
        else:
            _from_tar(path, target, files)
    except (zipfile.BadZipFile, tarfile.TarError, OSError, RuntimeError, EOFError, ValueError,
            NotImplementedError) as error:
        raise CourseError(f"{path.name}: cannot be unpacked ({error}). Ask for it again.") from error
