#pragma once

#include "scene/camera.h"

#include <string>

namespace raysteps {

// The camera as an option: `--camera 3,2,8,0,0,0,40`, in the fewest digits that give the same
// floats again. --camera keeps the scene's own up: where the picture is tilted against it, a
// second line tells the up that a scene file can have.
std::string camera_text(const Camera& camera, const glm::vec3& scene_up);

} // namespace raysteps
