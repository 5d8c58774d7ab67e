"""What other programs save, as the head and the arrays of a tree file."""

import ast
import io
import json
import struct
import zipfile

from tree_file import Array, TreeError

TRIANGLE = [("triangle", "uint32", 0, 1)]


def take(data, at, size, what):
    if at < 0 or size < 0 or at + size > len(data):
        raise TreeError(f"the file ends within {what}: it has {len(data)} bytes, and {at + size} are needed.")
    return data[at:at + size]


def are_nodes(data, at, used, indices):
    """Whether nearly all of these nodes refer to nodes and triangles that there are. A few may be wrong: to find
    those is what the tree is read for."""
    sound = sum(first + count <= indices if count else first + 1 < used
                for _, _, _, first, _, _, _, count in struct.iter_unpack("<3fI3fI", data[at:at + 32 * used]))
    return 10 * sound >= 9 * used


def read_tinybvh(data):
    """What BVH::Save writes: a word of version and layout, the number of triangles, the object itself as it
    lay in memory, nodes, indices. How large the object is depends on the compiler, so its numbers are
    found by what must be true of them: nodes and indices fill the rest of the file exactly."""
    head, triangles = struct.unpack("<II", take(data, 0, 8, "its first words"))
    layout = head >> 24
    if layout != 1:
        raise TreeError(f"its layout is {layout}, and only that of the class BVH, 1, is read. Save a BVH before it is "
                        "converted to another layout.")
    # In the object, the layout is followed by allocatedNodes, usedNodes, triCount and idxCount.
    found = []
    for at in range(8, min(len(data) - 20, 4096), 4):
        kind, allocated, used, count, indices = struct.unpack_from("<5I", data, at)
        nodes_at = len(data) - 32 * used - 4 * indices
        if kind == 1 and count == triangles and 0 < used <= allocated and indices >= count and nodes_at > at + 20:
            found.append((nodes_at, used, indices))
    found = {each for each in found if are_nodes(data, *each)}
    if len(found) != 1:
        raise TreeError("the numbers of its nodes and triangles were not found, or it is cut short. Was it written by "
                        "BVH::Save of tinybvh 1.6?")
    nodes_at, used, indices = found.pop()
    nodes = data[nodes_at:nodes_at + 32 * used]
    fields = [("lower", "float32", 0, 3), ("first", "uint32", 12, 1), ("upper", "float32", 16, 3), ("count", "uint32", 28, 1)]
    return ({"kind": "bvh", "made_by": "tinybvh", "triangles": "scene", "children_per_node": 2, "links": "pair",
             "splits": indices > triangles, "gaps": [1]},
            {"nodes": Array(nodes, 32, fields), "order": Array(data[nodes_at + 32 * used:], 4, TRIANGLE)})


def read_madmann91(data):
    """What serialize() of Bvh<Node<float, 3>> of madmann91/bvh, version 2, writes: the numbers of nodes and of
    triangles, nodes of six bounds and an index whose low four bits count triangles, then the triangles."""
    node_count, triangle_count = struct.unpack("<II", take(data, 0, 8, "its first words"))
    nodes = take(data, 8, 28 * node_count, "its nodes")
    order = take(data, 8 + len(nodes), 4 * triangle_count, "its triangles")
    if len(data) != 8 + len(nodes) + len(order):
        raise TreeError("it is longer than its numbers say. Only nodes of float and of three dimensions are read.")
    records = bytearray()
    for low_x, high_x, low_y, high_y, low_z, high_z, index in struct.iter_unpack("<6fI", nodes):
        records += struct.pack("<6f2I", low_x, low_y, low_z, high_x, high_y, high_z, index >> 4, index & 15)
    fields = [("lower", "float32", 0, 3), ("upper", "float32", 12, 3), ("first", "uint32", 24, 1), ("count", "uint32", 28, 1)]
    return ({"kind": "bvh", "made_by": "madmann91/bvh", "triangles": "scene", "children_per_node": 2, "links": "pair",
             "splits": triangle_count > len(set(struct.unpack(f"<{triangle_count}I", order)))},
            {"nodes": Array(bytes(records), 32, fields), "order": Array(order, 4, TRIANGLE)})


# --- NumPy ---

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
    plain = {"nodes": "nodes", "order": "triangle", "corners": "points", "bounds": "bounds", "starts": "start"}
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            files = {entry.removesuffix(".npy"): archive.read(entry) for entry in archive.namelist()}
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError) as error:
        raise TreeError("it is no .npz file that can be read.") from error
    if "head" not in files:
        raise TreeError("it has no array `head`, the text of the head.")
    text = read_npy(files.pop("head"), "head", "text").data
    unknown = sorted(set(files) - set(plain))
    if unknown:
        raise TreeError(f"it has an array {unknown[0]}. It may have head, {', '.join(plain)}.")
    try:
        head = json.loads(text.decode())
    except ValueError as error:
        raise TreeError("`head` is no JSON text. Save numpy.frombuffer(json.dumps(head).encode(), 'u1').") from error
    return head, {name: read_npy(files[name], name, plain[name]) for name in files}


READERS = {"tinybvh": read_tinybvh, "madmann91": read_madmann91, "npz": read_npz}
