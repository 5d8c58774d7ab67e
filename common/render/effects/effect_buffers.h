#pragma once

#include "gpu/program.h"
#include "image/image.h"
#include "render/effects/plan.h"
#include "render/scene_textures.h"
#include "scene/scene.h"

#include <glm/vec4.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// The texels of light/materials.glsl under a plan: a material is marked as a mirror where the plan
// sends rays on from it, and shows only that part of its colour which does not go through it.
std::vector<glm::vec4> pack_planned_materials(const Scene& scene, const Plan& plan);

// Arrays that only some effects read, by the names of their uniforms; empty where the plan has none
// of those effects.
struct EffectBuffers {
    std::map<std::string, BufferTexture> buffers;
    std::vector<std::string> messages; // of textures that could not be read
    std::size_t bytes = 0;
};

EffectBuffers upload_effects(const Scene& scene, const Plan& plan);

void bind(Program& program, const EffectBuffers& buffers);

// The programs of a plan, compiled and given what stays the same for all pictures of the scene.
// Asking for a pass that the plan does not have is a bug of the caller.
class PlannedPasses {
public:
    PlannedPasses(const Plan& plan, const SceneTextures& scene, const EffectBuffers& effects);

    Program& operator[](const std::string& name) { return programs_.at(name); }

private:
    std::map<std::string, Program> programs_;
};

// A texture made by code, for surfaces of sample scenes: `made:checker`, `made:bricks`, `made:wood`
// or `made:globe`. Throws InputError where there is none of that name.
Image made_texture(const std::string& name);

// Whether the name begins as those that made_texture knows.
bool is_made_texture(const std::string& name);

// The mipmap of an image: itself and its coarser levels, each half as wide and half as high as the
// last, rounded down, at least 1, until a single texel. A texel is the mean of the finer ones that
// it covers. Source: Williams, "Pyramidal parametrics", 1983.
std::vector<Image> mipmap_of(const Image& image);

// The images that materials of a scene name for effects of a plan, each once, and the index of its
// image for each material, or -1. One that cannot be read is left out with a message: its material
// then shows its Kd alone.
struct LoadedTextures {
    std::vector<Image> images;
    std::vector<int> textures; // of each material: map_Kd
    std::vector<int> normals;  // norm; the image has its values as they are in the file
    std::vector<int> glows;    // map_Ke
    std::vector<std::string> messages;
};

LoadedTextures load_textures(const Scene& scene, const EffectSet& effects);

} // namespace raysteps
