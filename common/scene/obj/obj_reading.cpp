#include "scene/obj_reading.h"

#include "error/error.h"
#include "scene/obj_numbers.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace raysteps {

ObjReading::ObjReading(std::string_view text, const std::filesystem::path& path)
    : statements_(text, path) {
    file_.path = path;
}

void ObjReading::take_position(float x, float y, float z) {
    file_.positions.emplace_back(checked(x), checked(y), checked(z));
}

void ObjReading::take_texture_coordinate(float x, float y) {
    file_.texture_coordinates.emplace_back(checked(x), checked(y));
}

// A float's square may be no float, so the length is taken in double.
void ObjReading::take_normal(float x, float y, float z) {
    const glm::dvec3 normal(x, y, z);
    const double length = glm::length(normal);
    if (length > 0.0 && std::isfinite(length)) {
        file_.normals.emplace_back(normal / length);
        return;
    }
    file_.normals.emplace_back(0.0f);
    statements_.findings().note(
        "A normal is zero or not finite; corners that name it get one that is made",
        statements_.line());
}

void ObjReading::take_material(const std::string& name) {
    const auto next = static_cast<int>(file_.material_names.size());
    const auto [entry, is_new] = index_of_material_.try_emplace(name, next);
    if (is_new)
        file_.material_names.push_back(name);
    material_name_ = entry->second;
}

void ObjReading::begin_face() {
    ObjFace face;
    face.line = statements_.line();
    face.first_corner = file_.corners.size();
    face.material_name = material_name_;
    face.smoothing_group = statements_.smoothing_group();
    file_.faces.push_back(face);
}

void ObjReading::take_corner(int position, int texture_coordinate, int normal) {
    const int texture_index =
        to_index(texture_coordinate, file_.texture_coordinates.size(), "texture coordinate");
    file_.corners.push_back({to_index(position, file_.positions.size(), "vertex"), texture_index,
                             to_index(normal, file_.normals.size(), "normal")});
    ++file_.faces.back().corner_count;
}

ObjFile ObjReading::finish() {
    for (const ObjFace& face : file_.faces)
        check_indices(face);
    file_.libraries = statements_.libraries();
    file_.findings = statements_.findings();
    return std::move(file_);
}

float ObjReading::checked(float coordinate) const {
    if (std::abs(coordinate) <= static_cast<float>(greatest_coordinate))
        return coordinate;
    throw InputError(statements_.where() +
                     "a coordinate is not a number between -1.8e18 and 1.8e18. Check the export.");
}

int ObjReading::to_index(int number, std::size_t count, const char* what) const {
    if (number >= 0)
        return number - 1;
    const std::int64_t index = static_cast<std::int64_t>(count) + number;
    if (index >= 0)
        return static_cast<int>(index);
    throw InputError(statements_.where() + "face names " + what + " " + std::to_string(number) +
                     ", but only " + std::to_string(count) + " stand above it. Check the export.");
}

void ObjReading::check_indices(const ObjFace& face) const {
    for (int i = 0; i < face.corner_count; ++i) {
        const ObjCorner& corner = file_.corners[face.first_corner + static_cast<std::size_t>(i)];
        if (corner.position == not_given)
            throw InputError(place(file_.path, face.line) +
                             "face has a corner without a vertex. Check the export.");
        check_index(corner.position, file_.positions.size(), "vertex", face);
        check_index(corner.texture_coordinate, file_.texture_coordinates.size(),
                    "texture coordinate", face);
        check_index(corner.normal, file_.normals.size(), "normal", face);
    }
}

void ObjReading::check_index(int index, std::size_t count, const char* what,
                             const ObjFace& face) const {
    if (index < static_cast<std::int64_t>(count))
        return;
    throw InputError(place(file_.path, face.line) + "face names " + what + " " +
                     std::to_string(index + std::int64_t{1}) + ", but the file has " +
                     std::to_string(count) + ". Check the export.");
}

} // namespace raysteps
