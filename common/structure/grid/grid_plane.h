#pragma once

namespace raysteps {

// The planes of a grid as the kernels compute them, in C++.
template <class Real>
struct GridPlane {
    using real = Real;

#define precise
    static
#include "geometry/grid_plane.glsl"
#undef precise
};

// The plane between the cells i - 1 and i along one axis, the same bits as on a GPU.
inline float grid_plane(float lower, float cell_size, int i) {
    return GridPlane<float>::grid_plane(lower, cell_size, i);
}

} // namespace raysteps
