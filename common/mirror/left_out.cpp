#include "mirror/left_out.h"

#include "mirror/walks.h"
#include "structure/padding.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <optional>

namespace raysteps {

namespace {

using Mirror = mirror::walks::bvh_skip<float>;

// Where the ray enters and leaves a box, and by which axis; -1 where it begins or ends in it.
struct BoxCrossing {
    float entry = 0.0f;
    float exit = 0.0f;
    int entry_axis = -1;
    int exit_axis = -1;

    bool met() const { return entry <= exit; }
};

BoxCrossing crossing_of(const Ray& ray, const Box& box, float t_max) {
    Mirror mirror{};
    const auto prepared = mirror.box_ray(mirror::to_mirror<Mirror>(ray));
    auto first = Mirror::real3(box.lower);
    auto last = Mirror::real3(box.upper);
    for (int axis = 0; axis < 3; ++axis) {
        if (mirror.descends(prepared, axis)) {
            std::swap(first[axis], last[axis]);
        }
    }
    const auto span = mirror.span_in_box(prepared, first, last, t_max);
    BoxCrossing crossing{span.entry, span.exit};
    for (int axis = 0; axis < 3; ++axis) {
        const float enters = (first[axis] - prepared.first_origin[axis]) * prepared.inverse[axis];
        const float leaves = (last[axis] - prepared.last_origin[axis]) * prepared.inverse[axis];
        crossing.entry_axis =
            enters == span.entry && crossing.entry_axis < 0 ? axis : crossing.entry_axis;
        crossing.exit_axis =
            leaves == span.exit && crossing.exit_axis < 0 ? axis : crossing.exit_axis;
    }
    return crossing;
}

// The least padding with which the ray meets the box, to three digits; nothing where no padding
// does.
std::optional<double> padding_that_keeps(const Ray& ray, const Box& box, float t_max) {
    const auto kept = [&](double padding) {
        return crossing_of(ray, pad(box, padding), t_max).met();
    };
    double most = 1e-30;
    while (most < 1e30 && !kept(most)) {
        most *= 2.0;
    }
    if (!kept(most)) {
        return std::nullopt;
    }
    double least = most > 1e-30 ? 0.5 * most : 0.0;
    for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (least + most);
        (kept(middle) ? most : least) = middle;
    }
    return most;
}

bool encloses(const Box& outer, std::span<const glm::vec3> points) {
    return std::ranges::all_of(points, [&](const glm::vec3& point) {
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            inside = inside && outer.lower[axis] <= point[axis] && point[axis] <= outer.upper[axis];
        }
        return inside;
    });
}

} // namespace

TreePaths paths_of(const BoxTree& tree, std::size_t triangles) {
    TreePaths paths{std::vector<std::int32_t>(tree.nodes.size(), no_child),
                    std::vector<std::vector<std::int32_t>>(triangles)};
    std::vector<char> reached(tree.nodes.size(), 0);
    std::size_t seen = 0;
    std::vector<std::size_t> open;
    if (!tree.nodes.empty()) {
        open.push_back(0);
        reached[0] = 1;
    }
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        for (const std::int32_t child : children_of(tree, node)) {
            if (child >= 0 && place_of(child) < tree.nodes.size() &&
                reached[place_of(child)] == 0) {
                reached[place_of(child)] = 1;
                paths.parents[place_of(child)] = static_cast<std::int32_t>(node);
                open.push_back(place_of(child));
            }
        }
        if (!is_leaf(tree, node)) {
            continue;
        }
        const BvhNode& leaf = tree.nodes[node];
        const std::int64_t end = std::int64_t{leaf.first} + leaf.count;
        seen += place_of(std::max(0, leaf.count));
        if (seen > most_references(tree)) {
            continue;
        }
        for (std::int64_t r = std::max(0, leaf.first);
             r < std::min(end, static_cast<std::int64_t>(tree.order.size())); ++r) {
            const std::int32_t triangle = tree.order[static_cast<std::size_t>(r)];
            if (triangle >= 0 && place_of(triangle) < triangles) {
                paths.leaves[place_of(triangle)].push_back(static_cast<std::int32_t>(node));
            }
        }
    }
    return paths;
}

