#include "hard_cases/aimed_rays.h"
#include "hard_cases/case_lists.h"
#include "hard_cases/meshes.h"
#include "structure/grid/build_grid.h"

#include <algorithm>

namespace raysteps {

namespace {

FamilyValues with_resolution(int resolution) {
    return {{"grid", {{"resolution", std::to_string(resolution)}}}};
}

// The lattice of the grid that a request with that resolution builds (0: with none).
Lattice lattice_for(const Mesh& mesh, int resolution) {
    GridOptions options;
    options.resolution = resolution;
    return lattice_of(shape_grid(mesh.corners, options));
}

HardScene hit_beyond_its_cell(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        const float y = 0.48f + 0.04f * numbers.unit();
        rays.push_back({{0.0f, y, 0.5f}, {1, 0, 0}, 0.0f, no_end});
    }
    return {long_triangle_before_a_small_one(), rays, rays.size(), with_resolution(4)};
}

// In a plane, a thousand cells along an axis are soon built.
HardScene many_cells(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = flattened(random_triangles(numbers, 200), 2, 0.25f);
    const std::vector<Ray> rays = rays_at_edges(numbers, mesh.corners, request.rays);
    return {mesh, rays, part_of(rays, 0.5), with_resolution(1024)};
}

HardScene through_lattice_points(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = wall_behind_loose_triangles(numbers);
    Lattice middle = lattice_for(mesh, 64);
    middle.lower = glm::vec3(-2.0f, -5.0f, -5.0f);
    middle.cells.y = 8;
    middle.cells.z = 8;
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < request.rays) {
        for (const Ray& ray : rays_through_lattice_points(numbers, middle, request.rays)) {
            if (ray.origin.x * (ray.origin.x + 3.0f * ray.direction.x) < 0.0f) {
                rays.push_back(ray);
                rays.push_back(reversed(std::span(&ray, 1)).front());
            }
        }
    }
    return {mesh, rays, rays.size(), with_resolution(64)};
}

HardScene triangles_in_planes(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = triangles_in_planes_of_cells(numbers, 6);
    std::vector<Ray> rays;
    const int each = request.rays / 12 + 1;
    for (const RayFamily& family : ray_families(numbers, mesh.corners, each)) {
        rays = joined(std::move(rays), family.rays);
    }
    for (const RayFamily& family : lattice_families(numbers, lattice_for(mesh, 6), each)) {
        rays = joined(std::move(rays), family.rays);
    }
    return {mesh, rays, part_of(rays, 0.2), with_resolution(6)};
}

HardScene origins_around_the_grid(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = random_triangles(numbers, 200);
    const Lattice lattice = lattice_for(mesh, 0);
    const glm::vec3 upper = lattice.lower + lattice.step * glm::vec3(lattice.cells);
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        glm::vec3 origin = point_in_box(numbers, {lattice.lower, upper});
        const glm::vec3 inside = origin;
        const int axis = numbers.below(3);
        const bool at_upper = numbers.below(2) == 0;
        origin[axis] = at_upper ? upper[axis] : lattice.lower[axis]; // on a face
        if (i % 4 == 1) {
            origin[axis] += at_upper ? 1.0f : -1.0f; // outside
        } else if (i % 4 == 2) {
            origin = any_lattice_point(numbers, lattice);
        } else if (i % 4 == 3) {
            origin = inside;
        }
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    return {mesh, rays, part_of(rays, 0.1)};
}

HardScene zero_components(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = random_triangles(numbers, 200);
    const std::vector<Ray> along = axis_parallel_rays(numbers, mesh.corners, request.rays / 2);
    const std::vector<Ray> rays =
        joined(along, rays_with_a_zero(numbers, mesh.corners, request.rays / 2));
    return {mesh, rays, part_of(rays, 0.3)};
}

HardScene flat_scene(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = flattened(random_triangles(numbers, 200), request.seed % 3, 0.7f);
    std::vector<Ray> rays = rays_at_triangles(numbers, mesh.corners, request.rays / 2);
    for (const RayFamily& family : ray_families(numbers, mesh.corners, request.rays / 20 + 1)) {
        rays = joined(std::move(rays), family.rays);
    }
    return {mesh, rays, part_of(rays, 0.4)};
}

HardScene no_rays_at_all(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    return {random_triangles(numbers, 100), nonsense_rays()};
}

HardScene teapot(const HardRequest& request) {
    RandomNumbers numbers(request.seed);
    const Mesh mesh = teapot_in_a_stadium(numbers);
    std::vector<Ray> rays;
    for (int i = 0; i < request.rays; ++i) {
        const glm::vec3 origin = 5.0f * numbers.in_cube();
        rays.push_back({origin, point_on_edge(numbers, mesh.corners) - origin, 0.0f, no_end});
    }
    return {mesh, rays, part_of(rays, 0.7)};
}

const std::string amanatides =
    "Amanatides and Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987";

} // namespace

std::vector<HardCase> grid_cases() {
    const auto make = [](const char* name, const char* title, const std::string& source,
                         const char* remedy, int most_rays, auto generator) {
        return HardCase{
            name,   title,     source,   Truth::the_loop, Guarantee::promised, Tries::structures,
            remedy, most_rays, generator};
    };
    return {
        make("G1", "a hit beyond the cell that lists it, with a nearer one on the way", amanatides,
             "end only where the hit lies before the exit of the cell", 100000,
             hit_beyond_its_cell),
        make("G2", "a thousand cells along an axis: sums of steps would drift", amanatides,
             "compute each crossing from the index of its plane", 100000, many_cells),
        make("G3", "rays through points of the lattice, there and back, at a wall", "", "", 100000,
             through_lattice_points),
        make("G4", "triangles in planes of cells and on the far face of the grid", "",
             "pad each triangle when it is listed", 1000000, triangles_in_planes),
        make("G5", "origins inside, outside, on faces and at corners of the grid", "", "", 1000000,
             origins_around_the_grid),
        make("G6", "zero components in the direction", "", "", 1000000, zero_components),
        make("G7", "a flat scene: no extent along one axis", "", "", 1000000, flat_scene),
        HardCase{"G8", "rays that are no rays: NaN, infinite, without a direction", "",
                 Truth::answered, Guarantee::promised, Tries::structures, "", 1000, no_rays_at_all},
        make("G9", "a teapot in a stadium: nearly all triangles in one cell", "",
             "a tree: kd or BVH", 20000, teapot),
    };
}

} // namespace raysteps
