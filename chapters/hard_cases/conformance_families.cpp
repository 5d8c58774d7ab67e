#include "conformance.h"

#include "hard_cases/aimed_rays.h"
#include "hard_cases/hard_cases.h"
#include "hard_cases/meshes.h"
#include "reference/exact.h"
#include "scene/shapes.h"

#include <array>
#include <cmath>
#include <limits>

namespace raysteps {

namespace {

std::function<HardScene(const HardRequest&)> of_case(const std::string& name) {
    return find_hard_case(name).make;
}

// A ball with rays from inside, at edges and then at corners.
HardScene inside_a_ball_of(float radius, const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = scaled_and_moved(sphere(glm::vec3(0.0f), 1.0f, 4), radius, glm::vec3(0.0f));
    const glm::vec3 half(0.4f * radius);
    std::vector<Ray> rays = edge_aimed_rays(numbers, mesh, half, request.rays / 2);
    for (const Ray& ray : corner_aimed_rays(numbers, mesh, half, request.rays / 2)) {
        rays.push_back(ray);
    }
    return {mesh, rays};
}

HardScene tiny_ball(const HardRequest& request) {
    return inside_a_ball_of(1e-9f, request);
}

HardScene huge_ball(const HardRequest& request) {
    return inside_a_ball_of(1e15f, request);
}

// At the two apexes, where two hundred triangles meet, and at spokes, ever nearer to them.
HardScene many_around_a_point(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = latitude_sphere(1.0f, 3, 200);
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        const glm::vec3 apex(0.0f, i % 2 == 0 ? 1.0f : -1.0f, 0.0f);
        const glm::vec3 rim = mesh.corners[any_corner(numbers, mesh.corners)];
        const float share = i % 50 == 0 ? 0.0f : std::ldexp(1.0f, -numbers.below(12));
        const glm::vec3 origin = 0.3f * numbers.in_cube();
        rays.push_back({origin, apex + share * (rim - apex) - origin, 0.0f, no_end});
    }
    return {mesh, rays};
}

// One component is far under the least normal float, and one more may be zero.
HardScene denormal_components(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 3);
    std::vector<Ray> rays = rays_with_a_zero(numbers, mesh.corners, request.rays);
    for (Ray& ray : rays) {
        for (int axis = 0; axis < 3; ++axis) {
            if (ray.direction[axis] == 0.0f) {
                const float units = 1.0f + static_cast<float>(numbers.below(1 << 20));
                ray.direction[axis] = (numbers.below(2) == 0 ? 0x1p-149f : -0x1p-149f) * units;
            }
        }
    }
    return {mesh, rays};
}

// At edges, with directions multiplied by powers of two from one to the other.
HardScene scaled_directions(const HardRequest& request, int least, int most) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 3);
    std::vector<Ray> rays = rays_at_edges(numbers, mesh.corners, request.rays);
    for (Ray& ray : rays) {
        ray.direction *= std::ldexp(1.0f, least + numbers.below(most - least + 1));
    }
    return {mesh, rays};
}

HardScene long_directions(const HardRequest& request) {
    return scaled_directions(request, 20, 100);
}

HardScene short_directions(const HardRequest& request) {
    return scaled_directions(request, -100, -20);
}

// Ends at, right before, right behind, and by a thousandth before and behind the nearest hit.
HardScene ends_at_a_hit(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 3);
    constexpr std::array factors{1.0f, 0x1.fffffep-1f, 0x1.000002p+0f, 0.999f, 1.001f};
    std::vector<Ray> rays = rays_at_triangles(numbers, mesh.corners, request.rays);
    const std::vector<ReferenceHit> nearest = exact_nearest_hits(rays, mesh.corners);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto t = static_cast<float>(nearest[i].t);
        const float end = factors[i % factors.size()] * (t < 1e6f ? t : 1.0f);
        (i / factors.size() % 2 == 0 ? rays[i].t_max : rays[i].t_min) = end;
    }
    return {mesh, rays};
}

// From corners and points of edges, and off the surface by the error bound of chapter 03.
HardScene from_the_surface(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 3);
    const int third = request.rays / 3;
    std::vector<Ray> rays = rays_between_corners(numbers, mesh.corners, third);
    for (int i = 0; i < third; ++i) {
        const glm::vec3 origin = point_on_edge(numbers, mesh.corners);
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    for (const RayFamily& family : families_from_inside(mesh.corners, third, request.seed)) {
        if (family.name == "leaving") {
            rays.insert(rays.end(), family.rays.begin(), family.rays.end());
        }
    }
    return {mesh, rays};
}

