#pragma once

#include "geometry/box.h"

#include <cstddef>
#include <memory>
#include <span>

namespace raysteps {

// What a tree is built for: see BvhOptions.
struct EmbreeTreeOptions {
    int leaf_triangles = 1;
    double traversal_cost = 1.0;
    double intersection_cost = 1.0;
};

// What came of it.
struct EmbreeTree {
    std::size_t inner_nodes = 0;
    std::size_t leaves = 0;
    std::size_t triangles = 0; // in all leaves
};

// Embree's builder for structures of one's own, rtcBuildBVH: a binary tree at medium quality
// (binned SAH), on one thread.
class EmbreeBuilder {
public:
    // The boxes of the triangles. Throws MachineError where Embree is missing, or fails.
    EmbreeBuilder(std::span<const Box> boxes, const EmbreeTreeOptions& options);
    ~EmbreeBuilder();
    EmbreeBuilder(const EmbreeBuilder&) = delete;
    EmbreeBuilder& operator=(const EmbreeBuilder&) = delete;

    // Gets ready what the next tree is built from, which building overwrites.
    void prepare();

    // Once for each time that it was prepared. Throws MachineError where Embree fails.
    EmbreeTree build();

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

} // namespace raysteps
