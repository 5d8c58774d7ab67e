#include "hard_cases/meshes.h"

#include "basics/random_numbers.h"
#include "hard_cases/aimed_rays.h"
#include "scene/shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raysteps {

namespace {

constexpr double pi = 3.14159265358979323846;

// On the sphere of radius 1. Rows run from pole to pole; the last point of a row is its first.
glm::vec3 point_on_sphere(int row, int rows, int column, int around) {
    const double down = pi * row / rows;
    const double round = 2.0 * pi * (column % around) / around;
    const double sine = row == 0 || row == rows ? 0.0 : std::sin(down);
    return glm::vec3(sine * std::cos(round), std::cos(down), sine * std::sin(round));
}

void append(std::vector<glm::vec3>& corners, const std::vector<glm::vec3>& more) {
    corners.insert(corners.end(), more.begin(), more.end());
}

} // namespace

glm::vec3 any_direction(RandomNumbers& numbers) {
    while (true) {
        const glm::vec3 point = numbers.in_cube();
        const float squared = glm::dot(point, point);
        if (squared <= 1.0f && squared > 0.01f) {
            return point / std::sqrt(squared);
        }
    }
}

SeenSurface any_triangle(RandomNumbers& numbers, float size, float offset) {
    const glm::vec3 place = offset * any_direction(numbers);
    const glm::vec3 a = place + size * any_direction(numbers);
    const glm::vec3 b = place + size * any_direction(numbers);
    const glm::vec3 c = place + size * any_direction(numbers);
    const float u = numbers.unit();
    const float v = (1.0f - u) * numbers.unit();
    const glm::vec3 inside = a + u * (b - a) + v * (c - a);
    const glm::vec3 eye = inside + 3.0f * size * any_direction(numbers);
    return {mesh_of({a, b, c}), {eye, inside - eye, 0.0f, no_end}};
}

SeenSurface any_parallelogram(RandomNumbers& numbers) {
    const glm::vec3 a = 10.0f * numbers.in_cube();
    const glm::vec3 b = a + numbers.in_cube();
    const glm::vec3 d = a + numbers.in_cube();
    const glm::vec3 c = b + (d - a);
    const float along = numbers.unit();
    const glm::vec3 inside = a + along * (b - a) + numbers.unit() * (d - a);
    const glm::vec3 eye = inside + 3.0f * any_direction(numbers);
    return {mesh_of({a, b, c, a, c, d}), {eye, inside - eye, 0.0f, no_end}};
}

SeenSurface any_point_of_a_ball(RandomNumbers& numbers) {
    static const Mesh ball = sphere(glm::vec3(0.0f), 1.0f, 2);
    const std::size_t a = 3 * numbers.below(ball.corners.size() / 3);
    const float u = numbers.unit();
    const float v = (1.0f - u) * numbers.unit();
    const glm::vec3 point = ball.corners[a] + u * (ball.corners[a + 1] - ball.corners[a]) +
                            v * (ball.corners[a + 2] - ball.corners[a]);
    const glm::vec3 eye = 4.0f * point;
    return {ball, {eye, point - eye, 0.0f, no_end}};
}

Mesh close_spheres(float gap) {
    return join(sphere(glm::vec3(0.0f), 1.0f, 8), sphere(glm::vec3(0.0f), 1.0f + gap, 8));
}

Mesh latitude_sphere(float radius, int rows, int around) {
    Mesh mesh;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        for (const glm::vec3& corner : {a, b, c}) {
            mesh.corners.push_back(radius * corner);
            mesh.normals.push_back(corner);
        }
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < around; ++column) {
            const glm::vec3 a = point_on_sphere(row, rows, column, around);
            const glm::vec3 b = point_on_sphere(row, rows, column + 1, around);
            const glm::vec3 c = point_on_sphere(row + 1, rows, column + 1, around);
            const glm::vec3 d = point_on_sphere(row + 1, rows, column, around);
            if (row > 0) {
                add(a, b, c);
            }
            if (row + 1 < rows) {
                add(a, c, d);
            }
        }
    }
    return mesh;
}

Mesh shared_edge_sphere() {
    return latitude_sphere(2.0f, 20, 40);
}

Mesh sliver_ball(float times) {
    Mesh mesh = sphere(glm::vec3(0.0f), 1.0f, 4);
    for (glm::vec3& corner : mesh.corners) {
        corner.x *= times;
    }
    return mesh;
}

Mesh flat_lens(float height) {
    Mesh mesh = latitude_sphere(1.0f, 12, 24);
    for (glm::vec3& corner : mesh.corners) {
        corner.y *= height;
    }
    return mesh;
}

Mesh scaled_and_moved(Mesh mesh, float scale, const glm::vec3& offset) {
    for (glm::vec3& corner : mesh.corners) {
        corner = scale * corner + offset;
    }
    return mesh;
}

