#pragma once

#include "visualizer/replay/structure_cells.h"
#include "structure/structure.h"
#include "state.h"

#include <map>
#include <string>

namespace raysteps::view {

// A structure as a state names it: `bvh_ordered:split=median` has a value of its own. Of a family,
// as in `kd`, it is a usual walk.
struct StructureName {
    std::string structure;
    std::map<std::string, std::string> values;
};

// Throws InputError where there is no such structure, or a value has no name.
StructureName read_structure_name(const std::string& text);

// The values for its builder: its own, and of those for all panes the ones that the builder knows.
// Throws InputError where it does not know one of its own.
std::map<std::string, std::string> values_for(const StructureName& name, const State& state);

// The costs that the builder reckoned with; of one that does not, those of CellCosts.
CellCosts costs_of(const StructureFamily& family, const std::map<std::string, std::string>& values);

} // namespace raysteps::view
