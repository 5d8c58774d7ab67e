#include "framing.h"

#include "layout.h"
#include "why.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace raysteps::view {

namespace {

constexpr float angle = 30.0f;

// The direction from which the ray is seen from the side, a little from above and from behind.
glm::dvec3 direction_beside(const glm::dvec3& ray, const glm::dvec3& upwards) {
    const glm::dvec3 along = glm::normalize(ray);
    glm::dvec3 aside = glm::cross(along, upwards);
    if (glm::length(aside) < 1e-3) {
        aside = glm::cross(along, glm::dvec3(along.y, along.z, along.x));
    }
    return glm::normalize(glm::normalize(aside) - 0.35 * along + 0.35 * upwards);
}

// The fraction of a pane's half width and half height that the scene may fill; a title stands
// above.
constexpr double room = 0.94;
constexpr double room_above = 0.80;

// How far back and how far aside a camera must stand, along one axis of its picture.
struct Stand {
    double back = 0.0;
    double aside = 0.0;
};

// `lower` and `upper` are the tangents of the angles to the two ends of the picture. A corner at
// `along` the axis and `before` the middle is visible if along - aside <= (back - before) upper and
// aside - along <= (back - before) lower: both hold with equality for the outermost corners.
Stand stand_of(std::span<const glm::dvec2> along_and_before, double lower, double upper) {
    double to_upper = std::numeric_limits<double>::lowest();
    double to_lower = std::numeric_limits<double>::lowest();
    for (const glm::dvec2& corner : along_and_before) {
        to_upper = std::max(to_upper, corner.y + corner.x / upper);
        to_lower = std::max(to_lower, corner.y - corner.x / lower);
    }
    const double aside = (to_upper - to_lower) / (1.0 / upper + 1.0 / lower);
    return {to_upper - aside / upper, aside};
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

Camera frame_stage(const Stage& stage, double aspect_ratio) {
    const glm::dvec3 upwards = glm::normalize(glm::dvec3(stage.camera().up));
    const Box& bounds = stage.bounds();
    const bool nothing = is_empty(bounds);
    const glm::dvec3 lower = nothing ? glm::dvec3(-0.5) : glm::dvec3(bounds.lower);
    const glm::dvec3 upper = nothing ? glm::dvec3(0.5) : glm::dvec3(bounds.upper);
    const glm::dvec3 center = 0.5 * (lower + upper);
    glm::dvec3 from =
        glm::normalize(glm::dvec3(stage.camera().eye) - glm::dvec3(stage.camera().target));
    if (stage.ray() && glm::length(glm::dvec3(stage.ray()->direction)) > 0.0) {
        from = direction_beside(glm::dvec3(stage.ray()->direction), upwards);
    }
    const bool steep = std::abs(glm::dot(from, upwards)) > 0.98;
    const glm::dvec3 up = steep ? glm::dvec3(upwards.y, upwards.z, upwards.x) : upwards;
    const glm::dvec3 rightwards = glm::normalize(glm::cross(up, from));
    const glm::dvec3 picture_up = glm::cross(from, rightwards);
    std::array<glm::dvec2, 8> across;
    std::array<glm::dvec2, 8> upright;
    for (unsigned i = 0; i < 8; ++i) {
        const glm::dvec3 corner =
            glm::dvec3((i & 1u) != 0 ? upper.x : lower.x, (i & 2u) != 0 ? upper.y : lower.y,
                       (i & 4u) != 0 ? upper.z : lower.z) -
            center;
        across[i] = {glm::dot(corner, rightwards), glm::dot(corner, from)};
        upright[i] = {glm::dot(corner, picture_up), glm::dot(corner, from)};
    }
    const double tangent = std::tan(glm::radians(static_cast<double>(angle)) / 2.0);
    const double wide = room * aspect_ratio * tangent;
    const Stand sideways = stand_of(across, wide, wide);
    const Stand vertical = stand_of(upright, room * tangent, room_above * tangent);
    Camera camera;
    camera.target = center + sideways.aside * rightwards + vertical.aside * picture_up;
    camera.eye = glm::dvec3(camera.target) + from * std::max({sideways.back, vertical.back, 1e-12});
    camera.up = glm::vec3(up);
    camera.vertical_field_of_view = angle;
    return camera;
}

namespace {

// What is looked at from close by; nothing where there is nothing.
std::optional<Box> box_to_see(const Stage& stage, const State& state) {
    if (const auto why = why_of(stage, state)) {
        const Box triangle = bounds_of(why->corners);
        return why->box ? merge(triangle, *why->box) : triangle;
    }
    const Pane& pane = *stage.panes().front();
    const RecordedWalk* walk = walk_in(pane, state);
    const bool has_step = walk && !walk->steps.empty();
    const int cell = has_step ? walk->steps[step_in(*walk, state)].cell : no_cell;
    const int shown = state.selected >= 0 ? state.selected : cell;
    if (shown < 0 || static_cast<std::size_t>(shown) >= pane.cells.cells.size()) {
        return std::nullopt;
    }
    return pane.cells.cells[static_cast<std::size_t>(shown)].box;
}

Camera viewpoint_of(const Stage& stage, const State& state) {
    const Area pane = layout_of(state, stage.panes().size()).panes.front();
    return state.viewpoint.value_or(
        frame_stage(stage, static_cast<double>(pane.width) / pane.height));
}

} // namespace

Camera fly_to_step(const Stage& stage, const State& state) {
    const Camera from = viewpoint_of(stage, state);
    const auto box = box_to_see(stage, state);
    if (!box) {
        return from;
    }
    const glm::dvec3 center = 0.5 * (glm::dvec3(box->lower) + glm::dvec3(box->upper));
    const double radius =
        std::max(0.5 * glm::length(glm::dvec3(box->upper) - glm::dvec3(box->lower)), 1e-12);
    const glm::dvec3 sight = glm::dvec3(from.eye) - glm::dvec3(from.target);
    Camera camera = from;
    camera.target = center;
    camera.eye = center + glm::normalize(sight) * (3.0 * radius / std::sin(glm::radians(15.0)));
    return camera;
}

} // namespace raysteps::view
