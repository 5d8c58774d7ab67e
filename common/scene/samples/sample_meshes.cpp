#include "basics/random_numbers.h"
#include "scene/mesh.h"
#include "scene/samples/samples.h"
#include "scene/shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace raysteps {

namespace {

using Tetrahedron = std::array<glm::vec3, 4>;

// The four tetrahedra of half the size in its corners. They touch in the middles of its edges.
std::array<Tetrahedron, 4> halve(const Tetrahedron& corners) {
    std::array<Tetrahedron, 4> smaller;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            smaller[i][j] = 0.5f * (corners[i] + corners[j]);
        }
    }
    return smaller;
}

} // namespace

Scene sample_tetrahedron(int depth) {
    const float side = std::sqrt(3.0f) / 2.0f;
    std::vector<Tetrahedron> tetrahedra = {{{{0.0f, 0.0f, 1.0f},
                                             {-side, 0.0f, -0.5f},
                                             {side, 0.0f, -0.5f},
                                             {0.0f, std::sqrt(2.0f), 0.0f}}}};
    for (int level = 0; level < depth; ++level) {
        std::vector<Tetrahedron> smaller;
        for (const Tetrahedron& corners : tetrahedra) {
            const std::array<Tetrahedron, 4> halves = halve(corners);
            smaller.insert(smaller.end(), halves.begin(), halves.end());
        }
        tetrahedra = std::move(smaller);
    }
    Mesh mesh;
    for (const Tetrahedron& corners : tetrahedra) {
        mesh = join(std::move(mesh), tetrahedron(corners[0], corners[1], corners[2], corners[3]));
    }
    return add_mesh({}, mesh, matte("gold", {0.75f, 0.50f, 0.15f}));
}

Scene sample_knot(int size) {
    return add_mesh({}, torus_knot(size), matte("jade", {0.15f, 0.55f, 0.40f}));
}

Scene sample_compact(int size) {
    return add_mesh({}, sphere(glm::vec3(0.0f), 1.0f, size), matte("clay", {0.70f, 0.30f, 0.20f}));
}

namespace {

constexpr int segments = 52; // of the ring around
constexpr int steps = 10;    // of the stands
constexpr float half_length = 70.0f;
constexpr float half_width = 50.0f; // of the ground inside the stands
constexpr float step_depth = 3.0f;
constexpr float step_height = 2.2f;

// A point of the oval ring: the segment says where on it, the distance how far outside the ground.
glm::vec3 ring_point(int segment, float distance, float height) {
    const double angle = 2.0 * std::numbers::pi * (segment % segments) / segments;
    return {(half_length + distance) * static_cast<float>(std::cos(angle)), height,
            (half_width + distance) * static_cast<float>(std::sin(angle))};
}

Mesh ground() {
    Mesh mesh;
    for (int i = 0; i < segments; ++i) {
        mesh = join(std::move(mesh), triangle(glm::vec3(0.0f), ring_point(i + 1, 0.0f, 0.0f),
                                              ring_point(i, 0.0f, 0.0f)));
    }
    return mesh;
}

// Risers and treads of the steps whose number has this remainder by two.
Mesh stands(int remainder) {
    Mesh mesh;
    for (int step = remainder; step < steps; step += 2) {
        const float near = step_depth * static_cast<float>(step);
        const float far = step_depth * static_cast<float>(step + 1);
        const float low = step_height * static_cast<float>(step);
        const float high = step_height * static_cast<float>(step + 1);
        for (int i = 0; i < segments; ++i) {
            const glm::vec3 near_high = ring_point(i, near, high);
            const glm::vec3 next_near_high = ring_point(i + 1, near, high);
            mesh =
                join(std::move(mesh), quad(ring_point(i, near, low), ring_point(i + 1, near, low),
                                           next_near_high, near_high));
            mesh =
                join(std::move(mesh), quad(near_high, next_near_high, ring_point(i + 1, far, high),
                                           ring_point(i, far, high)));
        }
    }
    return mesh;
}

// Ten mown stripes of a pitch of 105 by 68 metres; it lies 2 cm over the ground.
Mesh stripes(int remainder) {
    Mesh mesh;
    const float height = 0.02f;
    for (int i = remainder; i < 10; i += 2) {
        const float left = -52.5f + 10.5f * static_cast<float>(i);
        const float right = left + 10.5f;
        mesh = join(std::move(mesh), quad({left, height, 34.0f}, {right, height, 34.0f},
                                          {right, height, -34.0f}, {left, height, -34.0f}));
    }
    return mesh;
}

// The knot, 41 cm wide, 5 cm over the pitch.
Mesh small_knot(int size) {
    Mesh mesh = torus_knot(size);
    for (glm::vec3& corner : mesh.corners) {
        corner = 0.1f * corner + glm::vec3(0.0f, 0.26f, 0.0f);
    }
    return mesh;
}

} // namespace

