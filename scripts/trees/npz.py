"""Archives of NumPy arrays, as the head and the arrays of a tree file, and back; without NumPy."""

import ast
import io
import json
import zipfile

from readers import take
from tree_file import Array, TreeError

# The fields of arrays that are not structured.
PLAIN = {"nodes": "nodes", "order": "triangle", "corners": "points", "bounds": "bounds", "starts": "start"}


def field_of(name, described, at):
    """A field of a tree file for a dtype as NPY files spell it: '<f4', ('<f4', (3,))."""
    kind, shape = described if isinstance(described, tuple) else (described, ())
    types = {"f": "float", "i": "int", "u": "uint"}
    if not isinstance(kind, str) or len(kind) != 3 or kind[0] not in "<|" or kind[1] not in types or not kind[2].isdigit():
        raise TreeError(f"the field {name} is of the type {kind!r}. Take little-endian floats and integers.")
    values = 1
    for size in shape:
        values *= size
    return (name, f"{types[kind[1]]}{8 * int(kind[2])}", at, values), int(kind[2]) * values


def read_npy(data, name, plain):
    """One array of a .npz file. The records of a plain array are its rows, and `plain` is the name of their field."""
    if data[:6] != b"\x93NUMPY" or data[6] not in (1, 2, 3):
        raise TreeError(f"{name} is no NPY file.")
    size_bytes = 2 if data[6] == 1 else 4
    size = int.from_bytes(take(data, 8, size_bytes, name), "little")
    start = 8 + size_bytes + size
    try:
        head = ast.literal_eval(take(data, 8 + size_bytes, size, name).decode("latin-1").strip())
        descr, shape, in_columns = head["descr"], head["shape"], head["fortran_order"]
    except (ValueError, SyntaxError, KeyError, TypeError) as error:
        raise TreeError(f"the head of {name} cannot be read.") from error
    if in_columns and len(shape) > 1:
        raise TreeError(f"{name} lies in columns. Save numpy.ascontiguousarray of it.")
    fields, stride = [], 0
    if isinstance(descr, list):
        for each in descr:
            # A field without a name is a gap.
            if each[0] == "":
                stride += int(each[1][2:])
                continue
            field, size_of = field_of(each[0], tuple(each[1:]) if len(each) > 2 else each[1], stride)
            fields.append(field)
            stride += size_of
    else:
        field, stride = field_of(plain, (descr, tuple(shape[1:])), 0)
        fields.append(field)
    count = shape[0] if shape else 1
    return Array(take(data, start, count * stride, name), stride, fields)


def read_npz(data):
    """An archive with the arrays under their names, and `head`: the text of the head without `arrays`."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            files = {entry.removesuffix(".npy"): archive.read(entry) for entry in archive.namelist()}
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError) as error:
        raise TreeError("it is no .npz file that can be read.") from error
    if "head" not in files:
        raise TreeError("it has no array `head`, the text of the head.")
    text = read_npy(files.pop("head"), "head", "text").data
    unknown = sorted(set(files) - set(PLAIN))
    if unknown:
        raise TreeError(f"it has an array {unknown[0]}. It may have head, {', '.join(PLAIN)}.")
    try:
        head = json.loads(text.decode())
    except ValueError as error:
        raise TreeError("`head` is no JSON text. Save numpy.frombuffer(json.dumps(head).encode(), 'u1').") from error
    return head, {name: read_npy(files[name], name, PLAIN[name]) for name in files}


def npy_bytes(descr, shape, data):
    head = repr({"descr": descr, "fortran_order": False, "shape": shape}).encode()
    head += b" " * (-(len(head) + 11) % 64) + b"\n"
    return b"\x93NUMPY\x01\x00" + len(head).to_bytes(2, "little") + head + data


def described(name, array):
    """Its dtype and shape: a plain array where it has the one field that read_npz gives it."""
    kinds = {"float": "f", "int": "i", "uint": "u"}

    def kind_of(type_name):
        word = type_name.rstrip("0123456789")
        size = int(type_name[len(word):]) // 8
        return ("|" if size == 1 else "<") + kinds[word] + str(size), size

    if len(array.fields) == 1 and array.fields[0][0] == PLAIN[name]:
        _, type_name, at, values = array.fields[0]
        kind, size = kind_of(type_name)
        if at == 0 and size * values == array.stride:
            return kind, (array.count,) if values == 1 else (array.count, values)
    fields, end = [], 0
    for field, type_name, at, values in sorted(array.fields, key=lambda each: each[2]):
        kind, size = kind_of(type_name)
        if at < end:
            raise TreeError(f"the fields of {name} overlap, which an array of NumPy cannot have here.")
        if at > end:
            fields.append(("", f"|V{at - end}"))
        fields.append((field, kind) if values == 1 else (field, kind, (values,)))
        end = at + size * values
    if array.stride > end:
        fields.append(("", f"|V{array.stride - end}"))
    return fields, (array.count,)


def npz_bytes(head, arrays):
    """The archive that read_npz reads."""
    file = io.BytesIO()
    text = json.dumps(head).encode()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("head.npy", npy_bytes("|u1", (len(text),), text))
        for name, array in arrays.items():
            archive.writestr(name + ".npy", npy_bytes(*described(name, array), array.data))
    return file.getvalue()
