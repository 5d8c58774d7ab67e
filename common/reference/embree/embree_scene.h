#pragma once

#include "geometry/layout.h"
#include "parallel/on_threads.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

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
    // Three corners a triangle. Throws MachineError where Embree is missing, or fails.
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

} // namespace raysteps
