#include "render_effects.h"

#include "program/deliver.h"
#include "program/progress.h"
#include "program/tracing_options.h"
#include "render/effects/effects_renderer.h"

#include <chrono>
#include <iostream>

namespace raysteps {

namespace {

// The renderer of the plan for a camera; a new one where another view calls for other effects.
class RendererOfView {
public:
    RendererOfView(const Command& command, const EffectOptions& options, Scene scene,
                   const Parts& parts)
        : command_(command), options_(options), scene_(std::move(scene)), parts_(parts),
          limits_(measure_limits()) {
        make(scene_.camera, static_cast<double>(command.width) / command.height);
    }

    Image render(const Camera& camera, int width, int height) {
        scene_.camera = camera;
        const double aspect_ratio = static_cast<double>(width) / height;
        const Plan now = make_plan(scene_, aspect_ratio, options_.effects, options_.quality);
        if (now.effects != plan_.effects) {
            make(camera, aspect_ratio);
        }
        return renderer_->render(camera, width, height);
    }

    const Plan& plan() const { return plan_; }
    const EffectsRenderer& renderer() const { return *renderer_; }

private:
    void make(const Camera& camera, double aspect_ratio) {
        scene_.camera = camera;
        plan_ = make_plan(scene_, aspect_ratio, options_.effects, options_.quality);
        if (!structure_) {
            structure_ = build_structure(command_, scene_);
        }
        renderer_.emplace(scene_, upload(scene_, *structure_), plan_, parts_, limits_);
        renderer_->report_progress(show_progress("rendering"));
        for (const std::string& message : renderer_->messages()) {
            std::cerr << message << "\n";
        }
    }

    const Command& command_;
    const EffectOptions& options_;
    Scene scene_;
    Parts parts_;
    Limits limits_;
    Plan plan_;
    std::optional<BuiltStructure> structure_;
    std::optional<EffectsRenderer> renderer_;
};

nlohmann::ordered_json numbers_of(const Command& command, const RendererOfView& view,
                                  double seconds) {
    nlohmann::ordered_json numbers{{"scene", command.scene},
                                   {"renderer", renderer_name()},
                                   {"structure", command.structure},
                                   {"triangle", command.triangle},
                                   {"seconds", seconds}};
    for (const EffectCall& call : view.plan().called) {
        numbers["called_for"][std::string(row_of(call.effect).name)] = call.reason;
    }
    for (const PlannedPass& pass : view.plan().passes) {
        numbers["passes"].push_back(pass.name);
    }
    for (const auto& [kind, count] : kinds_of(view.renderer().tally())) {
        numbers["rays"][kind] = count;
    }
    return numbers;
}

} // namespace

void add_effect_options(CLI::App& app, EffectOptions& options) {
    app.add_option(
        "--effects", options.effects,
        "force effects on or off, for example +refraction,-shadows; +all is every effect");
    app.add_option("--max-bounces", options.quality.max_bounces,
                   "mirrors and glass surfaces that a path is followed through, 0 to 1000")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000));
    app.add_option("--faintest", options.quality.faintest,
                   "paths that contribute at most this part of their pixel are dropped, 0 to 1")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--samples", options.samples,
                   "rays per pixel, 1 to 4096; 0 means what the scene says")
        ->check(CLI::Range(0, 4096));
    app.add_flag("--explain", options.explain,
                 "print the effects with their reasons, the passes, rays by kind and memory");
}

Scene with_samples(Scene scene, const EffectOptions& options) {
    if (options.samples > 0) {
        scene.camera.samples = options.samples;
    }
    return scene;
}

void render_effects(const Command& command, const EffectOptions& options, Context& context,
                    const Scene& scene, const Parts& parts) {
    RendererOfView view(command, options, scene, parts);
    if (options.explain) {
        std::cout << explain(view.plan()) << std::flush;
    }
    double seconds = 0.0;
    deliver(command, context, scene.camera, picture_name(command),
            [&](const Camera& camera, int width, int height) {
                const auto start = std::chrono::steady_clock::now();
                Image image = view.render(camera, width, height);
                seconds =
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                return image;
            });
    if (options.explain) {
        std::cout << explain(view.renderer());
    }
    std::printf("rays      %ld in %.2f s\n", all_rays(view.renderer().tally()), seconds);
    deliver_numbers(command, numbers_of(command, view, seconds));
}

} // namespace raysteps
