#include "catch.h"
#include "grid_hits.h"
#include "scene/sample_scenes.h"
#include "scene/shapes.h"

#include <algorithm>

using namespace raysteps;

namespace {

Scene scene_of_corners(const std::vector<glm::vec3>& corners) {
    Mesh mesh;
    mesh.corners = corners;
    mesh.normals.resize(corners.size(), {0.0f, 0.0f, 1.0f});
    return scene_of(mesh);
}

// Bit-equal with the loop; returns how many hits there are.
std::size_t check_agreement(const Scene& scene, const Grid& grid, std::span<const Ray> rays) {
    const Agreement agreement = agreement_of(scene, grid, rays);
    CHECK(agreement.different == 0);
    CHECK(agreement.different_by_mailbox == 0);
    return agreement.hits;
}

// The numbers of the cells that a walk visits, as it goes, one round at a time.
std::vector<int> cells_on_the_way(const Scene& scene, const Grid& grid, const Ray& ray) {
    const mirror::SceneBuffers buffers(scene);
    GridWalk mirror = mirror::mirror_of<GridWalk>(buffers, grid);
    const auto own = mirror::to_mirror<GridWalk>(ray);
    std::vector<int> cells;
    auto walk = mirror.start_walk(own);
    while (!walk.ended) {
        if (cells.empty() || cells.back() != walk.place.x) {
            cells.push_back(walk.place.x);
        }
        walk = mirror.go_on(walk, own, -mirror.farthest, 1);
    }
    return cells;
}

// A wall across the grid at x = 8 - 1/8, and something small at either end of the grid.
Scene wall() {
    return scene_of_corners({{0.0f, 0.0f, 0.0f},
                             {0.0f, 0.125f, 0.0f},
                             {0.0f, 0.0f, 0.125f},
                             {8.0f, 8.0f, 8.0f},
                             {8.0f, 7.875f, 8.0f},
                             {8.0f, 8.0f, 7.875f},
                             {7.875f, 0.0f, 0.0f},
                             {7.875f, 16.0f, 0.0f},
                             {7.875f, 0.0f, 16.0f}});
}

} // namespace

TEST_CASE("a walk visits the cells that the ray crosses in their order", "[04][walk]") {
    const Scene scene = wall(); // x 0 ... 8, y and z 0 ... 16
    const Grid grid = grid_for(scene, {}, with_resolution(4));
    REQUIRE(grid.shape.cells == glm::ivec3(2, 4, 4));
    const auto cells = [&](const glm::vec3& origin, const glm::vec3& direction) {
        return cells_on_the_way(scene, grid, {origin, direction, 0.0f, 3.0f});
    };
    using Cells = std::vector<int>;
    CHECK(cells({1.0f, 1.0f, 1.0f}, {0.0f, 4.0f, 0.0f}) == Cells{0, 2, 4, 6});
    CHECK(cells({1.0f, 13.0f, 1.0f}, {0.0f, -4.0f, 0.0f}) == Cells{6, 4, 2, 0});
    CHECK(cells({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 4.0f}) == Cells{0, 8, 16, 24});
    // y reaches each of its planes before z does.
    CHECK(cells({1.0f, 1.5f, 1.0f}, {0.0f, 4.0f, 4.0f}) == Cells{0, 2, 10, 12, 20, 22, 30});
    CHECK(cells({1.0f, 1.0f, 1.0f}, {0.0f, 0.1f, 0.1f}) == Cells{0}); // t_max is in the first
    CHECK(cells({1.0f, -1.0f, 1.0f}, {0.0f, -1.0f, 0.0f}).empty());
    CHECK(cells({1.0f, -9.0f, 1.0f}, {0.0f, 1.0f, 0.0f}).empty()); // t_max is before it
}

