#pragma once

#include "basics/ray.h"
#include "reference/near_triangle.h"
#include "reference/triangle_boxes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace raysteps {

// What a ray tracer may answer to a ray, as docs/conformance/README.md defines it: computed without
// rounding, so the same on every machine.

// A triangle that may be named, with the least and the greatest float that t may be.
struct AllowedHit {
    std::int32_t triangle = no_triangle;
    float t_least = 0.0f;
    float t_most = 0.0f;

    bool operator==(const AllowedHit&) const = default;
};

struct AllowedAnswer {
    bool miss = false;
    bool anything = false; // the ray is none: any answer will do that is one
    std::vector<AllowedHit> hits{};
};

// Who asks about all rays of a mesh. Corners are finite, three per triangle.
class AnswerRules {
public:
    explicit AnswerRules(std::span<const glm::vec3> corners,
                         Arithmetic arithmetic = Arithmetic::filtered);

    // From inside a closed mesh a ray must hit whatever comes.
    enum class Origin { anywhere, inside };

    AllowedAnswer allowed(const Ray& ray, Origin origin) const;

private:
    struct Patches;

    std::vector<NearTriangle> near_triangles(const Ray& ray) const;
    Patches patches_of(std::span<NearTriangle> near, bool facing) const;
    void find_sure_hits(const Ray& ray, std::span<NearTriangle> near, bool facing,
                        AllowedAnswer& answer) const;

    std::span<const glm::vec3> corners_;
    Arithmetic arithmetic_;
    TriangleBoxes boxes_;
    std::vector<std::int32_t> points_; // of each corner: equal corners have equal numbers
};

} // namespace raysteps
