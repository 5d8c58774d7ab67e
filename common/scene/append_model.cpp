#include "scene/append_model.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cstddef>
#include <utility>

namespace raysteps {

namespace {

// The cofactors of the linear part are its inverse transpose times the determinant; what is left of
// that factor is its sign, since normals get length 1 again. Nothing is divided.
glm::dmat3 normal_matrix(const glm::dmat3& linear) {
    const glm::dmat3 cofactors{glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1])};
    return glm::determinant(linear) < 0.0 ? -cofactors : cofactors;
}

} // namespace

Scene append_model(Scene scene, const Scene& model, const glm::mat4& transform) {
    const glm::dmat4 whole(transform);
    const glm::dmat3 linear(whole);
    const glm::dmat3 for_normals = normal_matrix(linear);
    const bool mirrors = glm::determinant(linear) < 0.0;
    const std::size_t first_corner = scene.corners.size();
    const int first_triangle = triangle_count(scene) + static_cast<int>(scene.left_out.size());
    const int first_material = static_cast<int>(scene.materials.size());

    for (const int triangle : model.left_out) {
        scene.left_out.push_back(first_triangle + triangle);
    }
    for (const glm::vec3& corner : model.corners) {
        scene.corners.push_back(glm::vec3(linear * glm::dvec3(corner) + glm::dvec3(whole[3])));
    }
    for (const glm::vec3& normal : model.normals) {
        scene.normals.push_back(glm::vec3(glm::normalize(for_normals * glm::dvec3(normal))));
    }
    scene.texture_coordinates.insert(scene.texture_coordinates.end(),
                                     model.texture_coordinates.begin(),
                                     model.texture_coordinates.end());
    for (std::size_t i = first_corner; mirrors && i < scene.corners.size(); i += 3) {
        std::swap(scene.corners[i + 1], scene.corners[i + 2]);
        std::swap(scene.normals[i + 1], scene.normals[i + 2]);
        std::swap(scene.texture_coordinates[i + 1], scene.texture_coordinates[i + 2]);
    }
    for (const int material : model.triangle_materials) {
        scene.triangle_materials.push_back(first_material + material);
    }
    scene.materials.insert(scene.materials.end(), model.materials.begin(), model.materials.end());
    scene.models.insert(scene.models.end(), model.models.begin(), model.models.end());
    scene.messages.insert(scene.messages.end(), model.messages.begin(), model.messages.end());
    return scene;
}

} // namespace raysteps
