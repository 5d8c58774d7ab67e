#include "scene/sample_sphereflake.h"

#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace raysteps {

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
    return mirror("level " + std::to_string(level), colors[static_cast<std::size_t>(level)],
                  glm::vec3(0.25f));
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

} // namespace raysteps
