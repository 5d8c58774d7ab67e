#include "hard_cases/leak_rays.h"

namespace raysteps {

std::vector<Ray> edge_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                 int count) {
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const glm::vec3 target = point_on_edge(numbers, mesh.corners);
        const glm::vec3 origin = half * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> corner_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                   int count) {
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const glm::vec3 target = mesh.corners[any_corner(numbers, mesh.corners)];
        const glm::vec3 origin = half * numbers.in_cube();
        rays.push_back({origin, target - origin, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> random_rays_from_inside(RandomNumbers& numbers, const glm::vec3& half, int count) {
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = half * numbers.in_cube();
        rays.push_back({origin, numbers.in_cube(), 0.0f, no_end});
    }
    return rays;
}

} // namespace raysteps
