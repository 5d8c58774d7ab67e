#pragma once

#include "gpu/program.h"
#include "scene/scene.h"
#include "structure/structure.h"

#include <map>
#include <string>

namespace raysteps {

// A structure as the kernels read it, by the names of their uniforms.
struct StructureTextures {
    std::map<std::string, BufferTexture> buffers{};
    std::map<std::string, glm::vec3> points{};
    std::map<std::string, glm::ivec3> counts{};
    std::map<std::string, int> numbers{};
    int longest_walk = 0; // in rounds, where it is known; else 0
    std::vector<Fact> facts{};
};

// Throws MachineError where an array is over the machine's limit, or memory is short.
StructureTextures upload(BuiltStructure built);

// Gives a program that has the structure's part its arrays and numbers.
void bind(Program& program, const StructureTextures& structure);

// A scene as the kernels read it. Only upload knows both sides: core/triangles.glsl and
// light/materials.glsl say what lies where.
struct SceneTextures {
    int triangle_count = 0;
    BufferTexture corners;            // three texels per triangle
    BufferTexture normals;            // three texels per triangle
    BufferTexture triangle_materials; // one integer per triangle
    BufferTexture materials;          // three texels per material
    StructureTextures structure;
    std::map<std::string, BufferTexture> cutouts{}; // of cutout/pictures.glsl; empty without holes
};

// With the holes of its surfaces, where materials have a cutout_map.
SceneTextures upload(const Scene& scene, BuiltStructure structure);

// The same scene without them.
SceneTextures without_cutouts(SceneTextures textures);

// Without a structure: for the loop over every triangle.
SceneTextures upload(const Scene& scene);

} // namespace raysteps
