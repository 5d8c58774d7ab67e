#include "subject.h"

#include "basics/box.h"
#include "scene/load_scene.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "structure/structure.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace raysteps {

namespace {

int longest_axis(const glm::dvec3& v) {
    const int axis = std::abs(v.x) >= std::abs(v.y) ? 0 : 1;
    return std::abs(v[axis]) >= std::abs(v.z) ? axis : 2;
}

} // namespace

std::vector<glm::vec4> triangle_transforms(std::span<const glm::vec3> corners) {
    std::vector<glm::vec4> rows;
    for (std::size_t first = 0; first < corners.size(); first += 3) {
        const glm::dvec3 a(corners[first]);
        const glm::dvec3 e1 = glm::dvec3(corners[first + 1]) - a;
        const glm::dvec3 e2 = glm::dvec3(corners[first + 2]) - a;
        const glm::dvec3 normal = glm::cross(e1, e2);
        const int k = longest_axis(normal);
        const int i = (k + 1) % 3;
        const int j = (k + 2) % 3;
        glm::dvec3 u(0.0);
        glm::dvec3 v(0.0);
        u[i] = e2[j] / normal[k];
        u[j] = -e2[i] / normal[k];
        v[i] = -e1[j] / normal[k];
        v[j] = e1[i] / normal[k];
        for (const glm::dvec3& row : {u, v, normal / normal[k]}) {
            rows.emplace_back(glm::vec3(row), static_cast<float>(-glm::dot(row, a)));
        }
    }
    return rows;
}

std::shared_ptr<const SceneTextures>
build_textures(const Scene& scene, const std::string& structure, float reach,
               const std::map<std::string, std::string>& values) {
    const BuiltStructure built = family_of(structure).build(scene.corners, {reach, values});
    return std::make_shared<const SceneTextures>(upload(scene, built));
}

std::shared_ptr<const Subject> make_subject(Scene scene, float reach) {
    const bool small = triangle_count(scene) <= most_triangles_of_loop;
    const std::string structure = small ? "every_triangle" : "bvh_ordered";
    SceneTextures textures = upload(scene, family_of(structure).build(scene.corners, {reach, {}}));
    textures.structure.buffers.emplace("triangle_transforms",
                                       BufferTexture(triangle_transforms(scene.corners)));
    return std::make_shared<const Subject>(
        Subject{std::move(scene), find_part("structure", structure),
                std::make_shared<const SceneTextures>(std::move(textures))});
}

std::shared_ptr<const Subject> usual_subject() {
    Scene scene = add_mesh({}, sphere({0.3f, -0.2f, 0.1f}, 1.0f, 4), Material{});
    scene.name = "a sphere of 320 triangles";
    return make_subject(std::move(scene), 0.0f);
}

std::shared_ptr<const Subject> slivers_subject() {
    Scene scene = load_scene("needles:200", 1.0f);
    scene.name = "200 needles";
    return make_subject(std::move(scene), 0.0f);
}

} // namespace raysteps
