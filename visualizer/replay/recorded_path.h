#pragma once

#include "mirror/mirror_scene.h"
#include "scene/scene.h"
#include "walk_recorder.h"

#include <string>
#include <vector>

namespace raysteps {

// Why a ray is there.
enum class RayRole { camera, shadow, mirror, refraction };

// `camera ray`, `shadow ray to light 1`, `mirror ray 2`, `refracted ray 3`: what is counted begins
// at 1.
struct PathRay {
    RayRole role = RayRole::camera;
    int number = 0; // of the light, or of the bounce
    RecordedWalk walk;
};

std::string ray_name(const PathRay& ray);

// What recorded rays belong to. Must outlive the call.
struct PathInput {
    const Scene& scene;
    const mirror::SceneBuffers& buffers;
    const WalkRecorder& recorder;
};

// All rays behind one ray of the camera: the ray, the shadow rays from where it hits, then what a
// mirror sends on, up to so many bounces. Where it meets glass, the refracted ray with all that is
// behind it, and then the reflected one; of these, only what keeps over 1 in 50 of the light. A
// light behind a surface is asked for no ray.
std::vector<PathRay> record_path(const PathInput& input, const Ray& ray, int max_bounces);

// The ray through the centre of a pixel; column 0 is the left one, row 0 the top one.
Ray pixel_ray(const View& view, int width, int height, int column, int row);

// Those of all pixels, row by row from the top.
std::vector<Ray> pixel_rays(const View& view, int width, int height);

} // namespace raysteps
