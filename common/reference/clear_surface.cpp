#include "reference/clear_surface.h"

#include <glm/exponential.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raysteps {

double fresnel_by_angle(double angle, double index_before, double index_behind) {
    if (index_before == index_behind) {
        return 0.0;
    }
    const double sine_behind = std::sin(angle) * index_before / index_behind;
    if (sine_behind >= 1.0) {
        return 1.0;
    }
    const double behind = std::asin(sine_behind);
    if (angle < 1e-6) { // 0 / 0 there: the limit
        const double ratio = (index_before - index_behind) / (index_before + index_behind);
        return ratio * ratio;
    }
    const double across = std::sin(angle - behind) / std::sin(angle + behind);
    const double along = std::tan(angle - behind) / std::tan(angle + behind);
    return 0.5 * (across * across + along * along);
}

double clear_part(const Material& material) {
    if (material.opacity < 1.0f) {
        return 1.0 - static_cast<double>(material.opacity);
    }
    switch (material.illumination_model) {
    case 4:
    case 6:
    case 7:
    case 9:
        return 1.0;
    default:
        return 0.0;
    }
}

Passage passage(const Bodies& inside, const Material* material, bool outside) {
    Passage passage{inside, inside};
    if (outside) {
        passage.behind.push_back(material);
        return passage;
    }
    Bodies& behind = passage.behind;
    const auto innermost = std::find(behind.rbegin(), behind.rend(), material);
    if (innermost == behind.rend()) {
        passage.before.push_back(material); // it was in there from the start
        return passage;
    }
    behind.erase(std::next(innermost).base());
    return passage;
}

double index_of(const Bodies& bodies) {
    return bodies.empty() ? 1.0 : static_cast<double>(bodies.back()->refractive_index);
}

glm::dvec3 left_after(const Material& material, double distance) {
    return glm::pow(glm::dvec3(material.transmission), glm::dvec3(distance));
}

} // namespace raysteps
