#include "structure/grid/build_grid.h"

#include "basics/error.h"
#include "basics/threads.h"
#include "structure/grid/grid_overlap.h"
#include "structure/padding.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <string>

namespace raysteps {

namespace {

// All threads read the triangle of a reference while the one whose cell it is sets its other bits.
std::int32_t read(std::int32_t& reference) {
    return std::atomic_ref(reference).load(std::memory_order_relaxed);
}

void add_bit(std::int32_t& reference, int face) {
    const auto bit = static_cast<std::int32_t>(1U << static_cast<unsigned>(triangle_bits + face));
    std::atomic_ref(reference).store(read(reference) | bit, std::memory_order_relaxed);
}

std::span<std::int32_t> references_of(Grid& grid, std::int64_t cell) {
    const auto i = static_cast<std::size_t>(cell);
    const auto first = static_cast<std::size_t>(grid.starts[i]);
    const auto end = static_cast<std::size_t>(grid.starts[i + 1]);
    return std::span(grid.references).subspan(first, end - first);
}

// Both lists ascend, so one pass through the two finds what they share.
void mark(std::span<std::int32_t> own, std::span<std::int32_t> others, int face) {
    std::size_t other = 0;
    for (std::int32_t& reference : own) {
        const std::int32_t triangle = triangle_of(read(reference));
        while (other < others.size() && triangle_of(read(others[other])) < triangle) {
            ++other;
        }
        if (other < others.size() && triangle_of(read(others[other])) == triangle) {
            add_bit(reference, face);
        }
    }
}

} // namespace

std::int64_t neighbour_across(const GridShape& shape, std::int64_t cell, int face) {
    const int axis = face / 2;
    const std::int64_t stride = axis == 0   ? 1
                                : axis == 1 ? shape.cells.x
                                            : std::int64_t{shape.cells.x} * shape.cells.y;
    const std::int64_t place = cell / stride % shape.cells[axis];
    const bool upwards = face % 2 == 1;
    if (place == (upwards ? shape.cells[axis] - 1 : 0)) {
        return -1;
    }
    return upwards ? cell + stride : cell - stride;
}

Grid mark_neighbours(Grid grid, unsigned threads) {
    const auto mark_cells = [&grid](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto cell = static_cast<std::int64_t>(i);
            const std::span<std::int32_t> own = references_of(grid, cell);
            for (int face = 0; face < 6 && !own.empty(); ++face) {
                const std::int64_t neighbour = neighbour_across(grid.shape, cell, face);
                if (neighbour >= 0) {
                    mark(own, references_of(grid, neighbour), face);
                }
            }
        }
    };
    in_parts(threads, static_cast<std::size_t>(cell_count(grid.shape)), 4096, mark_cells);
    return grid;
}

