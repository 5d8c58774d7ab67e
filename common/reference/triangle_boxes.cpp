#include "reference/triangle_boxes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raysteps {

namespace {

constexpr std::size_t few_triangles = 8;

// A difference of two floats in double is wrong by e = 2^-53 of itself, each product by e more, and
// so is their difference: by at most (3 + 3 e) e times the sum with absolute values. One e more
// pays for rounding the bound itself. Products of two such numbers do not underflow.
constexpr double cross_error_factor = 4.0 / 9007199254740992.0;

// A box as the ray's origin sees it.
struct SeenBox {
    glm::dvec3 lower;
    glm::dvec3 upper;
};

SeenBox seen(const Ray& ray, const Box& box, double grown_by) {
    const glm::dvec3 origin(ray.origin);
    const SeenBox exact{glm::dvec3(box.lower) - origin, glm::dvec3(box.upper) - origin};
    if (grown_by == 0.0) {
        return exact;
    }
    const glm::dvec3 sizes = glm::max(glm::abs(exact.lower), glm::abs(exact.upper));
    const glm::dvec3 room(grown_by * std::max({sizes.x, sizes.y, sizes.z}));
    return {exact.lower - room, exact.upper + room};
}

// Whether the line of the ray, seen along the third axis, surely passes beside the box: all four
// corners then lie on one side of it.
bool passes_beside(const Ray& ray, const SeenBox& box, int first, int second) {
    const double along_first = static_cast<double>(ray.direction[first]);
    const double along_second = static_cast<double>(ray.direction[second]);
    int sides = 0;
    for (const double x : {box.lower[first], box.upper[first]}) {
        for (const double y : {box.lower[second], box.upper[second]}) {
            const double a = along_first * y;
            const double b = along_second * x;
            const double error = cross_error_factor * (std::abs(a) + std::abs(b));
            sides += static_cast<int>(a - b > error) - static_cast<int>(a - b < -error);
        }
    }
    return std::abs(sides) == 4;
}

bool surely_misses_box(const Ray& ray, const SeenBox& box) {
    return passes_beside(ray, box, 0, 1) || passes_beside(ray, box, 1, 2) ||
           passes_beside(ray, box, 2, 0);
}

} // namespace

TriangleBoxes::TriangleBoxes(std::span<const glm::vec3> corners) : corners_(corners) {
    numbers_.resize(corners.size() / 3);
    std::iota(numbers_.begin(), numbers_.end(), 0);
    std::erase_if(numbers_, [&](int triangle) {
        const std::span all = corners_.subspan(3 * static_cast<std::size_t>(triangle), 3);
        return !std::all_of(all.begin(), all.end(),
                            [](const glm::vec3& corner) { return is_finite(corner); });
    });
    if (!numbers_.empty()) {
        add(0, numbers_.size());
    }
}

std::vector<int> TriangleBoxes::candidates(const Ray& ray, double grown_by) const {
    std::vector<int> found;
    for (std::size_t i = 0; i < nodes_.size();) {
        const Node& node = nodes_[i];
        if (surely_misses_box(ray, seen(ray, node.box, grown_by))) {
            i = node.next;
            continue;
        }
        if (node.next == i + 1) { // it has no halves
            found.insert(found.end(), numbers_.begin() + node.begin, numbers_.begin() + node.end);
        }
        ++i;
    }
    std::sort(found.begin(), found.end());
    return found;
}

Box TriangleBoxes::box_of(int triangle) const {
    return bounds_of(corners_.subspan(3 * static_cast<std::size_t>(triangle), 3));
}

void TriangleBoxes::add(std::size_t begin, std::size_t end) {
    const std::size_t own = nodes_.size();
    nodes_.push_back({{}, static_cast<std::ptrdiff_t>(begin), static_cast<std::ptrdiff_t>(end)});
    Box box;
    for (std::size_t i = begin; i < end; ++i) {
        box = merge(box, box_of(numbers_[i]));
    }
    nodes_[own].box = box;
    if (end - begin > few_triangles) {
        const std::size_t middle = begin + (end - begin) / 2;
        halve(box, begin, middle, end);
        add(begin, middle);
        add(middle, end);
    }
    nodes_[own].next = nodes_.size();
}

void TriangleBoxes::halve(const Box& box, std::size_t begin, std::size_t middle, std::size_t end) {
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

} // namespace raysteps
