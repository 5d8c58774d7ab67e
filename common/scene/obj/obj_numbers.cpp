#include "scene/obj_numbers.h"

#include <array>
#include <charconv>
#include <limits>

namespace raysteps {

namespace {

// from_chars reads no '+', which OBJ allows; but "+-1" is no number.
std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

} // namespace

std::optional<double> to_number(std::string_view word) {
    word = without_plus(word);
    double number = 0.0;
    const char* const end = word.data() + word.size();
    const auto [stop, failure] = std::from_chars(word.data(), end, number);
    if (failure == std::errc::invalid_argument || stop != end)
        return std::nullopt;
    if (failure == std::errc::result_out_of_range)
        return std::numeric_limits<double>::infinity();
    return number;
}

std::optional<std::int64_t> to_whole_number(std::string_view word) {
    word = without_plus(word);
    std::int64_t number = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, failure] = std::from_chars(word.data(), end, number);
    if (failure != std::errc{} || stop != end)
        return std::nullopt;
    return number;
}

std::string to_text(float number) {
    std::array<char, 32> text{};
    const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), end};
}

} // namespace raysteps
