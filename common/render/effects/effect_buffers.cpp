#include "render/effects/effect_buffers.h"

#include "basics/error.h"
#include "scene/pack_scene.h"
#include "scene/scene.h"

#include <limits>

namespace raysteps {

namespace {

// Adds an array to the buffers, and its size.
template <class Texels>
void add(EffectBuffers& buffers, const std::string& name, const Texels& texels) {
    buffers.bytes += texels.size() * sizeof(texels[0]);
    buffers.buffers.emplace(name, std::span(texels));
}

struct PackedTextures {
    std::vector<glm::vec4> texels;
    std::vector<glm::ivec4> textures; // where each begins, its width, height and levels
};

PackedTextures pack_textures(const std::vector<Image>& textures) {
    PackedTextures packed;
    for (const Image& texture : textures) {
        const std::vector<Image> levels = mipmap_of(texture);
        if (packed.texels.size() > std::numeric_limits<int>::max() / 2) {
            throw InputError("The textures of the scene have too many texels. Make them smaller, "
                             "or leave them out with --effects -textures.");
        }
        packed.textures.emplace_back(static_cast<int>(packed.texels.size()), texture.width,
                                     texture.height, static_cast<int>(levels.size()));
        for (const Image& level : levels) {
            for (const glm::vec3& pixel : level.pixels) {
                packed.texels.emplace_back(pixel, 0.0f);
            }
        }
    }
    return packed;
}

void add_numbers(EffectBuffers& buffers, const std::string& name, const std::vector<int>& numbers) {
    if (!numbers.empty()) {
        add(buffers, name, std::vector<std::int32_t>(numbers.begin(), numbers.end()));
    }
}

void add_textures(EffectBuffers& buffers, const Scene& scene, const EffectSet& effects) {
    const LoadedTextures loaded = load_textures(scene, effects);
    const PackedTextures packed = pack_textures(loaded.images);
    std::vector<glm::vec4> coordinates;
    coordinates.reserve(scene.corners.size());
    for (std::size_t i = 0; i < scene.corners.size(); ++i) {
        coordinates.emplace_back(i < scene.texture_coordinates.size() ? scene.texture_coordinates[i]
                                                                      : glm::vec2(0.0f),
                                 0.0f, 0.0f);
    }
    add(buffers, "triangle_coordinates", coordinates);
    add(buffers, "picture_texels", packed.texels);
    add(buffers, "pictures", packed.textures);
    add_numbers(buffers, "material_pictures", loaded.textures);
    add_numbers(buffers, "material_normals", loaded.normals);
    add_numbers(buffers, "material_glows", loaded.glows);
    buffers.messages = loaded.messages;
}

} // namespace

std::vector<glm::vec4> pack_planned_materials(const Scene& scene, const Plan& plan) {
    std::vector<glm::vec4> texels;
    texels.reserve(3 * scene.materials.size());
    for (const Material& material : scene.materials) {
        const bool refracts = has(plan, Effect::refraction) && is_glass(material);
        const bool reflects = has(plan, Effect::mirrors) && is_mirror(material);
        const float opaque = refracts ? 1.0f - transparency(material) : 1.0f;
        texels.emplace_back(opaque * material.diffuse, 0.0f);
        texels.emplace_back(material.specular, refracts || reflects ? 1.0f : 0.0f);
        texels.emplace_back(material.emission, 0.0f);
    }
    return texels;
}

EffectBuffers upload_effects(const Scene& scene, const Plan& plan) {
    EffectBuffers buffers;
    if (needs_glass(plan)) {
        add(buffers, "glass_texels", pack_glass(scene));
    }
    if (has(plan, Effect::highlights)) {
        add(buffers, "gloss_texels", pack_gloss(scene));
    }
    if (reads_pictures(plan)) {
        add_textures(buffers, scene, plan.effects);
    }
    if (has(plan, Effect::emissive_maps)) {
        std::vector<glm::vec3> factors;
        for (const Material& material : scene.materials) {
            factors.push_back(material.emissive_factor);
        }
        add(buffers, "glow_factors", pack_vectors(factors));
    }
    if (has(plan, Effect::vertex_colors)) {
        std::vector<glm::vec3> colors = scene.corner_colors; // white where it was forced on
        colors.resize(scene.corners.size(), glm::vec3(1.0f));
        add(buffers, "corner_colors", pack_vectors(colors));
    }
    return buffers;
}

void bind(Program& program, const EffectBuffers& buffers) {
    for (const auto& [name, buffer] : buffers.buffers) {
        program.set(name, buffer);
    }
}

PlannedPasses::PlannedPasses(const Plan& plan, const SceneTextures& scene,
                             const EffectBuffers& effects) {
    for (const PlannedPass& pass : plan.passes) {
        if (pass.name == "compute_rays") {
            continue; // generate_rays of chapter 01 compiles it for each picture
        }
        Program program(find_pass(pass.name), pass.parts);
        program.set("triangle_corners", scene.corners)
            .set("triangle_normals", scene.normals)
            .set("triangle_materials", scene.triangle_materials)
            .set("materials", scene.materials);
        bind(program, effects);
        programs_.emplace(pass.name, std::move(program));
    }
}

} // namespace raysteps
