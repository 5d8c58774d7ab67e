#include "hard_cases/aimed_rays.h"
#include "hard_cases/case_lists.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"

#include <algorithm>

namespace raysteps {

namespace {

// Every family of rays at these triangles; at least that part of them hits.
HardScene asked_by_all_families(const Mesh& mesh, const HardRequest& request, double least) {
    RandomNumbers numbers(request.seed);
    std::vector<Ray> rays;
    for (const RayFamily& family : ray_families(numbers, mesh.corners, request.rays / 11 + 1)) {
        rays = joined(std::move(rays), family.rays);
    }
    const auto least_hits = static_cast<std::size_t>(least * static_cast<double>(rays.size()));
    return {mesh, rays, least_hits};
}

HardScene equal_centers(const HardRequest& request) {
    return asked_by_all_families(mesh_of(concentric_triangles(request.seed, 2000)), request, 0.2);
}

HardScene no_triangle_at_all(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    return {Mesh{}, random_rays(numbers, request.rays)};
}

HardScene one_triangle(const HardRequest& request) {
    return asked_by_all_families(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), request, 0.2);
}

// Rays at one size each, from around it. Products of the smallest ones would be denormal numbers,
// which a GPU may flush to zero (docs/numerics.md): no ray is aimed at them.
HardScene sizes_that_double(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = mesh_of(triangles_at_powers_of_two());
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < request.rays) {
        const glm::vec3 target = point_on_edge(numbers, mesh.corners);
        const glm::vec3 origin = target + target.x * numbers.in_cube();
        if (target.x > 0x1p-20f) {
            rays.push_back({origin, target - origin, 0.0f, no_end});
        }
    }
    return {mesh, rays, rays.size() / 4};
}

HardScene chain(const HardRequest& request) {
    HardScene made = asked_by_all_families(mesh_of(shells(3000)), request, 0.2);
    made.build_values["bvh"] = {{"split", "insertion"},
                                {"insertion-order", "as_given"},
                                {"leaf-triangles", "1"},
                                {"depth", "100000"}};
    return made;
}

} // namespace

std::vector<HardCase> tree_cases() {
    const auto make = [](const char* name, const char* title, const char* source,
                         const char* remedy, int most_rays, auto generator) {
        return HardCase{
            name,   title,     source,   Truth::the_loop, Guarantee::promised, Tries::structures,
            remedy, most_rays, generator};
    };
    return {
        make("V1", "two thousand triangles with the same centre", "", "halve by number", 20000,
             equal_centers),
        make("V2a", "a scene without a triangle", "", "", 1000, no_triangle_at_all),
        make("V2b", "a scene of one triangle", "", "", 100000, one_triangle),
        make("V3a", "triangles whose sizes double 120 times", "", "", 100000, sizes_that_double),
        make("V3b", "shells that make a chain of a tree that grows by insertion",
             "Goldsmith and Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, 1987",
             "a limit of depth, and insertion in shuffled order", 2000, chain),
    };
}

} // namespace raysteps
