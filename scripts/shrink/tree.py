"""A tree from a file, what of it is left with fewer triangles, and what `check` says of that."""

import json
import re
import struct

from reduce import ShrinkError
from scene import obj_of, run_check, write_floats
from tree_file import Array, read_tree_file, tree_file_bytes

NO_TRIANGLE_HAS_IT = 2**31 - 1
NO_NODE_HAS_IT = 2**31 - 2
FIELDS = [("lower", "float32", 0, 3), ("upper", "float32", 12, 3), ("first", "int32", 24, 1), ("count", "int32", 28, 1)]


class Tree:
    """Its parts, in the order of a walk: places where a leaf lists a triangle, links that lead to where a walk has been
    or nowhere, empty leaves; then triangles and nodes that no walk comes to."""

    def __init__(self, path, triangles):
        head, arrays = read_tree_file(path.read_bytes())
        if head["kind"] != "bvh":
            raise ShrinkError(f"a {head['kind']} cannot be reduced, only a hierarchy of boxes.")
        self.triangles = triangles
        self.width, self.splits, self.padding = (head[name] for name in ("children_per_node", "splits", "padding"))
        order = [number for number, in struct.iter_unpack("<i", arrays["order"].data)]
        nodes, stride = arrays["nodes"].data, arrays["nodes"].stride
        at = {field[0]: field[2] for field in arrays["nodes"].fields}
        self.boxes, self.children, self.listed = [], [], []
        for place in range(0, len(nodes), stride):
            self.boxes.append(struct.unpack_from("<6f", nodes, place + at["lower"]))
            first, count = struct.unpack_from("<2i", nodes, place + at["first"])
            if "children" in at:
                own = list(struct.unpack_from(f"<{self.width}i", nodes, place + at["children"]))
            else:
                own = [first, first + 1] if count == 0 else []
            own = [child for child in own if child != -1]
            self.children.append(own)
            # None is a range that is not in the list.
            self.listed.append(order[first:first + count] if first >= 0 and 0 <= count <= len(order) - first else None)
        self.walk(set(head.get("gaps", [])))

    def walk(self, gaps):
        self.met, self.below, self.parts = [], [[] for _ in self.boxes], []
        seen = [False] * len(self.boxes)
        listed = set()
        opened = []
        if self.boxes:
            opened, seen[0] = [0], True
        while opened:
            node = opened.pop()
            self.met.append(node)
            own = self.children[node]
            for place, triangle in enumerate(self.listed[node] or [] if not own else []):
                self.parts.append(("triangle", node, place))
                listed.add(triangle)
            if not own and not self.listed[node]:
                self.parts.append(("leaf", node, 0))
            for slot, child in enumerate(own):
                if not 0 <= child < len(self.boxes) or seen[child]:
                    self.parts.append(("link", node, slot))
                else:
                    seen[child] = True
                    self.below[node].append(child)
                    opened.append(child)
        self.parts += [("lost", i, 0) for i in range(len(self.triangles)) if i not in listed]
        self.parts += [("node", i, 0) for i, known in enumerate(seen) if not known and i not in gaps]

    def with_parts(self, numbers):
        """The tree file's bytes and the triangles, of these parts alone. A node with one child left gives way to it."""
        kept = {kind: [] for kind in ("triangle", "leaf", "link", "lost", "node")}
        for number in numbers:
            kind, node, place = self.parts[number]
            kept[kind].append((node, place))
        listed, links = {}, {}
        for node, place in kept["triangle"]:
            listed.setdefault(node, []).append(self.listed[node][place])
        for node, slot in kept["link"]:
            links.setdefault(node, []).append(self.children[node][slot])
        led_to = {target for targets in links.values() for target in targets}
        left = {node: node for node, _ in kept["leaf"]}
        below = {}
        for node in reversed(self.met):
            own = [left[child] for child in self.below[node] if child in left]
            if len(own) == 1 and node not in links and node not in led_to:
                left[node] = own[0]
            elif own or node in links or node in listed or node in led_to:
                left[node] = node
                below[node] = own
        return self.written(left.get(0), below, links, listed, kept)

    def written(self, root, below, links, listed, kept):
        nodes = [] if root is None else [root]
        for node in nodes:
            nodes += below.get(node, [])
        nodes += [node for node, _ in kept["node"]]
        names = {node: name for name, node in enumerate(nodes)}
        used = sorted({triangle for own in listed.values() for triangle in own
                       if 0 <= triangle < len(self.triangles)} | {triangle for triangle, _ in kept["lost"]})
        numbers = {triangle: number for number, triangle in enumerate(used)}
        order, records = [], b""
        for node in nodes:
            own = listed.get(node, [])
            count = len(own) if own or self.listed[node] is not None or self.children[node] else NO_TRIANGLE_HAS_IT
            children = [names[child] for child in below.get(node, [])]
            children += [names.get(target, target if target < 0 else NO_NODE_HAS_IT) for target in links.get(node, [])]
            children += [-1] * (self.width - len(children))
            records += struct.pack(f"<6f2i{self.width}i", *self.boxes[node], len(order), count, *children)
            order += [numbers.get(triangle, NO_TRIANGLE_HAS_IT) for triangle in own]
        head = {"kind": "bvh", "made_by": "what is left of another", "triangles": "scene", "children_per_node": self.width,
                "links": "indices", "splits": self.splits, "padding": self.padding}
        fields = FIELDS + [("children", "int32", 32, self.width)]
        arrays = {"nodes": Array(records, 32 + 4 * self.width, fields),
                  "order": Array(struct.pack(f"<{len(order)}i", *order), 4, [("triangle", "int32", 0, 1)])}
        return tree_file_bytes(head, arrays), [self.triangles[i] for i in used], len(nodes)


