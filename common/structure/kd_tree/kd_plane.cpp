#include "structure/kd_tree/kd_split.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace raysteps {

namespace {

glm::dvec3 size_of(const Box& box) {
    return glm::dvec3(box.upper) - glm::dvec3(box.lower);
}

// Is the plane far enough from both sides of the box?
bool leaves_room(const Box& box, int axis, float position, double padding) {
    const double least = least_width_in_paddings * padding;
    const double plane = position;
    return plane - static_cast<double>(box.lower[axis]) >= least &&
           static_cast<double>(box.upper[axis]) - plane >= least;
}

// What a plane at right angles to the axis costs. Half of a child's surface is
// cross_section + around * width, where width is its size along the axis.
struct AxisCosts {
    AxisCosts(const Box& box, int along, const KdOptions& chosen) : axis(along), options(chosen) {
        const glm::dvec3 size = size_of(box);
        cross_section = size[(axis + 1) % 3] * size[(axis + 2) % 3];
        around = size[(axis + 1) % 3] + size[(axis + 2) % 3];
        lower = box.lower[axis];
        upper = box.upper[axis];
        whole = cross_section + around * size[axis];
    }

    double at(float position, std::size_t lower_count, std::size_t upper_count) const {
        const double lower_area = cross_section + around * (position - lower);
        const double upper_area = cross_section + around * (upper - position);
        //# exercise 5.5: what a plane costs
        const double tests = (lower_area * static_cast<double>(lower_count) +
                              upper_area * static_cast<double>(upper_count)) /
                             whole;
        const double cost = options.traversal_cost + options.intersection_cost * tests;
        const bool cuts_off_empty = lower_count == 0 || upper_count == 0;
        return cuts_off_empty ? (1.0 - options.empty_bonus) * cost : cost;
        //# stub: static_cast<void>(lower_count + upper_count);
        //# stub: return lower_area + upper_area + whole;
        //# end
    }

    int axis;
    const KdOptions& options;
    double cross_section = 0.0;
    double around = 0.0;
    double lower = 0.0;
    double upper = 0.0;
    double whole = 0.0;
};

KdPlane cheaper(const KdPlane& a, const KdPlane& b) {
    return was_found(b) && (!was_found(a) || b.cost < a.cost) ? b : a;
}

// The plane sweeps along one axis. A triangle that ends at it is not above, and one that starts at
// it is not below.
KdPlane cheapest_on_axis(const KdEvents& events, const Box& box, int axis, double padding,
                         const KdOptions& options) {
    const AxisCosts costs(box, axis, options);
    const std::vector<KdEvent>& sorted = events[static_cast<std::size_t>(axis)];
    KdPlane best;
    std::size_t lower_count = 0;
    std::size_t upper_count = triangle_count(events);
    for (std::size_t i = 0; i < sorted.size();) {
        const float position = sorted[i].position;
        std::size_t starts = 0;
        for (; i < sorted.size() && sorted[i].position == position; ++i) {
            starts += is_start(sorted[i]) ? 1 : 0;
            upper_count -= is_start(sorted[i]) ? 0 : 1;
        }
        if (leaves_room(box, axis, position, padding)) {
            const double cost = costs.at(position, lower_count, upper_count);
            best = cheaper(best, {axis, position, lower_count, upper_count, cost});
        }
        lower_count += starts;
    }
    return best;
}

} // namespace

KdPlane cheapest_plane(const KdEvents& events, const Box& box, double padding,
                       const KdOptions& options) {
    KdPlane best;
    for (int axis = 0; axis < 3; ++axis) {
        best = cheaper(best, cheapest_on_axis(events, box, axis, padding, options));
    }
    return best;
}

namespace {

// How many parts start and end in each of equal slices of a box.
struct KdBins {
    static constexpr int most = 256;

    KdBins(const Box& box, int along, std::size_t parts)
        : count(parts > many_parts ? most : most / 4), lower(box.lower[along]),
          width((static_cast<double>(box.upper[along]) - lower) / count) {}

    float plane(int bin) const { return static_cast<float>(lower + bin * width); }

    // The last one whose lower plane is at most there; an end is in the bin that it closes.
    std::size_t of_start(float position) const {
        int bin = guess(position);
        bin -= bin > 0 && position < plane(bin) ? 1 : 0;
        bin += bin + 1 < count && position >= plane(bin + 1) ? 1 : 0;
        return static_cast<std::size_t>(bin);
    }
    std::size_t of_end(float position) const {
        int bin = guess(position);
        bin -= bin > 0 && position <= plane(bin) ? 1 : 0;
        bin += bin + 1 < count && position > plane(bin + 1) ? 1 : 0;
        return static_cast<std::size_t>(bin);
    }

    int guess(float position) const {
        const double place = (static_cast<double>(position) - lower) / width;
        return static_cast<int>(std::clamp(place, 0.0, count - 1.0));
    }

    static constexpr std::size_t many_parts = 4096;

    int count;
    double lower;
    double width;
    std::array<std::uint32_t, most> starts{};
    std::array<std::uint32_t, most> ends{};
    float first_start = std::numeric_limits<float>::infinity();
    float last_end = -std::numeric_limits<float>::infinity();
};

KdPlane cheapest_of_bins(std::span<const KdPart> parts, const Box& box, int axis, double padding,
                         const KdOptions& options) {
    KdBins bins(box, axis, parts.size());
    if (!(bins.width > 0.0)) {
        return {};
    }
    for (const KdPart& part : parts) {
        const float start = part.bounds.lower[axis];
        const float end = part.bounds.upper[axis];
        ++bins.starts[bins.of_start(start)];
        ++bins.ends[bins.of_end(end)];
        bins.first_start = std::min(bins.first_start, start);
        bins.last_end = std::max(bins.last_end, end);
    }
    const AxisCosts costs(box, axis, options);
    KdPlane best;
    const auto look_at = [&](float position, std::size_t lower_count, std::size_t upper_count) {
        if (leaves_room(box, axis, position, padding)) {
            const double cost = costs.at(position, lower_count, upper_count);
            best = cheaper(best, {axis, position, lower_count, upper_count, cost});
        }
    };
    look_at(bins.first_start, 0, parts.size());
    std::size_t lower_count = 0;
    std::size_t upper_count = parts.size();
    for (int bin = 1; bin < bins.count; ++bin) {
        lower_count += bins.starts[static_cast<std::size_t>(bin - 1)];
        upper_count -= bins.ends[static_cast<std::size_t>(bin - 1)];
        look_at(bins.plane(bin), lower_count, upper_count);
    }
    look_at(bins.last_end, parts.size(), 0);
    return best;
}

} // namespace

KdPlane binned_plane(std::span<const KdPart> parts, const Box& box, double padding,
                     const KdOptions& options) {
    KdPlane best;
    for (int axis = 0; axis < 3; ++axis) {
        best = cheaper(best, cheapest_of_bins(parts, box, axis, padding, options));
    }
    return best;
}

KdPlane middle_plane(const KdEvents& events, const Box& box, double padding) {
    const glm::dvec3 size = size_of(box);
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const auto middle = static_cast<float>(box.lower[axis] + 0.5 * size[axis]);
    if (!leaves_room(box, axis, middle, padding)) {
        return {};
    }
    KdPlane plane{axis, middle, 0, 0, 0.0};
    for (const KdEvent& event : events[static_cast<std::size_t>(axis)]) {
        plane.lower_count += is_start(event) && event.position < middle ? 1 : 0;
        plane.upper_count += !is_start(event) && event.position > middle ? 1 : 0;
    }
    return plane;
}

} // namespace raysteps
