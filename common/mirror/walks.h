#pragma once

#include "mirror/mirror_scene.h"
#include "structure/structure.h"

#include <cstdint>
#include <vector>

namespace raysteps::mirror {

// Who watches a walk: what it visits (cells or nodes) and which triangles it tests, in order.

struct NoObserver {
    void visit(int) {}
    void test(int) {}
};

struct Counter {
    std::uint32_t visits = 0;
    std::uint32_t tests = 0;

    void visit(int) { ++visits; }
    void test(int) { ++tests; }
};

struct WalkEvent {
    enum class Kind { visit, test } kind;
    int number; // of the cell or node, or of the triangle
};

struct Recorder {
    std::vector<WalkEvent> events;

    void visit(int place) { events.push_back({WalkEvent::Kind::visit, place}); }
    void test(int triangle) { events.push_back({WalkEvent::Kind::test, triangle}); }
};

// A uniform of a walk gets the array or number of its name.

inline void bind(samplerBuffer& buffer, const PackedStructure& packed, const char* name) {
    buffer.texels = packed.vectors.at(name);
}

inline void bind(isamplerBuffer& buffer, const PackedStructure& packed, const char* name) {
    const auto vectors = packed.integer_vectors.find(name);
    if (vectors != packed.integer_vectors.end()) {
        buffer.vectors = vectors->second;
    } else {
        buffer.texels = packed.integers.at(name);
    }
}

inline void bind(vec3& point, const PackedStructure& packed, const char* name) {
    point = packed.points.at(name);
}

inline void bind(ivec3& count, const PackedStructure& packed, const char* name) {
    count = packed.counts.at(name);
}

inline void bind(int& number, const PackedStructure& packed, const char* name) {
    const auto found = packed.numbers.find(name);
    number = found == packed.numbers.end() ? number : found->second; // the scene has some too
}

} // namespace raysteps::mirror

// Each walk of shaders/structure is a type walks::NAME<Real, Observer> with the watertight triangle
// test, and each test of shaders/triangle a type triangle_tests::NAME<Real, Observer> with the loop
// over every triangle. The walks of kd-trees keep t as a float in their place: they need float.
// ALL_WALKS, WALKS_IN_<folder> and ALL_TRIANGLE_TESTS list them: define WALK(name) or
// TRIANGLE_TEST(name) first.
#include <mirror_walks.inc>

namespace raysteps::mirror {

// A walk with the arrays of the scene and of its structure. Both must outlive it.
template <class Mirror>
Mirror mirror_of(const SceneBuffers& scene, const PackedStructure& packed) {
    Mirror mirror = mirror_of<Mirror>(scene);
    mirror.read(packed);
    return mirror;
}

} // namespace raysteps::mirror
