#pragma once

#include "program/output.h"
#include "scene/scene.h"
#include "structure/faults.h"
#include "structure/tree_file/tree_file.h"

#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// A tree by numbers: that of the file, or one to compare it with.
struct MeasuredTree {
    std::string name;
    BoxTreeMeasures measures;
};

// What can be said of a tree without a ray.
struct Inspection {
    FaultList faults;
    FaultList remarks;
    std::vector<std::string> guesses;   // what may be behind them
    std::vector<MeasuredTree> measured; // of hierarchies of boxes; that of the file comes first
};

// The tree over the scene's triangles, in its numbers. Calls progress with the part that is done.
Inspection inspect(const AnyTree& tree, const Scene& scene, const BvhOptions& options,
                   const std::function<void(double)>& progress);

// The tree of Embree's builder. Throws MachineError where Embree is missing.
BoxTree embree_tree(std::span<const glm::vec3> corners, const BvhOptions& options);

// For people, and for programs (check.schema.json).
std::string to_table(const Inspection& inspection);
Numbers numbers_of(const Inspection& inspection);

} // namespace raysteps
