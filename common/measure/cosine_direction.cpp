#include "measure/cosine_direction.h"

#include <glm/geometric.hpp>

namespace raysteps {

namespace {

// Of a direction whose rounding may turn it below the surface.
constexpr float least_square = 1e-4f;

} // namespace

// A normal plus a point on the unit sphere is a direction with the density of the cosine.
glm::vec3 cosine_direction(const glm::vec3& normal, const glm::vec3& point) {
    //# exercise 7.4: a bounce
    const glm::vec3 direction = normal + glm::normalize(point);
    return glm::dot(direction, direction) > least_square ? direction : normal;
    //# stub: static_cast<void>(point);
    //# stub: return normal;
    //# end
}

} // namespace raysteps
