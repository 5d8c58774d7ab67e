#include "answer_builders.h"

#include "basics/box.h"
#include "basics/error.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/bvh4.h"
#include "structure/bvh/bvh_split.h"
#include "structure/grid/grid.h"
#include "structure/kd_tree/kd_split.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace raysteps {

namespace {

std::uint32_t bits(double number) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(number));
}

Box box_of(const Ray& ray) {
    return {ray.origin, ray.direction};
}

int number_named(const CourseQuestion& question, const std::string& name, int otherwise) {
    const auto named = question.numbers.find(name);
    return named == question.numbers.end() ? otherwise : named->second;
}

// From a multiple of 1/64 to another, times 2^scale: so sums and products of sides are exact, and
// an answer does not depend on the order in which a student adds.
Ray random_box(std::mt19937& numbers, int scale) {
    Ray ray{};
    for (int axis = 0; axis < 3; ++axis) {
        const float lower = static_cast<float>(numbers() % 128) / 64.0f - 1.0f;
        const float upper = lower + static_cast<float>(1 + numbers() % 32) / 64.0f;
        ray.origin[axis] = std::ldexp(lower, scale);
        ray.direction[axis] = std::ldexp(upper, scale);
    }
    return ray;
}

// Of sides and places of any size, from 2^-10 to 2^10.
Ray uneven_box(std::mt19937& numbers) {
    const auto any = [&numbers] {
        const float part = static_cast<float>(numbers() >> 8U) * 0x1p-24f;
        return std::ldexp(part, static_cast<int>(numbers() % 21U) - 10);
    };
    Ray ray{};
    for (int axis = 0; axis < 3; ++axis) {
        const float sign = numbers() % 2U == 0 ? 1.0f : -1.0f;
        ray.origin[axis] = sign * any();
        ray.direction[axis] = ray.origin[axis] + any();
    }
    return ray;
}

std::vector<Ray> boxes_of(const CourseQuestion& question) {
    std::vector<Ray> boxes = question.rays;
    std::mt19937 numbers(static_cast<std::uint32_t>(question.seed));
    for (int i = 0; i < question.random_rays; ++i) {
        boxes.push_back(number_named(question, "uneven", 0) != 0
                            ? uneven_box(numbers)
                            : random_box(numbers, number_named(question, "scale", 0)));
    }
    return boxes;
}

Box around(std::span<const Ray> boxes) {
    Box all;
    for (const Ray& ray : boxes) {
        all = merge(all, box_of(ray));
    }
    return all;
}

Found grid_cells(const CourseQuestion& question, std::span<const Ray> boxes) {
    std::vector<glm::vec3> corners; // a triangle that spans each box
    for (const Ray& ray : boxes) {
        corners.insert(corners.end(), {ray.origin, ray.direction, ray.origin});
    }
    GridOptions options;
    const auto density = question.options.find("density");
    options.density =
        density == question.options.end() ? options.density : std::stod(density->second);
    const GridShape shape = shape_grid(corners, options);
    return {static_cast<std::uint32_t>(shape.cells.x), static_cast<std::uint32_t>(shape.cells.y),
            static_cast<std::uint32_t>(shape.cells.z), bits(shape.cell_size.x)};
}

KdEvents events_of(std::span<const Ray> boxes) {
    KdEvents events;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        int number = 0;
        for (const Ray& ray : boxes) {
            const int along = static_cast<int>(axis);
            events[axis].push_back(make_event(ray.origin[along], number, KdEventKind::start));
            events[axis].push_back(make_event(ray.direction[along], number, KdEventKind::end));
            ++number;
        }
        std::sort(events[axis].begin(), events[axis].end(), [](const KdEvent& a, const KdEvent& b) {
            return a.position < b.position || (a.position == b.position && a.code < b.code);
        });
    }
    return events;
}

