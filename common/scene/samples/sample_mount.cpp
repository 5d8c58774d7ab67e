#include "scene/sample_mount.h"

#include "scene/height_field.h"
#include "scene/mesh.h"
#include "scene/sample_materials.h"
#include "scene/shapes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace raysteps {

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
                     mirror("mirror", glm::vec3(0.05f), glm::vec3(0.85f)));
    scene.lights = {{{-6.0f, 5.0f, 3.0f}, {0.95f, 0.85f, 0.70f}},
                    {{5.0f, 6.0f, 5.0f}, {0.22f, 0.26f, 0.34f}}};
    scene.camera = {{0.55f, 0.95f, 2.6f}, {0.0f, 0.42f, 0.0f}, {0.0f, 1.0f, 0.0f}, 36.0f};
    scene.background = {0.25f, 0.38f, 0.60f};
    return scene;
}

} // namespace raysteps