LeftOut left_out(const BoxTree& tree, const TreePaths& paths, std::span<const glm::vec3> corners,
                 const Ray& ray, float t_max, std::int32_t triangle) {
    LeftOut best{.by = LeftOutBy::no_leaf};
    std::size_t farthest = 0; // so many nodes of the best way are met
    for (const std::int32_t leaf : paths.leaves[place_of(triangle)]) {
        LeftOut out;
        for (std::int32_t node = leaf; node != no_child; node = paths.parents[place_of(node)]) {
            out.way.push_back(node);
        }
        std::ranges::reverse(out.way);
        const auto missed = std::ranges::find_if(out.way, [&](std::int32_t node) {
            return !crossing_of(ray, tree.nodes[place_of(node)].box, t_max).met();
        });
        if (missed == out.way.end()) {
            out.by = LeftOutBy::nothing;
            return out;
        }
        out.node = *missed;
        out.by =
            encloses(tree.nodes[place_of(*missed)].box, corners.subspan(3 * place_of(triangle), 3))
                ? LeftOutBy::tight_box
                : LeftOutBy::short_box;
        const auto met = static_cast<std::size_t>(missed - out.way.begin()) + 1;
        if (met > farthest) {
            farthest = met;
            best = out;
        }
    }
    return best;
}

namespace {

std::string number_and_bits(float number) {
    return fmt::format("{:.9g} (0x{:08x})", number, std::bit_cast<std::uint32_t>(number));
}

std::string by_axis(int axis, const std::string& end) {
    return axis < 0 ? end : fmt::format("the planes of {}", "xyz"[axis]);
}

std::string way_in_words(std::span<const std::int32_t> way) {
    std::string words;
    for (const std::int32_t node : way) {
        words += (words.empty() ? "" : ", ") + std::to_string(node);
    }
    return words;
}

} // namespace

std::vector<std::string> left_out_in_words(const LeftOut& out, const BoxTree& tree, const Ray& ray,
                                           const SoughtTriangle& sought) {
    if (out.by == LeftOutBy::no_leaf) {
        return {fmt::format("No leaf that can be reached lists triangle {}.", sought.triangle)};
    }
    std::vector<std::string> lines{
        fmt::format("Leaf {} lists triangle {}. The way from the root: {}.", out.way.back(),
                    sought.triangle, way_in_words(out.way))};
    if (out.by == LeftOutBy::nothing) {
        lines.push_back("The ray meets every box on the way, so a walk comes to the triangle.");
        return lines;
    }
    const Box& box = tree.nodes[place_of(out.node)].box;
    const BoxCrossing crossing = crossing_of(ray, box, sought.t_max);
    lines.push_back(fmt::format(
        "Node {} left it out: the ray enters its box at t = {} by {}, and is out of it at t = {} "
        "by {}.",
        out.node, number_and_bits(crossing.entry), by_axis(crossing.entry_axis, "its t_min"),
        number_and_bits(crossing.exit), by_axis(crossing.exit_axis, "the hit")));
    const auto padding = padding_that_keeps(ray, box, sought.t_max);
    const std::string kept =
        padding ? fmt::format("Sides {:.3g} farther out would have kept it.", *padding)
                : "No padding would have kept it.";
    if (out.by == LeftOutBy::short_box) {
        lines.push_back("That box does not hold the triangle: it is short, or the triangle is in "
                        "the wrong branch. " +
                        kept);
    } else if (sought.meets) {
        lines.push_back("That box holds the triangle, but has no room for rounding: it is tight. " +
                        kept);
    } else {
        lines.push_back("That box holds the triangle, and the ray misses both, as it may.");
    }
    return lines;
}

} // namespace raysteps
