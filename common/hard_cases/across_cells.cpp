#include "hard_cases/across_cells.h"

#include "hard_cases/lattice_rays.h"
#include "hard_cases/loose_triangles.h"
#include "scene/shapes.h"

namespace raysteps {

Mesh long_triangle_before_a_small_one() {
    return mesh_of({{1.0f, 0.1f, 0.9f},
                    {1.0f, 0.9f, 0.9f},
                    {15.0f, 0.5f, 0.1f},
                    {6.0f, 0.4f, 0.4f},
                    {6.0f, 0.6f, 0.4f},
                    {6.0f, 0.5f, 0.7f},
                    {16.0f, 0.0f, 0.0f},
                    {16.0f, 1.0f, 0.0f},
                    {16.0f, 0.0f, 1.0f}});
}

LongAndSmall long_triangle_before_a_small_one_among_clutter(RandomNumbers& numbers) {
    const glm::vec3 small(6.0f, 1.0f, 5.75f);
    std::vector<glm::vec3> corners{{0, 0, 0},
                                   {10, 0, 10},
                                   {0, 10, 0},
                                   small + glm::vec3(-0.1f, 0, 0),
                                   small + glm::vec3(0.1f, 0, 0),
                                   small + glm::vec3(0, 0.1f, 0)};
    for (int i = 0; i < 50; ++i) {
        const float x = 10.0f * numbers.unit();
        const glm::vec3 place(x, 5.0f + 5.0f * numbers.unit(), -2.0f);
        corners.insert(corners.end(),
                       {place, place + glm::vec3(0.1f, 0, 0), place + glm::vec3(0, 0.1f, 0)});
    }
    return {mesh_of(std::move(corners)), small};
}

Mesh walls_at_whole_coordinates() {
    Mesh mesh;
    for (int i = 0; i < 5; ++i) {
        const auto at = static_cast<float>(i);
        mesh = join(mesh, quad({at, 0, 0}, {at, 4, 0}, {at, 4, 4}, {at, 0, 4}));
        mesh = join(mesh, quad({0, at, 0}, {0, at, 4}, {4, at, 4}, {4, at, 0}));
        mesh = join(mesh, quad({0, 0, at}, {4, 0, at}, {4, 4, at}, {0, 4, at}));
    }
    return mesh;
}

Mesh wall_behind_loose_triangles(RandomNumbers& numbers) {
    const Mesh wall = quad({0, -40, -40}, {0, 40, -40}, {0, 40, 40}, {0, -40, 40});
    return join(random_triangles(numbers, 60), wall);
}

Mesh triangles_in_planes_of_cells(RandomNumbers& numbers, int cells) {
    std::vector<glm::vec3> corners = box(glm::vec3(-1.0f), glm::vec3(1.0f)).corners;
    GridOptions options;
    options.resolution = cells;
    const GridShape shape = shape_grid(corners, options);
    // The outermost planes lie outside of the box: without them the grid stays the same.
    const Lattice inner{shape.lower + shape.cell_size, shape.cell_size, shape.cells - 2};
    for (int i = 0; i < 100; ++i) {
        const int axis = i % 3;
        const float place = any_lattice_point(numbers, inner)[axis];
        for (int corner = 0; corner < 3; ++corner) {
            glm::vec3 point = any_lattice_point(numbers, inner);
            point[axis] = place;
            corners.push_back(point);
        }
    }
    return mesh_of(std::move(corners));
}

Mesh teapot_in_a_stadium(RandomNumbers& numbers) {
    std::vector<glm::vec3> corners = sphere({0.3f, 0.2f, 0.1f}, 0.5f, 7).corners;
    for (const glm::vec3& corner : random_triangles(numbers, 20).corners) {
        corners.push_back(500.0f * corner);
    }
    return mesh_of(std::move(corners));
}

} // namespace raysteps
