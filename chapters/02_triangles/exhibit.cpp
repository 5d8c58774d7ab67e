#include "exhibit.h"

#include "basics/error.h"
#include "gpu/shaders.h"
#include "image/image.h"
#include "program/figures.h"
#include "reference/brute_force.h"
#include "render/rays.h"
#include "render/show_hits.h"
#include "render/trace_rays.h"
#include "scene/mesh.h"
#include "scene/shapes.h"

#include <fmt/core.h>

#include <iostream>

namespace raysteps {

namespace {

// Small pictures, so that a row of them can be seen at once.
constexpr int side = 256;

struct Exhibit {
    std::string triangle;
    std::string caption;
};

const std::vector<Exhibit> exhibits{
    {"paper_wrong_depth", "slip 3"},    {"paper_repaired", "slip 5"},
    {"paper_culling", "slip 6"},        {"paper_two_sided", "slip 7"},
    {"moeller_trumbore", "no epsilon"}, {"watertight", "shared edges"},
};

Scene scaled(Scene scene, float factor) {
    for (glm::vec3& corner : scene.corners) {
        corner *= factor;
    }
    scene.camera.eye *= factor;
    scene.camera.target *= factor;
    return scene;
}

// The part of the pixels, in percent, where the triangle is not the reference's, in double.
double percent_wrong(std::span<const Hit> hits, std::span<const ReferenceHit> expected) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        wrong += hits[i].triangle == expected[i].triangle ? 0 : 1;
    }
    return 100.0 * static_cast<double>(wrong) / static_cast<double>(expected.size());
}

struct Row {
    Image picture;
    Numbers::List numbers; // one for each test
};

// One row of the exhibit: the scene, traced by each test.
Row show_row(const Scene& scene, const Limits& limits, const std::string& size) {
    Numbers::List numbers;
    const SceneTextures textures = upload(scene);
    const RayTextures rays = generate_rays(scene.camera, side, side, RayGeneration::direct);
    const std::vector<ReferenceHit> expected = nearest_hits(read_rays(rays), scene.corners);
    std::vector<Image> images;
    std::vector<std::string> captions;
    for (const Exhibit& exhibit : exhibits) {
        TraceRays trace({{"triangle", find_part("triangle", exhibit.triangle)}}, limits);
        trace.report_progress(show_progress(exhibit.triangle));
        const Texture hits = trace.closest_hits(rays, textures);
        const double wrong = percent_wrong(read_hits(hits), expected);
        images.push_back(
            show_hits(rays, hits, textures, scene.camera, scene.background, "view/normals.glsl"));
        captions.push_back(fmt::format("{} ({}), {}: {:.3g} % of pixels wrong", exhibit.triangle,
                                       exhibit.caption, size, wrong));
        std::cout << captions.back() << "\n" << std::flush;
        numbers.push_back(
            {{"triangle", exhibit.triangle}, {"size", size}, {"percent_wrong", wrong}});
    }
    return {side_by_side(images, captions), numbers};
}

// The scene's camera in the middle of a ball: every ray must hit the inside of it.
Scene inside_a_ball(const Scene& scene) {
    Scene inside;
    inside.camera = scene.camera;
    inside.background = scene.background;
    return add_mesh(inside, sphere(scene.camera.eye, 2.0f, 8), Material{});
}

std::string refusal_of_compiler() {
    try {
        TraceRays({{"triangle", "exhibit/paper_as_printed.glsl"}}, 1);
    } catch (const Error& error) {
        return error.what();
    }
    return "the compiler of this machine takes it";
}

} // namespace

void show_exhibit(const Scene& scene, const std::filesystem::path& out,
                  const std::filesystem::path& json) {
    const Limits limits = measure_limits();
    std::cout << "as printed: " << refusal_of_compiler();
    const Row own_size = show_row(scene, limits, "own size");
    const Row small = show_row(scaled(scene, 0.001f), limits, "a thousandth");
    const Row inside = show_row(inside_a_ball(scene), limits, "inside a ball");
    write_picture(out / "exhibit.png",
                  stack(stack(own_size.picture, small.picture), inside.picture));
    Numbers rows = empty_list();
    for (const Row& row : {own_size, small, inside}) {
        for (const Numbers& numbers : row.numbers) {
            rows.push_back(numbers);
        }
    }
    write_figures(json, {.schema = "exhibit.schema.json", .scenes = {record_of(scene)}},
                  {{"rows", rows}});
}

} // namespace raysteps
