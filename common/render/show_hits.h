#pragma once

#include "image/image.h"
#include "render/ray_textures.h"
#include "render/scene_textures.h"
#include "scene/scene.h"

#include <string>

namespace raysteps {

// A picture of hits without any light. The part is a file of shaders/view: how a hit gets its
// colour.
Image show_hits(const RayTextures& rays, const Texture& hits, const SceneTextures& scene,
                const Camera& camera, const glm::vec3& background, const std::string& view_part);

} // namespace raysteps
