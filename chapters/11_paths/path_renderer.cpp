#include "11_paths/path_renderer.h"

#include "gpu/draw.h"
#include "scene/pack_scene.h"
#include "scene/view.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace raysteps {

namespace {

// Up to so many paths are on their way at once: about 250 bytes each.
constexpr int most_paths_at_once = 1 << 18;

float largest_of(const glm::vec3& color) {
    return std::max({color.x, color.y, color.z});
}

bool glows(const Material& material) {
    return largest_of(material.emission) > 0.0f;
}

bool has_triangle_with(const Scene& scene, bool (*has)(const Material&)) {
    return std::ranges::any_of(scene.triangle_materials, [&](int material) {
        return has(scene.materials[static_cast<std::size_t>(material)]);
    });
}

Sky sky_for_paths(const Scene& scene) {
    return scene.sky.value_or(Sky{scene.background, scene.background, scene.background});
}

bool is_black(const Sky& sky) {
    return sky.zenith + sky.horizon + sky.ground == glm::vec3(0.0f);
}

// Of the parts of light/materials.glsl, with light/path.glsl's share in the first texel.
std::vector<glm::vec4> pack_path_materials(const std::vector<Material>& materials) {
    std::vector<glm::vec4> texels;
    for (const Material& material : materials) {
        const float clear = transparency(material);
        const glm::vec3 matte = (1.0f - clear) * material.diffuse;
        const float smooth = clear > 0.0f          ? clear
                             : is_mirror(material) ? largest_of(material.specular)
                                                   : 0.0f;
        const float share =
            smooth == 0.0f ? 1.0f : largest_of(matte) / (largest_of(matte) + smooth);
        texels.emplace_back(matte, share);
        texels.emplace_back(material.specular, smooth > 0.0f ? 1.0f : 0.0f);
        texels.emplace_back(material.emission, 0.0f);
    }
    return texels;
}

struct Emitters {
    std::vector<std::int32_t> triangles;
    std::vector<glm::vec4> bounds;
    double power = 0.0;
};

Emitters emitters_of(const Scene& scene) {
    Emitters emitters;
    std::vector<double> sums;
    for (int triangle = 0; triangle < triangle_count(scene); ++triangle) {
        const auto first = 3 * static_cast<std::size_t>(triangle);
        const Material& material = scene.materials[static_cast<std::size_t>(
            scene.triangle_materials[static_cast<std::size_t>(triangle)])];
        const glm::dvec3 a(scene.corners[first]);
        const double area = 0.5 * glm::length(glm::cross(glm::dvec3(scene.corners[first + 1]) - a,
                                                         glm::dvec3(scene.corners[first + 2]) - a));
        if (glows(material) && area > 0.0) {
            emitters.power += area * static_cast<double>(largest_of(material.emission));
            emitters.triangles.push_back(triangle);
            sums.push_back(emitters.power);
        }
    }
    for (const double sum : sums) {
        emitters.bounds.emplace_back(static_cast<float>(sum / emitters.power), 0.0f, 0.0f, 0.0f);
    }
    return emitters;
}

SceneTextures with_path_materials(SceneTextures textures, const Scene& scene) {
    textures.materials = BufferTexture(pack_path_materials(scene.materials));
    return without_cutouts(std::move(textures));
}

std::vector<std::uint8_t> glowing_triangles(const Scene& scene) {
    std::vector<std::uint8_t> glowing;
    for (const int material : scene.triangle_materials) {
        glowing.push_back(glows(scene.materials[static_cast<std::size_t>(material)]) ? 1 : 0);
    }
    return glowing;
}

int most_side_by_side(int width, int height, int texture_size) {
    for (int count = samples_per_block; count > 1; count /= 2) {
        if (static_cast<long>(width) * height * count <= most_paths_at_once &&
            4 * std::max(width, height) <= texture_size) {
            return count;
        }
    }
    return 1;
}

} // namespace

