#include "hard_cases/aimed_rays.h"
#include "hard_cases/case_lists.h"
#include "hard_cases/meshes.h"
#include "scene/shapes.h"
#include "structure/kd_tree/build_kd_tree.h"

namespace raysteps {

namespace {

// As many leaves as can be: for the generator, and for the builder by name.
KdOptions small_leaves() {
    KdOptions options;
    options.leaf_triangles = 0;
    options.traversal_cost = 0.0;
    options.bad_splits = 4;
    return options;
}

const FamilyValues small_leaves_by_name{
    {"kd", {{"leaf-triangles", "0"}, {"traversal-cost", "0"}, {"bad-splits", "4"}}}};
const FamilyValues median_by_name{{"kd", {{"leaf-triangles", "0"}, {"split", "median"}}}};

KdOptions median() {
    KdOptions options;
    options.split = KdSplit::median;
    options.leaf_triangles = 0;
    return options;
}

std::vector<Ray> all_of(const std::vector<RayFamily>& families) {
    std::vector<Ray> rays;
    for (const RayFamily& family : families) {
        rays = joined(std::move(rays), family.rays);
    }
    return rays;
}

HardScene at_the_planes(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 4);
    const KdTree tree = build_kd_tree(mesh.corners, small_leaves());
    std::vector<Ray> rays =
        all_of(tree_families(numbers, tree, mesh.corners, request.rays / 4 + 1));
    for (std::size_t i = 0; i < rays.size(); i += 2) {
        rays[i].direction /= 1e5f; // t is large at every plane
    }
    return {mesh, rays, part_of(rays, 0.2), small_leaves_by_name};
}

// Every t small or large: a scene of that scale, and directions of any length.
HardScene any_size_of_t(const HardRequest& request, float scale) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = scaled_and_moved(sphere(glm::vec3(0.0f), 1.0f, 4), scale, glm::vec3(0.0f));
    std::vector<Ray> rays;
    for (const float distance : {1e-4f, 32.0f, 2048.0f, 1e7f}) {
        const std::vector<Ray> some = rays_at_edges(numbers, mesh.corners, request.rays / 4);
        rays = joined(std::move(rays), with_large_t(some, distance));
    }
    return {mesh, rays, part_of(rays, 0.8)};
}

HardScene large_t(const HardRequest& request) {
    return any_size_of_t(request, 1e6f);
}

HardScene small_t(const HardRequest& request) {
    return any_size_of_t(request, 1e-6f);
}

HardScene in_split_planes(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = random_triangles(numbers, 300);
    const KdTree tree = build_kd_tree(mesh.corners, small_leaves());
    const std::vector<Ray> rays =
        joined(rays_in_box_planes(numbers, tree, mesh.corners, request.rays / 2),
               rays_along_box_edges(numbers, tree, request.rays / 2));
    return {mesh, rays, part_of(rays, 0.3), small_leaves_by_name};
}

HardScene triangles_in_split_planes(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = walls_at_whole_coordinates();
    const Lattice lattice{glm::vec3(0.0f), glm::vec3(1.0f), glm::ivec3(4)};
    const int each = request.rays / 14 + 1;
    std::vector<Ray> rays = all_of(ray_families(numbers, mesh.corners, each));
    rays = joined(std::move(rays), all_of(lattice_families(numbers, lattice, each)));
    return {mesh, rays, part_of(rays, 0.3), small_leaves_by_name};
}

HardScene splits_at_bounds(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = mesh_of(box_in_the_corner_of_a_box());
    const std::vector<Ray> rays =
        all_of(ray_families(numbers, mesh.corners, request.rays / 11 + 1));
    return {mesh,
            rays,
            part_of(rays, 0.3),
            {{"kd", {{"leaf-triangles", "0"}, {"traversal-cost", "0"}, {"bad-splits", "16"}}}}};
}

