#include "hard_cases/aimed_rays.h"
#include "hard_cases/case_lists.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace raysteps {

namespace {

const glm::vec3 around_zero(0.9f);

// Rays at edges, and then at corners.
HardScene leaks_of(const Mesh& mesh, const glm::vec3& half, const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const int half_of_them = request.rays / 2;
    const std::vector<Ray> at_edges = edge_aimed_rays(numbers, mesh, half, half_of_them);
    return {mesh, joined(at_edges, corner_aimed_rays(numbers, mesh, half, half_of_them))};
}

HardScene shared_edges(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = shared_edge_sphere();
    return {mesh, edge_aimed_rays(numbers, mesh, around_zero, request.rays)};
}

HardScene shared_corners(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = shared_edge_sphere();
    return {mesh, corner_aimed_rays(numbers, mesh, around_zero, request.rays)};
}

HardScene diagonal_of_a_quad(const HardRequest&) {
    const Ray ray{{0, 0, 10}, {0.30458447f, 0.30458447f, -0.9024725f}, 0.0f, no_end};
    return {quad({-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}), {ray}};
}

// One behind the other, each a tenth of the one before: each ray meets all that are larger.
HardScene tiny_triangles(const HardRequest&) {
    std::vector<glm::vec3> corners;
    std::vector<Ray> rays;
    for (float s = 1.0f; s > 0.9e-18f; s *= 0.1f) {
        corners.insert(corners.end(), {{0, 0, 0}, {s, 0, 0}, {0, s, 0}});
        rays.push_back({{s / 3.0f, s / 3.0f, -1.0f}, {0, 0, 1}, 0.0f, no_end});
    }
    return {mesh_of(std::move(corners)), rays, rays.size()};
}

// Of a body so long and thin, much lies nearer to its walls than what is promised covers: 2^-19 of
// the reach (docs/numerics.md, section 5). From the end of this box the reach is 1.5e5, so that
// this is 0.29. The walls are 0.85 away from the axis there, and the corners of the box 0.36.
HardScene slivers(const HardRequest& request) {
    return leaks_of(sliver_ball(1e5f), {5e4f, 0.25f, 0.25f}, request);
}

// As above: the reach is 1.5 at most, so that 2.9e-6 are asked for, and the faces are 7e-6 above
// and below the middle where the box ends.
HardScene grazing(const HardRequest& request) {
    return leaks_of(flat_lens(1e-5f), {0.5f, 2.5e-6f, 0.5f}, request);
}

// Rays at these points from everywhere around.
std::vector<Ray> rays_at_points(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                std::span<const glm::vec3> points) {
    std::vector<Ray> rays;
    for (const glm::vec3& point : points) {
        const glm::vec3 origin = point_around(numbers, corners);
        rays.push_back({origin, point - origin, 0.0f, no_end});
    }
    return rays;
}

// A multiple of 2^-9 between -1 and 1.
glm::vec3 whole_point(RandomNumbers& numbers) {
    const int x = numbers.below(1024) - 512;
    const int y = numbers.below(1024) - 512;
    return 0x1p-9f * glm::vec3(x, y, numbers.below(1024) - 512);
}

// Two or three corners of each are one point.
HardScene repeated_corners(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    std::vector<glm::vec3> corners;
    std::vector<glm::vec3> points;
    for (int i = 0; i < 25; ++i) {
        const glm::vec3 a = numbers.in_cube();
        const glm::vec3 b = numbers.in_cube();
        corners.insert(corners.end(), {a, a, a, a, a, b, a, b, b, a, b, a});
    }
    for (int i = 0; i < request.rays; ++i) {
        points.push_back(point_on_edge(numbers, corners));
    }
    return {mesh_of(corners), rays_at_points(numbers, corners, points)};
}

// Three different corners on one line, exactly.
HardScene corners_on_a_line(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    std::vector<glm::vec3> corners;
    std::vector<glm::vec3> points;
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 a = whole_point(numbers);
        const glm::vec3 along = whole_point(numbers);
        const auto times = static_cast<float>(2 + numbers.below(6));
        corners.insert(corners.end(), {a, a + along, a + times * along});
    }
    for (int i = 0; i < request.rays; ++i) {
        points.push_back(point_on_edge(numbers, corners));
    }
    return {mesh_of(corners), rays_at_points(numbers, corners, points)};
}

