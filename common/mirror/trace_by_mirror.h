#pragma once

#include "basics/box.h"
#include "basics/ray.h"
#include "mirror/mirror_scene.h"
#include "structure/structure.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// Stands for the triangle where a walk did not end within 2^26 rounds.
inline constexpr int no_answer = -2;

// The nearest hit of each ray by the shader parts as C++, on all cores.
using TraceByMirror = std::vector<Hit> (*)(const mirror::SceneBuffers& scene,
                                           const PackedStructure& structure,
                                           std::span<const Ray> rays);

// Every walk of shaders/structure, with the watertight test.
const std::map<std::string, TraceByMirror>& mirror_walks();

// Every test of shaders/triangle, in a loop over every triangle, which needs no structure. Two are
// there in double precision as well: they end in `_double`.
const std::map<std::string, TraceByMirror>& mirror_triangle_tests();

// Whether the box tests of the walks through a BVH visit the box, which is not padded: as C++,
// by the shader parts structure/bvh/box_ray.glsl and box_padded.glsl.
bool meets_plain_box(const Ray& ray, const Box& box);
bool meets_padded_box(const Ray& ray, const Box& box);

// The box with nine roundings more on every side, for numbers up to 4: what the plain test needs
// (structure/bvh/box_ray.glsl has the derivation).
Box grown_by_roundings(const Box& box);

} // namespace raysteps
