#include "scene/mapping.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace raysteps {

namespace {

glm::vec2 flat_coordinate(const glm::vec3& point, const glm::vec3& normal, float size) {
    const glm::vec3 facing = glm::abs(normal);
    if (facing.y >= facing.x && facing.y >= facing.z) {
        return glm::vec2(point.x, -point.z) / size;
    }
    return (facing.x >= facing.z ? glm::vec2(point.z, point.y) : glm::vec2(point.x, point.y)) /
           size;
}

glm::vec2 round_coordinate(const glm::vec3& direction) {
    constexpr float pi = std::numbers::pi_v<float>;
    const float longitude = std::atan2(direction.x, direction.z);
    return {0.5f + longitude / (2.0f * pi), 0.5f + std::asin(direction.y) / pi};
}

} // namespace

Scene map_flat(Scene scene, int first, float size) {
    for (auto corner = 3 * static_cast<std::size_t>(first); corner < scene.corners.size();
         ++corner) {
        const std::size_t a = corner / 3 * 3;
        const glm::vec3 normal = glm::cross(scene.corners[a + 1] - scene.corners[a],
                                            scene.corners[a + 2] - scene.corners[a]);
        scene.texture_coordinates[corner] = flat_coordinate(scene.corners[corner], normal, size);
    }
    return scene;
}

Scene map_around(Scene scene, int first, const glm::vec3& center) {
    for (auto a = 3 * static_cast<std::size_t>(first); a < scene.corners.size(); a += 3) {
        for (std::size_t corner = a; corner < a + 3; ++corner) {
            glm::vec2 place = round_coordinate(glm::normalize(scene.corners[corner] - center));
            // A triangle over the seam goes on beyond the picture's edge, not back through it all.
            if (corner > a) {
                place.x += std::round(scene.texture_coordinates[a].x - place.x);
            }
            scene.texture_coordinates[corner] = place;
        }
    }
    return scene;
}

} // namespace raysteps
