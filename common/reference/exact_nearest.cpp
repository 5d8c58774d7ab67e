#include "reference/exact_mesh.h"

#include "basics/box.h"
#include "basics/threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace raysteps {

namespace {

using Corners = std::array<glm::vec3, 3>;

Corners corners_of(std::span<const glm::vec3> corners, int triangle) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return {corners[first], corners[first + 1], corners[first + 2]};
}

bool is_finite(const glm::vec3& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

bool is_finite(const Corners& triangle) {
    return is_finite(triangle[0]) && is_finite(triangle[1]) && is_finite(triangle[2]);
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

// A difference of two floats in double is wrong by e = 2^-53 of itself, each product by e more, and
// so is their difference: by at most (3 + 3 e) e times the sum with absolute values. One e more
// pays for rounding the bound itself. Products of two such numbers do not underflow.
constexpr double error_factor = 4.0 / 9007199254740992.0;

// Whether the line of the ray, seen along the third axis, surely passes beside the box: all four
// corners then lie on one side of it.
bool passes_beside(const Ray& ray, const Box& box, int first, int second) {
    const double along_first = static_cast<double>(ray.direction[first]);
    const double along_second = static_cast<double>(ray.direction[second]);
    int sides = 0;
    for (const float x : {box.lower[first], box.upper[first]}) {
        for (const float y : {box.lower[second], box.upper[second]}) {
            const double a =
                along_first * (static_cast<double>(y) - static_cast<double>(ray.origin[second]));
            const double b =
                along_second * (static_cast<double>(x) - static_cast<double>(ray.origin[first]));
            const double error = error_factor * (std::abs(a) + std::abs(b));
            sides += static_cast<int>(a - b > error) - static_cast<int>(a - b < -error);
        }
    }
    return std::abs(sides) == 4;
}

bool surely_misses_box(const Ray& ray, const Box& box) {
    return passes_beside(ray, box, 0, 1) || passes_beside(ray, box, 1, 2) ||
           passes_beside(ray, box, 2, 0);
}

} // namespace

// Boxes of triangles, halved by their middles until few are left: no structure of those that are
// judged, and no distance decides anything here. Only what a line surely misses is left out.
class TriangleBoxes {
public:
    explicit TriangleBoxes(std::span<const glm::vec3> corners) : corners_(corners) {
        numbers_.resize(corners.size() / 3);
        std::iota(numbers_.begin(), numbers_.end(), 0);
        std::erase_if(numbers_,
                      [&](int triangle) { return !is_finite(corners_of(corners_, triangle)); });
        if (!numbers_.empty()) {
            add(0, numbers_.size());
        }
    }

    // The triangles in boxes that the ray's line may meet, in ascending order.
    std::vector<int> candidates(const Ray& ray) const {
        std::vector<int> found;
        for (std::size_t i = 0; i < nodes_.size();) {
            const Node& node = nodes_[i];
            if (surely_misses_box(ray, node.box)) {
                i = node.next;
                continue;
            }
            if (node.next == i + 1) { // it has no halves
                found.insert(found.end(), numbers_.begin() + node.begin,
                             numbers_.begin() + node.end);
            }
            ++i;
        }
        std::sort(found.begin(), found.end());
        return found;
    }

private:
    struct Node {
        Box box;
        std::ptrdiff_t begin = 0; // of its triangles
        std::ptrdiff_t end = 0;
        std::size_t next = 0; // behind all nodes in it
    };

    static constexpr std::size_t few = 8;

    Box box_of(int triangle) const {
        const Corners corners = corners_of(corners_, triangle);
        return bounds_of(corners);
    }

    void add(std::size_t begin, std::size_t end) {
        const std::size_t own = nodes_.size();
        nodes_.push_back(
            {{}, static_cast<std::ptrdiff_t>(begin), static_cast<std::ptrdiff_t>(end)});
        Box box;
        for (std::size_t i = begin; i < end; ++i) {
            box = merge(box, box_of(numbers_[i]));
        }
        nodes_[own].box = box;
        if (end - begin > few) {
            const std::size_t middle = begin + (end - begin) / 2;
            halve(box, begin, middle, end);
            add(begin, middle);
            add(middle, end);
        }
        nodes_[own].next = nodes_.size();
    }

    void halve(const Box& box, std::size_t begin, std::size_t middle, std::size_t end) {
        const glm::dvec3 sides = glm::dvec3(box.upper) - glm::dvec3(box.lower);
        const int axis =
            sides.x >= sides.y ? (sides.x >= sides.z ? 0 : 2) : (sides.y >= sides.z ? 1 : 2);
        const auto place_of = [&](int triangle) {
            const Box own = box_of(triangle);
            return static_cast<double>(own.lower[axis]) + static_cast<double>(own.upper[axis]);
        };
        const auto first = numbers_.begin();
        std::nth_element(first + static_cast<std::ptrdiff_t>(begin),
                         first + static_cast<std::ptrdiff_t>(middle),
                         first + static_cast<std::ptrdiff_t>(end),
                         [&](int a, int b) { return place_of(a) < place_of(b); });
    }

    std::span<const glm::vec3> corners_;
    std::vector<int> numbers_;
    std::vector<Node> nodes_;
};

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
