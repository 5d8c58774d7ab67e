#include "scene/obj_normals.h"

#include "scene/normals.h"

#include <algorithm>

namespace raysteps {

namespace {

glm::vec3 given_normal(const ObjFile& file, const ObjCorner& corner) {
    return corner.normal == not_given ? glm::vec3(0.0f) : file.normals[corner.normal];
}

std::int64_t surface_of(const ObjFile& file, const CornerOrigin& origin) {
    if (origin.smoothing_group == 0)
        return flat;
    const auto vertices = static_cast<std::int64_t>(file.positions.size());
    return origin.smoothing_group * vertices + origin.corner.position;
}

std::string describe(std::size_t given, std::size_t smooth, std::size_t flat_ones) {
    if (given + smooth == 0)
        return "It gives no normals that can be used and no smoothing groups, so every triangle is "
               "flat.";
    if (smooth + flat_ones == 0)
        return "Its own normals are used.";
    if (given + flat_ones == 0)
        return "It gives no normals that can be used, so they are made: angle-weighted within its "
               "smoothing groups.";
    return "Of its corners, " + std::to_string(given) + " have normals of their own, " +
           std::to_string(smooth) + " angle-weighted ones within smoothing groups, and " +
           std::to_string(flat_ones) + " flat ones.";
}

} // namespace

ObjNormals make_normals(const ObjFile& file, std::span<const glm::vec3> corners,
                        std::span<const CornerOrigin> origins) {
    std::vector<std::int64_t> surfaces;
    surfaces.reserve(corners.size());
    for (const CornerOrigin& origin : origins)
        surfaces.push_back(surface_of(file, origin));

    ObjNormals result{corner_normals(corners, surfaces), ""};
    std::size_t given = 0;
    std::size_t smooth = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 normal = given_normal(file, origins[i].corner);
        if (normal != glm::vec3(0.0f)) {
            result.normals[i] = normal;
            ++given;
        } else if (surfaces[i] != flat) {
            ++smooth;
        }
    }
    result.message =
        file.path.string() + ": " + describe(given, smooth, corners.size() - given - smooth);
    return result;
}

} // namespace raysteps
