#include "reference/near_triangle.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace raysteps {

namespace {

// A hit lies within 2^-19 of the reach of its triangle along each axis (docs/numerics.md, section
// 1, has 23 of these 32 e). For integers all lengths are multiplied by 2^19, so that the room is a
// whole number.
constexpr unsigned room_bits = 19;
constexpr double room_share = 0x1p-19;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr Bounded unknown{0.0, endless};

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

// The part of a ray within the room of a triangle: the triangle, grown by a cube, is the polyhedron
// between pairs of planes across the axes, the triangle's normal, and edges times axes. It is
// computed twice: by integers, and in doubles as far as these can know it.

struct WholeTriangle {
    const std::array<Integer3, 3>& corners;
    const Integer3& direction;
    const Integer& reach;
};

class ExactPart {
public:
    explicit ExactPart(const WholeTriangle& triangle) : triangle_(triangle) {}

    std::optional<ExactRange> range() {
        const auto& corners = triangle_.corners;
        const Integer3 a = difference(corners[1], corners[0]);
        const Integer3 b = difference(corners[2], corners[1]);
        const Integer3 c = difference(corners[0], corners[2]);
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
        const Integer room = triangle_.reach * (abs(normal[0]) + abs(normal[1]) + abs(normal[2]));
        const std::array<Integer, 3> places{dot(normal, triangle_.corners[0]),
                                            dot(normal, triangle_.corners[1]),
                                            dot(normal, triangle_.corners[2])};
        const auto [low, high] = std::minmax_element(places.begin(), places.end());
        const Integer first = (*low << room_bits) - room;
        const Integer last = (*high << room_bits) + room;
        const Integer along = dot(normal, triangle_.direction) << room_bits;
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

    WholeTriangle triangle_;
    std::optional<ExactRange> range_;
    bool is_empty_ = false;
};

enum class Known { is_empty, is_there, no };

// The same in doubles.
struct RoughPart {
    Between least{-endless, -endless};
    Between most{endless, endless};
    bool is_beside = false;   // planes along the ray leave it out, or all of it up to there
    double outside = endless; // the size of t up to there
    bool is_unknown = false;

    Known known() const {
        if (most.high < least.low) {
            return Known::is_empty;
        }
        if (is_beside && -outside < least.low && most.high < outside) {
            return Known::is_empty;
        }
        if (is_beside || is_unknown || least.high > most.low) {
            return Known::no;
        }
        return Known::is_there;
    }

    // Between two parallel planes.
    void cut(const Bounded& first, const Bounded& last, const Bounded& along) {
        const std::optional<int> sign = sure_sign(along);
        if (sign && *sign != 0) {
            narrow(quotient(*sign > 0 ? first : last, along),
                   quotient(*sign > 0 ? last : first, along));
            return;
        }
        const double greatest = std::abs(along.value) + rounded_errors * along.error;
        const std::optional<int> first_sign = sure_sign(first);
        const std::optional<int> last_sign = sure_sign(last);
        if (first_sign == 1 || last_sign == -1) { // the origin is not between them
            const Bounded& nearer = first_sign == 1 ? first : last;
            outside = is_beside ? std::max(outside, far_away(nearer, greatest))
                                : far_away(nearer, greatest);
            is_beside = true;
            return;
        }
        if (sign && first_sign && last_sign) {
            return;
        }
        if (first_sign == -1 && last_sign == 1) {
            const double far = std::min(far_away(first, greatest), far_away(last, greatest));
            narrow({-endless, -far}, {far, endless});
            return;
        }
        is_unknown = true;
    }

private:
    static double far_away(const Bounded& place, double along) {
        const double least = std::abs(place.value) - rounded_errors * place.error;
        return along == 0.0 ? endless : (1.0 - 0x1p-50) * (least / along);
    }

    void narrow(const Between& lower, const Between& upper) {
        least = {std::max(least.low, lower.low), std::max(least.high, lower.high)};
        most = {std::min(most.low, upper.low), std::min(most.high, upper.high)};
    }
};

// Who has planes across an axis and times an axis: of a triangle or an edge.
class RoughCutter {
public:
    RoughCutter(const BoundedPoint& direction, const Bounded& room)
        : direction_(direction), room_(room) {}

    void cut_across_axes(std::span<const BoundedPoint> corners) {
        for (int axis = 0; axis < 3; ++axis) {
            Bounded low = corners[0][axis];
            Bounded high = low;
            for (const BoundedPoint& corner : corners) {
                low = lesser(low, corner[axis]);
                high = greater(high, corner[axis]);
            }
            part_.cut(low - room_, high + room_, direction_[axis]);
        }
    }

