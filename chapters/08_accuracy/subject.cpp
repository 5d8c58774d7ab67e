#include "subject.h"

#include "basics/box.h"
#include "judges.h"
#include "reference/exact.h"
#include "scene/load_scene.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "structure/structure.h"

#include <glm/geometric.hpp>

#include <algorithm>
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
    const std::string structure = small ? "every_triangle" : single_walk("fastest");
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

std::vector<std::shared_ptr<const TraceFamily>> with_truth(std::vector<RayFamily> families,
                                                           std::span<const glm::vec3> corners,
                                                           const Effort& effort) {
    const ExactMesh mesh(corners);
    std::vector<std::shared_ptr<const TraceFamily>> judged;
    for (RayFamily& family : families) {
        const std::size_t timed = std::min(effort.timed_rays, family.rays.size());
        RayTextures all = upload_rays(family.rays);
        RayTextures first = upload_rays(std::span(family.rays).first(timed));
        std::vector<ReferenceHit> truth = mesh.nearest_hits(family.rays);
        judged.push_back(std::make_shared<const TraceFamily>(
            TraceFamily{std::move(family.name), std::move(family.rays), std::move(truth), timed,
                        std::move(all), std::move(first)}));
    }
    return judged;
}

std::vector<MethodTrial>
trace_trials(const std::vector<TraceMethod>& methods,
             const std::vector<std::shared_ptr<const TraceFamily>>& families,
             std::span<const glm::vec3> corners, const Effort& effort) {
    std::vector<std::shared_ptr<TraceRays>> tracers;
    for (const TraceMethod& method : methods) {
        tracers.push_back(std::make_shared<TraceRays>(method.parts, effort.limits));
    }
    const auto mesh = std::make_shared<const ExactMesh>(corners);
    std::vector<MethodTrial> trials;
    for (const auto& family : families) {
        for (std::size_t i = 0; i < methods.size(); ++i) {
            const auto trace = tracers[i];
            const auto scene = methods[i].scene;
            trials.push_back(
                {.method = methods[i].name,
                 .family = family->name,
                 .timed_cases = family->timed_count,
                 .run = [=] { trace->closest_hits(family->timed, *scene); }, // ends with a query
                 .examine =
                     [=] {
                         const Texture hits = trace->closest_hits(family->all, *scene);
                         return judge_hits(family->rays, read_hits(hits, family->rays.size()),
                                           family->truth, *mesh);
                     }});
        }
    }
    return trials;
}

} // namespace raysteps
