#pragma once

#include "structure/kd_tree/kd_split.h"
#include "structure/kd_tree/kd_tree.h"

#include <glm/vec3.hpp>

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace raysteps {

enum class Sides : std::uint8_t { both, lower, upper };

// On which sides of the plane each triangle of a node has a part. The vector has a place for each
// triangle of the scene and is used again, since only those of the node matter.
std::vector<Sides> sorted_out(std::vector<Sides> sides, const KdEvents& events,
                              const KdPlane& plane);

// The events of the triangles with those sides, still sorted.
KdEvents events_on(Sides side, const KdEvents& events, const std::vector<Sides>& sides);

// The triangles with those sides, each once.
std::vector<int> triangles_on(Sides side, const KdEvents& events, const std::vector<Sides>& sides);

// What the leaves that are made take, of one tree on however many threads.
struct KdSpent {
    std::atomic<std::size_t> bytes = 0;
    std::atomic<std::size_t> leaves = 0;
    std::atomic<std::size_t> references = 0;
};

// What all parts of one tree have in common while it grows.
struct KdPlan {
    KdTriangles triangles;
    KdOptions options;
    int depth_limit = 0;
    KdSpent& spent;
};

// A node that is still to be split or to become a leaf.
struct KdBud {
    int node = 0;
    Box box;
    int depth = 0;
    int bad_splits = 0; // in a row, on the way to it
    KdEvents events;
};

// A tree without ropes, and the buds that it was not to grow itself.
struct KdGrowth {
    KdTree tree;
    std::vector<KdBud> left_over;
};

// Grows a tree from the bud, which becomes node 0. Children with fewer triangles are left over.
// Throws InputError where the plan's bytes are more than its options allow.
KdGrowth grow(const KdPlan& plan, KdBud bud, std::size_t fewest);

// The same for nodes with so many triangles that they are split by bins.
struct KdLargeBud {
    int node = 0;
    Box box;
    int depth = 0;
    int bad_splits = 0;
    std::vector<KdPart> parts;
};

// A tree from the bud, as grow would grow it: by bins as long as there are more than
// KdOptions::most_sorted parts and a plane pays, exactly below. The trunk is grown on one thread.
KdTree grow_large(const KdPlan& plan, KdLargeBud bud);

// The tree with two new nodes at its end, the children of the node, which has that box.
KdTree with_children(KdTree tree, int node, const Box& box, const KdPlane& plane);

// Does the split pay by itself? By area, where it costs less than a leaf; in the middle, where a
// side is rid of some triangle.
bool is_good(const KdPlane& plane, std::size_t count, const KdOptions& options);

// The trunk of a tree is grown on one thread, down to branches of so many triangles.
std::size_t fewest_of_trunk(std::size_t triangles);

// The tree with the branch, which was grown from a bud of it, in the place of that bud's node.
KdTree graft(KdTree tree, int node, const KdTree& branch);

// The tree with its leaves numbered and a rope behind each face of each leaf: the smallest node
// that holds the whole face. So a walk that leaves a leaf goes on there, and not at the root.
// Source: Havran, Bittner and Zara, "Ray tracing with rope trees", 1998; moved down as in Popov,
// Guenther, Seidel and Slusallek, "Stackless KD-tree traversal for high performance GPU ray
// tracing", 2007.
KdTree with_ropes(KdTree tree);

// The kd-tree over the triangles (three corners each), in O(n log n), by the surface-area heuristic
// or at medians of space. The tree does not depend on the number of threads.
//
// A node becomes a leaf where
// - it has no more than leaf_triangles triangles,
// - it is as deep as depth_limit allows, by default 8 + 1.3 log2 n,
// - every plane would make a child thinner than 8 paddings, or
// - no split pays: by area, where the best one costs no less than a leaf; at the median, where both
//   children keep all triangles. In a row of bad_splits of them the builder hopes for a better one
//   below, by area only where a child is rid of some triangle at least.
//
// It needs about 48 bytes a reference for each level that is under work, and the tree. Throws
// InputError where the tree would be larger than most_bytes, where a corner is not finite or
// farther out than 1.8e18, or where there are more than 2^28 triangles.
// Source: Wald and Havran, "On building fast kd-trees for ray tracing, and on doing that in
// O(N log N)", 2006. The depth is that of Havran, "Heuristic Ray Shooting Algorithms", 2000; bad
// splits are those of Pharr, Jakob and Humphreys, "Physically Based Rendering", 3rd ed., 2016.
KdTree build_kd_tree(std::span<const glm::vec3> corners, const KdOptions& options);

// The builder's options as a request has them. Throws InputError where a value makes no sense.
KdOptions kd_options_of(const BuildRequest& request);

// What is to be known of a tree over so many triangles, and of the seconds that building took.
std::vector<Fact> facts_of(const KdTree& tree, const KdOptions& options, std::size_t triangles,
                           double seconds);

} // namespace raysteps
