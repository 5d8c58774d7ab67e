#pragma once

#include "scene/mesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <filesystem>
#include <map>
#include <vector>

namespace raysteps {

inline const std::filesystem::path scene_files =
    std::filesystem::path(RAYSTEPS_SOURCE_DIR) / "tests/modules/scene/files";

// How many edges of triangles have no partner: the same edge of another triangle, run through in
// the opposite direction, with corners of the same bits (-0 counts as 0). A closed mesh has none.
inline int count_open_edges(const std::vector<glm::vec3>& corners) {
    using Edge = std::array<float, 6>;
    std::map<Edge, int> surplus; // edges in this direction less those in the other
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 from = corners[i];
        const glm::vec3 to = corners[i % 3 == 2 ? i - 2 : i + 1];
        const Edge edge{from.x, from.y, from.z, to.x, to.y, to.z};
        const Edge opposite{to.x, to.y, to.z, from.x, from.y, from.z};
        if (edge < opposite) {
            ++surplus[edge];
        } else {
            --surplus[opposite];
        }
    }
    int open = 0;
    for (const auto& [edge, count] : surplus) {
        open += count < 0 ? -count : count;
    }
    return open;
}

// The volume, by the divergence theorem; positive where the fronts are outside.
inline double signed_volume(const std::vector<glm::vec3>& corners) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const glm::dvec3 a(corners[i]);
        const glm::dvec3 b(corners[i + 1]);
        const glm::dvec3 c(corners[i + 2]);
        sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
               a.z * (b.x * c.y - b.y * c.x);
    }
    return sum / 6.0;
}

} // namespace raysteps
