#pragma once

#include "basics/box.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// Where the eye is as seen from what it looks at, and what is up: above right in front.
struct ViewDirection {
    glm::dvec3 backward{0.45, 0.35, 1.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
};

// A camera that sees the whole box, from that direction, at the aspect ratio width / height, which
// is over 0. For an empty box, the default camera.
Camera frame_box(const Box& box, float aspect_ratio, const ViewDirection& direction = {});

// The same for all that the scene has. Where the eye would be so far out, beyond
// greatest_coordinate, that squares of distances overflow a float, it is the camera `instead`;
// throws InputError where there is none, or its eye is as far out.
Camera frame_camera(const Scene& scene, float aspect_ratio,
                    const std::optional<Camera>& instead = std::nullopt);

// The camera, or `instead`, by the same rule.
Camera camera_or(const Camera& camera, const std::optional<Camera>& instead,
                 const std::string& scene_name);

// A bright light above left of the camera and a dim one on its right. Light in this project does
// not fade with the distance and there is none from all around, so the dim one shows what the
// bright one leaves in shadow.
std::vector<Light> place_lights(const Camera& camera);

// The lights of a sample that names none: the parallelograms that glow (glowing_lights) and the dim
// one of place_lights; where nothing glows, both of those. The scene needs its camera.
std::vector<Light> find_lights(Scene& scene);

// The scene with a camera, lights and a background, for a sample that names none. Throws as
// frame_camera does. (For files, place_camera.h looks closer.)
Scene frame_scene(Scene scene, float aspect_ratio,
                  const std::optional<Camera>& instead = std::nullopt);

// Lights stay below this. It is what place_lights needs for an eye and a target below
// greatest_coordinate: 1.8e18 + 1.07 * 2 * sqrt(3) * 1.8e18 = 8.5e18; and the square of a distance
// to a light, at most 3 * (8.5e18 + 1.8e18)^2 = 3.2e38, is still a float.
inline constexpr double greatest_light_coordinate = 8.5e18;

// The background of a scene that names none.
inline constexpr glm::vec3 calm_background{0.10f, 0.13f, 0.19f};

// The camera, its view widened where the picture is higher than wide, so that it still shows all
// that a square picture shows.
Camera keep_square_in_view(const Camera& camera, float aspect_ratio);

// The limit: every light costs a shadow ray at every point.
inline constexpr std::size_t most_glowing_lights = 16;

// The lights that the model itself has: two triangles in a row whose material glows (Ke), and which
// make a parallelogram, are a light with that area. Light does not fade with the distance here, so
// only the colour of Ke counts: one that is brighter than 1 is scaled to 1. What glows and is no
// such light is told to the messages of the scene.
std::vector<Light> glowing_lights(Scene& scene);

} // namespace raysteps