TEST_CASE("G1 a hit beyond the cell does not end the walk", "[04][hard_case]") {
    // Triangle 0 is listed in the first cell and hit in the fourth; triangle 1 lies between.
    const Scene scene = scene_of_corners({{1.0f, 0.1f, 0.9f},
                                          {1.0f, 0.9f, 0.9f},
                                          {15.0f, 0.5f, 0.1f},
                                          {6.0f, 0.4f, 0.4f},
                                          {6.0f, 0.6f, 0.4f},
                                          {6.0f, 0.5f, 0.7f},
                                          {16.0f, 0.0f, 0.0f},
                                          {16.0f, 1.0f, 0.0f},
                                          {16.0f, 0.0f, 1.0f}});
    const std::vector<Ray> rays{{{0.0f, 0.5f, 0.5f}, {1.0f, 0.0f, 0.0f}, 0.0f, no_end}};
    const Grid grid = grid_for(scene, rays, with_resolution(4));
    REQUIRE(grid.shape.cells == glm::ivec3(4, 1, 1));
    const mirror::SceneBuffers buffers(scene);
    CHECK(hits_by(mirror::mirror_of<GridWalk>(buffers, grid), rays).front().triangle == 1);
    CHECK(check_agreement(scene, grid, rays) == 1);
}

TEST_CASE("G2 a thousand cells along an axis agree with the loop", "[04][hard_case]") {
    const int seed = 2;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 1000);
    for (const int resolution : {128, 256}) {
        const Grid grid = grid_for(scene, rays, with_resolution(resolution));
        CHECK(check_agreement(scene, grid, rays) > 500);
    }
    Scene flat = scene; // in a plane a thousand cells are soon built
    for (glm::vec3& corner : flat.corners) {
        corner.z = 0.25f;
    }
    const std::vector<Ray> at_flat = rays_at_edges(numbers, flat.corners, 1000);
    const Grid grid = grid_for(flat, at_flat, with_resolution(1024));
    REQUIRE(std::max(grid.shape.cells.x, grid.shape.cells.y) == 1024);
    CHECK(check_agreement(flat, grid, at_flat) > 500);
}

TEST_CASE("G3 rays through lattice points hit a wall on the way there and back",
          "[04][hard_case]") {
    const int seed = 3;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    // Two triangles that share the edge y = z, far larger than the lattice of the loose ones, so
    // that each ray that goes along x meets one of them, inside or on the shared edge.
    Mesh mesh = random_triangles(numbers, 60);
    const std::vector<glm::vec3> corners{{0.0f, -40.0f, -40.0f}, {0.0f, 40.0f, -40.0f},
                                         {0.0f, 40.0f, 40.0f},   {0.0f, -40.0f, -40.0f},
                                         {0.0f, 40.0f, 40.0f},   {0.0f, -40.0f, 40.0f}};
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.normals.resize(mesh.corners.size(), {1.0f, 0.0f, 0.0f});
    const Scene scene = scene_of(mesh);
    const Grid grid = grid_for(scene, {}, with_resolution(64));
    const GridShape middle{glm::vec3(-2.0f, -5.0f, -5.0f), grid.shape.cell_size,
                           glm::ivec3(grid.shape.cells.x, 8, 8), 0.0};
    std::vector<Ray> there = rays_through_lattice_points(numbers, lattice_of(middle), 3000);
    there.erase(std::remove_if(there.begin(), there.end(),
                               [](const Ray& ray) {
                                   return ray.origin.x * (ray.origin.x + 3 * ray.direction.x) >=
                                          0.0f;
                               }),
                there.end());
    REQUIRE(there.size() > 1000);
    const std::vector<Ray> back = reversed(there);
    CHECK(check_agreement(scene, grid, there) == there.size());
    CHECK(check_agreement(scene, grid, back) == back.size());
}

