// Chapter 09: a picture with only those effects that its scene calls for.
#include "program/command.h"
#include "program/deliver.h"
#include "program/progress.h"
#include "program/timed_trace.h"
#include "program/tracing_options.h"
#include "basics/error.h"
#include "prove_effects.h"
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
    Proof proof{.scenes = {"cornell_box", "mirrors", "sphereflake:2", "glass_box", "glass_bunny",
                           "pictures", "soft_light", "lens", "room"}};
    bool prove = false;
    app.add_flag("--prove", prove, "compare planned effects with every effect, in many scenes")
        ->excludes("--rays", "--window", "--scene");
    app.add_option("--scenes", proof.scenes, "of --prove, between commas")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--rounds", proof.rounds, "of --prove: how often each picture is measured")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    return run_command(app, command, argc, argv, [&] {
        const Parts parts = trace_parts(command);
        if (prove) {
            const auto context = open_context(command);
            if (!prove_effects(command, proof, options.quality, parts)) {
                throw Error(ExitCode::check_failed,
                            "--prove: pictures differ that should not, or rays were cast "
                            "that nothing called for. See the table above.");
            }
            return;
        }
        const Scene scene = with_samples(open_scene(command), options);
        const auto context = open_context(command);
        if (!command.rays.empty()) {
            trace_ray_file(command, parts, scene);
            return;
        }
        render_effects(command, options, *context, scene, parts);
    });
}
