#include "reference/allowed_answers.h"

#include "reference/exact.h"
#include "reference/integer3.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace raysteps {

namespace {

// A hit lies within 2^-19 of the reach of its triangle along each axis (docs/numerics.md, section
// 1, has 23 of these 32 e). All lengths are multiplied by 2^19, so that the room is a whole number.
constexpr unsigned room_bits = 19;

Integer sum_of_sizes(const Integer3& a) {
    return abs(a[0]) + abs(a[1]) + abs(a[2]);
}

struct ExactRange {
    Fraction least;
    Fraction most;
};

using SeenTriangle = std::array<Integer3, 3>; // seen from the ray's origin

Integer reach_of(const SeenTriangle& triangle) {
    Integer reach = 0;
    for (const Integer3& corner : triangle) {
        for (const Integer& component : corner) {
            reach = std::max(reach, Integer(abs(component)));
        }
    }
    return reach;
}

// The part of a ray within the room of a triangle: the triangle, grown by a cube, is the polyhedron
// between pairs of planes across the axes, the triangle's normal, and edges times axes.
class GrownTriangle {
public:
    GrownTriangle(const SeenTriangle& triangle, const Integer3& direction, const Integer& reach)
        : triangle_(triangle), direction_(direction), reach_(reach) {}

    std::optional<ExactRange> range() {
        const Integer3 a = difference(triangle_[1], triangle_[0]);
        const Integer3 b = difference(triangle_[2], triangle_[1]);
        const Integer3 c = difference(triangle_[0], triangle_[2]);
        for (int axis = 0; axis < 3; ++axis) {
            Integer3 unit{0, 0, 0};
            unit[axis] = 1;
            cut(unit);
            for (const Integer3& edge : {a, b, c}) {
                cut(cross(edge, unit));
            }
        }
        cut(cross(a, b));
        if (is_empty_ || !range_) {
            return std::nullopt;
        }
        return range_;
    }

private:
    void cut(const Integer3& normal) {
        if (is_empty_) {
            return;
        }
        const Integer room = reach_ * sum_of_sizes(normal);
        std::array<Integer, 3> places{dot(normal, triangle_[0]), dot(normal, triangle_[1]),
                                      dot(normal, triangle_[2])};
        const auto [low, high] = std::minmax_element(places.begin(), places.end());
        const Integer first = (*low << room_bits) - room;
        const Integer last = (*high << room_bits) + room;
        const Integer along = dot(normal, direction_) << room_bits;
        if (along == 0) {
            is_empty_ = first > 0 || last < 0;
            return;
        }
        Fraction least = with_positive_denominator(along > 0 ? first : last, along);
        Fraction most = with_positive_denominator(along > 0 ? last : first, along);
        if (!range_) {
            range_ = {std::move(least), std::move(most)};
            return;
        }
        if (is_less(range_->least, least)) {
            range_->least = std::move(least);
        }
        if (is_less(most, range_->most)) {
            range_->most = std::move(most);
        }
        is_empty_ = is_less(range_->most, range_->least);
    }

    const SeenTriangle& triangle_;
    const Integer3& direction_;
    const Integer& reach_;
    std::optional<ExactRange> range_;
    bool is_empty_ = false;
};

Fraction fraction_of(float value) {
    return {in_units(value), in_units(1.0f)};
}

constexpr float largest = std::numeric_limits<float>::max();

float float_at_least(const Fraction& value) {
    auto rounded = static_cast<float>(nearest_double(value));
    rounded = std::clamp(rounded, -largest, largest);
    while (std::isfinite(rounded) && is_less(fraction_of(rounded), value)) {
        rounded = std::nextafter(rounded, std::numeric_limits<float>::infinity());
    }
    return rounded;
}

float float_at_most(const Fraction& value) {
    return -float_at_least({-value.numerator, value.denominator});
}

// The triangle in the plane across the ray's main axis, along the ray: the ray is the origin. In
// double, which is off by far less than the room.
bool is_surely_far(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 sizes = glm::abs(direction);
    const int along = sizes.x >= sizes.y && sizes.x >= sizes.z ? 0 : sizes.y >= sizes.z ? 1 : 2;
    const int first = (along + 1) % 3;
    const int second = (along + 2) % 3;
    double reach = 0.0;
    std::array<glm::dvec2, 3> flat;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3& corner = i == 0 ? a : i == 1 ? b : c;
        const glm::dvec3 size = glm::abs(corner);
        reach = std::max({reach, size.x, size.y, size.z});
        flat[i] = {corner[first] - corner[along] * (direction[first] / direction[along]),
                   corner[second] - corner[along] * (direction[second] / direction[along])};
    }
    const double room = 0x1p-17 * reach; // twice what a cube of the room comes to
    const auto is_aside = [&](const glm::dvec2& normal) {
        const double beyond = room * (std::abs(normal.x) + std::abs(normal.y));
        const std::array places{glm::dot(normal, flat[0]), glm::dot(normal, flat[1]),
                                glm::dot(normal, flat[2])};
        const auto [low, high] = std::minmax_element(places.begin(), places.end());
        return *low > beyond || *high < -beyond;
    };
    const auto across = [](const glm::dvec2& edge) { return glm::dvec2(edge.y, -edge.x); };
    return is_aside({1.0, 0.0}) || is_aside({0.0, 1.0}) || is_aside(across(flat[1] - flat[0])) ||
           is_aside(across(flat[2] - flat[1])) || is_aside(across(flat[0] - flat[2]));
}

