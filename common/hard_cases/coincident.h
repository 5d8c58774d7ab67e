#pragma once

#include "scene/mesh.h"

#include <array>

namespace raysteps {

// Triangles in the same place: which one is hit must not depend on the order of a walk.

// So many copies of one triangle.
Mesh copies_of_a_triangle(int count);

// Each triangle once more at the end, and once more with its corners the other way round.
Mesh tripled(const Mesh& mesh);

enum class TriangleOrder { forward, backward, shuffled };

inline constexpr std::array all_orders{TriangleOrder::forward, TriangleOrder::backward,
                                       TriangleOrder::shuffled};

// The triangles in another order.
Mesh reordered(const Mesh& mesh, TriangleOrder order, int seed = 99);

} // namespace raysteps