    // An edge with an end of it, and another corner of the triangle.
    void cut_along(const BoundedPoint& edge, const BoundedPoint& end, const BoundedPoint& other) {
        for (int axis = 0; axis < 3; ++axis) {
            const int i = (axis + 1) % 3;
            const int j = (axis + 2) % 3;
            const auto place = [&](const BoundedPoint& point) {
                return edge[j] * point[i] - edge[i] * point[j];
            };
            const Bounded room = room_ * (size_of(edge[i]) + size_of(edge[j]));
            const Bounded first = place(end);
            const Bounded second = place(other);
            part_.cut(lesser(first, second) - room, greater(first, second) + room,
                      place(direction_));
        }
    }

    void cut_across(const BoundedPoint& normal, const BoundedPoint& corner) {
        const Bounded room = room_ * (size_of(normal[0]) + size_of(normal[1]) + size_of(normal[2]));
        const Bounded place = dot(normal, corner);
        part_.cut(place - room, place + room, dot(normal, direction_));
    }

    const RoughPart& part() const { return part_; }

private:
    const BoundedPoint& direction_;
    Bounded room_;
    RoughPart part_;
};

BoundedPoint way(const glm::vec3& from, const glm::vec3& to) {
    const glm::dvec3 start(from);
    const glm::dvec3 end(to);
    return {Bounded{end.x} - Bounded{start.x}, Bounded{end.y} - Bounded{start.y},
            Bounded{end.z} - Bounded{start.z}};
}

glm::dvec3 in_doubles(const BoundedPoint& point) {
    return {point[0].value, point[1].value, point[2].value};
}

// The axis along which a ray goes farthest, and the two others.
struct MainAxis {
    int along = 0;
    int first = 0;
    int second = 0;
};

MainAxis main_axis(const glm::vec3& direction) {
    const glm::vec3 sizes = glm::abs(direction);
    const int along = sizes.x >= sizes.y && sizes.x >= sizes.z ? 0 : sizes.y >= sizes.z ? 1 : 2;
    return {along, (along + 1) % 3, (along + 2) % 3};
}

Fraction fraction_of(float value) {
    return {in_units(value), in_units(1.0f)};
}

constexpr float largest_float = std::numeric_limits<float>::max();

float float_at_least(const Fraction& value) {
    auto rounded = static_cast<float>(nearest_double(value));
    rounded = std::clamp(rounded, -largest_float, largest_float);
    while (std::isfinite(rounded) && is_less(fraction_of(rounded), value)) {
        rounded = std::nextafter(rounded, std::numeric_limits<float>::infinity());
    }
    return rounded;
}

float float_at_least(double value) {
    const auto most = static_cast<double>(largest_float);
    if (value > most) {
        return std::numeric_limits<float>::infinity();
    }
    const auto rounded = static_cast<float>(std::max(value, -most));
    return static_cast<double>(rounded) < value
               ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
               : rounded;
}

// The least float that is not less, where doubles know it to the sign of a zero.
std::optional<float> float_at_least(const Between& value) {
    const float low = float_at_least(value.low);
    const float high = float_at_least(value.high);
    return std::bit_cast<std::uint32_t>(low) == std::bit_cast<std::uint32_t>(high)
               ? std::optional(low)
               : std::nullopt;
}

} // namespace

NearTriangle::NearTriangle(std::int32_t number, const Ray& ray,
                           const std::array<glm::vec3, 3>& corners, Arithmetic arithmetic)
    : number_(number), ray_(&ray), corners_(corners), arithmetic_(arithmetic),
      direction_(way(glm::vec3(0.0f), ray.direction)) {
    for (int i = 0; i < 3; ++i) {
        seen_[i] = way(ray.origin, corners[i]);
        for (const Bounded& place : seen_[i]) {
            reach_ = greater(reach_, size_of(place));
        }
    }
}

bool NearTriangle::is_near() {
    if (is_surely_far(*ray_, in_doubles(seen_[0]), in_doubles(seen_[1]), in_doubles(seen_[2]))) {
        return false;
    }
    if (arithmetic_ == Arithmetic::filtered) {
        RoughCutter cutter(direction_, times_power_of_two(reach_, room_share));
        cutter.cut_across_axes(seen_);
        std::array<BoundedPoint, 3> edges;
        for (int i = 0; i < 3; ++i) {
            edges[i] = way(corners_[i], corners_[(i + 1) % 3]);
            cutter.cut_along(edges[i], seen_[i], seen_[(i + 2) % 3]);
        }
        const auto& [a, b, c] = edges;
        cutter.cut_across(
            {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]},
            seen_[0]);
        const RoughPart& part = cutter.part();
        if (part.known() == Known::is_empty) {
            return false;
        }
        if (part.known() == Known::is_there) {
            least_ = part.least;
            most_ = part.most;
        }
        const auto [along, first, second] = main_axis(ray_->direction);
        for (int i = 0; i < 3; ++i) {
            flat_[i] = {direction_[along] * seen_[i][first] - direction_[first] * seen_[i][along],
                        direction_[along] * seen_[i][second] -
                            direction_[second] * seen_[i][along]};
        }
        if (part.known() == Known::is_there) {
            return true;
        }
    } else {
        flat_.fill({unknown, unknown});
    }
    const InIntegers& whole = integers();
    exact_range_ = ExactPart({whole.corners, whole.direction, whole.reach}).range();
    return exact_range_.has_value();
}