TEST_CASE("G4 triangles in the planes of cells and on the far face are hit", "[04][hard_case]") {
    const int seed = 4;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    std::vector<glm::vec3> corners = box({-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}).corners;
    const GridShape shape = grid_for(scene_of_corners(corners), {}, with_resolution(6)).shape;
    REQUIRE(shape.cells == glm::ivec3(6));
    const Lattice lattice = lattice_of(shape);
    // Corners at lattice points, but for the outermost ones, which are outside of the box: the grid
    // stays the same.
    const Lattice inner{shape.lower + shape.cell_size, shape.cell_size, glm::ivec3(4)};
    for (int i = 0; i < 100; ++i) {
        const int axis = i % 3;
        glm::vec3 a = any_lattice_point(numbers, inner);
        for (int corner = 0; corner < 3; ++corner) {
            glm::vec3 point = any_lattice_point(numbers, inner);
            point[axis] = a[axis];
            corners.push_back(point);
        }
    }
    const Scene scene = scene_of_corners(corners);
    const Grid grid = grid_for(scene, {}, with_resolution(6));
    REQUIRE(grid.shape.lower == shape.lower);
    REQUIRE(grid.shape.cell_size == shape.cell_size);
    for (const RayFamily& family : ray_families(numbers, corners, 1500)) {
        CAPTURE(family.name);
        CHECK(check_agreement(scene, grid, family.rays) > 300);
    }
    for (const RayFamily& family : lattice_families(numbers, shape, 1500)) {
        CAPTURE(family.name);
        CHECK(check_agreement(scene, grid, family.rays) > 300);
    }
    CHECK(lattice.cells == glm::ivec3(6));
}

TEST_CASE("G5 origins inside and outside and on a face of the grid and pointing away",
          "[04][hard_case]") {
    const int seed = 5;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const Grid grid = grid_for(scene, {});
    const Lattice lattice = lattice_of(grid.shape);
    const glm::vec3 upper =
        lattice.lower + lattice.step * glm::vec3(lattice.cells); // a face, up to a rounding
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
        glm::vec3 origin = point_in_box(numbers, {lattice.lower, upper});
        const int axis = numbers.below(3);
        const bool at_upper = numbers.below(2) == 0;
        origin[axis] = at_upper ? upper[axis] : lattice.lower[axis]; // on a face
        if (i % 4 == 1) {
            origin[axis] += at_upper ? 1.0f : -1.0f; // outside
        } else if (i % 4 == 2) {
            origin = any_lattice_point(numbers, lattice);
        } else if (i % 4 == 3) {
            origin = point_in_box(numbers, {lattice.lower, upper});
        }
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    const std::size_t hits = check_agreement(scene, grid, rays);
    CHECK(hits > 500);
    CHECK(hits < 3500); // many point away
    const std::vector<Ray> away{{{0.0f, 0.0f, 9.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end},
                                {{0.0f, 0.0f, 9.0f}, {0.1f, 0.1f, 1.0f}, 0.0f, no_end}};
    CHECK(cells_on_the_way(scene, grid, away[0]).empty());
    CHECK(cells_on_the_way(scene, grid, away[1]).empty());
}

TEST_CASE("G6 a zero component keeps the ray in its cells and beside the grid misses",
          "[04][hard_case]") {
    const int seed = 6;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const Grid grid = grid_for(scene, {});
    CHECK(check_agreement(scene, grid, axis_parallel_rays(numbers, scene.corners, 4000)) > 400);
    CHECK(check_agreement(scene, grid, rays_with_a_zero(numbers, scene.corners, 4000)) > 2000);
    const glm::ivec3 cells = grid.shape.cells;
    const Ray along{{0.01f, 0.01f, -9.0f}, {0.0f, -0.0f, 1.0f}, 0.0f, no_end};
    const std::vector<int> visited = cells_on_the_way(scene, grid, along);
    REQUIRE(!visited.empty());
    for (std::size_t i = 1; i < visited.size(); ++i) {
        CHECK(visited[i] == visited[i - 1] + cells.x * cells.y);
    }
    const Ray beside{{0.01f, 9.0f, -9.0f}, {0.0f, 0.0f, 1.0f}, 0.0f, no_end};
    CHECK(cells_on_the_way(scene, grid, beside).empty());
}

TEST_CASE("G7 a flat scene is hit wherever the loop hits it", "[04][hard_case]") {
    const int seed = 7;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int axis = 0; axis < 3; ++axis) {
        Scene scene = scene_of(random_triangles(numbers, 200));
        for (glm::vec3& corner : scene.corners) {
            corner[axis] = 0.7f;
        }
        for (const RayFamily& family : ray_families(numbers, scene.corners, 1000)) {
            CAPTURE(axis, family.name);
            check_agreement(scene, grid_for(scene, family.rays), family.rays);
        }
        const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 1000);
        CHECK(check_agreement(scene, grid_for(scene, rays), rays) > 900);
    }
}

