#include "scene/ray_csv.h"

#include "error/error.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace raysteps {

namespace {

// The places of the columns in the eight numbers of a ray.
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

[[noreturn]] void fail(const std::filesystem::path& path, int line, const std::string& what) {
    throw InputError(path.string() + ":" + std::to_string(line) + ": " + what);
}

// Which number of a ray each cell of a line is.
std::vector<std::size_t> read_header(std::string_view line, const std::filesystem::path& path) {
    std::vector<std::size_t> places;
    for (const std::string_view cell : split_cells(line)) {
        const auto column = std::find(columns.begin(), columns.end(), cell);
        if (column == columns.end()) {
            fail(path, 1,
                 "there is no column `" + std::string(cell) +
                     "`. The columns are origin_x, origin_y, origin_z, direction_x, direction_y, "
                     "direction_z, t_min, t_max.");
        }
        places.push_back(static_cast<std::size_t>(column - columns.begin()));
    }
    std::vector<std::size_t> sorted = places;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() != columns.size() ||
        std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        fail(path, 1, "each of the eight columns is needed once. Name them in the first line.");
    }
    return places;
}

Ray read_line(std::string_view line, const std::vector<std::size_t>& places,
              const std::filesystem::path& path, int number) {
    const std::vector<std::string_view> cells = split_cells(line);
    if (cells.size() != places.size()) {
        fail(path, number,
             "the line has " + std::to_string(cells.size()) + " cells, but 8 are needed.");
    }
    std::array<float, 8> numbers{};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const char* end = cells[i].data() + cells[i].size();
        const auto parsed = std::from_chars(cells[i].data(), end, numbers[places[i]]);
        if (parsed.ec != std::errc() || parsed.ptr != end) {
            fail(path, number, "`" + std::string(cells[i]) + "` is not a number.");
        }
    }
    return {{numbers[0], numbers[1], numbers[2]},
            {numbers[3], numbers[4], numbers[5]},
            numbers[6],
            numbers[7]};
}

} // namespace

std::vector<Ray> parse_ray_csv(std::string_view text, const std::filesystem::path& path) {
    std::vector<Ray> rays;
    std::vector<std::size_t> places;
    for (int number = 1; !text.empty(); ++number) {
        const auto end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (number == 1) {
            places = read_header(line, path);
        } else if (!trim(line).empty()) {
            rays.push_back(read_line(line, places, path, number));
        }
    }
    if (places.empty()) {
        fail(path, 1, "the file is empty. Its first line names the columns.");
    }
    return rays;
}

} // namespace raysteps
