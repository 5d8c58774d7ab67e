#include "hard_cases/meshes.h"
#include "mirror/walks.h"
#include "mirror/whitted.h"
#include "render/whitted_renderer.h"
#include "scene/shapes.h"
#include "scene/view.h"
#include "trials.h"

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

using Mirror = mirror::walks::every_triangle<float>;

Material white_mirror(float glow) {
    Material material;
    material.diffuse = glm::vec3(0.0f);
    material.specular = glm::vec3(1.0f);
    material.emission = glm::vec3(glow);
    material.illumination_model = 3;
    return material;
}

// Two mirrors that glow and face each other, the camera between them: each bounce adds as much as
// the one before.
Scene facing_mirrors() {
    const auto wall = [](float z) {
        return quad({-100, -100, z}, {100, -100, z}, {100, 100, z}, {-100, 100, z});
    };
    Scene scene = add_mesh(add_mesh(Scene{}, wall(0.0f), white_mirror(0.125f)), wall(8.0f),
                           white_mirror(0.125f));
    scene.camera.eye = {0.0f, 0.0f, 4.0f};
    return scene;
}

// A mirror that loses nothing, before a white sky: it must vanish.
Scene white_furnace() {
    Scene scene = add_mesh(Scene{}, sphere(glm::vec3(0.0f), 1.0f, 8), white_mirror(0.0f));
    scene.background = glm::vec3(1.0f);
    scene.camera.eye = {0.0f, 0.0f, 4.0f};
    return scene;
}

std::vector<glm::vec3> picture(const Scene& scene, int side, int bounces, GpuMethods* gpu) {
    if (gpu != nullptr) {
        WhittedRenderer renderer(scene, upload(scene), {{"triangle", "triangle/watertight.glsl"}},
                                 gpu->limits());
        return renderer.render(scene.camera, side, side, bounces).pixels;
    }
    const mirror::SceneBuffers buffers(scene);
    Mirror mirror = mirror::mirror_of<Mirror>(buffers);
    return mirror::render_whitted_by_mirror(mirror, scene, view_of(scene.camera, 1.0), side, side,
                                            bounces)
        .pixels;
}

// The rows of C++ and of the GPU, as far as they take part.
template <class Row>
std::vector<TrialRow> by_both(const TrialTools& tools, const Row& row) {
    std::vector<TrialRow> rows;
    if (tools.by_mirror) {
        rows.push_back(row(nullptr, "C++"));
    }
    if (tools.gpu != nullptr) {
        rows.push_back(row(tools.gpu, "GPU"));
    }
    return rows;
}

std::vector<TrialRow> between_mirrors(const TrialTools& tools) {
    const Scene scene = facing_mirrors();
    return by_both(tools, [&](GpuMethods* gpu, const char* where) {
        std::size_t wrong = 0;
        for (const int depth : {0, 1, 64, 1000}) {
            const glm::vec3 expected(0.125f * static_cast<float>(depth + 1));
            wrong += picture(scene, 1, depth, gpu).front() == expected ? 0 : 1;
        }
        return promised_row("mirrors", where, "depth + 1 times the glow", wrong, 4);
    });
}

std::vector<TrialRow> furnace(const TrialTools& tools) {
    const Scene scene = white_furnace();
    return by_both(tools, [&](GpuMethods* gpu, const char* where) {
        const std::vector<glm::vec3> pixels = picture(scene, 32, 2, gpu);
        const auto wrong = std::count_if(pixels.begin(), pixels.end(), [](const glm::vec3& color) {
            return !(std::abs(color.x - 1.0f) <= 1e-5f && std::abs(color.y - 1.0f) <= 1e-5f &&
                     std::abs(color.z - 1.0f) <= 1e-5f);
        });
        return promised_row("mirrors", where, "each pixel is white",
                            static_cast<std::size_t>(wrong), pixels.size());
    });
}

} // namespace

std::vector<Trial> effect_checks() {
    return {
        {"E3", "two facing mirrors, followed 0, 1, 64 and 1000 times", "", "a limit of depth",
         between_mirrors},
        {"E4", "a perfect mirror before a white sky neither adds nor loses light", "", "", furnace},
    };
}

} // namespace raysteps
