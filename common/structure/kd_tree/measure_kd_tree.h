#pragma once

#include "structure/kd_options.h"
#include "structure/kd_tree.h"

namespace raysteps {

struct KdMeasures {
    std::size_t nodes = 0;
    std::size_t leaves = 0;
    std::size_t empty_leaves = 0;
    std::size_t longest_leaf = 0; // in references
    std::size_t references = 0;
    int depth = 0;     // of the deepest leaf, the root being at 0
    double cost = 0.0; // what the surface-area heuristic expects of a ray through the root's box
    std::size_t bytes = 0;
};

// The tree is that of build_kd_tree; of the options, only the costs matter.
KdMeasures measure_kd_tree(const KdTree& tree, const KdOptions& options);

} // namespace raysteps