std::vector<std::string> left_out_of_paths(const Scene& scene) {
    std::vector<std::string> sentences;
    const auto say = [&](bool has, const std::string& sentence) {
        if (has) {
            sentences.push_back(sentence);
        }
    };
    say(has_triangle_with(scene, has_highlight), "highlights: paths know matte surfaces, mirrors "
                                                 "and glass");
    say(has_triangle_with(scene, has_texture), "textures: each surface has its Kd");
    say(!scene.corner_colors.empty(), "colours of vertices: each surface has its Kd");
    say(std::ranges::any_of(scene.materials,
                            [](const Material& one) { return !one.cutout_map.empty(); }),
        "cut-outs: surfaces are whole");
    say(scene.camera.aperture > 0.0f, "the lens: the camera is a pinhole");
    say(has_triangle_with(scene, glows) && !scene.lights.empty(),
        "the scene's lights: what glows is the light");
    return sentences;
}

bool has_light_for_paths(const Scene& scene) {
    return has_triangle_with(scene, glows) || !is_black(sky_for_paths(scene)) ||
           !scene.lights.empty();
}

// The paths of one launch, and what they have found.
struct PathRenderer::Paths {
    Paths(int across, int down)
        : rays(make_ray_textures(across, down)), next_rays(make_ray_textures(across, down)),
          weights(TexelFormat::rgba32f, across, down),
          next_weights(TexelFormat::rgba32f, across, down),
          color(TexelFormat::rgba32f, across, down), live(across, down) {
        clear(color);
        rays.coherence = Coherence::neighbours;
    }

    // Draws what is added to the colour of living paths.
    Targets added() const { return {.textures = {color}, .live = &live, .blend = Blend::add}; }

    RayTextures rays;
    RayTextures next_rays;
    Texture weights;
    Texture next_weights;
    Texture color;
    LiveMask live;
    std::optional<Texture> media; // where there is glass
    std::optional<Texture> next_media;
};

PathRenderer::PathRenderer(const Scene& scene, SceneTextures textures, const PathChoice& choice,
                           const Parts& trace_parts, const Limits& limits)
    : choice_(choice), glowing_(glowing_triangles(scene)),
      scene_(with_path_materials(std::move(textures), scene)),
      has_mirrors_(has_triangle_with(
          scene, [](const Material& one) { return is_mirror(one) && !is_glass(one); })),
      has_glass_(has_triangle_with(scene, is_glass)), absorbs_(has_triangle_with(scene, absorbs)),
      trace_(trace_parts, limits), texture_size_(limits.texture_size) {
    const Emitters emitters = emitters_of(scene);
    has_emitters_ = !emitters.triangles.empty();
    if (has_emitters_) {
        buffers_.emplace("emitter_bounds", emitters.bounds);
        buffers_.emplace("emitter_triangles", std::span(emitters.triangles));
    } else {
        point_lights_ = scene.lights;
    }
    if (has_glass_) {
        buffers_.emplace("glass_texels", pack_glass(scene));
    }
    const Sky sky = sky_for_paths(scene);
    has_sky_ = !is_black(sky);

    const Parts random{{"random", find_part("random", choice.random)}};
    const Parts heuristic{{"heuristic", find_part("heuristic", choice.heuristic)}};
    const Parts bounce{{"bounce", find_part("bounce", choice.bounce)}};
    const Parts roulette{{"roulette", find_part("roulette", choice.roulette)}};
    const auto add = [&](const std::string& name, std::initializer_list<Parts> parts = {}) {
        Parts all;
        for (const Parts& some : parts) {
            all.insert(some.begin(), some.end());
        }
        Program program(find_pass(name), all);
        program.set("triangle_corners", scene_.corners)
            .set("triangle_normals", scene_.normals)
            .set("triangle_materials", scene_.triangle_materials)
            .set("materials", scene_.materials)
            .set("seed", choice.seed)
            .set("emitter_count", static_cast<int>(emitters.triangles.size()))
            .set("emitted_power", static_cast<float>(emitters.power))
            .set("sky_zenith", sky.zenith)
            .set("sky_horizon", sky.horizon)
            .set("sky_ground", sky.ground);
        for (const auto& [uniform, buffer] : buffers_) {
            program.set(uniform, buffer);
        }
        passes_.emplace(name, std::move(program));
    };
    for (const std::string name :
         {"sum_samples", "select_all", "select_misses", "select_rays", "select_empty_rays"}) {
        add(name);
    }
    add("start_paths", {random});
    add("bounce", {random, bounce, roulette});
    if (has_sky_) {
        add("add_sky");
    }
    if (has_emitters_) {
        add("meet_glow", {heuristic});
        add("cast_light_rays", {random, bounce, heuristic});
        add("add_reached");
    }
    if (!point_lights_.empty()) {
        add("cast_shadow_rays");
        add("add_light");
    }
    if (has_mirrors_) {
        add("bounce_off_mirror", {random, roulette});
    }
    if (has_glass_) {
        add("cross_glass", {random, roulette});
        add("carry_media");
    }
    if (absorbs_) {
        add("absorb");
    }
}

