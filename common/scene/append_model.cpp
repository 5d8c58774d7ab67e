#include "scene/append_model.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cstddef>
#include <iterator>
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

// Behind what there is; the first of all is not copied.
template <class Value>
void take(std::vector<Value>& values, std::vector<Value>&& more) {
    if (values.empty()) {
        values = std::move(more);
        return;
    }
    values.insert(values.end(), std::make_move_iterator(more.begin()),
                  std::make_move_iterator(more.end()));
}

void append_names(Scene& scene, Scene& model) {
    const int first_triangle = static_cast<int>(scene.triangle_materials.size());
    const int first_model = static_cast<int>(scene.models.size());
    for (NamedRun run : model.runs) {
        run.first_triangle += first_triangle;
        run.model += first_model;
        scene.runs.push_back(std::move(run));
    }
    take(scene.faces, std::move(model.faces));
}

template <class Value>
void swap_second_and_third(std::vector<Value>& of_corners) {
    for (std::size_t i = 0; i + 2 < of_corners.size(); i += 3) {
        std::swap(of_corners[i + 1], of_corners[i + 2]);
    }
}

// Of what not every model has at its corners: where only one of both has it, the other gets `none`.
template <class Value>
void take_at_corners(std::vector<Value>& values, std::vector<Value>&& more,
                     std::size_t first_corner, std::size_t end_corner, const Value& none) {
    if (values.empty() && more.empty()) {
        return;
    }
    values.resize(first_corner, none);
    take(values, std::move(more));
    values.resize(end_corner, none);
}

Camera transformed(Camera camera, const glm::dmat3& linear, const glm::dvec3& translation) {
    camera.eye = glm::vec3(linear * glm::dvec3(camera.eye) + translation);
    camera.target = glm::vec3(linear * glm::dvec3(camera.target) + translation);
    camera.up = glm::vec3(glm::normalize(linear * glm::dvec3(camera.up)));
    return camera;
}

} // namespace

Scene append_model(Scene scene, Scene model, const glm::mat4& transform) {
    const glm::dmat4 whole(transform);
    const glm::dmat3 linear(whole);
    const glm::dmat3 for_normals = normal_matrix(linear);
    const std::size_t first_corner = scene.corners.size();
    const int first_triangle = triangle_count(scene) + static_cast<int>(scene.left_out.size());
    const int first_material = static_cast<int>(scene.materials.size());

    glm::dvec3 translation(whole[3]);
    if (model.origin != glm::dvec3(0.0) || scene.origin != glm::dvec3(0.0)) {
        translation += linear * model.origin - scene.origin;
    }
    for (glm::vec3& corner : model.corners) {
        corner = glm::vec3(linear * glm::dvec3(corner) + translation);
    }
    for (glm::vec3& normal : model.normals) {
        normal = glm::vec3(glm::normalize(for_normals * glm::dvec3(normal)));
    }
    if (glm::determinant(linear) < 0.0) { // it mirrors
        swap_second_and_third(model.corners);
        swap_second_and_third(model.normals);
        swap_second_and_third(model.texture_coordinates);
        swap_second_and_third(model.corner_colors);
    }
    for (Light& light : model.lights) {
        light.position = glm::vec3(linear * glm::dvec3(light.position) + translation);
    }
    if (model.file_camera && !scene.file_camera) {
        scene.file_camera = transformed(*model.file_camera, linear, translation);
    }
    for (int& triangle : model.left_out) {
        triangle += first_triangle;
    }
    for (int& material : model.triangle_materials) {
        material += first_material;
    }
    append_names(scene, model);
    const std::size_t end_corner = first_corner + model.corners.size();
    take_at_corners(scene.corner_colors, std::move(model.corner_colors), first_corner, end_corner,
                    glm::vec3(1.0f));
    take_at_corners(scene.texture_coordinates, std::move(model.texture_coordinates), first_corner,
                    end_corner, glm::vec2(0.0f));
    take(scene.corners, std::move(model.corners));
    take(scene.normals, std::move(model.normals));
    take(scene.triangle_materials, std::move(model.triangle_materials));
    take(scene.left_out, std::move(model.left_out));
    take(scene.lights, std::move(model.lights));
    take(scene.materials, std::move(model.materials));
    take(scene.enclosed, std::move(model.enclosed));
    take(scene.models, std::move(model.models));
    take(scene.messages, std::move(model.messages));
    return scene;
}

} // namespace raysteps
