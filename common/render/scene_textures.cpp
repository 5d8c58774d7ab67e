#include "render/scene_textures.h"

#include "scene/pack_scene.h"
#include "structure/structure.h"

namespace raysteps {

StructureTextures upload(const BuiltStructure& built) {
    StructureTextures textures{.points = built.packed.points,
                               .counts = built.packed.counts,
                               .numbers = built.packed.numbers,
                               .longest_walk = built.longest_walk,
                               .facts = built.facts};
    for (const auto& [name, texels] : built.packed.vectors) {
        textures.buffers.emplace(name, std::span(texels));
    }
    for (const auto& [name, texels] : built.packed.integer_vectors) {
        textures.buffers.emplace(name, std::span(texels));
    }
    for (const auto& [name, texels] : built.packed.integers) {
        textures.buffers.emplace(name, std::span(texels));
    }
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

SceneTextures upload(const Scene& scene, const BuiltStructure& structure) {
    return {triangle_count(scene),
            BufferTexture(pack_vectors(scene.corners)),
            BufferTexture(pack_vectors(scene.normals)),
            BufferTexture(std::span<const std::int32_t>(scene.triangle_materials)),
            BufferTexture(pack_materials(scene.materials)),
            upload(structure)};
}

SceneTextures upload(const Scene& scene) {
    return upload(scene, every_triangle(triangle_count(scene)));
}

} // namespace raysteps
