#include "structure/grid_neighbours.h"

#include "parallel/on_threads.h"

#include <atomic>
#include <span>

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

} // namespace raysteps
