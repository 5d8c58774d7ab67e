#pragma once

#include "gpu/texture.h"
#include "image/image.h"
#include "render/rays.h"
#include "render/scene_textures.h"
#include "scene/scene.h"

#include <string>

namespace raysteps {

// The colours of a float texture as an image: OpenGL's bottom row comes last.
Image read_image(const Texture& texture);

// Directions as colours: a direction of length 1 with the components -1 ... 1 as red, green and
// blue 0 ... 1.
Image show_directions(const RayTextures& rays);

// A picture of hits without any light. The part is a file of shaders/view: how a hit gets its
// colour.
Image show_hits(const RayTextures& rays, const Texture& hits, const SceneTextures& scene,
                const Camera& camera, const glm::vec3& background, const std::string& view_part);

} // namespace raysteps
