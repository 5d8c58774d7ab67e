"""scripts/trees and scripts/shrink, by what check says of their files."""

import io
import json
import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT / "scripts" / "trees"))

from tree_file import Array, read_tree_file, tree_file_bytes  # noqa: E402

CHECK = os.environ["RAYSTEPS_CHECK"]
# The engine is called very often, and needs no packages.
PYTHON = f"{sys.executable} -I -S"

# Eight triangles side by side along x, each one wide.
COUNT = 8
MODEL = "".join(f"v {i} 0 0\nv {i}.9 0 0\nv {i} 1 0.5\n" for i in range(COUNT)) + "".join(
    f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}\n" for i in range(COUNT))


def box(triangles):
    return (min(triangles), 0, 0), (float(struct.unpack("f", struct.pack("f", max(triangles) + 0.9))[0]), 1, 0.5)


def halved(triangles, nodes, order, node):
    """A tree of pairs: (lower, upper, first, count) of each node."""
    lower, upper = box(triangles)
    if len(triangles) == 1:
        nodes[node] = (lower, upper, len(order), 1)
        order.append(triangles[0])
        return
    child = len(nodes)
    nodes[node] = (lower, upper, child, 0)
    nodes += [None, None]
    halved(triangles[:len(triangles) // 2], nodes, order, child)
    halved(triangles[len(triangles) // 2:], nodes, order, child + 1)


def tree(gap=False):
    nodes, order = [None] + [((0, 0, 0), (0, 0, 0), 0, 0)] * gap, []
    halved(list(range(COUNT)), nodes, order, 0)
    return nodes, order


def npy(descr, shape, data):
    head = repr({"descr": descr, "fortran_order": False, "shape": shape}).encode()
    head += b" " * (-(len(head) + 11) % 64) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head + data


def tinybvh_bytes():
    nodes, order = tree(gap=True)
    inside = struct.pack("<2Q", 7, 9) + struct.pack("<5I", 1, 2 * COUNT, len(nodes), COUNT, COUNT) + bytes(36)
    return (struct.pack("<II", 166 | 1 << 24, COUNT) + inside +
            b"".join(struct.pack("<3fI3fI", *low, first, *high, count) for low, high, first, count in nodes) +
            struct.pack(f"<{COUNT}I", *order))


def madmann91_bytes():
    nodes, order = tree()
    packed = b"".join(struct.pack("<6fI", low[0], high[0], low[1], high[1], low[2], high[2], first << 4 | count)
                      for low, high, first, count in nodes)
    return struct.pack("<II", len(nodes), COUNT) + packed + struct.pack(f"<{COUNT}I", *order)


def npz_bytes(kind="<f4"):
    nodes, order = tree()
    head = json.dumps({"kind": "bvh", "triangles": "scene", "children_per_node": 2, "links": "pair"}).encode()
    descr = [("lower", kind, (3,)), ("first", "<u4"), ("upper", "<f4", (3,)), ("count", "<u4")]
    data = b"".join(struct.pack("<3fI3fI", *low, first, *high, count) for low, high, first, count in nodes)
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("head.npy", npy("|u1", (len(head),), head))
        archive.writestr("nodes.npy", npy(descr, (len(nodes),), data))
        archive.writestr("order.npy", npy("<i8", (COUNT,), struct.pack(f"<{COUNT}q", *order)))
    return file.getvalue()


SAVED = {"tinybvh": tinybvh_bytes(), "madmann91": madmann91_bytes(), "npz": npz_bytes()}

# An engine: every triangle by Moeller-Trumbore. Its bugs are in the words of its fourth argument.
ENGINE = """
import struct, sys, os, time
points, faces = [], []
for line in open(sys.argv[1]):
    words = line.split()
    if words[:1] == ["v"]:
        points.append([float(word) for word in words[1:4]])
    elif words[:1] == ["f"]:
        faces.append([points[int(word) - 1] for word in words[1:4]])
ray = struct.unpack("<8f", open(sys.argv[2], "rb").read())
sub = lambda a, b: [x - y for x, y in zip(a, b)]
dot = lambda a, b: sum(x * y for x, y in zip(a, b))
cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
best = (ray[7], 0.0, 0.0, -1)
has_first = any(face[0][0] == 0 for face in faces)
for number, (a, b, c) in enumerate(faces):
    if a[0] == 5 and has_first:
        if sys.argv[4] == "lose":
            continue
        if sys.argv[4] == "crash":
            os.abort()
        if sys.argv[4] == "hang":
            time.sleep(60)
    e, f, d, s = sub(b, a), sub(c, a), ray[3:6], sub(ray[:3], a)
    p, q = cross(d, f), cross(s, e)
    det = dot(e, p)
    if det:
        u, v, t = dot(s, p) / det, dot(d, q) / det, dot(f, q) / det
        if u >= 0 and v >= 0 and u + v <= 1 and 0 <= t < best[0]:
            best = (t, u, v, number)
open(sys.argv[3], "wb").write(struct.pack("<fffi", *best))
"""


class ScriptsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="raysteps_test_check_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "model.obj").write_text(MODEL)

    def run_script(self, name, *words):
        return subprocess.run([sys.executable, "-B", ROOT / "scripts" / name, *words], cwd=self.folder,
                              capture_output=True, text=True, check=False, timeout=120)

    def converted(self, form, data):
        (self.folder / "saved").write_bytes(data)
        return self.run_script("trees", form, "saved", "tree.rstree")

    def test_what_others_save_becomes_a_tree_without_a_fault(self):
        for form, data in SAVED.items():
            with self.subTest(form):
                self.assertEqual(self.converted(form, data).returncode, 0)
                run = subprocess.run([CHECK, "--tree", "tree.rstree", "--scene", "model.obj"], cwd=self.folder,
                                     capture_output=True, text=True, check=False)
                self.assertEqual((run.returncode, "no fault" in run.stdout), (0, True), run.stdout + run.stderr)

    def test_a_saved_file_that_is_cut_short_or_none_ends_in_one_sentence(self):
        for form, data in SAVED.items():
            for size in (0, 7, len(data) // 2, len(data) - 1):
                with self.subTest(form, size=size):
                    run = self.converted(form, data[:size])
                    self.assertEqual(run.returncode, 2)
                    self.assertRegex(run.stderr, r"^saved: .*\n$")

    def test_arrays_come_back_from_a_tree_file(self):
        self.converted("npz", SAVED["npz"])
        self.assertEqual(self.run_script("trees", "to_npz", "tree.rstree", "again.npz").returncode, 0)
        self.assertEqual(self.run_script("trees", "npz", "again.npz", "again.rstree").returncode, 0)
        tree, again = ((self.folder / name).read_bytes() for name in ("tree.rstree", "again.rstree"))
        self.assertEqual(tree, again)
        self.assertEqual(self.run_script("trees", "to_npz", "model.obj", "bad.npz").returncode, 2)

    def test_arrays_of_other_types_are_refused_by_name(self):
        run = self.converted("npz", npz_bytes(kind=">f4"))
        self.assertIn("lower", run.stderr)
        self.assertEqual(run.returncode, 2)

    def shrink(self, bug, *words):
        (self.folder / "engine.py").write_text(ENGINE)
        (self.folder / "rays.csv").write_text(
            "origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,t_min,t_max\n"
            "2.3,0.3,3,0,0,-1,0,1e30\n5.3,0.3,3,0,0,-1,0,1e30\n")
        return self.run_script("shrink", "--check", CHECK, "--scene", "model.obj", "--rays", "rays.csv", "--out", "out",
                               "--command", f"{PYTHON} engine.py %m %r %h {bug}", *words)

    def test_a_wrong_answer_is_reduced_to_the_triangles_that_it_takes(self):
        run = self.shrink("lose")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("ray 1 of rays.csv: wrong; 8 triangles", run.stdout)
        self.assertIn("2 of 8 triangles are left", run.stdout)
        model = (self.folder / "out" / "shrunk.obj").read_text()
        self.assertEqual((model.count("v "), model.count("f ")), (6, 2))
        for bug, code in (("lose", 1), ("none", 0)):
            test = subprocess.run([sys.executable, "out/test_case.py", f"{PYTHON} engine.py %m %r %h {bug}"],
                                  cwd=self.folder, capture_output=True, text=True, check=False)
            self.assertEqual(test.returncode, code, test.stdout + test.stderr)
        again = self.shrink("lose")
        self.assertIn("goes on with 2 triangles", again.stdout)

    def test_an_engine_that_crashes_or_never_ends_is_reduced_too(self):
        self.assertIn("2 of 8 triangles are left", self.shrink("crash").stdout)
        run = self.shrink("hang", "--seconds", "0.6", "--ray-number", "1")
        self.assertIn("timeout", run.stdout)

    def test_a_right_engine_is_told_apart(self):
        run = self.shrink("none")
        self.assertEqual(run.returncode, 2)
        self.assertIn("right answer to every ray", run.stderr)


    def shrink_tree(self, nodes, *words):
        """Of the tree with these nodes; what is left of the triangles and nodes."""
        records = b"".join(struct.pack("<6f2I", *low, *high, first, count) for low, high, first, count in nodes)
        fields = [("lower", "float32", 0, 3), ("upper", "float32", 12, 3), ("first", "uint32", 24, 1), ("count", "uint32", 28, 1)]
        arrays = {"nodes": Array(records, 32, fields),
                  "order": Array(struct.pack(f"<{COUNT}i", *tree()[1]), 4, [("triangle", "int32", 0, 1)])}
        head = {"kind": "bvh", "triangles": "scene", "children_per_node": 2, "links": "pair"}
        (self.folder / "bad.rstree").write_bytes(tree_file_bytes(head, arrays))
        run = self.run_script("shrink", "--check", CHECK, "--scene", "model.obj", "--tree", "bad.rstree", "--out", "out", *words)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        _, left = read_tree_file((self.folder / "out" / "shrunk.rstree").read_bytes())
        return (self.folder / "out" / "shrunk.obj").read_text().count("f "), left["nodes"].count, run.stdout

    def test_a_short_box_of_a_tree_is_reduced_to_its_leaf(self):
        nodes = tree()[0]
        place = next(i for i, (low, _, _, count) in enumerate(nodes) if count == 1 and low[0] == 5)
        low, high, first, count = nodes[place]
        nodes[place] = (low, (5.1, *high[1:]), first, count)
        self.assertEqual(self.shrink_tree(nodes)[:2], (1, 1))
        (self.folder / "rays.f32").write_bytes(struct.pack("<16f", 2.3, 0.3, 3, 0, 0, -1, 0, 1e30, 5.3, 0.3, 3, 0, 0, -1, 0, 1e30))
        triangles, left, said = self.shrink_tree(nodes, "--rays", "rays.f32")
        self.assertEqual((triangles, left), (1, 1))
        self.assertIn("the box of node does not hold it, ray 1 of rays.f32", said)
        again = self.shrink_tree(nodes, "--rays", "rays.f32")[2]
        self.assertIn("goes on with 1 parts of the tree", again)

    def test_swapped_children_are_reduced_to_two_leaves_under_a_node(self):
        nodes = tree()[0]
        one, other = [i for i, (low, _, _, count) in enumerate(nodes) if count == 1 and low[0] in (0, 7)]
        nodes[one], nodes[other] = nodes[other], nodes[one]
        triangles, left, said = self.shrink_tree(nodes)
        self.assertEqual((triangles, left), (2, 3))
        self.assertIn("box does not enclose its child", said)

    def test_a_cycle_is_reduced_to_the_nodes_on_it(self):
        nodes = tree()[0]
        inner = max(i for i, node in enumerate(nodes) if node[3] == 0)
        nodes[inner] = (*nodes[inner][:2], 1, 0)
        triangles, left, said = self.shrink_tree(nodes)
        self.assertIn("bad.rstree: cycle;", said)
        self.assertEqual(triangles, 1)
        self.assertLessEqual(left, 4)

    def test_a_sound_tree_is_told_apart(self):
        with self.assertRaisesRegex(AssertionError, "the tree has no fault"):
            self.shrink_tree(tree()[0])


if __name__ == "__main__":
    unittest.main()