Mesh mesh_of(std::vector<glm::vec3> corners) {
    Mesh mesh;
    mesh.corners = std::move(corners);
    for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
        const glm::dvec3 a(mesh.corners[i]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(mesh.corners[i + 1]) - a, glm::dvec3(mesh.corners[i + 2]) - a);
        const double length = glm::length(normal);
        const glm::vec3 unit =
            length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f, 0.0f, 1.0f);
        mesh.normals.insert(mesh.normals.end(), 3, unit);
    }
    return mesh;
}

Mesh random_triangles(RandomNumbers& numbers, int count) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = numbers.in_cube();
        for (int corner = 0; corner < 3; ++corner) {
            corners.push_back(center + 0.3f * numbers.in_cube());
        }
    }
    return mesh_of(std::move(corners));
}

Mesh random_slivers(RandomNumbers& numbers, int count) {
    std::vector<glm::vec3> corners = random_triangles(numbers, count).corners;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        corners[i + 1] = corners[i] + 2.0f * numbers.in_cube();
        corners[i + 2] = corners[i] + 0.001f * numbers.in_cube();
    }
    return mesh_of(std::move(corners));
}

Mesh flattened(Mesh mesh, int axis, float place) {
    for (glm::vec3& corner : mesh.corners) {
        corner[axis] = place;
    }
    return mesh_of(std::move(mesh.corners));
}

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

Mesh copies_of_a_triangle(int count) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < count; ++i) {
        corners.insert(corners.end(),
                       {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.5f}, {0.0f, 1.0f, 0.25f}});
    }
    return mesh_of(std::move(corners));
}

Mesh tripled(const Mesh& mesh) {
    Mesh turned = mesh;
    for (std::size_t i = 0; i < turned.corners.size(); i += 3) {
        std::swap(turned.corners[i + 1], turned.corners[i + 2]);
    }
    return join(join(mesh, mesh), turned);
}

Mesh reordered(const Mesh& mesh, TriangleOrder order, int seed) {
    std::vector<std::size_t> places(mesh.corners.size() / 3);
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (order == TriangleOrder::backward) {
        std::reverse(places.begin(), places.end());
    }
    if (order == TriangleOrder::shuffled) {
        RandomNumbers numbers(seed);
        for (std::size_t i = places.size(); i > 1; --i) {
            std::swap(places[i - 1], places[numbers.below(i)]);
        }
    }
    Mesh result;
    for (const std::size_t place : places) {
        for (std::size_t i = 3 * place; i < 3 * place + 3; ++i) {
            result.corners.push_back(mesh.corners[i]);
            result.normals.push_back(mesh.normals[i]);
        }
    }
    return result;
}

std::vector<glm::vec3> triangle_around(const glm::vec3& center, const glm::vec3& a) {
    return {center - a, center + a, center + glm::vec3(a.x, -a.y, a.z)};
}

std::vector<glm::vec3> concentric_triangles(int seed, int count) {
    RandomNumbers numbers(seed);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < count; ++i) {
        append(corners, triangle_around(glm::vec3(0.0f), numbers.in_cube()));
    }
    return corners;
}

std::vector<glm::vec3> triangles_at_powers_of_two() {
    std::vector<glm::vec3> corners;
    for (int i = -60; i <= 60; ++i) {
        const float size = std::ldexp(1.0f, i);
        append(corners, triangle_around(glm::vec3(size), glm::vec3(0.1f * size)));
    }
    return corners;
}

std::vector<glm::vec3> shells(int count) {
    std::vector<glm::vec3> corners;
    for (int i = 1; i <= count; ++i) {
        append(corners, triangle_around(glm::vec3(0.0f), glm::vec3(static_cast<float>(i))));
    }
    return corners;
}

std::vector<glm::vec3> heaps_at_the_end_of_floats(int seed) {
    RandomNumbers numbers(seed);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 64; ++i) {
        const glm::vec3 heap(i % 2 == 0 ? -8.0f : 8.0f, 0.0f, 0.0f);
        for (const glm::vec3& corner : triangle_around(heap + numbers.in_cube(), {1, 1, 1})) {
            corners.push_back(1e29f * corner);
        }
    }
    return corners;
}

std::vector<glm::vec3> box_in_the_corner_of_a_box() {
    return join(box(glm::vec3(0.0f), glm::vec3(1.0f)), box(glm::vec3(0.0f), glm::vec3(0.5f)))
        .corners;
}

std::vector<glm::vec3> triangles_at_doubling_distances() {
    std::vector<glm::vec3> corners{{0, 0, 0}, {0, 0.25f, 0}, {0, 0, 0.25f}};
    for (float x = 1.0f; x < 16384.0f; x *= 2.0f) {
        append(corners, {{x, 0, 0}, {x, 0.25f, 0}, {x, 0, 0.25f}});
    }
    return corners;
}

} // namespace raysteps
