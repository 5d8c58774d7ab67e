#pragma once

#include "scene/scene.h"

#include <string>

namespace raysteps {

// 6, 7 or 10 numbers between commas: eye and target, the vertical field of view in degrees, and up;
// what is not given is the start's. Throws InputError where a number is not one, where eye and
// target are the same point, or where up is parallel to the line between them. Places are in the
// coordinates of the scene's files, from which its origin is taken.
Camera parse_camera(const std::string& text, const Camera& start,
                    const glm::dvec3& origin = glm::dvec3(0.0));

// The camera as an option: `--camera 3,2,8,0,0,0,40`, in the fewest digits that give the same
// floats again. Where the picture is tilted against the scene's up, the camera's up follows. Places
// are in the coordinates of the scene's files.
std::string camera_text(const Camera& camera, const glm::vec3& scene_up,
                        const glm::dvec3& origin = glm::dvec3(0.0));

} // namespace raysteps
