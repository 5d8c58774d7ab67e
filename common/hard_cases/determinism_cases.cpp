#include "hard_cases/aimed_rays.h"
#include "hard_cases/case_lists.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"

namespace raysteps {

namespace {

// Every triangle three times, in that order, with leaves as small as can be: copies come into
// leaves of their own.
HardScene coincident(const HardRequest& request, TriangleOrder order) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = reordered(tripled(sphere(glm::vec3(0.0f), 1.0f, 3)), order, request.seed);
    std::vector<Ray> rays;
    for (const RayFamily& family : ray_families(numbers, mesh.corners, request.rays / 11 + 1)) {
        rays = joined(std::move(rays), family.rays);
    }
    return {mesh, rays, rays.size() / 2, {{"bvh", {{"leaf-triangles", "1"}}}}};
}

HardScene forward(const HardRequest& request) {
    return coincident(request, TriangleOrder::forward);
}

HardScene backward(const HardRequest& request) {
    return coincident(request, TriangleOrder::backward);
}

HardScene shuffled(const HardRequest& request) {
    return coincident(request, TriangleOrder::shuffled);
}

HardScene ten_thousand_copies(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = copies_of_a_triangle(10000);
    const std::vector<Ray> rays = rays_at_triangles(numbers, mesh.corners, request.rays);
    return {mesh, rays, rays.size() / 10 * 9, {{"grid", {{"resolution", "8"}}}}};
}

} // namespace

std::vector<HardCase> determinism_cases() {
    const auto make = [](const char* name, const char* title, int most_rays, auto generator) {
        return HardCase{name,
                        title,
                        "",
                        Truth::the_loop,
                        Guarantee::promised,
                        Tries::structures,
                        "of equal distances the smallest triangle wins",
                        most_rays,
                        generator};
    };
    return {
        make("D1", "every triangle three times: equal, and wound backwards", 1000000, forward),
        make("D2", "the same, with its triangles from the last to the first", 1000000, backward),
        make("D3", "the same, with its triangles shuffled", 1000000, shuffled),
        make("D4", "ten thousand copies of one triangle", 200, ten_thousand_copies),
    };
}

} // namespace raysteps
