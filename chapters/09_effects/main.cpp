// Chapter 09: a picture with only those effects that its scene calls for.
#include "command/command.h"
#include "command/deliver.h"
#include "command/progress.h"
#include "command/timed_trace.h"
#include "command/tracing_options.h"
#include "render_effects.h"

using namespace raysteps;

int main(int argc, char** argv) {
    CLI::App app("Chapter 09: only the effects that a scene calls for.");
    Command command{.chapter = "09_effects", .scene = "glass_box", .size = "384x384"};
    command.structure = "bvh_ordered";
    EffectOptions options;
    add_common_options(app, command);
    add_tracing_options(app, command);
    add_effect_options(app, options);
    return run_command(app, command, argc, argv, [&] {
        const Parts parts = trace_parts(command);
        const Scene scene = with_samples(open_scene(command), options);
        const auto context = open_context(command);
        if (!command.rays.empty()) {
            trace_ray_file(command, parts, scene);
            return;
        }
        render_effects(command, options, *context, scene, parts);
    });
}