using Point2 = std::array<Integer, 2>;

// Along the ray, so that the ray is the origin.
Point2 seen_along(const Integer3& corner, const Integer3& direction) {
    const Integer3 sizes{abs(direction[0]), abs(direction[1]), abs(direction[2])};
    const int along = sizes[0] >= sizes[1] && sizes[0] >= sizes[2] ? 0
                      : sizes[1] >= sizes[2]                       ? 1
                                                                   : 2;
    const int first = (along + 1) % 3;
    const int second = (along + 2) % 3;
    return {direction[along] * corner[first] - direction[first] * corner[along],
            direction[along] * corner[second] - direction[second] * corner[along]};
}

// What the edge from p to q adds to how often a border runs around the origin.
int turns(const Point2& p, const Point2& q) {
    const bool before = p[1] < 0;
    const bool behind = q[1] < 0;
    if (before == behind) {
        return 0;
    }
    const Integer side = p[0] * q[1] - q[0] * p[1];
    return before ? (side > 0 ? 1 : 0) : (side < 0 ? -1 : 0);
}

} // namespace

struct AnswerRules::NearTriangle {
    std::int32_t number = 0;
    SeenTriangle triangle;
    Integer3 direction;
    Integer reach;
    ExactRange range;
    std::array<Point2, 3> flat;
    std::array<bool, 3> near_edges{}; // from corner i to the next
};

AnswerRules::AnswerRules(std::span<const glm::vec3> corners) : corners_(corners) {
    std::map<std::tuple<float, float, float>, std::int32_t> numbers;
    for (const glm::vec3& corner : corners) {
        const auto next = static_cast<std::int32_t>(numbers.size());
        points_.push_back(numbers.try_emplace({corner.x, corner.y, corner.z}, next).first->second);
    }
}

std::vector<AnswerRules::NearTriangle> AnswerRules::near_triangles(const Ray& ray) const {
    std::vector<NearTriangle> near;
    const glm::dvec3 from(ray.origin);
    const Integer3 origin = point_in_units(ray.origin);
    const Integer3 direction = point_in_units(ray.direction);
    for (std::size_t first = 0; first + 2 < corners_.size(); first += 3) {
        const std::array seen{glm::dvec3(corners_[first]) - from,
                              glm::dvec3(corners_[first + 1]) - from,
                              glm::dvec3(corners_[first + 2]) - from};
        if (is_surely_far(ray, seen[0], seen[1], seen[2])) {
            continue;
        }
        NearTriangle one;
        one.number = static_cast<std::int32_t>(first / 3);
        one.direction = direction;
        for (int i = 0; i < 3; ++i) {
            one.triangle[i] = difference(point_in_units(corners_[first + i]), origin);
            one.flat[i] = seen_along(one.triangle[i], direction);
        }
        one.reach = reach_of(one.triangle);
        const auto range = GrownTriangle(one.triangle, direction, one.reach).range();
        if (!range) {
            continue;
        }
        one.range = *range;
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            if (!is_surely_far(ray, seen[i], seen[next], seen[next])) {
                const SeenTriangle edge{one.triangle[i], one.triangle[next], one.triangle[next]};
                one.near_edges[i] = GrownTriangle(edge, direction, one.reach).range().has_value();
            }
        }
        near.push_back(std::move(one));
    }
    return near;
}

namespace {

// Numbers in sets that grow together.
class GrowingSets {
public:
    explicit GrowingSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }

    std::size_t group_of(std::size_t one) const {
        while (parents_[one] != one) {
            one = parents_[one];
        }
        return one;
    }

    void join(std::size_t one, std::size_t other) { parents_[group_of(one)] = group_of(other); }

private:
    std::vector<std::size_t> parents_;
};

