#include "hard_cases/meshes.h"
#include "mirror/mirror_scene.h"
#include "mirror/walks.h"
#include "trials.h"

#include <fmt/core.h>

namespace raysteps {

namespace {

using Mirror = mirror::walks::every_triangle<float>;

constexpr int usual_leaving_rays = 20000;

int leaving_rays_of(const TrialTools& tools) {
    return tools.rays > 0 ? tools.rays : usual_leaving_rays;
}

// How a ray leaves a surface: from an origin moved off it, as in chapter 03; from the hit point; or
// from the hit point, with the first 1e-4 of it left out.
enum class Leave { moved, at_the_hit, late };

// A ray from where the surface was hit into any direction on the same side.
Mirror::Ray leaving_ray(RandomNumbers& numbers, Mirror& mirror, const Mirror::Ray& ray,
                        const Mirror::Hit& hit, Leave leave) {
    const auto surface = mirror.surface_at(ray, hit);
    glm::vec3 direction = any_direction(numbers);
    if (glm::dot(direction, surface.geometric_normal) < 0.0f) {
        direction = -direction;
    }
    Mirror::Ray leaving{surface.origin, direction, 0.0f, no_end};
    if (leave != Leave::moved) {
        leaving.origin = ray.origin + hit.t * ray.direction;
        leaving.t_min = leave == Leave::late ? 1e-4f : 0x1p-126f;
    }
    return leaving;
}

struct Rehits {
    std::size_t hits = 0;
    std::size_t rehits = 0;
};

// How many rays meet the mesh again that they have left.
template <class Make>
Rehits count_rehits(const TrialTools& tools, Leave leave, const Make& make) {
    RandomNumbers numbers(tools.seed);
    Rehits counts;
    for (int i = 0; i < leaving_rays_of(tools); ++i) {
        const SeenSurface seen = make(numbers);
        const mirror::SceneBuffers buffers(add_mesh(Scene{}, seen.mesh, Material{}));
        Mirror mirror = mirror::mirror_of<Mirror>(buffers);
        const auto ray = mirror::to_mirror<Mirror>(seen.ray);
        const auto hit = mirror.closest_hit(ray);
        if (!mirror.is_hit(hit)) {
            continue; // aimed at an edge, and rounded past it
        }
        ++counts.hits;
        const auto leaving = leaving_ray(numbers, mirror, ray, hit, leave);
        counts.rehits += mirror.is_hit(mirror.closest_hit(leaving)) ? 1 : 0;
    }
    return counts;
}

template <class Make>
std::vector<TrialRow> leave_surfaces(const TrialTools& tools, const Make& make) {
    const Rehits moved = count_rehits(tools, Leave::moved, make);
    const Rehits late = count_rehits(tools, Leave::late, make);
    const Rehits at_the_hit = count_rehits(tools, Leave::at_the_hit, make);
    const char* never = "not hit again";
    return {promised_row("origin moved off", "C++", never, moved.rehits, moved.hits),
            reported_row("t > 1e-4", "C++", never, late.rehits, late.hits),
            reported_row("from the hit itself", "C++", never, at_the_hit.rehits, at_the_hit.hits)};
}

Trial triangles_trial(const char* name, float size, float offset) {
    return {name,
            fmt::format("a ray that leaves a triangle of size {:g} at a distance of {:g} from zero",
                        size, offset),
            "Pharr, Jakob and Humphreys, Physically Based Rendering, 2016",
            "move the origin off the plane by as much as rounding can",
            [=](const TrialTools& tools) {
                return leave_surfaces(tools, [=](RandomNumbers& numbers) {
                    return any_triangle(numbers, size, offset);
                });
            }};
}

// From the inner sphere outwards the outer one must be hit, however close it is.
std::vector<TrialRow> close_behind(const TrialTools& tools) {
    const mirror::SceneBuffers both(add_mesh(Scene{}, close_spheres(4e-5f), Material{}));
    Mirror mirror = mirror::mirror_of<Mirror>(both);
    const int inner = mirror.triangle_count / 2;
    Mirror inner_only = mirror;
    inner_only.triangle_count = inner;
    RandomNumbers numbers(tools.seed);
    std::size_t moved = 0;
    std::size_t late = 0;
    const int count = leaving_rays_of(tools) / 10 + 1;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 outside = 3.0f * any_direction(numbers);
        const Mirror::Ray ray{outside, -outside, 0.0f, no_end};
        const auto hit = inner_only.closest_hit(ray);
        const auto surface = inner_only.surface_at(ray, hit);
        Mirror::Ray leaving{surface.origin, surface.geometric_normal, 0.0f, no_end};
        moved += mirror.closest_hit(leaving).triangle >= inner ? 0 : 1;
        leaving.t_min = 1e-4f;
        late += mirror.closest_hit(leaving).triangle >= inner ? 0 : 1;
    }
    const auto tried = static_cast<std::size_t>(count);
    return {promised_row("origin moved off", "C++", "the outer one is hit", moved, tried),
            reported_row("t > 1e-4", "C++", "the outer one is hit", late, tried)};
}

} // namespace

std::vector<Trial> surface_checks() {
    return {
        {"P13", "rays that start where a ball was hit",
         "Wang and Wen, Research of Acceleration Structures for GPU Based Ray Tracing, 2010",
         "move the origin off the plane by as much as rounding can",
         [](const TrialTools& tools) { return leave_surfaces(tools, any_point_of_a_ball); }},
        triangles_trial("S1", 1.0f, 0.0f),
        triangles_trial("S2", 1.0f, 1e3f),
        triangles_trial("S3", 1.0f, 1e5f),
        triangles_trial("S4", 1e-3f, 0.0f),
        {"S5", "a ray that leaves a triangle, and its neighbour in the same plane", "",
         "move the origin off the plane",
         [](const TrialTools& tools) { return leave_surfaces(tools, any_parallelogram); }},
        {"S6", "a surface 4e-5 behind another must still be hit", "",
         "move the origin by no more than rounding needs", close_behind},
    };
}

} // namespace raysteps