TEST_CASE("G8 rays that are no rays are answered within the grid", "[04][hard_case]") {
    const int seed = 8;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 100));
    const Grid grid = grid_for(scene, {});
    const mirror::SceneBuffers buffers(scene);
    GridWalk mirror = mirror::mirror_of<GridWalk>(buffers, grid);
    // A walk steps along each axis at most once a cell, and tests each reference at most once.
    const int most_rounds = grid.shape.cells.x + grid.shape.cells.y + grid.shape.cells.z +
                            static_cast<int>(grid.references.size());
    int walks = 0;
    for (const Ray& ray : nonsense_rays()) {
        const auto own = mirror::to_mirror<GridWalk>(ray);
        auto walk = mirror.start_walk(own);
        int rounds = 0;
        for (; !walk.ended && rounds <= most_rounds; ++rounds) {
            REQUIRE(walk.place.x >= 0);
            REQUIRE(walk.place.x < cell_count(grid.shape));
            walk = mirror.go_on(walk, own, -mirror.farthest, 1);
        }
        CHECK(rounds <= most_rounds);
        walks += rounds > 0 ? 1 : 0;
    }
    CHECK(walks > 20);
}

TEST_CASE("G9 a teapot in a stadium is right however slow", "[04][hard_case]") {
    const int seed = 9;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    // A small sphere in the middle of a few triangles that are a thousand times as large.
    Mesh mesh = sphere({0.3f, 0.2f, 0.1f}, 0.5f, 7);
    for (const glm::vec3& corner : random_triangles(numbers, 20).corners) {
        mesh.corners.push_back(500.0f * corner);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
    const Scene scene = scene_of(mesh);
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 origin = 5.0f * numbers.in_cube();
        rays.push_back({origin, point_on_edge(numbers, scene.corners) - origin, 0.0f, no_end});
    }
    const Grid grid = grid_for(scene, rays);
    CHECK(check_agreement(scene, grid, rays) > 1500);
    // Nearly all of the 1000 triangles share a cell or two.
    std::int32_t longest = 0;
    for (std::size_t cell = 0; cell + 1 < grid.starts.size(); ++cell) {
        longest = std::max(longest, grid.starts[cell + 1] - grid.starts[cell]);
    }
    CHECK(longest > 900);
}

TEST_CASE("G10 a walk takes at most one step a cell along each axis", "[04][hard_case]") {
    const int seed = 10;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    const Grid grid = grid_for(scene, {}, with_resolution(32));
    const mirror::SceneBuffers buffers(scene);
    auto counted = mirror::mirror_of<mirror::GridCounted<float>>(buffers, grid);
    const glm::ivec3 cells = grid.shape.cells;
    unsigned most = 0;
    for (const RayFamily& family : lattice_families(numbers, grid.shape, 2000)) {
        for (const Ray& ray : family.rays) {
            counted.observe_from(mirror::uvec4(0U));
            counted.closest_hit(mirror::to_mirror<decltype(counted)>(ray));
            most = std::max(most, counted.observations().x);
        }
    }
    CHECK(most > 32U);
    CHECK(most <= static_cast<unsigned>(cells.x + cells.y + cells.z - 2));
}

