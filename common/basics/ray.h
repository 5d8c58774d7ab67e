#pragma once

#include <glm/vec3.hpp>

namespace raysteps {

// The records that C++ and GLSL share, in C++: the text is that of shaders/core.
#define precise
template <class Real>
struct Layout {
    using real = Real;
    using real3 = glm::vec<3, Real>;

#include "core/ray.glsl"

#include "core/hit.glsl"

#include "core/view.glsl"
};
#undef precise

using Ray = Layout<float>::Ray;
using Hit = Layout<float>::Hit;
using View = Layout<float>::View;

inline constexpr int no_triangle = -1;

// Rays and hits go to files and textures as they lie in memory (see docs/ray_files.md).
static_assert(sizeof(Ray) == 32);
static_assert(sizeof(Hit) == 16);

} // namespace raysteps
