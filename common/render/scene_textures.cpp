#include "render/scene_textures.h"

#include "scene/pack_scene.h"
#include "scene/pictures.h"
#include "structure/structure.h"

#include <utility>

namespace raysteps {

namespace {

// The words of a picture, behind those that there are: bit i of a word is its texel i, 1 where
// there is a surface.
void append_words(std::vector<std::int32_t>& words, const Opacity& opacity, float cutoff) {
    const std::size_t first = words.size();
    words.resize(first + (opacity.values.size() + 31) / 32, 0);
    for (std::size_t i = 0; i < opacity.values.size(); ++i) {
        if (static_cast<float>(opacity.values[i]) >= 255.0f * cutoff) {
            const auto word = static_cast<std::uint32_t>(words[first + i / 32]) | 1u << (i % 32);
            words[first + i / 32] = static_cast<std::int32_t>(word);
        }
    }
}

std::vector<glm::vec4> pack_coordinates(const Scene& scene) {
    std::vector<glm::vec4> texels;
    texels.reserve(scene.corners.size());
    for (const glm::vec2& place : scene.texture_coordinates) {
        texels.emplace_back(place, 0.0f, 0.0f);
    }
    texels.resize(scene.corners.size(), glm::vec4(0.0f));
    return texels;
}

std::map<std::string, BufferTexture> upload_cutouts(const Scene& scene) {
    std::vector<std::int32_t> numbers;
    std::vector<glm::ivec4> pictures;
    std::vector<std::int32_t> words;
    std::map<std::pair<std::string, float>, int> known;
    for (const Material& material : scene.materials) {
        if (material.cutout_map.empty()) {
            numbers.push_back(-1);
            continue;
        }
        const auto [entry, is_new] = known.try_emplace({material.cutout_map, material.cutoff},
                                                       static_cast<int>(pictures.size()));
        if (is_new) {
            const Opacity opacity = opacity_of(scene, material.cutout_map);
            pictures.emplace_back(static_cast<int>(words.size()), opacity.width, opacity.height, 0);
            append_words(words, opacity, material.cutoff);
        }
        numbers.push_back(entry->second);
    }
    std::map<std::string, BufferTexture> buffers;
    if (pictures.empty()) {
        return buffers;
    }
    const std::vector<glm::vec4> coordinates = pack_coordinates(scene);
    buffers.emplace("cutout_coordinates", std::span<const glm::vec4>(coordinates));
    buffers.emplace("cutout_materials", std::span<const std::int32_t>(scene.triangle_materials));
    buffers.emplace("material_cutouts", std::span<const std::int32_t>(numbers));
    buffers.emplace("cutouts", std::span<const glm::ivec4>(pictures));
    buffers.emplace("cutout_words", std::span<const std::int32_t>(words));
    return buffers;
}

} // namespace

namespace {

template <class Texel>
void upload_arrays(StructureTextures& textures, std::map<std::string, std::vector<Texel>>& arrays) {
    for (auto& [name, texels] : arrays) {
        textures.buffers.emplace(name, std::move(texels));
    }
}

} // namespace

StructureTextures upload(BuiltStructure built) {
    StructureTextures textures{.points = std::move(built.packed.points),
                               .counts = std::move(built.packed.counts),
                               .numbers = std::move(built.packed.numbers),
                               .longest_walk = built.longest_walk,
                               .facts = std::move(built.facts)};
    upload_arrays(textures, built.packed.vectors);
    upload_arrays(textures, built.packed.integer_vectors);
    upload_arrays(textures, built.packed.integers);
    return textures;
}

void bind(Program& program, const StructureTextures& structure) {
    for (const auto& [name, buffer] : structure.buffers) {
        program.set(name, buffer);
    }
    for (const auto& [name, point] : structure.points) {
        program.set(name, point);
    }
    for (const auto& [name, count] : structure.counts) {
        program.set(name, count);
    }
    for (const auto& [name, number] : structure.numbers) {
        program.set(name, number);
    }
}

SceneTextures upload(const Scene& scene, BuiltStructure structure) {
    StructureTextures arrays = upload(std::move(structure));
    return {triangle_count(scene),
            BufferTexture(std::span<const glm::vec3>(scene.corners)),
            BufferTexture(std::span<const glm::vec3>(scene.normals)),
            BufferTexture(std::span<const std::int32_t>(scene.triangle_materials)),
            BufferTexture(pack_materials(scene.materials)),
            std::move(arrays),
            upload_cutouts(scene)};
}

SceneTextures without_cutouts(SceneTextures textures) {
    textures.cutouts.clear();
    return textures;
}

SceneTextures upload(const Scene& scene) {
    return upload(scene, every_triangle(triangle_count(scene)));
}

} // namespace raysteps
