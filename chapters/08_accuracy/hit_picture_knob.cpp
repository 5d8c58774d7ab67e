#include "hit_picture_knob.h"

#include "judge_picture.h"
#include "triangle_knob.h"
#include "render/rays.h"
#include "render/show_hits.h"
#include "render/trace_rays.h"
#include "structure/padding.h"

namespace raysteps {

namespace {

// The camera's rays, and the picture of their true hits.
struct Stage {
    std::shared_ptr<const Subject> subject;
    RayTextures rays;
    Image truth{};
};

Image show(const Stage& stage, const Texture& hits) {
    const Scene& scene = stage.subject->scene;
    return show_hits(stage.rays, hits, *stage.subject->textures, scene.camera, scene.background,
                     "view/facets.glsl");
}

Image show_with(const Stage& stage, TraceRays& trace) {
    return show(stage, trace.closest_hits(stage.rays, *stage.subject->textures));
}

TraceRays tracer(const Subject& subject, Parts parts, const Effort& effort) {
    parts["structure"] = subject.structure;
    return {std::move(parts), effort.limits};
}

// The same, so small that a fixed number is large beside it. A power of 2 changes no digit of any
// coordinate, so whatever else is wrong stays the same.
constexpr float smaller = 0x1p-7f;

std::shared_ptr<const Subject> made_smaller(const Subject& subject) {
    Scene scene = subject.scene;
    for (glm::vec3& corner : scene.corners) {
        corner *= smaller;
    }
    scene.camera.eye *= smaller;
    scene.camera.target *= smaller;
    const float reach = reach_of(scene.camera.eye, scene.corners);
    return make_subject(std::move(scene), reach);
}

std::shared_ptr<const Stage> make_stage(std::shared_ptr<const Subject> subject,
                                        const Effort& effort) {
    const int size = effort.picture_size;
    RayTextures rays = generate_rays(subject->scene.camera, size, size, RayGeneration::direct);
    TraceRays judge = tracer(*subject, {{"triangle", "triangle/watertight.glsl"}}, effort);
    const auto stage = std::make_shared<Stage>(Stage{std::move(subject), std::move(rays)});
    stage->truth = show_with(*stage, judge);
    return stage;
}

void add_stage(Knob& knob, const std::string& family, const std::shared_ptr<const Stage>& stage,
               const Effort& effort) {
    for (const TriangleMethod& method : triangle_methods()) {
        const auto trace =
            std::make_shared<TraceRays>(tracer(*stage->subject, method.parts, effort));
        const Image picture = show_with(*stage, *trace);
        if (judge_picture(picture, stage->truth).faults.front().count > 0) {
            knob.pictures.push_back({family + ": " + method.name, picture});
            knob.pictures.push_back({family + ": " + method.name + ", wrong pixels",
                                     mark_differences(picture, stage->truth)});
        }
        knob.trials.push_back(
            {.method = method.name,
             .family = family,
             .timed_cases = stage->truth.pixels.size(),
             .run = [=] { trace->closest_hits(stage->rays, *stage->subject->textures); },
             .examine = [=] { return judge_picture(show_with(*stage, *trace), stage->truth); }});
    }
}

} // namespace

Knob hit_picture_knob(const std::shared_ptr<const Subject>& subject, const Effort& effort) {
    Knob knob;
    knob.name = "triangle, as a picture";
    knob.question = "What does a picture show of wrong hits? Its own triangles as colours, " +
                    subject->scene.name + ".";
    knob.unit_of_cases = "pixel";
    knob.unit_of_error = "a pixel, in steps of sRGB";
    knob.kind = KnobKind::illustration;
    const auto stage = make_stage(subject, effort);
    knob.pictures.push_back({"truth: watertight, exact areas", stage->truth});
    add_stage(knob, "as it is", stage, effort);
    add_stage(knob, "128 times smaller", make_stage(made_smaller(*subject), effort), effort);
    return knob;
}

} // namespace raysteps
