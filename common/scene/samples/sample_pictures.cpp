#include "scene/sample_pictures.h"

#include "scene/mapping.h"
#include "scene/mesh.h"
#include "scene/sample_surfaces.h"
#include "scene/shapes.h"

#include <utility>

namespace raysteps {

namespace {

Scene add_flat(Scene scene, const Mesh& mesh, const Material& material, float size) {
    const int first = triangle_count(scene);
    return map_flat(add_mesh(std::move(scene), mesh, material), first, size);
}

} // namespace

Scene sample_pictures() {
    Scene scene;
    scene = add_flat(std::move(scene), quad({-8, 0, 8}, {8, 0, 8}, {8, 0, -3}, {-8, 0, -3}),
                     painted("floor", "made:wood"), 2.0f);
    scene = add_flat(std::move(scene), quad({-8, 0, -3}, {8, 0, -3}, {8, 6, -3}, {-8, 6, -3}),
                     painted("wall", "made:bricks"), 2.0f);
    scene = add_flat(std::move(scene), box({1.2f, 0.01f, -1.0f}, {2.6f, 1.41f, 0.4f}),
                     painted("box", "made:checker"), 1.4f);
    const glm::vec3 center{-0.7f, 1.26f, -0.2f};
    const int globe = triangle_count(scene);
    Material earth = painted("globe", "made:globe");
    earth.specular = glm::vec3(0.5f);
    earth.shininess = 60.0f;
    earth.illumination_model = 2;
    scene = add_mesh(std::move(scene), sphere(center, 1.25f, 14), earth);
    scene = map_around(std::move(scene), globe, center);
    scene.lights = {{{-4.5f, 6.0f, 5.0f}, {0.85f, 0.81f, 0.75f}},
                    {{5.0f, 3.5f, 5.0f}, {0.28f, 0.30f, 0.35f}}};
    scene.camera = {{1.0f, 2.5f, 7.4f}, {0.35f, 1.25f, -0.4f}, {0.0f, 1.0f, 0.0f}, 38.0f};
    scene.background = {0.10f, 0.13f, 0.19f};
    return scene;
}

} // namespace raysteps