std::vector<glm::vec4> PathRenderer::render_block(const Camera& camera, int width, int height,
                                                  int block, int side_by_side) {
    const int count =
        side_by_side > 0 ? side_by_side : most_side_by_side(width, height, texture_size_);
    const int across = count >= 8 ? 4 : std::min(count, 2);
    const View view = view_of(camera, static_cast<double>(width) / height);
    Texture sum(TexelFormat::rgba32f, width, height);
    Texture next_sum(TexelFormat::rgba32f, width, height);
    clear(sum);
    for (int first = 0; first < samples_per_block; first += count) {
        for (auto& [name, program] : passes_) {
            program.set("picture_width", width)
                .set("picture_height", height)
                .set("pictures_across", across)
                .set("first_sample", samples_per_block * block + first);
        }
        Paths paths(across * width, count / across * height);
        draw(pass("start_paths")
                 .set("view.eye", view.eye)
                 .set("view.lower_left", view.lower_left)
                 .set("view.right", view.right)
                 .set("view.up", view.up),
             {.textures = {paths.rays.origins, paths.rays.directions, paths.weights}});
        tally_.camera += static_cast<long>(width) * height * count;
        follow(paths);
        draw(pass("sum_samples")
                 .set("samples", paths.color)
                 .set("sum_before", sum)
                 .set("sample_count", count),
             {.textures = {next_sum}});
        std::swap(sum, next_sum);
    }
    return read_floats(sum);
}

std::vector<std::uint8_t> PathRenderer::pixels_with_lamps(const Camera& camera, int width,
                                                          int height) {
    std::vector<std::uint8_t> found(static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height));
    const RayTextures rays = generate_rays(camera, width, height, RayGeneration::direct);
    const std::vector<Hit> hits = read_hits(trace_.closest_hits(rays, scene_));
    for (int i = 0; i < static_cast<int>(hits.size()); ++i) {
        const Hit& hit = hits[static_cast<std::size_t>(i)];
        if (hit.triangle < 0 || glowing_[static_cast<std::size_t>(hit.triangle)] == 0) {
            continue;
        }
        const int column = i % width;
        const int row = height - 1 - i / width;
        for (int y = std::max(0, row - 1); y <= std::min(height - 1, row + 1); ++y) {
            for (int x = std::max(0, column - 1); x <= std::min(width - 1, column + 1); ++x) {
                found[static_cast<std::size_t>(y * width + x)] = 1;
            }
        }
    }
    return found;
}

void PathRenderer::follow(Paths& paths) {
    if (has_glass_) {
        paths.media.emplace(TexelFormat::rgba32ui, paths.color.width(), paths.color.height());
        paths.next_media.emplace(TexelFormat::rgba32ui, paths.color.width(), paths.color.height());
        clear(*paths.media, glm::uvec4(0));
    }
    for (int bounce = 0;; ++bounce) {
        const Texture hits = trace_.closest_hits(paths.rays, scene_, &paths.live);
        if (absorbs_ && bounce > 0) {
            draw(at_hits("absorb", paths, hits),
                 {.textures = {paths.next_weights}, .live = &paths.live});
            std::swap(paths.weights, paths.next_weights);
        }
        if (has_sky_) {
            draw(at_hits("add_sky", paths, hits), paths.added());
        }
        if (has_emitters_) {
            draw(at_hits("meet_glow", paths, hits), paths.added());
        }
        retire(paths.live, pass("select_misses").set("hits", hits));
        const long going_on = count_live(paths.live, pass("select_all"));
        if (bounce == choice_.max_bounces || going_on == 0) {
            tally_.cut += going_on;
            return;
        }
        add_point_lights(paths, hits);
        if (has_emitters_ && choice_.heuristic != "bounce_only") {
            meet_glow_by_rays(paths, hits, bounce);
        }
        leave_surfaces(paths, hits, bounce);
    }
}

