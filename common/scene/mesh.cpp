#include "scene/mesh.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <unordered_map>

namespace raysteps {

Mesh join(Mesh first, const Mesh& second) {
    first.corners.insert(first.corners.end(), second.corners.begin(), second.corners.end());
    first.normals.insert(first.normals.end(), second.normals.begin(), second.normals.end());
    return first;
}

Scene add_mesh(Scene scene, const Mesh& mesh, const Material& material) {
    const int material_index = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene.corners.insert(scene.corners.end(), mesh.corners.begin(), mesh.corners.end());
    scene.normals.insert(scene.normals.end(), mesh.normals.begin(), mesh.normals.end());
    scene.texture_coordinates.resize(scene.corners.size(), glm::vec2(0.0f));
    scene.triangle_materials.resize(scene.corners.size() / 3, material_index);
    return scene;
}

namespace {

// Normals in double are right to a few 1e-16. A sum a billion times shorter than the angles that
// went into it is what is left when opposite faces cancel out: mostly rounding, not a direction.
constexpr double least_agreement = 1e-9;

struct WeightedNormal {
    glm::dvec3 sum{0.0};
    double angles = 0.0;
};

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// At the corner `at` of the triangle that begins at `first`.
double corner_angle(std::span<const glm::vec3> corners, std::size_t first, std::size_t at) {
    const glm::dvec3 apex = corners[first + at];
    return angle_between(glm::dvec3(corners[first + (at + 1) % 3]) - apex,
                         glm::dvec3(corners[first + (at + 2) % 3]) - apex);
}

} // namespace

glm::dvec3 area_vector(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
}

std::vector<glm::vec3> corner_normals(std::span<const glm::vec3> corners,
                                      std::span<const std::int64_t> surfaces) {
    std::vector<glm::vec3> normals(corners.size());
    std::unordered_map<std::int64_t, WeightedNormal> shared;
    for (std::size_t first = 0; first < corners.size(); first += 3) {
        const glm::dvec3 normal =
            glm::normalize(area_vector(corners[first], corners[first + 1], corners[first + 2]));
        for (std::size_t at = 0; at < 3; ++at) {
            normals[first + at] = normal;
            if (surfaces[first + at] == flat)
                continue;
            const double angle = corner_angle(corners, first, at);
            WeightedNormal& weighted = shared[surfaces[first + at]];
            weighted.sum += angle * normal;
            weighted.angles += angle;
        }
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (surfaces[i] == flat)
            continue;
        const WeightedNormal& weighted = shared[surfaces[i]];
        if (glm::length(weighted.sum) > least_agreement * weighted.angles)
            normals[i] = glm::normalize(weighted.sum);
    }
    return normals;
}

} // namespace raysteps
