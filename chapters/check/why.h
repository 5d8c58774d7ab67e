#pragma once

#include "basics/ray.h"
#include "structure/bvh/box_tree.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// The share of a triangle's height within which rounding may take a ray to either side of its edge:
// that of 25 e M (structure/padding.h), 3e-6 of a scene's side, on a triangle of 1/300 of it.
inline constexpr double edge_share = 1e-3;

// The parents of all nodes that can be reached, and the leaves of all triangles.
struct TreePaths {
    std::vector<std::int32_t> parents;             // no_child of the root and of lost nodes
    std::vector<std::vector<std::int32_t>> leaves; // that list the triangle
};

TreePaths paths_of(const BoxTree& tree, std::size_t triangles);

// Why a walk through the tree does not come to a triangle that the ray meets.
enum class LeftOutBy {
    nothing,   // it comes to it
    no_leaf,   // no leaf lists it
    short_box, // a box on the way does not hold the triangle
    tight_box, // one that does, but the box test rounds
};

struct LeftOut {
    LeftOutBy by = LeftOutBy::nothing;
    std::vector<std::int32_t> way{}; // from the root to the leaf
    std::int32_t node = no_child;    // the first on the way that the ray does not meet
};

// The way that comes farthest, of all leaves that list the triangle; the boxes by the test of our
// walks (shaders/structure/bvh/box_plain.glsl), up to t_max.
LeftOut left_out(const BoxTree& tree, const TreePaths& paths, std::span<const glm::vec3> corners,
                 const Ray& ray, float t_max, std::int32_t triangle);

// In words, with the numbers of the box test, their bits, and the padding that would have kept the
// box; and what exact arithmetic says of ray and triangle.
std::string why_not(const BoxTree& tree, std::span<const glm::vec3> corners, const Ray& ray,
                    std::int32_t triangle);

} // namespace raysteps
