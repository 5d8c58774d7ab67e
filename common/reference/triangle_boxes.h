#pragma once

#include "basics/box.h"
#include "basics/ray.h"

#include <cstddef>
#include <span>
#include <vector>

namespace raysteps {

// Boxes of triangles, halved by their middles until few are left: no structure of those that are
// judged, and no distance decides anything here. Only what a line surely misses is left out.
// Triangles with corners that are not finite are in none.
class TriangleBoxes {
public:
    explicit TriangleBoxes(std::span<const glm::vec3> corners);

    // The triangles in boxes that the ray's line may meet, in ascending order. Each box is grown by
    // that share of its reach, the largest coordinate of a corner minus the origin.
    std::vector<int> candidates(const Ray& ray, double grown_by = 0.0) const;

private:
    struct Node {
        Box box;
        std::ptrdiff_t begin = 0; // of its triangles
        std::ptrdiff_t end = 0;
        std::size_t next = 0; // behind all nodes in it
    };

    Box box_of(int triangle) const;
    void add(std::size_t begin, std::size_t end);
    void halve(const Box& box, std::size_t begin, std::size_t middle, std::size_t end);

    std::span<const glm::vec3> corners_;
    std::vector<int> numbers_;
    std::vector<Node> nodes_;
};

} // namespace raysteps
