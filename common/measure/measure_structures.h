#pragma once

#include "gpu/limits.h"
#include "render/trace_rays.h"
#include "report/measured_range.h"
#include "scene/scene.h"
#include "structure/structure_family.h"

#include <string>
#include <vector>

namespace raysteps {

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
