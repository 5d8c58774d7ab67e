#include "hard_cases/surfaces.h"

#include "hard_cases/loose_triangles.h"
#include "scene/shapes.h"

#include <glm/geometric.hpp>

namespace raysteps {

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
    const std::size_t a =
        3 * static_cast<std::size_t>(numbers.below(static_cast<int>(ball.corners.size() / 3)));
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

} // namespace raysteps
