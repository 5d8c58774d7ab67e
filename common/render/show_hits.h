#pragma once

#include "image/image.h"
#include "render/ray_textures.h"
#include "render/scene_textures.h"
#include "scene/scene.h"

#include <string>

namespace raysteps {

// A picture of hits without any light. The view names a part of shaders/view: normals, facets,
// depth, triangles, barycentric. Throws InputError where there is no such view.
Image show_hits(const RayTextures& rays, const Texture& hits, const SceneTextures& scene,
                const Camera& camera, const glm::vec3& background, const std::string& view);

} // namespace raysteps
