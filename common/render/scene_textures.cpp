#include "render/scene_textures.h"

#include "scene/pack_scene.h"
#include "structure/families.h"

namespace raysteps {

SceneTextures upload(const Scene& scene, const BuiltStructure& structure) {
    return {triangle_count(scene),
            BufferTexture(pack_vectors(scene.corners)),
            BufferTexture(pack_vectors(scene.normals)),
            BufferTexture(std::span<const std::int32_t>(scene.triangle_materials)),
            BufferTexture(pack_materials(scene.materials)),
            upload(structure)};
}

SceneTextures upload(const Scene& scene) {
    return upload(scene, family_of("every_triangle").build(scene.corners, {}));
}

} // namespace raysteps
