#pragma once

#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace raysteps {

// A closed sphere around the origin, of stacks from pole to pole and slices around it:
// 2 * slices * (stacks - 1) triangles. Neighbours share the very same corners.
inline std::vector<glm::vec3> sphere_mesh(float radius, int stacks, int slices) {
    const auto point = [&](int stack, int slice) {
        if (stack == 0 || stack == stacks) {
            return glm::vec3(0.0f, 0.0f, stack == 0 ? radius : -radius);
        }
        const double polar = std::numbers::pi * stack / stacks;
        const double around = 2.0 * std::numbers::pi * (slice % slices) / slices;
        return glm::vec3(radius * std::sin(polar) * std::cos(around),
                         radius * std::sin(polar) * std::sin(around), radius * std::cos(polar));
    };
    std::vector<glm::vec3> corners;
    for (int stack = 0; stack < stacks; ++stack) {
        for (int slice = 0; slice < slices; ++slice) {
            const glm::vec3 a = point(stack, slice);
            const glm::vec3 b = point(stack + 1, slice);
            const glm::vec3 c = point(stack + 1, slice + 1);
            const glm::vec3 d = point(stack, slice + 1);
            if (stack + 1 < stacks) {
                corners.insert(corners.end(), {a, b, c});
            }
            if (stack > 0) {
                corners.insert(corners.end(), {a, c, d});
            }
        }
    }
    return corners;
}

} // namespace raysteps
