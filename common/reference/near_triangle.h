#pragma once

#include "reference/bounded.h"
#include "reference/exact.h"

#include <array>
#include <cstdint>
#include <optional>

namespace raysteps {

// What decides: doubles where they can, or exact arithmetic alone, which is slow and checks them.
// The answers are the same.
enum class Arithmetic { filtered, exact };

struct ExactRange {
    Fraction least;
    Fraction most;
};

// A triangle and the line of a ray: the part of the line that lies within the triangle's room
// (docs/conformance/README.md, rule 1), and how the triangle's edges run around the line. The ray
// is usable, has a direction, and outlives this.
class NearTriangle {
public:
    NearTriangle(std::int32_t number, const Ray& ray, const std::array<glm::vec3, 3>& corners,
                 Arithmetic arithmetic);

    std::int32_t number() const { return number_; }

    // Whether any part of the line is in the room. All that is below is told only if so.
    bool is_near();

    // The least and the greatest float of that part.
    float least();
    float most();

    bool begins_before(float t);
    bool ends_before(float t);
    bool ends_behind(float t);

    // Whether the line comes within the room of the edge from that corner to the next.
    bool is_edge_near(int corner);

    // Seen along the ray, what the way from one corner to the other adds to how often a border runs
    // around the ray.
    int turns(int from, int to);

    // Whether the corners run clockwise, seen along the ray.
    bool is_clockwise();

private:
    using Point2 = std::array<Integer, 2>;

    struct InIntegers {
        Integer3 direction;
        std::array<Integer3, 3> corners; // from the origin
        Integer reach;
        std::array<Point2, 3> flat; // along the ray, so that the ray is the origin
    };

    const InIntegers& integers();
    const ExactRange& exact_range();
    int compare(const Between& bounds, float t, Fraction ExactRange::*end);
    int sign_of_height(int corner);

    std::int32_t number_;
    const Ray* ray_;
    std::array<glm::vec3, 3> corners_;
    Arithmetic arithmetic_;
    BoundedPoint direction_;
    std::array<BoundedPoint, 3> seen_; // from the origin
    Bounded reach_;
    std::array<std::array<Bounded, 2>, 3> flat_;
    Between least_;
    Between most_;
    std::optional<InIntegers> integers_;
    std::optional<ExactRange> exact_range_;
};

} // namespace raysteps
