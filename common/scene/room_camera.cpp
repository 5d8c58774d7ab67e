#include "scene/room_camera.h"

#include "basics/box.h"
#include "scene/coarse_view.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace raysteps {

namespace {

constexpr int places_a_side = 4;
constexpr long most_triangles_drawn = 20'000'000; // at all places; about six seconds
constexpr int side_pixels = 24;                   // of a picture over a quarter turn
constexpr double wide_angle = 65.0;               // degrees
constexpr int directions = 12;

struct Seen {
    double entropy = 0.0;
    double fronts = 0.0; // solid angle
};

class SeenTriangles {
public:
    void add(const CoarseView& view) {
        for (std::size_t i = 0; i < view.triangles.size(); ++i) {
            if (view.triangles[i] >= 0 && !view.is_back[i]) {
                angles_[view.triangles[i]] += solid_angle_of(view, i);
            }
        }
    }

    Seen sum() const {
        constexpr double all = 4.0 * std::numbers::pi;
        Seen seen;
        for (const auto& [triangle, angle] : angles_) {
            seen.fronts += angle;
            seen.entropy -= angle / all * std::log2(angle / all);
        }
        return seen;
    }

private:
    std::unordered_map<int, double> angles_;
};

CoarseView square_view(int pixels) {
    CoarseView view;
    view.width = pixels;
    view.height = pixels;
    return view;
}

Seen look_around(const Scene& scene, const glm::dvec3& eye) {
    constexpr std::array<ViewFrame, 6> sides{{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                              {{0, 1, 0}, {0, 0, 1}, {-1, 0, 0}},
                                              {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                              {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                              {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                              {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}};
    SeenTriangles seen;
    for (const ViewFrame& side : sides) {
        seen.add(draw_coarsely(scene, eye, side, square_view(side_pixels)));
    }
    return seen.sum();
}

// In an order in which any first part is spread over the box. Nobody stands right below the ceiling
// or lies on the floor: along the axis that is up they are in the middle half.
std::vector<glm::dvec3> places_in(const Box& box, const glm::dvec3& up) {
    std::vector<glm::dvec3> places;
    const glm::dvec3 whole = glm::dvec3(box.upper) - glm::dvec3(box.lower);
    const glm::dvec3 sides = whole * (1.0 - 0.5 * glm::abs(up));
    const glm::dvec3 first = glm::dvec3(box.lower) + 0.5 * (whole - sides);
    constexpr int all = places_a_side * places_a_side * places_a_side;
    for (int i = 0; i < all; ++i) {
        const int place = i * 37 % all; // 37 has no factor in common with 64
        const glm::dvec3 part(place % places_a_side, place / places_a_side % places_a_side,
                              place / (places_a_side * places_a_side));
        places.push_back(first + (part + 0.5) / double{places_a_side} * sides);
    }
    return places;
}

double median_depth(const CoarseView& view) {
    std::vector<double> depths;
    std::copy_if(view.depths.begin(), view.depths.end(), std::back_inserter(depths),
                 [](double depth) { return std::isfinite(depth); });
    if (depths.empty()) {
        return 1.0;
    }
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    return *middle;
}

// The frame of who stands upright, turned by a part of a full turn.
ViewFrame turned(const glm::dvec3& up, double part) {
    const glm::dvec3 north = std::abs(up.y) > 0.5 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 east = glm::cross(north, up);
    const double angle = 2.0 * std::numbers::pi * part;
    return view_frame(std::cos(angle) * north + std::sin(angle) * east, up);
}

Camera best_direction(const Scene& scene, const glm::dvec3& eye, float aspect_ratio,
                      const glm::dvec3& up) {
    CoarseView wide = square_view(2 * side_pixels);
    wide.up_slope = std::tan(0.5 * glm::radians(wide_angle));
    wide.right_slope = wide.up_slope * static_cast<double>(aspect_ratio);
    Camera best;
    double most = -1.0;
    for (int i = 0; i < directions; ++i) {
        const ViewFrame frame = turned(up, static_cast<double>(i) / directions);
        const CoarseView view = draw_coarsely(scene, eye, frame, wide);
        SeenTriangles seen;
        seen.add(view);
        if (const double entropy = seen.sum().entropy; entropy > most) {
            most = entropy;
            best.target = glm::vec3(eye + median_depth(view) * frame.forward);
        }
    }
    best.eye = glm::vec3(eye);
    best.up = glm::vec3(up);
    best.vertical_field_of_view = static_cast<float>(wide_angle);
    return best;
}

// How far one sees from the eye in that direction, at most so far.
double free_way(const Scene& scene, const glm::dvec3& eye, const glm::dvec3& direction,
                const glm::dvec3& up, double farthest) {
    const CoarseView view = draw_coarsely(scene, eye, view_frame(direction, up), square_view(3));
    return std::min(view.depths[4], farthest);
}

} // namespace

RoomCamera camera_inside(const Scene& scene, float aspect_ratio, const glm::dvec3& up) {
    const Box box = bounds_of(scene.corners);
    if (is_empty(box)) {
        return {};
    }
    std::vector<glm::dvec3> places = places_in(box, up);
    const long most = most_triangles_drawn / std::max(1, triangle_count(scene));
    places.resize(static_cast<std::size_t>(std::clamp(most, 8L, long(places.size()))));
    glm::dvec3 best = places.front();
    Seen most_seen{-1.0, 0.0};
    for (const glm::dvec3& place : places) {
        const Seen seen = look_around(scene, place);
        if (seen.entropy > most_seen.entropy) {
            most_seen = seen;
            best = place;
        }
    }
    return {best_direction(scene, best, aspect_ratio, up),
            most_seen.fronts >= 2.0 * std::numbers::pi};
}

std::vector<Light> lights_inside(const Scene& scene, std::vector<Light> placed) {
    const glm::dvec3 eye(scene.camera.eye);
    const glm::dvec3 target(scene.camera.target);
    const glm::dvec3 up(scene.camera.up);
    const ViewFrame frame = view_frame(target - eye, up);
    const double distance = glm::distance(eye, target);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const glm::dvec3 light(placed[i].position);
        const double way = glm::distance(light, target);
        if (free_way(scene, target, light - target, frame.right, way) >= way) {
            continue;
        }
        const double side = i == 0 ? -0.5 : 0.5;
        const glm::dvec3 direction =
            glm::normalize(0.6 * frame.forward + side * frame.right + 0.6 * frame.up);
        const double half = 0.5 * free_way(scene, eye, direction, frame.right, distance);
        placed[i].position = glm::vec3(eye + half * direction);
    }
    return placed;
}

} // namespace raysteps