Scene sample_stadium(int size) {
    Scene scene;
    scene = add_mesh(std::move(scene), ground(), matte("ground", {0.35f, 0.25f, 0.18f}));
    scene = add_mesh(std::move(scene), stripes(0), matte("light grass", {0.22f, 0.45f, 0.12f}));
    scene = add_mesh(std::move(scene), stripes(1), matte("dark grass", {0.15f, 0.34f, 0.09f}));
    scene = add_mesh(std::move(scene), stands(0), matte("concrete", glm::vec3(0.55f)));
    scene = add_mesh(std::move(scene), stands(1), matte("seats", {0.18f, 0.28f, 0.55f}));
    scene = add_mesh(std::move(scene), small_knot(size), matte("trophy", {0.80f, 0.55f, 0.15f}));
    scene.lights = {{{-60.0f, 90.0f, 70.0f}, {0.85f, 0.82f, 0.76f}},
                    {{80.0f, 70.0f, 60.0f}, {0.28f, 0.30f, 0.35f}}};
    scene.camera = {{0.25f, 0.42f, 0.95f}, {0.0f, 0.27f, 0.0f}, {0.0f, 1.0f, 0.0f}, 50.0f};
    scene.background = {0.25f, 0.38f, 0.60f};
    return scene;
}

namespace {

struct Ball {
    glm::dvec3 center{0.0};
    double radius = 1.0;
    glm::dvec3 outward{0.0, 1.0, 0.0}; // away from the ball that it sits on
};

// Six balls around the equator and three above, each a third as large.
std::vector<Ball> balls_on(const Ball& ball) {
    const glm::dvec3 y = ball.outward;
    const glm::dvec3 least_along_y =
        std::abs(y.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 z = glm::normalize(glm::cross(least_along_y, y));
    const glm::dvec3 x = glm::cross(y, z);
    const auto around = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180.0;
        return std::cos(angle) * x + std::sin(angle) * z;
    };
    std::vector<glm::dvec3> directions;
    directions.reserve(9);
    for (int i = 0; i < 6; ++i) {
        directions.push_back(around(60.0 * i));
    }
    for (int i = 0; i < 3; ++i) {
        directions.push_back(std::sqrt(1.0 / 3.0) * around(30.0 + 120.0 * i) +
                             std::sqrt(2.0 / 3.0) * y);
    }
    const double radius = ball.radius / 3.0;
    std::vector<Ball> balls;
    balls.reserve(directions.size());
    for (const glm::dvec3& direction : directions) {
        balls.push_back({ball.center + (ball.radius + radius) * direction, radius, direction});
    }
    return balls;
}

Mesh mesh_of(const std::vector<Ball>& balls, int divisions) {
    Mesh mesh;
    for (const Ball& ball : balls) {
        mesh = join(std::move(mesh),
                    sphere(glm::vec3(ball.center), static_cast<float>(ball.radius), divisions));
    }
    return mesh;
}

Material material_of(int level) {
    const std::vector<glm::vec3> colors = {{0.60f, 0.30f, 0.10f}, {0.65f, 0.45f, 0.10f},
                                           {0.45f, 0.50f, 0.15f}, {0.15f, 0.45f, 0.45f},
                                           {0.15f, 0.25f, 0.55f}, {0.45f, 0.20f, 0.50f}};
    return mirror_material("level " + std::to_string(level), colors[level], glm::vec3(0.25f));
}

int divisions_of(int level) {
    if (level == 0) {
        return 8;
    }
    return level == 1 ? 4 : 2;
}

Mesh floor_square() {
    const float size = 14.0f;
    const float height = -1.05f; // just under the lowest ball, so that nothing touches
    return quad({-size, height, size}, {size, height, size}, {size, height, -size},
                {-size, height, -size});
}

} // namespace

