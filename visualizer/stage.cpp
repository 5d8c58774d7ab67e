#include "stage.h"

#include "basics/error.h"
#include "hard_cases/hard_cases.h"
#include "mirror/walks.h"
#include "scene/load_scene.h"
#include "scene/scaling.h"
#include "scene/view.h"
#include "structure/padding.h"
#include "visualizer/replay/sentence.h"
#include "walk_file.h"

#include <algorithm>
#include <utility>

namespace raysteps::view {

namespace {

// A case may have very many rays with very long walks: then only the first ones are tried.
constexpr std::size_t most_tests = 20'000'000;
constexpr std::size_t most_recorded = 3'000'000; // steps and tests of all walks together

std::string answer_text(int triangle) {
    return triangle == no_triangle ? "no hit" : "triangle " + std::to_string(triangle);
}

// The hit that the walk would end with if it did not check where the hit lies.
std::optional<Hit> first_hit_taken(const RecordedWalk& walk) {
    for (const Step& step : walk.steps) {
        for (const TriangleTest& test : tests_of(walk, step)) {
            if (test.best && step.cell != no_cell && step.face >= 0 && test.hit.t > step.exit) {
                return test.hit;
            }
        }
    }
    return std::nullopt;
}

// A walk that takes a hit for the answer, though the hit lies beyond the cell where it is found.
std::optional<HardRay> breaks_first_hit(std::span<const Ray> rays, const WalkRecorder& recorder) {
    std::size_t recorded = 0;
    for (std::size_t i = 0; i < rays.size() && recorded < most_recorded; ++i) {
        const RecordedWalk walk = recorder.record(rays[i], Question::nearest);
        recorded += walk.steps.size() + walk.tests.size();
        const auto taken = first_hit_taken(walk);
        if (taken && taken->triangle != walk.hit.triangle) {
            return HardRay{i,
                           "a walk that takes the first hit it finds, beyond the cell, answers " +
                               answer_text(taken->triangle) + " instead of " +
                               answer_text(walk.hit.triangle)};
        }
    }
    return std::nullopt;
}

// The triangle test by Moeller and Trumbore, where that is not too much work.
std::optional<HardRay> breaks_triangle_test(std::span<const Ray> rays,
                                            const mirror::SceneBuffers& scene,
                                            const WalkRecorder& recorder) {
    using Mirror = mirror::triangle_tests::moeller_trumbore<float>;
    auto mirror = mirror::mirror_of<Mirror>(scene);
    const std::size_t triangles = std::max<std::size_t>(scene.corners.size() / 3, 1);
    const std::size_t count = std::min(rays.size(), most_tests / triangles);
    std::size_t recorded = 0;
    for (std::size_t i = 0; i < count && recorded < most_recorded; ++i) {
        const RecordedWalk walk = recorder.record(rays[i], Question::nearest);
        recorded += walk.steps.size() + walk.tests.size();
        const int right = walk.hit.triangle;
        const int usual = mirror.closest_hit(mirror::to_mirror<Mirror>(rays[i])).triangle;
        if (right != usual) {
            return HardRay{i, "the test by Moeller and Trumbore answers " + answer_text(usual) +
                                  " instead of " + answer_text(right)};
        }
    }
    return std::nullopt;
}

// The first ray that breaks a usual method; else the first that hits anything, else the first.
HardRay choose_hard_ray(std::span<const Ray> rays, const mirror::SceneBuffers& scene,
                        const WalkRecorder& recorder) {
    if (const auto found = breaks_first_hit(rays, recorder)) {
        return *found;
    }
    if (const auto found = breaks_triangle_test(rays, scene, recorder)) {
        return *found;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (recorder.record(rays[i], Question::nearest).hit.triangle != no_triangle) {
            return {i, "one of the rays that are aimed at it"};
        }
    }
    return {0, "one of the rays that are aimed at it, and miss"};
}

bool same_camera(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up &&
           a.vertical_field_of_view == b.vertical_field_of_view;
}

bool same_ray(const std::optional<Ray>& a, const std::optional<Ray>& b) {
    if (!a || !b) {
        return !a && !b;
    }
    return a->origin == b->origin && a->direction == b->direction && a->t_min == b->t_min &&
           a->t_max == b->t_max;
}

float aspect_ratio(const glm::ivec2& picture) {
    return static_cast<float>(picture.x) / static_cast<float>(picture.y);
}

View view_of(const Camera& camera, const glm::ivec2& picture) {
    return raysteps::view_of(camera, static_cast<double>(aspect_ratio(picture)));
}

std::string pixel_text(const glm::ivec2& pixel) {
    return std::to_string(pixel.x) + "," + std::to_string(pixel.y);
}

} // namespace

bool Stage::PathSource::operator==(const PathSource& other) const {
    return same_ray(ray, other.ray) && bounces == other.bounces && steps == other.steps;
}

bool Stage::CountSource::operator==(const CountSource& other) const {
    return same_camera(camera, other.camera) && picture == other.picture;
}

void Stage::show(const State& state) {
    tell(state.steps);
    std::optional<Camera> camera = state.camera;
    if (camera) {
        camera = scaled(*camera, state.scale_exponent);
    }
    load({state.scene, state.hard_case, aspect_ratio(state.picture), state.scale_exponent,
          state.placed, state.up},
         camera);
    camera_ = camera.value_or(scene_.camera);
    const std::optional<Ray> ray = ray_of(state);
    build({state.structures, state.build_values, reach_with(ray), state.steps});
    note_.clear();
    ray_ = ray ? ray : hard_ray(state); // chosen by its walks, so the structures come first
    record({ray_, state.bounces, state.steps});
    check_sought(state);
    if (state.heat_map != HeatMap::none) {
        if (told_) {
            throw InputError("--heat-map: recorded steps are of one ray. Leave --heat-map or "
                             "--steps out.");
        }
        count({camera_, state.picture});
    }
}

void Stage::check_sought(const State& state) const {
    const std::string option = "--why " + std::to_string(state.why);
    if (state.why >= triangle_count(scene_)) {
        throw InputError(option + ": the scene has " + std::to_string(triangle_count(scene_)) +
                         " triangles, counted from 0.");
    }
    if (state.why >= 0 && !ray_) {
        throw InputError(option + ": it asks about a ray. Name one with --rays, --ray or --pixel.");
    }
}

void Stage::tell(const std::string& steps) {
    if (told_file_ == steps) {
        return;
    }
    told_ = steps.empty() ? std::nullopt : std::optional(read_told_walk(steps));
    told_file_ = steps;
}

void Stage::load(const SceneSource& source, const std::optional<Camera>& camera) {
    if (loaded_ == source) {
        return;
    }
    Scene scene;
    HardScene hard;
    if (source.hard_case.empty()) {
        say_("loading " + source.scene);
        scene = load_scene(source.scene, source.aspect_ratio,
                           {.scale_exponent = source.scale_exponent,
                            .camera = {source.placed, source.up, camera}});
        const auto holes =
            std::count_if(scene.materials.begin(), scene.materials.end(),
                          [](const Material& material) { return !material.cutout_map.empty(); });
        if (holes > 0) {
            scene.messages.push_back("Cut-outs are not shown in view: " + std::to_string(holes) +
                                     " materials.");
        }
        if (scene.origin != glm::dvec3(0.0)) {
            scene.messages.push_back("In view, --camera, --viewpoint, --ray and --clip count from "
                                     "that point.");
        }
    } else {
        const HardCase& hard_case = find_hard_case(source.hard_case);
        say_("making " + hard_case.name);
        hard = hard_case.make({});
        scene = scene_of(hard_case, hard, source.aspect_ratio);
    }
    panes_.clear(); // they read the buffers
    built_.reset();
    scene_ = std::move(scene);
    bounds_ = bounds_of(scene_.corners);
    buffers_ = std::make_unique<mirror::SceneBuffers>(scene_);
    hard_rays_ = std::move(hard.rays);
    hard_values_ = std::move(hard.build_values);
    loaded_ = source;
}

// Structures hold for rays from within their reach: when a ray starts farther out, they are built
// again, and then serve the nearer ones as well.
float Stage::reach_with(const std::optional<Ray>& ray) const {
    const float built = built_ ? built_->reach : 0.0f;
    const float rays = ray ? reach_of(Box{ray->origin, ray->origin}, scene_.corners)
                           : reach_of(hard_rays_, scene_.corners);
    return std::max({built, reach_of(origins_of(camera_), scene_.corners), rays});
}

void Stage::build(const StructureSource& source) {
    if (built_ == source) {
        return;
    }
    std::vector<std::string> structures = source.structures;
    if (told_) {
        structures.insert(structures.begin(),
                          is_walk_of_ours(*told_) ? told_->structure : "every_triangle");
    }
    panes_ = build_panes(
        structures, {scene_, *buffers_, source.reach, source.build_values, hard_values_}, say_);
    if (told_) {
        panes_.front()->label = told_->name;
        if (!is_walk_of_ours(*told_)) {
            panes_.front()->cells = told_cells(*told_);
        }
    }
    most_telling_.reset();
    recorded_.reset();
    built_ = source;
}

std::optional<Ray> Stage::ray_of(const State& state) const {
    if (told_) {
        return told_->ray;
    }
    if (!state.pixel) {
        return state.ray ? std::optional(scaled(*state.ray, state.scale_exponent)) : std::nullopt;
    }
    const glm::ivec2 pixel = *state.pixel;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= state.picture.x || pixel.y >= state.picture.y) {
        throw InputError("--pixel " + pixel_text(pixel) + ": the picture has the pixels 0,0 to " +
                         pixel_text(state.picture - 1) + ". Take one of them, or another --size.");
    }
    return pixel_ray(view_of(camera_, state.picture), state.picture.x, state.picture.y, pixel.x,
                     pixel.y);
}

