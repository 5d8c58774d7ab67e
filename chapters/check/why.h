#pragma once

#include "basics/ray.h"
#include "structure/bvh/box_tree.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>

namespace raysteps {

// The share of a triangle's height within which rounding may take a ray to either side of its edge:
// that of 25 e M (structure/padding.h), 3e-6 of a scene's side, on a triangle of 1/300 of it.
inline constexpr double edge_share = 1e-3;

// Why a walk through the tree does not come to the triangle, in words (mirror/left_out.h), and what
// exact arithmetic says of ray and triangle.
std::string why_not(const BoxTree& tree, std::span<const glm::vec3> corners, const Ray& ray,
                    std::int32_t triangle);

} // namespace raysteps
