// Chapter 09: a picture with only those effects that its scene calls for.
#include "basics/error.h"
#include "prove_effects.h"
#include "render_effects.h"
#include "trace/trace_picture.h"

using namespace raysteps;

int main(int argc, char** argv) {
    Options options("09_effects", "Chapter 09: only the effects that a scene calls for.");
    PictureOptions picture{.scene = "glass_box", .size = {384, 384}};
    TraceOptions tracing{.structure = "fastest"};
    EffectOptions effects;
    Proof proof{.scenes = {"cornell_box", "mirrors", "sphereflake:2", "glass_box", "glass_bunny",
                           "pictures", "soft_light", "lens", "room"}};
    bool prove = false;
    add_picture_options(options, picture);
    add_trace_options(options, tracing);
    add_effect_options(options, effects);
    options.flag("--prove", prove, "compare planned effects with every effect, in many scenes");
    options.excludes("--prove", {"--rays", "--window", "--scene"});
    options.list("--scenes", proof.scenes, "the scenes of --prove, between commas");
    options.number("--rounds", proof.rounds, "how often --prove measures each picture", 1, 1000);
    return options.run(argc, argv, [&] {
        if (prove) {
            const auto context = open_context(picture);
            if (!prove_effects(picture, tracing, proof, effects.quality)) {
                throw Error(ExitCode::check_failed,
                            "--prove: pictures differ that should not, or rays were cast "
                            "that nothing called for. See the table above.");
            }
            return;
        }
        picture.needs_camera = tracing.rays.empty();
        const Scene scene = with_samples(load_scene(picture), effects);
        const auto context = open_context(picture);
        if (!tracing.rays.empty()) {
            trace_ray_file(picture, tracing, scene);
            return;
        }
        render_effects(picture, tracing, effects, *context, scene);
    });
}
