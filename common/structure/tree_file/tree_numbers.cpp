#include "structure/tree_file/tree_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>

namespace raysteps {

namespace {

// The nine floats of a triangle, from its least corner on, so that one that was turned is the same.
using TriangleBits = std::array<std::uint32_t, 9>;

TriangleBits bits_of(std::span<const glm::vec3> corners) {
    std::array<TriangleBits, 3> turned{};
    for (std::size_t turn = 0; turn < 3; ++turn) {
        for (std::size_t i = 0; i < 9; ++i) {
            const float number = corners[(turn + i / 3) % 3][static_cast<int>(i % 3)];
            turned[turn][i] = std::bit_cast<std::uint32_t>(number == 0.0f ? 0.0f : number); // no -0
        }
    }
    return *std::ranges::min_element(turned);
}

struct HashOfBits {
    std::size_t operator()(const TriangleBits& bits) const {
        std::uint64_t hash = 14695981039346656037ULL; // FNV-1a
        for (const std::uint32_t number : bits) {
            hash = (hash ^ number) * 1099511628211ULL;
        }
        return hash;
    }
};

// The number in the scene of each triangle of the file. Of equal ones, each takes the next.
std::vector<std::int32_t> numbers_in(std::span<const glm::vec3> scene,
                                     std::span<const glm::vec3> own) {
    std::unordered_multimap<TriangleBits, std::int32_t, HashOfBits> places;
    places.reserve(scene.size() / 3);
    for (std::size_t i = scene.size() / 3; i-- > 0;) {
        places.emplace(bits_of(scene.subspan(3 * i, 3)), static_cast<std::int32_t>(i));
    }
    std::vector<std::int32_t> numbers(own.size() / 3, far_out);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto [first, last] = places.equal_range(bits_of(own.subspan(3 * i, 3)));
        const auto least = std::min_element(
            first, last, [](const auto& a, const auto& b) { return a.second < b.second; });
        if (least != last) {
            numbers[i] = least->second;
            places.erase(least);
        }
    }
    return numbers;
}

std::vector<std::int32_t> translated(std::vector<std::int32_t> order,
                                     const std::vector<std::int32_t>& numbers) {
    for (std::int32_t& triangle : order) {
        triangle = triangle >= 0 && static_cast<std::size_t>(triangle) < numbers.size()
                       ? numbers[static_cast<std::size_t>(triangle)]
                       : far_out;
    }
    return order;
}

void check_references(std::span<const std::int32_t> references, std::size_t triangles) {
    for (const std::int32_t triangle : references) {
        if (triangle < 0 || static_cast<std::size_t>(triangle) >= triangles) {
            throw InputError("the tree names triangle " + std::to_string(triangle) +
                             ", and the scene has " + std::to_string(triangles) +
                             ". Is it a tree of this scene?");
        }
    }
}

// A triangle without area that the loader has dropped is missed by nobody: it is taken out of the
// leaves.
bool is_nothing(std::span<const glm::vec3> corners) {
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

BoxTree without_nothing(BoxTree tree, const std::vector<std::int32_t>& numbers,
                        std::span<const glm::vec3> own) {
    const auto dropped = [&](std::int32_t triangle) {
        const auto place = static_cast<std::size_t>(triangle);
        return triangle >= 0 && place < numbers.size() && numbers[place] == far_out &&
               is_nothing(own.subspan(3 * place, 3));
    };
    if (std::ranges::none_of(tree.order, dropped)) {
        return tree;
    }
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        BvhNode& leaf = tree.nodes[i];
        const std::int64_t end = std::int64_t{leaf.first} + leaf.count;
        if (!is_leaf(tree, i) || leaf.first < 0 || leaf.count < 0 ||
            end > static_cast<std::int64_t>(tree.order.size())) {
            continue;
        }
        const auto first = tree.order.begin() + leaf.first;
        leaf.count = static_cast<std::int32_t>(
            std::stable_partition(first, tree.order.begin() + end,
                                  [&](std::int32_t triangle) { return !dropped(triangle); }) -
            first);
    }
    return tree;
}

// A reference says which neighbours list its triangle as well.
std::vector<std::int32_t> with_neighbours(const GridShape& shape,
                                          const std::vector<std::int32_t>& starts,
                                          const std::vector<std::int32_t>& references) {
    const auto lists = [&](std::int64_t cell, std::int32_t triangle) {
        const auto first = references.begin() + starts[static_cast<std::size_t>(cell)];
        const auto last = references.begin() + starts[static_cast<std::size_t>(cell) + 1];
        return std::binary_search(first, last, triangle);
    };
    std::vector<std::int32_t> marked = references;
    const std::array<std::int64_t, 3> steps{1, shape.cells.x,
                                            std::int64_t{shape.cells.x} * shape.cells.y};
    for (std::int64_t cell = 0; cell < cell_count(shape); ++cell) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t step = steps[static_cast<std::size_t>(axis)];
            const std::int64_t place = cell / step % shape.cells[axis];
            for (int side = 0; side < 2; ++side) {
                if (place == (side == 0 ? 0 : shape.cells[axis] - 1)) {
                    continue;
                }
                const std::int64_t neighbour = side == 0 ? cell - step : cell + step;
                for (auto r = static_cast<std::size_t>(starts[static_cast<std::size_t>(cell)]);
                     r < static_cast<std::size_t>(starts[static_cast<std::size_t>(cell) + 1]);
                     ++r) {
                    if (lists(neighbour, references[r])) {
                        marked[r] = static_cast<std::int32_t>(
                            static_cast<std::uint32_t>(marked[r]) |
                            1U << static_cast<unsigned>(triangle_bits + 2 * axis + side));
                    }
                }
            }
        }
    }
    return marked;
}

// In ascending order within each range, as the walks need it.
template <class Ends>
void sort_ranges(std::vector<std::int32_t>& references, const Ends& ends) {
    for (const auto& [first, end] : ends) {
        std::sort(references.begin() + first, references.begin() + end);
    }
}

} // namespace

AnyTree in_numbers_of(TreeFile file, std::span<const glm::vec3> corners) {
    const std::size_t triangles = corners.size() / 3;
    const std::vector<std::int32_t> numbers =
        file.corners.empty() ? std::vector<std::int32_t>{} : numbers_in(corners, file.corners);
    const auto translate = [&](std::vector<std::int32_t>& order) {
        if (!file.corners.empty()) {
            order = translated(std::move(order), numbers);
        }
    };
    std::vector<std::pair<std::int32_t, std::int32_t>> ranges;
    if (BoxTree* const boxes = std::get_if<BoxTree>(&file.tree)) {
        *boxes = without_nothing(std::move(*boxes), numbers, file.corners);
        translate(boxes->order);
    } else if (KdTree* const kd_tree = std::get_if<KdTree>(&file.tree)) {
        translate(kd_tree->references);
        check_references(kd_tree->references, triangles);
        for (const KdNode& node : kd_tree->nodes) {
            ranges.emplace_back(node.first_reference, node.end_reference);
        }
        sort_ranges(kd_tree->references, ranges);
    } else {
        Grid& grid = std::get<Grid>(file.tree);
        translate(grid.references);
        check_references(grid.references, std::min<std::size_t>(triangles, triangle_mask));
        for (std::size_t i = 0; i + 1 < grid.starts.size(); ++i) {
            ranges.emplace_back(grid.starts[i], grid.starts[i + 1]);
        }
        sort_ranges(grid.references, ranges);
        grid.references = with_neighbours(grid.shape, grid.starts, grid.references);
    }
    return std::move(file.tree);
}

} // namespace raysteps
