#include "scene/place_camera.h"

#include "basics/box.h"
#include "basics/error.h"
#include "scene/coarse_view.h"
#include "scene/frame_scene.h"
#include "scene/mesh.h"
#include "scene/room_camera.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace raysteps {

namespace {

// What is given as right, up and backward of who stands before the model, in the scene's axes.
glm::dvec3 in_scene(UpAxis up, const glm::dvec3& vector) {
    return up == UpAxis::y ? vector : glm::dvec3(vector.x, -vector.z, vector.y);
}

ViewDirection direction_of(const CameraRequest& request) {
    const auto seen = [&](const glm::dvec3& backward, const glm::dvec3& up) {
        return ViewDirection{in_scene(request.up, backward), in_scene(request.up, up)};
    };
    switch (request.choice) {
    case CameraChoice::front:
        return seen({0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
    case CameraChoice::left:
        return seen({-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
    case CameraChoice::top:
        return seen({0.0, 1.0, 0.0}, {0.0, 0.0, -1.0});
    default:
        return seen(ViewDirection{}.backward, ViewDirection{}.up);
    }
}

Box box_of(const Scene& scene, int triangle) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return bounds_of(std::span(scene.corners).subspan(first, 3));
}

double area_of(const Scene& scene, int triangle) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return 0.5 * glm::length(area_vector(scene.corners[first], scene.corners[first + 1],
                                         scene.corners[first + 2]));
}

glm::dvec3 sides_of(const Box& box) {
    return is_empty(box) ? glm::dvec3(0.0) : glm::dvec3(box.upper) - glm::dvec3(box.lower);
}

double greatest_side(const glm::dvec3& vector) {
    return std::max({vector.x, vector.y, vector.z});
}

// A floor is flat: most of the area across its axis lies at one height of a hundredth of the whole.
constexpr int heights = 100;
constexpr double least_covered = 0.5;   // by a floor, of the box as seen along its axis
constexpr double greatest_things = 0.5; // of the largest side: what is larger is the picture
constexpr double thinnest_slab = 0.02;  // of the largest side: what a floor's edge has at most
constexpr double level_enough = 1e-3;   // of its own largest side, for a triangle to be level

bool is_level(const glm::dvec3& sides, int axis) {
    return sides[axis] <= level_enough * greatest_side(sides);
}

// The box of what is left without a floor across the axis and the edges of its slab; empty where
// there is no floor.
Box without_floor(const Scene& scene, const Box& box, int axis) {
    const glm::dvec3 sides = sides_of(box);
    const double whole = greatest_side(sides);
    if (!(sides[axis] > 0.0)) {
        return {};
    }
    const auto height_of = [&](const Box& one) {
        const double up = (static_cast<double>(one.lower[axis]) - box.lower[axis]) / sides[axis];
        return static_cast<std::size_t>(std::min(up, 1.0) * heights);
    };
    std::array<double, heights + 1> areas{};
    for (int i = 0; i < triangle_count(scene); ++i) {
        const Box one = box_of(scene, i);
        if (is_level(sides_of(one), axis)) {
            areas[height_of(one)] += area_of(scene, i);
        }
    }
    const auto floor = std::max_element(areas.begin(), areas.end());
    if (*floor < least_covered * sides[(axis + 1) % 3] * sides[(axis + 2) % 3]) {
        return {};
    }
    Box things;
    for (int i = 0; i < triangle_count(scene); ++i) {
        const Box one = box_of(scene, i);
        const glm::dvec3 own = sides_of(one);
        const bool in_floor = is_level(own, axis) &&
                              height_of(one) == static_cast<std::size_t>(floor - areas.begin());
        const bool in_edge =
            greatest_side(own) >= greatest_things * whole && own[axis] <= thinnest_slab * whole;
        if (!in_floor && !in_edge) {
            things = merge(things, one);
        }
    }
    return things;
}

Box box_of_things(const Scene& scene) {
    const Box box = bounds_of(scene.corners);
    Box smallest = box;
    for (int axis = 0; axis < 3 && !is_empty(box); ++axis) {
        const Box things = without_floor(scene, box, axis);
        const double side = greatest_side(sides_of(things));
        if (side > 0.0 && side <= greatest_things * greatest_side(sides_of(box)) &&
            side < greatest_side(sides_of(smallest))) {
            smallest = things;
        }
    }
    return smallest;
}

// Models stand on something flat. One that has most of that at the end of the z axis, and nothing
// like it at the other end or at those of the y axis, seems to have z up.
constexpr double foot_height = 0.01;   // of the side along the axis
constexpr double least_foot = 0.02;    // of all the area
constexpr double greatest_other = 0.2; // of the foot: what is as flat at another end

bool seems_to_lie(const Scene& scene) {
    const Box box = bounds_of(scene.corners);
    const glm::dvec3 sides = sides_of(box);
    double all = 0.0;
    std::array<double, 4> ends{}; // lower and upper y, lower and upper z
    for (int i = 0; i < triangle_count(scene); ++i) {
        const Box one = box_of(scene, i);
        const double area = area_of(scene, i);
        all += area;
        for (const int axis : {1, 2}) {
            const double near = foot_height * sides[axis];
            const std::size_t end = axis == 1 ? 0 : 2;
            ends[end] += one.upper[axis] <= box.lower[axis] + near ? area : 0.0;
            ends[end + 1] += one.lower[axis] >= box.upper[axis] - near ? area : 0.0;
        }
    }
    return ends[2] > 0.0 && ends[2] >= least_foot * all &&
           std::max({ends[0], ends[1], ends[3]}) <= greatest_other * ends[2];
}

constexpr int coarse_pixels = 64;

CoarseView view_of_camera(const Scene& scene, const Camera& camera, float aspect_ratio) {
    const glm::dvec3 eye(camera.eye);
    const double slope =
        std::tan(0.5 * glm::radians(static_cast<double>(camera.vertical_field_of_view)));
    CoarseView view;
    view.width = coarse_pixels;
    view.height = coarse_pixels;
    view.up_slope = slope;
    view.right_slope = slope * static_cast<double>(aspect_ratio);
    return draw_coarsely(scene, eye,
                         view_frame(glm::dvec3(camera.target) - eye, glm::dvec3(camera.up)), view);
}

bool shows_backs(const CoarseView& view) {
    long backs = 0;
    long seen = 0;
    for (std::size_t i = 0; i < view.triangles.size(); ++i) {
        seen += view.triangles[i] >= 0 ? 1 : 0;
        backs += view.is_back[i] ? 1 : 0;
    }
    return 2 * backs > seen;
}

std::string shown_otherwise(const char* options) {
    return std::string(" ") + options + " shows it otherwise.";
}

// The camera of a file, its target as far away as the middle of what there is: what is placed by
// the camera is placed by that distance.
Camera camera_of_file(const Scene& scene) {
    Camera camera = *scene.file_camera;
    const Box box = bounds_of(scene.corners);
    const glm::dvec3 eye(camera.eye);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - eye);
    const double distance =
        glm::dot(0.5 * (glm::dvec3(box.lower) + glm::dvec3(box.upper)) - eye, forward);
    if (distance > 0.0 && std::isfinite(distance)) {
        camera.target = glm::vec3(eye + distance * forward);
    }
    return camera;
}

// Files of some kinds hold cameras that nobody placed, or that are read wrongly: one that shows a
// tenth of the triangles that another shows, or less, is not what a person would choose.
constexpr std::size_t least_part_shown = 10;

std::size_t count_shown(const Scene& scene, const Camera& camera, float aspect_ratio) {
    const CoarseView view = view_of_camera(scene, camera, aspect_ratio);
    const std::set<int> shown(view.triangles.begin(), view.triangles.end());
    return shown.size() - shown.count(-1);
}

Camera automatic_camera(Scene& scene, float aspect_ratio, const CameraRequest& request) {
    const Camera whole = frame_box(bounds_of(scene.corners), aspect_ratio, direction_of(request));
    const bool has_camera =
        scene.file_camera &&
        least_part_shown * count_shown(scene, camera_of_file(scene), aspect_ratio) >=
            count_shown(scene, whole, aspect_ratio);
    if (scene.file_camera && !has_camera) {
        scene.messages.push_back(scene.name +
                                 ": the camera of its file shows hardly anything of it, "
                                 "so another was placed." +
                                 shown_otherwise("--camera file"));
    }
    if (has_camera) {
        scene.messages.push_back(scene.name + ": it is seen by the camera of its file." +
                                 shown_otherwise("--camera front"));
        return camera_of_file(scene);
    }
    const Box things = box_of_things(scene);
    const Camera outside = camera_or(frame_box(things, aspect_ratio, direction_of(request)),
                                     request.instead, scene.name);
    if (shows_backs(view_of_camera(scene, outside, aspect_ratio))) {
        const RoomCamera room = camera_inside(scene, aspect_ratio, direction_of(request).up);
        if (room.is_enclosed) {
            scene.messages.push_back(scene.name +
                                     ": it is seen from inside, since from outside it "
                                     "shows mostly backs." +
                                     shown_otherwise("--camera front"));
            return room.camera;
        }
    }
    if (request.up == UpAxis::y && seems_to_lie(scene)) {
        scene.messages.push_back(scene.name + ": it may lie on its back: what it seems to stand on "
                                              "is at the end of its z axis. Add --up z to see it "
                                              "upright.");
    }
    return outside;
}

} // namespace

std::vector<std::string> camera_choices() {
    return {"automatic", "front", "left", "top", "inside", "file"};
}

std::vector<std::string> up_axes() {
    return {"y", "z"};
}

std::optional<CameraChoice> camera_choice(const std::string& name) {
    const std::vector<std::string> names = camera_choices();
    const auto known = std::find(names.begin(), names.end(), name);
    return known == names.end() ? std::nullopt
                                : std::optional(static_cast<CameraChoice>(known - names.begin()));
}

Camera place_camera(Scene& scene, float aspect_ratio, const CameraRequest& request) {
    if (request.choice == CameraChoice::automatic) {
        return automatic_camera(scene, aspect_ratio, request);
    }
    if (request.choice == CameraChoice::inside) {
        return camera_inside(scene, aspect_ratio, direction_of(request).up).camera;
    }
    if (request.choice == CameraChoice::file) {
        if (!scene.file_camera) {
            throw InputError("--camera file: " + scene.name +
                             " has no camera. Take --camera front, or leave it out.");
        }
        return camera_of_file(scene);
    }
    return camera_or(frame_box(box_of_things(scene), aspect_ratio, direction_of(request)),
                     request.instead, scene.name);
}

namespace {

// In sRGB, as in a picture's file: what is asked for, and what is aimed at, as this is an estimate.
constexpr double darkest_median = 0.15;
constexpr double least_wanted = 0.2;
constexpr double lightest_median = 0.7;
constexpr double most_wanted = 0.65;
constexpr double most_stronger = 16.0; // and weaker

double to_linear(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// Of what is seen and of the whole picture, linear; 0 where there is nothing.
struct Medians {
    double seen = 0.0;
    double picture = 0.0;
};

double median_of(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// What the lights make of a triangle's point, without shadows: the colours' green, which is most of
// the brightness.
double brightness_of(const Scene& scene, int triangle, const glm::dvec3& point,
                     const std::vector<Light>& lights) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    const glm::dvec3 normal =
        area_vector(scene.corners[first], scene.corners[first + 1], scene.corners[first + 2]);
    const Material& material =
        scene.materials[static_cast<std::size_t>(scene.triangle_materials[triangle])];
    const glm::dvec3 to_eye = glm::dvec3(scene.camera.eye) - point;
    const double side = glm::dot(normal, to_eye) < 0.0 ? -1.0 : 1.0;
    double brightness = static_cast<double>(material.emission.y);
    for (const Light& light : lights) {
        const glm::dvec3 to_light = glm::dvec3(light.position) - point;
        const double length = glm::length(normal) * glm::length(to_light);
        const double cosine = length > 0.0 ? side * glm::dot(normal, to_light) / length : 0.0;
        brightness += std::max(cosine, 0.0) * static_cast<double>(light.color.y) *
                      static_cast<double>(material.diffuse.y);
    }
    return brightness;
}

Medians medians_of(const Scene& scene, const std::vector<Light>& lights, float aspect_ratio) {
    const Camera& camera = scene.camera;
    const CoarseView view = view_of_camera(scene, camera, aspect_ratio);
    const glm::dvec3 eye(camera.eye);
    const ViewFrame frame = view_frame(glm::dvec3(camera.target) - eye, glm::dvec3(camera.up));
    std::vector<double> seen;
    for (std::size_t i = 0; i < view.triangles.size(); ++i) {
        if (view.triangles[i] >= 0) {
            const glm::dvec3 place = place_in(view, i);
            seen.push_back(brightness_of(scene, view.triangles[i],
                                         eye + place.x * frame.right + place.y * frame.up +
                                             place.z * frame.forward,
                                         lights));
        }
    }
    const double median = median_of(seen);
    seen.resize(view.triangles.size(), static_cast<double>(scene.background.y));
    return {median, median_of(seen)};
}

// By how much the lights should be stronger; 1 where they are right.
double stronger_by(const Medians& medians) {
    const bool too_dark = medians.seen > 0.0 && medians.seen < to_linear(darkest_median);
    const bool too_light = medians.picture > to_linear(lightest_median);
    const double factor = too_dark    ? to_linear(least_wanted) / medians.seen
                          : too_light ? to_linear(most_wanted) / medians.picture
                                      : 1.0;
    return std::clamp(factor, 1.0 / most_stronger, most_stronger);
}

bool is_within(const Box& box, const glm::vec3& point) {
    return glm::min(box.lower, point) == box.lower && glm::max(box.upper, point) == box.upper;
}

} // namespace

std::vector<Light> place_model_lights(Scene& scene, float aspect_ratio) {
    std::vector<Light> placed = place_lights(scene.camera);
    if (is_within(bounds_of(scene.corners), scene.camera.eye)) {
        placed = lights_inside(scene, std::move(placed));
    }
    std::vector<Light> lights = glowing_lights(scene);
    if (!lights.empty() || !scene.lights.empty()) {
        placed.erase(placed.begin());
    }
    placed.insert(placed.begin(), scene.lights.begin(), scene.lights.end());
    lights.insert(lights.end(), placed.begin(), placed.end());

    const auto factor = static_cast<float>(stronger_by(medians_of(scene, lights, aspect_ratio)));
    if (factor != 1.0f) {
        for (Light& light : lights) { // what glows as well: of a white room it is most of the light
            light.color *= factor;
        }
        scene.messages.push_back(fmt::format(
            "{}: its colours are {}, so the lights are {:.2g} times as strong as usual.",
            scene.name, factor > 1.0f ? "dark" : "light", factor));
    }
    return lights;
}

} // namespace raysteps
