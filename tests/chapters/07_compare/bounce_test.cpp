#include "basics/random_numbers.h"
#include "catch.h"
#include "measure/cosine_direction.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace raysteps;

TEST_CASE("bounces leave with the density of the cosine", "[07][bounce]") {
    const int seed = 7;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const glm::vec3 normal = glm::normalize(glm::vec3(1.0f, -2.0f, 2.0f));
    constexpr int count = 100'000;
    double least = 1.0;
    double cosines = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
        glm::vec3 point = numbers.in_cube();
        while (glm::dot(point, point) > 1.0f || glm::dot(point, point) < 1e-4f) {
            point = numbers.in_cube();
        }
        const double cosine =
            static_cast<double>(glm::dot(glm::normalize(cosine_direction(normal, point)), normal));
        least = std::min(least, cosine);
        cosines += cosine;
        squares += cosine * cosine;
    }
    CHECK(least > 0.0);
    // A cosine's variance is 1 / 2 - 4 / 9 = 1 / 18, so its mean strays by 7.5e-4 (one sigma), and
    // that of its square (variance 1 / 12) by 9.1e-4. Five of these are under 5e-3.
    CHECK(std::abs(cosines / count - 2.0 / 3.0) < 5e-3);
    CHECK(std::abs(squares / count - 0.5) < 5e-3);
}

TEST_CASE("a bounce whose point is opposite to the normal goes along the normal", "[07][bounce]") {
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    CHECK(cosine_direction(up, -0.5f * up) == up);
    CHECK(cosine_direction(up, 0.5f * up) == 2.0f * up);
}