class TreeCheck:
    """What `check` finds in a tree, without a ray or for one of them."""

    def __init__(self, check, folder):
        self.check, self.folder = check, folder
        self.verdict = folder / "verdict.json"

    def findings(self, tree, scene, rays=None):
        """The kinds of faults, and the first wrong answers."""
        self.verdict.unlink(missing_ok=True)
        run_check(self.check, "--tree", tree, "--scene", scene, *(["--rays", rays] if rays else []),
                  "--out", self.folder, "--json", self.verdict)
        found = json.loads(self.verdict.read_text())
        if rays and "answers" not in found:
            raise ShrinkError("no walk goes through this tree, so it is reduced without rays. Leave --rays out.")
        return ([kind["fault"] for kind in found["fault_kinds"]],
                found["answers"]["first_wrong"] if rays else [])

    def first_failure(self, tree, scene, rays, number):
        """The kind of the first fault, and of which ray."""
        kinds, wrong = self.findings(tree, scene, rays)
        if rays is None:
            if not kinds:
                raise ShrinkError("the tree has no fault. Name rays that go wrong with --rays.")
            return kinds[0], None
        wrong = [each for each in wrong if number in (None, each["ray"])]
        if not wrong:
            raise ShrinkError("check names no wrong answer to the ray. Take bad.csv, which it writes.")
        return kind_of(wrong[0]["cause"]), wrong[0]["ray"]

    def has_failure(self, failure, data, triangles, ray):
        model, tree, rays = (self.folder / name for name in ("model.obj", "tree.rstree", "ray.f32"))
        model.write_text(obj_of(triangles))
        tree.write_bytes(data)
        if ray is not None:
            write_floats(rays, ray)
        try:
            kinds, wrong = self.findings(tree, model, None if ray is None else rays)
        except ShrinkError:
            return False
        return failure in (kinds if ray is None else [kind_of(each["cause"]) for each in wrong])


def kind_of(cause):
    """Without the numbers of nodes."""
    return re.sub(r" \d+", "", cause)
