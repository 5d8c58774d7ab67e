#include "render_effects.h"

#include "render/effects/effects_renderer.h"
#include "trace/live_trace.h"
#include "trace/trace_picture.h"

#include <iostream>
#include <memory>
#include <tuple>

namespace raysteps {

namespace {

// The renderer of the plan for a camera; a new one where another view calls for other effects.
class RendererOfView {
public:
    RendererOfView(const PictureOptions& picture, const TraceOptions& tracing,
                   const EffectOptions& options, Scene scene)
        : tracing_(tracing), options_(options), scene_(std::move(scene)),
          reach_(camera_reach(picture, scene_)),
          parts_(trace_parts(tracing.triangle, tracing.structure)), limits_(measure_limits()) {
        make(scene_.camera, static_cast<double>(picture.size.width) / picture.size.height);
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
            structure_ = build_structure(tracing_.structure, scene_.corners,
                                         {.reach = reach_, .values = tracing_.build_values});
        }
        renderer_.emplace(scene_, upload(scene_, *structure_), plan_, parts_, limits_);
        renderer_->report_progress(show_progress("rendering"));
        for (const std::string& message : renderer_->messages()) {
            std::cerr << message << "\n";
        }
    }

    const TraceOptions& tracing_;
    const EffectOptions& options_;
    Scene scene_;
    float reach_;
    Parts parts_;
    Limits limits_;
    Plan plan_;
    std::optional<BuiltStructure> structure_;
    std::optional<EffectsRenderer> renderer_;
};

// The effects and their reasons, a line each.
std::vector<std::string> called_for(const Plan& plan) {
    std::vector<std::string> lines;
    for (const EffectCall& call : plan.called) {
        lines.push_back(std::string(row_of(call.effect).name) + ": " + call.reason);
    }
    return lines;
}

Numbers numbers_of(const TraceOptions& tracing, const RendererOfView& view, double seconds) {
    Numbers numbers{{"structure", tracing.structure},
                    {"triangle", tracing.triangle},
                    {"seconds", seconds},
                    {"called_for", empty_object()},
                    {"passes", empty_list()},
                    {"rays_by_kind", empty_object()}};
    for (const EffectCall& call : view.plan().called) {
        numbers["called_for"][std::string(row_of(call.effect).name)] = call.reason;
    }
    for (const PlannedPass& pass : view.plan().passes) {
        numbers["passes"].push_back(pass.name);
    }
    for (const auto& [kind, count] : kinds_of(view.renderer().tally())) {
        numbers["rays_by_kind"][kind] = count;
    }
    return numbers;
}

} // namespace

void add_effect_options(Options& options, EffectOptions& effects) {
    options.text("--effects", effects.effects,
                 "force effects on or off, for example +refraction,-shadows; +all is every effect");
    options.number("--max-bounces", effects.quality.max_bounces,
                   "mirrors and glass surfaces that a path is followed through", 0, 1000);
    options.number("--faintest", effects.quality.faintest,
                   "paths that contribute at most this part of their pixel are dropped", 0.0f,
                   1.0f);
    options.number("--samples", effects.samples,
                   "rays per pixel, 1 to 4096; 0 means what the scene says", 0, 4096);
    options.flag("--explain", effects.explain,
                 "print the effects with their reasons, the passes, rays by kind and memory");
}

Scene with_samples(Scene scene, const EffectOptions& options) {
    if (options.samples > 0) {
        scene.camera.samples = options.samples;
    }
    return scene;
}

void render_effects(const PictureOptions& picture, const TraceOptions& tracing,
                    const EffectOptions& options, Context& context, const Scene& scene) {
    TraceOptions walk = tracing; // a window may change these
    EffectOptions effects = options;
    int samples = scene.camera.samples;
    std::unique_ptr<RendererOfView> view;
    const auto make = [&] {
        view = std::make_unique<RendererOfView>(picture, walk, effects, scene);
    };
    make();
    if (options.explain) {
        std::cout << explain(view->plan()) << std::flush;
    }
    double seconds = 0.0;
    LiveOffer live = live_trace(picture, scene, walk, make);
    live.choices.push_back(number_choice("mirrors and glass", 'm', {0, 1, 2, 4, 8, 16},
                                         effects.quality.max_bounces, make));
    live.choices.push_back(number_choice("rays a pixel", 'n', {1, 4, 16, 64}, samples, [] {}));
    live.notes = [&] { return called_for(view->plan()); };
    show_or_write(
        picture, context, scene.camera, picture_name(picture.scene),
        [&](Camera camera, int width, int height) {
            camera.samples = samples;
            Image image;
            std::tie(image, seconds) = timed([&] { return view->render(camera, width, height); });
            return image;
        },
        live);
    if (options.explain) {
        std::cout << explain(view->renderer());
    }
    std::printf("rays      %ld in %.2f s\n", all_rays(view->renderer().tally()), seconds);
    if (!picture.json.empty()) {
        write_figures(picture.json, head_of("effects.schema.json", walk, scene),
                      numbers_of(walk, *view, seconds));
    }
}

} // namespace raysteps
