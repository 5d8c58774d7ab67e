#pragma once

#include "gpu/limits.h"
#include "gpu/shaders.h"
#include "measure/ray_kinds.h"
#include "measure/statistics.h"
#include "render/scene_textures.h"
#include "render/trace_rays.h"
#include "scene/scene.h"
#include "structure/structure.h"

#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace raysteps {

// The parts of a walk's program by their names. Throws InputError where there is no such part.
inline Parts walk_parts(const std::string& triangle, const std::string& structure,
                        const std::string& observer) {
    return {{"triangle", find_part("triangle", triangle)},
            {"structure", find_part("structure", structure)},
            {"observer", "observer/" + observer + ".glsl"}};
}

// A texture of the answers to that query.
inline Texture trace(TraceRays& tracer, const SceneTextures& scene, const RayTextures& rays,
                     Query query) {
    return query == Query::any ? tracer.any_hits(rays, scene) : tracer.closest_hits(rays, scene);
}

// Closest hits must agree in every bit; of any hit, only whether there is one is compared.
inline bool is_same_answer(const Hit& a, const Hit& b, Query query) {
    if (a.triangle < 0 || b.triangle < 0 || query == Query::any) {
        return (a.triangle < 0) == (b.triangle < 0);
    }
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// Of two lists of equal length.
inline std::size_t count_other_answers(std::span<const Hit> a, std::span<const Hit> b,
                                       Query query) {
    std::size_t others = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        others += is_same_answer(a[i], b[i], query) ? 0 : 1;
    }
    return others;
}

// A scene with a built structure of each family, by the family's name.
using BuiltFamilies = std::map<std::string, SceneTextures>;

// Builds each family of these structures once, for all its walks. The values are those of --NAME; a
// builder is given those that it knows. A context must be current. Throws InputError as the
// builders do.
BuiltFamilies build_families(const Scene& scene, const std::vector<std::string>& structures,
                             const std::map<std::string, std::string>& values);

// The one that serves the structure of that name, which must be among those that were built.
const SceneTextures& built_for(const BuiltFamilies& built, const std::string& structure);

// What one kind of rays costs in one structure.
struct RayCosts {
    std::string kind;
    std::size_t rays = 0;
    double visits_a_ray = 0.0; // of cells or nodes
    double tests_a_ray = 0.0;  // of triangles
    MeasuredRange rate;        // million rays a second
};

struct StructureCosts {
    std::string structure;
    std::vector<Fact> facts;
    std::vector<RayCosts> kinds;
};

struct MeasureRequest {
    std::vector<std::string> structures;
    std::map<std::string, std::string> build_values;
    std::string triangle = "watertight";
    std::vector<std::string> kinds{"primary", "shadow", "bounce"};
    int width = 256;
    int height = 256;
    int rounds = 5; // after one that is not counted
};

// Traces primary, shadow and bounce rays (measure/ray_kinds.h) through each structure. First it
// checks that all give the same answers, bit for bit, and counts visits and tests; then it
// measures, interleaved: each round traces every kind in every structure. A context must be
// current. Throws Error with exit code 1 where answers differ: with a triangle test that is not
// exact, that can happen.
std::vector<StructureCosts> measure_structures(const Scene& scene, const MeasureRequest& request,
                                               const Limits& limits, const Progress& progress);

// A table for people: one row a structure and kind.
std::string to_table(std::span<const StructureCosts> costs);

} // namespace raysteps
