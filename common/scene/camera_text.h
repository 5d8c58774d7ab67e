#pragma once

#include "scene/scene.h"

#include <string>

namespace raysteps {

// 6, 7 or 10 numbers between commas: eye and target, the vertical field of view in degrees, and up;
// what is not given is the start's. Throws InputError where a number is not one, where eye and
// target are the same point, or where up is parallel to the line between them.
Camera parse_camera(const std::string& text, const Camera& start);

// The camera as an option: `--camera 3,2,8,0,0,0,40`, in the fewest digits that give the same
// floats again. Where the picture is tilted against the scene's up, the camera's up follows.
std::string camera_text(const Camera& camera, const glm::vec3& scene_up);

} // namespace raysteps
