#include "render/whitted_renderer.h"

#include "gpu/draw.h"
#include "render/rays.h"
#include "render/show_hits.h"

namespace raysteps {

namespace {

void set_surfaces(Program& program, const SceneTextures& scene) {
    program.set("triangle_corners", scene.corners)
        .set("triangle_normals", scene.normals)
        .set("triangle_materials", scene.triangle_materials)
        .set("materials", scene.materials);
}

} // namespace

WhittedRenderer::WhittedRenderer(const Scene& scene, SceneTextures textures,
                                 const Parts& trace_parts, const Limits& limits)
    : lights_(scene.lights), background_(scene.background), scene_(std::move(textures)),
      trace_(trace_parts, limits), start_weights_("pass/light/start_weights.frag"),
      add_surroundings_("pass/light/add_surroundings.frag"),
      cast_shadow_rays_("pass/light/cast_shadow_rays.frag"),
      add_light_("pass/light/add_light.frag"), reflect_("pass/light/reflect.frag"),
      select_misses_("pass/select/select_misses.frag"),
      select_unmirrored_("pass/select/select_unmirrored.frag"),
      select_all_("pass/select/select_all.frag") {
    for (Program* program : {&add_surroundings_, &cast_shadow_rays_, &add_light_, &reflect_,
                             &select_misses_, &select_unmirrored_}) {
        set_surfaces(*program, scene_);
    }
    add_surroundings_.set("background", background_);
}

Image WhittedRenderer::render(const Camera& camera, int width, int height, int max_bounces) {
    counts_ = {};
    RayTextures rays = generate_rays(camera, width, height, RayGeneration::direct);
    RayTextures reflected = make_ray_textures(width, height);
    Texture weights(TexelFormat::rgba32f, width, height);
    Texture reflected_weights(TexelFormat::rgba32f, width, height);
    const Texture color(TexelFormat::rgba32f, width, height);
    LiveMask live(width, height);
    clear(color);
    draw(start_weights_, {.textures = {weights}});

    counts_.camera = static_cast<long>(width) * height;
    for (int bounce = 0;; ++bounce) {
        const Texture hits = trace_.closest_hits(rays, scene_, &live);
        add_surroundings_.set("hits", hits).set("weights", weights);
        draw(add_surroundings_, {.textures = {color}, .live = &live, .blend = Blend::add});
        retire(live, select_misses_.set("hits", hits));
        add_lights(rays, hits, weights, color, live);

        retire(live, select_unmirrored_.set("hits", hits));
        const long mirrored = count_live(live, select_all_);
        if (mirrored == 0 || bounce == max_bounces) {
            return read_image(color);
        }
        counts_.mirror += mirrored;
        reflect_.set("ray_origins", rays.origins)
            .set("ray_directions", rays.directions)
            .set("hits", hits)
            .set("weights", weights);
        draw(reflect_, {.textures = {reflected.origins, reflected.directions, reflected_weights},
                        .live = &live});
        std::swap(rays, reflected);
        reflected.coherence = Coherence::alone; // they were the camera's
        std::swap(weights, reflected_weights);
    }
}

void WhittedRenderer::add_lights(const RayTextures& rays, const Texture& hits,
                                 const Texture& weights, const Texture& color,
                                 const LiveMask& live) {
    RayTextures shadow_rays = make_ray_textures(rays.origins.width(), rays.origins.height());
    shadow_rays.coherence = rays.coherence; // from neighbouring hits to one light
    clear(shadow_rays.directions);          // so that pixels without a path have no ray
    const long asking = count_live(live, select_all_);
    for (const Light& light : lights_) {
        counts_.shadow += asking;
        cast_shadow_rays_.set("ray_origins", rays.origins)
            .set("ray_directions", rays.directions)
            .set("hits", hits)
            .set("light_position", light.position);
        draw(cast_shadow_rays_,
             {.textures = {shadow_rays.origins, shadow_rays.directions}, .live = &live});
        const Texture shadow_hits = trace_.any_hits(shadow_rays, scene_, &live);
        add_light_.set("ray_origins", rays.origins)
            .set("ray_directions", rays.directions)
            .set("hits", hits)
            .set("shadow_hits", shadow_hits)
            .set("weights", weights)
            .set("light_position", light.position)
            .set("light_color", light.color);
        draw(add_light_, {.textures = {color}, .live = &live, .blend = Blend::add});
    }
}

} // namespace raysteps
