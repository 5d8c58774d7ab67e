#include "trade_offs.h"

#include "judges.h"
#include "render/rays.h"
#include "render/show_hits.h"
#include "render/trace_rays.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "scene/view.h"
#include "scene_needs.h"
#include "structure/padding.h"

#include <algorithm>

namespace raysteps {

namespace {

const std::string in_double = "exhibit/double_precision.glsl";

Parts with_test(const std::string& name) {
    return {{"triangle", find_part("triangle", name)}};
}

Parts with_test_in_double(const std::string& name) {
    return {{"triangle", find_part("triangle", name)}, {"real", in_double}};
}

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
    const float reach = reach_of(origins_of(scene.camera), scene.corners);
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

void add_stage(TradeOffTrials& trade_off, const std::string& family,
               const std::shared_ptr<const Stage>& stage, const Effort& effort) {
    for (const TriangleMethod& method : triangle_methods()) {
        const auto trace =
            std::make_shared<TraceRays>(tracer(*stage->subject, method.parts, effort));
        const Image picture = show_with(*stage, *trace);
        if (judge_picture(picture, stage->truth).faults.front().count > 0) {
            trade_off.pictures.push_back({family + ": " + method.name, picture});
            trade_off.pictures.push_back({family + ": " + method.name + ", wrong pixels",
                                          mark_differences(picture, stage->truth)});
        }
        trade_off.trials.push_back(
            {.method = method.name,
             .family = family,
             .timed_cases = stage->truth.pixels.size(),
             .run = [=] { trace->closest_hits(stage->rays, *stage->subject->textures); },
             .examine = [=] { return judge_picture(show_with(*stage, *trace), stage->truth); }});
    }
}

} // namespace

const std::vector<TriangleMethod>& triangle_methods() {
    static const std::vector<TriangleMethod> all{
        {"paper, culling", with_test("paper_culling")},
        {"paper, 1e-6", with_test("paper_two_sided")},
        {"paper, repaired", with_test("paper_repaired")},
        {"Moeller-Trumbore", with_test("moeller_trumbore")},
        {"Moeller-Trumbore, double", with_test_in_double("moeller_trumbore")},
        {"Pluecker", with_test("pluecker")},
        {"Baldwin-Weber", {{"triangle", "exhibit/precomputed_triangle.glsl"}}},
        {"watertight, rounded", with_test("watertight_rounded")},
        {"watertight, fallback", with_test("watertight_fallback")},
        {"watertight, exact areas", with_test("watertight")},
        {"watertight, double", with_test_in_double("watertight_rounded")}};
    return all;
}

TradeOffTrials triangle_trade_off(const std::string& name,
                                  const std::shared_ptr<const Subject>& subject,
                                  const Effort& effort) {
    std::vector<TraceMethod> methods;
    for (const TriangleMethod& method : triangle_methods()) {
        Parts parts = method.parts;
        parts["structure"] = subject->structure;
        methods.push_back({method.name, std::move(parts), subject->textures});
    }
    const std::span<const glm::vec3> corners = subject->scene.corners;
    const auto families =
        with_truth(families_from_inside(corners, effort.judged_rays, effort.seed), corners, effort);
    TradeOffTrials trade_off;
    trade_off.name = name;
    trade_off.question = "Where does a ray meet a triangle? On " + subject->scene.name + ".";
    trade_off.source =
        "Published, not measured here: watertight at \"the same performance as simpler "
        "algorithms that are not watertight\" (Woop, Benthin and Wald, Watertight "
        "Ray/Triangle Intersection, 2013); Plücker's volumes are tight along edges and "
        "not at corners (the same).";
    trade_off.unit_of_cases = "ray";
    trade_off.unit_of_error = "t, in ulp";
    trade_off.on_closed_mesh = find_needs(subject->scene).open_edges == 0;
    trade_off.trials = trace_trials(methods, families, corners, effort);
    for (MethodTrial& trial : trade_off.trials) { // the corners live in the subject
        trial.examine = [examine = std::move(trial.examine), subject] { return examine(); };
    }
    return trade_off;
}

TradeOffTrials hit_picture_trade_off(const std::shared_ptr<const Subject>& subject,
                                     const Effort& effort) {
    TradeOffTrials trade_off;
    trade_off.name = "triangle, as a picture";
    trade_off.question = "What does a picture show of wrong hits? Its own triangles as colours, " +
                         subject->scene.name + ".";
    trade_off.unit_of_cases = "pixel";
    trade_off.unit_of_error = "a pixel, in steps of sRGB";
    trade_off.kind = TradeOffKind::illustration;
    const auto stage = make_stage(subject, effort);
    trade_off.pictures.push_back({"truth: watertight, exact areas", stage->truth});
    add_stage(trade_off, "as it is", stage, effort);
    add_stage(trade_off, "128 times smaller", make_stage(made_smaller(*subject), effort), effort);
    return trade_off;
}

TradeOffTrials precision_trade_off(const Effort& effort) {
    const auto scene = std::make_shared<const Scene>(
        add_mesh({}, sphere({0.3f, -0.2f, 0.1f}, 1.0f, 8), Material{}));
    std::vector<RayFamily> families;
    float reach = 0.0f;
    for (RayFamily& family :
         families_from_inside(scene->corners, effort.judged_rays, effort.seed)) {
        if (family.name != "leaving" && family.name != "axis" && family.name != "inside") {
            reach = std::max(reach, reach_of(family.rays, scene->corners));
            families.push_back(std::move(family));
        }
    }
    const auto textures = build_textures(*scene, "fastest", reach, {});
    const std::string walk = find_part("structure", single_walk("fastest"));
    const std::string exact = "triangle/watertight.glsl";
    const std::string rounded = "triangle/watertight_rounded.glsl";
    const std::vector<TraceMethod> methods{
        {"float", {{"structure", walk}, {"triangle", rounded}}, textures},
        {"float, exact areas", {{"structure", walk}, {"triangle", exact}}, textures},
        {"double", {{"structure", walk}, {"triangle", rounded}, {"real", in_double}}, textures}};
    TradeOffTrials trade_off;
    trade_off.name = "precision";
    trade_off.question =
        "What does a kernel in double precision bring? A walk through a BVH of 1,280 "
        "triangles.";
    trade_off.unit_of_cases = "ray";
    trade_off.unit_of_error = "t, in ulp";
    for (MethodTrial& trial :
         trace_trials(methods, with_truth(std::move(families), scene->corners, effort),
                      scene->corners, effort)) {
        trial.examine = [examine = std::move(trial.examine), scene] { return examine(); };
        trade_off.trials.push_back(std::move(trial));
    }
    return trade_off;
}

} // namespace raysteps