// An edge of near triangles, from the smaller point to the larger one.
struct BorderEdge {
    int count = 0; // how often it is followed, less how often it is followed back
    bool is_near = false;
    Point2 from;
    Point2 to;
    std::size_t triangle = 0; // any one that has it
};

bool lies_in(const ExactRange& range, const Ray& ray) {
    const float last = std::min(ray.t_max, largest);
    const float first = std::max(ray.t_min, -largest);
    return !is_less(range.least, fraction_of(first)) && !is_less(fraction_of(last), range.most);
}

} // namespace

// Triangles that share edges are one patch. Its border is what edges are left when those that are
// followed there and back cancel out. Where the border is nowhere near the ray and runs around it,
// the ray meets the patch, however its corners move within the room. `facing` turns all triangles
// towards the ray first, and takes one of several with the same corners.
void AnswerRules::find_sure_hits(const Ray& ray, std::span<const NearTriangle> near, bool facing,
                                 AllowedAnswer& answer) const {
    GrowingSets patches(near.size());
    std::map<std::pair<std::int32_t, std::int32_t>, BorderEdge> edges;
    std::map<std::array<std::int32_t, 3>, std::size_t> known;
    for (std::size_t n = 0; n < near.size(); ++n) {
        const NearTriangle& one = near[n];
        const auto first = 3 * static_cast<std::size_t>(one.number);
        const std::array points{points_[first], points_[first + 1], points_[first + 2]};
        int sign = 1;
        if (facing) {
            std::array sorted = points;
            std::sort(sorted.begin(), sorted.end());
            const auto [same, is_new] = known.try_emplace(sorted, n);
            if (!is_new) {
                patches.join(n, same->second);
                continue;
            }
            const Integer volume =
                (one.flat[1][0] - one.flat[0][0]) * (one.flat[2][1] - one.flat[0][1]) -
                (one.flat[1][1] - one.flat[0][1]) * (one.flat[2][0] - one.flat[0][0]);
            sign = volume < 0 ? -1 : 1;
        }
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            const bool up = points[i] < points[next];
            const auto [place, is_new] =
                edges.try_emplace(std::minmax(points[i], points[next]), BorderEdge{});
            BorderEdge& edge = place->second;
            if (is_new) {
                edge.from = one.flat[up ? i : next];
                edge.to = one.flat[up ? next : i];
                edge.triangle = n;
            }
            edge.count += points[i] == points[next] ? 0 : up ? sign : -sign;
            edge.is_near = edge.is_near || one.near_edges[i];
            patches.join(n, edge.triangle);
        }
    }
    std::vector<int> around(near.size(), 0);
    std::vector<bool> is_sure(near.size(), true);
    for (const auto& [points, edge] : edges) {
        if (edge.count != 0) {
            const std::size_t patch = patches.group_of(edge.triangle);
            around[patch] += edge.count * turns(edge.from, edge.to);
            is_sure[patch] = is_sure[patch] && !edge.is_near;
        }
    }
    std::map<std::size_t, Fraction> ends;
    for (std::size_t n = 0; n < near.size(); ++n) {
        const std::size_t patch = patches.group_of(n);
        is_sure[patch] = is_sure[patch] && lies_in(near[n].range, ray);
        const auto [end, is_new] = ends.try_emplace(patch, near[n].range.most);
        if (!is_new && is_less(end->second, near[n].range.most)) {
            end->second = near[n].range.most;
        }
    }
    for (const auto& [patch, end] : ends) {
        if (!is_sure[patch] || around[patch] == 0) {
            continue;
        }
        answer.miss = false;
        std::erase_if(answer.hits, [&](const AllowedHit& hit) {
            return is_less(end, fraction_of(hit.t_least));
        });
    }
}

AllowedAnswer AnswerRules::allowed(const Ray& ray, Origin origin) const {
    if (!is_usable(ray) || ray.direction == glm::vec3(0.0f)) {
        return {.miss = true, .anything = true};
    }
    AllowedAnswer answer{.miss = origin == Origin::anywhere};
    const std::vector<NearTriangle> near = near_triangles(ray);
    for (const NearTriangle& one : near) {
        const float least = std::max(float_at_least(one.range.least), ray.t_min);
        const float most = std::min({float_at_most(one.range.most), ray.t_max, largest});
        if (least <= most) {
            answer.hits.push_back({one.number, least, most});
        }
    }
    for (const NearTriangle& one : near) { // each by itself, then together
        find_sure_hits(ray, {&one, 1}, false, answer);
    }
    find_sure_hits(ray, near, false, answer);
    find_sure_hits(ray, near, true, answer);
    return answer;
}

} // namespace raysteps
