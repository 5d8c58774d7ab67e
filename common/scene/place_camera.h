#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// From where a model that names no camera is seen. `automatic` is the camera of its file, else from
// above right in front; or from inside, where from there one would mostly see backs.
enum class CameraChoice { automatic, front, left, top, inside, file };

enum class UpAxis { y, z };

// The names of both, in their order.
std::vector<std::string> camera_choices();
std::vector<std::string> up_axes();

// The choice of that name; none where it is none, as six numbers are.
std::optional<CameraChoice> camera_choice(const std::string& name);

struct CameraRequest {
    CameraChoice choice = CameraChoice::automatic;
    UpAxis up = UpAxis::y;
    std::optional<Camera> instead{}; // where the scene is too large for a camera in front of it
};

// A camera for a scene of models, at the aspect ratio width / height: one that shows the things in
// it as large as they fit in the picture, whatever floor they stand on. Where that needs words, it
// is said to the scene's messages. Throws InputError where the request cannot be met.
Camera place_camera(Scene& scene, float aspect_ratio, const CameraRequest& request);

// The lights of a scene of models, whose camera is known: what glows in it (glowing_lights), those
// of the models' files, and what is placed: one above left of the camera, where there are no
// others, and a dim one on its right; in a room, where the camera sees them. Where the colours of
// the models are so dark or so light that half the picture would be under 0.15 or over 0.7, as sRGB
// from 0 to 1, all but the first kind are stronger or weaker.
std::vector<Light> place_model_lights(Scene& scene, float aspect_ratio);

} // namespace raysteps
