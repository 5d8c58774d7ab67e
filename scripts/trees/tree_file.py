"""Writes tree files: a head, then raw arrays."""

import json
import struct

MAGIC = b"raysteps tree 1\n"
ALIGNMENT = 16


class TreeError(Exception):
    """One sentence on what is wrong with a file."""


class Array:
    """Records of one size as bytes; fields are (name, type, first byte, number of values)."""

    def __init__(self, data, stride, fields):
        if len(data) % stride != 0:
            raise TreeError(f"{len(data)} bytes are no whole number of records of {stride}.")
        self.data = bytes(data)
        self.stride = stride
        self.fields = fields

    @property
    def count(self):
        return len(self.data) // self.stride


def padded(data):
    return data + bytes(-len(data) % ALIGNMENT)


def tree_file_bytes(head, arrays):
    """The bytes of a tree file of that head, which says all but where the arrays are."""
    data = b""
    described = {}
    for name, array in arrays.items():
        data = padded(data)
        described[name] = {
            "at": len(data), "count": array.count, "stride": array.stride,
            "fields": [dict(zip(("name", "type", "at", "values"), field)) for field in array.fields]}
        data += array.data
    text = json.dumps({**head, "arrays": described}, indent=2).encode() + b"\n"
    return padded(MAGIC + struct.pack("<Q", len(text)) + text) + data
