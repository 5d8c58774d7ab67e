// Chapter 01: primary rays, interpolated by the rasterizer and computed by each pixel.
#include "program/command.h"
#include "program/deliver.h"
#include "compare_generations.h"
#include "render/rays.h"
#include "render/show_hits.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 01: primary rays, interpolated and direct, and how exact they are.");
    Command command{.chapter = "01_rays", .scene = "mirrors"};
    std::string generation = "interpolated";
    add_common_options(app, command);
    app.add_option("--generation", generation, "of the picture's rays: interpolated or direct")
        ->capture_default_str();
    return run_command(app, command, argc, argv, [&] {
        const RayGeneration chosen = parse_generation(generation);
        const Scene scene = open_scene(command);
        const auto context = open_context(command);
        deliver(command, *context, scene.camera, "directions",
                [&](const Camera& camera, int width, int height) {
                    return show_directions(generate_rays(camera, width, height, chosen));
                });
        if (!command.window) {
            compare_generations(command, scene.camera);
        }
    });
}
