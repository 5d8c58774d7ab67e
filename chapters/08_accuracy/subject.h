#pragma once

#include "hard_cases/aimed_rays.h"
#include "reference/exact.h"
#include "render/scene_textures.h"
#include "render/trace_rays.h"
#include "scene/scene.h"
#include "trade_off.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace raysteps {

// A scene to compare methods on. Up to most_triangles_of_loop triangles, rays are tested against
// every one of them, so that all methods make the same tests; more are walked by the fastest walk.
struct Subject {
    Scene scene;
    std::string structure; // the part's file
    std::shared_ptr<const SceneTextures> textures;
};

inline constexpr int most_triangles_of_loop = 600;

// Origins are expected at most so far from the corners (structure/padding.h). A context must be
// current as long as it lives.
std::shared_ptr<const Subject> make_subject(Scene scene, float reach);

// A small closed mesh: a sphere of 320 triangles around a point off the origin.
std::shared_ptr<const Subject> usual_subject();

// Needles in all directions, up to five thousand times as long as wide.
std::shared_ptr<const Subject> slivers_subject();

// The scene's triangles in a structure, built with these values.
std::shared_ptr<const SceneTextures>
build_textures(const Scene& scene, const std::string& structure, float reach,
               const std::map<std::string, std::string>& values);

// The map of each triangle to a unit triangle, for shaders/exhibit/transforms.glsl: three rows per
// triangle, computed in double. Of a triangle without an area, rows that are not finite.
std::vector<glm::vec4> triangle_transforms(std::span<const glm::vec3> corners);

// A program that traces, by the parts of its slots, through the structure that it is given.
struct TraceMethod {
    std::string name;
    Parts parts;
    std::shared_ptr<const SceneTextures> scene;
};

// Rays on the GPU, with the true hits; the first of them also by themselves, to be timed.
struct TraceFamily {
    std::string name;
    std::vector<Ray> rays;
    std::vector<ReferenceHit> truth;
    std::size_t timed_count = 0;
    RayTextures all;
    RayTextures timed;
};

// The families with the truth of exact arithmetic on the float inputs.
std::vector<std::shared_ptr<const TraceFamily>> with_truth(std::vector<RayFamily> families,
                                                           std::span<const glm::vec3> corners,
                                                           const Effort& effort);

// Each method on each family: nearest hits, judged by 08_accuracy/judges.h. The corners must
// outlive the trials. A context must be current as long as they live.
std::vector<MethodTrial>
trace_trials(const std::vector<TraceMethod>& methods,
             const std::vector<std::shared_ptr<const TraceFamily>>& families,
             std::span<const glm::vec3> corners, const Effort& effort);

} // namespace raysteps
