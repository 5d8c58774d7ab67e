#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// A structure as the kernels read it: each array and each number under the name of its uniform.
struct PackedStructure {
    std::map<std::string, std::vector<glm::vec4>> vectors;          // samplerBuffer
    std::map<std::string, std::vector<glm::ivec4>> integer_vectors; // isamplerBuffer, four a texel
    std::map<std::string, std::vector<std::int32_t>> integers;      // isamplerBuffer, one a texel
    std::map<std::string, glm::vec3> points;
    std::map<std::string, glm::ivec3> counts;
    std::map<std::string, int> numbers;
};

// A choice that a builder leaves to its user: --NAME on the command line.
struct BuildOption {
    std::string name;
    std::string initial; // what holds where it is not given
    std::string meaning;
};

// Prints the sentence on a line of standard error.
void print_warning(const std::string& sentence);

// What a builder is asked for beside the triangles.
struct BuildRequest {
    float reach = 0.0f; // the rays' origins lie at most so far from any corner, along each axis
    std::map<std::string, std::string>
        values{}; // of BuildOptions, by name; the initial where absent
    // Called with what the builder is about to take, in words, before it is taken.
    std::function<void(const std::string&)> say = [](const std::string&) {};
    // Called with a sentence, before the long work, where the structure will serve badly.
    std::function<void(const std::string&)> warn = print_warning;
    // The most texels that an array may have: the GPU's limit, where a GPU is to read it. A builder
    // that lists triangles more than once stops as soon as it knows that it will need more.
    std::int64_t most_texels = std::numeric_limits<std::int32_t>::max();
};

// A measured property of a structure that was built: ("cells", 4096).
struct Fact {
    std::string name;
    double value;
};

// As people read it, with its unit: of `memory_bytes` 1860524 it is "memory 1.86 MB".
std::string readable(const Fact& fact);

struct BuiltStructure {
    PackedStructure packed;
    std::vector<Fact> facts; // in the order in which they are to be read
    int longest_walk = 0;    // in rounds, where it is known beforehand; else 0
};

// No structure: nothing is built, and each ray tests every triangle.
inline BuiltStructure every_triangle(int triangle_count) {
    BuiltStructure loop;
    loop.packed.numbers["triangle_count"] = triangle_count;
    loop.longest_walk = triangle_count;
    return loop;
}

// A structure that one builder makes for several walks. The family `kd` serves the walks
// kd_*.glsl of shaders/structure/kd_tree (and would serve kd.glsl). Throws InputError where a value
// of the request makes no sense, or where the memory would be too much, and MachineError where an
// array would have more than the most texels.
struct StructureFamily {
    std::string name;
    std::vector<BuildOption> options;
    std::function<BuiltStructure(std::span<const glm::vec3> corners, const BuildRequest& request)>
        build; // three corners a triangle
};

// All families there are: each file family_NAME.cpp of this folder and its subfolders defines one,
// and CMake writes the list. So a new builder needs no entry anywhere.
std::vector<StructureFamily> list_families();

// A structure's name may say more than one walk: `packet_NAME` walks through NAME, neighbours in
// packets of four rays and others by themselves, and `fastest` is what is the fastest for each kind
// of rays. The name of the walk of rays by themselves: that of most names is the name.
std::string single_walk(const std::string& structure);

// Whether rays that are neighbours go in packets.
bool has_packets(const std::string& structure);

// The family that serves the structure of that name. Throws InputError where none does.
StructureFamily family_of(const std::string& structure);

// The options of all builders by name. Several may ask for one of the same name; its meaning then
// has each builder's own values.
std::map<std::string, BuildOption> all_build_options();

// Every option of the structure's builder with its value: the given one, else the initial.
std::map<std::string, std::string>
used_build_values(const std::string& structure, const std::map<std::string, std::string>& values);

// A walk, and options of its builder that hold for it alone.
struct StructureChoice {
    std::string text;      // as it was given: its name in tables
    std::string structure; // bvh_ordered
    std::map<std::string, std::string> values{};
};

// `bvh_ordered`, or with options `bvh_ordered:split=median:bins=8`. Throws InputError where nobody
// builds for it, or its builder has no such option.
StructureChoice parse_structure(const std::string& text);

// Throws InputError where a value was given that no builder of these structures has an option for:
// it would be passed over in silence.
void check_build_values(const std::map<std::string, std::string>& values,
                        std::span<const std::string> structures);

} // namespace raysteps
