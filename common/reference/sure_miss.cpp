#include "reference/sure_miss.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace raysteps {

namespace {

// The bound of Shewchuk's orient3d ("Adaptive precision floating-point arithmetic and fast robust
// geometric predicates", 1997, section 4.3): a 3 x 3 determinant of rounded differences is wrong by
// at most (7 + 56 e) e times the same sum with absolute values, where e = 2^-53. Our third row, the
// direction, is not even rounded. Finite floats cannot overflow in it, nor underflow: products of
// three lie between 2^-447 and 2^390. One e more pays for rounding the bound itself.
constexpr double error_factor = 8.0 / 9007199254740992.0; // 8 * 2^-53

// -1, 0 or +1: the sign of direction . (a x b), or 0 where rounding leaves it open.
int sure_sign_of_volume(const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b) {
    const double volume = glm::dot(direction, glm::cross(a, b));
    const double magnitude = std::abs(direction.x) * (std::abs(a.y * b.z) + std::abs(a.z * b.y)) +
                             std::abs(direction.y) * (std::abs(a.z * b.x) + std::abs(a.x * b.z)) +
                             std::abs(direction.z) * (std::abs(a.x * b.y) + std::abs(a.y * b.x));
    const double error = error_factor * magnitude;
    return static_cast<int>(volume > error) - static_cast<int>(volume < -error);
}

} // namespace

// Inside, the three volumes have one sign; so two that surely differ prove a miss.
bool surely_misses(const Ray& ray, const std::array<glm::vec3, 3>& corners) {
    const glm::dvec3 origin(ray.origin);
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 a = glm::dvec3(corners[0]) - origin;
    const glm::dvec3 b = glm::dvec3(corners[1]) - origin;
    const glm::dvec3 c = glm::dvec3(corners[2]) - origin;
    const int sign_a = sure_sign_of_volume(direction, b, c);
    const int sign_b = sure_sign_of_volume(direction, c, a);
    const int sign_c = sure_sign_of_volume(direction, a, b);
    return sign_a * sign_b < 0 || sign_b * sign_c < 0 || sign_c * sign_a < 0;
}

} // namespace raysteps
