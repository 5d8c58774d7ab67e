#include "render/effects/effects_renderer.h"

#include "gpu/draw.h"
#include "render/rays.h"
#include "render/show_hits.h"
#include "scene/view.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace raysteps {

namespace {

SceneTextures with_planned_materials(SceneTextures textures, const Scene& scene, const Plan& plan) {
    textures.materials = BufferTexture(pack_planned_materials(scene, plan));
    return has(plan, Effect::cutouts) ? std::move(textures) : without_cutouts(std::move(textures));
}

Program& set_view(Program& program, const Camera& camera, double aspect_ratio) {
    const View view = view_of(camera, aspect_ratio);
    return program.set("view.eye", view.eye)
        .set("view.lower_left", view.lower_left)
        .set("view.right", view.right)
        .set("view.up", view.up);
}

float focus_distance_of(const Camera& camera) {
    return camera.focus_distance > 0.0f ? camera.focus_distance
                                        : glm::distance(camera.eye, camera.target);
}

Image mean_of(Image sum, int count) {
    const float part = 1.0f / static_cast<float>(count);
    for (glm::vec3& pixel : sum.pixels) {
        pixel *= part;
    }
    return sum;
}

} // namespace

EffectsRenderer::EffectsRenderer(const Scene& scene, SceneTextures textures, const Plan& plan,
                                 const Parts& trace_parts, const Limits& limits)
    : plan_(plan), scene_(with_planned_materials(std::move(textures), scene, plan)),
      effects_(upload_effects(scene, plan)), trace_(trace_parts, limits),
      passes_(plan_, scene_, effects_), lamps_(scene.lights, plan_) {
    const bool has_sky = has(plan_, Effect::sky) && scene.sky;
    passes_["add_surroundings"].set("background", has_sky ? glm::vec3(0.0f) : scene.background);
    if (has_sky) {
        passes_["add_sky"]
            .set("sky_zenith", scene.sky->zenith)
            .set("sky_horizon", scene.sky->horizon)
            .set("sky_ground", scene.sky->ground);
    }
    if (goes_on(plan_)) {
        passes_["select_faint"].set("faintest", plan_.quality.faintest);
    }
}

Image EffectsRenderer::render(const Camera& camera, int width, int height) {
    tally_ = {};
    const Texture color(TexelFormat::rgba32f, width, height);
    clear(color);
    const float pixel_angle = glm::length(view_of(camera, static_cast<double>(width) / height).up) /
                              static_cast<float>(height);
    for (const auto& [effect, pass] : {std::pair{Effect::textures, "paint_surface"},
                                       {Effect::normal_maps, "bend_normals"},
                                       {Effect::emissive_maps, "add_glow"}}) {
        if (has(plan_, effect)) {
            passes_[pass].set("pixel_angle", pixel_angle);
        }
    }
    const Media media = has(plan_, Effect::refraction) ? Media::kept : Media::none;
    for (int sample = 0; sample < plan_.camera_samples; ++sample) {
        Branch branch = make_branch(width, height, media);
        branch.rays = camera_rays(camera, width, height, sample);
        branch.live = std::make_unique<LiveMask>(width, height);
        draw(passes_["start_weights"], {.textures = {branch.weights}});
        if (branch.media) {
            clear(*branch.media); // the camera stands in the open
        }
        tally_.camera += static_cast<long>(width) * height;
        waiting_.push_back(std::move(branch));
        while (!waiting_.empty()) {
            Branch last = std::move(waiting_.back());
            waiting_.pop_back();
            follow(std::move(last), color, sample);
        }
        progress_((sample + 1.0) / plan_.camera_samples);
    }
    return mean_of(read_image(color), plan_.camera_samples);
}

RayTextures EffectsRenderer::camera_rays(const Camera& camera, int width, int height, int sample) {
    const double aspect_ratio = static_cast<double>(width) / height;
    RayTextures rays = make_ray_textures(width, height);
    if (has(plan_, Effect::antialiasing)) {
        Program& spread = set_view(passes_["spread_rays"], camera, aspect_ratio);
        spread.set("picture_size", glm::vec2(width, height))
            .set("pixel_sample", camera.samples > 1 ? sample : 0);
        draw(spread, {.textures = {rays.origins, rays.directions}});
        rays.coherence = Coherence::neighbours;
    } else {
        rays = generate_rays(camera, width, height, RayGeneration::direct);
    }
    if (!has(plan_, Effect::depth_of_field)) {
        return rays;
    }
    RayTextures through_lens = make_ray_textures(width, height);
    Program& lens = set_view(passes_["lens_rays"], camera, aspect_ratio);
    lens.set("ray_origins", rays.origins)
        .set("ray_directions", rays.directions)
        .set("lens_radius", 0.5f * camera.aperture)
        .set("focus_distance", focus_distance_of(camera))
        .set("lens_sample", sample);
    draw(lens, {.textures = {through_lens.origins, through_lens.directions}});
    return through_lens;
}

