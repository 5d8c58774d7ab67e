#include "render/effects/effects_renderer.h"

#include "gpu/draw.h"

namespace raysteps {

namespace {

// A shadow ray that has come through so many surfaces of glass is given up: its lamp is dark.
constexpr int most_surfaces_of_glass = 64;

// One point of one light.
struct LampPoint {
    const Light& light;
    glm::vec3 color; // its part of the light's
    int sample;
};

Program& set_paths(Program& program, const PathsAtHits& paths) {
    return program.set("ray_origins", paths.rays.origins)
        .set("ray_directions", paths.rays.directions)
        .set("hits", paths.hits)
        .set("weights", paths.weights);
}

Program& set_lamp(Program& program, const LampPoint& lamp) {
    return program.set("light_position", lamp.light.position)
        .set("light_across", lamp.light.across)
        .set("light_along", lamp.light.along)
        .set("lamp_sample", lamp.sample)
        .set("light_color", lamp.color);
}

// What one point of a light takes.
class LampWork {
public:
    LampWork(const PathsAtHits& paths, const Plan& plan, PlannedPasses& passes, TraceRays& trace,
             const SceneTextures& scene, RayTally& tally)
        : paths_(paths), plan_(plan), passes_(passes), trace_(trace), scene_(scene), tally_(tally),
          width_(paths.hits.width()), height_(paths.hits.height()) {}

    // The colour of each surface from its texture, for all lamps.
    void paint() {
        paint_.emplace(TexelFormat::rgba32f, width_, height_);
        draw(set_paths(passes_["paint_surface"], paths_),
             {.textures = {*paint_}, .live = &paths_.live});
    }

    // That colour, or the material's own, times those of the corners.
    void tint() {
        Program& program = passes_["tint_surface"].set("hits", paths_.hits);
        if (paint_) {
            program.set("paint", *paint_);
        }
        Texture tinted(TexelFormat::rgba32f, width_, height_);
        draw(program, {.textures = {tinted}, .live = &paths_.live});
        paint_ = std::move(tinted);
    }

    // The normal of each surface from its picture, for all lamps.
    void bend_normals() {
        normals_.emplace(TexelFormat::rgba32f, width_, height_);
        draw(set_paths(passes_["bend_normals"], paths_),
             {.textures = {*normals_}, .live = &paths_.live});
    }

    void light(const LampPoint& lamp, const Texture& color, long asking) {
        std::optional<Texture> visible;
        if (has(plan_, Effect::shadows)) {
            const RayTextures rays = cast(lamp);
            const long facing =
                count_live(paths_.live, passes_["select_rays"]
                                            .set("ray_origins", rays.origins)
                                            .set("ray_directions", rays.directions));
            tally_.facing_away += asking - facing;
            if (facing == 0) {
                ++tally_.lamps_skipped;
                return;
            }
            (has_area(lamp.light) ? tally_.soft_shadow : tally_.shadow) += facing;
            visible = has(plan_, Effect::glass_shadows)
                          ? shares_behind_glass(rays)
                          : trace_.any_hits(rays, scene_, &paths_.live);
        }
        if (has(plan_, Effect::diffuse)) {
            add("light_surface", lamp, visible, color);
        }
        if (has(plan_, Effect::highlights)) {
            add("add_highlight", lamp, visible, color);
        }
    }

private:
    RayTextures cast(const LampPoint& lamp) {
        RayTextures rays = make_ray_textures(width_, height_);
        rays.coherence = paths_.rays.coherence; // from neighbouring hits to one lamp
        clear(rays.directions);                 // so that pixels without a path have no ray
        Program& program = set_lamp(set_paths(passes_["cast_lamp_rays"], paths_), lamp);
        if (normals_) {
            program.set("bent_normals", *normals_);
        }
        draw(program, {.textures = {rays.origins, rays.directions}, .live = &paths_.live});
        return rays;
    }

    // What is left of the lamp's light for each shadow ray: they go on behind glass, until none is
    // left.
    Texture shares_behind_glass(const RayTextures& cast_rays) {
        LiveMask live(width_, height_);
        retire(live, passes_["select_empty_rays"]
                         .set("ray_origins", cast_rays.origins)
                         .set("ray_directions", cast_rays.directions));
        Texture reached(TexelFormat::rgba32f, width_, height_);
        clear(reached);
        Texture shares(TexelFormat::rgba32f, width_, height_);
        draw(passes_["start_weights"], {.textures = {shares}});
        Texture next_shares(TexelFormat::rgba32f, width_, height_);
        RayTextures next = make_ray_textures(width_, height_);
        RayTextures rest = make_ray_textures(width_, height_);
        for (int surface = 0; surface < most_surfaces_of_glass; ++surface) {
            const RayTextures& rays = surface == 0 ? cast_rays : rest;
            const Texture hits = trace_.closest_hits(rays, scene_, &live);
            draw(passes_["reach_lamp"].set("hits", hits).set("shares", shares),
                 {.textures = {reached}, .live = &live});
            retire(live, passes_["select_no_glass"].set("hits", hits));
            const long going_on = count_live(live, passes_["select_all"]);
            if (going_on == 0) {
                break;
            }
            tally_.behind_glass += going_on;
            draw(passes_["dim_light"]
                     .set("ray_origins", rays.origins)
                     .set("ray_directions", rays.directions)
                     .set("hits", hits)
                     .set("shares", shares),
                 {.textures = {next.origins, next.directions, next_shares}, .live = &live});
            std::swap(rest, next);
            std::swap(shares, next_shares);
        }
        return reached;
    }

    void add(const std::string& pass, const LampPoint& lamp, const std::optional<Texture>& visible,
             const Texture& color) {
        Program& program = set_lamp(set_paths(passes_[pass], paths_), lamp);
        if (visible) {
            program.set("shadow_hits", *visible).set("light_shares", *visible);
        }
        if (paint_) {
            program.set("paint", *paint_);
        }
        if (normals_) {
            program.set("bent_normals", *normals_);
        }
        draw(program, {.textures = {color}, .live = &paths_.live, .blend = Blend::add});
    }

    const PathsAtHits& paths_;
    const Plan& plan_;
    PlannedPasses& passes_;
    TraceRays& trace_;
    const SceneTextures& scene_;
    RayTally& tally_;
    int width_;
    int height_;
    std::optional<Texture> paint_;
    std::optional<Texture> normals_;
};

} // namespace

Lamps::Lamps(std::vector<Light> lights, const Plan& plan)
    : lights_(std::move(lights)), plan_(plan) {}

void Lamps::light(const PathsAtHits& paths, const Texture& color, int sample, PlannedPasses& passes,
                  TraceRays& trace, const SceneTextures& scene, RayTally& tally) const {
    const long asking = count_live(paths.live, passes["select_all"]);
    if (asking == 0) {
        return;
    }
    LampWork work(paths, plan_, passes, trace, scene, tally);
    if (has(plan_, Effect::textures)) {
        work.paint();
    }
    if (has(plan_, Effect::vertex_colors)) {
        work.tint();
    }
    if (has(plan_, Effect::normal_maps)) {
        work.bend_normals();
    }
    for (const Light& light : lights_) {
        if (light.color == glm::vec3(0.0f)) {
            ++tally.lamps_skipped;
            continue;
        }
        const int samples =
            has(plan_, Effect::soft_shadows) && has_area(light) ? plan_.lamp_samples : 1;
        const glm::vec3 part = light.color * (1.0f / static_cast<float>(samples));
        for (int i = 0; i < samples; ++i) {
            work.light({light, part, sample * samples + i}, color, asking);
        }
    }
}

} // namespace raysteps
