#include "hard_cases/lattice_rays.h"

namespace raysteps {

Lattice lattice_of(const GridShape& shape) {
    return {shape.lower, shape.cell_size, shape.cells};
}

glm::vec3 any_lattice_point(RandomNumbers& numbers, const Lattice& lattice) {
    glm::vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<float>(numbers.below(lattice.cells[axis] + 1));
        point[axis] = lattice.lower[axis] + lattice.step[axis] * i;
    }
    return point;
}

std::vector<Ray> rays_through_lattice_points(RandomNumbers& numbers, const Lattice& lattice,
                                             int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 from = any_lattice_point(numbers, lattice);
        const glm::vec3 along = any_lattice_point(numbers, lattice) - from;
        rays.push_back({from - along, along, 0.0f, no_end});
    }
    return rays;
}

std::vector<Ray> rays_in_lattice_planes(RandomNumbers& numbers, const Lattice& lattice, int count) {
    const glm::vec3 size = lattice.step * glm::vec3(lattice.cells);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const int axis = numbers.below(3);
        glm::vec3 origin = point_in_box(numbers, {lattice.lower, lattice.lower + size});
        origin[axis] = any_lattice_point(numbers, lattice)[axis];
        glm::vec3 direction = size * numbers.in_cube();
        direction[axis] = 0.0f;
        rays.push_back({origin, direction, -1.0f, no_end});
    }
    return rays;
}

std::vector<RayFamily> lattice_families(RandomNumbers& numbers, const Lattice& lattice, int count) {
    const std::vector<Ray> through = rays_through_lattice_points(numbers, lattice, count);
    return {{"through lattice points", through},
            {"back through lattice points", reversed(through)},
            {"in lattice planes", rays_in_lattice_planes(numbers, lattice, count)}};
}

} // namespace raysteps
