"""Writes the forms of model files that the gallery shows: PNG pictures, binary PLY and GLB."""

import json
import struct
import zlib


def png(width, height, color_at):
    """The bytes of a picture; color_at(column, row) gives three bytes, or four with alpha."""
    rows = [b"".join(bytes(color_at(x, y)) for x in range(width)) for y in range(height)]
    kind = 6 if len(rows[0]) == 4 * width else 2

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 9)) + chunk(b"IEND", b""))


def ply(vertices, faces):
    """Of vertices ((x, y, z), (red, green, blue)), the places in double, and triangles of their numbers."""
    head = ("ply\nformat binary_little_endian 1.0\n"
            f"element vertex {len(vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    return (head.encode() + b"".join(struct.pack("<3d3B", *place, *color) for place, color in vertices)
            + b"".join(struct.pack("<B3i", 3, *face) for face in faces))


class Glb:
    """A glTF file in one piece: what it is made of is added, and each call gives back a number."""

    def __init__(self):
        self._bytes = b""
        self._parts = {name: [] for name in ("nodes", "meshes", "materials", "textures", "images", "accessors",
                                             "bufferViews")}

    def _add(self, kind, part):
        self._parts[kind].append(part)
        return len(self._parts[kind]) - 1

    def _view(self, data):
        view = self._add("bufferViews", {"buffer": 0, "byteOffset": len(self._bytes), "byteLength": len(data)})
        self._bytes += data + b"\0" * (-len(data) % 4)
        return view

    def _vectors(self, vectors):
        size = len(vectors[0])
        data = b"".join(struct.pack(f"<{size}f", *vector) for vector in vectors)
        ends = {"min": [min(v[i] for v in vectors) for i in range(size)],
                "max": [max(v[i] for v in vectors) for i in range(size)]}
        return self._add("accessors", {"bufferView": self._view(data), "componentType": 5126, "count": len(vectors),
                                       "type": f"VEC{size}", **ends})

    def texture(self, picture):
        image = self._add("images", {"bufferView": self._view(picture), "mimeType": "image/png"})
        return self._add("textures", {"source": image})

    def material(self, **properties):
        return self._add("materials", properties)

    def mesh(self, places, normals, coordinates, faces, material):
        """Faces are triangles of numbers of places; the lists of places, normals and coordinates are as long."""
        numbers = self._add("accessors", {
            "bufferView": self._view(b"".join(struct.pack("<3I", *face) for face in faces)), "componentType": 5125,
            "count": 3 * len(faces), "type": "SCALAR"})
        attributes = {"POSITION": self._vectors(places), "NORMAL": self._vectors(normals),
                      "TEXCOORD_0": self._vectors(coordinates)}
        return self._add("meshes", {"primitives": [{"attributes": attributes, "indices": numbers,
                                                    "material": material}]})

    def node(self, name, mesh, **place):
        return self._add("nodes", {"name": name, "mesh": mesh, **place})

    def to_bytes(self):
        file = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(self._parts["nodes"])))}],
                "buffers": [{"byteLength": len(self._bytes)}], **{k: v for k, v in self._parts.items() if v}}
        text = json.dumps(file, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self._bytes))
                + struct.pack("<I4s", len(text), b"JSON") + text
                + struct.pack("<I4s", len(self._bytes), b"BIN\0") + self._bytes)