Found kd_plane(const CourseQuestion& /*question*/, std::span<const Ray> boxes) {
    const KdPlane plane = cheapest_plane(events_of(boxes), around(boxes), 0.0, {});
    return {static_cast<std::uint32_t>(plane.axis), bits(static_cast<double>(plane.position)),
            static_cast<std::uint32_t>(plane.lower_count), bits(plane.cost)};
}

using BvhSplitRule = std::optional<BvhCut> (*)(const BvhRange&, const BvhOptions&);

Found bvh_cut(BvhSplitRule rule, std::span<const Ray> boxes) {
    std::vector<BvhItem> items;
    for (const Ray& ray : boxes) {
        items.push_back({box_of(ray), static_cast<std::int32_t>(items.size())});
    }
    BvhRange range{items, around(boxes), {}};
    for (const BvhItem& item : items) {
        range.centers = merge(range.centers, doubled_center(item));
    }
    BvhOptions options;
    options.traversal_cost = 1.0; // the known answers are for a node that costs so much
    const std::optional<BvhCut> cut = rule(range, options);
    if (!cut) {
        return {static_cast<std::uint32_t>(-1)};
    }
    const auto cost = std::bit_cast<std::uint64_t>(cut->cost);
    return {static_cast<std::uint32_t>(cut->axis),
            static_cast<std::uint32_t>(cut->lower_count),
            bits(cut->cost),
            std::bit_cast<std::uint32_t>(
                cut->first_upper_center.value_or(std::numeric_limits<float>::quiet_NaN())),
            static_cast<std::uint32_t>(cost >> 32U),
            static_cast<std::uint32_t>(cost)};
}

Found bvh_median(const CourseQuestion& /*question*/, std::span<const Ray> boxes) {
    return bvh_cut(split_median, boxes);
}

Found bvh_binned(const CourseQuestion& /*question*/, std::span<const Ray> boxes) {
    return bvh_cut(split_binned, boxes);
}

// Of the last box, in the frame around all of them, along one axis.
Found half_planes(const CourseQuestion& question, std::span<const Ray> boxes) {
    const Box whole = around(boxes);
    HalfFrame frame{whole.lower, whole.upper - whole.lower};
    const int axis = number_named(question, "axis", 0);
    while (frame.lower[axis] + frame.size[axis] < whole.upper[axis]) { // it is around the boxes
        frame.size[axis] = std::nextafter(frame.size[axis], std::numeric_limits<float>::infinity());
    }
    const Box box = box_of(boxes.back());
    const int below = half_below(frame, axis, box.lower[axis]);
    const int above = half_above(frame, axis, box.upper[axis]);
    return {static_cast<std::uint32_t>(below), static_cast<std::uint32_t>(above),
            bits(static_cast<double>(half_plane(frame, axis, below))),
            bits(static_cast<double>(half_plane(frame, axis, above)))};
}

// The lowest of the boxes that lie below a child of a node.
std::int32_t lowest_box(const Bvh4& bvh, const BvhNode& child) {
    std::int32_t lowest = std::numeric_limits<std::int32_t>::max();
    if (is_leaf(child)) {
        for (std::int32_t i = child.first; i < child.first + child.count; ++i) {
            lowest = std::min(lowest, bvh.order[static_cast<std::size_t>(i)]);
        }
        return lowest;
    }
    for (std::int32_t i = 0; i < bvh4_width; ++i) {
        const BvhNode& below = bvh.children[static_cast<std::size_t>(bvh4_width * child.first + i)];
        if (is_leaf(below) || below.first != no_bvh4_node) {
            lowest = std::min(lowest, lowest_box(bvh, below));
        }
    }
    return lowest;
}

