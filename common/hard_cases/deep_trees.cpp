#include "hard_cases/deep_trees.h"

#include "scene/random_numbers.h"
#include "scene/shapes.h"

#include <cmath>

namespace raysteps {

namespace {

void append(std::vector<glm::vec3>& corners, const std::vector<glm::vec3>& more) {
    corners.insert(corners.end(), more.begin(), more.end());
}

} // namespace

std::vector<glm::vec3> triangle_around(const glm::vec3& center, const glm::vec3& a) {
    return {center - a, center + a, center + glm::vec3(a.x, -a.y, a.z)};
}

std::vector<glm::vec3> concentric_triangles(int seed, int count) {
    RandomNumbers numbers(seed);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < count; ++i) {
        append(corners, triangle_around(glm::vec3(0.0f), numbers.in_cube()));
    }
    return corners;
}

std::vector<glm::vec3> triangles_at_powers_of_two() {
    std::vector<glm::vec3> corners;
    for (int i = -60; i <= 60; ++i) {
        const float size = std::ldexp(1.0f, i);
        append(corners, triangle_around(glm::vec3(size), glm::vec3(0.1f * size)));
    }
    return corners;
}

std::vector<glm::vec3> shells(int count) {
    std::vector<glm::vec3> corners;
    for (int i = 1; i <= count; ++i) {
        append(corners, triangle_around(glm::vec3(0.0f), glm::vec3(static_cast<float>(i))));
    }
    return corners;
}

std::vector<glm::vec3> heaps_at_the_end_of_floats(int seed) {
    RandomNumbers numbers(seed);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 64; ++i) {
        const glm::vec3 heap(i % 2 == 0 ? -8.0f : 8.0f, 0.0f, 0.0f);
        for (const glm::vec3& corner : triangle_around(heap + numbers.in_cube(), {1, 1, 1})) {
            corners.push_back(1e29f * corner);
        }
    }
    return corners;
}

std::vector<glm::vec3> box_in_the_corner_of_a_box() {
    return join(box(glm::vec3(0.0f), glm::vec3(1.0f)), box(glm::vec3(0.0f), glm::vec3(0.5f)))
        .corners;
}

std::vector<glm::vec3> triangles_at_doubling_distances() {
    std::vector<glm::vec3> corners{{0, 0, 0}, {0, 0.25f, 0}, {0, 0, 0.25f}};
    for (float x = 1.0f; x < 16384.0f; x *= 2.0f) {
        append(corners, {{x, 0, 0}, {x, 0.25f, 0}, {x, 0, 0.25f}});
    }
    return corners;
}

} // namespace raysteps
