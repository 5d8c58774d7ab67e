#include "scene/mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <map>
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

namespace {

// Some direction across the edge, of length 1: across the axis that it runs along least.
glm::dvec3 any_normal_across(const glm::dvec3& edge) {
    const glm::dvec3 along = glm::abs(edge);
    glm::dvec3 axis(0.0);
    axis[along.x <= along.y && along.x <= along.z ? 0 : along.y <= along.z ? 1 : 2] = 1.0;
    const glm::dvec3 across = glm::cross(edge, axis);
    return across == glm::dvec3(0.0) ? axis : glm::normalize(across);
}

glm::dvec3 longest_edge(std::span<const glm::vec3> corners, std::size_t first) {
    glm::dvec3 longest(0.0);
    for (std::size_t at = 0; at < 3; ++at) {
        const glm::dvec3 edge =
            glm::dvec3(corners[first + (at + 1) % 3]) - glm::dvec3(corners[first + at]);
        longest = glm::length(edge) > glm::length(longest) ? edge : longest;
    }
    return longest;
}

// -0 and 0 are the same place.
std::array<float, 3> place_of(const glm::vec3& corner) {
    return {corner.x + 0.0f, corner.y + 0.0f, corner.z + 0.0f};
}

bool is_direction(const WeightedNormal& weighted) {
    return glm::length(weighted.sum) > least_agreement * weighted.angles;
}

// For the triangles without area, which begin at those corners.
void borrow_normals(std::vector<glm::vec3>& normals, std::span<const glm::vec3> corners,
                    std::span<const std::size_t> without_area) {
    std::map<std::array<float, 3>, WeightedNormal> around;
    for (const std::size_t first : without_area) {
        for (std::size_t at = 0; at < 3; ++at) {
            around[place_of(corners[first + at])];
        }
    }
    for (std::size_t i = 0; i < corners.size() && !around.empty(); ++i) {
        const auto found = around.find(place_of(corners[i]));
        const std::size_t first = i - i % 3;
        const glm::dvec3 area = area_vector(corners[first], corners[first + 1], corners[first + 2]);
        if (found != around.end() && area != glm::dvec3(0.0)) {
            const double angle = corner_angle(corners, first, i % 3);
            found->second.sum += angle * glm::normalize(area);
            found->second.angles += angle;
        }
    }
    for (const std::size_t first : without_area) {
        const glm::dvec3 across = any_normal_across(longest_edge(corners, first));
        for (std::size_t at = 0; at < 3; ++at) {
            const WeightedNormal& weighted = around.at(place_of(corners[first + at]));
            normals[first + at] = is_direction(weighted) ? glm::normalize(weighted.sum) : across;
        }
    }
}

} // namespace

std::vector<glm::vec3> corner_normals(std::span<const glm::vec3> corners,
                                      std::span<const std::int64_t> surfaces) {
    std::vector<glm::vec3> normals(corners.size());
    std::unordered_map<std::int64_t, WeightedNormal> shared;
    std::vector<std::size_t> without_area; // the first corner of each such triangle
    for (std::size_t first = 0; first < corners.size(); first += 3) {
        const glm::dvec3 area = area_vector(corners[first], corners[first + 1], corners[first + 2]);
        if (area == glm::dvec3(0.0)) {
            without_area.push_back(first);
            continue;
        }
        const glm::dvec3 normal = glm::normalize(area);
        for (std::size_t at = 0; at < 3; ++at) {
            normals[first + at] = normal;
            if (surfaces.empty() || surfaces[first + at] == flat)
                continue;
            const double angle = corner_angle(corners, first, at);
            WeightedNormal& weighted = shared[surfaces[first + at]];
            weighted.sum += angle * normal;
            weighted.angles += angle;
        }
    }
    borrow_normals(normals, corners, without_area);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (surfaces[i] == flat)
            continue;
        const WeightedNormal& weighted = shared[surfaces[i]];
        if (is_direction(weighted))
            normals[i] = glm::normalize(weighted.sum);
    }
    return normals;
}

} // namespace raysteps