// The rays of a branch to their end, or to the glass where they split.
void EffectsRenderer::follow(Branch branch, const Texture& color, int sample) {
    const int width = branch.weights.width();
    const int height = branch.weights.height();
    const bool is_list = !branch.targets.empty();
    if (is_list) { // the last row may not be full
        retire(*branch.live, passes_["select_faint"].set("weights", branch.weights));
    }
    for (;; ++branch.bounce) {
        ++tally_.waves;
        tally_.deepest = std::max(tally_.deepest, branch.bounce);
        const Texture hits = trace_.closest_hits(branch.rays, scene_, branch.live.get());
        if (is_list) {
            const Texture light(TexelFormat::rgba32f, width, height);
            clear(light);
            shade(branch, hits, light, sample);
            carry_to_pixels(branch, light, color);
        } else {
            shade(branch, hits, color, sample);
        }
        if (!goes_on(plan_) || branch.bounce == plan_.quality.max_bounces) {
            return;
        }
        retire(*branch.live, passes_["select_unmirrored"].set("hits", hits));
        if (has(plan_, Effect::refraction) &&
            count_live(*branch.live, passes_["select_glass"].set("hits", hits)) > 0) {
            split_at_glass(branch, hits);
            return;
        }
        if (!mirror(branch, hits)) {
            return;
        }
    }
}

// What the rays see where they hit. Paths that leave the scene end.
void EffectsRenderer::shade(Branch& branch, const Texture& hits, const Texture& light, int sample) {
    if (has(plan_, Effect::absorption) && branch.bounce > 0) {
        Texture kept(TexelFormat::rgba32f, hits.width(), hits.height());
        draw(at_hits("absorb", branch, hits), {.textures = {kept}, .live = branch.live.get()});
        std::swap(branch.weights, kept);
    }
    const Targets added{.textures = {light}, .live = branch.live.get(), .blend = Blend::add};
    draw(at_hits("add_surroundings", branch, hits), added);
    if (has(plan_, Effect::sky)) {
        draw(at_hits("add_sky", branch, hits), added);
    }
    retire(*branch.live, passes_["select_misses"].set("hits", hits));
    if (has(plan_, Effect::emissive_maps)) {
        draw(at_hits("add_glow", branch, hits), added);
    }
    if (is_lit(plan_)) {
        lamps_.light({branch.rays, hits, branch.weights, *branch.live}, light, sample, passes_,
                     trace_, scene_, tally_);
    }
}

void EffectsRenderer::carry_to_pixels(const Branch& branch, const Texture& light,
                                      const Texture& color) {
    const BufferTexture targets{std::span<const std::int32_t>(branch.targets)};
    add_points(passes_["scatter_light"]
                   .set("lights", light)
                   .set("targets", targets)
                   .set("picture_width", color.width())
                   .set("picture_height", color.height()),
               color, static_cast<int>(branch.targets.size()));
}

// Sends all paths that live on from their mirrors, in their places; false where none does.
bool EffectsRenderer::mirror(Branch& branch, const Texture& hits) {
    LiveMask& live = *branch.live;
    const long meeting = count_live(live, passes_["select_all"]);
    if (meeting == 0) {
        return false;
    }
    Branch next = make_branch(hits.width(), hits.height(), Media::none);
    draw(at_hits("reflect", branch, hits),
         {.textures = {next.rays.origins, next.rays.directions, next.weights}, .live = &live});
    std::swap(branch.rays, next.rays);
    std::swap(branch.weights, next.weights);
    retire(live, passes_["select_faint"].set("weights", branch.weights));
    const long sent = count_live(live, passes_["select_all"]);
    tally_.faint += meeting - sent;
    tally_.mirror += sent;
    return sent > 0;
}

// Sends up to two rays on from each path that lives, as a list.
void EffectsRenderer::split_at_glass(const Branch& branch, const Texture& hits) {
    const LiveMask& live = *branch.live;
    const long meeting = count_live(live, passes_["select_all"]);
    Branch first = make_branch(hits.width(), hits.height(), Media::kept);
    Branch second = make_branch(hits.width(), hits.height(), Media::kept);
    clear(first.weights); // a ray of weight 0 is no ray
    clear(second.weights);
    const auto all_of = [&](const Branch& to) {
        return Targets{.textures = {to.rays.origins, to.rays.directions, to.weights, *to.media},
                       .live = &live};
    };
    if (has(plan_, Effect::mirrors)) {
        draw(passes_["carry_media"].set("media", *branch.media),
             {.textures = {*first.media}, .live = &live});
        draw(at_hits("reflect", branch, hits),
             {.textures = {first.rays.origins, first.rays.directions, first.weights},
              .live = &live});
    }
    draw(at_hits("refract", branch, hits), all_of(first));
    draw(at_hits("reflect_off_glass", branch, hits), all_of(second));

    retire(*branch.live, passes_["select_faint"].set("weights", first.weights));
    const long sent = count_live(live, passes_["select_all"]);
    const long refracted = count_live(live, passes_["select_glass"].set("hits", hits));
    const Gathered gathered = gather(first, second, branch, plan_.quality.faintest);
    tally_.refracted += refracted;
    tally_.mirror += sent - refracted;
    tally_.reflected_by_glass += gathered.second_sent;
    tally_.faint += meeting - sent + gathered.second_faint;
    tally_.most_listed = std::max(tally_.most_listed, gathered.list.targets.size());
    for (Branch& piece : upload_list(gathered.list, branch.bounce + 1)) {
        waiting_.push_back(std::move(piece));
    }
}

Program& EffectsRenderer::at_hits(const std::string& pass, const Branch& branch,
                                  const Texture& hits) {
    Program& program = passes_[pass]
                           .set("ray_origins", branch.rays.origins)
                           .set("ray_directions", branch.rays.directions)
                           .set("hits", hits)
                           .set("weights", branch.weights);
    if (branch.media) {
        program.set("media", *branch.media);
    }
    return program;
}

} // namespace raysteps
