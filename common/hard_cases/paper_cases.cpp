#include "hard_cases/case_lists.h"
#include "hard_cases/closed_meshes.h"
#include "hard_cases/leak_rays.h"
#include "hard_cases/loose_triangles.h"
#include "scene/shapes.h"

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
        {"P6", "from inside a closed mesh every ray sees a back face", paper, Truth::all_hit,
         Guarantee::promised, aimed, "no culling, or only for rays from the camera", 1000000,
         inside_a_ball},
        {"P7", "a model a thousandth in size: an absolute 1e-6 lets it vanish", paper,
         Truth::all_hit, Guarantee::promised, aimed, "no epsilon on det", 1000000,
         inside_a_small_ball},
    };
}

} // namespace raysteps
