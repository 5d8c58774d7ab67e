#include "hard_cases/meshes.h"
#include "scene/obj/load_obj.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace raysteps {

namespace {

using Place = std::array<float, 3>;
using Edge = std::pair<Place, Place>; // the smaller end first

Place place_of(const glm::vec3& corner) {
    return {corner.x, corner.y, corner.z};
}

Edge edge_between(const glm::vec3& a, const glm::vec3& b) {
    return std::minmax(place_of(a), place_of(b));
}

} // namespace

// Nine digits tell any two floats apart.
Mesh as_loaded(const Mesh& mesh) {
    std::string text;
    const auto out = std::back_inserter(text);
    for (const glm::vec3& corner : mesh.corners) {
        fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", corner.x, corner.y, corner.z);
    }
    for (std::size_t first = 1; first + 2 <= mesh.corners.size(); first += 3) {
        fmt::format_to(out, "f {} {} {}\n", first, first + 1, first + 2);
    }
    Scene scene = parse_obj(text, "hard_case.obj");
    return {std::move(scene.corners), std::move(scene.normals)};
}

Mesh split_on_one_side(const Mesh& mesh) {
    std::vector<glm::vec3> corners;
    std::set<Edge> split;
    for (std::size_t first = 0; first < mesh.corners.size(); first += 3) {
        std::size_t at = 0;
        while (at < 3 && !split
                              .insert(edge_between(mesh.corners[first + at],
                                                   mesh.corners[first + (at + 1) % 3]))
                              .second) {
            ++at;
        }
        const glm::vec3 a = mesh.corners[first + at % 3];
        const glm::vec3 b = mesh.corners[first + (at + 1) % 3];
        const glm::vec3 c = mesh.corners[first + (at + 2) % 3];
        if (at == 3) { // all its edges are split on the other side
            corners.insert(corners.end(), {a, b, c});
            continue;
        }
        const glm::vec3 middle = 0.5f * a + 0.5f * b;
        corners.insert(corners.end(), {a, middle, c, middle, b, c, a, b, middle});
    }
    return mesh_of(std::move(corners));
}

Mesh jittered_sphere(RandomNumbers& numbers, int rows, int around, const glm::vec3& center) {
    const Mesh sphere = latitude_sphere(1.0f, rows, around);
    std::map<Place, glm::vec3> moved;
    std::vector<glm::vec3> corners;
    for (const glm::vec3& corner : sphere.corners) {
        const auto [place, is_new] = moved.try_emplace(place_of(corner));
        if (is_new) {
            const double radius = 1.0 + 0.1 * (static_cast<double>(numbers.unit()) - 0.5);
            place->second = glm::vec3(glm::dvec3(center) + radius * glm::dvec3(corner));
        }
        corners.push_back(place->second);
    }
    return mesh_of(std::move(corners));
}

std::vector<glm::vec3> corners_without_area(const Mesh& mesh) {
    std::vector<glm::vec3> corners;
    for (std::size_t first = 0; first < mesh.corners.size(); first += 3) {
        const std::array three{mesh.corners[first], mesh.corners[first + 1],
                               mesh.corners[first + 2]};
        if (area_vector(three[0], three[1], three[2]) == glm::dvec3(0.0)) {
            corners.insert(corners.end(), three.begin(), three.end());
        }
    }
    return corners;
}

} // namespace raysteps
