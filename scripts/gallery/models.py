"""The gallery's models that are made by code: each function gives the files of one, by their names."""

import math
import random

from .model_files import Glb, png, ply


def hills():
    """Land in map coordinates, z up, in double, with a colour at each vertex."""
    side, step = 160, 25.0
    east, north = 448262.0, 5411932.0

    def height(x, y):
        return (90 * math.sin(x / 700) * math.cos(y / 900) + 45 * math.sin(x / 310 + y / 450)
                + 12 * math.sin(x / 97) * math.sin(y / 113) + 420)

    def color(z):
        shore = (196, 182, 128)
        meadow = (88, 132, 58)
        rock = (150, 146, 140)
        return shore if z < 350 else meadow if z < 470 else rock

    vertices = []
    for row in range(side):
        for column in range(side):
            x, y = column * step, row * step
            z = max(height(x, y), 330.0)
            vertices.append(((east + x, north + y, z), color(z) if z > 330 else (60, 104, 150)))
    faces = []
    for row in range(side - 1):
        for column in range(side - 1):
            a = row * side + column
            faces += [(a, a + 1, a + side + 1), (a, a + side + 1, a + side)]
    return {"hills.ply": ply(vertices, faces)}


def _plate(size):
    half = size / 2
    places = [(-half, 0, half), (half, 0, half), (half, 0, -half), (-half, 0, -half)]
    return places, [(0, 1, 0)] * 4, [(0, 1), (1, 1), (1, 0), (0, 0)], [(0, 1, 2), (0, 2, 3)]


def _ball(rows=32):
    places, coordinates, faces = [], [], []
    for i in range(rows + 1):
        for j in range(2 * rows + 1):
            down, around = math.pi * i / rows, math.pi * j / rows
            places.append((math.sin(down) * math.cos(around), math.cos(down), -math.sin(down) * math.sin(around)))
            coordinates.append((j / rows, i / rows))
    for i in range(rows):
        for j in range(2 * rows):
            a = i * (2 * rows + 1) + j
            b = a + 2 * rows + 1
            faces += [(a, b, a + 1)] * (i > 0) + [(a + 1, b, b + 1)] * (i + 1 < rows)
    return places, places, coordinates, faces


def _matte(red, green, blue):
    return {"pbrMetallicRoughness": {"baseColorFactor": [red, green, blue, 1], "metallicFactor": 0,
                                     "roughnessFactor": 1}}


def hedge():
    """Leaves that one picture's alpha cuts out of squares, by many nodes over few meshes."""
    def leaf(x, y):
        u, v = (x + 0.5) / 64 * 2 - 1, (y + 0.5) / 64
        wide = 0.72 * math.sin(math.pi * v) ** 0.8
        stem = abs(u) < 0.05
        inside = abs(u) < wide or (stem and v > 0.9)
        vein = stem or abs(abs(u) - 3.2 * abs((v * 4) % 1 - 0.5) * wide) < 0.03
        green = (52, 96, 34) if vein else (74, 138, 48)
        return (*green, 255 if inside else 0)

    glb = Glb()
    leaves = {**_matte(1, 1, 1), "name": "leaf", "alphaMode": "MASK", "alphaCutoff": 0.5, "doubleSided": True}
    leaves["pbrMetallicRoughness"]["baseColorTexture"] = {"index": glb.texture(png(64, 64, leaf))}
    numbers = random.Random(7)
    mesh = glb.mesh(*_plate(1.0), glb.material(**leaves))
    ground = glb.mesh(*_plate(6.4), glb.material(name="ground", **_matte(0.5, 0.42, 0.32)))
    glb.node("ground", ground)
    for i in range(900):
        turn = [numbers.gauss(0, 1) for _ in range(4)]
        length = math.sqrt(sum(x * x for x in turn))
        place = [numbers.uniform(-2.6, 2.6), numbers.uniform(0.25, 1.9), numbers.uniform(-0.7, 0.7)]
        glb.node(f"leaf {i}", mesh, translation=place, rotation=[x / length for x in turn],
                 scale=[numbers.uniform(0.3, 0.55)] * 3)
    return {"hedge.glb": glb.to_bytes()}