// From around a point inside, at edges of those triangles.
std::vector<Ray> rays_at_edges_of(RandomNumbers& numbers, const glm::vec3& inside,
                                  std::span<const glm::vec3> corners, int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = inside + 0.3f * numbers.in_cube();
        rays.push_back({origin, point_on_edge(numbers, corners) - origin, 0.0f, no_end});
    }
    return rays;
}

HardScene slits_that_are_closed(const HardRequest& request) {
    Mesh sphere = latitude_sphere(1.0f, 8, 16);
    for (glm::vec3& corner : sphere.corners) {
        corner = 0x1p-10f * glm::round(0x1p10f * corner);
    }
    const Mesh mesh = as_loaded(split_on_one_side(sphere));
    RandomNumbers numbers(request.seed);
    const std::vector<glm::vec3> lines = corners_without_area(split_on_one_side(sphere));
    return {mesh, rays_at_edges_of(numbers, glm::vec3(0.0f), lines, request.rays)};
}

HardScene areas_lost_by_rounding(const HardRequest& request) {
    RandomNumbers of_the_mesh(1);
    const glm::vec3 center(1e6f, -7e5f, 3e5f);
    const Mesh sphere = jittered_sphere(of_the_mesh, 48, 96, center);
    RandomNumbers numbers(request.seed);
    const int half_of_them = request.rays / 2;
    const std::vector<Ray> at_lines =
        rays_at_edges_of(numbers, center, corners_without_area(sphere), half_of_them);
    return {as_loaded(sphere),
            joined(at_lines, rays_at_edges_of(numbers, center, sphere.corners, half_of_them))};
}

// A tetrahedron, its corners counter-clockwise as seen from outside.
Mesh tetrahedron() {
    const glm::vec3 a(-0.09524089f, 0.119544774f, 0.848421156f);
    const glm::vec3 b(-0.06869986f, 0.0156825464f, 0.17476967f);
    const glm::vec3 c(-0.630679309f, 0.0238172784f, 0.259765446f);
    const glm::vec3 d(0.585953772f, -0.811753094f, -0.393197477f);
    const bool inwards = glm::dot(area_vector(a, b, c), glm::dvec3(d) - glm::dvec3(a)) > 0.0;
    return inwards ? mesh_of({a, c, b, a, b, d, b, c, d, c, a, d})
                   : mesh_of({a, b, c, a, d, b, b, d, c, c, d, a});
}

// How far inside of a convex mesh a point is: the least distance to a plane of its faces, measured
// along the axis where it is greatest. Negative outside.
double depth_inside(const Mesh& mesh, const glm::vec3& point) {
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first < mesh.corners.size(); first += 3) {
        const glm::dvec3 normal =
            area_vector(mesh.corners[first], mesh.corners[first + 1], mesh.corners[first + 2]);
        const glm::dvec3 size = glm::abs(normal);
        const double above = glm::dot(normal, glm::dvec3(point) - glm::dvec3(mesh.corners[first]));
        depth = std::min(depth, -above / (size.x + size.y + size.z));
    }
    return depth;
}

