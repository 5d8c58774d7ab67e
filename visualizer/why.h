#pragma once

#include "stage.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace raysteps::view {

// Why the walk of the state's ray through the first structure does not come to the state's
// triangle.
struct Why {
    std::vector<std::string> lines; // why_lines at most
    std::vector<glm::vec3> corners; // of the triangle
    std::optional<Box> box;         // that left it out
};

// Nothing where the state does not ask. Nodes have the numbers of the tree's file, and those of the
// cells where it is of our own builder.
std::optional<Why> why_of(const Stage& stage, const State& state);

// What the watertight test finds in a loop over every triangle.
Hit hit_by_loop(const Stage& stage, const Ray& ray);

} // namespace raysteps::view
