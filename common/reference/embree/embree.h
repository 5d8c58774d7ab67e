#pragma once

#include "basics/box.h"
#include "basics/ray.h"
#include "basics/threads.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// Whether Embree takes part, and in which of its modes.
enum class EmbreePart { none, fast, robust };

// off, fast or robust; auto is robust where this program was built with Embree, else off. Throws
// InputError for another word, and MachineError where Embree is asked for and missing.
EmbreePart parse_embree(const std::string& text);

// `Embree 3.13.5`; empty where this program was built without it.
std::string embree_name();

// How Embree tests boxes and triangles: as fast as it can, or so that no ray slips through an edge.
enum class EmbreeMode { fast, robust };

// How rays are given to Embree.
enum class EmbreeCall {
    one_by_one, // rtcIntersect1 and rtcOccluded1
    packets,    // rtcIntersect8 and rtcOccluded8, of eight rays that follow one another
};

// Triangles in Embree, the ray tracer for CPUs of Wald, Woop, Benthin, Johnson and Ernst, "Embree:
// A Kernel Framework for Efficient CPU Ray Tracing", 2014. Rays need t_min >= 0. Of triangles that
// are equally near, any one may be found.
class EmbreeScene {
public:
    // Three corners per triangle. Throws MachineError where Embree is missing, or fails.
    EmbreeScene(std::span<const glm::vec3> corners, EmbreeMode mode);
    ~EmbreeScene();
    EmbreeScene(EmbreeScene&&) noexcept;
    EmbreeScene& operator=(EmbreeScene&&) noexcept;

    Hit nearest_hit(const Ray& ray) const;

    // The nearest hit of each ray.
    std::vector<Hit> nearest_hits(std::span<const Ray> rays, EmbreeCall call,
                                  unsigned threads = all_cores) const;

    // For each ray 1 where it hits anything, else 0.
    std::vector<std::uint8_t> any_hits(std::span<const Ray> rays, EmbreeCall call,
                                       unsigned threads = all_cores) const;

    // What committing the scene took: Embree's building.
    double build_seconds() const;

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

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

// A node of such a tree: with two children, or without any and with the triangles
// [first, first + count) of the list.
struct EmbreeNode {
    Box box;
    std::array<std::int32_t, 2> children{-1, -1};
    std::int32_t first = 0;
    std::int32_t count = 0;
};

struct EmbreeNodes {
    std::vector<EmbreeNode> nodes; // the root is node 0
    std::vector<std::int32_t> triangles;
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

    // The nodes of what was built last.
    EmbreeNodes nodes() const;

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

} // namespace raysteps