std::optional<Ray> Stage::hard_ray(const State& state) {
    if (hard_rays_.empty()) {
        return std::nullopt;
    }
    if (state.hard_ray >= static_cast<int>(hard_rays_.size())) {
        throw InputError("--hard-ray " + std::to_string(state.hard_ray) + ": the case has " +
                         std::to_string(hard_rays_.size()) + " rays. Take one from 0 to " +
                         std::to_string(hard_rays_.size() - 1) + ".");
    }
    if (state.hard_ray < 0 && !most_telling_) {
        most_telling_ = choose_hard_ray(hard_rays_, *buffers_, panes_.front()->recorder);
    }
    const HardRay chosen = state.hard_ray < 0
                               ? *most_telling_
                               : HardRay{static_cast<std::size_t>(state.hard_ray), "as asked for"};
    const HardCase& hard_case = find_hard_case(state.hard_case);
    note_ = hard_case.name + ", " + hard_case.title + ". Ray " + std::to_string(chosen.number) +
            ": " + chosen.why + ".";
    return hard_rays_[chosen.number];
}

void Stage::record(const PathSource& source) {
    if (recorded_ == source) {
        return;
    }
    recorded_ = source;
    if (told_) {
        record_told();
        return;
    }
    for (const std::unique_ptr<Pane>& pane : panes_) {
        pane->path.clear();
        if (source.ray) {
            pane->path =
                record_path({scene_, *buffers_, pane->recorder}, *source.ray, source.bounces);
        }
    }
}

