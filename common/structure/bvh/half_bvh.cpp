#include "structure/bvh/bvh.h"

#include "basics/box.h"

#include <bit>
#include <cmath>

namespace raysteps {

namespace {

// Halves from 0 to 1 that are not denormal, in order: number 0 is 0, number 1 is 2^-14.
constexpr int first_normal = 0x0400;
constexpr int one = 0x3c00;
constexpr int half_count = one - first_normal + 2;

int bits_of_number(int number) {
    return number == 0 ? 0 : first_normal + number - 1;
}

// The first of the halves for which the question is answered with yes; it stays yes from there on.
template <class Question>
int first_number(const Question& question) {
    int low = 0;
    int high = half_count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (question(bits_of_number(middle))) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

HalfFrame frame_of(const Box& box) {
    HalfFrame frame{box.lower, box.upper - box.lower};
    for (int axis = 0; axis < 3; ++axis) {
        while (frame.lower[axis] + frame.size[axis] < box.upper[axis]) {
            frame.size[axis] = std::nextafter(frame.size[axis], INFINITY);
        }
    }
    return frame;
}

glm::vec3 point_of(const glm::ivec4& texel) {
    return {std::bit_cast<float>(texel.x), std::bit_cast<float>(texel.y),
            std::bit_cast<float>(texel.z)};
}

int both(int low, int high) {
    return static_cast<int>(static_cast<unsigned>(low) | static_cast<unsigned>(high) << 16U);
}

glm::ivec4 half_node(const HalfFrame& frame, const glm::ivec4& first, const glm::ivec4& last,
                     int node_count) {
    const glm::vec3 lower = point_of(first);
    const glm::vec3 upper = point_of(last);
    const bool leaf = last.w >= 0;
    const int next = first.w < 0 ? node_count : first.w;
    return {both(half_below(frame, 0, lower.x), half_below(frame, 1, lower.y)),
            both(half_below(frame, 2, lower.z), half_above(frame, 0, upper.x)),
            both(half_above(frame, 1, upper.y), half_above(frame, 2, upper.z)),
            leaf ? -1 - last.w : next};
}

} // namespace

float half_plane(const HalfFrame& frame, int axis, int bits) {
    const float share = bits == 0 ? 0.0f : std::bit_cast<float>((bits << 13) + (112 << 23));
    return frame.lower[axis] + frame.size[axis] * share;
}

//# exercise 8.4: rounded outwards
int half_below(const HalfFrame& frame, int axis, float value) {
    return bits_of_number(
        first_number([&](int bits) { return half_plane(frame, axis, bits) > value; }) - 1);
}

int half_above(const HalfFrame& frame, int axis, float value) {
    return bits_of_number(
        first_number([&](int bits) { return half_plane(frame, axis, bits) >= value; }));
}
//# stub: int half_below(const HalfFrame& /*frame*/, int /*axis*/, float /*value*/) {
//# stub:     return 0;
//# stub: }
//# stub: int half_above(const HalfFrame& /*frame*/, int /*axis*/, float /*value*/) {
//# stub:     return one;
//# stub: }
//# end

PackedStructure with_half_boxes(const PackedStructure& bvh) {
    const int count = bvh.numbers.at("bvh_node_count");
    const std::vector<glm::ivec4>& nodes = bvh.integer_vectors.at("bvh_nodes");
    HalfFrame frame;
    std::vector<glm::ivec4> halves;
    if (count > 0) { // octant 0 comes first, and in it the root
        frame = frame_of({point_of(nodes[0]), point_of(nodes[1])});
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        halves.push_back(half_node(frame, nodes[2 * i], nodes[2 * i + 1], count));
    }
    PackedStructure packed;
    packed.integer_vectors["half_nodes"] = halves;
    packed.integer_vectors["bvh_triangles"] = bvh.integer_vectors.at("bvh_triangles");
    packed.points["half_lower"] = frame.lower;
    packed.points["half_size"] = frame.size;
    packed.numbers["bvh_node_count"] = count;
    return packed;
}

} // namespace raysteps