HardScene one_centre(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = mesh_of(concentric_triangles(request.seed, 300));
    std::vector<Ray> rays;
    for (const RayFamily& family : ray_families(numbers, mesh.corners, request.rays / 11 + 1)) {
        rays.insert(rays.end(), family.rays.begin(), family.rays.end());
    }
    return {mesh, rays};
}

// Between them such as are rays, so that it is seen when one disturbs the next.
HardScene no_rays(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 3);
    std::vector<Ray> nonsense = nonsense_rays();
    std::erase_if(nonsense, [](const Ray& ray) {
        return is_usable(ray) && ray.direction != glm::vec3(0.0f);
    });
    std::vector<Ray> rays = rays_at_triangles(numbers, mesh.corners, request.rays);
    for (std::size_t i = 0; i < rays.size(); i += 2) {
        rays[i] = nonsense[i / 2 % nonsense.size()];
    }
    return {mesh, rays};
}

} // namespace

const std::vector<ConformanceFamily>& conformance_families() {
    constexpr auto anywhere = AnswerRules::Origin::anywhere;
    constexpr auto inside = AnswerRules::Origin::inside;
    static const std::vector<ConformanceFamily> families{
        {"random", "any rays from inside a closed mesh: to compare with",
         "nobody: such rays find none of these faults", inside, of_case("T0")},
        {"edges", "points of edges of a closed mesh, from inside",
         "tests that compute u + v <= 1 for each triangle by itself", inside, of_case("T1")},
        {"corners", "corners of a closed mesh, from inside",
         "the same tests, in double precision too", inside, of_case("T2")},
        {"valence", "two hundred triangles around a point", "tests with an epsilon on the area",
         inside, many_around_a_point},
        {"grazing", "a closed lens a hundred thousand times wider than high, from inside",
         "tests that divide by a small determinant", inside, of_case("T7")},
        {"needles", "a closed mesh of triangles 100,000 times longer than wide",
         "tests with an epsilon on the determinant", inside, of_case("T6")},
        {"slits", "triangles without area that close slits between others",
         "loaders and builders that drop them", inside, of_case("T8c")},
        {"near_wall", "origins 2^-19 of their reach inside a wall",
         "an epsilon on t, and rays that are moved forward", inside, of_case("T14")},
        {"far", "a closed mesh a million radii away from zero, from inside",
         "rays that are turned into segments, and boxes by plane * inverse - origin * inverse",
         inside, of_case("T12")},
        {"far_origins", "origins 100,000 sizes away", "tests whose error grows with the distance",
         anywhere, of_case("T11")},
        {"tiny", "a closed mesh of radius 1e-9, from inside", "an absolute epsilon", inside,
         tiny_ball},
        {"huge", "a closed mesh of radius 1e15, from inside",
         "a determinant that overflows in single precision", inside, huge_ball},
        {"dynamic_range", "triangles whose sizes double 120 times",
         "bounds padded by a part of the whole scene, or by a fixed length", anywhere,
         of_case("V3a")},
        {"zeros", "zeros of either sign in the direction, in planes of the mesh",
         "0 / 0 in the box test", anywhere, of_case("T10")},
        {"denormals", "components of the direction under the least normal float",
         "an inverse that overflows", anywhere, denormal_components},
        {"long", "directions up to 2^100 long",
         "squares that overflow, and limits that nobody told", anywhere, long_directions, true},
        {"short", "directions down to 2^-100 long",
         "an epsilon on t, and endpoints that are the origin again", anywhere, short_directions,
         true},
        {"ends", "t_min and t_max at, before and behind a hit",
         "who has no t_min, or compares it before rounding", anywhere, ends_at_a_hit},
        {"surface", "origins on the surface", "an epsilon on t that skips the next hit", anywhere,
         from_the_surface},
        {"ties", "every triangle three times, once turned round", "who culls, or loses ties",
         anywhere, of_case("D1")},
        {"flat", "a scene without extent along one axis", "a box of volume 0", anywhere,
         of_case("G7")},
        {"one_triangle", "a scene of one triangle, also in its plane", "a tree of one leaf",
         anywhere, of_case("V2b")},
        {"nothing", "a scene without a triangle", "who reads the first one", anywhere,
         of_case("V2a")},
        {"cell_planes", "triangles and rays in planes of a grid's cells",
         "a triangle in no cell, and a ray between two", anywhere, of_case("G4")},
        {"split_planes", "rays in planes of a kd-tree", "0 / 0 at a plane", anywhere,
         of_case("K3")},
        {"same_centre", "three hundred triangles with one centre", "builders that cannot part them",
         anywhere, one_centre},
        {"no_rays", "NaN and infinity in every second ray",
         "who hangs or crashes, and packets in which one ray spoils the next", anywhere, no_rays,
         true},
    };
    return families;
}

} // namespace raysteps
