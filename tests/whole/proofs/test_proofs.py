"""The bounds of docs/numerics.md are proved from the shaders' own text, and no longer where that text changes."""

import re
import shutil
import struct
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

from prover import ROOT, Bounds, NotProved, TextChanged, is_installed
from shader_text import constant, formula

NOT_RUN = 77  # what CTest takes for skipped
ROW = re.compile(r"^\| .* \| (at (?:most|least) \S+) \| (-?\S+) \| `(\w+)\.g` \|$", re.M)

# What stands in a shader, what takes its place, and the proof that must notice.
CHANGES = {
    "a sign": ("shaders/triangle/watertight/shear.glsl", "p.x - ray.shear.x * p.z", "p.x + ray.shear.x * p.z",
               "sheared_corner"),
    "a factor of another axis": ("shaders/triangle/watertight/shear.glsl", "p.y - ray.shear.y * p.z",
                                 "p.y - ray.shear.x * p.z", "sheared_corner"),
    "a product in place of a quotient": ("shaders/triangle/watertight/shear.glsl", "direction.x / direction.z",
                                         "direction.x * shear_z", "sheared_corner"),
    "sums that may be fused": ("shaders/triangle/watertight/shear.glsl", "precise real t =", "real t =", "distance"),
    "a share left out": ("shaders/triangle/watertight/shear.glsl", "share * p.z + u * q.z", "u * q.z", "distance"),
    "an area twice": ("shaders/triangle/watertight/shear.glsl", "areas.x + areas.y + areas.z",
                      "areas.x + areas.y + areas.x", "share"),
    "a missing part left out": ("shaders/triangle/watertight/exact_area.glsl", "- missing_part(second, ay, bx)", "",
                                "area_near"),
    "what is missing from one product, twice": ("shaders/triangle/watertight/exact_area.glsl",
                                                "missing_part(second, ay, bx)", "missing_part(first, ay, bx)",
                                                "area_apart"),
    "a plane of a grid multiplied out": ("shaders/structure/grid/grid_cells.glsl",
                                         "(plane_of_grid(axis, plane) - ray.origin[axis]) / ray.direction[axis]",
                                         "plane_of_grid(axis, plane) / ray.direction[axis] - "
                                         "ray.origin[axis] / ray.direction[axis]", "plane"),
    "a plane of a box multiplied out": ("shaders/structure/bvh/box_ray.glsl",
                                        "(first_planes - ray.first_origin) * ray.inverse",
                                        "first_planes * ray.inverse - ray.first_origin * ray.inverse", "box"),
    "one more rounding in four boxes": ("shaders/structure/bvh/bvh4_nodes.glsl",
                                        "(last_planes - ray.last_origin[axis]) * ray.inverse[axis]",
                                        "(last_planes - ray.last_origin[axis]) * (1.5f * ray.inverse[axis])", "box"),
    "half the padding": ("common/structure/padding.cpp", "return 0x1p-19", "return 0x1p-20", "padding"),
    "half the way off a surface": ("shaders/light/leave_surface.glsl", "64.0f", "32.0f", "left_surface"),
    "half the room": ("shaders/structure/bvh/box_padded.glsl", "4.76837158203125e-7f", "2.384185791015625e-7f",
                      "box_room"),
    "another function": ("shaders/structure/kd_tree/kd_descent.glsl", "real t = (plane - ray.origin[axis])",
                         "real t = floor(plane - ray.origin[axis])", "plane"),
}


BOUNDS = Bounds()  # each is found once


class Single:
    """A number of single precision; each operation rounds to nearest."""

    def __init__(self, value):
        self.value = struct.unpack("f", struct.pack("f", float(value)))[0]

    # In double, +, -, * and / of two floats round once more, and to the same float (Figueroa, 1995).
    def __add__(self, other):
        return Single(self.value + other.value)

    def __sub__(self, other):
        return Single(self.value - other.value)

    def __mul__(self, other):
        return Single(self.value * other.value)

    def __truediv__(self, other):
        return Single(self.value / other.value)


def computed(file, function, name, known):
    """What a shader's formula gives; of a number between bars the proofs take the absolute value."""
    text = formula(ROOT, file, function, name, set(known)).replace("|", "")
    return eval(re.sub(r"\b1\b", "Single(1)", text), {"Single": Single, **known})  # pylint: disable=eval-used


class ProofsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="raysteps_test_proofs_")
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)

    def test_every_bound_is_as_promised(self):
        self.assertGreater(len(BOUNDS.proofs), 12)
        for name in BOUNDS.proofs:
            with self.subTest(name):
                BOUNDS.check(name)

    def test_the_page_says_what_gappa_finds(self):
        rows = {name: (promise, found)
                for promise, found, name in ROW.findall((ROOT / "docs/numerics.md").read_text())}
        self.assertEqual(rows, {name: (f"at {proof.kind} {float(proof.promise):g}", f"{float(BOUNDS[name]):.2f}")
                                for name, proof in BOUNDS.proofs.items()})

    def test_a_rough_division_costs_12_roundings(self):
        rough = Bounds(division=5)
        self.assertGreater(rough["hit"], 34)
        self.assertLess(rough["hit"], Fraction(352, 10))

    def test_a_changed_formula_is_not_proved(self):
        for folder in ("shaders", "common/structure"):
            shutil.copytree(ROOT / folder, self.tree / folder)
        for change, (file, old, new, proof) in CHANGES.items():
            with self.subTest(change):
                path = self.tree / file
                text = path.read_text()
                self.assertIn(old, text)
                path.write_text(text.replace(old, new, 1))
                bounds = Bounds(self.tree)
                bounds.update((name, BOUNDS[name]) for name in BOUNDS.proofs if name != proof)
                with self.assertRaises((NotProved, TextChanged)):
                    bounds.check(proof)
                path.write_text(text)

    def test_an_unproved_formula_says_where_it_stands(self):
        file = "shaders/triangle/watertight/shear.glsl"
        known = {"p_x", "p_z", "ray_shear_x"}
        self.assertEqual(formula(ROOT, file, "sheared", "x", known), "p_x - ray_shear_x * p_z")
        with self.assertRaisesRegex(TextChanged, "shear.glsl: x in sheared has ray.shear.x, of which"):
            formula(ROOT, file, "sheared", "x", {"p_x", "p_z"})
        with self.assertRaisesRegex(TextChanged, "has 0 formulas of w, not one"):
            formula(ROOT, file, "sheared", "w", known)
        with self.assertRaisesRegex(TextChanged, "has 0 functions sharpened, not one"):
            formula(ROOT, file, "sharpened", "x", known)

    def test_two_units_are_too_little_room_for_some_box_and_four_are_enough(self):
        """The ray goes through the edge where the box begins along x and ends along y, as exact numbers say."""
        box_ray, padded = "shaders/structure/bvh/box_ray.glsl", "shaders/structure/bvh/box_padded.glsl"
        true, rounded = [], []
        for plane, origin, direction in (("0x1.35ba44p+0", "-0x1.000faep-24", "0x1.ffffd2p-1"),
                                         ("0x1.35a76ap+0", "-0x1.9dd1d6p-25", "0x1.ffe0a8p-1")):
            numbers = [float.fromhex(number) for number in (plane, origin, direction)]
            true.append((Fraction(numbers[0]) - Fraction(numbers[1])) / Fraction(numbers[2]))
            planes, origins, directions = map(Single, numbers)
            inverse = computed(box_ray, "box_ray", "inverse", {"ray_direction": directions})
            rounded.append(computed(box_ray, "span_in_box", "enters.x", {
                "first_planes_x": planes, "ray_first_origin_x": origins, "ray_inverse_x": inverse}))
        entry, leaves = rounded
        padded_exits = []
        for places in (Fraction(1, 2**22), Fraction(1, 2**21)):
            room = computed(padded, "meets_box", "room", {"span_exit": leaves, "four_last_places": Single(places)})
            padded_exits.append(computed(padded, "meets_box", "exit", {"span_exit": leaves, "room": room}))
        self.assertEqual(constant(ROOT / padded, "four_last_places"), "1b-21")
        self.assertLessEqual(true[0], true[1])  # it is in the box
        self.assertGreater(entry.value, padded_exits[0].value)  # and would be said not to be
        self.assertLessEqual(entry.value, padded_exits[1].value)


if __name__ == "__main__":
    if not is_installed():
        print("proofs: the bounds are not proved, because gappa is not installed (package gappa).")
        sys.exit(NOT_RUN)
    unittest.main()
