#include "basics/error.h"
#include "basics/random_numbers.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "mirror/mirror_scene.h"
#include "mirror/walks.h"
#include "scene/shapes.h"
#include "trials.h"

#include <array>

namespace raysteps {

namespace {

using Mirror = mirror::walks::every_triangle<float>;

std::vector<TrialRow> as_printed(const TrialTools& tools) {
    if (tools.gpu == nullptr) {
        return {};
    }
    std::size_t taken = 1;
    try {
        TraceRays({{"triangle", "exhibit/paper_as_printed.glsl"}}, tools.gpu->limits());
    } catch (const MachineError&) {
        taken = 0;
    }
    return {promised_row("the shader compiler", "GPU", "refuses the listing", taken, 1)};
}

// A wall, a lamp before it, and a cover behind the lamp: the cover casts no shadow on the wall.
std::vector<TrialRow> cover_behind_a_lamp(const TrialTools& tools) {
    const Mesh wall = quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    const Mesh cover = quad({-9, -9, 6}, {-9, 9, 6}, {9, 9, 6}, {9, -9, 6});
    const glm::vec3 lamp(0.0f, 0.0f, 4.0f);
    const mirror::SceneBuffers buffers(add_mesh(Scene{}, join(wall, cover), Material{}));
    Mirror mirror = mirror::mirror_of<Mirror>(buffers);
    RandomNumbers numbers(tools.seed);
    const std::size_t tried = 1000;
    std::size_t dark = 0;
    std::size_t dark_by_any_hit = 0;
    for (std::size_t i = 0; i < tried; ++i) {
        const glm::vec3 target = 0.9f * glm::vec3(1, 1, 0) * numbers.in_cube();
        const Mirror::Ray ray{{0, 0, 3}, target - glm::vec3(0, 0, 3), 0.0f, mirror.farthest};
        auto shadow = mirror.shadow_ray(mirror.surface_at(ray, mirror.closest_hit(ray)), lamp);
        dark += mirror.is_hit(mirror.any_hit(shadow)) ? 1 : 0;
        shadow.t_max = mirror.farthest; // any hit counts, however far
        dark_by_any_hit += mirror.is_hit(mirror.any_hit(shadow)) ? 1 : 0;
    }
    return {promised_row("shadow rays to the lamp", "C++", "lit", dark, tried),
            reported_row("any hit, however far", "C++", "lit", dark_by_any_hit, tried)};
}

// Which of the coinciding triangles is the nearest, when they are visited from the first to the
// last and from the last to the first.
std::vector<TrialRow> two_orders(const TrialTools& tools) {
    RandomNumbers numbers(tools.seed);
    const Mesh mesh = tripled(sphere(glm::vec3(0.0f), 1.0f, 2));
    const mirror::SceneBuffers buffers(add_mesh(Scene{}, mesh, Material{}));
    Mirror mirror = mirror::mirror_of<Mirror>(buffers);
    const int count = mirror.triangle_count;
    std::size_t parted = 0;
    std::size_t parted_by_strict_t = 0;
    const std::vector<Ray> rays = rays_at_triangles(numbers, mesh.corners, 1000);
    for (const Ray& given : rays) {
        const auto ray = mirror::to_mirror<Mirror>(given);
        const auto prepared = mirror.prepare_ray(ray);
        std::array<Mirror::Hit, 2> nearest{mirror.miss(ray), mirror.miss(ray)};
        std::array<Mirror::Hit, 2> by_strict_t = nearest;
        for (int i = 0; i < count; ++i) {
            for (const std::size_t order : {0, 1}) {
                const int triangle = order == 0 ? i : count - 1 - i;
                const auto hit =
                    mirror.intersect_triangle(prepared, mirror.triangle_corner(triangle, 0),
                                              mirror.triangle_corner(triangle, 1),
                                              mirror.triangle_corner(triangle, 2), triangle);
                nearest[order] = mirror.is_nearer(hit, nearest[order]) ? hit : nearest[order];
                by_strict_t[order] =
                    mirror.is_hit(hit) && hit.t < by_strict_t[order].t ? hit : by_strict_t[order];
            }
        }
        parted += nearest[0].triangle == nearest[1].triangle ? 0 : 1;
        parted_by_strict_t += by_strict_t[0].triangle == by_strict_t[1].triangle ? 0 : 1;
    }
    const char* same = "one answer in both orders";
    return {promised_row("(t, triangle)", "C++", same, parted, rays.size()),
            reported_row("t < nearest.t", "C++", same, parted_by_strict_t, rays.size())};
}

// A hit record that keeps a number as a float, as the paper's does, and one that keeps an integer.
std::vector<TrialRow> numbers_as_floats(const TrialTools&) {
    std::size_t lost = 0;
    std::size_t lost_as_integer = 0;
    const std::size_t tried = 1000;
    for (int i = 0; i < static_cast<int>(tried); ++i) {
        const int triangle = (1 << 24) + i;
        lost += static_cast<int>(static_cast<float>(triangle)) == triangle ? 0 : 1;
        const mirror::walks::every_triangle<float>::Hit hit{1.0f, 0.0f, 0.0f, triangle};
        lost_as_integer += mirror::from_mirror(hit).triangle == triangle ? 0 : 1;
    }
    return {promised_row("an integer", "C++", "the triangle's number", lost_as_integer, tried),
            reported_row("a float", "C++", "the triangle's number", lost, tried)};
}

} // namespace

std::vector<Trial> paper_checks() {
    const std::string paper =
        "Wang and Wen, Research of Acceleration Structures for GPU Based Ray Tracing, 2010";
    return {
        {"P1", "the listing as it is printed: a second a, no q, a float3 for a number", paper,
         "give the cross product a name of its own", as_printed},
        {"P10s", "the listing's strict t < lasthit.z, where triangles coincide", paper,
         "of equal t, the smaller number of the triangle", two_orders},
        {"P11", "numbers of triangles from 2^24 on in the record of a hit", paper,
         "keep integers as integers", numbers_as_floats},
        {"P12", "a shadow ray, and what is behind the lamp", paper, "end the ray at the lamp",
         cover_behind_a_lamp},
    };
}

} // namespace raysteps
