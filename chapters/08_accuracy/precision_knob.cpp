#include "precision_knob.h"

#include "scene/mesh.h"
#include "scene/shapes.h"
#include "structure/padding.h"
#include "subject.h"
#include "trace_trials.h"

#include <algorithm>

namespace raysteps {

Knob precision_knob(const Effort& effort) {
    const auto scene = std::make_shared<const Scene>(
        add_mesh({}, sphere({0.3f, -0.2f, 0.1f}, 1.0f, 8), Material{}));
    std::vector<RayFamily> families;
    float reach = 0.0f;
    for (RayFamily& family :
         families_from_inside(scene->corners, effort.judged_rays, effort.seed)) {
        if (family.name != "leaving" && family.name != "axis" && family.name != "inside") {
            reach = std::max(reach, reach_of(family.rays, scene->corners));
            families.push_back(std::move(family));
        }
    }
    const auto textures = build_textures(*scene, "bvh_ordered", reach, {});
    const std::string walk = "structure/bvh/bvh_ordered.glsl";
    const std::string exact = "triangle/watertight.glsl";
    const std::string rounded = "triangle/watertight_rounded.glsl";
    const std::vector<TraceMethod> methods{
        {"float", {{"structure", walk}, {"triangle", rounded}}, textures},
        {"float, exact areas", {{"structure", walk}, {"triangle", exact}}, textures},
        {"double",
         {{"structure", walk}, {"triangle", rounded}, {"real", "exhibit/double_precision.glsl"}},
         textures}};
    Knob knob;
    knob.name = "precision";
    knob.question = "What does a kernel in double precision bring? A walk through a BVH of 1,280 "
                    "triangles.";
    knob.unit_of_cases = "ray";
    knob.unit_of_error = "t, in ulp";
    for (Trial& trial :
         trace_trials(methods, with_truth(std::move(families), scene->corners, effort),
                      scene->corners, effort)) {
        trial.examine = [examine = std::move(trial.examine), scene] { return examine(); };
        knob.trials.push_back(std::move(trial));
    }
    return knob;
}

} // namespace raysteps