// How many children the root has, the lowest box below each of them, two digits a child; how many
// nodes there are; and a digest of all of them.
Found found_of(const Bvh4& bvh) {
    std::uint32_t children = 0;
    std::int32_t lowest = 0;
    for (std::size_t i = 0; i < bvh4_width; ++i) {
        const BvhNode& child = bvh.children[i];
        if (is_leaf(child) || child.first != no_bvh4_node) {
            ++children;
            lowest = 100 * lowest + lowest_box(bvh, child);
        }
    }
    std::uint32_t digest = 0;
    for (const BvhNode& child : bvh.children) {
        digest = 31U * digest + 2U * static_cast<std::uint32_t>(child.first) +
                 static_cast<std::uint32_t>(child.count);
    }
    return {children, static_cast<std::uint32_t>(lowest),
            static_cast<std::uint32_t>(bvh.parents.size()), digest};
}

// Of a hierarchy whose leaves have a box each.
Found bvh4_root(const CourseQuestion& /*question*/, std::span<const Ray> boxes) {
    std::vector<glm::vec3> corners; // a triangle that spans each box
    for (const Ray& ray : boxes) {
        corners.insert(corners.end(), {ray.origin, ray.direction, ray.origin});
    }
    const BvhOptions options{.leaf_triangles = 1};
    return found_of(collapse(build_bvh(corners, options)));
}

// Of a hierarchy over the boxes in their order, without a builder and without padding: each node is
// cut in the middle, or with `numbers.seed` anywhere.
Found bvh4_in_order(const CourseQuestion& question, std::span<const Ray> boxes) {
    struct Part {
        std::size_t node;
        std::size_t first;
        std::size_t count;
    };
    const int seed = number_named(question, "seed", 0);
    std::mt19937 numbers(static_cast<std::uint32_t>(seed));
    Bvh bvh;
    bvh.nodes.resize(1);
    std::vector<Part> parts{{0, 0, boxes.size()}};
    while (!parts.empty()) {
        const Part part = parts.back();
        parts.pop_back();
        BvhNode node{around(boxes.subspan(part.first, part.count)),
                     static_cast<std::int32_t>(part.first), 1};
        if (part.count > 1) {
            const std::size_t lower = seed == 0 ? part.count / 2 : 1 + numbers() % (part.count - 1);
            node.first = static_cast<std::int32_t>(bvh.nodes.size());
            node.count = 0;
            parts.push_back({bvh.nodes.size(), part.first, lower});
            parts.push_back({bvh.nodes.size() + 1, part.first + lower, part.count - lower});
            bvh.nodes.resize(bvh.nodes.size() + 2);
        }
        bvh.nodes[part.node] = node;
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        bvh.order.push_back(static_cast<std::int32_t>(i));
    }
    return found_of(collapse(bvh));
}

using AskBuilder = Found (*)(const CourseQuestion&, std::span<const Ray>);

AskBuilder builder_of(const std::string& subject) {
    static const std::map<std::string, AskBuilder> builders{
        {"grid_cells", grid_cells},      {"kd_plane", kd_plane},   {"bvh_median", bvh_median},
        {"bvh_binned", bvh_binned},      {"bvh4_root", bvh4_root}, {"half_planes", half_planes},
        {"bvh4_in_order", bvh4_in_order}};
    const auto place = builders.find(subject);
    if (place == builders.end()) {
        throw InputError("no builder has the name " + subject +
                         ". Take grid_cells, kd_plane, bvh_median, bvh_binned, bvh4_root, "
                         "bvh4_in_order or half_planes.");
    }
    return place->second;
}

} // namespace

Answer answer_by_builders(const CourseQuestion& question) {
    if (question.kind != QuestionKind::builder) {
        throw InputError("this program answers questions about builders. Ask course_shaders.");
    }
    const AskBuilder ask = builder_of(question.subject);
    Answer answer{boxes_of(question), {}};
    const auto first = static_cast<std::size_t>(number_named(question, "least", 2));
    for (std::size_t count = first; count <= answer.rays.size(); ++count) {
        answer.steps.push_back({ask(question, std::span(answer.rays).first(count))});
    }
    return answer;
}

} // namespace raysteps
