#pragma once

#include "reference/exact.h"

#include <memory>
#include <mutex>

namespace raysteps {

class TriangleBoxes;

// Triangles that are asked again and again: the boxes around them, which spare most of them the
// exact arithmetic, are made once, for the first question of many rays. The corners must outlive
// it.
class ExactMesh {
public:
    ExactMesh(std::span<const glm::vec3> corners);
    ExactMesh(const std::vector<glm::vec3>& corners);
    ~ExactMesh();
    ExactMesh(const ExactMesh&) = delete;
    ExactMesh& operator=(const ExactMesh&) = delete;

    std::span<const glm::vec3> corners() const { return corners_; }

    // exact_nearest_hit of each ray, on all cores.
    std::vector<ReferenceHit> nearest_hits(std::span<const Ray> rays) const;

private:
    std::span<const glm::vec3> corners_;
    mutable std::once_flag made_;
    mutable std::unique_ptr<const TriangleBoxes> boxes_;
};

} // namespace raysteps
