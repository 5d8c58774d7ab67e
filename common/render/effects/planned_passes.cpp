#include "effects/planned_passes.h"

namespace raysteps {

PlannedPasses::PlannedPasses(const Plan& plan, const SceneTextures& scene,
                             const EffectBuffers& effects) {
    for (const PlannedPass& pass : plan.passes) {
        if (pass.name == "compute_rays") {
            continue; // generate_rays of chapter 01 compiles it for each picture
        }
        Program program("pass/" + pass.name + ".frag", pass.parts);
        program.set("triangle_corners", scene.corners)
            .set("triangle_normals", scene.normals)
            .set("triangle_materials", scene.triangle_materials)
            .set("materials", scene.materials);
        bind(program, effects);
        programs_.emplace(pass.name, std::move(program));
    }
}

} // namespace raysteps
