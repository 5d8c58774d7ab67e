#pragma once

#include "visualizer/replay/recorded_path.h"

#include <glm/vec3.hpp>

// The colours of the drawings, in sRGB. Those that tell things apart are of the set by Okabe and
// Ito, "Color Universal Design", 2008, which people with any kind of colour vision can tell apart.
namespace raysteps::view {

inline constexpr glm::vec3 paper{0.985f, 0.985f, 0.975f};
inline constexpr glm::vec3 panel{0.935f, 0.940f, 0.948f};
inline constexpr glm::vec3 ink{0.12f, 0.14f, 0.18f};
inline constexpr glm::vec3 faint_ink{0.42f, 0.45f, 0.50f};
inline constexpr glm::vec3 warning_ink{0.72f, 0.10f, 0.08f};
inline constexpr glm::vec3 rule_color{0.78f, 0.80f, 0.83f};

inline constexpr glm::vec3 model_color{0.58f, 0.63f, 0.70f};
inline constexpr glm::vec3 current_color{0.90f, 0.62f, 0.00f}; // orange
inline constexpr glm::vec3 culled_color{0.55f, 0.55f, 0.55f};
inline constexpr glm::vec3 tested_color{0.34f, 0.71f, 0.91f};   // sky blue
inline constexpr glm::vec3 hit_color{0.84f, 0.37f, 0.00f};      // vermillion
inline constexpr glm::vec3 selected_color{0.80f, 0.47f, 0.65f}; // reddish purple

inline glm::vec3 color_of(RayRole role) {
    switch (role) {
    case RayRole::shadow:
        return {0.25f, 0.25f, 0.25f};
    case RayRole::mirror:
        return {0.00f, 0.62f, 0.45f}; // bluish green
    case RayRole::refraction:
        return {0.64f, 0.31f, 0.50f}; // reddish purple, darker
    case RayRole::camera:
        break;
    }
    return {0.00f, 0.45f, 0.70f}; // blue
}

// A mark of the step's outcome on the slider.
inline glm::vec3 color_of(const Step& step) {
    if (is_culled(step.outcome)) {
        return {0.72f, 0.72f, 0.72f};
    }
    if (step.end_test > step.first_test) {
        return tested_color;
    }
    return step.outcome == Outcome::leaf ? glm::vec3(0.62f, 0.80f, 0.74f)
                                         : glm::vec3(0.50f, 0.62f, 0.78f);
}

} // namespace raysteps::view
