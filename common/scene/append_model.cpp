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

void append_names(Scene& scene, const Scene& model) {
    const int first_triangle = static_cast<int>(scene.triangle_materials.size());
    const int first_model = static_cast<int>(scene.models.size());
    for (NamedRun run : model.runs) {
        run.first_triangle += first_triangle;
        run.model += first_model;
        scene.runs.push_back(std::move(run));
    }
    scene.faces.insert(scene.faces.end(), model.faces.begin(), model.faces.end());
}

// Where only one of both has colours, the other is white.
void append_colors(Scene& scene, const Scene& model, std::size_t first_corner, bool mirrors) {
    if (scene.corner_colors.empty() && model.corner_colors.empty()) {
        return;
    }
    std::vector<glm::vec3>& colors = scene.corner_colors;
    colors.resize(first_corner, glm::vec3(1.0f));
    colors.insert(colors.end(), model.corner_colors.begin(), model.corner_colors.end());
    colors.resize(scene.corners.size(), glm::vec3(1.0f));
    for (std::size_t i = first_corner; mirrors && i < colors.size(); i += 3) {
        std::swap(colors[i + 1], colors[i + 2]);
    }
}

Camera transformed(Camera camera, const glm::dmat3& linear, const glm::dvec3& translation) {
    camera.eye = glm::vec3(linear * glm::dvec3(camera.eye) + translation);
    camera.target = glm::vec3(linear * glm::dvec3(camera.target) + translation);
    camera.up = glm::vec3(glm::normalize(linear * glm::dvec3(camera.up)));
    return camera;
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
    glm::dvec3 translation(whole[3]);
    if (model.origin != glm::dvec3(0.0) || scene.origin != glm::dvec3(0.0)) {
        translation += linear * model.origin - scene.origin;
    }
    for (const glm::vec3& corner : model.corners) {
        scene.corners.push_back(glm::vec3(linear * glm::dvec3(corner) + translation));
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
    append_names(scene, model);
    append_colors(scene, model, first_corner, mirrors);
    for (Light light : model.lights) {
        light.position = glm::vec3(linear * glm::dvec3(light.position) + translation);
        scene.lights.push_back(light);
    }
    if (model.file_camera && !scene.file_camera) {
        scene.file_camera = transformed(*model.file_camera, linear, translation);
    }
    for (const int material : model.triangle_materials) {
        scene.triangle_materials.push_back(first_material + material);
    }
    scene.materials.insert(scene.materials.end(), model.materials.begin(), model.materials.end());
    scene.enclosed.insert(scene.enclosed.end(), model.enclosed.begin(), model.enclosed.end());
    scene.models.insert(scene.models.end(), model.models.begin(), model.models.end());
    scene.messages.insert(scene.messages.end(), model.messages.begin(), model.messages.end());
    return scene;
}

} // namespace raysteps