def domes():
    """A normal map: what looks like domes on a ball and on a plate is flat."""
    def dome(x, y):
        u = (x + 0.5) / 256 * 4 % 1 * 2 - 1
        v = -((y + 0.5) / 256 * 4 % 1 * 2 - 1)
        far = math.hypot(u, v)
        normal = (0.8 * u, 0.8 * v, math.sqrt(max(0.0, 1 - 0.64 * far * far))) if far < 0.9 else (0, 0, 1)
        return tuple(round((part + 1) * 127.5) for part in normal)

    glb = Glb()
    texture = glb.texture(png(256, 256, dome))
    clay = glb.material(name="clay", normalTexture={"index": texture}, **_matte(0.75, 0.42, 0.28))
    tile = glb.material(name="tile", normalTexture={"index": texture}, **_matte(0.55, 0.6, 0.65))
    glb.node("ball", glb.mesh(*_ball(), clay), translation=[0, 1, 0])
    glb.node("plate", glb.mesh(*_plate(5.0), tile))
    return {"domes.glb": glb.to_bytes()}


LETTERS = {"R": ("###.", "#..#", "###.", "#.#.", "#..#"), "A": (".##.", "#..#", "####", "#..#", "#..#"),
           "Y": ("#..#", "#..#", ".##.", ".##.", ".##."), "S": (".###", "#...", ".##.", "...#", "###.")}


def sign():
    """A sign that glows by a picture, and lights nothing else."""
    def glow(x, y):
        column, row = x // 6 - 1, y // 6 - 1
        letter, part = divmod(column, 5)
        inside = 0 <= letter < 4 and part < 4 and 0 <= row < 5
        on = inside and LETTERS["RAYS"[letter]][row][part] == "#"
        return (255, 120, 40) if on else (4, 6, 12)

    glb = Glb()
    board = glb.material(name="board", emissiveTexture={"index": glb.texture(png(126, 42, glow))},
                         emissiveFactor=[1, 1, 1], **_matte(0.05, 0.05, 0.06))
    wall = glb.material(name="wall", **_matte(0.36, 0.3, 0.28))
    places = [(-1.5, -0.5, 0), (1.5, -0.5, 0), (1.5, 0.5, 0), (-1.5, 0.5, 0)]
    upright = glb.mesh(places, [(0, 0, 1)] * 4, [(0, 1), (1, 1), (1, 0), (0, 0)], [(0, 1, 2), (0, 2, 3)], board)
    glb.node("sign", upright, translation=[0, 1.2, 0.05])
    glb.node("wall", glb.mesh(*_plate(5.0), wall), rotation=[math.sin(math.pi / 4), 0, 0, math.cos(math.pi / 4)],
             translation=[0, 1, 0])
    glb.node("floor", glb.mesh(*_plate(5.0), wall), translation=[0, 0, 2.5])
    return {"sign.glb": glb.to_bytes()}


def _box(lower, upper, inwards=False):
    """The six sides of a box, as lists of four places."""
    x, y, z = zip(lower, upper)
    corners = [(x[i & 1], y[i >> 1 & 1], z[i >> 2]) for i in range(8)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return [[corners[i] for i in (side[::-1] if inwards else side)] for side in sides]


def room():
    """A closed room: from outside there is nothing to see. The lamp is a surface that glows."""
    parts = [("wall", _box((0, 0, 0), (6, 3, 5), inwards=True)), ("wood", _box((2, 0.95, 1.5), (4.2, 1.05, 2.7)))]
    for x in (2.1, 4.0):
        for z in (1.6, 2.5):
            parts.append(("wood", _box((x, 0, z), (x + 0.1, 0.95, z + 0.1))))
    parts += [("red", _box((2.5, 1.05, 1.8), (2.9, 1.45, 2.2))), ("blue", _box((3.3, 1.05, 2.0), (3.6, 1.75, 2.3))),
              ("cupboard", _box((0, 0, 3.4), (0.6, 2.0, 4.8)))]
    lamp = [(2.6, 2.95, 1.8), (3.6, 2.95, 1.8), (3.6, 2.95, 2.5), (2.6, 2.95, 2.5)]
    parts.append(("lamp", [lamp]))
    text, count = ["mtllib room.mtl"], 0
    for material, sides in parts:
        text.append(f"usemtl {material}")
        for side in sides:
            text += [f"v {x:g} {y:g} {z:g}" for x, y, z in side]
            text.append("f " + " ".join(str(count + i) for i in range(1, 5)))
            count += 4
    colors = {"wall": (0.72, 0.7, 0.64), "wood": (0.5, 0.32, 0.18), "red": (0.7, 0.15, 0.12),
              "blue": (0.16, 0.24, 0.6), "cupboard": (0.38, 0.42, 0.36), "lamp": (0.0, 0.0, 0.0)}
    mtl = []
    for name, color in colors.items():
        mtl += [f"newmtl {name}", "Kd " + " ".join(map(str, color))] + ["Ke 1 1 1"] * (name == "lamp")
    return {"room.obj": ("\n".join(text) + "\n").encode(), "room.mtl": ("\n".join(mtl) + "\n").encode()}


MODELS = (hills, hedge, domes, sign, room)
