#include "stage.h"

#include "basics/error.h"
#include "hard_cases/hard_cases.h"
#include "basics/text.h"
#include "scene/load_scene.h"
#include "scene/view.h"
#include "structure/structure.h"
#include "structure/padding.h"
#include "hard_ray.h"
#include "structure_name.h"

#include <algorithm>
#include <utility>

namespace raysteps::view {

namespace {

bool same_camera(const std::optional<Camera>& a, const std::optional<Camera>& b) {
    if (!a || !b) {
        return !a && !b;
    }
    return a->eye == b->eye && a->target == b->target && a->up == b->up &&
           a->vertical_field_of_view == b->vertical_field_of_view;
}

bool same_ray(const std::optional<Ray>& a, const std::optional<Ray>& b) {
    if (!a || !b) {
        return !a && !b;
    }
    return a->origin == b->origin && a->direction == b->direction && a->t_min == b->t_min &&
           a->t_max == b->t_max;
}

float aspect_ratio(const State& state) {
    return static_cast<float>(state.picture.x) / static_cast<float>(state.picture.y);
}

std::string pixel_text(const glm::ivec2& pixel) {
    return std::to_string(pixel.x) + "," + std::to_string(pixel.y);
}

} // namespace

void Stage::load(const State& state) {
    Scene scene;
    hard_rays_.clear();
    hard_values_.clear();
    if (state.hard_case.empty()) {
        say_("loading " + state.scene);
        scene = load_scene(state.scene, aspect_ratio(state));
    } else {
        const HardCase& hard_case = find_hard_case(state.hard_case);
        say_("making " + hard_case.name);
        HardScene made = hard_case.make({});
        scene = scene_of(hard_case, made, aspect_ratio(state));
        hard_rays_ = std::move(made.rays);
        hard_values_ = std::move(made.build_values);
    }
    scene_ = std::move(scene);
    bounds_ = bounds_of(scene_.corners);
    panes_.clear();
    buffers_ = std::make_unique<mirror::SceneBuffers>(scene_);
}

void Stage::build(const State& state) {
    check_build_values(state.build_values, [&] {
        std::vector<std::string> names;
        for (const std::string& text : state.structures) {
            names.push_back(read_structure_name(text).structure);
        }
        return names;
    }());
    std::vector<std::unique_ptr<Pane>> panes;
    for (const std::string& text : state.structures) {
        const StructureName name = read_structure_name(text);
        auto pane = std::make_unique<Pane>();
        pane->label = text;
        pane->structure = name.structure;
        pane->recorder = make_recorder(name.structure, {*buffers_, pane->built.packed});
        const StructureFamily family = family_of(name.structure);
        std::map<std::string, std::string> values = values_for(name, state);
        if (const auto hard = hard_values_.find(family.name); hard != hard_values_.end()) {
            values.insert(hard->second.begin(), hard->second.end());
        }
        say_("building " + text);
        pane->built = family.build(scene_.corners, {.reach = reach_, .values = values});
        pane->cells = cells_of(pane->built.packed, costs_of(family, values));
        panes.push_back(std::move(pane));
    }
    panes_ = std::move(panes);
}

void Stage::record(const State& state) {
    for (const std::unique_ptr<Pane>& pane : panes_) {
        pane->path.clear();
        if (ray_) {
            pane->path = record_path({scene_, *buffers_, pane->recorder}, *ray_, state.bounces);
        }
    }
}

void Stage::count(const State& state) {
    if (state.heat_map == HeatMap::none) {
        return;
    }
    const View seen = view_of(camera_, static_cast<double>(aspect_ratio(state)));
    for (const std::unique_ptr<Pane>& pane : panes_) {
        if (pane->counted.empty()) {
            say_("tracing every pixel through " + pane->label);
            pane->counted =
                pane->recorder.count(pixel_rays(seen, state.picture.x, state.picture.y));
        }
    }
}

std::optional<Ray> Stage::ray_asked_for(const State& state) const {
    if (!state.pixel) {
        return state.ray;
    }
    const glm::ivec2 pixel = *state.pixel;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= state.picture.x || pixel.y >= state.picture.y) {
        throw InputError("--pixel " + pixel_text(pixel) + ": the picture has the pixels 0,0 to " +
                         pixel_text(state.picture - 1) + ". Take one of them, or another --size.");
    }
    return pixel_ray(view_of(camera_, static_cast<double>(aspect_ratio(state))), state.picture.x,
                     state.picture.y, pixel.x, pixel.y);
}

