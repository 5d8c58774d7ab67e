#include "visualizer/framing.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace raysteps::view {

namespace {

constexpr float angle = 30.0f;

// From where the ray is seen from the side, a little from above and a little from behind.
glm::dvec3 direction_beside(const glm::dvec3& ray, const glm::dvec3& upwards) {
    const glm::dvec3 along = glm::normalize(ray);
    glm::dvec3 aside = glm::cross(along, upwards);
    if (glm::length(aside) < 1e-3) {
        aside = glm::cross(along, glm::dvec3(along.y, along.z, along.x));
    }
    return glm::normalize(glm::normalize(aside) - 0.35 * along + 0.35 * upwards);
}

// Where the walk hits; where it does not, the middle of the scene.
glm::dvec3 end_of_walk(const Stage& stage, const State& state, const glm::dvec3& center) {
    const RecordedWalk* walk = walk_in(*stage.panes().front(), state);
    if (!walk || walk->hit.triangle == no_triangle) {
        return center;
    }
    return glm::dvec3(walk->ray.origin) +
           static_cast<double>(walk->hit.t) * glm::dvec3(walk->ray.direction);
}

} // namespace

float size_of(const Box& bounds) {
    if (is_empty(bounds)) {
        return 1.0f;
    }
    const glm::vec3 side = bounds.upper - bounds.lower;
    const float largest = std::max({side.x, side.y, side.z});
    return largest > 0.0f ? largest : 1.0f;
}

Camera frame_stage(const Stage& stage, const State& state, double aspect_ratio) {
    const glm::dvec3 upwards = glm::normalize(glm::dvec3(stage.camera().up));
    const Box& bounds = stage.bounds();
    const bool nothing = is_empty(bounds);
    const glm::dvec3 center =
        nothing ? glm::dvec3(0.0) : 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
    const double radius =
        nothing ? 1.0
                : std::max(0.5 * glm::length(glm::dvec3(bounds.upper) - glm::dvec3(bounds.lower)),
                           1e-12);
    glm::dvec3 from =
        glm::normalize(glm::dvec3(stage.camera().eye) - glm::dvec3(stage.camera().target));
    glm::dvec3 target = center;
    double seen = radius;
    if (stage.ray() && glm::length(glm::dvec3(stage.ray()->direction)) > 0.0) {
        from = direction_beside(glm::dvec3(stage.ray()->direction), upwards);
        // What the ray does is small beside the scene: nearer to where it goes in and ends.
        target = glm::mix(center, end_of_walk(stage, state, center), 0.6);
        seen = 0.85 * radius;
    }
    const double half = glm::radians(static_cast<double>(angle)) / 2.0;
    const double narrow = std::atan(std::tan(half) * std::min(aspect_ratio, 1.0));
    Camera camera;
    camera.target = target;
    camera.eye = target + from * (seen / std::sin(narrow));
    const bool steep = std::abs(glm::dot(from, upwards)) > 0.98;
    camera.up = glm::vec3(steep ? glm::dvec3(upwards.y, upwards.z, upwards.x) : upwards);
    camera.vertical_field_of_view = angle;
    return camera;
}

Camera fly_to_step(const Stage& stage, const State& state, const Camera& from) {
    const Pane& pane = *stage.panes().front();
    const RecordedWalk* walk = walk_in(pane, state);
    const bool has_step = walk && !walk->steps.empty();
    const int cell = has_step ? walk->steps[step_in(*walk, state)].cell : no_cell;
    const int shown = state.selected >= 0 ? state.selected : cell;
    if (shown < 0 || static_cast<std::size_t>(shown) >= pane.cells.cells.size()) {
        return from;
    }
    const Box& box = pane.cells.cells[static_cast<std::size_t>(shown)].box;
    const glm::dvec3 center = 0.5 * (glm::dvec3(box.lower) + glm::dvec3(box.upper));
    const double radius =
        std::max(0.5 * glm::length(glm::dvec3(box.upper) - glm::dvec3(box.lower)), 1e-12);
    const glm::dvec3 sight = glm::dvec3(from.eye) - glm::dvec3(from.target);
    Camera camera = from;
    camera.target = center;
    camera.eye = center + glm::normalize(sight) * (3.0 * radius / std::sin(glm::radians(15.0)));
    return camera;
}

} // namespace raysteps::view