// Origins about so far inside of a wall, with rays towards it.
HardScene close_to_a_wall(const HardRequest& request, double distance) {
    const Mesh mesh = tetrahedron();
    RandomNumbers numbers(request.seed);
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < request.rays) {
        const std::size_t first = 3 * static_cast<std::size_t>(numbers.below(4));
        const glm::dvec3 a(mesh.corners[first]);
        const glm::dvec3 b(mesh.corners[first + 1]);
        const glm::dvec3 c(mesh.corners[first + 2]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const glm::dvec3 size = glm::abs(normal);
        const double u = numbers.unit();
        const double v = (1.0 - u) * static_cast<double>(numbers.unit());
        const glm::dvec3 inwards = -normal / (size.x + size.y + size.z);
        // Along the normal it takes this far to be `distance` away along some axis.
        const double away = distance / glm::dot(inwards, -glm::normalize(normal));
        const glm::vec3 origin(a + u * (b - a) + v * (c - a) -
                               1.01 * away * glm::normalize(normal));
        glm::vec3 direction = any_direction(numbers);
        direction = glm::dot(glm::dvec3(direction), normal) < 0.0 ? -direction : direction;
        const double depth = depth_inside(mesh, origin);
        if (depth >= distance && depth < 2.0 * distance) {
            rays.push_back({origin, direction, 0.0f, no_end});
        }
    }
    return {mesh, rays};
}

// More than its longest side, 1.242 along z: the reach of rays from inside.
constexpr double tetrahedron_reach = 1.25;

HardScene at_the_promised_distance(const HardRequest& request) {
    return close_to_a_wall(request, 0x1p-19 * tetrahedron_reach);
}

HardScene closer_than_promised(const HardRequest& request) {
    return close_to_a_wall(request, 0x1p-27 * tetrahedron_reach);
}

HardScene in_the_plane(const HardRequest&) {
    std::vector<Ray> rays;
    for (const float y : {0.0f, 0.25f, 0.5f, 1.0f}) {
        for (const float zero : {0.0f, -0.0f}) {
            rays.push_back({{-1, y, 0}, {1, zero, zero}, 0.0f, no_end});
            rays.push_back({{y, -1, zero}, {zero, 1, 0}, -no_end, no_end});
            rays.push_back({{-1, -1, zero}, {1, 1, 0}, 0.0f, no_end});
            rays.push_back({{0.25f, 0.25f, 0}, {1, y, zero}, -no_end, no_end});
        }
    }
    return {triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), rays};
}

// Every ray as often as a zero of it can have a sign.
HardScene zeros_of_either_sign(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 3);
    std::vector<Ray> rays;
    for (const Ray& ray : axis_parallel_rays(numbers, mesh.corners, request.rays / 4)) {
        for (const float first : {0.0f, -0.0f}) {
            for (const float second : {0.0f, -0.0f}) {
                Ray turned = ray;
                const int axis = ray.direction.x != 0.0f ? 0 : ray.direction.y != 0.0f ? 1 : 2;
                turned.direction[(axis + 1) % 3] = first;
                turned.direction[(axis + 2) % 3] = second;
                rays.push_back(turned);
            }
        }
    }
    return {mesh, rays, rays.size() / 10};
}

HardScene from_far_away(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = random_triangles(numbers, 100);
    return {mesh, rays_from_far_away(numbers, mesh.corners, 1e5f, request.rays)};
}

HardScene at_an_offset(const HardRequest& request) {
    const glm::vec3 offset(1e6f);
    const Mesh mesh = scaled_and_moved(shared_edge_sphere(), 1.0f, offset);
    RandomNumbers numbers(request.seed);
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        const glm::vec3 target = i % 2 == 0 ? point_on_edge(numbers, mesh.corners)
                                            : mesh.corners[any_corner(numbers, mesh.corners)];
        const glm::vec3 origin = offset + around_zero * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return {mesh, rays};
}

HardScene random_from_inside(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    return {shared_edge_sphere(), random_rays_from_inside(numbers, around_zero, request.rays)};
}

HardScene loose(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = random_triangles(numbers, 200);
    return {mesh, random_rays(numbers, request.rays), static_cast<std::size_t>(request.rays / 12)};
}