TEST_CASE("of coincident triangles the smallest is hit in any order", "[04][hard_case]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Mesh mesh = sphere({0.0f, 0.0f, 0.0f}, 1.0f, 3);
    std::vector<glm::vec3> corners = mesh.corners;
    corners.insert(corners.end(), mesh.corners.begin(), mesh.corners.end());   // equal
    corners.insert(corners.end(), mesh.corners.rbegin(), mesh.corners.rend()); // wound backwards
    const auto triangles = static_cast<int>(corners.size() / 3);
    std::vector<int> order(static_cast<std::size_t>(triangles));
    for (int i = 0; i < triangles; ++i) {
        order[static_cast<std::size_t>(i)] = i;
    }
    std::vector<std::vector<int>> orders{order, {order.rbegin(), order.rend()}};
    for (std::size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1],
                  order[static_cast<std::size_t>(numbers.below(static_cast<int>(i)))]);
    }
    orders.push_back(order);
    const std::vector<Ray> rays = rays_at_corners(numbers, corners, 2000);
    for (const std::vector<int>& each : orders) {
        std::vector<glm::vec3> ordered;
        for (const int triangle : each) {
            const auto first = std::ptrdiff_t{3} * triangle;
            ordered.insert(ordered.end(), corners.begin() + first, corners.begin() + first + 3);
        }
        const Scene scene = scene_of_corners(ordered);
        CHECK(check_agreement(scene, grid_for(scene, rays), rays) > 1900);
    }
}

TEST_CASE("ten thousand copies of a triangle are one hit and the first", "[04][hard_case]") {
    std::vector<glm::vec3> corners{{4.0f, 4.0f, 4.0f}, {4.1f, 4.0f, 4.0f}, {4.0f, 4.1f, 4.0f}};
    for (int copy = 0; copy < 10000; ++copy) {
        corners.insert(corners.end(), {{0.0f, 0.0f, 0.0f}, {2.0f, 0.1f, 0.2f}, {0.1f, 2.0f, 0.3f}});
    }
    const Scene scene = scene_of_corners(corners);
    const int seed = 12;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const std::vector<Ray> rays = rays_at_triangles(numbers, scene.corners, 100);
    const Grid grid = grid_for(scene, rays, with_resolution(8));
    CHECK(check_agreement(scene, grid, rays) == 100);
    const mirror::SceneBuffers buffers(scene);
    for (const Hit& hit : hits_by(mirror::mirror_of<MailboxWalk>(buffers, grid), rays)) {
        CHECK(hit.triangle == 1);
    }
}

TEST_CASE("a hit exactly at t_min or at t_max counts in every cell", "[04][hard_case]") {
    const int seed = 13;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Scene scene = scene_of(random_triangles(numbers, 200));
    std::vector<Ray> rays = rays_at_edges(numbers, scene.corners, 2000);
    const Grid grid = grid_for(scene, rays, with_resolution(16));
    const mirror::SceneBuffers buffers(scene);
    const std::vector<Hit> hits = hits_by(mirror::mirror_of<EveryTriangle>(buffers), rays);
    std::vector<Ray> at_end = rays;
    std::vector<Ray> at_start = rays;
    std::vector<Ray> at_both = rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        at_end[i].t_max = hits[i].t;
        at_start[i].t_min = hits[i].t;
        at_both[i].t_min = hits[i].t;
        at_both[i].t_max = hits[i].t;
    }
    const std::size_t count = count_hits(hits);
    REQUIRE(count > 1500);
    CHECK(check_agreement(scene, grid, at_end) == count);
    CHECK(check_agreement(scene, grid, at_start) == count);
    CHECK(check_agreement(scene, grid, at_both) == count);
}
