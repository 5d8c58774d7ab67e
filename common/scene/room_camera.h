#pragma once

#include "scene/scene.h"

#include <vector>

namespace raysteps {

struct RoomCamera {
    Camera camera;
    bool is_enclosed = false; // half of all directions or more end at a front
};

// Of 64 places in the scene's box, the one from which one sees most: where the solid angles of the
// triangles that show their front have the greatest entropy, which favours many triangles, none of
// them over the others (Vazquez, Feixas, Sbert and Heidrich, "Viewpoint Selection using Viewpoint
// Entropy", 2001); and from there, the level direction in which one sees most. Of large scenes
// fewer places are tried. Aspect ratio is width / height; up has length 1.
RoomCamera camera_inside(const Scene& scene, float aspect_ratio, const glm::dvec3& up);

// Placed lights for a camera in a room: those that its target cannot be seen from move to where
// the camera sees them.
std::vector<Light> lights_inside(const Scene& scene, std::vector<Light> placed);

} // namespace raysteps
