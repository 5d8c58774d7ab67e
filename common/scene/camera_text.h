#pragma once

#include "scene/camera.h"

#include <string>

namespace raysteps {

// The camera as an option: `--camera 3,2,8,0,0,0,40`, in the fewest digits that give the same
// floats again. Where the picture is tilted against the scene's up, the camera's up follows.
std::string camera_text(const Camera& camera, const glm::vec3& scene_up);

} // namespace raysteps
