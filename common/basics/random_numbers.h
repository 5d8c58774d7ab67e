#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <random>

namespace raysteps {

// The same numbers from the same seed everywhere: the C++ standard fixes what std::mt19937 gives,
// but not how std::uniform_real_distribution uses it, so the last step is ours.
class RandomNumbers {
public:
    explicit RandomNumbers(int seed) : generator_(static_cast<std::uint32_t>(seed)) {}

    // One of 0, 1, ... limit - 1, almost equally likely; limit is at least 1.
    int below(int limit) {
        return static_cast<int>(generator_() % static_cast<std::uint32_t>(limit));
    }

    // In [0, 1), a multiple of 2^-24, so every value is exact.
    float unit() { return static_cast<float>(generator_() >> 8) * 0x1p-24f; }

    // In the cube from -1 to 1.
    glm::vec3 in_cube() {
        const float x = 2.0f * unit() - 1.0f;
        const float y = 2.0f * unit() - 1.0f;
        const float z = 2.0f * unit() - 1.0f;
        return {x, y, z};
    }

private:
    std::mt19937 generator_;
};

} // namespace raysteps
