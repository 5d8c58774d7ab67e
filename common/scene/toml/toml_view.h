#pragma once

#include "scene/camera.h"
#include "scene/light.h"
#include "scene/sky.h"

#include <toml++/toml.h>

#include <string_view>
#include <vector>

namespace raysteps {

// What a scene file says of its camera, its lights and its background. All of these throw
// InputError with file, line and column.
Camera toml_camera(const toml::node& camera);
std::vector<Light> toml_lights(const toml::node& lights);
Sky toml_sky(const toml::node& sky);
glm::vec3 toml_color(const toml::node& color, std::string_view key);

} // namespace raysteps
