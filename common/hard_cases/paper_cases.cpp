#include "hard_cases/aimed_rays.h"
#include "hard_cases/case_lists.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"

#include <cmath>

namespace raysteps {

namespace {

// Two triangles one behind the other, so that a wrong depth is seen as the wrong triangle.
HardScene two_depths(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const glm::vec3 offset(0.0f, 4.0f, 3.0f);
    const auto at = [&](float x, float y, float z) { return offset + glm::vec3(x, y, z); };
    // The front one first, turned so that its first edge is not that of the one behind.
    const Mesh mesh =
        mesh_of({at(0, 1, 0), at(0, 0, 0), at(1, 0, 0), at(0, 0, -1), at(1, 0, -1), at(0, 1, -1)});
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        const float x = 0.05f + 0.8f * numbers.unit();
        const float y = (0.9f - x) * numbers.unit() + 0.05f;
        rays.push_back({at(x, y, 2), {0, 0, -1}, 0.0f, no_end});
    }
    return {mesh, rays};
}

// In the plane of a triangle and beside it: det is 0 without a rounding.
HardScene parallel_rays(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        const float height = i % 2 == 0 ? 0.0f : 0.5f * numbers.in_cube().z;
        const glm::vec3 way = numbers.in_cube();
        const glm::vec3 over = 0.5f * numbers.unit() * glm::vec3(1, 1, 0);
        rays.push_back({glm::vec3(over.x - way.x, over.y - way.y, height),
                        {way.x, way.y, 0.0f},
                        0.0f,
                        no_end});
    }
    return {triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), rays};
}

// The same rays with directions from 2^-20 to 2^20 times as long.
HardScene directions_of_any_length(const HardRequest& request) {
    HardScene made = two_depths(request);
    for (std::size_t i = 0; i < made.rays.size(); ++i) {
        made.rays[i].direction *= std::ldexp(1.0f, static_cast<int>(i % 41) - 20);
    }
    return made;
}

HardScene edges_of_a_ball(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 5);
    return {mesh, edge_aimed_rays(numbers, mesh, glm::vec3(0.4f), request.rays)};
}

HardScene three_in_one_place(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = tripled(sphere(glm::vec3(0.0f), 1.0f, 3));
    return {mesh, rays_at_triangles(numbers, mesh.corners, request.rays),
            static_cast<std::size_t>(request.rays / 2)};
}

HardScene inside_a_ball(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    return {sphere(glm::vec3(0.0f), 2.0f, 4),
            random_rays_from_inside(numbers, glm::vec3(0.9f), request.rays)};
}

// Edges of about 1e-3: their square is under 1e-6.
HardScene inside_a_small_ball(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    return {sphere(glm::vec3(0.0f), 0.002f, 4),
            random_rays_from_inside(numbers, glm::vec3(0.0009f), request.rays)};
}

const std::string paper =
    "Wang and Wen, Research of Acceleration Structures for GPU Based Ray Tracing, 2010";

} // namespace

std::vector<HardCase> paper_cases() {
    const auto aimed = Tries::structures_and_triangle_tests;
    return {
        {"P3", "one triangle before another: t must come from the cross product, not the corner",
         paper, Truth::exact, Guarantee::promised, aimed, "q in place of the second a", 100000,
         two_depths},
        {"P5", "a ray parallel to a triangle: det is 0, and u, v and t are divided by it", paper,
         Truth::all_miss, Guarantee::promised, aimed, "test det != 0 before all else", 100000,
         parallel_rays},
        {"P6", "from inside a closed mesh every ray sees a back face", paper, Truth::all_hit,
         Guarantee::promised, aimed, "no culling, or only for rays from the camera", 1000000,
         inside_a_ball},
        {"P7", "a model a thousandth in size: an absolute 1e-6 lets it vanish", paper,
         Truth::all_hit, Guarantee::promised, aimed, "no epsilon on det", 1000000,
         inside_a_small_ball},
        {"P8", "directions from 2^-20 to 2^20 long: an epsilon means another thing for each", paper,
         Truth::exact, Guarantee::promised, aimed, "no epsilon on det; t counts directions", 100000,
         directions_of_any_length},
        {"P9", "an edge of two triangles, each of which computes u + v <= 1 by itself", paper,
         Truth::all_hit, Guarantee::promised, aimed, "--triangle watertight", 1000000,
         edges_of_a_ball},
        {"P10", "three triangles in the same place: which one is the nearest", paper,
         Truth::the_loop, Guarantee::promised, Tries::structures,
         "the smallest t, and of equal ones the first", 1000000, three_in_one_place},
    };
}

} // namespace raysteps