// Along the diagonals of a cube of medians, two or three planes are met at equal distances.
HardScene edges_of_leaves(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 5);
    const KdTree tree = build_kd_tree(mesh.corners, median());
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        const glm::vec3 through = any_box_corner(numbers, tree);
        glm::vec3 direction;
        for (int axis = 0; axis < 3; ++axis) {
            direction[axis] = static_cast<float>(numbers.below(3) - 1);
        }
        rays.push_back({through - 4.0f * direction, direction, -no_end, no_end});
    }
    return {mesh, rays, part_of(rays, 0.3), median_by_name};
}

// A ray that is one point long: where its target is, or a corner of a box.
HardScene one_point_long(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 5);
    const KdTree tree = build_kd_tree(mesh.corners, small_leaves());
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        // From a lattice of powers of two, so that the corner is met at t = 1, exactly.
        const glm::vec3 target = mesh.corners[any_corner(numbers, mesh.corners)];
        const glm::vec3 away = glm::vec3(numbers.below(5) - 2, numbers.below(5) - 2, 1);
        Ray ray{target - away, away, 1.0f, 1.0f};
        ray.direction = target - ray.origin;
        if (i % 4 == 3) {
            ray.direction = any_box_corner(numbers, tree) - ray.origin;
        }
        rays.push_back(ray);
    }
    return {mesh, rays, part_of(rays, 0.05), small_leaves_by_name};
}

HardScene hit_beyond_its_leaf(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const auto [mesh, small] = long_triangle_before_a_small_one_among_clutter(numbers);
    const glm::vec3 origin(-1.0f, 1.0f, 0.5f);
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        const glm::vec3 target = small + glm::vec3(0.05f, 0.05f, 0.0f) * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return {mesh, rays, part_of(rays, 0.2), small_leaves_by_name};
}

HardScene fuller_than_the_stack(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = mesh_of(triangles_at_doubling_distances());
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        // Past the first triangles, and through one of the last ones.
        const glm::vec3 origin(0.5f, 0.3f + numbers.unit(), 0.0625f);
        const auto x = static_cast<float>(1 << numbers.below(14));
        const glm::vec3 target(x, 0.125f * numbers.unit(), 0.0625f);
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return {mesh, rays, part_of(rays, 0.7), median_by_name};
}

const std::string foley =
    "Foley and Sugerman, KD-Tree Acceleration Structures for a GPU Raytracer, 2005";
const std::string popov =
    "Popov, Guenther, Seidel and Slusallek, Stackless KD-Tree Traversal, 2007";

} // namespace

std::vector<HardCase> kd_cases() {
    const auto make = [](const char* name, const char* title, const std::string& source,
                         const char* remedy, int most_rays, auto generator) {
        return HardCase{
            name,   title,     source,   Truth::the_loop, Guarantee::promised, Tries::structures,
            remedy, most_rays, generator};
    };
    return {
        make("K1", "planes, edges and corners of leaves, near and at a large t", foley,
             "go on from the exit of the leaf itself, with one rule for equal distances", 1000000,
             at_the_planes),
        make("K2a", "a large scene and any size of t: an epsilon would make no progress", foley,
             "no epsilon", 1000000, large_t),
        make("K2b", "a small scene and any size of t: an epsilon would skip hits", foley,
             "no epsilon", 1000000, small_t),
        make("K3", "rays in planes of splits, where 0 is divided by 0", "", "visit both children",
             1000000, in_split_planes),
        make("K4", "triangles in planes of splits", "", "list them on both sides", 1000000,
             triangles_in_split_planes),
        make("K5", "planes that are bounds of the node they would split", "",
             "no split within eight paddings of a bound", 100000, splits_at_bounds),
        make("K6", "rays through edges and corners of leaves", popov,
             "of equal exits take any: each step comes farther", 1000000, edges_of_leaves),
        make("K7", "rays that are one point long", "", "an interval is closed at both ends",
             1000000, one_point_long),
        make("K8", "a hit beyond the exit of the leaf that lists it", "",
             "end only where the hit lies before the exit of the leaf", 100000,
             hit_beyond_its_leaf),
        make("K9", "a way that puts off more nodes than a short stack has room for", "",
             "restart, or climb, where the stack forgot", 100000, fuller_than_the_stack),
    };
}

} // namespace raysteps