Scene sample_sphereflake(int depth) {
    Scene scene;
    std::vector<Ball> balls = {Ball{}};
    for (int level = 0; level <= depth; ++level) {
        scene = add_mesh(std::move(scene), mesh_of(balls, divisions_of(level)), material_of(level));
        std::vector<Ball> smaller;
        for (const Ball& ball : balls) {
            const std::vector<Ball> on_it = balls_on(ball);
            smaller.insert(smaller.end(), on_it.begin(), on_it.end());
        }
        balls = std::move(smaller);
    }
    scene = add_mesh(std::move(scene), floor_square(), matte("floor", glm::vec3(0.55f)));
    scene.lights = {{{-5.0f, 9.0f, 6.0f}, {0.85f, 0.82f, 0.76f}},
                    {{8.0f, 5.0f, 4.0f}, {0.25f, 0.28f, 0.34f}}};
    scene.camera = {{2.6f, 2.6f, 5.0f}, {0.0f, 0.05f, 0.0f}, {0.0f, 1.0f, 0.0f}, 38.0f};
    scene.background = {0.10f, 0.14f, 0.22f};
    return scene;
}

namespace {

constexpr float shortest = 0.5f;
constexpr float longest = 1.0f;
constexpr float thickest = 0.02f; // in lengths of the needle
constexpr float thinnest = 0.0002f;

// Of length 1. Points outside the ball, which would favour the cube's corners, are drawn again, as
// are those next to its centre, whose direction is rounded.
glm::vec3 random_direction(RandomNumbers& random) {
    for (;;) {
        const glm::vec3 point = random.in_cube();
        const float squared = glm::dot(point, point);
        if (squared <= 1.0f && squared > 0.01f) {
            return glm::normalize(point);
        }
    }
}

Mesh random_needle(RandomNumbers& random) {
    const glm::vec3 center = 0.5f * random.in_cube();
    const glm::vec3 direction = random_direction(random);
    const float length = shortest + (longest - shortest) * random.unit();
    const float share = random.unit();
    const float width = length * (thinnest + (thickest - thinnest) * share * share * share);
    for (;;) {
        const glm::vec3 across = glm::cross(direction, random_direction(random));
        if (glm::dot(across, across) > 0.01f) {
            const glm::vec3 half_width = 0.5f * width * glm::normalize(across);
            const glm::vec3 half_length = 0.5f * length * direction;
            return triangle(center - half_length - half_width, center - half_length + half_width,
                            center + half_length);
        }
    }
}

} // namespace

Scene sample_needles(int count, int seed) {
    RandomNumbers random(seed);
    std::array<Mesh, 2> meshes;
    for (int i = 0; i < count; ++i) {
        Mesh& mesh = meshes[random.below(2)];
        mesh = join(std::move(mesh), random_needle(random));
    }
    Scene scene = add_mesh({}, meshes[0], matte("pine", {0.15f, 0.45f, 0.20f}));
    return add_mesh(std::move(scene), meshes[1], matte("straw", {0.75f, 0.65f, 0.30f}));
}

namespace {

// Falls with the cube root of the count, found in whole numbers: std::cbrt may differ between
// machines.
float triangle_size(int count) {
    long long side = 1;
    while (side * side * side < count) {
        ++side;
    }
    return std::min(0.75f, 1.5f / static_cast<float>(side));
}

// A triangle without an area is thrown away and drawn again.
Mesh random_triangle(RandomNumbers& random, float size) {
    for (;;) {
        const glm::vec3 center = random.in_cube() * (1.0f - size);
        const glm::vec3 a = center + size * random.in_cube();
        const glm::vec3 b = center + size * random.in_cube();
        const glm::vec3 c = center + size * random.in_cube();
        if (glm::length(glm::cross(b - a, c - a)) > 0.0f) {
            return triangle(a, b, c);
        }
    }
}

} // namespace