// As chapter 03 does: such a light is met by no path.
void PathRenderer::add_point_lights(Paths& paths, const Texture& hits) {
    for (const Light& light : point_lights_) {
        clear(paths.next_rays.directions); // so that pixels without a path have no ray
        paths.next_rays.coherence = paths.rays.coherence;
        draw(at_hits("cast_shadow_rays", paths, hits).set("light_position", light.position),
             {.textures = {paths.next_rays.origins, paths.next_rays.directions},
              .live = &paths.live});
        const Texture shadow_hits = trace_.any_hits(paths.next_rays, scene_, &paths.live);
        tally_.to_lamps +=
            count_live(paths.live, pass("select_rays")
                                       .set("ray_origins", paths.next_rays.origins)
                                       .set("ray_directions", paths.next_rays.directions));
        draw(at_hits("add_light", paths, hits)
                 .set("shadow_hits", shadow_hits)
                 .set("light_position", light.position)
                 .set("light_color", light.color),
             paths.added());
    }
}

void PathRenderer::meet_glow_by_rays(Paths& paths, const Texture& hits, int bounce) {
    clear(paths.next_rays.directions);
    paths.next_rays.coherence = paths.rays.coherence;
    draw(at_hits("cast_light_rays", paths, hits).set("bounce", bounce),
         {.textures = {paths.next_rays.origins, paths.next_rays.directions, paths.next_weights},
          .live = &paths.live});
    const Texture shadow_hits = trace_.any_hits(paths.next_rays, scene_, &paths.live);
    tally_.to_lamps +=
        count_live(paths.live, pass("select_rays")
                                   .set("ray_origins", paths.next_rays.origins)
                                   .set("ray_directions", paths.next_rays.directions));
    draw(pass("add_reached").set("shadow_hits", shadow_hits).set("lights", paths.next_weights),
         paths.added());
}

// Each pass takes those paths that leave their surfaces in its way.
void PathRenderer::leave_surfaces(Paths& paths, const Texture& hits, int bounce) {
    const Targets matte{
        .textures = {paths.next_rays.origins, paths.next_rays.directions, paths.next_weights},
        .live = &paths.live};
    draw(at_hits("bounce", paths, hits).set("bounce", bounce), matte);
    if (has_mirrors_) {
        draw(at_hits("bounce_off_mirror", paths, hits).set("bounce", bounce), matte);
    }
    if (has_glass_) {
        draw(pass("carry_media").set("media", *paths.media),
             {.textures = {*paths.next_media}, .live = &paths.live});
        draw(at_hits("cross_glass", paths, hits).set("bounce", bounce),
             {.textures = {paths.next_rays.origins, paths.next_rays.directions, paths.next_weights,
                           *paths.next_media},
              .live = &paths.live});
        std::swap(paths.media, paths.next_media);
    }
    std::swap(paths.rays, paths.next_rays);
    std::swap(paths.weights, paths.next_weights);
    paths.rays.coherence = Coherence::alone;
    retire(paths.live, pass("select_empty_rays")
                           .set("ray_origins", paths.rays.origins)
                           .set("ray_directions", paths.rays.directions));
    tally_.bounced += count_live(paths.live, pass("select_all"));
}

Program& PathRenderer::at_hits(const std::string& name, const Paths& paths, const Texture& hits) {
    Program& program = pass(name)
                           .set("ray_origins", paths.rays.origins)
                           .set("ray_directions", paths.rays.directions)
                           .set("hits", hits)
                           .set("weights", paths.weights);
    if (paths.media) {
        program.set("media", *paths.media);
    }
    return program;
}

} // namespace raysteps
