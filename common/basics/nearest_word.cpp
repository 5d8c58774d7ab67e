#include "scene/nearest_word.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace raysteps {

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1); // distances of a's beginning to b's beginnings
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

} // namespace

std::string_view nearest_word(std::string_view text, const std::vector<std::string_view>& words) {
    std::string_view nearest;
    std::size_t smallest = text.size() + 1;
    for (const std::string_view word : words) {
        const std::size_t distance = edit_distance(text, word);
        if (distance < smallest && 3 * distance < word.size() + 2) {
            smallest = distance;
            nearest = word;
        }
    }
    return nearest;
}

} // namespace raysteps
