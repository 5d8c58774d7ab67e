#include "scene/obj/obj_checks.h"

#include "basics/error.h"
#include "basics/text.h"
#include "scene/mesh.h"
#include "scene/obj/obj_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace raysteps {

namespace {

std::string joined(const std::vector<std::string_view>& words, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < std::min(count, words.size()); ++i)
        text.append(words[i]).append(1, ' ');
    text.back() = '\n';
    return text;
}

double checked_coordinate(std::string_view word, const ObjPlace& where) {
    const std::optional<double> number = to_number(word);
    if (!number)
        throw InputError(where.text() + in_quotes(word) + " is not a number. Check the export.");
    if (!(std::abs(*number) <= greatest_coordinate))
        throw InputError(where.text() + in_quotes(word) +
                         " is not a number between -1.8e18 and 1.8e18. Check the export.");
    return *number;
}

void check_count(const std::vector<std::string_view>& words, std::size_t least,
                 const ObjPlace& where) {
    if (words.size() < 1 + least)
        throw InputError(where.text() + std::string(words[0]) + " has " +
                         std::to_string(words.size() - 1) + " numbers, but needs " +
                         std::to_string(least) + ". Check the export.");
}

// The transfer function of sRGB (IEC 61966-2-1, 1999), backwards.
float to_linear(double value) {
    return static_cast<float>(value <= 0.04045 ? value / 12.92
                                               : std::pow((value + 0.055) / 1.055, 2.4));
}

bool is_direction(std::string_view word) {
    const std::optional<double> number = to_number(word);
    return number && std::abs(*number) <= std::numeric_limits<float>::max();
}

void check_index(std::string_view index, std::string_view corner, const ObjPlace& where) {
    constexpr std::int64_t greatest = std::numeric_limits<int>::max();
    const std::int64_t number = to_whole_number(index).value_or(0);
    if (number == 0 || number > greatest || number < -greatest)
        throw InputError(where.text() + "face has the corner " + in_quotes(corner) +
                         ", but a corner is made of whole numbers from 1 to 2147483647, or of "
                         "negative ones. Check the export.");
}

// An index of a texture coordinate or a normal may be left empty, as in 1//3 and 1/.
void check_corner(std::string_view corner, const ObjPlace& where) {
    std::string_view rest = corner;
    for (int part = 0; part < 3; ++part) {
        const std::size_t end = std::min(rest.find('/'), rest.size());
        if (part == 0 || end > 0)
            check_index(rest.substr(0, end), corner, where);
        if (end == rest.size())
            return;
        rest.remove_prefix(end + 1);
    }
    throw InputError(where.text() + "face has the corner " + in_quotes(corner) +
                     ", but a corner has at most three parts. Check the export.");
}

// A parser that looks for a number behind the slash of "1/ 2" finds that of the next corner.
std::string_view without_empty_end(std::string_view corner) {
    while (corner.ends_with('/'))
        corner.remove_suffix(1);
    return corner;
}

} // namespace

glm::dvec3 checked_position(const std::vector<std::string_view>& words, const ObjPlace& where) {
    check_count(words, 3, where);
    return {checked_coordinate(words[1], where), checked_coordinate(words[2], where),
            checked_coordinate(words[3], where)};
}

glm::vec3 checked_color(const std::vector<std::string_view>& words) {
    glm::vec3 color(1.0f);
    for (int i = 0; i < 3; ++i) {
        const double value =
            to_number(words[4 + static_cast<std::size_t>(i)]).value_or(std::nan(""));
        if (std::isnan(value))
            return glm::vec3(1.0f);
        color[i] = to_linear(std::clamp(value, 0.0, 1.0));
    }
    return color;
}

std::string checked_texture_coordinate(const std::vector<std::string_view>& words,
                                       const ObjPlace& where) {
    check_count(words, 1, where);
    for (std::size_t i = 1; i < std::min<std::size_t>(3, words.size()); ++i)
        checked_coordinate(words[i], where);
    return joined(words, 3);
}

std::string checked_normal(const std::vector<std::string_view>& words) {
    if (words.size() < 4 || !std::all_of(words.begin() + 1, words.begin() + 4, is_direction))
        return "vn 0 0 0\n";
    return joined(words, 4);
}

std::string checked_face(const std::vector<std::string_view>& words, const ObjPlace& where) {
    std::string face = "f";
    for (const std::string_view corner : std::span(words).subspan(1)) {
        check_corner(corner, where);
        face.append(1, ' ').append(without_empty_end(corner));
    }
    return face + '\n';
}

namespace {

const ObjCorner& corner_of(const ObjFile& file, const CornerOrigin& origin) {
    return file.corners[origin.corner];
}

glm::vec3 given_normal(const ObjFile& file, const CornerOrigin& origin) {
    const int normal = corner_of(file, origin).normal;
    return normal == not_given ? glm::vec3(0.0f) : file.normals[normal];
}

std::int64_t surface_of(const ObjFile& file, const CornerOrigin& origin) {
    if (origin.smoothing_group == 0)
        return flat;
    const auto vertices = static_cast<std::int64_t>(file.positions.size());
    return origin.smoothing_group * vertices + corner_of(file, origin).position;
}

// Those of corners without a smoothing group are not written down, where no corner has one.
std::vector<std::int64_t> surfaces_of(const ObjFile& file, std::span<const CornerOrigin> origins) {
    const bool all_flat = std::all_of(origins.begin(), origins.end(), [](const CornerOrigin& one) {
        return one.smoothing_group == 0;
    });
    std::vector<std::int64_t> surfaces;
    if (all_flat)
        return surfaces;
    surfaces.reserve(origins.size());
    for (const CornerOrigin& origin : origins)
        surfaces.push_back(surface_of(file, origin));
    return surfaces;
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
    const std::vector<std::int64_t> surfaces = surfaces_of(file, origins);
    ObjNormals result{corner_normals(corners, surfaces), ""};
    std::size_t given = 0;
    std::size_t smooth = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 normal = given_normal(file, origins[i]);
        if (normal != glm::vec3(0.0f)) {
            result.normals[i] = normal;
            ++given;
        } else if (origins[i].smoothing_group != 0) {
            ++smooth;
        }
    }
    result.message =
        file.path.string() + ": " + describe(given, smooth, corners.size() - given - smooth);
    return result;
}

} // namespace raysteps