// The told walk, and for its ray and its question those of the other panes: no ray behind it.
void Stage::record_told() {
    for (const std::unique_ptr<Pane>& pane : panes_) {
        RecordedWalk walk;
        if (pane != panes_.front()) {
            walk = pane->recorder.record(told_->ray, told_->question);
        } else if (is_walk_of_ours(*told_)) {
            walk = pane->recorder.explain(*told_);
        } else {
            walk = walk_in_told_cells(*told_, pane->recorder.explain(*told_));
        }
        pane->path = {{RayRole::camera, 0, walk}};
    }
}

void Stage::count(const CountSource& source) {
    for (const std::unique_ptr<Pane>& pane : panes_) {
        if (!pane->refusal.empty()) {
            throw InputError("--heat-map: " + pane->refusal);
        }
        if (counted_ == source && !pane->counted.empty()) {
            continue;
        }
        say_("tracing every pixel through " + pane->label);
        pane->counted = pane->recorder.count(
            pixel_rays(view_of(source.camera, source.picture), source.picture.x, source.picture.y));
    }
    counted_ = source;
}

int step_count(const Stage& stage, const State& state) {
    std::size_t most = 0;
    for (const std::unique_ptr<Pane>& pane : stage.panes()) {
        const RecordedWalk* walk = walk_in(*pane, state);
        most = std::max(most, walk ? walk->steps.size() : 0);
    }
    return static_cast<int>(most);
}

std::optional<Parting> parting_of(const Stage& stage, const State& state) {
    if (stage.panes().size() < 2) {
        return std::nullopt;
    }
    const Pane& first = *stage.panes()[0];
    const Pane& second = *stage.panes()[1];
    const RecordedWalk* walk = walk_in(first, state);
    const RecordedWalk* other = walk_in(second, state);
    if (!walk || !other) {
        return std::nullopt;
    }
    return find_parting({first.cells, *walk}, {second.cells, *other});
}

} // namespace raysteps::view
