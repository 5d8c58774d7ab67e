#pragma once

#include "recorded_walk.h"

#include <cstddef>
#include <optional>

namespace raysteps {

// A walk in its structure.
struct WalkIn {
    const StructureCells& structure;
    const RecordedWalk& walk;
};

// The first steps at which two walks do something else, counted from 0. Where one walk is over, it
// is its last.
struct Parting {
    std::size_t first_step = 0;
    std::size_t second_step = 0;
};

// Where the walks part; nothing where they never do. In the same structure they part at the first
// place that is not the same, or not treated the same. In two structures, places have nothing in
// common, so they part at the first triangle test that is not the same.
std::optional<Parting> find_parting(const WalkIn& first, const WalkIn& second);

} // namespace raysteps
