#pragma once

#include "render/structure_textures.h"
#include "scene/scene.h"

namespace raysteps {

// A scene as the kernels read it. Only upload knows both sides: layout/triangles.glsl and
// layout/surfaces.glsl say what lies where.
struct SceneTextures {
    int triangle_count = 0;
    BufferTexture corners;            // three texels a triangle
    BufferTexture normals;            // three texels a triangle
    BufferTexture triangle_materials; // one integer a triangle
    BufferTexture materials;          // three texels a material
    StructureTextures structure;
};

SceneTextures upload(const Scene& scene, const BuiltStructure& structure);

// Without a structure: for the loop over every triangle.
SceneTextures upload(const Scene& scene);

} // namespace raysteps
