#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include <bit>
#include <cassert>
#include <cstdint>
#include <span>

// What a shader part takes for granted in GLSL, for the parts that are compiled as C++.
namespace raysteps::mirror {

using glm::abs;
using glm::clamp;
using glm::floor;
using glm::greaterThan;
using glm::ivec3;
using glm::ivec4;
using glm::lessThan;
using glm::max;
using glm::min;
using glm::mix;
using glm::sqrt;
using glm::uvec4;
using glm::vec3;
using glm::vec4;
using uint = unsigned;

// The names are GLSL's own.
// NOLINTBEGIN(readability-identifier-naming)
struct samplerBuffer {
    std::span<const vec4> texels;
};

// One integer a texel, or four.
struct isamplerBuffer {
    std::span<const std::int32_t> texels;
    std::span<const ivec4> vectors;
};

// A GPU returns zero for a place outside; here it is a fault.
inline vec4 texelFetch(const samplerBuffer& buffer, int place) {
    assert(place >= 0 && static_cast<std::size_t>(place) < buffer.texels.size());
    return buffer.texels[static_cast<std::size_t>(place)];
}

inline ivec4 texelFetch(const isamplerBuffer& buffer, int place) {
    if (!buffer.vectors.empty()) {
        assert(place >= 0 && static_cast<std::size_t>(place) < buffer.vectors.size());
        return buffer.vectors[static_cast<std::size_t>(place)];
    }
    assert(place >= 0 && static_cast<std::size_t>(place) < buffer.texels.size());
    return {buffer.texels[static_cast<std::size_t>(place)], 0, 0, 1};
}

inline int floatBitsToInt(float value) {
    return std::bit_cast<std::int32_t>(value);
}

inline float intBitsToFloat(int bits) {
    return std::bit_cast<float>(bits);
}

inline vec4 intBitsToFloat(const ivec4& bits) {
    return {intBitsToFloat(bits.x), intBitsToFloat(bits.y), intBitsToFloat(bits.z),
            intBitsToFloat(bits.w)};
}

inline unsigned floatBitsToUint(float value) {
    return std::bit_cast<unsigned>(value);
}

inline float uintBitsToFloat(unsigned bits) {
    return std::bit_cast<float>(bits);
}
// NOLINTEND(readability-identifier-naming)

} // namespace raysteps::mirror