const std::string woop = "Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, 2013";
const std::string take_watertight = "--triangle watertight";

} // namespace

std::vector<HardCase> triangle_cases() {
    const auto aimed = Tries::structures_and_triangle_tests;
    return {
        {"T0", "random rays from inside a closed mesh: nearly blind for leaks, to compare with", "",
         Truth::all_hit, Guarantee::promised, aimed, take_watertight, 10000000, random_from_inside},
        {"T1", "rays from inside a closed mesh at points of shared edges", woop, Truth::all_hit,
         Guarantee::promised, aimed, take_watertight, 10000000, shared_edges},
        {"T2", "rays from inside a closed mesh at shared corners", woop, Truth::all_hit,
         Guarantee::promised, aimed, take_watertight + "; double precision does not cure it",
         10000000, shared_corners},
        {"T4", "a ray at the diagonal that splits a square", "", Truth::all_hit,
         Guarantee::promised, aimed, take_watertight, 1, diagonal_of_a_quad},
        {"T5", "triangles with edges from 1 down to 1e-18", "", Truth::all_hit, Guarantee::promised,
         aimed, "--scale-exponent N: all lengths times 2^N; below 1e-19 products underflow", 19,
         tiny_triangles},
        {"T6", "a closed mesh of slivers, 100,000 times longer than wide", "", Truth::all_hit,
         Guarantee::promised, aimed, take_watertight, 1000000, slivers},
        {"T7", "rays that graze the faces of a closed lens at 1e-5 radians", "", Truth::all_hit,
         Guarantee::promised, aimed, take_watertight, 1000000, grazing},
        {"T8a", "triangles of which two or three corners are one point", "", Truth::all_miss,
         Guarantee::promised, aimed, "", 100000, repeated_corners},
        {"T8b", "loose triangles with three corners on one line", "", Truth::all_miss,
         Guarantee::reported, aimed,
         "none is needed: a hit lies at the line, as near as any hit lies at its triangle", 100000,
         corners_on_a_line},
        {"T8c", "a closed mesh, in which triangles without area close slits between others", "",
         Truth::all_hit, Guarantee::promised, aimed,
         take_watertight + ", and keep triangles with three different corners on one line", 1000000,
         slits_that_are_closed},
        {"T8d", "a closed mesh, far from zero, in which rounding took the area of triangles", "",
         Truth::all_hit, Guarantee::promised, aimed,
         take_watertight + ", and keep triangles with three different corners on one line", 1000000,
         areas_lost_by_rounding},
        {"T9", "rays in the plane of a triangle, which miss by definition", "", Truth::all_miss,
         Guarantee::promised, aimed, "", 32, in_the_plane},
        {"T10", "zeros of either sign in the direction", "", Truth::the_loop, Guarantee::promised,
         Tries::structures, "", 100000, zeros_of_either_sign},
        {"T11", "rays that come from 100,000 sizes away", "", Truth::exact, Guarantee::reported,
         aimed, "start the rays nearer: move each origin to the scene's box, in double", 20000,
         from_far_away},
        {"T12", "a closed mesh a million radii away from zero", "", Truth::all_hit,
         Guarantee::promised, aimed, "move the model to zero: its corners have lost their digits",
         1000000, at_an_offset},
        {"T14", "rays that start 2^-19 of their reach inside a wall, towards it", "",
         Truth::all_hit, Guarantee::promised, aimed, take_watertight, 1000000,
         at_the_promised_distance},
        {"T15", "rays that start 2^-27 of their reach inside a wall, towards it", "",
         Truth::all_hit, Guarantee::reported, aimed,
         "start 2^-19 of the reach inside: nearer, rounding may bring t below 0", 1000000,
         closer_than_promised},
        {"T13", "loose triangles, whose u, v and t must stay in their range", "", Truth::the_loop,
         Guarantee::promised, Tries::structures, "", 1000000, loose},
    };
}

} // namespace raysteps
