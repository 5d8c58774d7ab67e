#include "reference/exact_mesh.h"

#include "basics/threads.h"
#include "reference/triangle_boxes.h"

#include <cmath>
#include <cstddef>

namespace raysteps {

namespace {

using Corners = std::array<glm::vec3, 3>;

Corners corners_of(std::span<const glm::vec3> corners, int triangle) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return {corners[first], corners[first + 1], corners[first + 2]};
}

// Triangles that the ray may meet are asked without rounding, in the order of their numbers.
class NearestHit {
public:
    explicit NearestHit(const Ray& ray) : ray_(ray), nearest_{.t = ray.t_max} {}

    void ask(int number, const Corners& triangle) {
        const ExactSolution solution = solve_exactly(ray_, triangle);
        // Of equal t the first, and so the smallest, index stays.
        if (is_hit(solution, ray_) && (!solution_.unique || is_less(solution.t, solution_.t))) {
            solution_ = solution;
            nearest_.triangle = number;
        }
    }

    ReferenceHit found() const {
        if (nearest_.triangle == no_triangle) {
            return nearest_;
        }
        return {nearest_double(solution_.t), nearest_double(solution_.u),
                nearest_double(solution_.v), nearest_.triangle};
    }

private:
    const Ray& ray_;
    ReferenceHit nearest_;
    ExactSolution solution_;
};

// Asks each triangle that `is_candidate` lets pass.
template <class Filter>
ReferenceHit nearest_of(const Ray& ray, std::span<const glm::vec3> corners,
                        const Filter& is_candidate) {
    NearestHit nearest(ray);
    for (int i = 0; is_usable(ray) && 3 * static_cast<std::size_t>(i) + 2 < corners.size(); ++i) {
        const Corners triangle = corners_of(corners, i);
        if (is_finite(triangle) && is_candidate(ray, triangle)) {
            nearest.ask(i, triangle);
        }
    }
    return nearest.found();
}

} // namespace

ReferenceHit exact_nearest_hit(const Ray& ray, std::span<const glm::vec3> corners) {
    return nearest_of(ray, corners, [](const Ray& line, const Corners& triangle) {
        return !surely_misses(line, triangle);
    });
}

ReferenceHit exact_nearest_hit_unfiltered(const Ray& ray, std::span<const glm::vec3> corners) {
    return nearest_of(ray, corners, [](const Ray&, const Corners&) { return true; });
}

namespace {

ReferenceHit nearest_in(const TriangleBoxes& boxes, const Ray& ray,
                        std::span<const glm::vec3> corners) {
    NearestHit nearest(ray);
    if (!is_usable(ray)) {
        return nearest.found();
    }
    for (const int number : boxes.candidates(ray)) {
        const Corners triangle = corners_of(corners, number);
        if (!surely_misses(ray, triangle)) {
            nearest.ask(number, triangle);
        }
    }
    return nearest.found();
}

constexpr std::size_t fewest_for_boxes = 32; // rays: making the boxes takes about as long

} // namespace

ExactMesh::ExactMesh(std::span<const glm::vec3> corners) : corners_(corners) {}
ExactMesh::ExactMesh(const std::vector<glm::vec3>& corners) : corners_(corners) {}
ExactMesh::~ExactMesh() = default;

std::vector<ReferenceHit> ExactMesh::nearest_hits(std::span<const Ray> rays) const {
    std::vector<ReferenceHit> hits(rays.size());
    if (rays.size() < fewest_for_boxes) {
        on_threads(all_cores, rays.size(),
                   [&](std::size_t i) { hits[i] = exact_nearest_hit(rays[i], corners_); });
        return hits;
    }
    std::call_once(made_, [&] { boxes_ = std::make_unique<const TriangleBoxes>(corners_); });
    on_threads(all_cores, rays.size(),
               [&](std::size_t i) { hits[i] = nearest_in(*boxes_, rays[i], corners_); });
    return hits;
}

std::vector<ReferenceHit> exact_nearest_hits(std::span<const Ray> rays,
                                             std::span<const glm::vec3> corners) {
    return ExactMesh(corners).nearest_hits(rays);
}

} // namespace raysteps
