#pragma once

#include "gpu/context.h"
#include "render/effects/effects_renderer.h"
#include "scene/load_scene.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "structure/structure.h"

#include <string>

namespace raysteps {

struct EffectPicture {
    Image image;
    RayTally tally;
    Plan plan;
};

// The scene with the effects that it calls for, as changed by the choice. A context must be
// current.
inline EffectPicture effect_picture(const Scene& scene, int side, const std::string& choice = "",
                                    const Quality& quality = {}) {
    EffectPicture picture;
    picture.plan = make_plan(scene, 1.0, choice, quality);
    const BuiltStructure structure = family_of("bvh_ordered").build(scene.corners, {});
    EffectsRenderer renderer(
        scene, upload(scene, structure), picture.plan,
        {{"triangle", "triangle/watertight.glsl"}, {"structure", "structure/bvh/bvh_ordered.glsl"}},
        measure_limits());
    picture.image = renderer.render(scene.camera, side, side);
    picture.tally = renderer.tally();
    return picture;
}

inline std::size_t count_different(const Image& a, const Image& b) {
    std::size_t different = a.pixels.size() == b.pixels.size() ? 0 : a.pixels.size();
    for (std::size_t i = 0; different < a.pixels.size() && i < a.pixels.size(); ++i) {
        different += a.pixels[i] == b.pixels[i] ? 0 : 1;
    }
    return different;
}

// Clear glass of that index and of that colour after a unit of length.
inline Material clear_glass(float index, const glm::vec3& kept = glm::vec3(1.0f)) {
    Material material;
    material.name = "glass";
    material.diffuse = glm::vec3(0.0f);
    material.refractive_index = index;
    material.transmission = kept;
    material.illumination_model = 7;
    return material;
}

// Looks down the z axis from +4 at the origin, with a narrow view; white all around, no light.
inline Scene white_scene() {
    Scene scene;
    scene.camera = {{0.0f, 0.0f, 4.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 20.0f};
    scene.background = glm::vec3(1.0f);
    return scene;
}

inline Mesh facing_wall(float z, float size) {
    return quad({-size, -size, z}, {size, -size, z}, {size, size, z}, {-size, size, z});
}

} // namespace raysteps
