#include "scene/glowing_lights.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace raysteps {

namespace {

using Corners = std::array<glm::vec3, 3>;

Corners corners_of(const Scene& scene, int triangle) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return {scene.corners[first], scene.corners[first + 1], scene.corners[first + 2]};
}

bool glows(const Scene& scene, int triangle) {
    const int material = scene.triangle_materials[static_cast<std::size_t>(triangle)];
    return scene.materials[static_cast<std::size_t>(material)].emission != glm::vec3(0.0f);
}

// Where in the first triangle the corner is that the second one does not have; none where they do
// not share an edge.
std::optional<std::size_t> lone_corner(const Corners& first, const Corners& second) {
    std::optional<std::size_t> lone;
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::find(second.begin(), second.end(), first[i]) == second.end()) {
            if (lone) {
                return std::nullopt;
            }
            lone = i;
        }
    }
    return lone;
}

float greatest_of(const glm::vec3& vector) {
    const glm::vec3 sizes = glm::abs(vector);
    return std::max({sizes.x, sizes.y, sizes.z});
}

// The parallelogram of two triangles that share a diagonal, without a colour; none where they make
// another shape. Its diagonals have the same middle. Each coordinate of a file is rounded by 2^-24
// of its size, and by a transform a few times more, so sums of two corners agree to 2^-20 of it.
std::optional<Light> parallelogram(const Corners& first, const Corners& second) {
    const std::optional<std::size_t> one = lone_corner(first, second);
    const std::optional<std::size_t> other = lone_corner(second, first);
    if (!one || !other) {
        return std::nullopt;
    }
    const glm::vec3 corner = first[*one];
    const glm::vec3 next = first[(*one + 1) % 3];
    const glm::vec3 last = first[(*one + 2) % 3];
    const float greatest = std::max({greatest_of(corner), greatest_of(next), greatest_of(last)});
    const glm::vec3 gap = (next - corner) - (second[*other] - last);
    const Light light{0.5f * next + 0.5f * last, {}, next - corner, last - corner};
    const bool has_size =
        glm::cross(glm::dvec3(light.across), glm::dvec3(light.along)) != glm::dvec3(0.0);
    if (!has_size || greatest_of(gap) > std::ldexp(greatest, -20)) {
        return std::nullopt;
    }
    return light;
}

} // namespace

std::vector<Light> glowing_lights(Scene& scene) {
    std::vector<Light> lights;
    std::size_t unused = 0;
    for (int i = 0; i < triangle_count(scene); ++i) {
        if (!glows(scene, i)) {
            continue;
        }
        const bool has_next = i + 1 < triangle_count(scene) && glows(scene, i + 1);
        std::optional<Light> light =
            has_next && lights.size() < most_glowing_lights
                ? parallelogram(corners_of(scene, i), corners_of(scene, i + 1))
                : std::nullopt;
        if (!light) {
            ++unused;
            continue;
        }
        const int material = scene.triangle_materials[static_cast<std::size_t>(i)];
        const glm::vec3 emission = scene.materials[static_cast<std::size_t>(material)].emission;
        light->color = emission / std::max(1.0f, greatest_of(emission));
        lights.push_back(*light);
        ++i; // the other half
    }
    if (unused > 0) {
        scene.messages.push_back(std::to_string(unused) +
                                 (unused == 1 ? " triangle glows" : " triangles glow") +
                                 " (Ke) and light nothing else: lights are the first " +
                                 std::to_string(most_glowing_lights) +
                                 " parallelograms that glow. Name lights in a scene file.");
    }
    return lights;
}

} // namespace raysteps
