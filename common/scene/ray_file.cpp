#include "scene/ray_file.h"

#include "basics/box.h"
#include "basics/error.h"
#include "basics/file.h"
#include "basics/text.h"
#include "scene/scaling.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace raysteps {

namespace {

// 128 million rays: more than the textures of a machine hold.
constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 30;

bool is_csv(const std::filesystem::path& path) {
    return path.extension() == ".csv";
}

std::vector<Ray> parse_binary(const std::string& bytes, const std::filesystem::path& path) {
    if (bytes.size() % sizeof(Ray) != 0) {
        throw InputError(path.string() + ": the file has " + std::to_string(bytes.size()) +
                         " bytes, but a ray has 32 (8 float32). Check how it was written.");
    }
    std::vector<Ray> rays(bytes.size() / sizeof(Ray));
    if (!bytes.empty()) {
        std::memcpy(rays.data(), bytes.data(), bytes.size());
    }
    return rays;
}

void check(const Ray& ray, std::size_t number, const std::filesystem::path& path) {
    const std::string place = path.string() + ": ray " + std::to_string(number) + " (from 0)";
    if (!is_finite(ray.origin) || !is_finite(ray.direction) || !std::isfinite(ray.t_min) ||
        std::isnan(ray.t_max)) {
        throw InputError(place + " has a number that is not finite. Only t_max may be infinite.");
    }
    if (ray.direction == glm::vec3(0.0f)) {
        throw InputError(place + " has no direction. Leave it out, or give it one.");
    }
}

// Nine digits give back the same float.
void append_csv(std::string& text, const Ray& ray) {
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", ray.origin.x,
                        ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y,
                        ray.direction.z, ray.t_min, ray.t_max);
}

void append_csv(std::string& text, const Hit& hit) {
    text += fmt::format("{:.9g},{:.9g},{:.9g},{}\n", hit.t, hit.u, hit.v, hit.triangle);
}

// As the ending of the path asks for.
template <class Record>
void write_list(const std::filesystem::path& path, const std::string& header,
                std::span<const Record> records) {
    std::string bytes;
    if (is_csv(path)) {
        bytes = header;
        for (const Record& record : records) {
            append_csv(bytes, record);
        }
    } else if (!records.empty()) {
        bytes.resize(records.size_bytes());
        std::memcpy(bytes.data(), records.data(), records.size_bytes());
    }
    write_file(path, bytes);
}

// The indices of the columns in the eight numbers of a ray.
constexpr std::array<std::string_view, 8> columns{"origin_x",    "origin_y",    "origin_z",
                                                  "direction_x", "direction_y", "direction_z",
                                                  "t_min",       "t_max"};

std::string_view trim(std::string_view word) {
    const auto first = word.find_first_not_of(" \t\r\"");
    if (first == std::string_view::npos) {
        return {};
    }
    return word.substr(first, word.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string_view> split_cells(std::string_view line) {
    std::vector<std::string_view> cells;
    while (true) {
        const auto comma = line.find(',');
        cells.push_back(trim(line.substr(0, comma)));
        if (comma == std::string_view::npos) {
            return cells;
        }
        line.remove_prefix(comma + 1);
    }
}

// With or without the names of the triangles.
bool is_header_of_hits(std::vector<std::string_view> cells) {
    if (cells.size() == 5 && cells.back() == "name") {
        cells.pop_back();
    }
    return cells == std::vector<std::string_view>{"t", "u", "v", "triangle"};
}

[[noreturn]] void fail(const std::filesystem::path& path, int line, const std::string& what) {
    throw InputError(path.string() + ":" + std::to_string(line) + ": " + what);
}

// Which number of a ray each cell of a line is.
std::vector<std::size_t> read_header(std::string_view line, const std::filesystem::path& path) {
    std::vector<std::size_t> indices;
    for (const std::string_view cell : split_cells(line)) {
        const auto column = std::find(columns.begin(), columns.end(), cell);
        if (column == columns.end()) {
            fail(path, 1,
                 "there is no column `" + std::string(cell) +
                     "`. The columns are origin_x, origin_y, origin_z, direction_x, direction_y, "
                     "direction_z, t_min, t_max.");
        }
        indices.push_back(static_cast<std::size_t>(column - columns.begin()));
    }
    std::vector<std::size_t> sorted = indices;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() != columns.size() ||
        std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        fail(path, 1, "each of the eight columns is needed once. Name them in the first line.");
    }
    return indices;
}

Ray read_line(std::string_view line, const std::vector<std::size_t>& indices,
              const std::filesystem::path& path, int number, const glm::dvec3& origin) {
    const std::vector<std::string_view> cells = split_cells(line);
    if (cells.size() != indices.size()) {
        fail(path, number,
             "the line has " + std::to_string(cells.size()) + " cells, but 8 are needed.");
    }
    std::array<float, 8> numbers{};
    glm::dvec3 in_file(0.0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto parsed = parse_number<float>(cells[i]);
        if (!parsed) {
            fail(path, number, "`" + std::string(cells[i]) + "` is not a number.");
        }
        numbers[indices[i]] = *parsed;
        if (indices[i] < 3) {
            in_file[static_cast<int>(indices[i])] = parse_number<double>(cells[i]).value_or(0.0);
        }
    }
    if (origin != glm::dvec3(0.0)) { // beside which a float would have too few digits
        const glm::vec3 seen = as_seen_from(origin, in_file);
        numbers[0] = seen.x;
        numbers[1] = seen.y;
        numbers[2] = seen.z;
    }
    return {{numbers[0], numbers[1], numbers[2]},
            {numbers[3], numbers[4], numbers[5]},
            numbers[6],
            numbers[7]};
}

} // namespace