namespace {

constexpr std::int64_t bytes_each = sizeof(std::int32_t);
constexpr std::int64_t bytes_in_mebibyte = 1LL << 20U;
constexpr std::int64_t most_numbers = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t triangles_in_part = 256;

void check_input(std::span<const glm::vec3> corners, const GridOptions& options) {
    if (!(options.density > 0.0 && options.density <= 1e6)) {
        throw InputError("--density " + std::to_string(options.density) +
                         ": the cells a triangle must be over 0 and at most 1000000.");
    }
    if (options.resolution < 0) {
        throw InputError("--resolution " + std::to_string(options.resolution) +
                         ": the cells along the longest side must be 1 or more, or 0 to follow "
                         "--density.");
    }
    if (corners.size() / 3 > static_cast<std::size_t>(triangle_mask) + 1) {
        throw InputError("the scene has " + std::to_string(corners.size() / 3) +
                         " triangles, and a grid can refer to 67108864 (2^26). Take another "
                         "--structure, or a smaller scene.");
    }
    check_corners(corners, std::numeric_limits<float>::max());
}

// Throws where so many cells with so many references are more than a GPU reads.
void check_texels(std::int64_t cells, std::int64_t references, const GridOptions& options) {
    if (std::max(cells + 1, references) > options.most_texels) {
        throw MachineError(fmt::format(
            "A grid of {} cells and {} references or more is asked for, but this machine's OpenGL "
            "reads at most {} of each. Take a smaller {}, or --structure bvh_ordered, which lists "
            "each triangle once.",
            cells, references, options.most_texels,
            options.resolution > 0 ? "--resolution" : "--density"));
    }
}

// Throws where so many cells with so many references take too much.
void check_memory(std::int64_t cells, std::int64_t references, const GridOptions& options) {
    const std::string coarser = options.resolution > 0 ? "--resolution" : "--density";
    const std::string numbers = "a grid of " + std::to_string(cells) + " cells and " +
                                std::to_string(references) + " references or more";
    if (cells >= most_numbers || references > most_numbers) {
        throw InputError(numbers + " is too large for 32-bit indices. Take a smaller " + coarser +
                         ".");
    }
    if (bytes_each * (cells + 1 + references) > options.memory_limit) {
        throw InputError(numbers + " takes over " +
                         std::to_string(options.memory_limit / bytes_in_mebibyte) +
                         " MiB. Take a smaller " + coarser + ", or a larger --memory-limit.");
    }
}

std::string mebibytes(std::int64_t numbers) {
    return fmt::format("{:.1f} MiB", static_cast<double>(bytes_each * numbers) /
                                         static_cast<double>(bytes_in_mebibyte));
}

// On the way of one ray.
constexpr std::int64_t fewest_worth_a_word = 1000;

// That with the most cells.
int longest_axis(const GridShape& shape) {
    int longest = 0;
    for (const int axis : {1, 2}) {
        longest = shape.cells[axis] > shape.cells[longest] ? axis : longest;
    }
    return longest;
}

// The most references that there is room for beside the cells.
std::int64_t most_references(std::int64_t cells, const GridOptions& options) {
    return std::min(
        {options.memory_limit / bytes_each - (cells + 1), options.most_texels, most_numbers});
}

TriangleOverlap overlap_of(const GridShape& shape, std::span<const glm::vec3> corners,
                           std::size_t triangle) {
    return prepare_overlap(shape, corners[3 * triangle], corners[3 * triangle + 1],
                           corners[3 * triangle + 2]);
}

// How many triangles overlap each cell; one number more, which is zero.
std::vector<std::int32_t> count_references(const GridShape& shape,
                                           std::span<const glm::vec3> corners,
                                           const GridOptions& options) {
    const std::int64_t cells = cell_count(shape);
    const std::int64_t most = most_references(cells, options);
    std::vector<std::int32_t> counts(static_cast<std::size_t>(cells) + 1, 0);
    std::atomic<std::int64_t> total = 0;
    const auto count = [&](std::size_t begin, std::size_t end) {
        // Past the limit the rest is not worth the time.
        for (std::size_t triangle = begin; triangle < end && total <= most; ++triangle) {
            std::int64_t own = 0;
            visit_overlapped(shape, overlap_of(shape, corners, triangle), [&](std::size_t cell) {
                std::atomic_ref(counts[cell]).fetch_add(1, std::memory_order_relaxed);
                ++own;
            });
            total.fetch_add(own, std::memory_order_relaxed);
        }
    };
    in_parts(options.threads, corners.size() / 3, triangles_in_part, count);
    check_memory(cells, total, options);
    check_texels(cells, total, options);
    return counts;
}

// From the count of each cell to where its references end.
std::vector<std::int32_t> add_up(std::vector<std::int32_t> counts) {
    std::int32_t sum = 0;
    for (std::int32_t& count : counts) {
        sum += count;
        count = sum;
    }
    return counts;
}

// Each reference goes before the last one of its cell, so that in the end the cell's number is
// where its references start. The order in a cell is that of the threads.
Grid fill(Grid grid, std::span<const glm::vec3> corners, unsigned threads) {
    grid.references.resize(static_cast<std::size_t>(grid.starts.back()));
    const auto fill_part = [&](std::size_t begin, std::size_t end) {
        for (std::size_t triangle = begin; triangle < end; ++triangle) {
            const auto visit = [&](std::size_t cell) {
                const std::int32_t place =
                    std::atomic_ref(grid.starts[cell]).fetch_sub(1, std::memory_order_relaxed) - 1;
                grid.references[static_cast<std::size_t>(place)] =
                    static_cast<std::int32_t>(triangle);
            };
            visit_overlapped(grid.shape, overlap_of(grid.shape, corners, triangle), visit);
        }
    };
    in_parts(threads, corners.size() / 3, triangles_in_part, fill_part);
    return grid;
}

Grid sort_references(Grid grid, unsigned threads) {
    const auto sort_part = [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            std::sort(grid.references.begin() + grid.starts[cell],
                      grid.references.begin() + grid.starts[cell + 1]);
        }
    };
    in_parts(threads, static_cast<std::size_t>(cell_count(grid.shape)), 4096, sort_part);
    return grid;
}

} // namespace

std::string slow_grid(const GridShape& shape, std::int64_t references, std::size_t triangles) {
    const int axis = longest_axis(shape);
    const std::int64_t columns = cell_count(shape) / shape.cells[axis];
    const std::int64_t met = references / columns;
    if (met < fewest_worth_a_word || static_cast<std::size_t>(met) <= triangles) {
        return "";
    }
    return fmt::format(
        "This grid will be slow: {} triangles are listed {} times in {} x {} x {} cells, as they "
        "are long beside a cell, so a ray along {} meets about {} of them, where a test of every "
        "triangle is {}. Take --structure bvh_ordered, which lists each triangle once.",
        triangles, references, shape.cells.x, shape.cells.y, shape.cells.z, "xyz"[axis], met,
        triangles);
}

Grid build_grid(std::span<const glm::vec3> corners, const GridOptions& options) {
    check_input(corners, options);
    Grid grid;
    grid.shape = shape_grid(corners, options);
    const std::int64_t cells = cell_count(grid.shape);
    check_memory(cells, 0, options);
    check_texels(cells, 0, options);
    options.say(std::to_string(cells) + " cells take " + mebibytes(cells));
    grid.starts = add_up(count_references(grid.shape, corners, options));
    const auto references = static_cast<std::int64_t>(grid.starts.back());
    options.say(std::to_string(references) + " references take " + mebibytes(references));
    const std::string warning = slow_grid(grid.shape, references, corners.size() / 3);
    if (!warning.empty()) {
        options.warn(warning);
    }
    grid = fill(std::move(grid), corners, options.threads);
    grid = sort_references(std::move(grid), options.threads);
    return mark_neighbours(std::move(grid), options.threads);
}

std::int64_t memory_of(const Grid& grid) {
    return bytes_each * static_cast<std::int64_t>(grid.starts.size() + grid.references.size());
}

} // namespace raysteps