const NearTriangle::InIntegers& NearTriangle::integers() {
    if (integers_) {
        return *integers_;
    }
    integers_.emplace();
    integers_->direction = point_in_units(ray_->direction);
    const Integer3 origin = point_in_units(ray_->origin);
    const auto [along, first, second] = main_axis(ray_->direction);
    const Integer3& direction = integers_->direction;
    for (int i = 0; i < 3; ++i) {
        Integer3& corner = integers_->corners[i];
        corner = difference(point_in_units(corners_[i]), origin);
        for (const Integer& component : corner) {
            integers_->reach = std::max(integers_->reach, Integer(abs(component)));
        }
        integers_->flat[i] = {direction[along] * corner[first] - direction[first] * corner[along],
                              direction[along] * corner[second] -
                                  direction[second] * corner[along]};
    }
    return *integers_;
}

// Asked only where there is one.
const ExactRange& NearTriangle::exact_range() {
    if (!exact_range_) {
        const InIntegers& whole = integers();
        exact_range_ = ExactPart({whole.corners, whole.direction, whole.reach}).range();
    }
    return *exact_range_;
}

float NearTriangle::least() {
    const std::optional<float> known = float_at_least(least_);
    return known ? *known : float_at_least(exact_range().least);
}

float NearTriangle::most() {
    const std::optional<float> known = float_at_least({-most_.high, -most_.low});
    if (known) {
        return -*known;
    }
    const Fraction& exact = exact_range().most;
    return -float_at_least(Fraction{-exact.numerator, exact.denominator});
}

// -1 where the end of the range is less than t, 1 where it is greater.
int NearTriangle::compare(const Between& bounds, float t, Fraction ExactRange::*end) {
    if (bounds.high < static_cast<double>(t)) {
        return -1;
    }
    if (bounds.low > static_cast<double>(t)) {
        return 1;
    }
    const Fraction& exact = exact_range().*end;
    return is_less(exact, fraction_of(t)) ? -1 : is_less(fraction_of(t), exact) ? 1 : 0;
}

bool NearTriangle::begins_before(float t) {
    return compare(least_, t, &ExactRange::least) < 0;
}

bool NearTriangle::ends_before(float t) {
    return compare(most_, t, &ExactRange::most) < 0;
}

bool NearTriangle::ends_behind(float t) {
    return compare(most_, t, &ExactRange::most) > 0;
}

bool NearTriangle::is_edge_near(int corner) {
    const int next = (corner + 1) % 3;
    const glm::dvec3 end = in_doubles(seen_[next]);
    if (is_surely_far(*ray_, in_doubles(seen_[corner]), end, end)) {
        return false;
    }
    if (arithmetic_ == Arithmetic::filtered) {
        RoughCutter cutter(direction_, times_power_of_two(reach_, room_share));
        cutter.cut_across_axes(std::array{seen_[corner], seen_[next]});
        cutter.cut_along(way(corners_[corner], corners_[next]), seen_[corner], seen_[corner]);
        if (cutter.part().known() != Known::no) {
            return cutter.part().known() == Known::is_there;
        }
    }
    const InIntegers& whole = integers();
    const std::array edge{whole.corners[corner], whole.corners[next], whole.corners[next]};
    return ExactPart({edge, whole.direction, whole.reach}).range().has_value();
}

int NearTriangle::sign_of_height(int corner) {
    const std::optional<int> sign = sure_sign(flat_[corner][1]);
    return sign ? *sign : integers().flat[corner][1].sign();
}

int NearTriangle::turns(int from, int to) {
    const bool before = sign_of_height(from) < 0;
    const bool behind = sign_of_height(to) < 0;
    if (before == behind) {
        return 0;
    }
    const auto side_of = [&](const auto& p, const auto& q) { return p[0] * q[1] - q[0] * p[1]; };
    std::optional<int> side = sure_sign(side_of(flat_[from], flat_[to]));
    if (!side) {
        side = Integer(side_of(integers().flat[from], integers().flat[to])).sign();
    }
    return before ? (*side > 0 ? 1 : 0) : (*side < 0 ? -1 : 0);
}

bool NearTriangle::is_clockwise() {
    const auto volume = [](const auto& flat) {
        return (flat[1][0] - flat[0][0]) * (flat[2][1] - flat[0][1]) -
               (flat[1][1] - flat[0][1]) * (flat[2][0] - flat[0][0]);
    };
    const std::optional<int> sign = sure_sign(volume(flat_));
    return sign ? *sign < 0 : Integer(volume(integers().flat)) < 0;
}

} // namespace raysteps
