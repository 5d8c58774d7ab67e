#pragma once

#include "scene/mesh.h"
#include "scene/random_numbers.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace raysteps {

enum class Order { forward, backward, shuffled };

inline constexpr std::array all_orders{Order::forward, Order::backward, Order::shuffled};

// The numbers of so many triangles, in that order.
inline std::vector<std::size_t> numbers_in(Order order, std::size_t triangles) {
    std::vector<std::size_t> places(triangles);
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (order == Order::backward) {
        std::reverse(places.begin(), places.end());
    }
    if (order == Order::shuffled) {
        RandomNumbers numbers(99);
        for (std::size_t i = places.size(); i > 1; --i) {
            std::swap(places[i - 1],
                      places[static_cast<std::size_t>(numbers.below(static_cast<int>(i)))]);
        }
    }
    return places;
}

// The triangles in another order.
inline Mesh reordered(const Mesh& mesh, Order order) {
    Mesh result;
    for (const std::size_t triangle : numbers_in(order, mesh.corners.size() / 3)) {
        for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
            result.corners.push_back(mesh.corners[corner]);
            result.normals.push_back(mesh.normals[corner]);
        }
    }
    return result;
}

// Each triangle once more at the end, and once more with its corners the other way round.
inline Mesh tripled(const Mesh& mesh) {
    Mesh turned = mesh;
    for (std::size_t i = 0; i < turned.corners.size(); i += 3) {
        std::swap(turned.corners[i + 1], turned.corners[i + 2]);
    }
    return join(join(mesh, mesh), turned);
}

} // namespace raysteps
