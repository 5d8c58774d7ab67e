#pragma once

#include "scene/scene.h"

#include <vector>

namespace raysteps {

// How many triangles of each material a ray from the camera may meet. Triangles that lie beyond one
// side of the view count as unseen, unless a mirror or glass is in view, which may show anything;
// or the camera has a lens, whose rays start beside the eye. Never too few.
std::vector<int> triangles_in_view(const Scene& scene, double aspect_ratio);

// The same without a view: all of them.
std::vector<int> triangles_of_materials(const Scene& scene);

} // namespace raysteps
