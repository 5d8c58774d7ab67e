// Chapter 01: primary rays, interpolated by the rasterizer and computed by each pixel.
#include "compare_generations.h"
#include "program/show.h"
#include "render/rays.h"
#include "render/show_hits.h"

using namespace raysteps;

int main(int argc, char** argv) {
    Options options("01_rays",
                    "Chapter 01: primary rays, interpolated and direct, and how exact they are.");
    PictureOptions picture{.scene = "mirrors"};
    RayGeneration generation = RayGeneration::interpolated;
    add_picture_options(options, picture);
    options.choice<RayGeneration>(
        "--generation", generation, "how the picture's rays are made",
        {{"interpolated", RayGeneration::interpolated}, {"direct", RayGeneration::direct}});
    return options.run(argc, argv, [&] {
        const Scene scene = load_scene(picture);
        const auto context = open_context(picture);
        show_or_write(picture, *context, scene.camera, "directions",
                      [&](const Camera& camera, int width, int height) {
                          return show_directions(generate_rays(camera, width, height, generation));
                      });
        if (!picture.window) {
            compare_generations(scene, picture.size, picture.out, picture.json);
        }
    });
}