Scene sample_soup(int count, int seed) {
    RandomNumbers random(seed);
    const float size = triangle_size(count);
    std::array<Mesh, 4> meshes;
    for (int i = 0; i < count; ++i) {
        Mesh& mesh = meshes[random.below(4)];
        mesh = join(std::move(mesh), random_triangle(random, size));
    }
    Scene scene;
    scene = add_mesh(std::move(scene), meshes[0], matte("carrot", {0.75f, 0.30f, 0.08f}));
    scene = add_mesh(std::move(scene), meshes[1], matte("leek", {0.35f, 0.55f, 0.15f}));
    scene = add_mesh(std::move(scene), meshes[2], matte("potato", {0.70f, 0.60f, 0.35f}));
    return add_mesh(std::move(scene), meshes[3], matte("beetroot", {0.45f, 0.08f, 0.20f}));
}

namespace {

constexpr int mountain_seed = 7;
constexpr float tree_line = 0.16f;
constexpr float snow_line = 0.46f;

// 0 for grass, 1 for rock, 2 for snow.
std::size_t ground_at(const Mesh& slope) {
    const float highest = std::max({slope.corners[0].y, slope.corners[1].y, slope.corners[2].y});
    if (highest < tree_line) {
        return 0;
    }
    return highest < snow_line ? 1 : 2;
}

std::array<Mesh, 3> mountain(const HeightField& field) {
    const auto point = [&](int column, int row) {
        const float cells = static_cast<float>(field.cells);
        return glm::vec3(2.0f * static_cast<float>(column) / cells - 1.0f,
                         height_at(field, column, row),
                         2.0f * static_cast<float>(row) / cells - 1.0f);
    };
    std::array<Mesh, 3> grounds;
    for (int row = 0; row < field.cells; ++row) {
        for (int column = 0; column < field.cells; ++column) {
            const glm::vec3 a = point(column, row);
            const glm::vec3 b = point(column, row + 1);
            const glm::vec3 c = point(column + 1, row + 1);
            const glm::vec3 d = point(column + 1, row);
            for (const Mesh& slope : {triangle(a, b, c), triangle(a, c, d)}) {
                Mesh& ground = grounds[ground_at(slope)];
                ground = join(std::move(ground), slope);
            }
        }
    }
    return grounds;
}

Mesh four_balls() {
    const float radius = 0.12f;
    const std::vector<glm::vec3> centers = {{-0.52f, 0.62f, 0.20f},
                                            {-0.22f, 0.34f, 0.74f},
                                            {0.34f, 0.42f, 0.62f},
                                            {0.50f, 0.80f, -0.05f}};
    Mesh mesh;
    for (const glm::vec3& center : centers) {
        mesh = join(std::move(mesh), sphere(center, radius, 8));
    }
    return mesh;
}

} // namespace

Scene sample_mount(int depth) {
    const std::array<Mesh, 3> grounds = mountain(random_mountain(depth, mountain_seed));
    Scene scene;
    scene = add_mesh(std::move(scene), grounds[0], matte("grass", {0.22f, 0.36f, 0.12f}));
    scene = add_mesh(std::move(scene), grounds[1], matte("rock", {0.38f, 0.32f, 0.27f}));
    scene = add_mesh(std::move(scene), grounds[2], matte("snow", {0.88f, 0.90f, 0.93f}));
    scene = add_mesh(std::move(scene), four_balls(),
                     mirror_material("mirror", glm::vec3(0.05f), glm::vec3(0.85f)));
    scene.lights = {{{-6.0f, 5.0f, 3.0f}, {0.95f, 0.85f, 0.70f}},
                    {{5.0f, 6.0f, 5.0f}, {0.22f, 0.26f, 0.34f}}};
    scene.camera = {{0.55f, 0.95f, 2.6f}, {0.0f, 0.42f, 0.0f}, {0.0f, 1.0f, 0.0f}, 36.0f};
    scene.background = {0.25f, 0.38f, 0.60f};
    return scene;
}

} // namespace raysteps
