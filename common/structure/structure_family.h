#pragma once

#include "structure/packed_structure.h"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// A choice that a builder leaves to its user: --NAME on the command line.
struct BuildOption {
    std::string name;
    std::string initial;
    std::string meaning;
};

// What a builder is asked for beside the triangles.
struct BuildRequest {
    float reach = 0.0f; // the rays' origins lie at most so far from any corner, along each axis
    std::map<std::string, std::string>
        values{}; // of BuildOptions, by name; the initial where absent
    // Called with what the builder is about to take, in words, before it is taken.
    std::function<void(const std::string&)> say = [](const std::string&) {};
};

// A measured property of a structure that was built: ("cells", 4096).
struct Fact {
    std::string name;
    double value;
};

struct BuiltStructure {
    PackedStructure packed;
    std::vector<Fact> facts; // in the order in which they are to be read
    int longest_walk = 0;    // in rounds, where it is known beforehand; else 0
};

// A structure that one builder makes for several walks. The family `kd` serves the parts
// structure/kd_*.glsl (and structure/kd.glsl). Throws InputError where a value of the request makes
// no sense, or where the memory would be too much.
struct StructureFamily {
    std::string name;
    std::vector<BuildOption> options;
    std::function<BuiltStructure(std::span<const glm::vec3> corners, const BuildRequest& request)>
        build; // three corners a triangle
};

} // namespace raysteps
