#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
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

} // namespace raysteps
