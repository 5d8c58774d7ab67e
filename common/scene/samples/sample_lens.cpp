#include "scene/sample_lens.h"

#include "scene/mapping.h"
#include "scene/mesh.h"
#include "scene/sample_surfaces.h"
#include "scene/shapes.h"

#include <string>
#include <utility>

namespace raysteps {

Scene sample_lens() {
    Scene scene;
    scene = add_mesh(std::move(scene), quad({-20, 0, 8}, {20, 0, 8}, {20, 0, -30}, {-20, 0, -30}),
                     painted("floor", "made:checker"));
    scene = map_flat(std::move(scene), 0, 6.0f);
    constexpr int sharp = 2;
    for (int i = 0; i < 7; ++i) {
        const auto place = static_cast<float>(i);
        const glm::vec3 color =
            i == sharp ? glm::vec3(0.70f, 0.10f, 0.08f) : glm::vec3(0.20f, 0.38f, 0.55f);
        scene = add_mesh(std::move(scene),
                         sphere({-2.1f + 0.9f * place, 0.61f, 3.0f - 2.0f * place}, 0.6f, 10),
                         glossy("ball " + std::to_string(i + 1), color, 0.5f, 80.0f));
    }
    scene.lights = {{{-5.0f, 8.0f, 6.0f}, {0.88f, 0.84f, 0.78f}},
                    {{6.0f, 4.0f, 8.0f}, {0.20f, 0.22f, 0.26f}}};
    scene.camera = {{0.0f, 1.7f, 8.0f}, {0.0f, 0.7f, -1.0f}, {0.0f, 1.0f, 0.0f}, 34.0f};
    scene.camera.aperture = 0.45f;
    scene.camera.focus_distance = 9.0f; // the red ball is 9 before the eye
    scene.camera.samples = 32;
    scene.sky = Sky{{0.16f, 0.28f, 0.55f}, {0.66f, 0.72f, 0.78f}, {0.30f, 0.28f, 0.25f}};
    return scene;
}

} // namespace raysteps