// The structures stand, so that it can be seen what a ray does in them.
std::optional<Ray> Stage::hard_ray(const State& state) {
    if (hard_rays_.empty()) {
        return std::nullopt;
    }
    if (state.hard_ray >= static_cast<int>(hard_rays_.size())) {
        throw InputError("--hard-ray " + std::to_string(state.hard_ray) + ": the case has " +
                         std::to_string(hard_rays_.size()) + " rays. Take one from 0 on.");
    }
    HardRay chosen{static_cast<std::size_t>(std::max(state.hard_ray, 0)), "as asked for"};
    if (state.hard_ray < 0) {
        chosen = choose_hard_ray(hard_rays_, *buffers_, panes_.front()->recorder);
    }
    const HardCase& hard_case = find_hard_case(state.hard_case);
    note_ = hard_case.name + ", " + hard_case.title + ". Ray " + std::to_string(chosen.number) +
            ": " + chosen.why + ".";
    return hard_rays_[chosen.number];
}

void Stage::show(const State& state) {
    if (state.structures.empty()) {
        throw InputError("--structure: no structure is named. Name one.");
    }
    // Where something goes wrong on the way, the next state is shown from the beginning.
    const std::optional<State> before = std::exchange(shown_, std::nullopt);
    const bool new_picture = !before || before->picture != state.picture;
    const bool new_scene = !before || before->scene != state.scene ||
                           before->hard_case != state.hard_case ||
                           (new_picture && aspect_ratio(*before) != aspect_ratio(state));
    if (new_scene) {
        load(state);
    }
    const bool new_camera = new_scene || !same_camera(before->camera, state.camera);
    if (new_camera) {
        camera_ = state.camera.value_or(scene_.camera);
    }
    std::optional<Ray> ray = ray_asked_for(state);
    // A structure holds for rays from within its reach; farther out, it is built anew.
    float reach = std::max(new_scene ? 0.0f : reach_, reach_of(camera_.eye, scene_.corners));
    if (ray) {
        reach = std::max(reach, reach_of(ray->origin, scene_.corners));
    } else {
        reach = std::max(reach, reach_of(hard_rays_, scene_.corners));
    }
    const bool new_structures = new_scene || reach > reach_ ||
                                before->structures != state.structures ||
                                before->build_values != state.build_values;
    reach_ = reach;
    if (new_structures) {
        build(state);
    }
    const bool same_hard_ray = before && !new_structures && !before->pixel && !before->ray &&
                               before->hard_ray == state.hard_ray;
    if (ray) {
        note_.clear();
    } else if (same_hard_ray) {
        ray = ray_; // to choose it takes long
    } else {
        note_.clear();
        ray = hard_ray(state);
    }
    const bool new_ray = !same_ray(ray, ray_) || (before && before->bounces != state.bounces);
    ray_ = ray;
    if (new_structures || new_ray) {
        record(state);
    }
    if (new_camera || new_picture) {
        for (const std::unique_ptr<Pane>& pane : panes_) {
            pane->counted.clear();
        }
    }
    shown_ = state;
    count(state);
}

const RecordedWalk* walk_in(const Pane& pane, const State& state) {
    if (pane.path.empty()) {
        return nullptr;
    }
    const int last = static_cast<int>(pane.path.size()) - 1;
    return &pane.path[static_cast<std::size_t>(std::clamp(state.path_ray, 0, last))].walk;
}

std::size_t step_in(const RecordedWalk& walk, const State& state) {
    if (walk.steps.empty()) {
        return 0;
    }
    const std::size_t last = walk.steps.size() - 1;
    return state.step < 0 ? last : std::min(static_cast<std::size_t>(state.step), last);
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