static_assert(std::endian::native == std::endian::little, "ray files are little-endian");

std::vector<Ray> read_ray_file(const std::filesystem::path& path, const glm::dvec3& origin) {
    const std::string bytes = read_file(path, most_bytes);
    std::vector<Ray> rays =
        is_csv(path) ? parse_ray_csv(bytes, path, origin) : parse_binary(bytes, path);
    for (std::size_t i = 0; i < rays.size() && !is_csv(path); ++i) {
        rays[i].origin = as_seen_from(origin, glm::dvec3(rays[i].origin));
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        check(rays[i], i, path);
    }
    return rays;
}

std::string unusual_lengths(std::span<const Ray> rays, const std::filesystem::path& path,
                            double reach) {
    const double longest = 0x1p103 * reach;
    const double shortest = 0x1p-128 * reach;
    const auto is_unusual = [&](const Ray& ray) {
        const glm::vec3 sizes = glm::abs(ray.direction);
        const auto length = static_cast<double>(std::max({sizes.x, sizes.y, sizes.z}));
        bool is_uneven = false;
        for (int axis = 0; axis < 3; ++axis) {
            is_uneven = is_uneven || std::fpclassify(ray.direction[axis]) == FP_SUBNORMAL;
        }
        return length > longest || length <= shortest || is_uneven;
    };
    const auto first = std::find_if(rays.begin(), rays.end(), is_unusual);
    if (first == rays.end()) {
        return "";
    }
    return fmt::format(
        "{}: {} of {} rays (the first is ray {}, from 0) have directions so long or so short that "
        "floats do not hold every t, and may hit otherwise with another --structure or on another "
        "machine. Scale them to {:.2g} to {:.2g} for the longest component, and leave no other "
        "under 1.2e-38 that is not 0.",
        path.string(), std::count_if(first, rays.end(), is_unusual), rays.size(),
        first - rays.begin(), std::max(shortest, 0x1p-126), std::min(longest, 0x1p126));
}

void write_ray_file(const std::filesystem::path& path, std::span<const Ray> rays) {
    write_list(path, fmt::format("{}\n", fmt::join(columns, ",")), rays);
}

void write_hit_file(const std::filesystem::path& path, std::span<const Hit> hits) {
    write_list(path, "t,u,v,triangle\n", hits);
}

void write_hit_file(const std::filesystem::path& path, std::span<const Hit> hits,
                    const Scene& scene) {
    if (!is_csv(path) || scene.runs.empty()) {
        write_hit_file(path, hits);
        return;
    }
    std::string text = "t,u,v,triangle,name\n";
    for (const Hit& hit : hits) {
        append_csv(text, hit);
        text.back() = ',';
        text += csv_field(name_of_triangle(scene, hit.triangle)) + "\n";
    }
    write_file(path, text);
}

std::vector<Hit> read_hit_file(const std::filesystem::path& path) {
    const std::string bytes = read_file(path, most_bytes);
    if (!is_csv(path)) {
        if (bytes.size() % sizeof(Hit) != 0) {
            throw InputError(path.string() + ": the file has " + std::to_string(bytes.size()) +
                             " bytes, but a hit has 16 (t, u, v as float32, the triangle as "
                             "int32). Check how it was written.");
        }
        std::vector<Hit> hits(bytes.size() / sizeof(Hit));
        if (!bytes.empty()) {
            std::memcpy(hits.data(), bytes.data(), bytes.size());
        }
        return hits;
    }
    std::vector<Hit> hits;
    bool named = false;
    std::string_view text = bytes;
    for (int number = 1; !text.empty(); ++number) {
        const auto end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const std::vector<std::string_view> cells = split_cells(line);
        if (number == 1 || trim(line).empty()) {
            if (number == 1 && !is_header_of_hits(cells)) {
                fail(path, 1, "the first line names the columns: t,u,v,triangle.");
            }
            named = named || cells.size() > 4;
            continue;
        }
        const bool complete = named ? cells.size() > 4 : cells.size() == 4; // a name has commas
        const auto triangle = complete ? parse_number<int>(cells[3]) : std::nullopt;
        std::array<float, 3> numbers{};
        for (std::size_t i = 0; complete && i < numbers.size(); ++i) {
            numbers[i] =
                parse_number<float>(cells[i]).value_or(std::numeric_limits<float>::quiet_NaN());
        }
        if (!triangle) {
            fail(path, number, "a line has t, u, v and the number of a triangle, or -1.");
        }
        hits.push_back({numbers[0], numbers[1], numbers[2], *triangle});
    }
    return hits;
}

std::vector<Ray> parse_ray_csv(std::string_view text, const std::filesystem::path& path,
                               const glm::dvec3& origin) {
    std::vector<Ray> rays;
    std::vector<std::size_t> indices;
    for (int number = 1; !text.empty(); ++number) {
        const auto end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (number == 1) {
            indices = read_header(line, path);
        } else if (!trim(line).empty()) {
            rays.push_back(read_line(line, indices, path, number, origin));
        }
    }
    if (indices.empty()) {
        fail(path, 1, "the file is empty. Its first line names the columns.");
    }
    return rays;
}

} // namespace raysteps
